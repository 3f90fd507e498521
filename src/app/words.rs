//! What happens to the robot, in words.

use crate::equilibrium::{Event, Occurrence};
use crate::forces::part_name_at;
use crate::model::Robot;
use crate::scene::Scene;
use crate::units::millimetres;
use crate::view::Quantity;

/// An obstacle of a scene as people call it: its name, or its shape and its
/// place in the list, from 1.
pub fn obstacle(scene: &Scene, index: usize) -> String {
    match scene.obstacles.get(index) {
        Some(obstacle) => match &obstacle.name {
            Some(name) => name.clone(),
            None => format!("{} {}", obstacle.shape.word(), index + 1),
        },
        None => format!("obstacle {}", index + 1),
    }
}

/// An event with its pull, in one line.
pub fn event(event: &Event, scene: &Scene, robot: &Robot) -> String {
    let pull = Quantity::fixed(millimetres(event.pull), 2, "mm").text();
    let what = match event.what {
        Occurrence::PushedAside {
            obstacle: index, ..
        } => {
            format!("pushed aside by {}", obstacle(scene, index))
        }
        Occurrence::ContactMade {
            line,
            node,
            obstacle: index,
        } => {
            let part = part_name_at(robot, line, node);
            format!("{part}, begins to press on {}", obstacle(scene, index))
        }
        Occurrence::ContactLost {
            line,
            node,
            obstacle: index,
        } => {
            let part = part_name_at(robot, line, node);
            format!("{part}, leaves {}", obstacle(scene, index))
        }
        Occurrence::Jump { node, distance } => {
            let far = Quantity::fixed(millimetres(distance), 1, "mm").text();
            format!("the robot jumps: node {node} moves {far}")
        }
        Occurrence::BranchEnded { segment, .. } => {
            format!("the branch ends at segment {segment}")
        }
        Occurrence::StartRefused => "started from the straight robot".to_owned(),
    };
    format!("{pull}: {what}")
}
