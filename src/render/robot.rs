//! From a solution to its solids: backbone, disks, cable, base and obstacles
//! as one mesh. Decides what there is and what it is made of; light is the
//! shader's business.

use super::mesh::{Bounds3, Flat, Material, Mesh, Point, Triangles, Turned, lifted};
use super::outline::{self, Corner};
use super::plate::{Plate, Template};
use crate::contact::{Class, Contact};
use crate::equilibrium::Solved;
use crate::geometry::{Core, Obstacle, Vector};
use crate::mechanics::Problem;
use crate::robot::{PlanarNode, Robot};
use crate::view::{Bounds, Colour, ForceScale, Role, Shares, Standing, Theme};
use nalgebra::Vector3;
use std::f32::consts::FRAC_PI_2;

/// How far around the robot obstacles are shown, over the backbone's length.
const SURROUNDINGS: f64 = 0.6;
/// How far around it a picture reaches at most.
const NEAR: f64 = 0.22;
/// How thick a wall is drawn.
const WALL: f64 = 0.05;

/// How thick the parts are drawn, in metres: as they are or, where a scene
/// leaves them at zero, as thin as can still be seen.
struct Drawn {
    /// Radius of the disks' rim.
    rim: f64,
    /// Thickness of a disk.
    disk: f64,
    /// Radius of the backbone.
    backbone: f64,
    /// Radius of the cable.
    cable: f64,
}

impl Drawn {
    fn of(robot: &Robot) -> Self {
        let bay = robot.length * robot.segments_per_bay as f64 / robot.segments.max(1) as f64;
        // Thick enough to see, and no thicker than there is room for.
        let visible = |given: f64, share: f64, room: f64| {
            if given > 0.0 {
                given
            } else {
                (share * robot.length).min(room)
            }
        };
        let (sizes, offset) = (&robot.sizes, robot.offset);
        Self {
            rim: sizes.rim,
            disk: visible(sizes.disk, 0.0095, 0.4 * bay),
            backbone: visible(0.5 * sizes.backbone, 0.0062, 0.3 * offset),
            cable: visible(0.5 * sizes.cable, 0.0030, 0.2 * offset),
        }
    }
}

/// What the parts are made of in one picture.
struct Materials {
    backbone: Material,
    disk: Material,
    cable: Material,
    base: Material,
    obstacle: Material,
}

impl Materials {
    fn of(theme: Theme, standing: &Standing) -> Self {
        let stroke = |role| {
            let style = theme.style(role, standing);
            style.fill.or(style.stroke).map_or([128; 3], |c| c.rgb)
        };
        let made = |colour, gloss, metal| Material {
            colour,
            emission: 0,
            gloss,
            metal,
        };
        let quiet = theme.style(Role::Obstacle(0), standing);
        let obstacle = match theme {
            Theme::Light => quiet.fill,
            // By night the fill is as dark as the shadows.
            Theme::Dark => quiet.stroke,
        };
        let obstacle = obstacle.map_or([128; 3], |c| c.rgb);
        Self {
            backbone: made(stroke(Role::Backbone), 210, 90),
            disk: made(stroke(Role::Disk), 120, 40),
            cable: made(stroke(Role::Cable), 150, 0),
            base: made(stroke(Role::Base), 110, 60),
            obstacle: made(obstacle, 70, 0),
        }
    }
}

