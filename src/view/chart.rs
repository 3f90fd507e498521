//! Curves over one abscissa as plain data: what the plots' files, the report's
//! figures and the window all draw. It holds no layout and no colour.

/// Curves over one abscissa.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// A word for files, unique among the charts of one figure or plot.
    pub word: &'static str,
    /// The abscissa.
    pub x: Axis,
    /// The ordinate.
    pub y: Axis,
    /// The curves.
    pub series: Vec<Series>,
}

/// What an axis counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Its name.
    pub name: &'static str,
    /// The unit of its numbers; empty for a pure number.
    pub unit: &'static str,
    /// Whether it has to show zero.
    pub from_zero: bool,
    /// Whether both axes have one scale, as in a map.
    pub to_scale: bool,
}

impl Axis {
    /// An axis that shows zero.
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self {
            name,
            unit,
            from_zero: true,
            to_scale: false,
        }
    }

    /// An axis of a map, in millimetres.
    pub const fn map(name: &'static str) -> Self {
        Self {
            to_scale: true,
            ..Self::new(name, "mm")
        }
    }
}

/// A curve of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// How it is drawn.
    pub style: CurveStyle,
    /// Its points (x, y), in the units of the axes.
    pub points: Vec<(f64, f64)>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveStyle {
    /// A line.
    Line,
    /// A dashed line: a model of what another curve shows.
    Dashed,
    /// Points by themselves: what was measured.
    Dots,
    /// A stem from zero to each point.
    Stems,
}

impl Series {
    /// A curve.
    pub fn new(name: impl Into<String>, style: CurveStyle, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            style,
            points,
        }
    }
}
