//! From a solution to plain draw data: what the canvas, the SVG export and the
//! text snapshots all draw. Knows no window and no file.
//!
//! [`draw`] makes a [`Drawing`]: marks in the world, in metres, with what they
//! mean. A [`Theme`] says how each role looks; [`place_labels`] finds room for
//! the text once letters have a size. A [`Chart`] is curves over one abscissa.

mod bounds;
mod cables;
mod chart;
mod compared;
mod draw;
mod drawing;
mod force_scale;
mod frame;
mod labels;
mod outcome;
mod paper;
mod path;
mod quantity;
mod rubbing;
mod shares;
mod theme;

pub use bounds::Bounds;
pub use chart::{Axis, Chart, CurveStyle, Series};
pub use compared::compared;
pub use draw::{Notes, draw, draw_on_the_way};
pub use drawing::{Caption, Drawing, Fact, Geometry, Label, LabelText, Mark, Role, Spot, Standing};
pub use force_scale::{ForceScale, Key};
pub use frame::Frame;
pub use labels::{Placed, place_labels, place_labels_beside};
pub use outcome::{outcome, reason};
pub use paper::charts;
pub use path::{Clipped, Outline, Path, Piece, circle, clip_half_plane, hatching, outline};
pub use quantity::{Quantity, one_two_five, superscript};
pub use shares::Shares;
pub use theme::{Arrowhead, Colour, Palette, Style, Theme};
