//! A table of measurements on its way into the scene. One that does not fit
//! the robot changes nothing and is told with its rows.

use crate::app::commands::Command;
use crate::app::words::{faults_of, sentence, shown};
use crate::app::workbench::{Notice, Selection, Trouble, Workbench};
use crate::experiments::measured_csv::{LeftOut, Sheet as Table};
use crate::experiments::{Measured, MeasuredPoint};
use crate::mechanics::Problem;
use crate::scene::{Measurements, Scene};
use std::path::Path;

/// Brings a table's measurements into the scene.
pub fn import(bench: &mut Workbench, path: &Path, bytes: &[u8]) {
    let name = shown(path);
    match imported(&bench.document.scene, bytes) {
        Ok((measured, what, left_out)) => {
            bench.document.scene.measured = Some(measured);
            bench.selection = Selection::Measured;
            let mut told = format!("Imported {what} from {name}");
            if !left_out.rows().is_empty() {
                told = format!("{told}. {}", sentence(&left_out.to_string()));
            }
            bench.notices.tell(Notice::success(told));
        }
        Err(faults) => {
            let trouble = Trouble::new(format!("{name} cannot be imported"), faults)
                .with("Nothing has changed here. Correct the table, or choose another:")
                .offering("Choose …", Command::ImportMeasurements);
            bench.trouble = Some(trouble);
        }
    }
}

/// The scene's measurements with those of a table, what was new, and the rows
/// that hold nothing.
fn imported(scene: &Scene, bytes: &[u8]) -> Result<(Measurements, String, LeftOut), Vec<String>> {
    let one = |fault: &dyn std::fmt::Display| vec![sentence(&fault.to_string())];
    let (table, left_out) = Table::read(bytes).map_err(|fault| one(&fault))?;
    let what = match &table {
        Table::Backbone(rows) => format!("{} points of a backbone", rows.len()),
        Table::Forces(readings) => format!("{} force readings", readings.len()),
    };
    let points = match &table {
        Table::Backbone(rows) => rows.iter().copied().map(MeasuredPoint::from).collect(),
        Table::Forces(_) => Vec::new(),
    };
    let mut held = scene.measured.clone().unwrap_or_default();
    table.put_into(&mut held);
    let with = Scene {
        measured: Some(held.clone()),
        ..scene.clone()
    };
    let problem = Problem::parse(&with).map_err(|faults| faults_of(&faults))?;
    if !points.is_empty() {
        Measured::new(points, &problem).map_err(|fault| one(&fault))?;
    }
    Ok((held, what, left_out))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_both_kinds_are_taken_side_by_side() {
        let mut scene = Scene::default();
        let (held, what, _) = imported(&scene, b"x_mm,y_mm\n0,0\n0,60\n2,120\n").unwrap();
        assert_eq!(
            (held.points_mm.len(), &*what),
            (3, "3 points of a backbone")
        );
        scene.measured = Some(held);
        let (held, what, _) = imported(&scene, b"load_g,force_g\n100,6\n200,13\n").unwrap();
        assert_eq!((held.points_mm.len(), held.forces.len()), (3, 2));
        assert_eq!(what, "2 force readings");
    }

    #[test]
    fn rows_without_numbers_are_left_out_and_told() {
        let table = b"x (cm),y (cm)\n0,0\nnan,nan\n0,6\n0,12\n";
        let (held, _, left_out) = imported(&Scene::default(), table).unwrap();
        assert_eq!(held.points_mm, [[0.0, 0.0], [0.0, 60.0], [0.0, 120.0]]);
        assert_eq!(left_out.rows(), [3]);
    }

    #[test]
    fn a_table_that_does_not_fit_the_robot_is_told_with_its_row() {
        let check = |text: &str, part: &str| {
            let faults = imported(&Scene::default(), text.as_bytes()).unwrap_err();
            assert!(faults[0].contains(part), "{faults:?}");
        };
        check("x_mm,y_mm\n0,0\n0,60\n0,6000\n", "Row 4");
        check("x_mm,y_mm\n0,zero\n", "Row 2");
        check("a,b\n1,2\n", "Row 1");
        check(
            "x_mm,y_mm\n0,0\n0,9\n0,18\n",
            "write them in mm, or name the unit",
        );
        check("", "no rows of numbers");
    }
}
