//! From a solution to its picture. Decides what is shown and how large it is
//! in the world; colours are [`super::Theme`]'s business.

use super::bounds::Bounds;
use super::cables;
use super::drawing::{Caption, Drawing, Fact, Geometry, Label, LabelText, Mark, Role, Spot};
use super::force_scale::ForceScale;
use super::outcome::standing;
use super::path::{Outline, Path, clip_half_plane, hatching, outline};
use super::quantity::{Quantity, one_two_five};
use super::rubbing;
use super::shares::Shares;
use crate::contact::{Class, Contact};
use crate::equilibrium::{Solution, Solved};
use crate::forces::Stiffness;
use crate::geometry::Vector;
use crate::mechanics::{Input, Model, Problem};
use crate::robot::{Line, PlanarNode, Sizes};
use crate::scene::Scene;
use crate::units::{degrees, grams, millimetres};

/// How far around the robot obstacles are shown, over the backbone's length.
const SURROUNDINGS: f64 = 0.5;
/// How much of a wall is shown, over the backbone's length.
const WALL_DEPTH: f64 = 0.06;
/// Margin around everything, over the larger side of the picture.
const MARGIN: f64 = 0.05;
/// Arrows whose multiplier is below this share of the greatest have no number, and
/// neither have those below that share of the scale: they are next to nothing.
const LABELLED: [f64; 2] = [0.02, 0.002];
/// Most numbers on contacts, the greatest first.
const MOST_LABELS: usize = 8;
/// How far curves may be from the points that stand for them where the picture's
/// bounds are found, over the backbone's length: well inside the margin.
const COARSE: f64 = 1e-3;
/// The same where an obstacle's extent is found for its name, in metres: below a
/// pixel on robots of some centimetres, and more than one does no harm.
const NAMED: f64 = 1e-4;
/// Grid lines over the larger side of a picture, at least.
const GRID_LINES: f64 = 8.0;
/// The longest scale bar, over the picture's width and over its height: it has
/// to leave the corner beside it free.
const BAR: [f64; 2] = [0.35, 0.3];
/// How far the ground at the base reaches to either side, over the rim's radius,
/// and how far apart and how long the strokes under it are: eight of them.
const GROUND: f64 = 1.6;
const HATCH: f64 = 0.4;

/// What a picture shows that neither the problem nor the solution knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Notes {
    /// The title.
    pub title: Option<String>,
    /// The obstacles' names, in the order of the problem; may be shorter.
    pub names: Vec<Option<String>>,
    /// Where the tip has been, in metres.
    pub tip_trace: Vec<Vector>,
    /// The backbone's bending stiffness; without it contacts show multipliers
    /// in the place of forces.
    pub stiffness: Option<Stiffness>,
    /// What forces are drawn by; left out, the finest scale that shows them all.
    pub scale: Option<ForceScale>,
}

impl Notes {
    /// The title, names and stiffness of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            title: scene.title.clone(),
            names: scene.obstacles.iter().map(|o| o.name.clone()).collect(),
            tip_trace: Vec::new(),
            stiffness: Stiffness::of_scene(scene).ok().flatten(),
            scale: None,
        }
    }
}

/// The picture of a solution. A solution without nodes shows the obstacles
/// alone.
pub fn draw(solved: &Solved, notes: &Notes) -> Drawing {
    draw_on_the_way(solved, solved.problem(), notes)
}

