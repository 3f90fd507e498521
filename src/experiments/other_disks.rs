//! Fig. 10b: the force where another disk than the third from the top meets the load
//! cell, by virtual work and by the sliding cable. Nothing of it was measured.

use super::ExperimentError;
use super::data::{Data, DiskForces, DiskModel};
use super::item::{Check, Id, Item};
use super::load_cell::{ABOUT_SLIDING, CALIBRATION_MM, calibrated, force_g};
use super::scenes::PaperScene;
use super::sliding_cell::{FITTED, SlidingCell, named};
use super::table::ForceTable;
use super::tip::{WINDOW_MM, free_rates};
use crate::forces::VirtualWork;
use crate::scene::Friction;

/// The disk, from 1 at the tip, at which Table 1 was measured and friction fitted.
const FITTED_DISK: usize = 3;

pub(super) fn figure_10b(table: &ForceTable) -> Result<Item, ExperimentError> {
    let tip = calibrated(table)?;
    let friction = tip.friction();
    let (_, problem) = PaperScene::Free.problem()?;
    let robot = *problem.robot();
    let bay = robot.segments_per_bay;
    let (mut disks, mut frictionless, mut rubbing) = (Vec::new(), Vec::new(), Vec::new());
    let mut checks = Vec::new();
    for from_top in [1_usize, 2, 3, 4] {
        let node = robot.segments - (from_top - 1) * bay;
        let rates = free_rates(node, WINDOW_MM)?;
        let estimator = VirtualWork::new(robot.offset, rates, friction)?;
        let rows = table.rows().iter();
        let by_load_g = rows.map(|row| (row.load_g, force_g(&estimator, row.load_g)));
        let disk = DiskForces {
            from_top,
            by_load_g: by_load_g.collect(),
        };
        checks.push(
            Check::ours(
                format!("Force over load at {} (node {})", disk.name(), node + 1),
                "",
                estimator.force_per_load(),
            )
            .decimals(4),
        );
        disks.push(disk);
        for (friction, curves) in [
            (Friction::default(), &mut frictionless),
            (FITTED, &mut rubbing),
        ] {
            let cell = SlidingCell::at_node(CALIBRATION_MM, node, friction, table)?;
            let told = match (friction.is_none(), from_top == FITTED_DISK) {
                (true, _) => "",
                (false, true) => ", fitted there",
                (false, false) => ", predicted",
            };
            let quantity = format!(
                "… of a {}{told}, d = {CALIBRATION_MM} mm (node {})",
                named(&friction),
                node + 1
            );
            checks.push(Check::ours(quantity, "", cell.force_per_load()).decimals(4));
            curves.push(DiskForces {
                from_top,
                by_load_g: cell.by_load_g,
            });
        }
    }
    let caveats = VirtualWork::new(
        robot.offset,
        free_rates(robot.segments - 2 * bay, WINDOW_MM)?,
        friction,
    )?
    .caveats(robot.segments);
    let mut notes = vec![
        "Eq. 11 with each node's own slopes and the μ of Table 1. The lower the contact, the less \
         it moves per pull and the harder it presses."
            .to_owned(),
    ];
    notes.push(ABOUT_SLIDING.to_owned());
    notes.push(
        "Table 1 was measured at disk 3 from the top. What its constants say of the other disks \
         is a prediction, and what they say of disk 3 is not: there they were fitted."
            .to_owned(),
    );
    notes.extend(caveats.iter().map(|c| format!("{c}.")));
    Ok(Item {
        id: Id::Fig10b,
        title: "Force over load at other contact points",
        about: "Virtual work at the nodes of the four upper disks, and the sliding cable with one \
                of them against the cell."
            .to_owned(),
        checks,
        data: vec![
            Data::DiskForces(DiskModel::VirtualWork, disks),
            Data::DiskForces(DiskModel::Frictionless, frictionless),
            Data::DiskForces(DiskModel::Rubbing, rubbing),
        ],
        pictures: Vec::new(),
        notes,
        missing: vec![
            "The text gives neither the figure's values nor its contact points: these curves have \
             nothing to be compared with."
                .to_owned(),
        ],
    })
}
