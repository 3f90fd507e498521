//! What lights up because the pointer is on it here, or on its twin in another
//! part of the window.

use super::chip::Chip;
use super::overlay;
use crate::app::look::Tokens;
use crate::app::paint::to_screen;
use crate::app::words;
use crate::app::workbench::{Hovered, Workbench, nodes_of_stretch};
use crate::contact::{Class, Contact};
use crate::equilibrium::Solved;
use crate::forces::Sections;
use crate::mechanics::{Problem, Slip};
use crate::robot::{disk_name, part_name};
use crate::units::{METRES_PER_MM, degrees, grams, millimetres, per_millimetre};
use crate::view::{Frame, Quantity, Theme};
use eframe::egui::{Color32, Painter, Rect, Shape, Stroke};

/// Paints what is hovered and what there is to know of it.
pub fn paint(
    painter: &Painter,
    bench: &Workbench,
    hovered: Hovered,
    frame: &Frame,
    within: Rect,
    theme: Theme,
) {
    let tokens = Tokens::of(theme);
    let Some(solution) = bench.live.solution() else {
        return;
    };
    let problem = solution.problem();
    let ring = |at, radius: f32| {
        painter.circle_stroke(at, radius + 1.5, Stroke::new(4.0, tokens.canvas));
        painter.circle(
            at,
            radius,
            Color32::TRANSPARENT,
            Stroke::new(2.0, tokens.accent),
        );
    };
    match hovered {
        Hovered::Nothing => {}
        Hovered::Pull(pull) => {
            let path = bench.live.path();
            if let Some(then) = path.and_then(|path| path.at(pull)) {
                let at = to_screen(frame, then.tip.position);
                ring(at, 6.0);
                let title = Some("The tip at this pull".to_owned());
                let rows = vec![row("Pull", Quantity::fixed(millimetres(pull), 2, "mm"))];
                Chip { title, rows }.paint(painter, within, at, &tokens);
            }
        }
        Hovered::Node(index) => {
            let Some(node) = solution.nodes.get(index) else {
                return;
            };
            // Its bay, so that one sees where a plot's point is.
            let offset = problem.robot().offset;
            let ends = [node.position, node.at(offset)].map(|p| to_screen(frame, p));
            painter.line_segment(ends, Stroke::new(2.0, tokens.accent));
            ring(ends[0], 6.0);
            node_chip(solution, index).paint(painter, within, ends[0], &tokens);
        }
        Hovered::Contact(index) => {
            let Some(contact) = solution.contacts.get(index) else {
                return;
            };
            let at = to_screen(frame, contact.point);
            ring(at, 11.0);
            contact_chip(bench, problem, contact).paint(painter, within, at, &tokens);
        }
        Hovered::Stretch { cable, stretch } => {
            let known = solution.cables.get(cable).is_some() && !solution.nodes.is_empty();
            let points = known.then(|| solution.cable_points(cable));
            let nodes = nodes_of_stretch(problem, stretch);
            let Some(points) = points
                .as_ref()
                .and_then(|all| all.get(nodes.start..=nodes.end))
            else {
                return;
            };
            let line: Vec<_> = points.iter().map(|p| to_screen(frame, *p)).collect();
            let middle = to_screen(frame, 0.5 * (points[0] + points[points.len() - 1]));
            painter.add(Shape::line(line.clone(), Stroke::new(7.0, tokens.canvas)));
            painter.add(Shape::line(line, Stroke::new(4.0, tokens.accent)));
            stretch_chip(bench, solution, cable, stretch).paint(painter, within, middle, &tokens);
        }
        Hovered::Obstacle(index) => {
            let stroke = Stroke::new(1.5, tokens.accent.gamma_multiply(0.6));
            overlay::outline_of(painter, &bench.live, index, frame, stroke);
        }
    }
}

fn row(name: &str, value: Quantity) -> (String, Quantity) {
    (name.to_owned(), value)
}

fn text(words: impl Into<String>) -> Quantity {
    Quantity {
        digits: words.into(),
        unit: "",
    }
}

