//! The graphics processor's pictures: shaders that every backend takes, and
//! renders on a software adapter whose pixels say what they should.
//!
//! `PICTURES=folder cargo test --test render` also writes the pictures there,
//! to be looked at.

mod offscreen;

use std::sync::Arc;

use offscreen::{Offscreen, Picture};
use sinew::equilibrium::{Settings, Solution, Start, solve};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::model::Problem;
use sinew::render::{
    self, Camera, FieldOutput, FieldPass, FieldPicture, RobotSizes, SolidPass, SolidPicture,
    contour_spacing,
};
use sinew::scene::Scene;
use sinew::view::{Bounds, Frame, Notes, Theme, draw};

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const SHAPES: &str = include_str!("../assets/scenes/shapes.toml");

fn solved(text: &str) -> (Scene, Problem, Solution) {
    let scene = Scene::from_toml(text).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    (scene, problem, solution)
}

fn window(width: f64, height: f64) -> Bounds {
    Bounds {
        least: Vector::zeros(),
        most: Vector::new(width, height),
    }
}

// --- The clearance field ----------------------------------------------

/// The clearance that the shader finds at the middle of every pixel.
fn clearances(frame: &Frame, obstacles: &[Obstacle], width: u32, height: u32) -> Picture<f32> {
    let screen = Offscreen::new();
    let format = eframe::wgpu::TextureFormat::R32Float;
    let mut pass = FieldPass::new(&screen.device, format, FieldOutput::Clearance);
    let picture = FieldPicture::new(frame.window, frame, obstacles, Theme::Light);
    let index = pass.prepare(&screen.device, &screen.queue, &picture, 1.0);
    pass.prepared();
    screen.floats(width, height, |target| pass.paint(index, target))
}

