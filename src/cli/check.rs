//! `sinew check`: what a scene says in a few sentences, where nothing is wrong
//! with it.

use std::io::{self, Write};

use super::arguments::Check;
use super::input;
use super::output::{printable, reader};
use super::{Failure, Outcome};
use crate::experiments::Measured;
use crate::model::Problem;
use crate::scene::limits::shown;
use crate::scene::{Candidates, Scene};
use crate::units::millimetres;

/// Obstacles named in the summary; of more than these, only the number is told.
const NAMED: usize = 8;

pub(super) fn run(what: &Check) -> Result<Outcome, Failure> {
    let (scene, problem) = input::problem(&what.scene, None)?;
    let text = summary(&scene, &problem);
    reader(writeln!(io::stdout().lock(), "{text}"))?;
    Ok(Outcome::Done)
}

fn summary(scene: &Scene, problem: &Problem) -> String {
    let robot = &scene.robot;
    let title = scene.title.as_deref().unwrap_or("untitled");
    let (least, most) = problem.robot().pull_range();
    let [base_x, base_y] = robot.base_mm.map(shown);
    [
        format!("{}: no faults.", printable(title)),
        format!(
            "The robot is {} mm long in {} segments, with a disk every {} and the cable {} mm beside the backbone; its base is at ({base_x}, {base_y}) mm.",
            shown(robot.length_mm),
            robot.segments,
            robot.segments_per_bay,
            shown(robot.cable_offset_mm),
        ),
        format!(
            "The pull is {} mm; the segments allow {:.1} to {:.1} mm.",
            shown(scene.actuation.pull_mm),
            millimetres(least),
            millimetres(most),
        ),
        obstacles(scene),
    ]
    .into_iter()
    .chain(measured(scene, problem))
    .collect::<Vec<_>>()
    .join("\n")
}

/// What the scene's measured backbone is, or why nothing can be compared with
/// it; nothing where there is none.
fn measured(scene: &Scene, problem: &Problem) -> Option<String> {
    let held = scene.measured.as_ref()?;
    let count = held.points_mm.len();
    if count == 0 {
        return None;
    }
    Some(match Measured::of_scene(held, problem) {
        Ok(measured) => format!(
            "The measured backbone has {count} points and is {:.1} mm long.",
            millimetres(measured.length())
        ),
        Err(fault) => {
            format!("Caution: nothing can be compared with measured.points_mm: {fault}.")
        }
    })
}

fn obstacles(scene: &Scene) -> String {
    let count = scene.obstacles.len();
    let what = match scene.contact.candidates {
        Candidates::Nodes => "every node of backbone and cable",
        Candidates::Body => "the robot's whole body",
        Candidates::Listed => "the listed nodes",
    };
    let head = match count {
        0 => return "Nothing stands around it.".to_owned(),
        1 => format!("One obstacle keeps out {what}"),
        _ => format!("{count} obstacles keep out {what}"),
    };
    if count > NAMED {
        return format!("{head}.");
    }
    let named = scene.obstacles.iter().enumerate();
    let list: Vec<String> = named
        .map(|(index, obstacle)| match &obstacle.name {
            Some(name) => format!("{index} {} ({})", printable(name), obstacle.shape.word()),
            None => format!("{index} {}", obstacle.shape.word()),
        })
        .collect();
    format!("{head}: {}.", list.join(", "))
}
