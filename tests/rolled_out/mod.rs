//! The solver's point of a chain, rolled out from its controls.

use sinew::solver::{Chain, Control, Point};

/// The point at these controls, with its rows and derivatives.
pub fn at<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    controls: &[Control<NU>],
) -> Point<C, NX, NU> {
    let mut point = Point {
        controls: controls.to_vec(),
        ..Point::default()
    };
    point.evaluate(chain);
    point
}
