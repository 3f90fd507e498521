//! Dragging: the view, obstacles, their handles, new obstacles, the tip, the force on
//! it, gravity's direction.
//! Each frame starts from the scene as it was when the drag began, so that
//! rounding does not add up and giving up restores it exactly.

use super::hit::{self, Target};
use super::pull::TipMap;
use super::view::Canvas;
use super::{gravity, tip_force};
use crate::app::shapes::{self, Handle, Tool, drag, handles, moved, neat, vertices};
use crate::app::workbench::{Playing, Selection, Workbench};
use crate::geometry::Vector;
use crate::scene::{Obstacle, Scene, Shape};
use crate::units::{METRES_PER_MM, metres, millimetres};
use crate::view::{Frame, Quantity};
use eframe::egui::Modifiers;

/// A tip is behind the hand that drags it at this distance, and at the end of its path
/// so near to it in pull, over the robot's length.
const BEHIND: f64 = 0.08;
const ENDS: f64 = 1e-4;
/// A force whose arrow is shorter than this, in points, is none.
const NO_FORCE: f64 = 6.0;

/// A drag that is going on.
#[derive(Clone, Debug)]
pub struct Drag {
    /// What is dragged.
    pub what: Dragged,
    /// The scene before it.
    before: Scene,
    /// Where it began, in mm.
    origin: Vector,
    /// From there to what is dragged, in mm.
    grip: Vector,
    /// What the scene was last made to follow: it stays where it is while the
    /// pointer does, even where it was refused.
    followed: Option<(Vector, Modifiers)>,
}

/// What is dragged.
#[derive(Clone, Debug)]
pub enum Dragged {
    /// The view.
    View,
    /// An obstacle, by its index.
    Obstacle(usize),
    /// A handle of an obstacle with this shape.
    Handle(usize, Handle, Shape),
    /// A new obstacle, which has this index.
    New(Tool, usize),
    /// The tip.
    Tip {
        /// What tells the pull that belongs to its place.
        map: TipMap,
        /// The pull, in metres, that it stood for on the map.
        stood: f64,
        /// The pull, in mm, that it had.
        pull_mm: f64,
    },
    /// The force on the tip.
    TipForce {
        /// Newtons for a millimetre of its arrow.
        scale: f64,
        /// The force, in N, that it was.
        force: Vector,
    },
    /// Gravity's direction.
    Gravity,
}

impl Drag {
    /// A drag of the view.
    pub fn view(bench: &Workbench) -> Self {
        Self::new(bench, Dragged::View, Vector::zeros())
    }

    /// The drag that begins at a point in metres, on a target or with a tool.
    /// Selects what it takes hold of.
    pub fn begin(
        canvas: &mut Canvas,
        bench: &mut Workbench,
        frame: &Frame,
        target: Target,
        at: Vector,
    ) -> Self {
        let origin = at / METRES_PER_MM;
        let tool = canvas.tool;
        if !matches!(tool, Tool::Select | Tool::Polygon) {
            let index = bench.document.scene.obstacles.len();
            return Self::new(bench, Dragged::New(tool, index), origin);
        }
        match target {
            Target::Handle(index, handle) => {
                let Some((_, shape)) = hit::selected(canvas.tool, bench, frame) else {
                    return Self::view(bench);
                };
                let all = handles(&shape, hit::per_point(frame));
                let place = all.iter().find(|(other, _)| *other == handle);
                let grip = place.map_or(Vector::zeros(), |(_, place)| place - origin);
                canvas.vertex = match handle {
                    Handle::Vertex(vertex) => Some((index, vertex)),
                    _ => None,
                };
                let what = Dragged::Handle(index, handle, shape);
                Self {
                    grip,
                    ..Self::new(bench, what, origin)
                }
            }
            Target::Obstacle(index) => {
                if bench.selection != Selection::Obstacle(index) {
                    canvas.vertex = None;
                }
                bench.selection = Selection::Obstacle(index);
                bench.preferences.hints.obstacle = true;
                Self::new(bench, Dragged::Obstacle(index), origin)
            }
            Target::Tip => {
                bench.selection = Selection::Robot;
                bench.transport.stop();
                bench.preferences.hints.tip = true;
                let map = TipMap::of(bench);
                match map.pull_for_tip(bench, at) {
                    Some(stood) => {
                        let pull_mm = bench.pull_mm();
                        let what = Dragged::Tip {
                            map,
                            stood,
                            pull_mm,
                        };
                        Self::new(bench, what, origin)
                    }
                    None => Self::view(bench),
                }
            }
            Target::TipForce => {
                bench.selection = Selection::Robot;
                let Some(long) = tip_force::metres_per_newton(bench) else {
                    return Self::view(bench);
                };
                let what = Dragged::TipForce {
                    scale: METRES_PER_MM / long,
                    force: tip_force::force(bench),
                };
                Self::new(bench, what, origin)
            }
            Target::Gravity => Self::new(bench, Dragged::Gravity, origin),
            Target::Robot | Target::Nothing => Self::view(bench),
        }
    }