/// The picture of a robot as it is known, on its way to a problem that is not
/// solved yet or that it does not get to: the obstacles, and the pull in the
/// caption, are that problem's.
pub fn draw_on_the_way(solved: &Solved, to: &Problem, notes: &Notes) -> Drawing {
    let (problem, solution) = (solved.problem(), solved.solution());
    let nodes = &solution.nodes[..];
    let sizes = &problem.robot().sizes;
    let most = solution.contacts.iter().map(|contact| contact.multiplier);
    let most = most.fold(0.0, f64::max);
    let scale = notes
        .scale
        .unwrap_or_else(|| ForceScale::above(problem, notes.stiffness, most));
    let shares = Shares::of(solution, scale);
    let share = |contact: &Contact| shares.contact(contact);
    let mut marks = Vec::new();
    for (index, obstacle) in to.obstacles().iter().enumerate() {
        let geometry = match outline(obstacle) {
            Outline::Closed(path) => Geometry::Path(path),
            Outline::HalfPlane { point, normal } => Geometry::HalfPlane { point, normal },
        };
        marks.push(mark(Role::Obstacle(index), geometry, 0.0));
    }
    add_base(&mut marks, nodes, sizes);
    add_path(
        &mut marks,
        Role::TipTrace,
        notes.tip_trace.iter().copied(),
        0.0,
    );
    for (index, node) in nodes.iter().enumerate() {
        if problem.robot().has_disk(index) {
            let role = match shares.disk(index) {
                Some(share) => Role::TouchedDisk(share),
                None => Role::Disk,
            };
            let across = Path::line(node.at(-sizes.rim), node.at(sizes.rim));
            marks.push(mark(role, Geometry::Path(across), sizes.disk));
        }
    }
    let cables = nodes.first().map_or(0, |_| problem.drive().cables.len());
    for index in 0..cables {
        let Some((path, is_slack)) = cables::line(solved, index) else {
            continue;
        };
        let diameter = match index {
            0 => sizes.cable,
            _ => problem.drive().cables[index].cable.diameter,
        };
        let role = if is_slack {
            Role::SlackCable
        } else {
            Role::Cable
        };
        marks.push(mark(role, Geometry::Path(path), diameter));
    }
    add_path(
        &mut marks,
        Role::Backbone,
        solution.backbone(),
        sizes.backbone,
    );
    if let Some((tip, before)) = nodes.split_last() {
        let dot = |role, at| mark(role, Geometry::Dot(at), 0.0);
        marks.extend(before.iter().map(|node| dot(Role::Node, node.position)));
        marks.push(dot(Role::Tip, tip.position));
    }
    marks.extend(rubbing::cones(solution, scale));
    for contact in &solution.contacts {
        if contact.class == Class::Pressing {
            let tail = contact.point;
            let tip = tail + scale.arrow(share(contact)) * contact.normal;
            let role = Role::Force(share(contact));
            marks.push(mark(role, Geometry::Arrow { tail, tip }, 0.0));
        }
    }
    marks.extend(rubbing::arrows(solution, scale));
    for contact in &solution.contacts {
        let role = Role::Contact {
            share: share(contact),
            class: contact.class,
        };
        marks.push(mark(role, Geometry::Dot(contact.point), 0.0));
    }
    let bounds = bounds(problem, &marks);
    let size = bounds.size();
    Drawing {
        bounds,
        grid: one_two_five(size.max() / GRID_LINES),
        scale_bar: one_two_five((BAR[0] * size.x).min(BAR[1] * size.y)),
        labels: labels(solution, notes, &marks, (most, scale), bounds),
        scale,
        presses: most > 0.0,
        caption: caption(solved, to, notes),
        standing: standing(solution),
        marks,
    }
}

fn mark(role: Role, geometry: Geometry, thickness: f64) -> Mark {
    Mark {
        role,
        geometry,
        thickness,
    }
}

fn add_path(
    marks: &mut Vec<Mark>,
    role: Role,
    points: impl Iterator<Item = Vector>,
    thickness: f64,
) {
    if let Some(path) = Path::through(points)
        && !path.pieces.is_empty()
    {
        marks.push(mark(role, Geometry::Path(path), thickness));
    }
}

fn add_base(marks: &mut Vec<Mark>, nodes: &[PlanarNode], sizes: &Sizes) {
    let [base, next, ..] = nodes else { return };
    // Behind the base, whichever way the robot leaves it.
    let normal = base.normal();
    let into = -normal * normal.dot(&(next.position - base.position)).signum();
    let (from, to) = (base.at(-GROUND * sizes.rim), base.at(GROUND * sizes.rim));
    let ground = Path::line(from, to);
    marks.push(mark(Role::Base, Geometry::Path(ground), 0.0));
    let strokes = hatching([from, to], into, HATCH * sizes.rim, HATCH * sizes.rim);
    for [from, to] in strokes {
        let stroke = Geometry::Path(Path::line(from, to));
        marks.push(mark(Role::BaseHatch, stroke, 0.0));
    }
}

/// The robot, its arrows, and what is near of the obstacles.
fn bounds(problem: &Problem, marks: &[Mark]) -> Bounds {
    let length = problem.length();
    let everywhere = Bounds::EMPTY;
    let of = |mark: &Mark| Bounds::of(mark.geometry.points(COARSE * length, &everywhere));
    let robot = marks
        .iter()
        .filter(|mark| !matches!(mark.role, Role::Obstacle(_)))
        .map(of)
        .fold(Bounds::EMPTY, Bounds::and);
    let robot = if robot.is_empty() {
        let base = problem.robot().base.position;
        Bounds::of([base]).grown(0.5 * length)
    } else {
        robot
    };
    let near = robot.grown(SURROUNDINGS * length);
    let mut all = robot;
    for mark in marks {
        match (mark.role, &mark.geometry) {
            (_, Geometry::HalfPlane { point, normal }) => {
                // The wall beside the robot, a little deep.
                let shown = clip_half_plane(*point, *normal, &near.corners());
                if shown.surface.is_some() {
                    for corner in robot.corners() {
                        let height = normal.dot(&(corner - point));
                        let foot = corner - (height + WALL_DEPTH * length) * normal;
                        if near.holds(foot) {
                            all = all.with(foot);
                        }
                    }
                }
            }
            (Role::Obstacle(_), _) => {
                let shown = of(mark).within(near);
                if !shown.is_empty() {
                    all = all.and(shown);
                }
            }
            _ => {}
        }
    }
    all.grown(MARGIN * all.size().max())
}

