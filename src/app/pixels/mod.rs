//! Pixels: what a photograph's file holds, how large one may be, and how many
//! pixels an exported picture has.

#[cfg(not(target_arch = "wasm32"))]
mod decode;

#[cfg(not(target_arch = "wasm32"))]
pub use decode::decode;

use eframe::egui::ColorImage;

/// Pixels of a PNG in a pixel of the picture.
pub const SCALE: f64 = 2.0;
/// The most pixels on a side of a photograph.
pub const MOST_SIDE: u32 = 8192;
/// The most pixels on a side that are shown; a screen has not many more.
pub const SHOWN_SIDE: u32 = 2048;

/// A decoded photograph.
#[derive(Clone, Debug, PartialEq)]
pub struct Decoded {
    /// Its pixels, at most [`SHOWN_SIDE`] on a side, the right way up.
    pub image: ColorImage,
    /// Width and height in the file, in pixels, the right way up.
    pub size: [u32; 2],
}

/// What is said of a file that is no such picture.
pub fn neither() -> String {
    "it is neither a PNG nor a JPEG picture; save it as one of these".to_owned()
}

/// What is said of a picture that has more than [`MOST_SIDE`] pixels on a
/// side.
pub fn too_large(width: u32, height: u32) -> String {
    format!(
        "it has {width} × {height} pixels, and a photograph may have {MOST_SIDE} on a side; make \
         it smaller"
    )
}
