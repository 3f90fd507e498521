//! How many disks there are and how far apart, and into how many segments the robot is
//! cut between them: what it is, and how finely it is computed.

use crate::app::widgets::{Form, Kind, Number, row};
use crate::scene::limits::{DISK_SPACING, DISKS, LENGTH, Limits, SEGMENTS_PER_BAY};
use crate::scene::limits::{SEGMENTS, SLIDING_SEGMENTS_PER_BAY};
use crate::scene::{Mechanics, Robot, Scene};
use crate::view::Quantity;
use eframe::egui::Ui;

/// The disks beside the base's, at least 1.
fn count(robot: &Robot) -> u32 {
    let bays = robot.segments.checked_div(robot.segments_per_bay);
    bays.unwrap_or(1).max(1)
}

/// Shows the fields of the disks.
pub(super) fn disks(ui: &mut Ui, form: &mut Form<'_>, robot: &mut Robot) {
    let mut disks = count(robot);
    let number = Number {
        kind: Kind::Count,
        meaning: "Disks along the robot without the base’s, spread over its length",
        limits: Limits {
            max: SEGMENTS.max / f64::from(robot.segments_per_bay.max(1)),
            ..DISKS
        },
        ..Number::length("robot.disks", "Disks", DISKS)
    };
    if form.count(ui, &number, &mut disks) {
        robot.segments = disks * robot.segments_per_bay;
    }
    let count = f64::from(count(robot));
    let mut spacing_mm = robot.length_mm / count;
    let number = Number {
        meaning: "From disk to disk. Changing it keeps the disks and changes the robot’s length",
        limits: Limits {
            min: DISK_SPACING.min.max(LENGTH.min / count),
            max: LENGTH.max / count,
            ..DISK_SPACING
        },
        ..Number::length("robot.disk_spacing_mm", "Disk spacing", DISK_SPACING)
    };
    if form.number(ui, &number, &mut spacing_mm) {
        robot.length_mm = spacing_mm * count;
    }
}

/// Shows into how many segments the robot is cut.
pub(super) fn accuracy(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let most = match scene.model.mechanics {
        Mechanics::Sliding => SLIDING_SEGMENTS_PER_BAY,
        Mechanics::Equal => SEGMENTS_PER_BAY,
    };
    let robot = &mut scene.robot;
    let disks = count(robot);
    let number = Number {
        kind: Kind::Count,
        meaning: "Arcs that the backbone is cut into from disk to disk: more come nearer to a \
                  smooth rod, and take longer. The disks stay where they are",
        limits: Limits {
            max: most.max.min(SEGMENTS.max / f64::from(disks)).floor(),
            ..most
        },
        ..Number::length("robot.segments_per_bay", "Segments per bay", most)
    };
    if form.count(ui, &number, &mut robot.segments_per_bay) {
        robot.segments = disks * robot.segments_per_bay;
    }
    let all = Quantity::fixed(robot.segments.into(), 0, "");
    row::fact(ui, "Segments", "n", &all);
}
