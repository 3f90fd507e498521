//! The solver's point of a planar robot, from its turns.

use sinew::mechanics::Problem;
use sinew::solver::{Control, Point};

/// The solver's point of the planar robot.
pub type Planar = Point<Problem, 3, 1>;

/// The point at these turns, with its rows and derivatives.
pub fn at(problem: &Problem, controls: &[Control<1>]) -> Planar {
    let mut point = Planar {
        controls: controls.to_vec(),
        ..Planar::default()
    };
    point.evaluate(problem);
    point
}
