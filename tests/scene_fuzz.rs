//! Scenes spoiled at random: nothing panics, and what passes the checks is
//! finite, in range and read back the same. The seeds are fixed.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use sinew::scene::Scene;

const SCENES: [&str; 5] = [
    include_str!("cases/scene/full.toml"),
    include_str!("cases/scene/cables.toml"),
    include_str!("../assets/scenes/free.toml"),
    include_str!("../assets/scenes/shapes.toml"),
    include_str!("../assets/scenes/load-cell.toml"),
];

/// Values put in place of numbers: extremes, and other kinds of value.
const EXTREMES: [&str; 24] = [
    "nan",
    "-nan",
    "inf",
    "-inf",
    "0",
    "-0.0",
    "-1",
    "1",
    "2",
    "1e300",
    "-1e300",
    "1e-300",
    "5e-324",
    "1.7976931348623157e308",
    "9223372036854775807",
    "-9223372036854775808",
    "4294967296",
    "0x7fff",
    "1e6",
    "1000000.0001",
    "\"\"",
    "[]",
    "{}",
    "[[[]]]",
];

/// Pieces spliced in anywhere.
const PIECES: [&str; 19] = [
    "[[obstacle]]\n",
    "[contact]\n",
    "[measured]\n",
    "[[measured.force]]\n",
    "[photo]\n",
    "[[cable]]\n",
    "[loads]\n",
    "\"",
    "'''",
    "[",
    "]",
    "{",
    "}",
    "=",
    ".",
    "\\u0000",
    "\u{feff}",
    "listed = []\n",
    "å",
];