    fn new(bench: &Workbench, what: Dragged, origin: Vector) -> Self {
        Self {
            what,
            before: bench.document.scene.clone(),
            origin,
            grip: Vector::zeros(),
            followed: None,
        }
    }

    /// Whether the view is dragged, not the scene.
    pub fn is_view(&self) -> bool {
        matches!(self.what, Dragged::View)
    }

    /// The scene as it was before the drag.
    pub fn before(&self) -> &Scene {
        &self.before
    }

    /// Makes the scene follow the pointer, which is at a point in metres.
    pub fn follow(
        &mut self,
        bench: &mut Workbench,
        frame: &Frame,
        at: Vector,
        modifiers: Modifiers,
    ) {
        if self.followed == Some((at, modifiers)) {
            return;
        }
        self.followed = Some((at, modifiers));
        let per_point = hit::per_point(frame);
        let to = at / METRES_PER_MM;
        match &self.what {
            Dragged::View => {}
            Dragged::Obstacle(index) => {
                if let Some(obstacle) = self.before.obstacles.get(*index) {
                    let by = to - self.origin;
                    set(
                        bench,
                        *index,
                        moved(&obstacle.shape, by, modifiers, per_point),
                    );
                }
            }
            Dragged::Handle(index, handle, shape) => {
                let to = to + self.grip;
                set(
                    bench,
                    *index,
                    drag(shape, *handle, to, modifiers, per_point),
                );
            }
            Dragged::New(tool, index) => {
                let robot = &self.before.robot;
                if let Some(shape) = shapes::dragged(*tool, self.origin, to, robot, per_point) {
                    let obstacles = &mut bench.document.scene.obstacles;
                    if *index == obstacles.len() {
                        obstacles.push(Obstacle::from(shape));
                    } else {
                        set(bench, *index, shape);
                    }
                }
            }
            Dragged::TipForce { scale, force } => {
                let force = force + *scale * (to - self.origin);
                // No finer than the screen shows; no force within a few points.
                let grain = scale * per_point;
                let force = match force.norm() < NO_FORCE * grain {
                    true => Vector::zeros(),
                    false => force.map(|newtons| neat(newtons, grain)),
                };
                bench.document.scene.loads.tip_force_n = force.into();
            }
            Dragged::Gravity => {
                let snap = match modifiers.shift {
                    true => gravity::Snap::Marks,
                    false => gravity::Snap::Degrees,
                };
                // From where it was, so that its size stays what it is.
                let scene = &mut bench.document.scene;
                scene.loads.gravity_m_s2 = self.before.loads.gravity_m_s2;
                gravity::turn(scene, frame, frame.to_screen(at), snap);
            }
            Dragged::Tip {
                map,
                stood,
                pull_mm,
            } => {
                if let Some(pull) = map.pull_for_tip(bench, at) {
                    let span = bench.span_mm();
                    let by = millimetres(pull - stood);
                    let pull_mm = (pull_mm + by).clamp(span.0, span.1);
                    // A pull moves the tip by a few times its length.
                    bench.set_pull(neat(pull_mm, 0.5 * per_point), Playing::GoesOn);
                }
            }
        }
    }

    /// Ends the drag where it is.
    pub fn end(self, canvas: &mut Canvas, bench: &mut Workbench) {
        if let Dragged::New(_, index) = self.what {
            canvas.tool = Tool::Select;
            if index < bench.document.scene.obstacles.len() {
                bench.selection = Selection::Obstacle(index);
            }
        }
    }

    /// The target that the drag has taken hold of.
    pub fn target(&self) -> Target {
        match &self.what {
            Dragged::View => Target::Nothing,
            Dragged::Obstacle(index) | Dragged::New(_, index) => Target::Obstacle(*index),
            Dragged::Handle(index, handle, _) => Target::Handle(*index, *handle),
            Dragged::Tip { .. } => Target::Tip,
            Dragged::TipForce { .. } => Target::TipForce,
            Dragged::Gravity => Target::Gravity,
        }
    }