/// Compares the shader's clearances with the library's, to `tolerance` pixels.
fn check_field(frame: &Frame, obstacles: &[Obstacle], tolerance: f64) {
    let size = frame.window.size();
    let found = clearances(frame, obstacles, size.x as u32, size.y as u32);
    let mut signs = [0, 0];
    for (x, y, value) in found.pixels() {
        let point = frame.to_world(Vector::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
        let expected = obstacles
            .iter()
            .map(|obstacle| obstacle.clearance(point).distance)
            .fold(f64::INFINITY, f64::min);
        let error = (f64::from(value) - expected) * frame.scale;
        assert!(
            error.abs() < tolerance,
            "{value} is not {expected} at {x}, {y}: {error} pixels off"
        );
        signs[usize::from(expected < 0.0)] += 1;
    }
    assert!(signs[0] > 100 && signs[1] > 100, "{signs:?}");
}

fn frame(middle: Vector, across: f64) -> Frame {
    Frame {
        window: window(160.0, 120.0),
        scale: 160.0 / across,
        middle,
    }
}

#[test]
fn the_field_is_the_clearance_for_every_shape() {
    let hexagon: Vec<Vector> = (0..6)
        .map(|i| (f64::from(i) * 1.05).sin_cos())
        .map(|(sine, cosine)| Vector::new(0.04 * cosine, 0.02 * sine))
        .collect();
    let at = Vector::new(0.31, -0.17);
    for radius in [0.0, 0.007] {
        let cores = [
            Core::Point,
            Core::HalfPlane,
            Core::rectangle(0.05, 0.03),
            Core::segment(0.05),
            Core::polygon(&hexagon).unwrap(),
        ];
        for core in cores {
            if radius == 0.0 && matches!(core, Core::Point) {
                continue;
            }
            // A segment of no width has no inside.
            let grown = match core {
                Core::Vertices(ref vertices) if vertices.len() == 2 => radius + 0.002,
                _ => radius,
            };
            let obstacle = Obstacle::new(core, grown, at, 0.6);
            check_field(&frame(at, 0.1), &[obstacle], 1e-3);
        }
    }
}

#[test]
fn the_field_of_a_whole_scene_is_the_least_clearance() {
    let (_, problem, _) = solved(SHAPES);
    let middle = Vector::new(0.03, 0.09);
    check_field(&frame(middle, 0.3), problem.obstacles(), 1e-3);
}

/// The limits of a scene: 1000 obstacles, 64 vertices.
#[test]
fn the_field_takes_as_many_obstacles_as_a_scene() {
    let ring: Vec<Vector> = (0..64)
        .map(|i| (f64::from(i) * std::f64::consts::TAU / 64.0).sin_cos())
        .map(|(sine, cosine)| Vector::new(0.006 * cosine, 0.004 * sine))
        .collect();
    let core = Core::polygon(&ring).unwrap();
    let obstacles: Vec<Obstacle> = (0..1000)
        .map(|i| {
            let place = Vector::new(f64::from(i % 40) * 0.02, f64::from(i / 40) * 0.02);
            Obstacle::new(core.clone(), 0.001, place, f64::from(i))
        })
        .collect();
    check_field(&frame(Vector::new(0.4, 0.25), 0.8), &obstacles, 1e-3);
}

/// A thousandth of a millimetre across, a kilometre from the origin, beside a
/// disc and a wall: single precision would be off by the whole window.
#[test]
fn the_field_keeps_its_digits_when_zoomed() {
    let at = Vector::new(1000.0, -700.0);
    for core in [Core::Point, Core::HalfPlane, Core::rectangle(0.2, 0.2)] {
        let obstacle = Obstacle::new(core, 0.05, at, 0.3);
        let middle = at
            + obstacle
                .support(Vector::new(0.3f64.cos(), 0.3f64.sin()))
                .map_or(Vector::zeros(), |reach| {
                    let out = Vector::new(0.3f64.cos(), 0.3f64.sin());
                    (reach - out.dot(&at)) * out
                });
        check_field(&frame(middle, 1e-6), &[obstacle], 0.01);
    }
}

#[test]
fn contours_are_a_round_distance_apart() {
    let at = |across| contour_spacing(&frame(Vector::zeros(), across));
    assert_eq!(at(0.3), 0.05);
    assert_eq!(at(0.03), 0.005);
    assert_eq!(at(0.1), 0.02);
}

/// The surface and the lines are drawn where the clearance is a multiple of
/// the spacing, and nowhere else.
#[test]
fn contour_lines_lie_where_they_should() {
    let disc = Obstacle::new(Core::Point, 0.02, Vector::zeros(), 0.0);
    let frame = Frame {
        window: window(400.0, 400.0),
        scale: 2000.0,
        middle: Vector::zeros(),
    };
    let spacing = contour_spacing(&frame) * frame.scale;
    let screen = Offscreen::new();
    for theme in [Theme::Light, Theme::Dark] {
        let image = field_image(&screen, &frame, &[disc.clone()], theme, [0, 0, 0, 0]);
        // Along a row through the centre, outward from the surface.
        let row: Vec<f64> = (241..399).map(|x| f64::from(image.at(x, 200)[3])).collect();
        for (i, alpha) in row.iter().enumerate() {
            let distance = i as f64 + 241.5 - 200.0 - 40.0;
            let nearest = (distance / spacing).round() * spacing;
            let on_line = nearest > 0.0 && (distance - nearest).abs() < 0.51;
            let apart = (distance - nearest).abs() > 2.0;
            let beside = (row[i.saturating_sub(3)] + row[(i + 3).min(row.len() - 1)]) / 2.0;
            if on_line && i > 3 && i + 3 < row.len() && distance < 4.0 * spacing {
                assert!(*alpha > beside + 4.0, "{theme:?} no line at {distance}");
            } else if apart && i > 3 && i + 3 < row.len() {
                assert!(*alpha < beside + 8.0, "{theme:?} a line at {distance}");
            }
        }
        // The surface is the strongest.
        let surface = (238..243).map(|x| image.at(x, 200)[3]).max().unwrap();
        assert!(surface > 160, "{surface}");
    }
}

fn field_image(
    screen: &Offscreen,
    frame: &Frame,
    obstacles: &[Obstacle],
    theme: Theme,
    background: [u8; 4],
) -> Picture<[u8; 4]> {
    let format = eframe::wgpu::TextureFormat::Rgba8Unorm;
    let mut pass = FieldPass::new(&screen.device, format, FieldOutput::Picture);
    let picture = FieldPicture::new(frame.window, frame, obstacles, theme);
    let index = pass.prepare(&screen.device, &screen.queue, &picture, 1.0);
    pass.prepared();
    let size = frame.window.size();
    screen.image(size.x as u32, size.y as u32, background, |target| {
        pass.paint(index, target);
    })
}

#[test]
fn pictures_of_the_field() {
    let screen = Offscreen::new();
    for (name, text) in [("two-discs", TWO_DISCS), ("shapes", SHAPES)] {
        let (scene, problem, solution) = solved(text);
        let drawing = draw(&problem, &solution, &Notes::of(&scene));
        let frame = Frame::fitting(&drawing.bounds, window(1000.0, 900.0));
        for (theme, word) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
            let [r, g, b] = theme.palette().background.rgb;
            let image = field_image(&screen, &frame, problem.obstacles(), theme, [r, g, b, 255]);
            image.save(&format!("render-field-{name}-{word}"));
            let changed = image
                .pixels()
                .filter(|(.., p)| *p != [r, g, b, 255])
                .count();
            assert!(changed > 100_000, "{changed}");
        }
    }
}

// --- The robot in space -----------------------------------------------

fn solid_image(
    screen: &Offscreen,
    picture: &SolidPicture,
    [width, height]: [u32; 2],
    samples: u32,
) -> Picture<[u8; 4]> {
    let format = eframe::wgpu::TextureFormat::Rgba8Unorm;
    let mut pass = SolidPass::new(&screen.device, format, samples);
    let mut encoder = screen.device.create_command_encoder(&Default::default());
    let place = [[0.0; 2], [width as f32, height as f32]];
    let index = pass.prepare(&screen.device, &screen.queue, &mut encoder, picture, place);
    pass.prepared();
    screen.queue.submit([encoder.finish()]);
    screen.image(width, height, [255, 0, 255, 255], |target| {
        pass.paint(index, target);
    })
}

fn solids(text: &str, theme: Theme, aspect: f64) -> SolidPicture {
    let (scene, problem, solution) = solved(text);
    let standing = draw(&problem, &solution, &Notes::of(&scene)).standing;
    let sizes = RobotSizes::of(&scene.robot);
    let mesh = render::mesh(&problem, &solution, &sizes, theme, &standing);
    SolidPicture {
        camera: Camera::fitting(&mesh.focus, aspect),
        mesh: Arc::new(mesh),
        theme,
    }
}

#[test]
fn pictures_of_the_robot() {
    let screen = Offscreen::new();
    for (name, text) in [("two-discs", TWO_DISCS), ("shapes", SHAPES)] {
        for (theme, word) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
            let picture = solids(text, theme, 1.1);
            let image = solid_image(&screen, &picture, [1100, 1000], 4);
            image.save(&format!("render-solid-{name}-{word}"));
        }
    }
}