/// One change to a scene's bytes. Places count modulo the length.
#[derive(Clone, Debug)]
enum Edit {
    Flip { place: usize, bit: u8 },
    Delete { place: usize, length: usize },
    Repeat { place: usize, length: usize },
    Splice { place: usize, piece: &'static str },
    Number { which: usize, value: String },
    SwapLines { first: usize, second: usize },
}

fn edit() -> impl Strategy<Value = Edit> {
    let place = || 0..10_000_usize;
    let length = || prop_oneof![0..4_usize, 0..200_usize];
    let value = || {
        prop_oneof![
            2 => proptest::sample::select(&EXTREMES[..]).prop_map(str::to_owned),
            1 => any::<f64>().prop_map(|number| format!("{number:?}").replace("NaN", "nan")),
            2 => (-200..200_i32).prop_map(|number| number.to_string()),
        ]
    };
    prop_oneof![
        1 => (place(), 0..8_u8).prop_map(|(place, bit)| Edit::Flip { place, bit }),
        1 => (place(), length()).prop_map(|(place, length)| Edit::Delete { place, length }),
        1 => (place(), length()).prop_map(|(place, length)| Edit::Repeat { place, length }),
        1 => (place(), proptest::sample::select(&PIECES[..])).prop_map(|(place, piece)| Edit::Splice { place, piece }),
        4 => (place(), value()).prop_map(|(which, value)| Edit::Number { which, value }),
        1 => (place(), place()).prop_map(|(first, second)| Edit::SwapLines { first, second }),
    ]
}

fn apply(bytes: &mut Vec<u8>, edit: &Edit) {
    if bytes.is_empty() {
        return;
    }
    let size = bytes.len();
    match edit {
        Edit::Flip { place, bit } => bytes[place % size] ^= 1 << bit,
        Edit::Delete { place, length } => {
            let start = place % size;
            bytes.drain(start..(start + length).min(size));
        }
        Edit::Repeat { place, length } => {
            let start = place % size;
            let piece = bytes[start..(start + length).min(size)].to_vec();
            bytes.splice(start..start, piece);
        }
        Edit::Splice { place, piece } => {
            let start = place % size;
            bytes.splice(start..start, piece.bytes());
        }
        Edit::Number { which, value } => {
            let numbers = numbers(bytes);
            if !numbers.is_empty() {
                bytes.splice(numbers[which % numbers.len()].clone(), value.bytes());
            }
        }
        Edit::SwapLines { first, second } => {
            let mut lines: Vec<_> = bytes
                .split(|byte| *byte == b'\n')
                .map(<[u8]>::to_vec)
                .collect();
            let count = lines.len();
            lines.swap(first % count, second % count);
            *bytes = lines.join(&b'\n');
        }
    }
}

/// Where numbers stand after `= `, `[` or `, `, outside comments.
fn numbers(bytes: &[u8]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    let mut in_comment = false;
    while at < bytes.len() {
        match bytes[at] {
            b'\n' => in_comment = false,
            b'#' => in_comment = true,
            b'0'..=b'9' | b'-' if !in_comment && at > 0 && matches!(bytes[at - 1], b' ' | b'[') => {
                let number = |byte: &&u8| byte.is_ascii_digit() || matches!(byte, b'-' | b'.');
                let end = at + bytes[at..].iter().take_while(number).count();
                found.push(at..end);
                at = end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// What came of one text.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Refused,
    Faulty,
    Fine,
}

/// Reads the bytes as a scene and checks all that is promised of the result.
fn examine(bytes: &[u8]) -> Result<Outcome, TestCaseError> {
    let scene = match Scene::from_toml_bytes(bytes) {
        Ok(scene) => scene,
        Err(error) => {
            let message = error.to_string();
            prop_assert!(message.len() < 1000, "{message}");
            // The phrases of serde, which no user should have to read.
            for leak in [
                "invalid type",
                "expected struct",
                "missing field",
                "unknown variant",
                "expected a map",
            ] {
                prop_assert!(!message.contains(leak), "{message}");
            }
            return Ok(Outcome::Refused);
        }
    };
    let faults = scene.faults();
    prop_assert_eq!(scene.check().err(), faults.first().cloned());
    let written = scene.to_toml().unwrap();
    if !faults.is_empty() {
        prop_assert!(faults.iter().all(|fault| !fault.to_string().is_empty()));
        prop_assert!(Scene::from_toml(&written).is_ok(), "{written}");
        return Ok(Outcome::Faulty);
    }
    let table: toml::Value =
        toml::from_str(&written).map_err(|error| TestCaseError::fail(error.to_string()))?;
    prop_assert!(all_moderate(&table), "{written}");
    let stiffness = scene.robot.bending_stiffness_nmm2;
    prop_assert!(
        stiffness.is_none_or(|ei| 0.0 < ei && ei <= 1e12),
        "{written}"
    );
    if let Some(measured) = &scene.measured {
        let chosen = measured.calibrating();
        prop_assert_eq!(chosen.is_some(), measured.calibration.is_some());
        let named = [0, measured.points_mm.len()].contains(&measured.nodes.len());
        prop_assert!(named && measured.nodes.is_sorted(), "{written}");
        prop_assert!(
            chosen.is_none_or(|reading| reading.force_g > 0.0),
            "{written}"
        );
    }
    prop_assert!(
        scene.robot.length_mm >= 1.0
            && scene
                .each_cable()
                .all(|cable| cable.offset_mm.abs() >= 0.01),
        "{written}"
    );
    prop_assert!(
        scene
            .robot
            .segments
            .is_multiple_of(scene.robot.segments_per_bay),
        "{written}"
    );
    let cables = scene.cable_count();
    prop_assert!((1..=16).contains(&cables), "{written}");
    for cable in scene.each_cable() {
        let to_disk = cable.to_disk.unwrap_or(1);
        prop_assert!(
            (1..=scene.last_disk()).contains(&to_disk) && scene.rim_mm() >= cable.offset_mm.abs(),
            "{written}"
        );
    }
    prop_assert_eq!(Scene::from_toml(&written), Ok(scene));
    Ok(Outcome::Fine)
}

/// The keys of greater numbers.
const FAR: [&str; 3] = [
    "bending_stiffness_nmm2",
    "axial_stiffness_n",
    "tip_moment_nmm",
];

/// Whether every number is finite and at most a million, the widest range of
/// any field but stiffnesses and the moment.
fn all_moderate(value: &toml::Value) -> bool {
    match value {
        toml::Value::Float(number) => number.abs() <= 1e6,
        toml::Value::Integer(number) => number.abs() <= 1_000_000,
        toml::Value::Array(items) => items.iter().all(all_moderate),
        toml::Value::Table(table) => table
            .iter()
            .filter(|(key, _)| !FAR.contains(&key.as_str()))
            .all(|(_, item)| all_moderate(item)),
        _ => true,
    }
}

/// Runs `cases` inputs from a fixed seed and returns how many were refused,
/// faulty and fine.
fn run(cases: u32, inputs: impl Strategy<Value = Vec<u8>>) -> [u32; 3] {
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let outcomes = std::cell::Cell::new([0; 3]);
    let result = TestRunner::new_with_rng(config, random).run(&inputs, |bytes| {
        let mut counts = outcomes.get();
        counts[examine(&bytes)? as usize] += 1;
        outcomes.set(counts);
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
    outcomes.get()
}

#[test]
fn spoiled_scenes() {
    let spoiled = (
        proptest::sample::select(&SCENES[..]),
        prop::collection::vec(edit(), 1..6),
    )
        .prop_map(|(scene, edits)| {
            let mut bytes = scene.as_bytes().to_vec();
            edits.iter().for_each(|edit| apply(&mut bytes, edit));
            bytes
        });
    let [refused, faulty, fine] = run(15_000, spoiled);
    // Each way out was taken often enough to have been tested.
    assert!(
        refused > 1000 && faulty > 1000 && fine > 1000,
        "{refused} {faulty} {fine}"
    );
}

#[test]
fn two_scenes_cut_and_joined() {
    let scenes = || proptest::sample::select(&SCENES[..]);
    let joined =
        (scenes(), 0..3000_usize, scenes(), 0..3000_usize).prop_map(|(head, cut, tail, from)| {
            let (head, tail) = (head.as_bytes(), tail.as_bytes());
            [&head[..cut.min(head.len())], &tail[from.min(tail.len())..]].concat()
        });
    run(5000, joined);
}

#[test]
fn arbitrary_text_and_bytes() {
    let text = ".{0,200}".prop_map(String::into_bytes);
    let toml_like = "[a-z_]{1,9} = [-\\[\\]{}\"0-9a-z.,= \n]{0,80}".prop_map(String::into_bytes);
    let bytes = prop::collection::vec(any::<u8>(), 0..200);
    run(5000, prop_oneof![text, toml_like, bytes]);
}
