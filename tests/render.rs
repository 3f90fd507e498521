//! The graphics processor's pictures: shaders that every backend takes, and
//! renders on a software adapter whose pixels say what they should.
//!
//! `PICTURES=folder cargo test --test render` also writes the pictures there,
//! to be looked at.

mod offscreen;

use std::sync::Arc;

use eframe::egui;
use eframe::egui_wgpu::wgpu::{TextureFormat, naga};
use offscreen::{Offscreen, Picture};
use sinew::equilibrium::{Settings, Solved, Start, solve};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::mechanics::Problem;
use sinew::render::{
    self, Camera, FieldOutput, FieldPass, FieldPicture, SolidPass, SolidPicture, contour_spacing,
};
use sinew::scene::Scene;
use sinew::view::{Bounds, Frame, Notes, Standing, Theme, draw};

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const SHAPES: &str = include_str!("../assets/scenes/shapes.toml");

/// The format of most windows: sRGB, stored as it is given.
const STORED: TextureFormat = TextureFormat::Rgba8Unorm;
/// The format of windows that turn light into sRGB.
const ENCODED: TextureFormat = TextureFormat::Rgba8UnormSrgb;

fn solved(text: &str) -> (Scene, Problem, Solved) {
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
    let format = TextureFormat::R32Float;
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
        let image = field_image(
            &screen,
            &frame,
            std::slice::from_ref(&disc),
            theme,
            [0, 0, 0, 0],
        );
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
    let mut pass = FieldPass::new(&screen.device, STORED, FieldOutput::Picture);
    let picture = FieldPicture::new(frame.window, frame, obstacles, theme);
    let index = pass.prepare(&screen.device, &screen.queue, &picture, 1.0);
    pass.prepared();
    let size = frame.window.size();
    screen.image(
        STORED,
        [size.x as u32, size.y as u32],
        background,
        |target| {
            pass.paint(index, target);
        },
    )
}

#[test]
fn pictures_of_the_field() {
    let screen = Offscreen::new();
    for (name, text) in [("two-discs", TWO_DISCS), ("shapes", SHAPES)] {
        let (scene, problem, solution) = solved(text);
        let drawing = draw(&solution, &Notes::of(&scene));
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
    format: TextureFormat,
    [width, height]: [u32; 2],
    samples: u32,
) -> Picture<[u8; 4]> {
    let mut pass = SolidPass::new(&screen.device, format, samples);
    let mut encoder = screen.device.create_command_encoder(&Default::default());
    let place = [[0.0; 2], [width as f32, height as f32]];
    let index = pass.prepare(&screen.device, &screen.queue, &mut encoder, picture, place);
    pass.prepared();
    screen.queue.submit([encoder.finish()]);
    screen.image(format, [width, height], [255, 0, 255, 255], |target| {
        pass.paint(index, target);
    })
}

fn solids(text: &str, theme: Theme, aspect: f64) -> SolidPicture {
    let (scene, problem, solution) = solved(text);
    let drawing = draw(&solution, &Notes::of(&scene));
    let (standing, scale) = (&drawing.standing, drawing.scale);
    let mesh = render::mesh(&solution, problem.obstacles(), scale, theme, standing);
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
            let image = solid_image(&screen, &picture, STORED, [1100, 1000], 4);
            image.save(&format!("render-solid-{name}-{word}"));
            let mut near = picture.clone();
            near.camera.zoom(3.0);
            near.camera.target += nalgebra::Vector3::new(0.005, 0.035, 0.0);
            let image = solid_image(&screen, &near, STORED, [1100, 1000], 4);
            image.save(&format!("render-solid-near-{name}-{word}"));
        }
    }
}

/// A straight robot beside a post that it does not touch.
const POST: &str = r#"
    version = 2
    model = { mechanics = "equal" }
    robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
    actuation = { pull_mm = 0 }
    [[obstacle]]
    shape = "disc"
    center_mm = [40, 90]
    radius_mm = 12.5
"#;

/// The pixel of a point of the world, in millimetres, and the picture's colour
/// there as red, green, blue.
fn seen(picture: &SolidPicture, image: &Picture<[u8; 4]>, side: u32, at: [f64; 3]) -> [i32; 3] {
    let point = 1e-3 * nalgebra::Vector3::from(at);
    let clip = picture.camera.clip(nalgebra::Vector3::zeros(), 1.0) * point.push(1.0);
    let half = 0.5 * f64::from(side);
    let x = half * (1.0 + clip.x / clip.w);
    let y = half * (1.0 - clip.y / clip.w);
    let [red, green, blue, _] = image.at(x as u32, y as u32);
    [red, green, blue].map(i32::from)
}

fn looking(yaw: f64, pitch: f64) -> SolidPicture {
    let mut picture = solids(POST, Theme::Light, 1.0);
    picture.camera.yaw = yaw;
    picture.camera.pitch = pitch;
    picture
}

