//! Anderson's acceleration of a fixed-point iteration x ← G(x).
//!
//! Of the last few residuals G(x) − x it takes the combination that is least, and goes
//! on from the same combination of the G(x): on a linear map that is as good as GMRES,
//! so that a few slow modes do not decide how many passes it takes. Anderson (1965);
//! Walker and Ni (2011), with the differences orthogonalised from the newest on.

/// How many passes are remembered.
const DEPTH: usize = 6;
/// A difference of residuals that depends on newer ones but for this share of its length
/// says nothing.
const DEPENDENT: f64 = 1e-8;

/// A pass: x and G(x) − x.
#[derive(Clone, Debug, Default)]
struct Pass {
    argument: Vec<f64>,
    residual: Vec<f64>,
}

/// The passes of an iteration so far.
#[derive(Clone, Debug, Default)]
pub struct Anderson {
    /// The newest last.
    passes: Vec<Pass>,
}

impl Anderson {
    /// Forgets all passes, as where the map has changed.
    pub fn reset(&mut self) {
        self.passes.clear();
    }

    /// Takes the pass that led from `argument` to `value`, and makes `value` the
    /// argument of the next. One of another length than those before begins anew.
    pub fn improve(&mut self, argument: &[f64], value: &mut [f64]) {
        if self
            .passes
            .first()
            .is_some_and(|pass| pass.argument.len() != argument.len())
        {
            self.reset();
        }
        if self.passes.len() == DEPTH {
            self.passes.remove(0);
        }
        let residual: Vec<f64> = value.iter().zip(argument).map(|(g, x)| g - x).collect();
        let mut left = residual.clone();
        // Each difference to the pass before it, orthogonalised: of residuals with, by
        // the same steps, that of the values.
        let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::with_capacity(DEPTH);
        let newest = Pass {
            argument: argument.to_vec(),
            residual,
        };
        let mut later = &newest;
        for earlier in self.passes.iter().rev() {
            let mut change: Vec<f64> = difference(&later.residual, &earlier.residual);
            let moved = difference(&later.argument, &earlier.argument);
            let mut along: Vec<f64> = change.iter().zip(&moved).map(|(f, x)| f + x).collect();
            later = earlier;
            let length = dot(&change, &change);
            for (direction, values) in &basis {
                let share = dot(direction, &change);
                subtract(&mut change, share, direction);
                subtract(&mut along, share, values);
            }
            let rest = dot(&change, &change);
            if rest <= DEPENDENT * DEPENDENT * length || rest == 0.0 {
                continue;
            }
            let scale = 1.0 / libm::sqrt(rest);
            change
                .iter_mut()
                .chain(&mut along)
                .for_each(|entry| *entry *= scale);
            basis.push((change, along));
        }
        for (direction, values) in &basis {
            let share = dot(direction, &left);
            subtract(&mut left, share, direction);
            subtract(value, share, values);
        }
        self.passes.push(newest);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn subtract(from: &mut [f64], share: f64, what: &[f64]) {
    for (entry, what) in from.iter_mut().zip(what) {
        *entry -= share * what;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear map of three modes, one of them slow: plain passes gain a hundredth each.
    #[test]
    fn a_linear_map_is_solved_in_as_many_passes_as_it_has_modes() {
        let map = |x: &[f64]| {
            vec![
                0.99 * x[0] + 1.0,
                -0.7 * x[1] + 0.2 * x[0],
                0.3 * x[2] + x[1],
            ]
        };
        let mut anderson = Anderson::default();
        let mut x = vec![0.0; 3];
        for _ in 0..5 {
            let mut value = map(&x);
            anderson.improve(&x, &mut value);
            x = value;
        }
        let value = map(&x);
        for (value, x) in value.iter().zip(&x) {
            assert!((value - x).abs() < 1e-9, "{value} {x}");
        }
        assert!((x[0] - 100.0).abs() < 1e-7);
    }

    #[test]
    fn the_first_pass_is_plain_and_another_length_begins_anew() {
        let mut anderson = Anderson::default();
        let mut value = vec![3.0];
        anderson.improve(&[1.0], &mut value);
        assert_eq!(value, [3.0]);
        let mut value = vec![3.0, 4.0];
        anderson.improve(&[1.0, 1.0], &mut value);
        assert_eq!(value, [3.0, 4.0]);
    }
}