/// The solids of a solution among these obstacles, its problem's own or those
/// that it is on its way to, with forces by a scale. One without nodes shows the
/// obstacles alone.
pub fn mesh(
    solved: &Solved,
    obstacles: &[Obstacle],
    scale: ForceScale,
    theme: Theme,
    standing: &Standing,
) -> Mesh {
    let (problem, solution) = (solved.problem(), solved.solution());
    let sizes = &Drawn::of(problem.robot());
    let base = problem.robot().base.position;
    let nodes = &solution.nodes[..];
    let length = problem.length();
    let robot = Bounds::of(solution.backbone().chain([base])).grown(sizes.rim);
    let around = robot.grown(SURROUNDINGS * length);
    let near = robot.grown(NEAR * length);
    // How deep the scene is, told by the disks.
    let depth = sizes.rim.max(0.02 * length);
    let board = -1.9 * depth;
    let span = [board as f32, 1.25 * depth as f32];
    let materials = Materials::of(theme, standing);
    let origin = around.centre();
    let flat = |v: Vector| Flat::new((v.x - origin.x) as f32, (v.y - origin.y) as f32);
    let shares = Shares::of(solution, scale);
    let share = |contact: &Contact| shares.contact(contact);

    let mut solids = Triangles::default();
    let mut shown = robot;
    for obstacle in obstacles {
        let bevel = 0.006 * length;
        let area = match obstacle.core() {
            Core::HalfPlane => &near,
            _ => &around,
        };
        let outline = outline::corners(obstacle, area, origin, bevel, WALL * length);
        if let Some((corners, bevel)) = outline {
            solids.prism(&corners, span, bevel as f32, &materials.obstacle);
            let seen = extent(&corners, origin).within(near);
            if !seen.is_empty() {
                shown = shown.and(seen);
            }
        }
    }
    if let [first, next, ..] = nodes {
        let block = base_block(first, next, sizes);
        let reach = 10.0 * (block.reach + length);
        let everywhere = Bounds::of([base]).grown(reach);
        if let Some((corners, bevel)) =
            outline::corners(&block.obstacle, &everywhere, origin, 0.004 * length, 0.0)
        {
            solids.prism(&corners, span, bevel as f32, &materials.base);
            shown = shown.and(extent(&corners, origin));
        }
    }
    add_disks(&mut solids, problem, nodes, sizes, flat, |index| {
        let colour = |share| theme.contact(share);
        match shares.disk(index) {
            Some(share) if !standing.is_greyed() => glowing(colour(share), share),
            _ => materials.disk,
        }
    });
    let n = nodes.len();
    let backbone: Vec<Flat> = nodes.iter().map(|node| flat(node.position)).collect();
    if let [first, .., last] = nodes {
        let ends = [first, last].map(|node| {
            let normal = node.normal();
            let along = nodes[1].position - nodes[0].position;
            let normal = normal * normal.dot(&along).signum();
            Flat::new(normal.x as f32, normal.y as f32)
        });
        let steps = (160 / n).clamp(2, 8);
        // Both run on into the base, and the backbone through the last disk.
        let into = sizes.rim as f32;
        let over = 0.55 * sizes.disk as f32;
        let mut line = smooth(&backbone, ends, steps);
        line.insert(0, (line[0].0 - into * ends[0], ends[0]));
        line.push((backbone[n - 1] + over * ends[1], ends[1]));
        solids.tube(&line, sizes.backbone as f32, 18, &materials.backbone);
        for (index, driven) in solved.problem().drive().cables.iter().enumerate() {
            let points: Vec<Flat> = solved.cable_points(index).into_iter().map(flat).collect();
            let mut cable = straight(&points);
            let end = nodes[points.len() - 1].normal();
            let end = match points.len() == nodes.len() {
                true => ends[1],
                false => Flat::new(end.x as f32, end.y as f32),
            };
            cable.insert(0, (cable[0].0 - into * ends[0], ends[0]));
            cable.push((cable[points.len()].0 + over * end, end));
            let diameter = match index {
                0 => sizes.cable,
                _ => driven.cable.diameter,
            };
            solids.tube(&cable, diameter as f32, 12, &materials.cable);
        }
    }
    let mut overlay = Triangles::default();
    let mut glows = Vec::new();
    for contact in &solution.contacts {
        let at = lifted(flat(contact.point));
        let style = theme.style(
            Role::Contact {
                share: share(contact),
                class: contact.class,
            },
            standing,
        );
        let colour = style.fill.or(style.stroke).map_or([128; 3], |c| c.rgb);
        let pressing = contact.class == Class::Pressing;
        let bead = Material {
            colour,
            emission: if pressing && !standing.is_greyed() {
                170
            } else {
                0
            },
            gloss: 120,
            metal: 0,
        };
        let radius = if pressing { 0.010 } else { 0.006 } * length;
        overlay.ball(at, radius as f32, &bead);
        if pressing {
            let arrow = scale.arrow(share(contact));
            add_arrow(&mut overlay, contact, at, arrow, length, &bead);
            if !standing.is_greyed() {
                let strength = (0.55 + 0.45 * share(contact)) * (20.0 * share(contact)).min(1.0);
                Mesh::add_glow(
                    &mut glows,
                    at,
                    0.10 * length as f32,
                    colour,
                    strength as f32,
                );
            }
        }
    }
    let focus = Bounds3 {
        least: Vector3::new(shown.least.x, shown.least.y, board),
        most: Vector3::new(shown.most.x, shown.most.y, f64::from(span[1])),
    };
    Mesh {
        origin: Vector3::new(origin.x, origin.y, 0.0),
        board,
        length,
        focus,
        solids,
        overlay,
        glows,
    }
}

/// A material that shines by itself, in the colour of a contact.
fn glowing(colour: Colour, share: f64) -> Material {
    Material {
        colour: colour.rgb,
        emission: (60.0 + 80.0 * share) as u8,
        gloss: 90,
        metal: 0,
    }
}

fn extent(corners: &[Corner], origin: Vector) -> Bounds {
    Bounds::of(corners.iter().map(|corner| {
        let place = corner.position;
        origin + Vector::new(f64::from(place.x), f64::from(place.y))
    }))
}