/// From the right the post hides the backbone, from the left the backbone is
/// before the post; with one sample a pixel too.
#[test]
fn what_is_in_front_hides_what_is_behind() {
    let screen = Offscreen::new();
    let behind = |yaw: f64, samples: u32| {
        let picture = looking(yaw, 0.0);
        let image = solid_image(&screen, &picture, STORED, [500, 500], samples);
        // Of the backbone, between two disks.
        seen(&picture, &image, 500, [0.0, 90.0, 0.0])[1]
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    for samples in [1, 4] {
        let (hidden, free) = (behind(quarter, samples), behind(-quarter, samples));
        // The post is light, the backbone dark.
        assert!(hidden > free + 60, "{hidden} {free}");
    }
}

/// The post's shadow falls on the board to the lower right, and the board is
/// not drawn from behind.
#[test]
fn shadows_fall_away_from_the_light() {
    let screen = Offscreen::new();
    let picture = looking(0.0, 0.0);
    let image = solid_image(&screen, &picture, STORED, [500, 500], 4);
    // On the board, as far from the post's middle on either side.
    let board = |aside: f64| {
        let around = [-2.5, 0.0, 2.5].map(|more| {
            let at = [40.0 + aside + more, 90.0 - 1.47 * aside + more, -15.2];
            seen(&picture, &image, 500, at)[1]
        });
        around.into_iter().max().unwrap()
    };
    let (shade, light) = (board(11.5), board(-11.5));
    assert!(shade + 15 < light, "{shade} {light}");
    let back = looking(std::f64::consts::PI, 0.0);
    let image = solid_image(&screen, &back, STORED, [500, 500], 4);
    let [node, beside] = [0.0, 4.0].map(|x| seen(&back, &image, 500, [x, 90.0, 0.0])[1]);
    assert!(node + 60 < beside, "{node} {beside}");
}

/// Pixels of the contacts' colours: much red, little blue.
fn warm(image: &Picture<[u8; 4]>) -> usize {
    let warm =
        |[red, green, blue, _]: [u8; 4]| i32::from(red) > i32::from(blue) + 60 && red >= green;
    image.pixels().filter(|(.., pixel)| warm(*pixel)).count()
}

#[test]
fn contacts_glow_and_grey_shapes_do_not() {
    let screen = Offscreen::new();
    let (_, problem, solution) = solved(TWO_DISCS);
    for theme in [Theme::Light, Theme::Dark] {
        let certified = solids(TWO_DISCS, theme, 1.0);
        let image = solid_image(&screen, &certified, STORED, [500, 500], 4);
        let glowing = warm(&image);
        assert!(glowing > 800, "{glowing}");
        let contact = &solution.contacts[0];
        let node = solution.nodes[contact.node];
        // On the pressing disk's rim towards the viewer.
        let rim = 1e3 * node.position;
        let found = seen(&certified, &image, 500, [rim.x, rim.y, 8.0]);
        assert!(found[0] > found[2] + 60, "{found:?}");
        let greyed = Standing::Greyed {
            what: "Unfinished",
            reason: String::new(),
        };
        let (scene, ..) = solved(TWO_DISCS);
        let scale = draw(&solution, &Notes::of(&scene)).scale;
        let mesh = render::mesh(&solution, problem.obstacles(), scale, theme, &greyed);
        let grey = SolidPicture {
            mesh: Arc::new(mesh),
            ..certified
        };
        let image = solid_image(&screen, &grey, STORED, [500, 500], 4);
        assert_eq!(warm(&image), 0);
    }
}

/// A window that turns light into sRGB shows the same picture as one that
/// takes sRGB.
#[test]
fn pictures_do_not_depend_on_the_window_s_format() {
    let screen = Offscreen::new();
    let picture = solids(SHAPES, Theme::Dark, 1.5);
    let [stored, encoded] =
        [STORED, ENCODED].map(|format| solid_image(&screen, &picture, format, [300, 200], 4));
    for ((x, y, a), (.., b)) in stored.pixels().zip(encoded.pixels()) {
        let off = a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max();
        assert!(off <= Some(1), "{a:?} {b:?} at {x}, {y}");
    }
}

// --- In the window -----------------------------------------------------

/// Two views in space and a field, side by side.
struct Views {
    installed: bool,
}

impl eframe::App for Views {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let theme = Theme::Light;
        let left = solids(TWO_DISCS, theme, 1.0);
        let right = solids(SHAPES, theme, 1.0);
        let (_, problem, _) = solved(SHAPES);
        let square = |i: usize| {
            let corner = egui::pos2(10.0 + 110.0 * i as f32, 10.0);
            egui::Rect::from_min_size(corner, egui::vec2(100.0, 100.0))
        };
        let frame = Frame {
            window: Bounds {
                least: Vector::new(230.0, 10.0),
                most: Vector::new(330.0, 110.0),
            },
            scale: 400.0,
            middle: Vector::new(0.03, 0.09),
        };
        let painter = ui.painter();
        painter.add(render::solid_callback(
            square(0),
            left.mesh,
            left.camera,
            theme,
        ));
        painter.add(render::solid_callback(
            square(1),
            right.mesh,
            right.camera,
            theme,
        ));
        let field = render::field_callback(square(2), &frame, problem.obstacles(), theme);
        painter.add(field);
    }
}

