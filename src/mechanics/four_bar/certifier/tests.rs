//! The certificate's pieces against differences of their own definitions, on a
//! shape that need not be an equilibrium: every term of the Lagrangian's
//! Hessian, the motions that the links allow, and the sign of its pivots.

use super::*;
use crate::contact::Class;
use crate::geometry::{Core, Obstacle};
use crate::robot::{Joins, Line, PlanarNode, Robot, Sizes};
use nalgebra::{DMatrix, SymmetricEigen, matrix};

/// A backbone and a cable point a node.
type Points = Vec<(Vector, Vector)>;

const OFFSET: f64 = 8e-3;
const RADIUS: f64 = 1e-3;
const NODES: usize = 7;

/// A robot bent to and fro, its links of no particular length.
fn points() -> Points {
    let some = |i: usize, by: f64| libm::sin(by * i as f64 + 0.4);
    (0..NODES)
        .map(|i| {
            let angle = 0.25 * some(i, 1.3);
            let at = Vector::new(2e-3 * some(i, 0.9), 10e-3 * i as f64);
            (
                at,
                at + OFFSET * Vector::new(libm::cos(angle), libm::sin(angle)),
            )
        })
        .collect()
}

fn ends(points: &Points, candidate: &Candidate) -> (Vector, Vector) {
    let at = |i: usize, lever: f64| {
        let (backbone, cable) = points[i];
        backbone + lever / OFFSET * (cable - backbone)
    };
    let i = candidate.node;
    match candidate.element {
        Element::Point { lever } | Element::OnLink { lever, .. } => (at(i, lever), at(i, lever)),
        Element::Link { lever } => (at(i - 1, lever), at(i, lever)),
        Element::Across { lever } => (at(i, -lever), at(i, lever)),
    }
}

/// A point, a link and a disk, each on a post of its own.
fn pressed() -> (Problem, Vec<Contact>) {
    let base = PlanarNode {
        position: Vector::zeros(),
        disk: Vector::x(),
        angle: 0.0,
    };
    let robot = Robot {
        length: 0.06,
        segments: NODES - 1,
        segments_per_bay: 1,
        offset: OFFSET,
        sizes: Sizes {
            rim: OFFSET,
            disk: 0.0,
            backbone: 0.0,
            cable: 0.0,
        },
        base,
    };
    let candidate = |node, element| Candidate {
        line: Line::Cable,
        node,
        element,
        radius: 5e-4,
        joins: Joins::Nothing,
        span: 1,
        cable: 0,
    };
    let candidates = vec![
        candidate(
            2,
            Element::Point {
                lever: 1.2 * OFFSET,
            },
        ),
        candidate(4, Element::Link { lever: OFFSET }),
        candidate(
            5,
            Element::Across {
                lever: 1.5 * OFFSET,
            },
        ),
        candidate(
            1,
            Element::Link {
                lever: -0.5 * OFFSET,
            },
        ),
    ];
    let points = points();
    let mut posts = Vec::new();
    let mut contacts = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let (start, end) = ends(&points, candidate);
        let along = 0.3;
        let (normal, vertex) = if start == end {
            (Vector::new(-0.8, 0.6), None)
        } else {
            (perpendicular(end - start).normalize(), Some(0))
        };
        let point = start + along * (end - start);
        let center = point - (RADIUS + candidate.radius) * normal;
        posts.push(Obstacle::new(Core::Point, RADIUS, center, 0.0));
        contacts.push(Contact {
            candidate: index,
            line: candidate.line,
            cable: 0,
            node: candidate.node,
            obstacle: index,
            vertex,
            along,
            point: point - candidate.radius * normal,
            normal,
            clearance: 0.0,
            multiplier: 20.0 + index as f64,
            friction: 0.0,
            slid: 0.0,
            class: Class::Pressing,
        });
    }
    (
        Problem::from_parts(robot, 1e-3, candidates, posts),
        contacts,
    )
}

/// Multipliers of a node's links: backbone, cable, disk.
type Links = [f64; 3];

