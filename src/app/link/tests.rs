//! What becomes of links, good, cut, damaged and hostile.

use proptest::prelude::*;

use super::*;
use crate::scene::{Measurements, Obstacle, Photo, Shape};

const TWO_DISCS: &str = include_str!("../../../assets/scenes/two-discs.toml");
const FULL: &str = include_str!("../../../tests/cases/scene/full.toml");
const CABLES: &str = include_str!("../../../tests/cases/scene/cables.toml");

fn scene(text: &str) -> Scene {
    Scene::from_toml(text).unwrap()
}

/// A link with this text in it, whatever the text is.
fn link_of(text: &[u8]) -> String {
    format!("#s1.{}", LETTERS.encode(deflated(text).unwrap()))
}

#[track_caller]
fn check_refused(link: &str, expected: &str) {
    assert_eq!(decode(link).unwrap_err().to_string(), expected);
}

#[test]
fn scenes_come_back_without_their_photograph() {
    for text in [TWO_DISCS, FULL, CABLES] {
        let sent = scene(text);
        let link = encode(&sent).unwrap();
        let expected = Scene {
            photo: None,
            ..sent
        };
        assert_eq!(decode(&link), Ok(expected));
    }
    assert_eq!(
        decode(&encode(&Scene::default()).unwrap()),
        Ok(Scene::default())
    );
}

#[test]
fn the_papers_scene_makes_a_short_link() {
    let link = encode(&scene(TWO_DISCS)).unwrap();
    assert!(link.len() < 400, "{}: {link}", link.len());
    let unreserved = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    assert!(link[1..].chars().all(unreserved), "{link}");
    assert!(link.starts_with("#s1."));
}

#[test]
fn links_written_once_can_be_read_for_ever() {
    let sent = "#s1.fY5BCoMwEEX3c4rgqgURrQq66LYn6E5Eoo4aiEYyk3r9plrooqXLz_vz_rBijeIqgvtmRK-oI3G6qTESWXsO4IGWlFk8TwAq2bGT7HMNq9O6mWcPsqj0qDItsew01jV0uDDag1ZpGoqirGGR8z6jzYY2ACt75ejoJJcoB5rkuhdePwT_jHkZiiSLP0q3rl_KH0JrWsPeJVuNjRkGQj7KBWhcRp7ep0UMhOPsJ2mP8AQ";
    // As it was then, without a stiffness.
    let mut then = scene(TWO_DISCS);
    then.robot.bending_stiffness_nmm2 = None;
    assert_eq!(decode(sent), Ok(then));
}

#[test]
fn a_link_may_be_pasted_in_every_form() {
    let sent = scene(TWO_DISCS);
    let link = encode(&sent).unwrap();
    for form in [
        format!("https://example.org/sinew/?theme=dark{link}"),
        link[1..].to_owned(),
        format!(" \t{link}\r\n"),
        format!("\n{} ", &link[1..]),
    ] {
        assert_eq!(decode(&form), Ok(sent.clone()), "{form}");
    }
}

#[test]
fn what_is_no_link_is_told() {
    let no_scene =
        "this is no link to a scene; one ends in #s1. and many letters and digits: copy all of it";
    for text in [
        "",
        "#",
        "hello",
        "https://example.org/",
        "https://example.org/#about",
        "#s",
        "#s.AAAA",
        "#s1AAAA",
        "#s1x.AAAA",
        "#S1.AAAA",
        "#s9999999999.AAAA",
        "å",
    ] {
        check_refused(text, no_scene);
    }
    for version in ["2", "0", "12", "01"] {
        check_refused(
            &format!("#s{version}.AAAA"),
            &format!(
                "the link is of version {version}, and this program reads version 1; open it with a newer one"
            ),
        );
    }
}

#[test]
fn damage_is_told_where_it_shows() {
    let mut link = encode(&scene(TWO_DISCS)).unwrap();
    link.replace_range(20..21, "!");
    check_refused(
        &link,
        "character 20 after the # is '!', which no link to a scene has; copy the link again",
    );
    link.replace_range(20..21, "å");
    check_refused(
        &link,
        "character 20 after the # is 'å', which no link to a scene has; copy the link again",
    );
    // The third kind of block, which there is not.
    check_refused("#s1.____", "the link is damaged; copy it again");
    let packed = [deflated(TWO_DISCS.as_bytes()).unwrap(), vec![0; 3]].concat();
    let tail = format!("#s1.{}", LETTERS.encode(packed));
    check_refused(&tail, "the link is damaged; copy it again");
}

