//! A straight line through points, by least squares, and how well it fits.

/// The line y = `intercept` + `slope` x that is least Σ residual² away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineFit {
    /// The slope, in y's unit over x's.
    pub slope: f64,
    /// The value at x = 0, in y's unit.
    pub intercept: f64,
    /// Root of the mean squared residual, in y's unit.
    pub rms_residual: f64,
    /// The greatest |residual|, in y's unit.
    pub max_residual: f64,
    /// R², the share of the variance that the line explains, at most 1; 1 for
    /// a constant y, which a level line explains fully.
    pub r_squared: f64,
    /// Number of points.
    pub points: usize,
}

/// Abscissae that differ by less than this, over the largest, are one: a few
/// thousand roundings of it, in which a slope would drown.
const NO_SPREAD: f64 = 1e-12;

/// Why there is no line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// Two points always lie on a line: their fit would say nothing.
    #[error("a fit needs at least {least} points and has {0}", least = LineFit::LEAST_POINTS)]
    TooFew(usize),
    /// All points lie above each other.
    #[error("all {0} points of the fit have the same abscissa")]
    NoSpread(usize),
    /// A coordinate is not a finite number.
    #[error("point {0} of the fit, from 0, is not finite")]
    NotFinite(usize),
}

impl LineFit {
    /// The fewest points of a fit whose residual means something.
    pub const LEAST_POINTS: usize = 3;

    /// The line through points (x, y).
    ///
    /// # Errors
    /// With fewer than [`LineFit::LEAST_POINTS`] points, a coordinate that is
    /// not finite, or no two different x.
    pub fn through(points: &[(f64, f64)]) -> Result<Self, FitError> {
        let count = points.len();
        if count < Self::LEAST_POINTS {
            return Err(FitError::TooFew(count));
        }
        if let Some(bad) = points
            .iter()
            .position(|(x, y)| !(x.is_finite() && y.is_finite()))
        {
            return Err(FitError::NotFinite(bad));
        }
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count as f64;
        let (mean_x, mean_y) = (mean(|p| p.0), mean(|p| p.1));
        // About the means: without that, the squares of nearby x cancel.
        let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
            points.iter().map(|(x, y)| of(x - mean_x, y - mean_y)).sum()
        };
        let (xx, xy, yy) = (sum(&|x, _| x * x), sum(&|x, y| x * y), sum(&|_, y| y * y));
        let widest = points.iter().map(|p| p.0.abs()).fold(0.0, f64::max);
        if xx.sqrt() <= NO_SPREAD * widest || xx == 0.0 {
            return Err(FitError::NoSpread(count));
        }
        let slope = xy / xx;
        let intercept = mean_y - slope * mean_x;
        let residual = |(x, y): &(f64, f64)| y - (intercept + slope * x);
        let squares: f64 = points.iter().map(|p| residual(p) * residual(p)).sum();
        Ok(Self {
            slope,
            intercept,
            rms_residual: (squares / count as f64).sqrt(),
            max_residual: points.iter().map(|p| residual(p).abs()).fold(0.0, f64::max),
            r_squared: if yy > 0.0 { 1.0 - squares / yy } else { 1.0 },
            points: count,
        })
    }

    /// The line's y at x, each in its unit.
    pub fn at(&self, x: f64) -> f64 {
        self.intercept + self.slope * x
    }
}
