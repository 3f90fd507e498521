//! The camera that orbits a point: plain numbers and the moves that a pointer
//! makes. Knows no input and no screen.

use super::mesh::Bounds3;
use nalgebra::{Matrix4, Point3, Vector3};

/// How far the pitch goes either way: just short of straight up, where the
/// horizon would be lost.
const STEEPEST: f64 = 1.5;
/// Radians a turn for each point that the pointer moves.
const TURN: f64 = 0.008;
/// The least and the greatest distance, over the radius of what is looked at.
const NEAREST: f64 = 0.05;
const FARTHEST: f64 = 50.0;

/// A camera that looks at a target. +y of the plane is up, +z is towards the
/// viewer at a yaw and pitch of 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// What it looks at, in metres.
    pub target: Vector3<f64>,
    /// How far round it is, in radians, positive to the right.
    pub yaw: f64,
    /// How far up it is, in radians.
    pub pitch: f64,
    /// Its distance from the target, in metres.
    pub distance: f64,
    /// The vertical angle of its view, in radians.
    pub field_of_view: f64,
    /// The radius of what it was fitted to, in metres.
    pub scale: f64,
}

/// Looks at the origin from half left and above, at something a metre across.
impl Default for Camera {
    fn default() -> Self {
        Self {
            target: Vector3::zeros(),
            yaw: -0.50,
            pitch: 0.30,
            distance: 3.0,
            // A long lens: parallels stay nearly parallel.
            field_of_view: 0.42,
            scale: 0.5,
        }
    }
}

impl Camera {
    /// The default view of all that a box holds, for a window of this width
    /// over height.
    pub fn fitting(bounds: &Bounds3, aspect: f64) -> Self {
        let mut camera = Self::default();
        camera.fit(bounds, aspect);
        camera
    }

    /// Moves back or forth until all of a box is seen, as large as the window
    /// allows; keeps the direction.
    pub fn fit(&mut self, bounds: &Bounds3, aspect: f64) {
        /// Margin around it, over its size.
        const ROOM: f64 = 1.06;
        if bounds.is_empty() || !(aspect > 0.0 && aspect.is_finite()) {
            return;
        }
        self.scale = 0.5 * bounds.size().norm();
        let [right, up, back] = self.axes();
        let high = (0.5 * self.field_of_view).tan();
        let wide = high * aspect;
        // Twice: first about the middle, then about the middle of what is seen.
        self.target = bounds.centre();
        for _ in 0..3 {
            // Along each axis, what distance from the target lets both edges
            // of the window just clear the box.
            let edges = |axis: Vector3<f64>, slope: f64| {
                let reach = |sign: f64| {
                    let needs = bounds.corners().map(|corner| {
                        let away = corner - self.target;
                        sign * axis.dot(&away) / (slope / ROOM) + back.dot(&away)
                    });
                    needs.into_iter().fold(f64::NEG_INFINITY, f64::max)
                };
                (reach(1.0), reach(-1.0))
            };
            let (left, other) = edges(right, wide);
            let (top, bottom) = edges(up, high);
            self.distance = left.max(other).max(top).max(bottom);
            let shift = 0.25 * (wide * (left - other) * right + high * (top - bottom) * up);
            self.target += 2.0 * shift / ROOM;
        }
    }

    /// Turns about the target by a pointer's way in points; rightward turns
    /// what is seen to the right.
    pub fn orbit(&mut self, right: f64, down: f64) {
        let turned = self.yaw - TURN * right;
        self.yaw = turned - std::f64::consts::TAU * (turned / std::f64::consts::TAU).round();
        self.pitch = (self.pitch + TURN * down).clamp(-STEEPEST, STEEPEST);
    }

    /// Moves so that the target follows a pointer's way in points, in a window
    /// so many points high.
    pub fn pan(&mut self, right: f64, down: f64, height: f64) {
        let [aside, up, _] = self.axes();
        let metres = 2.0 * self.distance * (0.5 * self.field_of_view).tan() / height.max(1.0);
        self.target += metres * (down * up - right * aside);
    }

    /// Comes nearer by a factor over 1, goes back by one below.
    pub fn zoom(&mut self, factor: f64) {
        if factor > 0.0 && factor.is_finite() {
            let distance = self.distance / factor;
            self.distance = distance.clamp(NEAREST * self.scale, FARTHEST * self.scale);
        }
    }

    /// Where the camera is, in metres.
    pub fn eye(&self) -> Vector3<f64> {
        let [_, _, back] = self.axes();
        self.target + self.distance * back
    }

    /// Unit vectors to the right and up on the screen, and out of it.
    pub fn axes(&self) -> [Vector3<f64>; 3] {
        let (sy, cy) = self.yaw.sin_cos();
        let (sp, cp) = self.pitch.sin_cos();
        let right = Vector3::new(cy, 0.0, -sy);
        let back = Vector3::new(sy * cp, sp, cy * cp);
        [right, back.cross(&right), back]
    }

