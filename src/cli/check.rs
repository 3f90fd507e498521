//! `sinew check`: what a scene says in a few sentences, where nothing is wrong
//! with it.

use std::io::{self, Write};

use super::arguments::{Check, Driving};
use super::output::{Labels, printable, reader};
use super::progress::Progress;
use super::solve::{RESOLUTION, finish};
use super::{Failure, Outcome};
use super::{compare, input};
use crate::equilibrium::{Caution, Run, Settings, Start, Status};
use crate::experiments::Measured;
use crate::math::{decimals, unsigned_zero};
use crate::mechanics::{Model, Problem};
use crate::scene::limits::shown;
use crate::scene::{Candidates, Drive, Scene};
use crate::units::millimetres;

/// Obstacles named in the summary; of more than these, only the number is told.
const NAMED: usize = 8;

pub(super) fn run(what: &Check) -> Result<Outcome, Failure> {
    let (scene, problem) = input::problem(&what.scene, &what.edits, &Driving::default())?;
    // What `compare` would refuse is a fault, too.
    let measured = compare::held(&scene, &problem, &input::origin(&what.scene))?;
    let mut text = summary(&scene, &problem);
    if let Some(measured) = measured {
        text.push_str(&format!("\n{}", backbone(&scene, &measured)));
    }
    for sentence in cautions(&scene, &problem) {
        text.push_str(&format!("\nCaution: {sentence}"));
    }
    reader(writeln!(io::stdout().lock(), "{text}"))?;
    Ok(Outcome::Done)
}

/// What to know of the scene's shape. It is solved for this: whether a link
/// crosses an obstacle depends on the shape alone, and finding that takes
/// milliseconds. How the solve ends is no fault of the scene.
fn cautions(scene: &Scene, problem: &Problem) -> Vec<String> {
    let mut run = Run::new(problem, Start::Straight, Settings::default());
    let mut progress = Progress::new("solving", RESOLUTION);
    finish(&mut run, |run| {
        progress.at((run.share() * f64::from(RESOLUTION)) as u32);
    });
    drop(progress);
    let labels = Labels::of(scene, problem);
    let mut found = Caution::all(&run.solved());
    found.extend(Caution::of_scene(scene));
    let mut sentences: Vec<String> = found.iter().map(|one| labels.caution(one)).collect();
    if run.solution().status != Status::Converged {
        let reason = run.solution().status.reason();
        let asked = match problem.drive().cables[..] {
            [_] if problem.drive().load().is_none() => "pull",
            [_] => "load",
            _ => "pulls and loads",
        };
        sentences.push(format!("A solve does not reach the {asked}: {reason}."));
    }
    sentences
}

fn summary(scene: &Scene, problem: &Problem) -> String {
    let robot = &scene.robot;
    let title = scene.title.as_deref().unwrap_or("untitled");
    let [base_x, base_y] = robot.base_mm.map(number);
    let mut lines = vec![format!("{}: no faults.", printable(title))];
    let cable = match problem.model() {
        Model::Equal => format!(
            " and the cable {} mm beside the backbone",
            number(scene.offset_mm())
        ),
        Model::Sliding => String::new(),
    };
    lines.push(format!(
        "The robot is {} mm long in {} segments, with a disk every {}{cable}; its base is at ({base_x}, {base_y}) mm.",
        number(robot.length_mm),
        robot.segments,
        robot.segments_per_bay,
    ));
    match problem.model() {
        Model::Equal => {
            let (least, most) = problem.pull_range();
            lines.push(format!(
                "Every segment of the cable shortens alike, as in the paper. The pull is {} mm; the segments allow {} to {} mm.",
                number(scene.pull_mm()),
                decimals(millimetres(least), 1),
                decimals(millimetres(most), 1),
            ));
        }
        Model::Sliding => lines.push(cables(scene)),
    }
    lines.push(obstacles(scene));
    lines.join("\n")
}

/// Where cables that slide run, and what drives them.
fn cables(scene: &Scene) -> String {
    let each = scene.each_cable().map(|cable| {
        let drive = match cable.drive {
            Drive::PullMm(pull_mm) => format!("a pull of {} mm", number(pull_mm)),
            Drive::LoadG(load_g) => format!("a load of {} g", number(load_g)),
        };
        let end = match cable.to_disk {
            Some(disk) => format!(" to disk {disk}"),
            None => String::new(),
        };
        format!("at {} mm{end} by {drive}", number(cable.offset_mm))
    });
    let each: Vec<String> = each.collect();
    let head = match each.len() {
        1 => "One cable slides through the disks".to_owned(),
        count => format!("{count} cables slide through the disks"),
    };
    format!("{head}: {}.", each.join(", "))
}

/// A number of the file, with no sign where it is zero.
fn number(value: f64) -> String {
    shown(unsigned_zero(value))
}

/// What the scene's measured backbone is.
fn backbone(scene: &Scene, measured: &Measured) -> String {
    let count = scene
        .measured
        .as_ref()
        .map_or(0, |held| held.points_mm.len());
    let length = millimetres(measured.length());
    format!(
        "The measured backbone has {count} points and is {} mm long.",
        decimals(length, 1)
    )
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
