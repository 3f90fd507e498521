//! From a scene, in the file's units, to a problem that cannot be wrong.

use super::candidate::{Candidate, Element, Joins, Line};
use super::node::PlanarNode;
use super::problem::Problem;
use super::robot::Robot;
use super::sizes::Sizes;
use crate::geometry::{Core, Edge, Obstacle, Vector};
use crate::scene::{self, Candidates, Scene, SceneError, Shape, limits::shown};
use crate::units::{metres, millimetres, radians};

impl Problem {
    /// The problem a scene describes.
    ///
    /// # Errors
    /// The first of [`Problem::faults`].
    pub fn new(scene: &Scene) -> Result<Self, SceneError> {
        match Self::parse(scene) {
            Ok(problem) => Ok(problem),
            Err(mut faults) => Err(faults.swap_remove(0)),
        }
    }

    /// Everything that keeps a scene from being solved, in the order of the
    /// file: fields out of range ([`Scene::faults`]) or, where there are none,
    /// a pull that no linkage can take and obstacles over the base.
    pub fn faults(scene: &Scene) -> Vec<SceneError> {
        Self::parse(scene).err().unwrap_or_default()
    }

    /// The problem a scene describes.
    ///
    /// # Errors
    /// All of [`Problem::faults`], at least one.
    pub fn parse(scene: &Scene) -> Result<Self, Vec<SceneError>> {
        let faults = scene.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let robot = robot(&scene.robot);
        let candidates = candidates(scene, &robot);
        let mut faults = Vec::new();
        let pull = metres(scene.actuation.pull_mm);
        let (least, most) = robot.pull_range();
        if !(least..=most).contains(&pull) {
            faults.push(SceneError::not_within(
                "actuation.pull_mm",
                scene.actuation.pull_mm,
                format!(
                    "for which the segments' linkages exist, from {} to {}",
                    shown(rounded_towards_zero(millimetres(least))),
                    shown(rounded_towards_zero(millimetres(most)))
                ),
                "mm",
            ));
        }
        let mut obstacles = Vec::new();
        for (index, described) in scene.obstacles.iter().enumerate() {
            match obstacle(&described.shape) {
                Some(obstacle) => {
                    if covers_base(&robot, scene, &obstacle) {
                        faults.push(over_base(index, described));
                    }
                    obstacles.push(obstacle);
                }
                None => faults.push(SceneError::Geometry {
                    field: format!("obstacle[{index}].points_mm"),
                    problem: "spans no area to within rounding".to_owned(),
                    advice: "move its vertices apart".to_owned(),
                }),
            }
        }
        if faults.is_empty() {
            Ok(Problem::from_parts(robot, pull, candidates, obstacles))
        } else {
            Err(faults)
        }
    }
}

/// Two decimals, so that the bound named in a message is itself allowed.
fn rounded_towards_zero(value: f64) -> f64 {
    (value * 100.0).trunc() / 100.0
}

fn over_base(index: usize, obstacle: &scene::Obstacle) -> SceneError {
    let name = obstacle.name.as_deref().unwrap_or(obstacle.shape.word());
    SceneError::Geometry {
        field: format!("obstacle[{index}] ({name})"),
        problem: "covers the robot's base, which cannot move".to_owned(),
        advice: "move or shrink it until it is clear of the first disk".to_owned(),
    }
}

fn robot(described: &scene::Robot) -> Robot {
    let angle = radians(described.base_angle_deg);
    Robot {
        length: metres(described.length_mm),
        segments: described.segments as usize,
        segments_per_bay: described.segments_per_bay as usize,
        offset: metres(described.cable_offset_mm),
        sizes: Sizes::of(described),
        base: PlanarNode {
            position: point(described.base_mm),
            disk: Vector::new(libm::cos(angle), libm::sin(angle)),
            angle,
        },
    }
}

/// A point from the file's millimetres.
fn point([x, y]: [f64; 2]) -> Vector {
    Vector::new(metres(x), metres(y))
}

/// The obstacle of a shape. `None` for a polygon without area.
pub(super) fn obstacle(shape: &Shape) -> Option<Obstacle> {
    let position = point(shape.anchor_mm());
    let angle = radians(shape.rotation_deg());
    let (core, radius_mm) = match shape {
        Shape::Disc { radius_mm, .. } => (Core::Point, *radius_mm),
        Shape::Wall {
            corner_radius_mm, ..
        } => (Core::HalfPlane, *corner_radius_mm),
        Shape::Box {
            size_mm,
            corner_radius_mm,
            ..
        } => (rounded_box(*size_mm, *corner_radius_mm), *corner_radius_mm),
        Shape::Capsule {
            length_mm,
            radius_mm,
            ..
        } => (Core::segment(metres(*length_mm)), *radius_mm),
        Shape::Polygon {
            points_mm,
            corner_radius_mm,
            ..
        } => {
            let local: Vec<Vector> = points_mm.iter().map(|p| point(*p) - position).collect();
            (Core::polygon(&local)?, *corner_radius_mm)
        }
    };
    Some(Obstacle::new(core, metres(radius_mm), position, angle))
}

