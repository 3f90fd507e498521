//! What the robot's lines and parts are called: in files, in sentences, and in
//! tables by disk. Every message that names a part takes it from here.

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

/// A part of the robot in words, by the disk that it belongs to, counted from 1
/// at the base as in the paper, and the side: `disk 6, cable side` for a cable
/// node that carries a disk, `between disks 6 and 7, backbone` for one that
/// does not. `node` is that of a contact: 0 at the base, a link's upper one.
pub fn part_name(robot: &Robot, line: Line, node: usize) -> String {
    let bay = robot.segments_per_bay;
    let link = matches!(line, Line::BackboneLink | Line::CableLink);
    let whole = node / bay + 1;
    let place = if robot.has_disk(node) && !link {
        format!("disk {whole}")
    } else {
        // A link ends at its node, so the one below a disk starts in its bay.
        let below = node.saturating_sub(usize::from(link)) / bay + 1;
        format!("between disks {below} and {}", below + 1)
    };
    let side = match line {
        Line::Backbone => "backbone",
        Line::Cable => "cable side",
        Line::RimCableSide => "rim on the cable side",
        Line::RimFarSide => "rim on the far side",
        Line::BackboneLink => "backbone",
        Line::CableLink => "cable",
        Line::DiskFace => "face",
    };
    format!("{place}, {side}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// Two segments a bay, as the paper's.
    #[test]
    fn parts_are_named_by_their_disks_as_the_paper_counts_them() {
        let robot = Robot::of(&Scene::default());
        let check = |line, node, expected: &str| {
            assert_eq!(part_name(&robot, line, node), expected);
        };
        check(Line::Cable, 10, "disk 6, cable side");
        check(Line::Cable, 16, "disk 9, cable side");
        check(Line::Cable, 11, "between disks 6 and 7, cable side");
        // A link belongs to the bay it lies in, also where it ends at a disk.
        check(Line::CableLink, 12, "between disks 6 and 7, cable");
        check(Line::CableLink, 13, "between disks 7 and 8, cable");
        check(Line::RimFarSide, 0, "disk 1, rim on the far side");
    }
}