#[test]
fn a_link_cut_anywhere_is_refused() {
    for text in [TWO_DISCS, FULL] {
        let link = encode(&scene(text)).unwrap();
        for end in 0..link.len() {
            let error = decode(&link[..end]).unwrap_err();
            let fitting = match error {
                LinkError::NoScene => end < 3,
                LinkError::Cut => end >= 3,
                _ => false,
            };
            assert!(fitting, "cut at {end}: {error}");
        }
    }
}

#[test]
fn the_scene_in_a_link_is_checked() {
    check_refused(
        &link_of(TWO_DISCS.replace("pull_mm", "pul_mm").as_bytes()),
        "the scene of the link is at fault: actuation.pul_mm is not a key of a scene; did you mean `pull_mm`?",
    );
    check_refused(
        &link_of(TWO_DISCS.replace("4.9", "nan").as_bytes()),
        "the scene of the link is at fault: actuation.pull_mm is nan, not a number; set it to a value from -100000 to 100000 mm",
    );
    check_refused(
        &link_of(b"\xff"),
        "the scene of the link is at fault: the file is not UTF-8 text (first at byte 0); a scene is a TOML text file",
    );
    let mut faulty = scene(TWO_DISCS);
    faulty.robot.length_mm = f64::NAN;
    assert_eq!(
        encode(&faulty),
        Err(LinkError::Scene(faulty.check().unwrap_err()))
    );
}

#[test]
fn bombs_are_refused() {
    // Five megabytes of nothing pack into few letters.
    let bomb = link_of(&vec![b' '; 5 << 20]);
    assert!(bomb.len() < MAX_CHARACTERS);
    check_refused(
        &bomb,
        "the link unpacks to more than 131072 bytes, which no link to a scene does",
    );
    let most = format!(
        "{TWO_DISCS}{}",
        " ".repeat(MAX_TEXT_BYTES - TWO_DISCS.len())
    );
    assert_eq!(decode(&link_of(most.as_bytes())), Ok(scene(TWO_DISCS)));
    assert_eq!(
        decode(&link_of(format!("{most} ").as_bytes())),
        Err(LinkError::Bomb)
    );
    let deep = link_of(format!("title = {}", "[".repeat(100_000)).as_bytes());
    assert_eq!(decode(&deep), Err(LinkError::Scene(SceneError::TooDeep)));
    check_refused(
        &format!("#s1.{}", "A".repeat(20_000_000)),
        "the link has 20000003 characters after its #; one to a scene has at most 8000",
    );
}

/// A scene with many obstacles that do not repeat themselves.
fn crowded(count: usize) -> Scene {
    let disc = |i: usize| Shape::Disc {
        center_mm: [200.0 + (i as f64).sin(), (i as f64).cos()],
        radius_mm: 1.0,
    };
    Scene {
        obstacles: (0..count).map(|i| Obstacle::from(disc(i))).collect(),
        ..Scene::default()
    }
}