    /// The numbers that are being dragged, by name.
    pub fn reading(&self, bench: &Workbench) -> Vec<(&'static str, Quantity)> {
        let obstacles = &bench.document.scene.obstacles;
        let shape = |index: usize| obstacles.get(index).map(|o| &o.shape);
        match &self.what {
            Dragged::View => Vec::new(),
            Dragged::Obstacle(index) => shape(*index).map_or(Vec::new(), place_reading),
            Dragged::New(_, index) => shape(*index).map_or(Vec::new(), size_reading),
            Dragged::Handle(index, handle, _) => {
                shape(*index).map_or(Vec::new(), |shape| handle_reading(shape, *handle))
            }
            Dragged::Tip { map, .. } => {
                let pull = ("Pull", mm(bench.pull_mm()));
                let why = self.followed.and_then(|(at, _)| held_back(bench, map, at));
                std::iter::once(pull).chain(why).collect()
            }
            Dragged::Gravity => match gravity::of(bench) {
                Some(gravity) => vec![("Gravity towards", gravity::direction(gravity))],
                None => Vec::new(),
            },
            Dragged::TipForce { .. } => {
                let force = tip_force::force(bench).norm();
                vec![("Force", Quantity::significant(force, "N"))]
            }
        }
    }
}

/// Why a tip does not follow a hand that is far from it, at a point in metres.
fn held_back(bench: &Workbench, map: &TipMap, at: Vector) -> Option<(&'static str, Quantity)> {
    let TipMap::Path(path) = map else {
        return None;
    };
    let live = &bench.live;
    let tip = live.solution()?.nodes.last()?.position;
    if live.is_waiting() || (at - tip).norm() < BEHIND * live.problem().length() {
        return None;
    }
    let words = match &path.end {
        Some(end) if metres(bench.pull_mm()) >= end.pull - ENDS * path.length => {
            end.status.reason()
        }
        _ => "the tip gets no nearer".to_owned(),
    };
    let words = Quantity {
        digits: words,
        unit: "",
    };
    Some(("·", words))
}

fn set(bench: &mut Workbench, index: usize, shape: Shape) {
    if let Some(obstacle) = bench.document.scene.obstacles.get_mut(index) {
        obstacle.shape = shape;
    }
}

fn mm(value: f64) -> Quantity {
    Quantity::fixed(value, 2, "mm")
}

fn degrees(value: f64) -> Quantity {
    Quantity::fixed(value, 1, "°")
}

fn place_reading(shape: &Shape) -> Vec<(&'static str, Quantity)> {
    let [x, y] = shape.anchor_mm();
    vec![("x", mm(x)), ("y", mm(y))]
}

fn size_reading(shape: &Shape) -> Vec<(&'static str, Quantity)> {
    match shape {
        Shape::Disc { radius_mm, .. } => vec![("Radius", mm(*radius_mm))],
        Shape::Box { size_mm, .. } => {
            vec![("Width", mm(size_mm[0])), ("Height", mm(size_mm[1]))]
        }
        Shape::Capsule {
            length_mm,
            rotation_deg,
            ..
        } => vec![("Length", mm(*length_mm)), ("Turn", degrees(*rotation_deg))],
        Shape::Wall { rotation_deg, .. } => vec![("Normal", degrees(*rotation_deg))],
        Shape::Polygon { .. } => Vec::new(),
    }
}

fn handle_reading(shape: &Shape, handle: Handle) -> Vec<(&'static str, Quantity)> {
    match (shape, handle) {
        (Shape::Wall { rotation_deg, .. }, _) => vec![("Normal", degrees(*rotation_deg))],
        (shape, Handle::Turn) => vec![("Turn", degrees(shape.rotation_deg()))],
        (
            Shape::Box {
                corner_radius_mm, ..
            },
            Handle::Corner,
        ) => vec![("Corner radius", mm(*corner_radius_mm))],
        (Shape::Capsule { radius_mm, .. }, Handle::Flank(_)) => vec![("Radius", mm(*radius_mm))],
        (shape, Handle::Vertex(index)) => match vertices(shape).get(index) {
            Some(at) => vec![("x", mm(at.x)), ("y", mm(at.y))],
            None => Vec::new(),
        },
        (shape, _) => size_reading(shape),
    }
}
