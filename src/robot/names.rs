//! What the robot's lines and parts are called: in files, in sentences, and in
//! short by disk. Every message that names a part takes it from here.

use super::candidate::Line;
use super::dimensions::Robot;

impl Line {
    /// The line's name in files and reports.
    pub fn name(self) -> &'static str {
        match self {
            Line::Backbone => "backbone",
            Line::Cable => "cable",
            Line::RimCableSide => "rim_cable_side",
            Line::RimFarSide => "rim_far_side",
            Line::BackboneLink => "backbone_link",
            Line::CableLink => "cable_link",
            Line::DiskFace => "disk",
        }
    }

    /// The part of the robot that this line has at a node, in words: `the
    /// cable between nodes 9 and 10`.
    pub fn part(self, node: usize) -> String {
        let link = |name| format!("the {name} between nodes {} and {node}", node - 1);
        match self {
            Line::Backbone | Line::Cable => format!("{} node {node}", self.name()),
            Line::RimCableSide => format!("the cable-side rim at node {node}"),
            Line::RimFarSide => format!("the far rim at node {node}"),
            Line::BackboneLink => link("backbone"),
            Line::CableLink => link("cable"),
            Line::DiskFace => format!("the disk at node {node}"),
        }
    }
}

/// A part of the robot in short, by the disk that it belongs to, counted from 0 at the
/// base, and the side: `D5, cable side` for a cable node that carries a disk, `D5–D6,
/// backbone` for one that does not. `node` is that of a contact: 0 at the base, a
/// link's upper one. The paper counts disks from 1.
pub fn part_name(robot: &Robot, line: Line, node: usize) -> String {
    let link = matches!(line, Line::BackboneLink | Line::CableLink);
    let place = if link {
        // A link ends at its node, so the one below a disk starts in its bay.
        between(robot, node.saturating_sub(1))
    } else {
        disk_name(robot, node)
    };
    let side = match line {
        Line::Backbone => "backbone",
        Line::Cable => "cable side",
        Line::RimCableSide => "cable-side rim",
        Line::RimFarSide => "far rim",
        Line::BackboneLink => "backbone",
        Line::CableLink => "cable",
        Line::DiskFace => "face",
    };
    format!("{place}, {side}")
}

/// The disk at a node, as `D5`, or those that it is between, as `D5–D6`.
pub fn disk_name(robot: &Robot, node: usize) -> String {
    match robot.has_disk(node) {
        true => format!("D{}", node / robot.segments_per_bay),
        false => between(robot, node),
    }
}

fn between(robot: &Robot, node: usize) -> String {
    let below = node / robot.segments_per_bay;
    format!("D{below}–D{}", below + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// Two segments a bay, as the paper's.
    #[test]
    fn parts_are_named_by_their_disks_from_the_base() {
        let robot = Robot::of(&Scene::default());
        let check = |line, node, expected: &str| {
            assert_eq!(part_name(&robot, line, node), expected);
        };
        check(Line::Cable, 10, "D5, cable side");
        check(Line::Cable, 16, "D8, cable side");
        check(Line::Cable, 11, "D5–D6, cable side");
        // A link belongs to the bay it lies in, also where it ends at a disk.
        check(Line::CableLink, 12, "D5–D6, cable");
        check(Line::CableLink, 13, "D6–D7, cable");
        check(Line::RimFarSide, 0, "D0, far rim");
    }
}
