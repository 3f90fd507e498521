//! What things of the scene and the solver are called on the screen. The
//! words of files and of the command line are the library's.

use crate::app::look::icons;
use crate::equilibrium::{Caution, Conflict, Event, Occurrence, Solution, Status};
use crate::mechanics::{Model, Problem, Slip};
use crate::robot::Line;
use crate::scene::{Obstacle, Scene, SceneError, Shape};
use crate::units::{grams, millimetres};
use crate::view::{Quantity, reason};
use std::path::Path;

/// An obstacle's name or, where it has none, its shape and its place in the
/// list, from 1.
pub fn obstacle(index: usize, obstacle: &Obstacle) -> String {
    match &obstacle.name {
        Some(name) if !name.trim().is_empty() => name.clone(),
        _ => format!("{} {}", shape(&obstacle.shape), index + 1),
    }
}

/// The name of a scene's obstacle; a number for one that is gone.
pub fn obstacle_of(scene: &Scene, index: usize) -> String {
    match scene.obstacles.get(index) {
        Some(found) => obstacle(index, found),
        None => format!("obstacle {}", index + 1),
    }
}

/// A stretch of a cable: the disks, from 0 at the base, or, in the paper's model, the
/// nodes that it is between, and the cable where there are several.
pub fn stretch(problem: &Problem, cables: usize, cable: usize, stretch: usize) -> String {
    let place = match problem.model() {
        Model::Sliding => format!("D{stretch} to D{}", stretch + 1),
        Model::Equal => format!("node {stretch} to {}", stretch + 1),
    };
    match cables {
        0 | 1 => place,
        _ => format!("cable {}, {place}", cable + 1),
    }
}

/// How a cable goes through a hole.
pub fn slips(slip: Slip) -> &'static str {
    match slip {
        Slip::In => "slips in",
        Slip::Out => "slips out",
        Slip::Sticks => "sticks",
    }
}

/// A shape's word.
pub fn shape(shape: &Shape) -> &'static str {
    match shape {
        Shape::Disc { .. } => "Disc",
        Shape::Wall { .. } => "Wall",
        Shape::Box { .. } => "Box",
        Shape::Capsule { .. } => "Capsule",
        Shape::Polygon { .. } => "Polygon",
    }
}

/// A shape's icon.
pub fn shape_icon(shape: &Shape) -> &'static str {
    match shape {
        Shape::Disc { .. } => icons::CIRCLE,
        Shape::Wall { .. } => icons::WALL,
        Shape::Box { .. } => icons::SQUARE,
        Shape::Capsule { .. } => icons::PILL,
        Shape::Polygon { .. } => icons::POLYGON,
    }
}

/// What a field of a scene file is called on the screen; `None` for fields
/// that are not on it.
fn field(path: &str) -> Option<&'static str> {
    let key = path.rsplit('.').next().unwrap_or(path);
    Some(match key {
        "length_mm" => "length",
        "segments" => "segments",
        "segments_per_bay" => "segments per bay",
        "cable_offset_mm" | "offset_mm" => "cable offset",
        "disk_radius_mm" => "disk radius",
        "disk_thickness_mm" => "disk thickness",
        "backbone_diameter_mm" => "backbone diameter",
        "cable_diameter_mm" | "diameter_mm" => "cable diameter",
        "base_mm[0]" => "base x",
        "base_mm[1]" => "base y",
        "base_angle_deg" => "base angle",
        "pull_mm" => "pull",
        "load_g" => "load",
        "bending_stiffness_nmm2" => "stiffness",
        "cable" => "list of cables",
        "to_disk" => "last disk of the cable",
        "axial_stiffness_n" => "stiffness of the cable",
        "disk_mass_g" => "mass of a disk",
        "backbone_mass_g" => "mass of the backbone",
        "holes" => "friction in the holes",
        "contacts" => "friction at contacts",
        "base_loss" => "loss at the base",
        "tip_force_n" => "tip force",
        "tip_force_n[0]" => "tip force x",
        "tip_force_n[1]" => "tip force y",
        "tip_moment_nmm" => "tip moment",
        "gravity_m_s2" => "gravity",
        "gravity_m_s2[0]" => "gravity x",
        "gravity_m_s2[1]" => "gravity y",
        "candidates" => "contact parts",
        "listed" => "list of contact parts",
        "center_mm[0]" => "centre x",
        "center_mm[1]" => "centre y",
        "point_mm[0]" => "point x",
        "point_mm[1]" => "point y",
        "size_mm" => "size",
        "size_mm[0]" => "width",
        "size_mm[1]" => "height",
        "radius_mm" => "radius",
        "corner_radius_mm" => "corner radius",
        "rotation_deg" => "rotation",
        "points_mm" => "polygon",
        _ => return None,
    })
}