/// What there is to know of a node.
fn node_chip(solution: &Solved, index: usize) -> Chip {
    let problem = solution.problem();
    let robot = problem.robot();
    let node = &solution.nodes[index];
    let mut title = format!("Node {index}");
    if index + 1 == solution.nodes.len() {
        title.push_str(" · tip");
    } else if robot.has_disk(index) {
        title.push_str(&format!(" · {}", disk_name(robot, index)));
    }
    let mm = |value| Quantity::fixed(millimetres(value), 2, "mm");
    let mut rows = vec![row("x", mm(node.position.x)), row("y", mm(node.position.y))];
    if let Some(bend) = index.checked_sub(1).and_then(|i| solution.bends.get(i)) {
        rows.push(row("Bend", Quantity::fixed(degrees(*bend), 2, "°")));
    }
    let candidates = problem.candidates();
    let clearances = solution.clearances().into_iter();
    let of_node = clearances.filter(|c| candidates[c.candidate].node == index);
    if let Some(least) = of_node.map(|c| c.clearance).reduce(f64::min) {
        rows.push(row("Clearance", mm(least)));
    }
    Chip {
        title: Some(title),
        rows,
    }
}

/// What there is to know of a stretch of a cable.
fn stretch_chip(bench: &Workbench, solution: &Solved, cable: usize, stretch: usize) -> Chip {
    let newtons = bench.document.newtons_per_multiplier();
    let tensions = Sections::of(solution, newtons.unwrap_or(1.0)).tensions;
    let tension = tensions.get(cable).and_then(|of| of.get(stretch)).copied();
    let tension = tension.map(|tension| match newtons {
        Some(_) => Quantity::fixed(grams(tension), 1, "g"),
        None => Quantity::significant(per_millimetre(tension), "rad²/mm"),
    });
    let cables = solution.cables.len();
    let place = words::stretch(solution.problem(), cables, cable, stretch);
    let title = match cables {
        0 | 1 => format!("Cable, {place}"),
        _ => words::capital(&place),
    };
    let friction = &solution.drive.friction;
    let rubs = friction.holes > 0.0 || friction.base_loss > 0.0;
    let strand = solution.strands.get(cable).filter(|_| rubs);
    let slip = strand.and_then(|strand| strand.slips.get(stretch));
    let slip = slip.map(|slip| row(&format!("In D{stretch}"), text(words::slips(*slip))));
    let tension = tension.map(|tension| row("Tension T", tension));
    Chip {
        title: Some(title),
        rows: tension.into_iter().chain(slip).collect(),
    }
}

/// What there is to know of a contact.
fn contact_chip(bench: &Workbench, problem: &Problem, contact: &Contact) -> Chip {
    let part = part_name(problem.robot(), contact.line, contact.node);
    let name = words::obstacle_of(&bench.document.scene, contact.obstacle);
    let multiplier = contact.multiplier * METRES_PER_MM;
    let force = bench.document.force(contact.multiplier);
    let force = force.map(|force| row("Force", force));
    let rubs = bench.live.solution().is_some_and(|solved| {
        solved.drive.friction.contacts > 0.0 && contact.class == Class::Pressing
    });
    let held = contact.friction.abs();
    let friction = rubs.then(|| {
        let force = bench.document.force(held);
        row(
            "Friction",
            force.unwrap_or_else(|| Quantity::significant(held * METRES_PER_MM, "rad²/mm")),
        )
    });
    let slides = rubs.then(|| {
        let how = match Slip::of(contact.slid) {
            Slip::Sticks => "sticks",
            Slip::In | Slip::Out => "slides",
        };
        row("The robot", text(how))
    });
    Chip {
        title: Some(words::capital(&part)),
        rows: [row(
            &words::capital(contact.class.word()),
            text(format!("on {name}")),
        )]
        .into_iter()
        .chain(force)
        .chain(friction)
        .chain(slides)
        .chain([row(
            "Multiplier λ",
            Quantity::significant(multiplier, "rad²/mm"),
        )])
        .collect(),
    }
}