    /// Where a point is seen, in metres: to the right and up from the middle of
    /// the picture, in halves of its width and height. `None` behind the camera.
    pub fn seen(&self, point: Vector3<f64>, aspect: f64) -> Option<[f64; 2]> {
        let clip = self.clip(self.target, aspect) * (point - self.target).push(1.0);
        (clip.w > 0.0).then(|| [clip.x / clip.w, clip.y / clip.w])
    }

    /// From points relative to `origin` to clip space: x to the right, y up,
    /// depth from 0 to 1.
    pub fn clip(&self, origin: Vector3<f64>, aspect: f64) -> Matrix4<f64> {
        let [_, up, _] = self.axes();
        let at = |v: Vector3<f64>| Point3::from(v - origin);
        let view = Matrix4::look_at_rh(&at(self.eye()), &at(self.target), &up);
        let far = self.distance + 8.0 * self.scale;
        let near = (self.distance - 3.0 * self.scale).max(0.01 * self.distance);
        let focal = 1.0 / (0.5 * self.field_of_view).tan();
        let mut lens = Matrix4::zeros();
        lens[(0, 0)] = focal / aspect;
        lens[(1, 1)] = focal;
        lens[(2, 2)] = far / (near - far);
        lens[(2, 3)] = near * far / (near - far);
        lens[(3, 2)] = -1.0;
        lens * view
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bounds() -> Bounds3 {
        Bounds3 {
            least: Vector3::new(0.9, -0.3, -0.1),
            most: Vector3::new(1.2, 0.4, 0.05),
        }
    }

    fn on_screen(camera: &Camera, point: Vector3<f64>, aspect: f64) -> Vector3<f64> {
        let origin = Vector3::new(1.0, 0.0, 0.0);
        let clip = camera.clip(origin, aspect) * (point - origin).push(1.0);
        clip.xyz() / clip.w
    }

    #[test]
    fn what_was_fitted_fills_the_window() {
        for aspect in [0.4, 1.0, 3.0] {
            for yaw in [-2.0, -0.5, 0.0, 1.3] {
                let mut camera = Camera {
                    yaw,
                    ..Camera::default()
                };
                camera.fit(&bounds(), aspect);
                let seen = bounds().corners().map(|c| on_screen(&camera, c, aspect));
                let most = seen.iter().map(|p| p.x.abs().max(p.y.abs()));
                let most = most.fold(0.0, f64::max);
                assert!((0.85..=1.0).contains(&most), "{aspect} {yaw}: {most}");
                assert!(seen.iter().all(|p| (0.0..=1.0).contains(&p.z)));
            }
        }
    }

    #[test]
    fn up_is_up_and_the_front_is_near() {
        let camera = Camera::fitting(&bounds(), 1.0);
        let at = |x, y, z| on_screen(&camera, camera.target + Vector3::new(x, y, z), 1.0);
        assert!(at(0.0, 0.1, 0.0).y > at(0.0, 0.0, 0.0).y + 0.1);
        assert!(at(0.1, 0.0, 0.0).x > at(0.0, 0.0, 0.0).x + 0.1);
        assert!(at(0.0, 0.0, 0.1).z < at(0.0, 0.0, 0.0).z);
        let (front, middle) = (at(0.0, 0.1, 0.0).x, at(0.0, 0.0, 0.0).x);
        assert!((front - middle).abs() < 1e-12);
    }

    /// The target stays under the pointer that drags it.
    #[test]
    fn a_pan_follows_the_pointer() {
        let camera = Camera::fitting(&bounds(), 1.5);
        let before = camera.target;
        let mut moved = camera;
        moved.pan(30.0, -20.0, 400.0);
        let now = on_screen(&moved, before, 1.5);
        assert!((now.x * 300.0 - 30.0).abs() < 0.5, "{now}");
        assert!((now.y * 200.0 - 20.0).abs() < 0.5, "{now}");
    }

    #[test]
    fn orbits_and_zooms_stay_within_bounds() {
        let mut camera = Camera::fitting(&bounds(), 1.0);
        for _ in 0..1000 {
            camera.orbit(100.0, 100.0);
            camera.zoom(1.3);
        }
        assert!(camera.pitch == STEEPEST && camera.yaw.abs() <= 3.2);
        assert!(camera.distance >= NEAREST * camera.scale);
        camera.zoom(f64::NAN);
        camera.zoom(-1.0);
        assert!(camera.distance.is_finite());
        assert!(
            camera
                .clip(Vector3::zeros(), 1.0)
                .iter()
                .all(|v| v.is_finite())
        );
    }
}
