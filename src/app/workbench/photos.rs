//! The photographs that the scene names, as far as they are known, and the tool
//! that brings one to scale.

use crate::app::pixels::Decoded;
use crate::app::platform::Errand;
use crate::geometry::Vector;
use crate::scene::{Photo, limits};
use crate::units::{metres, millimetres};
use eframe::egui::TextureHandle;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

/// What is known of a photograph's file.
pub enum Photograph {
    /// It is being read.
    Coming,
    /// It is here.
    Here {
        /// Its pixels, perhaps fewer than in the file.
        texture: TextureHandle,
        /// Width and height in the file, in pixels.
        size: [u32; 2],
    },
    /// It cannot be shown, for this reason.
    Missing(String),
}

/// The photographs that were seen.
#[derive(Default)]
pub struct Photos {
    /// What is known of each, by its file.
    pub known: BTreeMap<PathBuf, Photograph>,
    /// Those that are being decoded.
    pub coming: Vec<Coming>,
    /// The scale tool, while it is in the hand.
    pub scaling: Option<Scaling>,
}

/// A photograph that is being decoded.
pub struct Coming {
    /// What for.
    pub errand: Errand,
    /// The document that it was chosen for, see [`super::Workbench::opened`].
    pub opened: u64,
    /// Its file.
    pub path: PathBuf,
    /// Where it comes.
    pub result: Receiver<Result<Decoded, String>>,
}

impl Photos {
    /// What is known of a photograph.
    pub fn get(&self, photo: &Photo) -> Option<&Photograph> {
        self.known.get(Path::new(&photo.file))
    }

    /// Height over width, where it is known.
    pub fn ratio(&self, photo: &Photo) -> Option<f64> {
        match self.get(photo)? {
            Photograph::Here { size, .. } => Some(f64::from(size[1]) / f64::from(size[0])),
            _ => None,
        }
    }
}

/// The scale tool: two points of the photograph, and how far apart they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scaling {
    /// The points, in metres; at most two.
    pub points: Vec<Vector>,
    /// Their distance, in mm.
    pub distance_mm: f64,
}

impl Scaling {
    /// Takes a point; with the second, the distance is what it is now.
    pub fn take(&mut self, point: Vector) {
        if self.points.len() >= 2 {
            self.points.clear();
        }
        self.points.push(point);
        if let [a, b] = self.points[..] {
            self.distance_mm = millimetres((b - a).norm());
        }
    }

    /// The photograph with its points at their distance: the first stays.
    /// `None` where there are no two points, or it would become too small or
    /// large.
    pub fn applied(&self, photo: &Photo) -> Option<Photo> {
        let [a, b] = self.points[..] else {
            return None;
        };
        let factor = metres(self.distance_mm) / (b - a).norm();
        let width_mm = factor * photo.width_mm;
        let centre = a + factor * (photo_centre(photo) - a);
        (factor > 0.0 && limits::PHOTO_WIDTH.contain(width_mm)).then(|| Photo {
            width_mm,
            center_mm: [millimetres(centre.x), millimetres(centre.y)],
            ..photo.clone()
        })
    }
}

/// The centre of a photograph, in metres.
pub fn photo_centre(photo: &Photo) -> Vector {
    Vector::new(metres(photo.center_mm[0]), metres(photo.center_mm[1]))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A photograph that is turned by a right angle.
    pub fn photo() -> Photo {
        Photo {
            file: "a.png".to_owned(),
            center_mm: [10.0, 20.0],
            width_mm: 100.0,
            rotation_deg: 90.0,
            opacity: 1.0,
        }
    }

    #[test]
    fn two_points_come_to_their_distance_and_the_first_stays() {
        let mut scaling = Scaling::default();
        scaling.take(Vector::new(0.01, 0.02));
        assert!(scaling.applied(&photo()).is_none());
        scaling.take(Vector::new(0.01, 0.05));
        assert!((scaling.distance_mm - 30.0).abs() < 1e-12);
        scaling.distance_mm = 60.0;
        let scaled = scaling.applied(&photo()).unwrap();
        assert!((scaled.width_mm - 200.0).abs() < 1e-9);
        // The first point was the centre.
        assert!((scaled.center_mm[0] - 10.0).abs() < 1e-9);
        assert!((scaled.center_mm[1] - 20.0).abs() < 1e-9);
        scaling.distance_mm = 0.0;
        assert!(scaling.applied(&photo()).is_none());
    }
}