#[test]
fn what_does_not_fit_is_told_with_what_to_leave_out() {
    let mut scene = crowded(200);
    let link = encode(&scene).unwrap();
    assert!(link.len() <= MAX_CHARACTERS && link.len() > MAX_CHARACTERS / 2);
    assert_eq!(decode(&link).as_ref(), Ok(&scene));

    scene.measured = Some(Measurements {
        points_mm: crowded(400)
            .obstacles
            .iter()
            .map(|obstacle| obstacle.shape.anchor_mm())
            .collect(),
        ..Measurements::default()
    });
    let error = encode(&scene).unwrap_err();
    let LinkError::TooMuch { characters, .. } = error else {
        panic!("{error}");
    };
    assert_eq!(
        error.to_string(),
        format!(
            "the link would have {characters} characters and most programs cut it after 8000; leave the measured backbone out, or send the scene's file"
        )
    );
    let error = encode(&crowded(400)).unwrap_err().to_string();
    assert!(error.ends_with("leave some obstacles out, or send the scene's file"));

    let polygon = Shape::Polygon {
        points_mm: vec![[200.0, 0.0], [201.0, 0.0], [200.0, 1.0], [199.0, 0.5]],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    let mut same = Scene {
        obstacles: vec![Obstacle::from(polygon); 1000],
        ..Scene::default()
    };
    assert_eq!(decode(&encode(&same).unwrap()).as_ref(), Ok(&same));
    same.title = Some("x".repeat(MAX_TEXT_BYTES));
    let error = encode(&same).unwrap_err();
    assert!(matches!(error, LinkError::TooMuchText { .. }), "{error}");
}

fn number(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    let whole = (range.start as i32..range.end as i32).prop_map(f64::from);
    prop_oneof![range, whole, Just(0.0), Just(-0.0)]
}

fn point() -> impl Strategy<Value = [f64; 2]> {
    [number(-1e3..1e3), number(-1e3..1e3)]
}

fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        (point(), 0.1..50.0).prop_map(|(center_mm, radius_mm)| Shape::Disc {
            center_mm,
            radius_mm
        }),
        (point(), number(-360.0..360.0)).prop_map(|(point_mm, rotation_deg)| Shape::Wall {
            point_mm,
            rotation_deg,
            corner_radius_mm: 0.0
        }),
        (point(), 1.0..50.0, number(-90.0..90.0)).prop_map(|(center_mm, side, rotation_deg)| {
            Shape::Box {
                center_mm,
                size_mm: [side, 2.0 * side],
                rotation_deg,
                corner_radius_mm: 0.25,
            }
        }),
        (point(), number(0.0..9.0)).prop_map(|([x, y], corner_radius_mm)| Shape::Polygon {
            points_mm: vec![[x, y], [x + 9.0, y], [x, y + 9.5]],
            rotation_deg: 0.0,
            corner_radius_mm,
        }),
    ]
}

fn any_scene() -> impl Strategy<Value = Scene> {
    let robot = (1u32..9, 1u32..4, number(-90.0..90.0), point(), 0.0..9.0);
    let obstacle = (proptest::option::of(".{0,12}"), shape())
        .prop_map(|(name, shape)| Obstacle { name, shape });
    let obstacles = proptest::collection::vec(obstacle, 0..9);
    let measured = proptest::collection::vec(point(), 2..20);
    let measured = proptest::option::of(measured);
    (
        proptest::option::of(".{0,20}"),
        robot,
        number(-50.0..50.0),
        obstacles,
        measured,
    )
        .prop_map(
            |(title, (bays, per_bay, angle, base, diameter), pull_mm, obstacles, measured)| {
                let mut scene = Scene {
                    title,
                    obstacles,
                    ..Scene::default()
                };
                scene.robot.segments = bays * per_bay;
                scene.robot.segments_per_bay = per_bay;
                scene.robot.base_angle_deg = angle;
                scene.robot.base_mm = base;
                scene.robot.backbone_diameter_mm = diameter;
                scene.robot.bending_stiffness_nmm2 = Some(diameter + 1.0);
                scene.set_pull_mm(pull_mm);
                scene.measured = measured.map(|points_mm| Measurements {
                    points_mm,
                    ..Measurements::default()
                });
                scene.photo = Some(Photo {
                    file: "a.png".to_owned(),
                    center_mm: base,
                    width_mm: 1.0,
                    rotation_deg: 0.0,
                    opacity: 1.0,
                });
                scene
            },
        )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn any_scene_comes_back(sent in any_scene()) {
        let link = encode(&sent).unwrap();
        let came = decode(&link).unwrap();
        // Signs of zeros too, which `==` does not see.
        let expected = Scene { photo: None, ..sent };
        prop_assert_eq!(came.to_toml().unwrap(), expected.to_toml().unwrap());
    }

    #[test]
    fn no_link_however_spoiled_panics(place in 4..200_usize, letter in "[A-Za-z0-9_-]", more in "[A-Za-z0-9_-]{0,40}") {
        let mut link = encode(&scene(TWO_DISCS)).unwrap();
        link.replace_range(place..=place, &letter);
        link.insert_str(place, &more);
        if let Err(error) = decode(&link) {
            prop_assert!(error.to_string().len() < 1000);
        }
    }
}
