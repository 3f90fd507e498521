//! What a part of the robot is called where people read of it.

use crate::equilibrium::Contact;
use crate::model::{Line, Robot};

/// The part that touches, in words: the disk it belongs to, counted from 1 at
/// the base as in the paper, and the side. `disk 6, cable side` for a cable
/// node that carries a disk, `between disks 6 and 7, backbone` for one that
/// does not.
pub fn part_name(robot: &Robot, contact: &Contact) -> String {
    part_name_at(robot, contact.line, contact.node)
}

/// The same for the part on a line at a node, from 1 at the base's neighbour.
pub fn part_name_at(robot: &Robot, line: Line, node: usize) -> String {
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
        Line::Disk => "face",
    };
    format!("{place}, {side}")
}
