//! Obstacles and motions where what happens when, or which feature is nearest,
//! can be told by hand.

use sinew::geometry::{Core, Edge, Obstacle, Vector};

fn v(x: f64, y: f64) -> Vector {
    Vector::new(x, y)
}

/// Whether an edge from (a, height) to (b, height) that sinks through the
/// origin, from a height of `above` to one of −`below`, while it goes `aside`,
/// sweeps over a needle there.
fn sweeps(ends: [f64; 2], [above, below]: [f64; 2], aside: f64) -> bool {
    let needle = Obstacle::new(Core::Point, 1e-6, Vector::zeros(), 0.0);
    let motion = |x: f64| (v(x, above), v(x + aside, -below));
    let ends = (motion(ends[0]), motion(ends[1]));
    let turned = (ends.1, ends.0);
    let found = needle.edge_passes(&needle, ends, 1e-9, 1.0);
    assert_eq!(found, needle.edge_passes(&needle, turned, 1e-9, 1.0));
    found
}

/// Where the edge is when it passes the point's height decides, and neither
/// where it starts nor where it ends.
#[test]
fn an_edge_sweeps_over_what_it_covers_when_it_gets_there() {
    // A quarter of the way down and aside: the edge is at 0.02 to 0.04 then.
    assert!(!sweeps([-0.01, 0.01], [0.01, 0.03], 0.12));
    assert!(sweeps([-0.04, -0.02], [0.01, 0.03], 0.12));
    assert!(!sweeps([-0.10, -0.08], [0.01, 0.03], 0.12));
    // Three quarters of the way.
    assert!(sweeps([-0.10, -0.08], [0.03, 0.01], 0.12));
    assert!(!sweeps([-0.04, -0.02], [0.03, 0.01], 0.12));
    // Not down to it, and within the tolerance of it at the end.
    assert!(!sweeps([-0.01, 0.01], [0.03, -0.01], 0.0));
    assert!(!sweeps([-0.01, 0.01], [0.03, 1e-10], 0.0));
    assert!(sweeps([-0.01, 0.01], [0.03, 1e-8], 0.0));
}

#[test]
fn a_bar_that_an_edge_sweeps_over_is_swept_at_either_end() {
    let bar = Obstacle::new(Core::segment(0.04), 1e-3, v(0.1, 0.1), 0.0);
    let sinking = |x: f64| (v(x, 0.11), v(x, 0.09));
    for (from, to, over) in [
        (0.07, 0.09, true),
        (0.11, 0.13, true),
        (0.085, 0.115, false),
        (0.13, 0.15, false),
    ] {
        let ends = (sinking(from), sinking(to));
        assert_eq!(bar.edge_passes(&bar, ends, 1e-9, 1.0), over, "{from} {to}");
    }
}

fn shapes() -> Vec<Obstacle> {
    let five = Core::polygon(&[
        v(-0.02, -0.015),
        v(0.025, -0.01),
        v(0.027, 0.004),
        v(0.015, 0.02),
        v(-0.01, 0.022),
    ]);
    let blade = Core::polygon(&[v(-0.03, 0.0), v(0.03, -0.002), v(0.03, 0.002)]);
    let at = v(0.3, -0.2);
    vec![
        Obstacle::new(Core::Point, 0.012, at, 0.0),
        Obstacle::new(Core::segment(0.05), 0.004, at, 1.1),
        Obstacle::new(Core::rectangle(0.04, 0.02), 0.0, at, 0.4),
        Obstacle::new(Core::rectangle(0.04, 0.02), 0.005, at, -0.7),
        Obstacle::new(five.unwrap(), 0.002, at, 2.3),
        Obstacle::new(blade.unwrap(), 0.0, at, -2.0),
    ]
}

/// Numbers between −1 and 1, the same on every run.
fn numbers(seed: usize) -> impl Iterator<Item = f64> {
    (0..).map(move |k| {
        let x = (12.9898 * k as f64 + 78.233 * seed as f64).sin() * 43758.5453;
        2.0 * (x - x.floor()) - 1.0
    })
}

/// The core's vertices in the world, counterclockwise.
fn outline(obstacle: &Obstacle) -> Vec<Vector> {
    let (sine, cosine) = obstacle.angle().sin_cos();
    let world =
        |p: &Vector| obstacle.position() + v(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y);
    match obstacle.core() {
        Core::Vertices(vertices) => vertices.iter().map(world).collect(),
        _ => vec![obstacle.position()],
    }
}