fn views(installed: bool) -> image::RgbaImage {
    let mut harness = egui_kittest::Harness::builder()
        .with_size(egui::vec2(340.0, 120.0))
        .with_pixels_per_point(1.5)
        .with_theme(egui::Theme::Light)
        .wgpu()
        .build_eframe(|cc| {
            if let Some(state) = cc.wgpu_render_state.as_ref().filter(|_| installed) {
                render::install(state);
            }
            Views { installed }
        });
    harness.run();
    assert_eq!(harness.state().installed, installed);
    harness.render().unwrap()
}

#[test]
fn the_window_shows_every_view_in_its_place() {
    let image = views(true);
    let screen = Offscreen::new();
    for (i, text) in [TWO_DISCS, SHAPES].into_iter().enumerate() {
        let picture = solids(text, Theme::Light, 1.0);
        let expected = solid_image(&screen, &picture, STORED, [150, 150], 4);
        for (x, y, pixel) in expected.pixels() {
            let found = image.get_pixel(15 + 165 * i as u32 + x, 15 + y).0;
            assert_eq!(found, pixel, "view {i} at {x}, {y}");
        }
    }
    let field = (0..150).flat_map(|y| (0..150).map(move |x| (345 + x, 15 + y)));
    let bare = image.get_pixel(500, 175);
    let drawn = field
        .filter(|(x, y)| image.get_pixel(*x, *y) != bare)
        .count();
    assert!(drawn > 5000, "{drawn}");
}

#[test]
fn without_the_passes_nothing_is_drawn() {
    let image = views(false);
    let bare = image.get_pixel(0, 0);
    assert!(image.pixels().all(|pixel| pixel == bare));
}

// --- Shaders -----------------------------------------------------------

/// Every shader is valid, has a Rust file of its name, and every entry point
/// of it can be written for WebGL 2.
#[test]
fn every_shader_is_valid_on_every_backend() {
    use naga::back::glsl;
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut entries = 0;
    for file in std::fs::read_dir(root.join("shaders")).unwrap() {
        let path = file.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let rust = root.join("src/render").join(format!("{name}.rs"));
        let rust = std::fs::read_to_string(rust).unwrap_or_else(|_| panic!("{name} has no file"));
        assert!(
            rust.contains(&format!("/shaders/{name}.wgsl\"")),
            "{name}.rs"
        );
        let text = std::fs::read_to_string(&path).unwrap();
        let module = naga::front::wgsl::parse_str(&text)
            .unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
        // No capability beyond the least.
        let mut validator = naga::valid::Validator::new(
            naga::valid::ValidationFlags::all(),
            naga::valid::Capabilities::empty(),
        );
        let info = validator.validate(&module).unwrap();
        for entry in &module.entry_points {
            let options = glsl::Options {
                version: glsl::Version::Embedded {
                    version: 300,
                    is_webgl: true,
                },
                ..glsl::Options::default()
            };
            let pipeline = glsl::PipelineOptions {
                shader_stage: entry.stage,
                entry_point: entry.name.clone(),
                multiview: None,
            };
            let mut output = String::new();
            let policies = naga::proc::BoundsCheckPolicies::default();
            let written =
                glsl::Writer::new(&mut output, &module, &info, &options, &pipeline, policies);
            written.unwrap().write().unwrap();
            assert!(output.starts_with("#version 300 es"));
            entries += 1;
        }
    }
    assert!(entries >= 10, "{entries}");
}

/// Everything works within the least that a browser without WebGPU offers.
#[test]
fn the_passes_stay_within_webgl_limits() {
    let screen = Offscreen::within(eframe::wgpu::Limits::downlevel_webgl2_defaults());
    let picture = solids(TWO_DISCS, Theme::Light, 1.0);
    let image = solid_image(&screen, &picture, STORED, [200, 200], 4);
    assert!(warm(&image) > 100, "{}", warm(&image));
    let (_, problem, _) = solved(SHAPES);
    let frame = frame(Vector::new(0.03, 0.09), 0.3);
    let image = field_image(&screen, &frame, problem.obstacles(), Theme::Dark, [0; 4]);
    assert!(image.pixels().any(|(.., pixel)| pixel[3] > 0));
}