/// J − Σ λ g − Σ μ |link|, from its definition.
fn lagrangian(
    problem: &Problem,
    points: &Points,
    contacts: &[Contact],
    links: &[Links; NODES],
) -> f64 {
    let angle = |i: usize| {
        let disk = points[i].1 - points[i].0;
        libm::atan2(disk.y, disk.x)
    };
    let mut sum = 0.0;
    for i in 1..NODES {
        let bend = angle(i - 1) - angle(i);
        sum += bend * bend;
        let lengths = [
            points[i].0 - points[i - 1].0,
            points[i].1 - points[i - 1].1,
            points[i].1 - points[i].0,
        ];
        for (length, multiplier) in lengths.iter().zip(links[i]) {
            sum -= multiplier * length.norm();
        }
    }
    for contact in contacts {
        let (start, end) = ends(points, &problem.candidates()[contact.candidate]);
        let center = problem.obstacles()[contact.obstacle].position();
        let distance = if start == end {
            (start - center).norm()
        } else {
            cross(end - start, center - start).abs() / (end - start).norm()
        };
        sum -= contact.multiplier * distance;
    }
    sum
}

/// A certifier that has found forces and curvatures, with the multipliers of
/// the links read from what they balance.
fn certifier() -> (Certifier, Problem, Vec<Contact>, [Links; NODES]) {
    let (problem, contacts) = pressed();
    let mut certifier = Certifier::default();
    certifier.certify(&problem, points().into_iter(), &contacts);
    // Once more, without what holds the contacts.
    certifier.add_energy();
    certifier.add_contacts(&problem, &contacts);
    certifier.balance_links();
    let mut links = [[0.0; 3]; NODES];
    for (i, links) in links.iter_mut().enumerate().skip(1) {
        let unit = |v: Vector| v.normalize();
        let (b, k) = (
            unit(certifier.backbone[i] - certifier.backbone[i - 1]),
            unit(certifier.cable[i] - certifier.cable[i - 1]),
        );
        let w = unit(certifier.disk(i));
        let rates = matrix![
            b.x, 0.0, -w.x;
            b.y, 0.0, -w.y;
            0.0, k.x, w.x;
            0.0, k.y, w.y
        ];
        let normal = rates.transpose() * rates;
        let found = normal.try_inverse().unwrap() * rates.transpose() * certifier.balance[i];
        *links = found.into();
    }
    (certifier, problem, contacts, links)
}

fn moved(points: &Points, coordinate: usize, by: f64) -> Points {
    let mut points = points.clone();
    let (backbone, cable) = &mut points[coordinate / 4];
    match coordinate % 4 {
        0 => backbone.x += by,
        1 => backbone.y += by,
        2 => cable.x += by,
        _ => cable.y += by,
    }
    points
}

/// The Hessian of the certifier's blocks, dense.
fn dense(certifier: &Certifier) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(4 * NODES, 4 * NODES);
    for i in 0..NODES {
        all.view_mut((4 * i, 4 * i), (4, 4))
            .copy_from(&certifier.diagonal[i]);
        if i > 0 {
            let across = certifier.across[i];
            all.view_mut((4 * i - 4, 4 * i), (4, 4)).copy_from(&across);
            all.view_mut((4 * i, 4 * i - 4), (4, 4))
                .copy_from(&across.transpose());
        }
    }
    all
}

/// Second differences of step 1e-6 m err by 1e-15/1e-12 of rounding and by
/// 1e-12 of the fourth derivative, of order λ over the cube of the post's radius.
#[test]
fn every_term_of_the_hessian_against_differences() {
    let (certifier, problem, contacts, links) = certifier();
    let points = points();
    let found = dense(&certifier);
    let h = 1e-6;
    for a in 0..4 * NODES {
        for b in 0..=a {
            let at = |first: f64, second: f64| {
                let points = moved(&moved(&points, a, first), b, second);
                lagrangian(&problem, &points, &contacts, &links)
            };
            let difference = (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4.0 * h * h);
            let error = (difference - found[(a, b)]).abs();
            assert!(error < 0.05, "{a} {b}: {difference} {}", found[(a, b)]);
        }
    }
}