/// The signed distance by its definition.
fn distance(obstacle: &Obstacle, point: Vector) -> f64 {
    let vertices = outline(obstacle);
    let mut nearest = f64::INFINITY;
    let mut inside = vertices.len() > 2;
    for (i, a) in vertices.iter().enumerate() {
        let b = vertices[(i + 1) % vertices.len()];
        let edge = b - a;
        let share = edge.dot(&(point - a)) / edge.norm_squared().max(1e-300);
        nearest = nearest.min((a + share.clamp(0.0, 1.0) * edge - point).norm());
        inside &= edge.x * (point.y - a.y) - edge.y * (point.x - a.x) > 0.0;
    }
    let to_core = if inside { -nearest } else { nearest };
    to_core - obstacle.radius()
}

#[test]
fn points_are_as_far_as_the_outline_says() {
    for (seed, obstacle) in shapes().iter().enumerate() {
        let mut numbers = numbers(seed);
        for _ in 0..500 {
            let mut next = || 0.06 * numbers.next().unwrap();
            let point = obstacle.position() + v(next(), next());
            let expected = distance(obstacle, point);
            let found = obstacle.clearance(point);
            assert!(
                (found.distance - expected).abs() < 1e-15,
                "{obstacle:?} {point:?}"
            );
            assert!((found.normal.norm() - 1.0).abs() < 1e-12);
            let nearer = distance(obstacle, point + 1e-7 * found.normal) - expected;
            assert!(
                (nearer - 1e-7).abs() < 1e-9,
                "{obstacle:?} {point:?} {nearer}"
            );
            for margin in [0.0, 0.01, 0.03, -0.001] {
                if obstacle.is_beyond(point, margin) {
                    assert!(expected > margin);
                }
            }
            let far = point + 0.2 * (point - obstacle.position()).normalize();
            assert!(obstacle.is_beyond(far, 0.1) && !obstacle.is_beyond(far, 0.3));
        }
    }
}

#[test]
fn a_walls_distance_is_along_its_normal() {
    let wall = Obstacle::new(Core::HalfPlane, 0.01, v(0.3, 0.1), 0.5);
    let normal = v(0.5_f64.cos(), 0.5_f64.sin());
    for height in [-0.3, 0.0, 0.02, 0.5] {
        let point = v(0.3, 0.1) + height * normal + 0.7 * v(-normal.y, normal.x);
        let found = wall.clearance(point);
        assert!((found.distance - (height - 0.01)).abs() < 1e-15);
        assert!((found.normal - normal).norm() < 1e-15 && found.curvature == 0.0);
        for margin in [-0.05, 0.0, 0.1] {
            let beyond = height - 0.01 > margin;
            assert_eq!(wall.is_beyond(point, margin), beyond, "{height} {margin}");
        }
    }
    let support = wall.support(normal).unwrap();
    assert!((support - normal.dot(&v(0.3, 0.1)) - 0.01).abs() < 1e-15);
    assert_eq!(wall.support(-normal), None);
}

