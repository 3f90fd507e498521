//! A table of measurements on its way into the scene. One that does not fit
//! the robot changes nothing and is told with its rows.

use crate::app::commands::Command;
use crate::app::files::{faults_of, sentence, shown};
use crate::app::notices::Notice;
use crate::app::sheets::Sheet;
use crate::app::state::{Selection, State};
use crate::experiments::measured_csv::{BackboneRow, Sheet as Table};
use crate::experiments::{Measured, MeasuredPoint};
use crate::geometry::Vector;
use crate::model::Problem;
use crate::scene::{Measurements, Scene};
use crate::units::metres;
use std::path::Path;

/// Brings a table's measurements into the scene.
pub fn import(state: &mut State, path: &Path, bytes: &[u8]) {
    let name = shown(path);
    match imported(&state.document.scene, bytes) {
        Ok((measured, what)) => {
            state.document.scene.measured = Some(measured);
            state.selection = Selection::Measured;
            let told = format!("Imported {what} from {name}");
            state.notices.tell(Notice::success(told));
        }
        Err(faults) => {
            let sheet = Sheet::trouble(format!("{name} cannot be imported"), faults)
                .with("Nothing has changed here. Correct the table, or choose another:")
                .offering("Choose …", Command::ImportMeasurements);
            state.sheets.show(sheet);
        }
    }
}

/// The scene's measurements with those of a table, and what was new.
fn imported(scene: &Scene, bytes: &[u8]) -> Result<(Measurements, String), Vec<String>> {
    let one = |fault: &dyn std::fmt::Display| vec![sentence(&fault.to_string())];
    let table = Table::read(bytes).map_err(|fault| one(&fault))?;
    let what = match &table {
        Table::Backbone(rows) => format!("{} points of a backbone", rows.len()),
        Table::Forces(readings) => format!("{} force readings", readings.len()),
    };
    let points = match &table {
        Table::Backbone(rows) => rows.iter().map(point).collect(),
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
    Ok((held, what))
}

/// A row's point, with the row for messages.
fn point(row: &BackboneRow) -> MeasuredPoint {
    MeasuredPoint {
        row: row.row,
        node: row.node.map(|node| node as usize),
        position: Vector::new(metres(row.point_mm[0]), metres(row.point_mm[1])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_both_kinds_are_taken_side_by_side() {
        let mut scene = Scene::default();
        let (held, what) = imported(&scene, b"x_mm,y_mm\n0,0\n0,60\n2,120\n").unwrap();
        assert_eq!(
            (held.points_mm.len(), &*what),
            (3, "3 points of a backbone")
        );
        scene.measured = Some(held);
        let (held, what) = imported(&scene, b"load_g,force_g\n100,6\n200,13\n").unwrap();
        assert_eq!((held.points_mm.len(), held.forces.len()), (3, 2));
        assert_eq!(what, "2 force readings");
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
        check("", "no rows of numbers");
    }
}
