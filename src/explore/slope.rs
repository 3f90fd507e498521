//! Which pull a load on the cable amounts to: the load holds the shape whose
//! energy rises with the pull as steeply as the load pulls, T = (EI/2l_0) dJ/dl.

use super::path::Path;

impl Path {
    /// The pull, in metres, at which dJ/dl first comes to `slope`, in rad²/m: the
    /// shape that a robot takes whose load grows slowly from nothing. Straight
    /// between the path's states; where the robot jumps to a shape that needs
    /// more, the pull of the jump. `None` where no state needs as much.
    pub fn pull_at_slope(&self, slope: f64) -> Option<f64> {
        let after = self.states.iter().position(|it| it.energy_slope >= slope)?;
        let b = &self.states[after];
        let before = after.checked_sub(1).map(|index| &self.states[index]);
        let Some(a) = before.filter(|a| a.branch == b.branch) else {
            return Some(b.pull);
        };
        let share = (slope - a.energy_slope) / (b.energy_slope - a.energy_slope);
        Some(a.pull + share * (b.pull - a.pull))
    }

    /// The steepest dJ/dl of all states, in rad²/m, and 0 where none rises.
    pub fn greatest_slope(&self) -> f64 {
        let slopes = self.states.iter().map(|state| state.energy_slope);
        slopes.fold(0.0, f64::max)
    }
}