/// The block that holds the base.
struct Block {
    obstacle: Obstacle,
    reach: f64,
}

fn base_block(base: &PlanarNode, next: &PlanarNode, sizes: &Drawn) -> Block {
    // Behind the base, whichever way the robot leaves it.
    let normal = base.normal();
    let into = -normal * normal.dot(&(next.position - base.position)).signum();
    let (wide, deep) = (3.6 * sizes.rim, 1.1 * sizes.rim);
    let radius = 0.12 * sizes.rim;
    let middle = base.position + (0.5 * deep + 0.5 * sizes.disk) * into;
    let core = Core::rectangle(wide - 2.0 * radius, deep - 2.0 * radius);
    Block {
        obstacle: Obstacle::new(core, radius, middle, base.angle),
        reach: wide,
    }
}

fn add_disks(
    solids: &mut Triangles,
    problem: &Problem,
    nodes: &[PlanarNode],
    sizes: &Drawn,
    flat: impl Fn(Vector) -> Flat,
    material: impl Fn(usize) -> Material,
) {
    let robot = problem.robot();
    let offset = robot.offset as f32;
    let plate = Plate {
        rim: sizes.rim as f32,
        thickness: sizes.disk as f32,
        // Room around what runs through, but never one hole into the other.
        middle_hole: (1.25 * sizes.backbone as f32).min(0.45 * offset),
        offset,
        cable_hole: (1.9 * sizes.cable as f32).min(0.4 * offset),
    };
    let disks = nodes.len() / robot.segments_per_bay.max(1);
    let slices = if disks > 40 { 28 } else { 56 };
    let template = Template::new(&plate, slices);
    for (index, node) in nodes.iter().enumerate() {
        if robot.has_disk(index) {
            let cable = Flat::new(node.disk.x as f32, node.disk.y as f32);
            template.add(solids, flat(node.position), cable, &material(index));
        }
    }
}

/// A smooth line through points with its unit directions, given those at its
/// ends: cubic Hermite pieces of so many steps.
fn smooth(points: &[Flat], ends: [Flat; 2], steps: usize) -> Vec<(Flat, Flat)> {
    let last = points.len() - 1;
    let slope = |i: usize| match i {
        0 => ends[0] * (points[1] - points[0]).norm(),
        i if i == last => ends[1] * (points[last] - points[last - 1]).norm(),
        i => 0.5 * (points[i + 1] - points[i - 1]),
    };
    let mut line = vec![(points[0], ends[0])];
    for i in 0..last {
        let (a, b, from, to) = (points[i], points[i + 1], slope(i), slope(i + 1));
        for step in 1..=steps {
            let t = step as f32 / steps as f32;
            let (t2, t3) = (t * t, t * t * t);
            let point = (2.0 * t3 - 3.0 * t2 + 1.0) * a
                + (t3 - 2.0 * t2 + t) * from
                + (3.0 * t2 - 2.0 * t3) * b
                + (t3 - t2) * to;
            let direction = 6.0 * (t2 - t) * (a - b)
                + (3.0 * t2 - 4.0 * t + 1.0) * from
                + (3.0 * t2 - 2.0 * t) * to;
            line.push((point, direction.normalize()));
        }
    }
    line
}

/// The straight pieces between points with the unit directions of their
/// corners.
fn straight(points: &[Flat]) -> Vec<(Flat, Flat)> {
    let last = points.len() - 1;
    let direction = |i: usize| points[(i + 1).min(last)] - points[i.saturating_sub(1)];
    (0..=last)
        .map(|i| {
            (
                points[i],
                direction(i).try_normalize(0.0).unwrap_or(Flat::y()),
            )
        })
        .collect()
}

/// The force on the robot, from the contact into it.
fn add_arrow(
    overlay: &mut Triangles,
    contact: &Contact,
    tail: Point,
    arrow: f64,
    length: f64,
    material: &Material,
) {
    let head = 0.055 * length;
    // A short arrow keeps its shape and shrinks.
    let size = (arrow / (1.3 * head)).min(1.0);
    let (head, wide, shaft) = (size * head, 0.017 * size * length, 0.0052 * size * length);
    let neck = arrow - head;
    let slope = (wide / head).atan() as f32;
    let at = |along: f64, radius: f64, slope: f32| Turned {
        along: along as f32,
        radius: radius as f32,
        slope,
    };
    let profile = [
        at(0.0, shaft, 0.0),
        at(neck, shaft, 0.0),
        at(neck, shaft, -FRAC_PI_2),
        at(neck, wide, -FRAC_PI_2),
        at(neck, wide, slope),
        at(arrow, 0.0, slope),
    ];
    let axis = Flat::new(contact.normal.x as f32, contact.normal.y as f32);
    overlay.turned(tail, axis, &profile, 24, material);
}

#[cfg(test)]
mod tests;
