//! What is under a point of the canvas, and how near is near enough.

use super::{gravity, tip_force};
use crate::app::shapes::{Handle, Tool, Turned, handles};
use crate::app::workbench::{Hovered, Live, Workbench, nodes_of_stretch};
use crate::equilibrium::Solved;
use crate::geometry::{Obstacle, Vector};
use crate::scene::Shape;
use crate::units::{METRES_PER_MM, millimetres};
use crate::view::{Frame, clip_half_plane};
use eframe::egui::{CursorIcon, Ui};

/// How near the pointer has to be, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// To a handle or the tip.
    pub handle: f64,
    /// To an obstacle's outline, from outside.
    pub outline: f64,
    /// To a node, a contact or the backbone.
    pub node: f64,
}

impl Reach {
    const MOUSE: Self = Self {
        handle: 9.0,
        outline: 4.0,
        node: 10.0,
    };
    const TOUCH: Self = Self {
        handle: 22.0,
        outline: 12.0,
        node: 22.0,
    };

    /// The reach of what is pointing: a finger has a wider one.
    pub fn of(ui: &Ui) -> Self {
        if ui.input(|input| input.any_touches()) {
            Self::TOUCH
        } else {
            Self::MOUSE
        }
    }
}

/// What a drag that begins at a point takes hold of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A handle of the selected obstacle.
    Handle(usize, Handle),
    /// The robot's tip.
    Tip,
    /// The force on it.
    TipForce,
    /// The dial of gravity.
    Gravity,
    /// An obstacle.
    Obstacle(usize),
    /// The robot.
    Robot,
    /// The plane.
    Nothing,
}

impl Target {
    /// The obstacle that the target is or belongs to.
    pub fn obstacle(self) -> Option<usize> {
        match self {
            Target::Handle(index, _) | Target::Obstacle(index) => Some(index),
            _ => None,
        }
    }
}

/// What is at a point, in metres.
pub fn target_at(
    tool: Tool,
    bench: &Workbench,
    frame: &Frame,
    point: Vector,
    reach: Reach,
) -> Target {
    let place = frame.to_screen(point);
    if tool == Tool::Select && gravity::is_held_at(bench, frame, place, 1.5 * reach.handle) {
        return Target::Gravity;
    }
    if let Some((index, shape)) = selected(tool, bench, frame) {
        let all = handles(&shape, per_point(frame));
        let away = all.iter().map(|(_, at)| at * METRES_PER_MM);
        // Corners come after the sides they end.
        if let Some(nearest) = nearest(away, point, reach.handle / frame.scale) {
            return Target::Handle(index, all[nearest].0);
        }
    }
    let Some(solution) = bench.live.solution() else {
        return under(&bench.live, frame, point, reach);
    };
    let grip = tip_force::grip(bench, frame).filter(|_| tool == Tool::Select);
    if nearest(grip.into_iter(), point, reach.handle / frame.scale).is_some() {
        return Target::TipForce;
    }
    let tip = solution.nodes.last().map(|node| node.position);
    if nearest(tip.into_iter(), point, reach.handle / frame.scale).is_some() {
        return Target::Tip;
    }
    match under(&bench.live, frame, point, reach) {
        Target::Nothing => {
            let backbone: Vec<Vector> = solution.backbone().collect();
            let near = 0.8 * reach.node / frame.scale;
            let mut links = backbone.windows(2);
            let on = links.any(|ends| away_from([ends[0], ends[1]], point) <= near);
            if on { Target::Robot } else { Target::Nothing }
        }
        obstacle => obstacle,
    }
}

/// The topmost obstacle at a point.
fn under(live: &Live, frame: &Frame, point: Vector, reach: Reach) -> Target {
    let margin = reach.outline / frame.scale;
    let on = |obstacle: &Obstacle| obstacle.clearance(point).distance <= margin;
    let found = live.problem().obstacles().iter().rposition(on);
    found.map_or(Target::Nothing, Target::Obstacle)
}

/// What at a point has twins in other parts of the window: the nearest of
/// contacts and nodes, or an obstacle.
pub fn hovered_at(bench: &Workbench, frame: &Frame, point: Vector, reach: Reach) -> Hovered {
    let near = reach.node / frame.scale;
    if let Some(solution) = bench.live.solution() {
        let contacts = solution.contacts.iter().map(|contact| contact.point);
        if let Some(index) = nearest(contacts, point, near) {
            return Hovered::Contact(index);
        }
        if let Some(index) = nearest(solution.backbone(), point, near) {
            return Hovered::Node(index);
        }
        if let Some(stretch) = stretch_at(solution, point, 0.6 * near) {
            return stretch;
        }
    }
    match under(&bench.live, frame, point, reach) {
        Target::Obstacle(index) => Hovered::Obstacle(index),
        _ => Hovered::Nothing,
    }
}

