//! Where the canvas looks: panned, zoomed at the pointer, fitted to the scene.

use crate::geometry::Vector;
use crate::view::{Bounds, Frame};
use eframe::egui::{MouseWheelSource, Rect, Response, Ui, Vec2, vec2};

/// How far one may zoom: points in a metre. A robot of a metre fills a window
/// at about 1000.
const SCALES: (f64, f64) = (1e-2, 1e9);
/// Room that is left free around the scene, in points: for the legend and the
/// chips at the canvas's edges.
const MARGIN: f32 = 28.0;

/// A view of the plane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Camera {
    frame: Option<Frame>,
    /// Whether the user has moved it: then it no longer follows the window.
    moved: bool,
    fit: bool,
}

impl Camera {
    /// Shows everything at the next frame.
    pub fn fit_soon(&mut self) {
        self.fit = true;
    }

    /// Whether the user has moved the view since it was fitted.
    pub fn is_moved(&self) -> bool {
        self.moved
    }

    /// Looks through a window on the screen; the first time, or when asked to,
    /// at all of `bounds`, beside what covers the window's `left` edge.
    pub fn place(&mut self, window: Rect, left: f32, bounds: &Bounds) {
        let mut free = window;
        free.min.x = (free.min.x + left).min(free.max.x);
        let inner = bounds_of(free.shrink(MARGIN.min(0.2 * free.size().min_elem())));
        let window = bounds_of(window);
        let mut fitting = Frame::fitting(bounds, inner);
        fitting.window = window;
        // In the middle of what is free.
        let aside = (inner.centre() - window.centre()) / fitting.scale;
        fitting.middle -= Vector::new(aside.x, -aside.y);
        match &mut self.frame {
            Some(frame) if !self.fit => {
                // A window that changes its size keeps the view's middle; one
                // that nobody has moved shows everything again.
                if frame.window.size() != window.size() && !self.moved {
                    *frame = fitting;
                }
                frame.window = window;
            }
            _ => {
                self.frame = Some(fitting);
                self.moved = false;
                self.fit = false;
            }
        }
    }

    /// The present view. An empty one before [`Camera::place`].
    pub fn frame(&self) -> Frame {
        self.frame.unwrap_or(Frame {
            window: Bounds::of([Vector::zeros()]).grown(1.0),
            scale: 1.0,
            middle: Vector::zeros(),
        })
    }

    /// Moves the view by points on the screen.
    pub fn pan(&mut self, right: f64, down: f64) {
        if let Some(frame) = &mut self.frame {
            frame.middle += Vector::new(-right, down) / frame.scale;
            self.moved = true;
        }
    }

    /// Enlarges by a factor and keeps a point of the screen where it is.
    pub fn zoom(&mut self, factor: f64, at: Vector) {
        if let Some(frame) = &mut self.frame
            && factor.is_finite()
            && factor > 0.0
        {
            let kept = frame.to_world(at);
            frame.scale = (frame.scale * factor).clamp(SCALES.0, SCALES.1);
            frame.middle += kept - frame.to_world(at);
            self.moved = true;
        }
    }

    /// Follows the wheel and pinches.
    pub fn navigate(&mut self, ui: &Ui, response: &Response) {
        let (zoom, scroll, source, touch) = ui.input(|input| {
            let scroll = input.smooth_scroll_delta();
            let source = input.scroll_source();
            (input.zoom_delta(), scroll, source, input.multi_touch())
        });
        let fingers = touch.map(|touch| touch.center_pos);
        let fingers = fingers.filter(|at| response.interact_rect.contains(*at));
        let Some(pointer) = fingers.or(response.hover_pos()) else {
            return;
        };
        let at = Vector::new(f64::from(pointer.x), f64::from(pointer.y));
        // Two fingers on a trackpad move the view, where they can be told from
        // a wheel, which zooms as in drawing programs and maps.
        let trackpad = matches!(
            source,
            Some(MouseWheelSource::Trackpad | MouseWheelSource::Momentum)
        );
        let wheel = if trackpad { 0.0 } else { f64::from(scroll.y) };
        let factor = f64::from(zoom) * (wheel / 240.0).exp();
        if factor != 1.0 {
            self.zoom(factor, at);
        }
        let by = match touch {
            Some(touch) => touch.translation_delta,
            None if trackpad => scroll,
            None => vec2(scroll.x, 0.0),
        };
        if by != Vec2::ZERO {
            self.pan(f64::from(by.x), f64::from(by.y));
        }
    }
}

fn bounds_of(rect: Rect) -> Bounds {
    Bounds {
        least: Vector::new(f64::from(rect.left()), f64::from(rect.top())),
        most: Vector::new(f64::from(rect.right()), f64::from(rect.bottom())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    fn looking() -> Camera {
        let mut camera = Camera::default();
        let bounds = Bounds::of([Vector::new(0.0, 0.0), Vector::new(0.2, 0.1)]);
        let window = Rect::from_min_max(pos2(100.0, 50.0), pos2(900.0, 650.0));
        camera.place(window, 0.0, &bounds);
        camera
    }

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let mut camera = looking();
        let at = Vector::new(300.0, 500.0);
        let before = camera.frame().to_world(at);
        camera.zoom(3.7, at);
        assert!((camera.frame().to_world(at) - before).norm() < 1e-12);
        camera.zoom(f64::NAN, at);
        assert!((camera.frame().to_world(at) - before).norm() < 1e-12);
    }

    #[test]
    fn everything_is_shown_beside_what_covers_the_edge() {
        let mut camera = Camera::default();
        let bounds = Bounds::of([Vector::new(0.0, 0.0), Vector::new(0.3, 0.1)]);
        let window = Rect::from_min_max(pos2(100.0, 50.0), pos2(900.0, 650.0));
        camera.place(window, 60.0, &bounds);
        let [left, right] = [bounds.least, bounds.most].map(|p| camera.frame().to_screen(p));
        // As far from the cover as from the other edge.
        assert!((left.x - 160.0 - f64::from(MARGIN)).abs() < 1e-9, "{left}");
        assert!(
            (900.0 - right.x - f64::from(MARGIN)).abs() < 1e-9,
            "{right}"
        );
    }

    #[test]
    fn panning_moves_the_picture_with_the_pointer() {
        let mut camera = looking();
        let point = camera.frame().to_world(Vector::new(300.0, 500.0));
        camera.pan(12.0, -7.0);
        let now = camera.frame().to_screen(point);
        assert!((now - Vector::new(312.0, 493.0)).norm() < 1e-9, "{now}");
    }
}