/// What is left of a box inside its rounded corners: a smaller box, or a
/// segment or a point where the corners take the whole width.
fn rounded_box(size_mm: [f64; 2], corner_radius_mm: f64) -> Core {
    let [width, height] = size_mm.map(|side| metres(side - 2.0 * corner_radius_mm).max(0.0));
    match (width > 0.0, height > 0.0) {
        (true, true) => Core::rectangle(width, height),
        (true, false) => Core::segment(width),
        (false, true) => {
            let end = Vector::new(0.0, 0.5 * height);
            Core::Vertices(vec![-end, end])
        }
        (false, false) => Core::Point,
    }
}

fn candidates(scene: &Scene, robot: &Robot) -> Vec<Candidate> {
    let nodes = 1..=robot.segments;
    let cable = robot.offset;
    let at = |line, node, lever| Candidate {
        line,
        node,
        element: Element::Point { lever },
        radius: 0.0,
        joins: Joins::Nothing,
    };
    match scene.contact.candidates {
        Candidates::Nodes => nodes
            .flat_map(|i| [at(Line::Backbone, i, 0.0), at(Line::Cable, i, cable)])
            .collect(),
        Candidates::Listed => {
            let listed = scene.contact.listed.iter().map(|listed| {
                let node = listed.node as usize;
                match listed.line {
                    scene::Line::Backbone => at(Line::Backbone, node, 0.0),
                    scene::Line::Cable => at(Line::Cable, node, cable),
                }
            });
            listed.collect()
        }
        Candidates::Body => nodes.flat_map(|node| robot.parts(node)).collect(),
    }
}

/// Whether the obstacle overlaps what cannot move, the first disk, by more
/// than touching it. Listed nodes never include it.
fn covers_base(robot: &Robot, scene: &Scene, obstacle: &Obstacle) -> bool {
    let base = robot.base;
    let (start, end, thickness) = match scene.contact.candidates {
        Candidates::Listed => return false,
        Candidates::Nodes => (base.position, base.at(robot.offset), 0.0),
        Candidates::Body => {
            let Sizes { rim, disk, .. } = robot.sizes;
            (base.at(-rim), base.at(rim), 0.5 * disk)
        }
    };
    let touching = robot.touching();
    let least = thickness - touching;
    let mut covered = [start, end]
        .iter()
        .any(|point| obstacle.clearance(*point).distance < least);
    if scene.contact.candidates == Candidates::Body {
        let depth = obstacle.crossing_depth(start, end);
        covered |= depth.is_some_and(|depth| depth - obstacle.radius() > touching);
        obstacle.edge_clearances(&Edge::alone(start, end), |clearance| {
            covered |= clearance.distance < least;
        });
    }
    covered
}

#[cfg(test)]
mod tests {
    use super::super::four_bar::FourBar;
    use super::*;

    fn check(edit: impl Fn(&mut Scene), expect: &str) {
        let mut scene = Scene {
            obstacles: vec![
                Shape::Disc {
                    center_mm: [40.0, 100.0],
                    radius_mm: 10.0,
                }
                .into(),
            ],
            ..Scene::default()
        };
        edit(&mut scene);
        let found = match Problem::new(&scene) {
            Ok(_) => "fine".to_owned(),
            Err(error) => error.to_string(),
        };
        assert_eq!(found, expect);
    }

    #[test]
    fn what_cannot_exist_is_told_with_its_bounds() {
        check(|_| {}, "fine");
        check(
            |scene| scene.actuation.pull_mm = 176.5,
            "actuation.pull_mm is 176.5 mm; set it to a value for which the segments' linkages \
             exist, from -286.9 to 176.4 mm",
        );
        check(|scene| scene.actuation.pull_mm = 176.4, "fine");
        check(
            |scene| {
                scene.obstacles[0].shape = Shape::Disc {
                    center_mm: [8.0, 9.0],
                    radius_mm: 10.0,
                }
            },
            "obstacle[0] (disc) covers the robot's base, which cannot move; move or shrink it \
             until it is clear of the first disk",
        );
        // A thin bar between the base's two points covers neither of them.
        check(
            |scene| {
                scene.obstacles[0].shape = Shape::Capsule {
                    center_mm: [4.0, 0.0],
                    length_mm: 20.0,
                    radius_mm: 0.5,
                    rotation_deg: 90.0,
                }
            },
            "fine",
        );
        check(
            |scene| {
                scene.contact.candidates = Candidates::Body;
                scene.obstacles[0].shape = Shape::Capsule {
                    center_mm: [4.0, 0.0],
                    length_mm: 20.0,
                    radius_mm: 0.5,
                    rotation_deg: 90.0,
                }
            },
            "obstacle[0] (capsule) covers the robot's base, which cannot move; move or shrink it \
             until it is clear of the first disk",
        );
    }

    #[test]
    fn the_pull_range_ends_where_the_linkage_does() {
        let robot = robot(&scene::Robot::default());
        let (least, most) = robot.pull_range();
        for pull in [least, most] {
            let n = robot.segments as f64;
            let segment = FourBar::new(robot.length / n, pull / n, robot.offset);
            assert!(segment.free_bend().abs() <= super::super::MOST_BEND + 1e-12);
            assert!(segment.cable() > 0.0 && segment.at(0.0).cost[0].is_finite());
        }
    }
}