fn labels(
    solution: &Solution,
    notes: &Notes,
    marks: &[Mark],
    (most, scale): (f64, ForceScale),
    bounds: Bounds,
) -> Vec<Label> {
    let mut labels = Vec::new();
    let mut pressing: Vec<&Contact> = solution
        .contacts
        .iter()
        .filter(|c| c.class == Class::Pressing && c.multiplier >= LABELLED[0] * most)
        .filter(|c| scale.of(c) >= LABELLED[1])
        .collect();
    pressing.sort_by(|a, b| b.multiplier.total_cmp(&a.multiplier));
    let arrows = marks
        .iter()
        .filter_map(|mark| match (mark.role, &mark.geometry) {
            (Role::Force(_), Geometry::Arrow { tail, tip }) => Some((*tail, *tip)),
            _ => None,
        });
    let arrows: Vec<_> = arrows.collect();
    for contact in pressing.into_iter().take(MOST_LABELS) {
        let tip = arrows.iter().find(|(tail, _)| *tail == contact.point);
        labels.push(Label {
            text: LabelText::Value(scale.written(contact.multiplier)),
            spot: Spot::Beyond {
                point: tip.map_or(contact.point, |(_, tip)| *tip),
                towards: contact.normal,
            },
        });
    }
    labels.extend(rubbing::labels(solution, scale, MOST_LABELS));
    for mark in marks {
        let Role::Obstacle(index) = mark.role else {
            continue;
        };
        let extent = match &mark.geometry {
            Geometry::HalfPlane { point, normal } => {
                let shown = clip_half_plane(*point, *normal, &bounds.corners());
                Bounds::of(shown.area)
            }
            geometry => Bounds::of(geometry.points(NAMED, &bounds)).within(bounds),
        };
        if let Some(Some(name)) = notes.names.get(index)
            && !extent.is_empty()
        {
            labels.push(Label {
                text: LabelText::Name(name.clone()),
                spot: Spot::Inside(extent),
            });
        }
    }
    labels
}

fn caption(solved: &Solved, to: &Problem, notes: &Notes) -> Caption {
    let solution = solved.solution();
    let mm = |value| Quantity::fixed(millimetres(value), 2, "mm");
    let mut facts = Vec::new();
    let mut fact = |name, value: Quantity, asked: Option<Quantity>| {
        // To the digits shown.
        let asked = asked.filter(|asked| *asked != value);
        facts.push(Fact { name, value });
        facts.extend(asked.map(|value| Fact { name: "of", value }));
    };
    if solution.cables.is_empty() {
        fact("pull", mm(solution.pull), Some(mm(to.pull())));
    }
    let load = |load: f64| Quantity::fixed(grams(load), 1, "g");
    let goals = to.drive().cables.iter().map(|driven| driven.input);
    let inputs = solution.drive.cables.iter().map(|driven| driven.input);
    for ((input, goal), state) in inputs.zip(goals).zip(&solution.cables) {
        match (input, goal) {
            (Input::Load(now), Input::Load(goal)) => fact("load", load(now), Some(load(goal))),
            (Input::Load(now), Input::Pull(_)) => fact("load", load(now), None),
            (Input::Pull(_), goal) => {
                let name = match solved.problem().model() {
                    Model::Sliding if state.is_slack => "slack, pull",
                    _ => "pull",
                };
                let goal = match goal {
                    Input::Pull(goal) => Some(mm(goal)),
                    Input::Load(_) => None,
                };
                fact(name, mm(state.pull), goal);
            }
        }
    }
    if let Some(tip) = solution.nodes.last() {
        let turned = degrees(solved.problem().robot().base.angle - tip.angle);
        for (name, value) in [
            ("tip x", mm(tip.position.x)),
            ("y", mm(tip.position.y)),
            ("bend", Quantity::fixed(turned, 1, "°")),
        ] {
            facts.push(Fact { name, value });
        }
    }
    Caption {
        title: notes.title.clone(),
        facts,
        note: note(to),
    }
}

/// Which nodes obstacles keep out, where it is not all of them: the others are
/// drawn inside obstacles that they pass through.
fn note(problem: &Problem) -> Option<String> {
    let candidates = problem.candidates();
    let robot = problem.robot();
    let of_cables: usize = match problem.model() {
        Model::Equal => robot.segments,
        Model::Sliding => {
            let cables = problem.drive().cables.iter();
            let nodes = cables.map(|driven| driven.cable.last_disk * robot.segments_per_bay);
            nodes.sum()
        }
    };
    let has_body = candidates
        .iter()
        .any(|candidate| candidate.line == Line::BackboneLink);
    let all = has_body || candidates.len() >= robot.segments + of_cables;
    if problem.obstacles().is_empty() || all {
        return None;
    }
    let names: Vec<String> = candidates
        .iter()
        .map(|candidate| format!("{} node {}", candidate.line.name(), candidate.node))
        .collect();
    Some(match names.len() {
        0 => "obstacles keep nothing out".to_owned(),
        1..=3 => format!("obstacles keep out only {}", names.join(", ")),
        count => format!("obstacles keep out only {count} nodes"),
    })
}
