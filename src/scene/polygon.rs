//! Whether a list of points bounds a convex polygon. Makes no shape of it.

use super::limits::{LEAST_VERTICES, VERTEX_SPACING_MM};

/// Why a list of points bounds no convex polygon; vertices count from 0.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PolygonFault {
    /// One or two points, or none.
    #[error("has {count} of the at least 3 vertices a polygon needs; add some")]
    TooFewVertices {
        /// How many there are.
        count: usize,
    },
    /// Two vertices in one place.
    #[error(
        "has its vertices {first} and {second} in one place; remove one, or move them at least {VERTEX_SPACING_MM} mm apart"
    )]
    RepeatedVertex {
        /// The first of the two.
        first: usize,
        /// The second of the two.
        second: usize,
    },
    /// All vertices on one line.
    #[error(
        "has all its vertices on one line, so it encloses nothing; move one aside, or use a capsule"
    )]
    NoArea,
    /// A vertex where the outline turns inward or back.
    #[error(
        "is not convex at vertex {vertex}; remove that vertex, or split the shape into convex obstacles"
    )]
    NotConvex {
        /// That vertex.
        vertex: usize,
    },
    /// An outline that goes round more than once, like a five-pointed star's.
    #[error("crosses itself before vertex {vertex}; list the vertices in order once around")]
    CrossesItself {
        /// The vertex by which it has gone round once.
        vertex: usize,
    },
}

/// The angle, rad, within which a vertex counts as straight. Decimal
/// coordinates of a straight edge are off by about 1e-16 of their size, 1e-10
/// for a 1 mm edge a million millimetres out.
const STRAIGHT: f64 = 1e-9;

/// More than once round, rad: an outline that crosses itself goes round twice,
/// and the rounding of all its turns is far below this.
const MORE_THAN_ONCE: f64 = std::f64::consts::TAU + 1e-6;

/// The first fault of the points as a convex polygon, either way round.
///
/// The points must be finite. Vertices in the middle of a straight edge are
/// accepted. Takes time quadratic in the number of points.
pub(super) fn fault(points: &[[f64; 2]]) -> Option<PolygonFault> {
    let count = points.len();
    if count < LEAST_VERTICES {
        return Some(PolygonFault::TooFewVertices { count });
    }
    for second in 1..count {
        for first in 0..second {
            let [x, y] = edge(points[first], points[second]);
            if libm::hypot(x, y) < VERTEX_SPACING_MM {
                return Some(PolygonFault::RepeatedVertex { first, second });
            }
        }
    }
    if all_on_one_line(points) {
        return Some(PolygonFault::NoArea);
    }

    // A closed outline is convex when it turns one way at every vertex and
    // goes round once; its total turn is always a multiple of a full turn.
    let turns: Vec<f64> = (0..count)
        .map(|i| {
            turn(
                points[(i + count - 1) % count],
                points[i],
                points[(i + 1) % count],
            )
        })
        .collect();
    let way = turns.iter().sum::<f64>().signum();
    let mut turned = 0.0;
    for (vertex, turn) in turns.iter().map(|turn| way * turn).enumerate() {
        if !(-STRAIGHT..=std::f64::consts::PI - STRAIGHT).contains(&turn) {
            return Some(PolygonFault::NotConvex { vertex });
        }
        turned += turn;
        if turned > MORE_THAN_ONCE {
            return Some(PolygonFault::CrossesItself { vertex });
        }
    }
    None
}

/// Whether every point lies on the line from the first to the one farthest
/// from it, to within [`STRAIGHT`] of that distance.
fn all_on_one_line(points: &[[f64; 2]]) -> bool {
    let from_first = |p: &[f64; 2]| edge(points[0], *p);
    let longest = points
        .iter()
        .map(from_first)
        .max_by(|a, b| libm::hypot(a[0], a[1]).total_cmp(&libm::hypot(b[0], b[1])));
    let Some(axis) = longest else { return true };
    let square = axis[0] * axis[0] + axis[1] * axis[1];
    points
        .iter()
        .map(from_first)
        .all(|p| cross(axis, p).abs() <= STRAIGHT * square)
}

/// The angle from edge `before`–`at` to edge `at`–`after`, rad, in (−π, π].
fn turn(before: [f64; 2], at: [f64; 2], after: [f64; 2]) -> f64 {
    let (a, b) = (edge(before, at), edge(at, after));
    libm::atan2(cross(a, b), a[0] * b[0] + a[1] * b[1])
}

fn edge(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::PolygonFault::*;
    use super::*;

    #[track_caller]
    fn check(points: &[[f64; 2]], expected: Option<PolygonFault>) {
        assert_eq!(fault(points), expected, "{points:?}");
    }

    #[test]
    fn convex_polygons_pass_either_way_round_and_anywhere() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let with_straight_vertex = [[0.0, 0.0], [0.1, 0.1], [0.3, 0.3], [0.0, 0.3]];
        let round: Vec<[f64; 2]> = (0..64)
            .map(|i| f64::from(i) / 64.0 * std::f64::consts::TAU)
            .map(|t| [libm::cos(t), libm::sin(t)])
            .collect();
        for shape in [&square[..], &with_straight_vertex, &round] {
            for shift in [0.0, -1000.0, 999_990.0] {
                let mut points: Vec<_> = shape
                    .iter()
                    .map(|p| [p[0] * 10.0 + shift, p[1] * 10.0])
                    .collect();
                check(&points, None);
                points.reverse();
                check(&points, None);
            }
        }
    }

    #[test]
    fn each_fault_is_told_from_the_others() {
        check(&[], Some(TooFewVertices { count: 0 }));
        check(&[[0.0, 0.0], [1.0, 0.0]], Some(TooFewVertices { count: 2 }));
        check(
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0005]],
            Some(RepeatedVertex {
                first: 1,
                second: 3,
            }),
        );
        check(&[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]], Some(NoArea));
        check(
            &[[1e5, 1e5], [1.1e5, 1.1e5], [1.3e5, 1.3e5], [2e5, 2e5]],
            Some(NoArea),
        );
        check(
            &[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]],
            Some(NotConvex { vertex: 2 }),
        );
        // Clockwise, so the inward vertex turns left.
        check(
            &[[0.0, 4.0], [1.0, 1.0], [4.0, 0.0], [0.0, 0.0]],
            Some(NotConvex { vertex: 1 }),
        );
        // A spike out of a triangle's corner and back.
        check(
            &[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [3.0, 0.0], [0.0, 4.0]],
            Some(NotConvex { vertex: 2 }),
        );
    }

    #[test]
    fn outlines_that_cross_themselves_are_refused() {
        let star: Vec<[f64; 2]> = (0..5)
            .map(|i| f64::from(i) * 0.8 * std::f64::consts::PI)
            .map(|t| [libm::cos(t), libm::sin(t)])
            .collect();
        assert!(matches!(fault(&star), Some(CrossesItself { .. })));
        let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(matches!(fault(&bow_tie), Some(NotConvex { .. })));
    }
}
