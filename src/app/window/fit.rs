//! Where the window is larger than its monitor or beyond its edges, it is
//! brought back: a first one, or one that was remembered from another monitor.
//! One that the system has moved by its frame is put where it was. Looks at the
//! first frames only; then the window is the user's.

use eframe::egui::{Context, Pos2, Rect, Vec2, ViewportCommand, pos2, vec2};

/// Frames after which the window is left alone. The system takes some of them
/// to put its frame around the window, and to do what it is told.
const FRAMES: u32 = 12;
/// What the system's frame takes at least, in points, told or not: a title bar.
const FRAME: Vec2 = vec2(2.0, 40.0);
/// What is left of the monitor for a panel of the desktop, in points.
const PANEL: f32 = 48.0;

/// Looks after the first frames.
#[derive(Debug, Default)]
pub struct Fit {
    frames: u32,
    /// Where the window was made, see [`Seen::made_at`].
    made_at: Option<Pos2>,
}

impl Fit {
    /// Looks at the window in this frame, and tells the system what to change.
    pub fn look(&mut self, ctx: &Context, frame: &eframe::Frame) {
        let Some(window) = frame.winit_window().filter(|_| self.frames < FRAMES) else {
            return;
        };
        self.frames += 1;
        ctx.request_repaint();
        if window.is_maximized() || window.fullscreen().is_some() {
            return;
        }
        let Some(monitor) = window.current_monitor() else {
            return;
        };
        let scale = ctx.pixels_per_point();
        let size = |width: u32, height: u32| vec2(width as f32, height as f32) / scale;
        let place = |x: i32, y: i32| pos2(x as f32, y as f32) / scale;
        let (at, extent) = (monitor.position(), monitor.size());
        let monitor = Rect::from_min_size(place(at.x, at.y), size(extent.width, extent.height));
        let (inner, outer) = (window.inner_size(), window.outer_size());
        // Not every system tells it.
        let at = window.outer_position().ok().map(|at| place(at.x, at.y));
        if self.frames == 1 {
            self.made_at = at;
        }
        let seen = Seen {
            at,
            made_at: self.made_at,
            inner: size(inner.width, inner.height),
            outer: size(outer.width, outer.height),
        };
        let (size, at) = seen.fitted(monitor);
        if let Some(size) = size {
            ctx.send_viewport_cmd(ViewportCommand::InnerSize(size));
        }
        if let Some(at) = at {
            ctx.send_viewport_cmd(ViewportCommand::OuterPosition(at));
        }
    }
}

/// A window as the system has it, in points.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// The upper left corner of its frame, where that is known …
    at: Option<Pos2>,
    /// … and where it was when it had none yet. Some systems then put the frame
    /// around it, which would move a remembered window at every start.
    made_at: Option<Pos2>,
    /// Its size without its frame …
    inner: Vec2,
    /// … and with it, as far as that is known.
    outer: Vec2,
}

impl Seen {
    /// What it has to become to lie on its monitor: its size without its frame,
    /// and where its frame is; `None` where it can stay as it is.
    fn fitted(&self, monitor: Rect) -> (Option<Vec2>, Option<Pos2>) {
        let told = self.outer - self.inner;
        let frame = told.max(FRAME);
        let room = monitor.size() - vec2(0.0, PANEL) - frame;
        let size = self.inner.min(room);
        // Rounding of pixels is no reason.
        let is_larger = (self.inner - size).max_elem() > 1.0;
        let last = monitor.max - size - frame;
        let is_by_frame = |made_at: &Pos2| {
            let by = self.at.map_or(Vec2::ZERO, |at| (at - *made_at).abs());
            by.x <= told.x && by.y <= told.y
        };
        let meant = self.made_at.filter(is_by_frame).or(self.at);
        let at = meant.map(|at| at.min(last).max(monitor.min));
        let is_elsewhere = |(at, was): &(Pos2, Pos2)| (*at - *was).length() > 0.5;
        let moved = at.zip(self.at).filter(is_elsewhere);
        (is_larger.then_some(size), moved.map(|(at, _)| at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTHING: (Option<Vec2>, Option<Pos2>) = (None, None);

    fn monitor(width: f32, height: f32) -> Rect {
        Rect::from_min_size(Pos2::ZERO, vec2(width, height))
    }

    fn seen(at: Option<[f32; 2]>, inner: [f32; 2], frame: [f32; 2]) -> Seen {
        let inner = Vec2::from(inner);
        let at = at.map(Pos2::from);
        Seen {
            at,
            made_at: at,
            inner,
            outer: inner + Vec2::from(frame),
        }
    }

    #[test]
    fn a_first_window_lies_on_a_small_screen_with_its_title_bar() {
        for (width, height) in [(1366.0, 768.0), (1440.0, 900.0), (1280.0, 720.0)] {
            for frame in [[0.0, 0.0], [2.0, 24.0], [10.0, 46.0]] {
                let first = seen(Some([0.0, 0.0]), [1440.0, 900.0], frame);
                let (size, at) = first.fitted(monitor(width, height));
                let size = size.unwrap();
                assert!(size.x + frame[0] <= width && size.y + frame[1] + PANEL <= height);
                // No smaller than it has to be.
                assert!(size.x + 12.0 >= width && size.y + 100.0 >= height);
                assert_eq!(at, None);
                let again = seen(Some([0.0, 0.0]), size.into(), frame);
                assert_eq!(again.fitted(monitor(width, height)), NOTHING);
            }
        }
        let first = seen(Some([240.0, 60.0]), [1440.0, 900.0], [2.0, 24.0]);
        assert_eq!(first.fitted(monitor(1920.0, 1080.0)), NOTHING);
        // Where the system does not tell where it is.
        let first = seen(None, [1440.0, 900.0], [0.0, 0.0]);
        let (size, at) = first.fitted(monitor(1366.0, 768.0));
        assert!(size.is_some() && at.is_none());
    }

    #[test]
    fn a_window_that_is_moved_by_its_frame_is_put_where_it_was() {
        let check = |at: [f32; 2], expect: Option<[f32; 2]>| {
            let framed = Seen {
                made_at: Some(pos2(470.0, 160.0)),
                ..seen(Some(at), [1000.0, 600.0], [2.0, 25.0])
            };
            let (_, moved) = framed.fitted(monitor(1920.0, 1080.0));
            assert_eq!(moved, expect.map(Pos2::from), "{at:?}");
        };
        check([471.0, 140.0], Some([470.0, 160.0]));
        check([470.0, 160.0], None);
        // The system has found another place for it.
        check([240.0, 77.0], None);
    }

    #[test]
    fn a_window_of_a_monitor_that_is_gone_is_brought_back() {
        let far = seen(Some([2500.0, 700.0]), [1000.0, 600.0], [2.0, 24.0]);
        let (size, at) = far.fitted(monitor(1366.0, 768.0));
        let at = at.unwrap();
        assert_eq!(size, None);
        assert!(at.x >= 0.0 && at.x + 1002.0 <= 1366.0);
        assert!(at.y >= 0.0 && at.y + 624.0 <= 768.0);
        let left = seen(Some([-300.0, -80.0]), [1000.0, 600.0], [2.0, 24.0]);
        let (_, at) = left.fitted(monitor(1366.0, 768.0));
        assert_eq!(at, Some(Pos2::ZERO));
        // On the second of two monitors it may stay where it is.
        let second = Rect::from_min_size(pos2(1366.0, 0.0), vec2(1920.0, 1080.0));
        let there = seen(Some([1500.0, 100.0]), [1440.0, 900.0], [2.0, 24.0]);
        assert_eq!(there.fitted(second), NOTHING);
    }
}
