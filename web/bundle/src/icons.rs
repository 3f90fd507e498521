//! The icon as pixels, for what does not take it as lines.

use anyhow::{Context, Result};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Files' names, their sides in pixels, and whether the whole square is
/// filled, for systems that cut their own shape.
const ICONS: &[(&str, u32, bool)] = &[
    ("icon-180.png", 180, true),
    ("icon-192.png", 192, false),
    ("icon-512.png", 512, false),
    ("icon-maskable.png", 512, true),
];

/// The rounding of the icon's corners, as its file has it.
const ROUNDED: &str = r#" rx="104""#;

/// The icons that are made of an SVG.
pub fn pixels(svg: &str) -> Result<Vec<(String, Vec<u8>)>> {
    let icons = ICONS.iter().map(|&(name, side, is_square)| {
        let text = if is_square {
            svg.replace(ROUNDED, "")
        } else {
            svg.to_owned()
        };
        Ok((name.to_owned(), png(&text, side)?))
    });
    icons.collect()
}

fn png(svg: &str, side: u32) -> Result<Vec<u8>> {
    let tree = Tree::from_str(svg, &Options::default())?;
    let mut pixels = Pixmap::new(side, side).context("an icon has pixels")?;
    let scale = side as f32 / tree.size().width();
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    Ok(pixels.encode_png()?)
}