/// The least distance along an edge is at one of its ends or is the row of its
/// inside; where it crosses the core it is told to, by the shortest way out.
#[test]
fn edges_are_as_far_as_their_nearest_point() {
    let (mut insides, mut crossings) = (0, 0);
    for (seed, obstacle) in shapes().iter().enumerate() {
        let mut numbers = numbers(seed + 10);
        let vertices = outline(obstacle);
        for _ in 0..400 {
            let mut next = || 0.05 * numbers.next().unwrap();
            let start = obstacle.position() + v(next(), next());
            let end = start + v(next(), next());
            // The distance is convex along the edge.
            let along = |t: f64| distance(obstacle, start + t * (end - start)) + obstacle.radius();
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let (a, b) = ((2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0);
                if along(a) < along(b) {
                    high = b
                } else {
                    low = a
                }
            }
            let least = along(0.5 * (low + high)).min(along(0.0)).min(along(1.0));
            let depth = obstacle.crossing_depth(start, end);
            let mut rows = f64::INFINITY;
            obstacle.edge_clearances(&Edge::alone(start, end), |row| {
                rows = rows.min(row.distance + obstacle.radius());
                let vertex = vertices[row.vertex];
                let foot = start + row.along * (end - start);
                assert!(depth.is_some() || (0.0..=1.0).contains(&row.along));
                assert!((row.normal.norm() - 1.0).abs() < 1e-12);
                assert!(row.normal.dot(&(end - start)).abs() < 1e-15);
                let distance = row.normal.dot(&(foot - vertex)) - obstacle.radius();
                assert!((row.distance - distance).abs() < 1e-14);
            });
            let told = obstacle.edge_distance(start, end) + obstacle.radius();
            if least > 1e-6 {
                assert!((told - least).abs() < 1e-7, "{obstacle:?} {told} {least}");
                let found = rows.min(along(0.0)).min(along(1.0));
                assert!(
                    (found - least).abs() < 1e-7,
                    "{obstacle:?} {start:?} {end:?}: {found} {least}"
                );
                assert_eq!(depth, None);
                insides += usize::from(rows < along(0.0).min(along(1.0)) - 1e-6);
            } else if least < -1e-6 {
                crossings += 1;
                assert_eq!(told, obstacle.radius() - depth.unwrap());
                // A row tells of it, or the point in which the edge ends.
                assert!(rows.min(along(0.0)).min(along(1.0)) < 0.0);
                // By the direction in which it overlaps least.
                let overlaps = (0..720).map(|k| {
                    let (sine, cosine) = (0.5 * f64::from(k)).to_radians().sin_cos();
                    let out = v(cosine, sine);
                    obstacle.support(out).unwrap() - out.dot(&start).min(out.dot(&end))
                });
                let over = overlaps.fold(f64::INFINITY, f64::min) - depth.unwrap();
                assert!((-1e-12..4e-4).contains(&over), "{obstacle:?} {over}");
            }
        }
    }
    assert!(insides > 50 && crossings > 130, "{insides} {crossings}");
}

/// Both sides go through a corner that is beyond an end of the edge, or through
/// a bar whose corners all are.
#[test]
fn an_edge_that_crosses_beside_every_corner_has_a_row() {
    let check = |obstacle: &Obstacle, (start, end): (Vector, Vector), depth: f64| {
        let mut rows = Vec::new();
        obstacle.edge_clearances(&Edge::alone(start, end), |row| rows.push(row));
        let mut beyond = rows.iter().filter(|row| !(0.0..=1.0).contains(&row.along));
        let row = beyond.next().unwrap();
        assert!((row.distance + depth).abs() < 1e-12, "{rows:?}");
        assert!(beyond.next().is_none(), "{rows:?}");
    };
    let eighth = std::f64::consts::FRAC_PI_4;
    let bar = Obstacle::new(Core::rectangle(0.1, 0.004), 0.0, v(0.0, 0.0), eighth);
    let link = (v(0.01, 0.0), v(0.01, 0.02));
    check(&bar, link, 0.052 * eighth.cos() - 0.01);
    let wedge = Core::polygon(&[v(0.0, 0.0), v(0.03, -0.011), v(0.03, 0.011)]);
    let wedge = Obstacle::new(wedge.unwrap(), 0.0, v(0.0, 0.0), 0.0);
    let downward = v(3.0_f64.sqrt(), -1.0) * 0.01;
    let start = v(0.002, 0.001);
    let depth = 0.5 * start.x + 0.75_f64.sqrt() * start.y;
    check(&wedge, (start, start + downward), depth);
}

