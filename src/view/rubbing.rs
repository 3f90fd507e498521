//! Friction at contacts as marks: the cone that the obstacle's force on the robot cannot
//! leave, and the part of that force along the surface. Of cables in their holes nothing
//! is drawn here.

use super::drawing::{Geometry, Label, LabelText, Mark, Role, Spot};
use super::force_scale::ForceScale;
use super::path::{Path, Piece};
use crate::contact::Contact;
use crate::equilibrium::Solution;
use crate::geometry::Vector;
use crate::mechanics::Slip;

/// Friction below this share of the scale has no number: it is next to nothing.
const LABELLED: f64 = 0.01;

/// What presses where contacts rub.
fn rubbing(solution: &Solution) -> impl Iterator<Item = &Contact> {
    let rubs = solution.drive.friction.contacts > 0.0;
    solution.pressing().filter(move |_| rubs)
}

/// The cones: as long as their arrows, atan μ to either side of the normal.
pub(super) fn cones(solution: &Solution, scale: ForceScale) -> impl Iterator<Item = Mark> {
    let half = libm::atan(solution.drive.friction.contacts);
    let (sine, cosine) = libm::sincos(half);
    rubbing(solution).map(move |contact| {
        let share = scale.of(contact);
        let apex = contact.point;
        let long = scale.arrow(share);
        let edge = |side: f64| {
            let way = cosine * contact.normal + side * sine * contact.tangent();
            apex + long * way
        };
        let arc = Piece::Arc {
            centre: apex,
            to: edge(-1.0),
            // From the clockwise edge to the other.
            sweep: 2.0 * half,
        };
        let pieces = vec![Piece::Line { to: edge(1.0) }, arc];
        Mark {
            role: Role::Cone {
                share,
                slides: Slip::of(contact.slid) != Slip::Sticks,
            },
            geometry: Geometry::Path(Path {
                start: apex,
                pieces,
                closed: true,
            }),
            thickness: 0.0,
        }
    })
}

/// The obstacle's friction on the robot, from where they touch, and its end and way.
fn friction(contact: &Contact, scale: ForceScale) -> (f64, Vector, Vector) {
    let share = scale.share(contact.friction.abs());
    let way = contact.friction.signum() * contact.tangent();
    (share, contact.point + scale.arrow(share) * way, way)
}

/// The arrows of friction.
pub(super) fn arrows(solution: &Solution, scale: ForceScale) -> impl Iterator<Item = Mark> {
    let acting = rubbing(solution).filter(|contact| contact.friction != 0.0);
    acting.map(move |contact| {
        let (share, tip, _) = friction(contact, scale);
        let tail = contact.point;
        Mark {
            role: Role::Friction(share),
            geometry: Geometry::Arrow { tail, tip },
            thickness: 0.0,
        }
    })
}

/// Their numbers, the greatest first, at most so many.
pub(super) fn labels(solution: &Solution, scale: ForceScale, most: usize) -> Vec<Label> {
    let mut acting: Vec<&Contact> = rubbing(solution)
        .filter(|contact| scale.share(contact.friction.abs()) >= LABELLED)
        .collect();
    acting.sort_by(|a, b| b.friction.abs().total_cmp(&a.friction.abs()));
    let told = acting.into_iter().take(most).map(|contact| {
        let (_, point, towards) = friction(contact, scale);
        Label {
            text: LabelText::Value(scale.written(contact.friction.abs())),
            spot: Spot::Beyond { point, towards },
        }
    });
    told.collect()
}