/// Why an edit was taken back, in the screen's words.
pub fn refusal(fault: &SceneError) -> String {
    let text = fault.to_string();
    let Some(path) = fault.field() else {
        return spoken(&text);
    };
    let rest = text.strip_prefix(path).unwrap_or(&text);
    let subject = match field(path) {
        Some(name) => name.to_owned(),
        None => match path.split_once(" (") {
            // An obstacle as a whole, which carries its name.
            Some((_, name)) => name.trim_end_matches(')').to_owned(),
            None => path.to_owned(),
        },
    };
    let words: Vec<String> = rest.split(' ').map(said).collect();
    spoken(&format!("{subject}{}", words.join(" ")))
}

/// Why the scene cannot be had in the other mechanics, in the screen's words and
/// without what to do about it: whoever asks stands before a switch.
pub fn obstacle_to(fault: &SceneError) -> String {
    let text = refusal(fault);
    let said = text.split("; ").next().unwrap_or(&text);
    spoken(said)
}

/// A word of a message, with a field's name in the place of its path.
fn said(word: &str) -> String {
    let bare = word.trim_end_matches([',', ';', ':']);
    let stops = &word[bare.len()..];
    match field(bare) {
        Some(name) if bare.contains('.') || bare.contains('_') => format!("the {name}{stops}"),
        _ if word == "deg" => "°".to_owned(),
        _ => word.to_owned(),
    }
}

/// A text with a capital at its start, whatever it starts with, and a stop at
/// its end.
pub fn spoken(text: &str) -> String {
    let stop = if text.ends_with('.') { "" } else { "." };
    format!("{}{stop}", capital(text))
}

/// A text with a capital at its start.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    let first: String = first.into_iter().flatten().collect();
    format!("{first}{}", letters.as_str())
}

/// A clause as a sentence. A key of a scene stays as it is written there.
pub fn sentence(clause: &str) -> String {
    let first = clause.split_whitespace().next().unwrap_or_default();
    let is_key = first.trim_end_matches('.').contains(['.', '_', '[']);
    let mut text = clause.to_owned();
    if let Some(letter) = clause.chars().next().filter(|_| !is_key) {
        let capital = letter.to_uppercase().to_string();
        text.replace_range(..letter.len_utf8(), &capital);
    }
    if !text.ends_with(['.', '!', '?']) {
        text.push('.');
    }
    text
}

/// Faults of a scene as sentences.
pub fn faults_of(faults: &[SceneError]) -> Vec<String> {
    let clauses = faults.iter().map(ToString::to_string);
    clauses.map(|clause| sentence(&clause)).collect()
}

