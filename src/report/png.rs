//! A drawing as PNG: its SVG, rasterised.
//!
//! Text is set in the font of `assets/fonts`, which is part of the program,
//! and in no other, so that a picture is the same everywhere. Characters
//! beyond Latin, Greek and Cyrillic are left out.

use super::svg::{self, Size};
use crate::view::{Drawing, Theme};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, Options, Tree};
use std::sync::Arc;

const FONTS: [&[u8]; 2] = [
    include_bytes!("../../assets/fonts/Inter-Regular.otf"),
    include_bytes!("../../assets/fonts/Inter-SemiBold.otf"),
];

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PngError {
    /// The rasteriser does not understand the SVG: a bug.
    #[error("the picture cannot be rasterised: {0}")]
    Svg(#[from] usvg::Error),
    /// Too many pixels, or none.
    #[error(
        "a picture of {width} × {height} pixels cannot be made; choose a size and scale that give \
         1 to {MOST_PIXELS} pixels a side"
    )]
    Size {
        /// Its width.
        width: f64,
        /// Its height.
        height: f64,
    },
    /// The pixels cannot be written as PNG.
    #[error("the picture cannot be encoded: {0}")]
    Encoding(String),
}

/// Most pixels on a side: 1 GB of them.
const MOST_PIXELS: u32 = 16_384;

/// The drawing as the bytes of a PNG file, with `scale` pixels of the file in
/// a pixel of the size.
///
/// # Errors
/// If the picture would have no pixels or more than 16 384 on a side.
pub fn render(
    drawing: &Drawing,
    theme: Theme,
    size: Size,
    scale: f64,
) -> Result<Vec<u8>, PngError> {
    let mut options = Options {
        font_family: "Inter".to_owned(),
        ..Options::default()
    };
    let fonts = Arc::make_mut(&mut options.fontdb);
    for font in FONTS {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family("Inter");
    let tree = Tree::from_str(&svg::render(drawing, theme, size), &options)?;
    let side = |length: f32| (f64::from(length) * scale).round();
    let (width, height) = (side(tree.size().width()), side(tree.size().height()));
    let refused = || PngError::Size { width, height };
    let most = f64::from(MOST_PIXELS);
    if !((1.0..=most).contains(&width) && (1.0..=most).contains(&height)) {
        return Err(refused());
    }
    let mut pixels = Pixmap::new(width as u32, height as u32).ok_or_else(refused)?;
    let scale = scale as f32;
    let transform = Transform::from_scale(scale, scale);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels
        .encode_png()
        .map_err(|error| PngError::Encoding(error.to_string()))
}