/// Halfway between two places everything is halfway; a change bounds how far
/// any part of the outline goes, and is no more than its parts.
#[test]
fn obstacles_move_evenly_and_no_farther_than_they_change() {
    let directions = || {
        (0..24)
            .map(|k| (15.0 * f64::from(k)).to_radians())
            .map(|a| v(a.cos(), a.sin()))
    };
    for obstacle in shapes() {
        let moved = obstacle.moved(v(0.03, -0.04));
        assert!((obstacle.change(&moved) - 0.05).abs() < 1e-15);
        let mut between = obstacle.clone();
        for share in [0.0, 0.25, 1.0] {
            between.set_between(&obstacle, &moved, share);
            assert!(
                (between.position() - obstacle.position() - share * v(0.03, -0.04)).norm() < 1e-15
            );
            for direction in directions() {
                let expected =
                    obstacle.support(direction).unwrap() + share * direction.dot(&v(0.03, -0.04));
                assert!((between.support(direction).unwrap() - expected).abs() < 1e-15);
            }
            assert_eq!(between.angle(), obstacle.angle());
        }
        let half = obstacle.shrunk(v(0.1, 0.1), 0.5);
        assert!((half.radius() - 0.5 * obstacle.radius()).abs() < 1e-17);
        let farther =
            |d: &Vector| (obstacle.support(*d).unwrap() - half.support(*d).unwrap()).abs();
        let most = directions().map(|d| farther(&d)).fold(0.0, f64::max);
        assert!(obstacle.change(&half) >= most);
    }
    let bar = |angle, radius| Obstacle::new(Core::segment(0.1), radius, v(0.2, 0.1), angle);
    let (a, b) = (bar(3.0, 0.01), bar(-3.0, 0.03));
    let turn = std::f64::consts::TAU - 6.0;
    assert!((a.change(&b) - (0.02 + 0.08 * turn)).abs() < 1e-12);
    let mut between = a.clone();
    between.set_between(&a, &b, 0.5);
    assert!((between.angle() - std::f64::consts::PI).abs() < 1e-12);
    assert!((between.radius() - 0.02).abs() < 1e-15);
}

/// How far a point's normal turns where its way dips into a disc, by hand: in
/// at (−0.6, 0.8) of the radius and out at (0.6, 0.8).
#[test]
fn a_way_that_dips_turns_the_normal_by_as_much() {
    let at = v(0.1, 0.2);
    let disc = Obstacle::new(Core::Point, 0.01, at, 0.3);
    let dips = |from: Vector, to: Vector, radius: f64, limits: (f64, f64)| {
        disc.point_dips(&disc, (at + from, at + to), radius, limits)
    };
    let limits = (1e-3, 0.05);
    let (left, right) = (v(-0.006, 0.008), v(0.006, 0.008));
    let turned = dips(left, right, 0.0, limits).unwrap();
    assert!((turned - (0.64 - 0.36)).abs() < 1e-12);
    // A thicker point is in it from farther away.
    let above = v(0.0, 0.003);
    assert_eq!(dips(left + above, right + above, 0.0, limits), None);
    assert!(dips(left + above, right + above, 0.002, limits).is_some());
    // Away from it only, towards it only, too short, too far.
    assert_eq!(dips(right, right + v(0.01, 0.0), 0.0, limits), None);
    assert_eq!(dips(left - v(0.01, 0.0), left, 0.0, limits), None);
    assert_eq!(dips(left, right, 0.0, (0.0121, 0.05)), None);
    assert!(dips(left, right, 0.0, (0.0119, 0.05)).is_some());
    let far = v(0.0, 0.05);
    assert_eq!(dips(left + far, right + far, 0.0, (1e-3, 0.02)), None);
    // Moved along with the point, it is not met.
    let later = disc.moved(right - left);
    assert_eq!(
        disc.point_dips(&later, (at + left, at + right), 0.0, limits),
        None
    );
    // Moved against a point at rest, it is.
    let rest = (at + left, at + left);
    let towards = disc.moved(left - right);
    let turned = disc.point_dips(&towards, rest, 0.0, limits).unwrap();
    assert!((turned - 0.28).abs() < 1e-12);
}

/// What is written of an obstacle makes the same one; a core of too few
/// vertices is refused.
#[test]
fn obstacles_come_back_as_they_were_written() {
    for obstacle in shapes() {
        let text = serde_json::to_string(&obstacle).unwrap();
        let again: Obstacle = serde_json::from_str(&text).unwrap();
        assert!(again.change(&obstacle) < 1e-15 && again.resembles(&obstacle));
        let point = obstacle.position() + v(0.031, 0.017);
        assert_eq!(again.clearance(point), obstacle.clearance(point));
    }
    let bar = Obstacle::new(Core::segment(0.04), 1e-3, v(0.1, 0.1), 0.0);
    let mut parts = serde_json::to_value(&bar).unwrap();
    let vertices = parts["core"]["Vertices"].as_array_mut().unwrap();
    vertices.pop();
    let refused = serde_json::from_value::<Obstacle>(parts).unwrap_err();
    assert!(refused.to_string().contains("too few or too many vertices"));
}
