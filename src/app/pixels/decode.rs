//! A photograph's pixels from the bytes of a PNG or JPEG file, whatever is in
//! them: what is too large is refused with its numbers before any pixel is
//! decoded.

use super::{Decoded, MOST_SIDE, SHOWN_SIDE};
use eframe::egui::{Color32, ColorImage};
use image::{DynamicImage, ImageDecoder as _, ImageFormat, ImageReader, Limits};
use std::io::Cursor;

/// The most memory that decoding one may take, in bytes: that of its pixels
/// at most, and as much again.
const MOST_BYTES: u64 = 2 * 4 * (MOST_SIDE as u64) * (MOST_SIDE as u64);

/// The photograph in a file's bytes.
///
/// # Errors
/// A clause with `it` for the file: not such a picture, too large, damaged.
pub fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let format = image::guess_format(bytes).ok();
    let Some(format @ (ImageFormat::Png | ImageFormat::Jpeg)) = format else {
        return Err(super::neither());
    };
    let mut limits = Limits::default();
    limits.max_alloc = Some(MOST_BYTES);
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(|error| damaged(&error))?;
    let (width, height) = decoder.dimensions();
    if width > MOST_SIDE || height > MOST_SIDE {
        return Err(super::too_large(width, height));
    }
    if width == 0 || height == 0 {
        return Err("it has no pixels".to_owned());
    }
    // Cameras write pictures lying down and note how to hold them.
    let orientation = decoder.orientation().map_err(|error| damaged(&error))?;
    let mut picture = DynamicImage::from_decoder(decoder).map_err(|error| damaged(&error))?;
    picture.apply_orientation(orientation);
    let size = [picture.width(), picture.height()];
    if size[0].max(size[1]) > SHOWN_SIDE {
        picture = picture.thumbnail(SHOWN_SIDE, SHOWN_SIDE);
    }
    let pixels = picture.into_rgba8();
    let shown = [pixels.width() as usize, pixels.height() as usize];
    let colours = pixels.pixels().map(|pixel| {
        let [r, g, b, a] = pixel.0;
        Color32::from_rgba_unmultiplied(r, g, b, a)
    });
    Ok(Decoded {
        image: ColorImage::new(shown, colours.collect()),
        size,
    })
}

fn damaged(error: &image::ImageError) -> String {
    match error {
        image::ImageError::Limits(_) => {
            "it takes too much memory to decode; make it smaller".to_owned()
        }
        _ => format!("it is damaged ({error}); save it again"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::RgbaImage;

    fn png(width: u32, height: u32) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        let picture = RgbaImage::from_pixel(width, height, image::Rgba([255, 0, 0, 128]));
        picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn a_picture_is_decoded_and_large_ones_are_shown_with_fewer_pixels() {
        let small = decode(&png(3, 2)).unwrap();
        assert_eq!((small.size, small.image.size), ([3, 2], [3, 2]));
        assert_eq!(
            small.image.pixels[0],
            Color32::from_rgba_unmultiplied(255, 0, 0, 128)
        );
        let large = decode(&png(4096, 16)).unwrap();
        assert_eq!((large.size, large.image.size), ([4096, 16], [2048, 8]));
    }

    #[test]
    fn what_cannot_be_shown_is_refused_with_its_numbers() {
        let wide = decode(&png(8193, 1)).unwrap_err();
        assert!(wide.contains("8193 × 1") && wide.contains("8192"), "{wide}");
        assert!(decode(b"GIF89a").unwrap_err().contains("neither"));
        assert!(decode(b"").unwrap_err().contains("neither"));
        let mut cut = png(64, 64);
        cut.truncate(cut.len() - 30);
        assert!(decode(&cut).unwrap_err().contains("damaged"));
        // A head that promises 4 billion pixels costs nothing.
        let mut bomb = png(1, 1);
        bomb[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
        assert!(decode(&bomb).is_err());
    }
}