/// The forces that the links pass on, by first differences: what is left at a
/// node lies along its free direction, and is the stationarity residual.
#[test]
fn what_links_cannot_balance_lies_along_the_free_direction() {
    let (certifier, problem, contacts, links) = certifier();
    let points = points();
    let h = 1e-6;
    for i in 1..NODES {
        let mut left = Pair::zeros();
        for axis in 0..4 {
            let at = |by: f64| {
                let points = moved(&points, 4 * i + axis, by);
                lagrangian(&problem, &points, &contacts, &links)
            };
            left[axis] = (at(h) - at(-h)) / (2.0 * h);
        }
        let free = certifier.free[i];
        assert!((free.norm() - 1.0).abs() < 1e-12);
        let along = left.dot(&free);
        assert!((left - along * free).norm() < 1e-5, "{i}: {left}");
        assert!((along - certifier.balance[i].dot(&free)).abs() < 1e-5);
    }
}

/// The columns are motions along the links, one a node but the base.
fn motions(certifier: &Certifier) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(4 * NODES, NODES - 1);
    for first in 1..NODES {
        let mut motion = certifier.free[first];
        for i in first..NODES {
            if i > first {
                motion = certifier.carried[i] * motion;
            }
            all.view_mut((4 * i, first - 1), (4, 1)).copy_from(&motion);
        }
    }
    all
}

#[test]
fn free_motions_keep_every_length() {
    let (certifier, ..) = certifier();
    let motions = motions(&certifier);
    for column in motions.column_iter() {
        let at = |row: usize| Vector::new(column[row], column[row + 1]);
        for i in 1..NODES {
            let (backbone, cable) = (at(4 * i), at(4 * i + 2));
            let links = [
                (
                    certifier.backbone[i] - certifier.backbone[i - 1],
                    backbone - at(4 * i - 4),
                ),
                (
                    certifier.cable[i] - certifier.cable[i - 1],
                    cable - at(4 * i - 2),
                ),
                (certifier.disk(i), cable - backbone),
            ];
            for (link, rate) in links {
                assert!(link.dot(&rate).abs() < 1e-13, "{i}");
            }
        }
    }
}

/// Stiffened or softened as a whole, the Hessian along the links turns
/// positive where its least eigenvalue does.
#[test]
fn pivots_are_positive_where_eigenvalues_are() {
    let (mut certifier, ..) = certifier();
    let motions = motions(&certifier);
    let least = |all: &DMatrix<f64>| {
        let reduced = motions.transpose() * all * &motions;
        SymmetricEigen::new(reduced).eigenvalues.min()
    };
    let hessian = dense(&certifier);
    let identity = DMatrix::identity(4 * NODES, 4 * NODES);
    let (mut low, mut high) = (-1e7, 1e7);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if least(&(&hessian + middle * &identity)) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    let original = certifier.diagonal.clone();
    for (by, positive) in [(1.0, true), (-1.0, false), (1e5, true), (-1e5, false)] {
        certifier.diagonal.clone_from(&original);
        for block in &mut certifier.diagonal {
            *block += (high + by) * Block::identity();
        }
        assert_eq!(certifier.pivots_positive(), positive, "{high} {by}");
    }
}

/// Curvature that is negative along the contacts' gradients alone is what
/// pressing contacts hold.
#[test]
fn pressing_contacts_hold_what_they_can() {
    let (mut certifier, problem, ..) = certifier();
    let softened = |certifier: &mut Certifier, pressing: &[(usize, Gradient)], by: f64| {
        for (i, gradient) in pressing {
            let Gradient { after, before } = gradient;
            certifier.diagonal[*i] -= by * after * after.transpose();
            certifier.diagonal[i - 1] -= by * before * before.transpose();
            certifier.across[*i] -= by * before * after.transpose();
        }
    };
    // Positive to begin with, by far.
    for block in &mut certifier.diagonal {
        *block += 1e7 * Block::identity();
    }
    assert!(certifier.is_minimum(&problem));
    let all = certifier.pressing.clone();
    for held in 0..all.len() {
        let original = certifier.clone();
        certifier.pressing = vec![all[held]];
        softened(&mut certifier, &[all[held]], 1e10);
        assert!(!certifier.pivots_positive());
        assert!(certifier.clone().is_minimum(&problem), "{held}");
        // Another contact does not hold it.
        certifier.pressing = vec![all[(held + 1) % all.len()]];
        assert!(!certifier.clone().is_minimum(&problem), "{held}");
        certifier.pressing.clear();
        assert!(!certifier.is_minimum(&problem));
        certifier = original;
    }
}