/// The nearest stretch of a cable, if it is near enough.
fn stretch_at(solution: &Solved, point: Vector, near: f64) -> Option<Hovered> {
    let problem = solution.problem();
    let per_stretch = nodes_of_stretch(problem, 0).len();
    let cables = (0..solution.cables.len()).filter(|_| !solution.nodes.is_empty());
    let pieces = cables.flat_map(|cable| {
        let points = solution.cable_points(cable);
        let pieces = (1..points.len()).map(move |i| (i, [points[i - 1], points[i]]));
        pieces.map(move |(i, ends)| (cable, (i - 1) / per_stretch, away_from(ends, point)))
    });
    let nearest = pieces.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let (cable, stretch, away) = nearest;
    (away <= near).then_some(Hovered::Stretch { cable, stretch })
}

/// How far a point is from a straight piece of a line.
fn away_from(ends: [Vector; 2], point: Vector) -> f64 {
    let along = ends[1] - ends[0];
    let share = (point - ends[0]).dot(&along) / along.norm_squared();
    (ends[0] + share.clamp(0.0, 1.0) * along - point).norm()
}

/// The selected obstacle with the shape whose handles are shown, if any are: a
/// wall is held by what is seen of its surface.
pub fn selected(tool: Tool, bench: &Workbench, frame: &Frame) -> Option<(usize, Shape)> {
    if tool != Tool::Select {
        return None;
    }
    let index = bench.selection.obstacle()?;
    let shape = &bench.document.scene.obstacles.get(index)?.shape;
    Some((index, in_view(shape, frame)))
}

/// The same shape, a wall anchored in the middle of what is seen of it where
/// its anchor is out of view.
fn in_view(shape: &Shape, frame: &Frame) -> Shape {
    let mut seen = shape.clone();
    if let Shape::Wall {
        point_mm,
        rotation_deg,
        ..
    } = &mut seen
    {
        let normal = Turned::by(*rotation_deg).x;
        let anchor = Vector::from(*point_mm) * METRES_PER_MM;
        let inner = frame.window.grown(-40.0);
        let corners = inner.corners().map(|corner| frame.to_world(corner));
        if !inner.holds(frame.to_screen(anchor))
            && let Some([a, b]) = clip_half_plane(anchor, normal, &corners).surface
        {
            *point_mm = (0.5 * (a + b)).map(millimetres).into();
        }
    }
    seen
}

/// Millimetres in a point of the screen.
pub fn per_point(frame: &Frame) -> f64 {
    millimetres(1.0 / frame.scale)
}

/// The cursor over a target.
pub fn cursor(target: Target, shape: Option<&Shape>, held: Held) -> CursorIcon {
    let resize = |degrees: f64| {
        // Screens have y downward; resizing looks the same from both sides.
        match ((degrees / 45.0).round() as i64).rem_euclid(4) {
            0 => CursorIcon::ResizeHorizontal,
            1 => CursorIcon::ResizeNeSw,
            2 => CursorIcon::ResizeVertical,
            _ => CursorIcon::ResizeNwSe,
        }
    };
    let turn = shape.map_or(0.0, Shape::rotation_deg);
    match target {
        Target::Handle(_, handle) => match handle {
            Handle::Rim(way) => resize(90.0 * f64::from(way)),
            Handle::Side { x, y } => {
                let angle = f64::from(y).atan2(f64::from(x)).to_degrees();
                resize(turn + angle)
            }
            Handle::Corner => resize(turn + 45.0),
            Handle::Flank(_) => resize(turn + 90.0),
            Handle::End(_) | Handle::Vertex(_) => CursorIcon::Move,
            Handle::Turn => held.cursor(),
        },
        Target::Tip | Target::TipForce | Target::Gravity | Target::Obstacle(_) => held.cursor(),
        Target::Robot => CursorIcon::PointingHand,
        Target::Nothing => CursorIcon::Default,
    }
}

/// Whether something is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// It is being dragged.
    Yes,
    /// It could be.
    No,
}

impl Held {
    fn cursor(self) -> CursorIcon {
        match self {
            Held::Yes => CursorIcon::Grabbing,
            Held::No => CursorIcon::Grab,
        }
    }
}

/// The nearest of some points, if it is near enough.
fn nearest(points: impl Iterator<Item = Vector>, to: Vector, near: f64) -> Option<usize> {
    let away = points.map(|point| (point - to).norm()).enumerate();
    away.filter(|(_, away)| *away <= near)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}