/// A path's last part, for sentences.
pub fn shown(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// What is said of a file that was chosen for another document.
pub fn too_late(path: &Path) -> String {
    let name = shown(path);
    format!("{name} was chosen for the scene before this one and is left out.")
}

/// A part of the robot where its disks are not known.
fn part(line: Line, node: usize) -> String {
    match line {
        Line::Backbone => format!("backbone node {node}"),
        Line::Cable => format!("cable node {node}"),
        Line::RimCableSide => format!("the cable-side rim at node {node}"),
        Line::RimFarSide => format!("the far rim at node {node}"),
        Line::BackboneLink => format!("the backbone below node {node}"),
        Line::CableLink => format!("the cable below node {node}"),
        Line::DiskFace => format!("the disk at node {node}"),
    }
}

/// One sentence on how a solve ended, which names obstacles by their names.
pub fn outcome(solution: &Solution, scene: &Scene) -> String {
    match &solution.status {
        Status::Infeasible { conflicts } if !conflicts.is_empty() => {
            let one = |conflict: &Conflict| {
                let obstacle = obstacle_of(scene, conflict.obstacle);
                format!("{} on {obstacle}", part(conflict.line, conflict.node))
            };
            let all: Vec<String> = conflicts.iter().map(one).collect();
            format!(
                "No shape near the last good one keeps clear of the obstacles; in conflict: {}.",
                all.join(", ")
            )
        }
        _ => spoken(&reason(solution)),
    }
}

/// A caution as a sentence, which names obstacles by their names.
pub fn caution(caution: &Caution, scene: &Scene) -> String {
    spoken(&caution.sentence(|index| obstacle_of(scene, index)))
}

/// What happened, after the pull or the load at which it did.
pub fn event(event: &Event, scene: &Scene) -> String {
    format!("{}: {}", when(event), occurrence(&event.what, scene))
}

/// The pull at which something happened or, where the load was given, the load.
pub fn when(event: &Event) -> String {
    let at = match event.load {
        Some(load) => Quantity::fixed(grams(load), 1, "g"),
        None => Quantity::fixed(millimetres(event.pull), 2, "mm"),
    };
    at.text()
}

/// What happened, without its pull.
pub fn occurrence(what: &Occurrence, scene: &Scene) -> String {
    let text = match what {
        Occurrence::PushedAside { obstacle, .. } => {
            format!("{} pushes the robot aside", obstacle_of(scene, *obstacle))
        }
        Occurrence::ContactMade {
            line,
            node,
            obstacle,
        } => {
            let obstacle = obstacle_of(scene, *obstacle);
            format!("{} meets {obstacle}", part(*line, *node))
        }
        Occurrence::ContactLost {
            line,
            node,
            obstacle,
        } => {
            let obstacle = obstacle_of(scene, *obstacle);
            format!("{} leaves {obstacle}", part(*line, *node))
        }
        Occurrence::Jump { node, distance } => {
            let far = Quantity::fixed(millimetres(*distance), 2, "mm").text();
            format!("the robot jumps; node {node} moves farthest, by {far}")
        }
        Occurrence::FrictionGaveWay => {
            "friction of contacts gives way; the robot slips and rests anew".to_owned()
        }
        Occurrence::BranchEnded { reason, segment } => {
            let status = Status::BranchEnded {
                reason: *reason,
                segment: *segment,
            };
            status.reason()
        }
        Occurrence::StartRefused => {
            "the shape before was no equilibrium; started from straight".to_owned()
        }
    };
    spoken(&text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Robot;

    fn told(change: impl FnOnce(&mut Scene)) -> String {
        let mut scene = Scene::default();
        let shape = Shape::Disc {
            center_mm: [40.0, 100.0],
            radius_mm: 5.0,
        };
        scene.obstacles.push(shape.into());
        change(&mut scene);
        let faults = crate::mechanics::Problem::faults(&scene);
        refusal(&faults[0])
    }

    #[test]
    fn refusals_speak_of_what_is_on_the_screen() {
        assert_eq!(
            told(|scene| scene.robot.disk_radius_mm = Some(6.0)),
            "Disk radius is 6 mm; set it to a value from the cable offset, 8, to 10000 mm."
        );
        assert_eq!(
            told(|scene| scene.robot.segments = 17),
            "Segments per bay is 2, which does not divide the segments, 17, so that no disk sits \
             at the tip; set it to 1, or set segments to 16 or 18."
        );
        assert_eq!(
            told(|scene| scene.obstacles[0].shape.move_to_mm([0.0, 0.0])),
            "Disc covers the robot's base, which cannot move; move or shrink it until it is clear \
             of the first disk."
        );
        let text = told(|scene| {
            scene.robot = Robot {
                base_angle_deg: 1e9,
                ..Robot::default()
            }
        });
        assert!(text.ends_with("from -36000 to 36000 °."), "{text}");
    }

    #[test]
    fn events_are_told_at_what_was_given() {
        let told = |load| {
            let event = Event {
                share: 1.0,
                pull: 4.9e-3,
                load,
                what: Occurrence::StartRefused,
            };
            when(&event)
        };
        assert_eq!(told(None), "4.90 mm");
        assert_eq!(told(Some(9.80665)), "1000.0 g");
    }

    #[test]
    fn what_keeps_from_a_switch_is_told_without_advice() {
        let mut scene = Scene::default();
        scene.loads.gravity_m_s2 = [0.0, -9.8];
        let faults = crate::mechanics::Problem::faults(&scene);
        assert_eq!(
            obstacle_to(&faults[0]),
            "Gravity is [0, -9.8] m/s², and nothing acts on the paper's model but its cable and \
             obstacles."
        );
    }

    #[test]
    fn clauses_become_sentences() {
        assert_eq!(sentence("it is not there"), "It is not there.");
        assert_eq!(sentence("line 3 is odd."), "Line 3 is odd.");
        assert_eq!(sentence("robot.length_mm is 0"), "robot.length_mm is 0.");
        assert_eq!(sentence(""), ".");
    }

    #[test]
    fn obstacles_without_a_name_are_counted() {
        let mut disc = Obstacle::from(Shape::Disc {
            center_mm: [0.0, 0.0],
            radius_mm: 1.0,
        });
        assert_eq!(obstacle(2, &disc), "Disc 3");
        disc.name = Some("post".to_owned());
        assert_eq!(obstacle(2, &disc), "post");
    }
}
