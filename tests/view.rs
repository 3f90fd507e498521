//! Drawings and their SVG: snapshots of what is drawn where, and properties.
//!
//! The snapshots are text files in tests/cases/view, with lengths rounded to
//! 0.001 mm. `UPDATE_SNAPSHOTS=1 cargo test --test view` rewrites them.

use std::fmt::Write;
use std::path::PathBuf;

use sinew::contact::Class;
use sinew::equilibrium::{EndReason, Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::mechanics::{Condition, Problem};
use sinew::report::svg::{self, Size};
use sinew::robot::PlanarNode;
use sinew::scene::Scene;
use sinew::view::{
    Drawing, Frame, Geometry, LabelText, Mark, Notes, Path, Piece, Quantity, Role, Spot, Standing,
    Theme, draw, draw_on_the_way, place_labels,
};

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const SHAPES: &str = include_str!("../assets/scenes/shapes.toml");
const BODY: &str = include_str!("../assets/scenes/body-contact.toml");
const LOAD_CELL: &str = include_str!("../assets/scenes/load-cell.toml");
const FREE: &str = include_str!("../assets/scenes/free.toml");

/// Two cables that slide, one of them slack, and a rim on a disc.
const ANTAGONISTS: &str = "version = 2
title = \"Antagonists\"
robot = { length_mm = 180, segments = 18, bending_stiffness_nmm2 = 8000, disk_radius_mm = 10 }
cable = [{ offset_mm = 8, pull_mm = 7.5 }, { offset_mm = -8, pull_mm = -9, to_disk = 6 }]
contact = { candidates = \"body\" }
obstacle = [{ name = \"upper\", shape = \"disc\", center_mm = [75, 140], radius_mm = 12.5 }]
";

const SIZE: Size = Size {
    width: 640.0,
    height: 720.0,
};

fn solved(text: &str) -> (Problem, Solved, Notes) {
    let scene = Scene::from_toml(text).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    (problem, solution, Notes::of(&scene))
}

fn drawn(text: &str) -> Drawing {
    let (problem, solution, notes) = solved(text);
    draw_on_the_way(&solution, &problem, &notes)
}

// --- Snapshots ---------------------------------------------------------

/// Coordinates in millimetres, rounded to 0.001 mm: the solver is exact to
/// about 1e-10 mm.
fn mm(point: Vector) -> String {
    let shown = |value: f64| {
        let rounded = (value * 1e6).round() / 1e3;
        format!("{:.3}", rounded + 0.0)
    };
    format!("({}, {})", shown(point.x), shown(point.y))
}

fn path_text(path: &Path) -> String {
    let mut text = mm(path.start);
    for piece in &path.pieces {
        match piece {
            Piece::Line { to } => write!(text, " – {}", mm(*to)).unwrap(),
            Piece::Arc { centre, to, sweep } => {
                let degrees = sweep.to_degrees();
                write!(
                    text,
                    " ⌒ {} about {} by {degrees:.2}°",
                    mm(*to),
                    mm(*centre)
                )
                .unwrap();
            }
        }
    }
    if path.closed {
        text.push_str(" closed");
    }
    text
}

fn snapshot(drawing: &Drawing) -> String {
    let mut text = String::new();
    let out = &mut text;
    let bounds = drawing.bounds;
    writeln!(out, "bounds {} to {}", mm(bounds.least), mm(bounds.most)).unwrap();
    writeln!(
        out,
        "grid {} mm, scale bar {} mm",
        drawing.grid * 1e3,
        drawing.scale_bar * 1e3
    )
    .unwrap();
    writeln!(out, "title {:?}", drawing.caption.title).unwrap();
    for fact in &drawing.caption.facts {
        writeln!(out, "fact {} {}", fact.name, fact.value.text()).unwrap();
    }
    if let Some(note) = &drawing.caption.note {
        writeln!(out, "note {note}").unwrap();
    }
    match &drawing.standing {
        Standing::Certified => writeln!(out, "certified").unwrap(),
        Standing::Greyed { what, reason } => writeln!(out, "greyed {what}: {reason}").unwrap(),
    }
    if drawing.presses {
        let (what, end) = (drawing.scale.what(), drawing.scale.end_written());
        writeln!(out, "scale of {what} to {}", end.text()).unwrap();
    }
    for mark in &drawing.marks {
        let role = format!("{:?}", mark.role);
        // Shares are ratios of multipliers, good to about 1e-9.
        let role = match mark.role {
            sinew::view::Role::Force(share) => format!("Force({share:.4})"),
            Role::Friction(share) => format!("Friction({share:.4})"),
            Role::Cone { share, slides } => {
                format!(
                    "Cone({share:.4}, {})",
                    if slides { "slides" } else { "sticks" }
                )
            }
            sinew::view::Role::TouchedDisk(share) => format!("TouchedDisk({share:.4})"),
            sinew::view::Role::Contact { share, class } => {
                format!("Contact({share:.4}, {})", class.word())
            }
            _ => role,
        };
        let geometry = match &mark.geometry {
            Geometry::Path(path) => path_text(path),
            Geometry::HalfPlane { point, normal } => {
                format!(
                    "behind {} facing {:.4} {:.4}",
                    mm(*point),
                    normal.x,
                    normal.y
                )
            }
            Geometry::Dot(point) => mm(*point),
            Geometry::Arrow { tail, tip } => format!("{} → {}", mm(*tail), mm(*tip)),
        };
        write!(out, "{role} {geometry}").unwrap();
        if mark.thickness > 0.0 {
            write!(out, " thick {:.3}", mark.thickness * 1e3).unwrap();
        }
        writeln!(out).unwrap();
    }
    for label in &drawing.labels {
        let words = match &label.text {
            LabelText::Value(value) => value.text(),
            LabelText::Name(name) => format!("{name:?}"),
        };
        let spot = match label.spot {
            Spot::Beyond { point, .. } => format!("beyond {}", mm(point)),
            Spot::Inside(extent) => format!("inside {} to {}", mm(extent.least), mm(extent.most)),
        };
        writeln!(out, "label {words} {spot}").unwrap();
    }
    text
}

#[track_caller]
fn check_snapshot(name: &str, drawing: &Drawing) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/cases/view")
        .join(format!("{name}.txt"));
    let found = snapshot(drawing);
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        std::fs::write(&file, &found).unwrap();
        return;
    }
    let expected = std::fs::read_to_string(&file)
        .unwrap()
        .replace("\r\n", "\n");
    for (line, (found, expected)) in found.lines().zip(expected.lines()).enumerate() {
        assert_eq!(found, expected, "{name}, line {}", line + 1);
    }
    assert_eq!(found.lines().count(), expected.lines().count(), "{name}");
}

#[test]
fn snapshots() {
    check_snapshot("two-discs", &drawn(TWO_DISCS));
    check_snapshot("shapes", &drawn(SHAPES));
    check_snapshot("body-contact", &drawn(BODY));
    check_snapshot("load-cell", &drawn(LOAD_CELL));
    check_snapshot("antagonists", &drawn(ANTAGONISTS));
    check_snapshot("friction", &drawn(&rubbing()));
}

/// Two posts on which the robot rubs, and its cable in its holes.
fn rubbing() -> String {
    let posts = include_str!("../assets/scenes/two-posts.toml");
    format!("{posts}\n[friction]\nholes = 0.275\ncontacts = 0.275\nbase_loss = 0.165\n")
}

#[test]
fn what_an_obstacle_exerts_is_on_the_edge_of_its_cone_where_the_robot_slides() {
    let (_, solution, notes) = solved(&rubbing());
    let drawing = draw(&solution, &notes);
    let of = |wanted: fn(&Role) -> bool| {
        let marks = drawing.marks.iter().filter(|mark| wanted(&mark.role));
        marks.collect::<Vec<_>>()
    };
    let cones = of(|role| matches!(role, Role::Cone { .. }));
    let along = of(|role| matches!(role, Role::Friction(_)));
    let against = of(|role| matches!(role, Role::Force(_)));
    assert_eq!((cones.len(), along.len(), against.len()), (2, 2, 2));
    let ends = |mark: &Mark| match mark.geometry {
        Geometry::Arrow { tail, tip } => (tail, tip - tail),
        _ => panic!("{mark:?}"),
    };
    for ((cone, along), against) in cones.iter().zip(&along).zip(&against) {
        let Geometry::Path(path) = &cone.geometry else {
            panic!("{cone:?}");
        };
        let ((at, friction), (from, normal)) = (ends(along), ends(against));
        assert_eq!((path.start, at), (from, from));
        let bound = 0.275 * normal.norm();
        assert!(friction.dot(&normal).abs() < 1e-12 * bound * normal.norm());
        let slides = matches!(cone.role, Role::Cone { slides: true, .. });
        assert!(friction.norm() <= bound * (1.0 + 1e-6), "{friction:?}");
        assert_eq!(slides, friction.norm() > bound * (1.0 - 1e-6));
        // The sum of both points to the edge.
        let edge = path.flattened(1e-6)[1..].iter().any(|end| {
            let (a, b) = ((end - from).normalize(), (normal + friction).normalize());
            (a - b).norm() < 1e-6
        });
        assert_eq!(edge, slides);
    }
}

// --- Properties --------------------------------------------------------

/// The mirror image of the world in the y axis.
fn mirrored(point: Vector) -> Vector {
    Vector::new(-point.x, point.y)
}

fn mirrored_problem(problem: &Problem) -> Problem {
    let turn = |angle: f64| std::f64::consts::PI - angle;
    let obstacles = problem.obstacles().iter().map(|obstacle| {
        // The frame's x axis is mirrored; y then turns round in the frame.
        let core = match obstacle.core() {
            Core::Vertices(vertices) if vertices.len() > 2 => {
                let turned: Vec<Vector> = vertices.iter().map(|v| Vector::new(v.x, -v.y)).collect();
                Core::polygon(&turned).unwrap()
            }
            core => core.clone(),
        };
        let at = mirrored(obstacle.position());
        Obstacle::new(core, obstacle.radius(), at, turn(obstacle.angle()))
    });
    let mut robot = *problem.robot();
    robot.base = mirrored_node(&robot.base);
    let candidates = problem.candidates().to_vec();
    Problem::from_parts(robot, problem.pull(), candidates, obstacles.collect())
}

fn mirrored_node(node: &PlanarNode) -> PlanarNode {
    PlanarNode {
        position: mirrored(node.position),
        disk: mirrored(node.disk),
        angle: std::f64::consts::PI - node.angle,
    }
}

/// The points of a drawing's marks, with each mark's role in a word.
fn points(drawing: &Drawing) -> Vec<(&'static str, Vec<Vector>)> {
    let of = |mark: &sinew::view::Mark| match &mark.geometry {
        Geometry::HalfPlane { point, normal } => vec![*point, point + 0.01 * normal],
        geometry => geometry.points(1e-5, &drawing.bounds),
    };
    drawing
        .marks
        .iter()
        .map(|mark| (mark.role.word(), of(mark)))
        .collect()
}

#[test]
fn a_mirrored_scene_has_a_mirrored_drawing() {
    for text in [TWO_DISCS, SHAPES, BODY, LOAD_CELL] {
        let (problem, solution, notes) = solved(text);
        let mut image = solution.solution().clone();
        image.nodes = solution.nodes.iter().map(mirrored_node).collect();
        for contact in &mut image.contacts {
            contact.point = mirrored(contact.point);
            contact.normal = mirrored(contact.normal);
        }
        let here = draw(&solution, &notes);
        let image = Solved::pair(mirrored_problem(&problem), image).unwrap();
        let there = draw(&image, &notes);
        // 1e-12 m is rounding of the obstacles' turned frames.
        let near = |a: Vector, b: Vector| (a - b).norm() < 1e-12;
        assert!(near(
            mirrored(here.bounds.least).inf(&mirrored(here.bounds.most)),
            there.bounds.least
        ));
        assert!(near(
            mirrored(here.bounds.least).sup(&mirrored(here.bounds.most)),
            there.bounds.most
        ));
        assert_eq!((here.grid, here.scale_bar), (there.grid, there.scale_bar));
        assert_eq!(
            (&here.scale, &here.standing),
            (&there.scale, &there.standing)
        );
        let (here, there) = (points(&here), points(&there));
        assert_eq!(here.len(), there.len());
        let mut free: Vec<_> = there.iter().collect();
        for (word, here) in &here {
            let image: Vec<Vector> = here.iter().copied().map(mirrored).collect();
            // Outlines run the other way round and hatching slants the other
            // way, but every point has its image nearby: arcs to within their
            // tolerance, the feet of strokes on each other.
            let matches = |(other, points): &&(&str, Vec<Vector>)| {
                let tolerance = match *word {
                    "obstacle" => 1e-3,
                    "base-hatch" => 8e-3,
                    _ => 1e-12,
                };
                let close =
                    |a: &Vector, set: &[Vector]| set.iter().any(|b| (a - b).norm() <= tolerance);
                other == word
                    && image.iter().all(|a| close(a, points))
                    && points.iter().all(|b| close(b, &image))
            };
            let found = free.iter().position(matches);
            let found = found.unwrap_or_else(|| panic!("no image of a {word}: {image:?}"));
            free.remove(found);
        }
    }
}

#[test]
fn steps_and_bars_are_1_2_or_5() {
    for factor in [1e-3, 0.3, 1.0, 7.0, 1e3] {
        let scaled = FREE
            .replace(
                "length_mm = 180",
                &format!("length_mm = {}", 180.0 * factor),
            )
            .replace("offset_mm = 8", &format!("offset_mm = {}", 8.0 * factor))
            .replace("pull_mm = 10", &format!("pull_mm = {}", 10.0 * factor));
        let scene = Scene::from_toml(&scaled).unwrap();
        let Ok(problem) = Problem::new(&scene) else {
            continue;
        };
        let solution = solve(&problem, Start::Direct, Settings::default());
        let drawing = draw(&solution, &Notes::of(&scene));
        for length in [drawing.grid, drawing.scale_bar] {
            let digits = format!("{length:e}");
            assert!(matches!(&digits[..2], "1e" | "2e" | "5e"), "{digits}");
        }
        let size = drawing.bounds.size();
        assert!(drawing.scale_bar < size.x.max(size.y) / 2.0);
    }
}

#[test]
fn what_is_not_certified_is_greyed_with_its_reason() {
    let (problem, solution, notes) = solved(TWO_DISCS);
    let check = |edit: &dyn Fn(&mut Solution), expected: &str| {
        let mut solution = solution.solution().clone();
        edit(&mut solution);
        let solution = Solved::pair(problem.clone(), solution).unwrap();
        let drawing = draw(&solution, &notes);
        let Standing::Greyed { reason, .. } = &drawing.standing else {
            panic!("not greyed");
        };
        assert_eq!(reason, expected);
        let picture = svg::render(&drawing, Theme::Light, SIZE);
        let ink = "#1c2430";
        assert!(!picture.contains(ink), "the backbone is not grey");
        assert!(picture.contains("class=\"warning\""));
    };
    let ended = Status::BranchEnded {
        reason: EndReason::Fold,
        segment: 12,
    };
    check(
        &|s| s.status = ended.clone(),
        "the branch ends at segment 12: the equilibrium folds back and the robot slips away",
    );
    check(
        &|s| s.certificate.set(Condition::Stationarity, 2.5e-4),
        "not certified: the optimality residual is 2.50×10⁻⁴, over 1.00×10⁻⁹",
    );
    check(
        &|s| s.certificate.set(Condition::Minimum, false),
        "not certified: the shape is balanced but not a minimum of the energy",
    );
}

#[test]
fn labels_cover_neither_each_other_nor_the_edge() {
    for text in [TWO_DISCS, SHAPES, BODY, LOAD_CELL] {
        let drawing = drawn(text);
        for width in [260.0, 480.0, 1200.0] {
            let window = sinew::view::Bounds {
                least: Vector::zeros(),
                most: Vector::new(width, 1.2 * width),
            };
            let frame = Frame::fitting(&drawing.bounds, window);
            let measure = |text: &LabelText| match text {
                LabelText::Value(value) => Vector::new(7.0 * value.text().len() as f64, 14.0),
                LabelText::Name(name) => Vector::new(7.0 * name.len() as f64, 14.0),
            };
            let placed = place_labels(&drawing, &frame, measure);
            for (i, a) in placed.iter().enumerate() {
                assert_eq!(a.area.within(window), a.area);
                for b in &placed[i + 1..] {
                    assert!(a.area.within(b.area).is_empty(), "{text}");
                }
            }
            assert!(width < 480.0 || placed.len() == drawing.labels.len());
        }
    }
}

// --- SVG ---------------------------------------------------------------

/// Parses a picture and checks what holds of every picture.
#[track_caller]
fn well_formed(picture: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(picture).unwrap();
    assert_eq!(document.root_element().tag_name().name(), "svg");
    for word in ["NaN", "inf"] {
        let attribute =
            |node: roxmltree::Node<'_, '_>| node.attributes().any(|a| a.value().contains(word));
        assert!(!document.descendants().any(attribute), "{word}");
    }
    // The drawing itself is in the clipped group.
    let clipped = document
        .descendants()
        .find(|node| node.attribute("clip-path") == Some("url(#window)"));
    let clipped = clipped.expect("a clipped group");
    for node in document.descendants() {
        let class = node.attribute("class").unwrap_or("");
        if class.split(' ').any(|word| word == "obstacle") {
            assert!(
                node.ancestors().any(|a| a == clipped),
                "{class} is not clipped"
            );
        }
    }
    let texts = document.descendants().filter(|n| n.is_text());
    texts
        .map(|n| n.text().unwrap_or("").trim().to_owned())
        .collect()
}

#[test]
fn pictures_are_well_formed_in_both_themes() {
    for text in [TWO_DISCS, SHAPES, BODY, LOAD_CELL, FREE] {
        let drawing = drawn(text);
        for size in [SIZE, Size::suiting(&drawing)] {
            let day = svg::render(&drawing, Theme::Light, size);
            let night = svg::render(&drawing, Theme::Dark, size);
            assert_eq!(well_formed(&day), well_formed(&night));
            assert!(day.contains("#fafaf7") && !day.contains("#15171c"));
            assert!(night.contains("#15171c") && !night.contains("#fafaf7"));
            let both = svg::render_adaptive(&drawing, size);
            well_formed(&both);
            assert!(both.contains("prefers-color-scheme"));
            assert_eq!(both, svg::render_adaptive(&drawing, size));
        }
    }
}

#[test]
fn titles_and_names_are_escaped() {
    let (_, solution, mut notes) = solved(TWO_DISCS);
    notes.title = Some("a <&> \"b\" 'c' \u{1}\u{1b}]]>".to_owned());
    notes.names[0] = Some("<&>".to_owned());
    let drawing = draw(&solution, &notes);
    let texts = well_formed(&svg::render(&drawing, Theme::Light, SIZE));
    let title = "a <&> \"b\" 'c' \u{fffd}\u{fffd}]]>".to_owned();
    assert!(texts.contains(&title), "{texts:?}");
    assert!(texts.contains(&"<&>".to_owned()), "{texts:?}");
}

#[test]
fn odd_pictures_are_still_pictures() {
    let (problem, solution, mut notes) = solved(SHAPES);
    notes.title = Some("very ".repeat(200));
    notes.tip_trace = vec![Vector::new(f64::NAN, 0.0), Vector::new(0.1, 0.1)];
    let mut broken = solution.solution().clone();
    broken.nodes[3].position.x = f64::NAN;
    broken.status = Status::NumericalFailure;
    let broken = Solved::pair(problem.clone(), broken).unwrap();
    for solution in [solution, Solved::unsolved(problem), broken] {
        let drawing = draw(&solution, &notes);
        for (width, height) in [(0.0, -1.0), (f64::NAN, f64::INFINITY), (200.0, 2000.0)] {
            well_formed(&svg::render(&drawing, Theme::Dark, Size { width, height }));
        }
    }
}

#[test]
fn a_grazing_contact_has_a_ring_and_no_number() {
    let (problem, solution, notes) = solved(TWO_DISCS);
    let mut solution = solution.into_solution();
    solution.contacts[0].class = Class::Grazing;
    solution.contacts[0].multiplier = 0.0;
    let solution = Solved::pair(problem.clone(), solution).unwrap();
    let drawing = draw(&solution, &notes);
    let values = drawing
        .labels
        .iter()
        .filter(|l| matches!(l.text, LabelText::Value(_)));
    assert_eq!(values.count(), 1);
    let picture = svg::render(&drawing, Theme::Light, SIZE);
    assert_eq!(picture.matches("class=\"ring\"").count(), 2);
    assert_eq!(picture.matches("class=\"force\"").count(), 1);
    let multiplier = solution.contacts[1].multiplier;
    let grams = sinew::units::grams(notes.stiffness.unwrap().per_bend(&problem) * multiplier);
    let scale = drawing.scale;
    assert_eq!(scale.what(), "contact force");
    assert!(
        scale.end() >= grams && scale.end() <= 2.5 * grams.max(0.1),
        "{scale:?}"
    );
    assert_eq!(scale.written(multiplier), Quantity::significant(grams, "g"));

    let unknown = Notes {
        stiffness: None,
        ..notes
    };
    let scale = draw(&solution, &unknown).scale;
    assert_eq!(scale.what(), "contact multiplier");
    let expected = Quantity::significant(multiplier * 1e-3, "rad²/mm");
    assert_eq!(scale.written(multiplier), expected);
}

#[cfg(feature = "cli")]
#[test]
fn a_png_has_its_size_and_its_text() {
    use sinew::report::png;
    let mut drawing = drawn(TWO_DISCS);
    let size = |bytes: &[u8]| {
        assert_eq!(&bytes[1..4], b"PNG");
        let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
        (side(16), side(20))
    };
    let titled = png::render(&drawing, Theme::Light, SIZE, 1.5).unwrap();
    assert_eq!(size(&titled), (960, 1080));
    // The embedded font draws the title: another one is another picture.
    drawing.caption.title = Some("Other title here".to_owned());
    assert_ne!(
        titled,
        png::render(&drawing, Theme::Light, SIZE, 1.5).unwrap()
    );
    let refused = png::render(&drawing, Theme::Light, SIZE, 1e6).unwrap_err();
    assert!(refused.to_string().contains("choose a size"), "{refused}");
    assert!(png::render(&drawing, Theme::Light, SIZE, f64::NAN).is_err());
}
