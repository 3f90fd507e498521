//! The program as its users meet it: arguments and files in, reports, messages
//! and exit codes out.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;
use sinew::scene::Scene;

/// What a run of the program left.
struct Ran {
    code: i32,
    out: String,
    err: String,
}

fn sinew(args: &[&str], input: &[u8]) -> Ran {
    let mut child = Command::new(env!("CARGO_BIN_EXE_sinew"))
        .args(args)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The program may end without reading all of it.
    let _ = child.stdin.take().unwrap().write_all(input);
    let output = child.wait_with_output().unwrap();
    Ran {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Keys of JSON that are null where a stiffness is not known, in the other mechanics,
/// without friction, and where another key is in their place. Any other null is a
/// number that is none.
const MAY_BE_NULL: [&str; 11] = [
    "base",
    "cable",
    "energy_nmm",
    "force_n",
    "friction_n",
    "load_n",
    "pull_mm",
    "slips",
    "stable_under_load",
    "tension_n",
    "tensions_n",
];

/// Runs the program and checks its exit code, and that results are on standard
/// output where there are any and messages on standard error where there are.
#[track_caller]
fn check_with(args: &[&str], input: &[u8], code: i32) -> Ran {
    let ran = sinew(args, input);
    assert_eq!(ran.code, code, "{args:?}: {}", ran.err);
    assert_eq!(ran.err.is_empty(), code == 0, "{args:?}: {}", ran.err);
    assert_eq!(ran.out.is_empty(), code == 2, "{args:?}: {}", ran.out);
    let known = MAY_BE_NULL.iter().fold(ran.out.clone(), |text, key| {
        text.replace(&format!("\"{key}\":null"), "")
    });
    for text in ["NaN", "nan,", "inf,", "null", "panicked"] {
        assert!(!known.contains(text), "{args:?}: {text} in {}", ran.out);
    }
    assert!(!ran.err.contains("panicked"), "{args:?}: {}", ran.err);
    if let Some(zero) = signed_zero(&ran.out) {
        panic!("{args:?}: {zero} in {}", ran.out);
    }
    ran
}

/// A zero with a sign, such as `-0.00`, in a text.
fn signed_zero(text: &str) -> Option<&str> {
    let part_of_number = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+' | '−');
    let mut words = text.split(|c: char| !part_of_number(c));
    words.find(|word| {
        let digits = word.strip_prefix(['-', '−']);
        digits.is_some_and(|digits| digits.parse() == Ok(0.0))
    })
}

#[track_caller]
fn check(args: &[&str], code: i32) -> Ran {
    check_with(args, b"", code)
}

/// Checks that bad input is refused with this sentence and no other.
#[track_caller]
fn check_refused(args: &[&str], input: &[u8], sentence: &str) {
    let ran = check_with(args, input, 2);
    assert_eq!(ran.err, format!("error: {sentence}\n"), "{args:?}");
}

#[track_caller]
fn json(args: &[&str], code: i32) -> Value {
    serde_json::from_str(&check(args, code).out).unwrap()
}

fn asset(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    format!("{folder}/{name}.toml")
}

/// A place for a file of one test.
fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<_> = value
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    keys.sort_unstable();
    keys
}

/// What holds of every state that is printed, whatever its status.
#[track_caller]
fn check_state(state: &Value, segments: usize) {
    assert_eq!(state["schema"], "sinew-solution-2");
    for left in ["force", "moment"] {
        assert!(
            number(&state["balance"][left]) <= 1e-9,
            "{}",
            state["balance"]
        );
    }
    for (key, count) in [
        ("backbone_mm", segments + 1),
        ("bends_rad", segments),
        ("shears_rad", segments),
    ] {
        assert_eq!(list(&state[key]).len(), count, "{key}");
    }
    let energy: f64 = list(&state["bends_rad"])
        .iter()
        .map(|bend| number(bend).powi(2))
        .sum();
    assert!((energy - number(&state["energy"])).abs() <= 1e-12 * energy);
    assert_eq!(
        state["certificate"]["holds"], true,
        "{}",
        state["certificate"]
    );
    assert!(number(&state["certificate"]["residual"]) <= 1e-9);
    for contact in list(&state["contacts"]) {
        let normal = list(&contact["normal"]);
        let length = number(&normal[0]).hypot(number(&normal[1]));
        assert!((length - 1.0).abs() < 1e-12);
        assert!((1..=segments as u64).contains(&contact["node"].as_u64().unwrap()));
        let pressing = number(&contact["multiplier"]) > 0.0;
        let class = if pressing { "pressing" } else { "grazing" };
        assert_eq!(contact["class"], class);
        assert!(number(&contact["clearance_mm"]).abs() < 1e-6);
    }
    for event in list(&state["events"]) {
        let expected: &[&str] = match event["what"].as_str().unwrap() {
            "contact_made" | "contact_lost" => &["line", "node", "obstacle"],
            "jump" => &["distance_mm", "node"],
            "branch_ended" => &["reason", "segment"],
            "pushed_aside" => &["direction", "obstacle"],
            other => panic!("unknown event {other}"),
        };
        let mut expected = [expected, &["cables", "share", "what"]].concat();
        expected.sort_unstable();
        assert_eq!(keys(event), expected);
        assert!((0.0..=1.0).contains(&number(&event["share"])));
        assert_eq!(list(&event["cables"]).len(), list(&state["cables"]).len());
    }
}

#[test]
fn json_of_two_discs_is_complete() {
    let state = json(&["solve", &asset("two-discs"), "--format", "json"], 0);
    check_state(&state, 18);
    assert_eq!(
        keys(&state),
        [
            "backbone_mm",
            "balance",
            "base",
            "bends_rad",
            "cable_mm",
            "cables",
            "cautions",
            "certificate",
            "contacts",
            "energy",
            "energy_nmm",
            "events",
            "iterations",
            "mechanics",
            "obstacles_placed",
            "pull_mm",
            "reason",
            "schema",
            "share",
            "shears_rad",
            "space",
            "stable_under_load",
            "status",
            "tip_mm",
            "tip_slope_rad",
            "unique_split",
        ]
    );
    assert_eq!(state["status"], "converged");
    assert!((number(&state["pull_mm"]) - 4.9).abs() < 1e-12);
    let contacts = list(&state["contacts"]);
    for (contact, (obstacle, node)) in contacts.iter().zip([(0, 10), (1, 16)]) {
        assert_eq!(
            keys(contact),
            [
                "cable",
                "class",
                "clearance_mm",
                "force_n",
                "friction_n",
                "line",
                "multiplier",
                "node",
                "normal",
                "obstacle",
                "point_mm",
                "slips"
            ]
        );
        assert_eq!(contact["obstacle"], obstacle);
        assert_eq!(contact["node"], node);
        assert_eq!(contact["line"], "cable");
        assert_eq!(contact["class"], "pressing");
        // The touching point is on the disc and, in `nodes` mode, the node.
        let (center, radius) = [([33.0, 89.0], 12.5), ([59.0, 140.0], 15.0)][obstacle];
        let point = list(&contact["point_mm"]);
        let distance = (number(&point[0]) - center[0]).hypot(number(&point[1]) - center[1]);
        assert!((distance - radius).abs() < 1e-9);
        let cable = &state["cable_mm"][node];
        assert!((number(&point[0]) - number(&cable[0])).abs() < 1e-9);
    }
    assert_eq!(contacts.len(), 2);
    // The order of the keys is part of the format.
    let text = check(&["solve", &asset("two-discs"), "--format", "json"], 0).out;
    assert!(text.starts_with(r#"{"schema":"sinew-solution-2","status":"converged","reason":""#));
}

#[test]
fn the_free_robot_is_an_arc() {
    // β* = 2 asin(l / (2 n a)), the tip by summing up the segments.
    for (pull, tip, slope) in [
        ("5", [54.448, 168.515], 35.812),
        ("10", [98.628, 136.665], 71.634),
        ("-5", [-54.448, 168.515], -35.812),
    ] {
        let args = ["solve", &asset("free"), "--pull", pull, "--format", "json"];
        let state = json(&args, 0);
        check_state(&state, 18);
        assert_eq!(number(&state["pull_mm"]).round().to_string(), pull);
        let bends: f64 = list(&state["bends_rad"]).iter().map(number).sum();
        assert!((bends.to_degrees() - slope).abs() < 5e-4, "{bends}");
        let end = &state["backbone_mm"][18];
        assert!((number(&end[0]) - tip[0]).abs() < 5e-4);
        assert!((number(&end[1]) - tip[1]).abs() < 5e-4);
        // What the text shows of the tip is in the JSON too.
        assert_eq!(&state["tip_mm"], end);
        assert!((number(&state["tip_slope_rad"]).to_degrees() - slope).abs() < 5e-4);
        assert!(list(&state["contacts"]).is_empty());
    }
}

#[test]
fn a_known_stiffness_gives_the_tension() {
    // J = n β², sin(β/2) = l/2na and T = (EI/2l_0) dJ/dl, in N and mm.
    let (n, offset, link, pull, stiffness): (f64, f64, f64, f64, f64) =
        (18.0, 8.0, 10.0, 5.0, 8700.0);
    let half = (pull / (2.0 * n * offset)).asin();
    let right = stiffness / (2.0 * link) * 4.0 * half / (offset * half.cos());
    let free = String::from_utf8(extended("free", "")).unwrap();
    let stiff = free.replacen("[robot]", "[robot]\nbending_stiffness_nmm2 = 8700", 1);
    let args = ["solve", "-", "--pull", "5", "--format", "json"];
    let state = json_of_input(&args, stiff.as_bytes());
    let tension = number(&state["cables"][0]["tension_n"]);
    assert!((tension / right - 1.0).abs() < 1e-9, "{tension} {right}");
    let text = check_with(&["solve", "-", "--pull", "5"], stiff.as_bytes(), 0).out;
    assert!(
        text.contains("  tension      385.1 g (3.777 N)\n"),
        "{text} {right}"
    );
    let unknown = json_of_input(&args, free.as_bytes());
    assert!(unknown["cables"][0]["tension_n"].is_null());
    assert!(unknown["base"].is_null() && unknown["energy_nmm"].is_null());
}

const PIN: &str = r#"
    version = 2
    model = { mechanics = "equal" }
    robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
    actuation = { pull_mm = 6.3 }
    obstacle = [{ name = "pin", shape = "disc", center_mm = [30, 105], radius_mm = 0.5 }]
"#;

#[test]
fn cautions_are_told_and_change_no_exit_code() {
    let sentence = "Obstacle 0 pin stands between backbone and cable below node 12, where the \
                    contact candidates do not see it; contact.candidates = \"body\" keeps it out.";
    let text = check_with(&["solve", "-"], PIN.as_bytes(), 0).out;
    let words: Vec<&str> = text.split_whitespace().collect();
    let told = format!("Cautions {sentence} Nothing touches.");
    assert!(words.join(" ").contains(&told), "{text}");
    let text = check_with(&["check", "-"], PIN.as_bytes(), 0).out;
    assert!(
        text.ends_with(&format!("\nCaution: {sentence}\n")),
        "{text}"
    );
    let text = check_with(&["solve", "-", "--path", "2"], PIN.as_bytes(), 0).out;
    assert!(
        text.ends_with("  caution: encloses obstacle 0 pin\n"),
        "{text}"
    );
    let state = json_of_input(&["solve", "-", "--format", "json"], PIN.as_bytes());
    let [caution] = list(&state["cautions"]) else {
        panic!("{}", state["cautions"]);
    };
    assert_eq!(
        keys(caution),
        ["message", "node", "obstacle", "remedy", "what"]
    );
    assert_eq!(caution["what"], "encloses_obstacle");
    assert_eq!(
        (&caution["node"], &caution["obstacle"]),
        (&12.into(), &0.into())
    );
    // Its remedy is one.
    let body = PIN.replacen("obstacle =", "contact.candidates = \"body\"\nobstacle =", 1);
    let state = json_of_input(&["solve", "-", "--format", "json"], body.as_bytes());
    assert_eq!(list(&state["cautions"]).len(), 0);
    assert_eq!(list(&state["contacts"]).len(), 1);
    // Every kind has its keys.
    for (scene, pull, expect) in [
        (
            "two-discs",
            "4.9",
            &[
                "depth_mm", "line", "message", "node", "obstacle", "remedy", "what",
            ][..],
        ),
        ("free", "-5", &["message", "what"]),
        ("free", "56", &["message", "node", "other_node", "what"]),
    ] {
        let state = json(
            &["solve", &asset(scene), "--pull", pull, "--format", "json"],
            0,
        );
        let [caution] = list(&state["cautions"]) else {
            panic!("{}", state["cautions"]);
        };
        assert_eq!(keys(caution), expect);
    }
}

#[test]
fn a_check_of_a_scene_that_cannot_be_reached_says_so() {
    let text = check(&["check", &asset("slip-off")], 0).out;
    assert!(!text.contains("does not reach"), "{text}");
    let mut scene = Scene::from_toml_bytes(&fs::read(asset("narrow-gap")).unwrap()).unwrap();
    scene.set_pull_mm(60.0);
    let input = scene.to_toml().unwrap();
    let state = check_with(&["solve", "-"], input.as_bytes(), 3);
    let text = check_with(&["check", "-"], input.as_bytes(), 0).out;
    assert!(
        text.contains("Caution: A solve does not reach the pull: "),
        "{text} {}",
        state.err
    );
}

#[test]
fn no_zero_has_a_sign() {
    // Sines of half turns, offsets from the base, and sums that cancel: all
    // checked where anything is printed.
    for angle in ["-90", "180"] {
        for (pull, base) in [
            ("0", "[-0.0, 0]"),
            ("5", "[1e-5, -1e-5]"),
            ("-5", "[0, -0.0]"),
        ] {
            let scene = format!(
                "version = 2\nmodel.mechanics = \"equal\"\nactuation.pull_mm = {pull}\n[robot]\nlength_mm = 180\nsegments = 18\n\
                 cable_offset_mm = 8\nbase_angle_deg = {angle}\nbase_mm = {base}\n\
                 bending_stiffness_nmm2 = 8700\n"
            );
            for args in [
                &["solve", "-"][..],
                &["solve", "-", "--format", "json"],
                &["solve", "-", "--format", "csv"],
                &["solve", "-", "--path", "3"],
                &["solve", "-", "--path", "3", "--format", "csv"],
                &["check", "-"],
                &["force", "-", "--loads", "100"],
                &["force", "-", "--loads", "100", "--format", "json"],
                &["force", "-", "--loads", "100", "--format", "csv"],
                &["draw", "-", "-o", "-"],
            ] {
                check_with(args, scene.as_bytes(), 0);
            }
        }
    }
    assert_eq!(signed_zero("x -0.00 mm"), Some("-0.00"));
    assert_eq!(signed_zero("[1.0,-0.0]"), Some("-0.0"));
    assert_eq!(signed_zero("−0°, -0.01, 1e-0, 0.0"), Some("−0"));
}

#[test]
fn what_presses_has_a_force() {
    // Without pull eq. 5 has no energy, and nothing that an obstacle pushes
    // aside needs a force.
    let scene = PIN
        .replacen("6.3", "0", 1)
        .replacen("[30, 105]", "[6, 105]", 1);
    let scene = scene.replacen("radius_mm = 0.5", "radius_mm = 12", 1);
    let at_rest = json_of_input(&["solve", "-", "--format", "json"], scene.as_bytes());
    let pulled = json_of_input(
        &["solve", "-", "--pull", "0.1", "--format", "json"],
        scene.as_bytes(),
    );
    let mut classes = Vec::new();
    for state in [&at_rest, &pulled] {
        assert!(!list(&state["contacts"]).is_empty());
        for contact in list(&state["contacts"]) {
            let presses = number(&contact["multiplier"]) > 0.0;
            assert_eq!(contact["class"] == "pressing", presses, "{contact}");
            classes.push(presses);
        }
    }
    assert!(!classes[0] && classes.contains(&true), "{classes:?}");
}

#[test]
fn every_asset_solves_in_every_format() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let path = path.to_str().unwrap();
        check(&["check", path], 0);
        let scene = Scene::from_toml_bytes(&fs::read(path).unwrap()).unwrap();
        let segments = scene.robot.segments as usize;
        check_state(&json(&["solve", path, "--format", "json"], 0), segments);
        check(&["solve", path], 0);
        let table = check(&["solve", path, "--format", "csv"], 0).out;
        assert_eq!(table.lines().count(), segments + 2);
    }
}

#[test]
fn the_text_report_says_what_presses_where() {
    let report = check(&["solve", &asset("two-discs")], 0).out;
    assert!(report.starts_with("Two discs (Fig. 4b)\n"), "{report}");
    for words in [
        "status converged: the shape is a certified equilibrium",
        "pull 4.9 mm",
        "tip x 50.87 mm, y 169.58 mm",
        "slope 35.1° clockwise from the base",
        "mechanics equal: every segment of the cable shortens alike, as in the paper",
        "cable 10 0 lower pressing 0.0962 2.359e-6 22.47 95.74",
        "cable 16 1 upper pressing 0.1174 2.878e-6 46.78 148.69",
        "The paper's cable cannot slide, and its model understates the forces of contacts;",
        "mm contact made: cable node 10 on obstacle 0 lower",
    ] {
        let found = report.lines().any(|line| {
            let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
            line.contains(words)
        });
        assert!(found, "{words:?} is not in:\n{report}");
    }
    let free = check(&["solve", &asset("free")], 0).out;
    assert!(free.ends_with("\nNothing touches.\n"), "{free}");
}

#[test]
fn a_path_leads_from_no_pull_to_the_pull() {
    let scene = asset("two-discs");
    let path = json(&["solve", &scene, "--path", "7", "--format", "json"], 0);
    assert_eq!(path["schema"], "sinew-path-2");
    let states = list(&path["states"]);
    assert_eq!(states.len(), 8);
    for (index, state) in states.iter().enumerate() {
        check_state(state, 18);
        let expected = 4.9 * index as f64 / 7.0;
        assert!((number(&state["pull_mm"]) - expected).abs() < 1e-12);
    }
    // However it is cut into pulls, the way leads to the same shape; its
    // residual of 1e-9 leaves far less than 1e-6 mm.
    let direct = json(&["solve", &scene, "--format", "json"], 0);
    for node in 0..=18 {
        for axis in 0..2 {
            let [a, b] = [&states[7], &direct].map(|s| number(&s["backbone_mm"][node][axis]));
            assert!((a - b).abs() < 1e-6, "node {node}: {a}, {b}");
        }
    }

    let text = check(&["solve", &scene, "--path", "7"], 0).out;
    assert_eq!(text.lines().count(), 4 + 8, "{text}");
    let table = check(&["solve", &scene, "--path", "7", "--format", "csv"], 0).out;
    assert_eq!(table.lines().count(), 1 + 8 * 19);
    assert!(table.starts_with("pull_mm,node,backbone_x_mm,"));
}

#[test]
fn csv_holds_the_numbers_of_json() {
    let scene = asset("two-discs");
    let state = json(&["solve", &scene, "--format", "json"], 0);
    let table = check(&["solve", &scene, "--format", "csv"], 0).out;
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(
        rows[0].join(","),
        "node,backbone_x_mm,backbone_y_mm,cable_x_mm,cable_y_mm,bend_rad,shear_rad,\
         backbone_multiplier_rad2_per_mm,cable_multiplier_rad2_per_mm"
    );
    assert_eq!(rows.len(), 20);
    assert_eq!((rows[1][5], rows[1][6]), ("", ""));
    // serde_json reads a number to its last bit but one.
    let check = |node: usize, column: usize, expected: f64| {
        let found: f64 = rows[node + 1][column].parse().unwrap();
        assert!(
            (found - expected).abs() <= 4e-16 * expected.abs(),
            "{found}, {expected}"
        );
    };
    for node in 0..=18 {
        assert_eq!(rows[node + 1][0], node.to_string());
        for axis in 0..2 {
            check(node, 1 + axis, number(&state["backbone_mm"][node][axis]));
            check(node, 3 + axis, number(&state["cable_mm"][node][axis]));
        }
        if node > 0 {
            check(node, 5, number(&state["bends_rad"][node - 1]));
            check(node, 6, number(&state["shears_rad"][node - 1]));
        }
        let contacts = list(&state["contacts"]).iter();
        let here = contacts.filter(|contact| contact["node"] == node);
        let sum: f64 = here.map(|contact| number(&contact["multiplier"])).sum();
        check(node, 7, 0.0);
        check(node, 8, sum);
    }
}

#[test]
fn repetition_times_three_kinds_of_solve() {
    let scene = asset("two-discs");
    let args = ["solve", &scene, "--repeat", "5", "--format", "json"];
    let timing = &json(&args, 0)["timing_us"];
    assert_eq!(keys(timing), ["cold", "path", "warm"]);
    for kind in ["cold", "path", "warm"] {
        let [median, p99] = ["median", "p99"].map(|key| number(&timing[kind][key]));
        assert!(0.0 < median && median <= p99, "{kind}: {median}, {p99}");
        assert_eq!(timing[kind]["converged"], 5);
    }
    let text = check(&["solve", &scene, "--repeat", "1"], 0).out;
    assert!(text.contains("Time of a solve, µs"), "{text}");
    // A pull at the end of its range has no room to be moved further.
    let most = ["solve", &asset("free"), "--pull", "176.4", "--repeat", "2"];
    check(&most, 0);
}

#[test]
fn a_solve_that_ends_early_shows_its_last_good_state() {
    let scene = asset("one-disc");
    let args = ["solve", &scene, "--pull", "20", "--format", "json"];
    let state = json(&args, 3);
    check_state(&state, 18);
    assert_eq!(state["status"], "branch_ended");
    assert!(number(&state["pull_mm"]) < 20.0);
    let last = list(&state["events"]).last().unwrap();
    assert_eq!(last["what"], "branch_ended");

    let ran = check(&args[..4], 3);
    let message = "error: not converged at pull 20 mm: the branch ends at segment ";
    assert!(ran.err.starts_with(message), "{}", ran.err);
    assert_eq!(ran.err.lines().count(), 1);
    assert!(ran.out.contains("mm of the 20 mm asked for"), "{}", ran.out);

    let path = json(&[&args[..], &["--path", "20"]].concat(), 3);
    let states = list(&path["states"]);
    assert!(states.len() < 21);
    let (last, before) = states.split_last().unwrap();
    assert_eq!(last["status"], "branch_ended");
    assert!(before.iter().all(|state| state["status"] == "converged"));
}

#[test]
fn obstacles_that_do_not_reach_their_place_are_told() {
    // A ceiling 1 mm above the base. Without pull no segment bends, and each
    // turns by at most π/2 − 0.01, so that the tip is at least 1.8 mm up.
    let scene = "
        version = 2
        model = { mechanics = \"equal\" }
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
        actuation = { pull_mm = 1 }
        obstacle = [{ shape = \"wall\", point_mm = [0, 1], rotation_deg = -90 }]
    ";
    let ran = check_with(&["solve", "-"], scene.as_bytes(), 3);
    let words = "at pull 0 mm and with obstacles not yet in their place";
    assert!(ran.err.contains(words), "{}", ran.err);
}

#[test]
fn a_scene_may_come_from_standard_input() {
    let scene = fs::read(asset("free")).unwrap();
    let from_pipe = check_with(&["solve", "-"], &scene, 0).out;
    assert_eq!(from_pipe, check(&["solve", &asset("free")], 0).out);
    check_with(&["check", "-"], &scene, 0);
}

#[test]
fn what_cannot_be_read_is_told_in_one_line() {
    let missing = temporary("missing.toml");
    let missing = missing.to_str().unwrap();
    let folder = env!("CARGO_TARGET_TMPDIR");
    let huge = temporary("huge.toml");
    File::create(&huge).unwrap().set_len(100 << 20).unwrap();
    let huge_name = huge.to_str().unwrap();
    for command in ["solve", "check"] {
        check_refused(
            &[command, missing],
            b"",
            &format!("{missing}: there is no such file"),
        );
        check_refused(
            &[command, folder],
            b"",
            &format!("{folder}: this is a directory; a scene is a TOML text file"),
        );
        // Only who did not read the file knows its size.
        check_refused(
            &[command, huge_name],
            b"",
            &format!(
                "{huge_name}: the file has 104857600 bytes; a scene has at most 4194304, so this \
                 is not one"
            ),
        );
        check_refused(
            &[command, "-"],
            b"",
            "standard input: the scene is empty; it needs at least `version = 2`, a [robot] \
             table and an [actuation] table",
        );
        check_refused(
            &[command, "-"],
            b"version\xff\x00",
            "standard input: the file is not UTF-8 text (first at byte 7); a scene is a TOML \
             text file",
        );
        check_refused(
            &[command, "-"],
            &vec![b'#'; 5 << 20],
            "standard input: this has more than 4194304 bytes, the most a scene has",
        );
        check_refused(
            &[command, "-"],
            b"robot {",
            "standard input: line 1, column 7 is not valid TOML: key with no value, expected `=`",
        );
    }
    fs::remove_file(huge).unwrap();
}

#[cfg(unix)]
#[test]
fn an_endless_file_is_not_read_to_its_end() {
    check_refused(
        &["solve", "/dev/zero"],
        b"",
        "/dev/zero: this has more than 4194304 bytes, the most a scene has",
    );
}

#[test]
fn every_fault_of_a_scene_is_listed() {
    let scene = fs::read_to_string(asset("two-discs")).unwrap();
    let bad = scene
        .replacen("length_mm = 180", "length_mm = -1", 1)
        .replacen("radius_mm = 15", "radius_mm = nan", 1);
    for command in ["check", "solve"] {
        check_refused(
            &[command, "-"],
            bad.as_bytes(),
            "standard input: robot.length_mm is -1 mm; set it to a value from 1 to 100000 mm\n\
             error: standard input: obstacle[1].radius_mm is nan, not a number; set it to a \
             value from 0.001 to 1000000 mm",
        );
    }
    let over_base = scene.replacen("[33, 89]", "[4, 3]", 1);
    check_refused(
        &["check", "-"],
        over_base.as_bytes(),
        "standard input: obstacle[0] (lower) covers the robot's base, which cannot move; move or \
         shrink it until it is clear of the first disk",
    );
    let typo = scene.replacen("pull_mm", "pul_mm", 1);
    check_refused(
        &["check", "-"],
        typo.as_bytes(),
        "standard input: actuation.pul_mm is not a key of a scene; did you mean `pull_mm`?",
    );
}

#[test]
fn a_pull_that_cannot_be_is_refused_like_one_in_the_file() {
    let scene = asset("two-discs");
    let any = "set it to a value from -100000 to 100000 mm";
    let possible = "set it to a value for which the segments' linkages exist, from -286.9 to \
                    176.4 mm";
    for (pull, sentence) in [
        ("nan", format!("--pull is nan, not a number; {any}")),
        ("inf", format!("--pull is inf mm; {any}")),
        ("-inf", format!("--pull is -inf mm; {any}")),
        ("1e300", format!("--pull is 1e300 mm; {any}")),
        ("176.5", format!("--pull is 176.5 mm; {possible}")),
        ("-287", format!("--pull is -287 mm; {possible}")),
    ] {
        let sentence = format!("{scene}: {sentence}");
        check_refused(&["solve", &scene, "--pull", pull], b"", &sentence);
    }
    // The file's own pull does not matter where another is given.
    let text = fs::read_to_string(&scene).unwrap();
    let absurd = text.replacen("pull_mm = 4.9", "pull_mm = 1e9", 1);
    check_with(&["solve", "-", "--pull", "4.9"], absurd.as_bytes(), 0);
}

#[test]
fn values_are_set_before_anything_is_done_with_the_scene() {
    let scene = asset("two-discs");
    let solved = |args: &[&str]| json(&[&["solve", &scene, "--format", "json"], args].concat(), 0);
    let nodes = |solved: &Value| list(&solved["backbone_mm"]).len();
    let by_pull = solved(&["--pull", "3"]);
    assert_eq!(solved(&["--set", "actuation.pull_mm=3"]), by_pull);
    // An option of its own is the last word.
    let both = ["--set", "actuation.pull_mm=-4", "--pull", "3"];
    assert_eq!(solved(&both), by_pull);
    let spaced = solved(&[
        "--set",
        "robot.disk_spacing_mm = 10",
        "--set",
        "robot.base_mm[0]=-5",
    ]);
    assert_eq!((nodes(&by_pull), nodes(&spaced)), (19, 37));
    assert_eq!(number(&list(&spaced["backbone_mm"])[0][0]), -5.0);
    // In their order: nine disks of one segment each, not of two.
    let single = "robot.segments_per_bay=1";
    let disks = solved(&["--set", single, "--set", "robot.disks=9"]);
    assert_eq!(nodes(&disks), 10);

    let summary = check(&["check", &scene, "--set", "title=\"Set\""], 0).out;
    assert!(summary.starts_with("Set: no faults."), "{summary}");
    let set = ["--set", "obstacle[0].point_mm[0]=31"];
    check(&[&["force", &asset("load-cell")], &set[..]].concat(), 0);
    check(
        &[&["draw", &asset("load-cell"), "-o", "-"], &set[..]].concat(),
        0,
    );
    let measured = temporary("set.csv");
    fs::write(&measured, "x_mm,y_mm\n0,0\n0,90\n0,180\n").unwrap();
    let measured = measured.to_str().unwrap();
    let set = ["--set", "robot.segments=36"];
    check(
        &[&["compare", &asset("free"), measured], &set[..]].concat(),
        0,
    );
}

#[test]
fn values_that_cannot_be_set_are_refused() {
    let scene = asset("two-discs");
    let refused =
        |set: &str, told: &str| check_refused(&["solve", &scene, "--set", set], b"", told);
    refused(
        "robot.length_mm",
        "--set robot.length_mm has no value; write it as --set robot.length_mm=VALUE",
    );
    refused(
        "robot.lenght_mm=3",
        "--set robot.lenght_mm=3: robot.lenght_mm is not a key of a scene; did you mean `length_mm`?",
    );
    refused(
        "robot.disk_spacing_mm=23",
        "--set robot.disk_spacing_mm=23: robot.disk_spacing_mm is 23 mm, which does not divide robot.length_mm, 180; set it to 22.5 for 8 disks or 25.714285714285715 for 7 disks",
    );
    let at = |fault: &str| format!("{scene}: {fault}");
    refused(
        "robot.length_mm=0",
        &at("robot.length_mm is 0 mm; set it to a value from 1 to 100000 mm"),
    );
    refused(
        "actuation.load_g=300",
        &at(
            "actuation.load_g is 300 g, and this program cannot solve the paper's model for a load yet; set pull_mm in its place",
        ),
    );
    let cables = include_str!("cases/scene/cables.toml");
    check_refused(
        &["solve", "-", "--pull", "3"],
        cables.as_bytes(),
        "--pull names no cable, and standard input has 2; add --cable with 0 to 1",
    );
}

#[test]
fn arguments_that_mean_nothing_are_refused() {
    let scene = asset("free");
    for more in [
        &["--pull", "much"][..],
        &["--format", "xml"],
        &["--path", "0"],
        &["--path", "-3"],
        &["--path", "100001"],
        &["--repeat", "0"],
        &["--repeat", "1.5"],
        &["--repeat", "2", "--path", "2"],
        &["--repeat", "2", "--format", "csv"],
        &["--loud"],
        &["another.toml"],
    ] {
        check(&[&["solve", &scene], more].concat(), 2);
    }
    check(&["solve"], 2);
    check(&["bake"], 2);
}

#[test]
fn help_goes_where_it_belongs() {
    if cfg!(not(feature = "app")) {
        let bare = check(&[], 2);
        assert!(bare.err.contains("Usage: sinew <COMMAND>"), "{}", bare.err);
    }
    for args in [&["--help"][..], &["help"], &["solve", "--help"]] {
        assert!(check(args, 0).out.contains("Examples:"));
    }
    let version = check(&["--version"], 0).out;
    assert_eq!(version, concat!("sinew ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[cfg(feature = "app")]
#[test]
fn without_a_display_the_window_names_the_commands_in_one_line() {
    let scene = asset("two-discs");
    for args in [&[][..], &[&*scene]] {
        let ran = sinew(args, b"");
        let said = ran.err;
        assert_eq!((ran.code, ran.out.as_str()), (1, ""), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(said.contains("no display") && said.contains("`sinew solve`"));
    }
    let said = check(&["no-such-scene.toml"], 2).err;
    assert!(said.contains("no-such-scene.toml"), "{said}");
}

#[test]
fn the_schema_is_json() {
    let schema: Value = serde_json::from_str(&check(&["schema"], 0).out).unwrap();
    assert_eq!(schema["title"], "Sinew scene");
}

#[test]
fn control_characters_of_a_scene_do_not_reach_the_terminal() {
    let scene = fs::read_to_string(asset("two-discs")).unwrap();
    let tricky =
        scene
            .replacen("Two discs", "\\u001b[2J", 1)
            .replacen("\"lower\"", "\"low\\ner\"", 1);
    for command in ["solve", "check"] {
        let text = check_with(&[command, "-"], tricky.as_bytes(), 0).out;
        assert!(!text.contains('\u{1b}') && !text.contains("low\ner"));
        assert!(text.contains("low\\ner"), "{text}");
    }
}

#[test]
fn characters_that_turn_a_text_do_not_reach_the_terminal() {
    let steers = |c: char| {
        (c.is_control() && c != '\n') || matches!(c, '\u{202e}' | '\u{2066}' | '\u{2028}')
    };
    let tricky = PIN
        .replacen(
            "version",
            "title = \"free\u{202e}gnp.exe\u{2066}\"\nversion",
            1,
        )
        .replacen("\"pin\"", "\"p\u{2028}i\\u009bn\u{202e}\"", 1)
        .replacen("[30, 105], radius_mm = 0.5", "[30, 105], radius_mm = 12", 1);
    for args in [
        &["solve", "-"][..],
        &["solve", "-", "--path", "3"],
        &["solve", "-", "--format", "json"],
        &["check", "-"],
        &["force", "-"],
        &["force", "-", "--format", "json"],
        &["draw", "-", "-o", "-"],
    ] {
        let ran = check_with(args, tricky.as_bytes(), 0);
        assert!(!ran.out.contains(steers), "{args:?}: {}", ran.out);
    }
    // In what is refused, and in what was asked.
    let named = tricky.replacen("radius_mm = 12", "radius_mm = 1000", 1);
    let ran = check_with(&["check", "-"], named.as_bytes(), 2);
    assert!(
        ran.err.contains("\\u{202e}") && !ran.err.contains(steers),
        "{}",
        ran.err
    );
    for args in [
        &["solve", "a\u{202e}b\u{1b}[2J.toml"][..],
        &["solve", "--format", "a\u{202e}b"],
        &["a\u{1b}[2J"],
    ] {
        let err = check(args, 2).err;
        assert!(!err.contains(steers), "{err:?}");
    }
}

#[test]
fn a_number_with_its_unit_is_told_how_to_be_written() {
    let scene = "version = 2\n[actuation]\npull_mm = 4.9 mm\n";
    check_refused(
        &["check", "-"],
        scene.as_bytes(),
        "standard input: line 3, column 11 is not valid TOML: write the number alone, \
         `pull_mm = 4.9`; the end of its key names the unit, millimetres",
    );
}

#[test]
fn a_reader_that_stops_early_is_no_fault() {
    let scene = asset("two-discs");
    for args in [
        &["solve", &scene, "--path", "2000", "--format", "json"][..],
        &["solve", &scene, "--path", "2000", "--format", "csv"],
        &["solve", &scene, "--path", "2000"],
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_sinew"))
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut out = child.stdout.take().unwrap();
        out.read_exact(&mut [0; 20]).unwrap();
        drop(out);
        let left = child.wait_with_output().unwrap();
        let err = String::from_utf8(left.stderr).unwrap();
        assert_eq!(
            (left.status.code(), err.as_str()),
            (Some(0), ""),
            "{args:?}"
        );
    }
}

#[test]
fn the_readme_shows_what_the_program_prints() {
    let readme = include_str!("../README.md");
    let report = check(&["solve", &asset("two-discs")], 0).out;
    // Rounding and the number of iterations may differ from machine to machine.
    let steady = report
        .lines()
        .filter(|line| !line.contains("residual") && !line.contains("iterations"));
    for line in steady {
        let shown = readme.lines().any(|other| other == line);
        assert!(shown, "the README does not show {line:?}");
    }
}

#[test]
fn the_readme_names_every_key_of_a_scene() {
    fn check_keys(schema: &Value, readme: &str) {
        if let Some(properties) = schema["properties"].as_object() {
            for (key, property) in properties {
                assert!(readme.contains(key.as_str()), "the README lacks {key}");
                check_keys(property, readme);
            }
        }
        check_keys_of_items(&schema["items"], readme);
    }
    fn check_keys_of_items(items: &Value, readme: &str) {
        if items.is_object() {
            check_keys(items, readme);
            let shapes = items["oneOf"].as_array();
            shapes
                .into_iter()
                .flatten()
                .for_each(|s| check_keys(s, readme));
        }
    }
    let schema: Value = serde_json::from_str(&check(&["schema"], 0).out).unwrap();
    check_keys(&schema, include_str!("../README.md"));
}

#[test]
fn pictures_come_as_svg_and_png() {
    let scene = asset("two-discs");
    let svg = temporary("two-discs.svg");
    let png = temporary("two-discs.PNG");
    for (file, start) in [(&svg, &b"<svg"[..]), (&png, &b"\x89PNG"[..])] {
        // Nothing on standard output: the picture is in its file.
        let ran = sinew(&["draw", &scene, "-o", file.to_str().unwrap()], b"");
        assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (0, "", ""));
        assert!(fs::read(file).unwrap().starts_with(start), "{file:?}");
    }
    let dark = check(&["draw", &scene, "-o", "-", "--theme", "dark"], 0);
    let light = check(&["draw", &scene, "-o", "-", "--theme", "light"], 0);
    assert!(dark.out.starts_with("<svg") && dark.out != light.out);
    let ended = check(&["draw", &asset("one-disc"), "--pull", "20", "-o", "-"], 3);
    assert!(ended.out.contains("branch ends"), "{}", ended.out);
    check_refused(
        &["draw", &scene, "-o", "two-discs.jpg"],
        b"",
        "two-discs.jpg does not say what to draw; end it in .svg or .png, or write - for an SVG on \
         standard output",
    );
}

/// The README's picture is what the program draws now. To renew it:
/// `cargo run --release -- draw assets/scenes/two-discs.toml -o assets/pictures/two-discs.svg`
#[test]
fn the_readmes_picture_is_of_the_present_state() {
    let drawn = check(&["draw", &asset("two-discs"), "-o", "-"], 0).out;
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/pictures/two-discs.svg");
    assert!(fs::read_to_string(kept).unwrap() == drawn, "renew {kept}");
}

#[test]
fn forces_come_as_text_json_and_csv() {
    let scene = asset("load-cell");
    let measured = ["force", &scene, "--measured", "250:17.8", "--rod", "2.2:3"];
    let with = |format| [&measured[..], &["--format", format]].concat();
    let text = check(&measured, 0).out;
    for part in ["17.80", "mu", "caution", "D7, cable side, on load cell"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let found = json(&with("json"), 0);
    assert_eq!(found["schema"], "sinew-force-2");
    let rows = list(&found["loads"]);
    assert_eq!(rows.len(), 7);
    for row in rows {
        let (load, force) = (number(&row["load_g"]), number(&row["force_x_g"]));
        assert!((force - 0.0712 * load).abs() < 1e-9 * load);
        let by_multipliers = &row["multipliers"];
        let tension = number(&by_multipliers["tension_g"]);
        let datum = number(&found["by_multipliers"]["tension_at_contact_g"]);
        assert!((tension - datum - load).abs() < 1e-4);
        for left in ["force", "moment"] {
            assert!(number(&by_multipliers["balance"][left]) <= 1e-9);
        }
    }
    let table = check(&with("csv"), 0).out;
    assert_eq!(table.lines().count(), 8);
    let head = "load_g,virtual_work_x_g,virtual_work_y_g,pull_mm,tension_g,multipliers_g,\
                frictionless_g";
    assert_eq!(table.lines().next(), Some(head));
    check(
        &[
            "force", &scene, "--motion", "contact", "--window", "3:6", "--node", "14",
        ],
        0,
    );
    check(
        &["force", &scene, "--weighed", "350:6.5", "--loads", "10,20"],
        0,
    );
}

/// The wedge's branch ends at a pull of 10.15 mm.
#[test]
fn forces_are_printed_up_to_the_end_of_a_branch() {
    let scene = asset("wedge");
    let loads = ["force", &scene, "--loads", "3000,1e9,100,10000"];
    let with = |format| [&loads[..], &["--format", format]].concat();
    let ran = check(&with("json"), 3);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    let rows = list(&found["loads"]).iter();
    let pulls: Vec<(f64, f64)> = rows
        .map(|row| {
            (
                number(&row["load_g"]),
                number(&row["multipliers"]["pull_mm"]),
            )
        })
        .collect();
    for ((load, pull), expected) in
        pulls
            .iter()
            .zip([(3000.0, 9.719), (100.0, 2.444), (1e4, 10.075)])
    {
        assert_eq!(*load, expected.0);
        assert!((pull - expected.1).abs() < 1e-3, "{load}: {pull}");
    }
    assert_eq!(pulls.len(), 3);
    let reason = "a load of 1000000000 g is not reached: the sweep stops at a pull of 10.150 mm: ";
    assert!(
        ran.err.starts_with(&format!("error: {reason}")),
        "{}",
        ran.err
    );
    assert!(found["reason"].as_str().unwrap().starts_with(reason));
    assert_eq!(check(&with("csv"), 3).out.lines().count(), 4);
    assert!(check(&with("text"), 3).out.contains("10.075"));
    // Whatever else ends early leaves the rest.
    let far = fs::read_to_string(asset("one-disc")).unwrap();
    let pulled = far.lines().map(|line| match line.starts_with("pull_mm") {
        true => "pull_mm = 20",
        false => line,
    });
    let far = pulled.collect::<Vec<_>>().join("\n");
    for (options, part) in [
        (
            &[][..],
            "the scene's pull of 20 mm is not reached, only 16.7637 mm",
        ),
        (
            &["--weighed", "500:18"],
            "the sweep stops at a pull of 16.764 mm",
        ),
        (
            &["--motion", "contact", "--window", "0:18", "--ei", "8000"],
            "the sweep stops at a pull of 16.764 mm",
        ),
    ] {
        let args = [&["force", "-"], options].concat();
        let ran = check_with(&args, far.as_bytes(), 3);
        assert!(ran.err.contains(part), "{options:?}: {}", ran.err);
        assert!(ran.out.contains("350 "), "{options:?}: {}", ran.out);
    }
}

#[test]
fn forces_that_cannot_be_estimated_are_told() {
    let scene = asset("free");
    let refused = |options: &[&str], sentence| {
        check_refused(&[&["force", &scene], options].concat(), b"", sentence);
    };
    refused(
        &["--loads", "50,0"],
        "load 2 of --loads is 0 g; loads count from contact and are positive",
    );
    refused(
        &["--loads", "many"],
        "--loads is \"many\"; write FIRST:LAST:STEP or a list such as 50,100,350, in grams",
    );
    refused(
        &["--window", "1"],
        "--window is \"1\"; write two numbers as 0:10",
    );
    refused(
        &["--window", "2:2"],
        "the window from 2.000 to 2.000 mm of pull: all 41 points of the fit have the same \
         abscissa; widen it or sweep in smaller steps",
    );
    refused(
        &["--node", "19"],
        "node 19 does not move or is not there; the robot's nodes that move are 1 to 18",
    );
    refused(
        &["--measured", "250:0"],
        "a load of 250 g with a force of 0 g cannot calibrate mu; both have to be positive",
    );
    refused(
        &["--ei", "0"],
        "a bending stiffness of 0 N mm² is not positive and finite; give one that is",
    );
    let ran = check(
        &["force", &scene, "--friction", "1", "--measured", "1:1"],
        2,
    );
    assert!(ran.err.contains("cannot be used with"));
}

#[test]
fn a_measured_backbone_is_compared_with_the_computed_one() {
    let scene = asset("free");
    let computed = check(&["solve", &scene, "--pull", "7.3", "--format", "csv"], 0).out;
    let points: String = computed
        .lines()
        .skip(1)
        .map(|line| {
            let fields: Vec<_> = line.split(',').collect();
            format!("{},{},{}\n", fields[0], fields[1], fields[2])
        })
        .collect();
    let file = temporary("measured.csv");
    fs::write(&file, format!("node,x_mm,y_mm\n{points}")).unwrap();
    let path = file.to_str().unwrap();
    let picture = temporary("measured.svg");
    let drawn = picture.to_str().unwrap();
    let found = json(
        &["compare", &scene, path, "--format", "json", "--out", drawn],
        0,
    );
    assert_eq!(found["schema"], "sinew-compare-1");
    assert_eq!(found["pull"], "best fit");
    assert!((number(&found["pull_mm"]) - 7.3).abs() < 1e-5);
    assert!(number(&found["rms_mm"]) < 1e-5);
    assert!(fs::read_to_string(&picture).unwrap().starts_with("<svg"));
    let given = json(
        &["compare", &scene, path, "--pull", "5", "--format", "json"],
        0,
    );
    assert_eq!(given["pull"], "given");
    let (rms, max) = (number(&given["rms_mm"]), number(&given["max_mm"]));
    assert!(1.0 < rms && rms < max);
    assert!((number(&given["rms_percent_of_length"]) - rms / 1.8).abs() < 1e-9);
    assert!(
        check(&["compare", &scene, path], 0)
            .out
            .contains("best fit")
    );
    let rows = check(&["compare", &scene, path, "--format", "csv"], 0).out;
    assert_eq!(rows.lines().count(), 20);
}

/// The text of a scene of the assets with more at its end.
fn extended(name: &str, more: &str) -> Vec<u8> {
    let text = fs::read_to_string(asset(name)).unwrap();
    format!("{text}\n{more}").into_bytes()
}

fn json_of_input(args: &[&str], input: &[u8]) -> Value {
    serde_json::from_str(&check_with(args, input, 0).out).unwrap()
}

#[test]
fn a_backbone_in_the_scene_is_compared_too() {
    let scene = asset("free");
    let solved = json(&["solve", &scene, "--pull", "7.3", "--format", "json"], 0);
    let points = format!("[measured]\npoints_mm = {}\n", solved["backbone_mm"]);
    let nodes = format!("nodes = {:?}\n", (0..19).collect::<Vec<_>>());
    let args = ["compare", "-", "--format", "json"];
    for (more, against) in [
        (points.clone(), "the nearest point of the backbone"),
        (points + &nodes, "its own node"),
    ] {
        let found = json_of_input(&args, &extended("free", &more));
        assert_eq!(found["against"], against);
        assert!((number(&found["pull_mm"]) - 7.3).abs() < 1e-5);
        assert_eq!(list(&found["points"]).len(), 19);
    }
    check_refused(
        &["compare", &scene],
        b"",
        &format!(
            "{scene}: the scene holds no measured backbone; name a CSV file of one, or add measured.points_mm"
        ),
    );
    check_refused(
        &["compare", "-"],
        &extended("free", "[measured]\npoints_mm = [[0, 0], [0, 90], [0, 40]]"),
        "standard input: measured.points_mm: row 3 turns back along the robot; order rows from base to tip, or name the nodes that they are",
    );
}

/// The same backbone as `solve` prints it, as numpy saves it and as spreadsheets
/// do, in metres, with gaps.
#[test]
fn measured_backbones_of_every_kind_are_read() {
    let scene = asset("free");
    let solved = check(&["solve", &scene, "--pull", "7.3", "--format", "csv"], 0).out;
    let rows = solved.lines().skip(1).map(|line| {
        let fields: Vec<f64> = line
            .split(',')
            .take(3)
            .map(|f| f.parse().unwrap())
            .collect();
        (fields[1], fields[2])
    });
    let rows: Vec<(f64, f64)> = rows.collect();
    let table = |head: &str, separator: &str, unit: f64| {
        let rows = rows
            .iter()
            .map(|(x, y)| format!("{}{separator}{}\n", x * unit, y * unit));
        format!("{head}{}", rows.collect::<String>())
    };
    let gap = table("x_mm,y_mm\nnan,nan\n", ",", 1.0);
    for (text, left_out) in [
        (solved.clone(), vec![]),
        (table("", " ", 1.0), vec![]),
        (table("# x_m y_m\n", " ", 1e-3), vec![]),
        (table("sep=;\r\nX (mm);Y (mm)\r\n", ";", 1.0), vec![]),
        (table("X [cm],Y [cm]\n", ",", 0.1), vec![]),
        (gap.clone(), vec![2]),
    ] {
        let found = json_of_input(
            &["compare", &scene, "-", "--format", "json"],
            text.as_bytes(),
        );
        assert!((number(&found["pull_mm"]) - 7.3).abs() < 1e-5, "{text}");
        assert!((number(&found["length_mm"]) - 180.0).abs() < 0.5, "{text}");
        assert_eq!(found["left_out"], Value::from(left_out));
    }
    let told = check_with(&["compare", &scene, "-"], gap.as_bytes(), 0).out;
    assert!(
        told.contains("caution: row 2 holds no numbers and was left out"),
        "{told}"
    );
    assert!(
        told.contains("180.0 mm through the points, 100.0 % of the robot's"),
        "{told}"
    );
    let ran = sinew(&["compare", &scene, "-", "--format", "csv"], gap.as_bytes());
    assert_eq!(ran.err, "note: row 2 holds no numbers and was left out\n");
    assert_eq!(ran.out.lines().count(), 20);
}

#[test]
fn a_pull_that_is_not_reached_is_compared_as_far_as_it_goes() {
    let scene = asset("wedge");
    let points = check(&["solve", &scene, "--pull", "10.149", "--format", "csv"], 0).out;
    let args = ["compare", &scene, "-", "--pull", "12", "--format", "json"];
    let ran = check_with(&args, points.as_bytes(), 3);
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    assert!((number(&found["pull_mm"]) - 10.15).abs() < 0.02);
    assert!(number(&found["rms_mm"]) < 0.1);
    assert!(
        ran.err.contains("the last good state, at pull 10.1"),
        "{}",
        ran.err
    );
}

#[test]
fn a_scene_gives_its_own_stiffness_and_calibration() {
    let measured = "[measured]\ncalibration = 1\n
        [[measured.force]]\nload_g = 50\nforce_g = 3.5\n
        [[measured.force]]\nload_g = 250\nforce_g = 17.8\n";
    let text = String::from_utf8(extended("load-cell", measured)).unwrap();
    let stiff = "bending_stiffness_nmm2 = 8747.09";
    let scene = text.replacen("bending_stiffness_nmm2 = 8000", stiff, 1);
    assert_ne!(scene, text);
    let force = |options: &[&str]| {
        let args = [&["force", "-", "--format", "json"], options].concat();
        json_of_input(&args, scene.as_bytes())
    };
    let by_flags = json(
        &[
            "force",
            &asset("load-cell"),
            "--format",
            "json",
            "--measured",
            "250:17.8",
            "--ei",
            "8747.09",
        ],
        0,
    );
    let by_scene = force(&[]);
    assert_eq!(by_scene["loads"], by_flags["loads"]);
    assert_eq!(by_scene["mu"], by_flags["mu"]);
    let multipliers = &by_scene["by_multipliers"];
    assert_eq!(multipliers["ei_from"], "robot.bending_stiffness_nmm2");
    assert_eq!(
        by_scene["mu_from"],
        "measured.calibration, 17.8 g under 250 g"
    );

    let overruled = force(&["--friction", "-0.5", "--rod", "2.2:3"]);
    assert_eq!(overruled["mu_from"], "--friction");
    assert_eq!(number(&overruled["mu"]), -0.5);
    assert_eq!(overruled["by_multipliers"]["ei_from"], "--rod");
    assert_eq!(force(&["--measured", "50:3.5"])["mu_from"], "--measured");
    let told = check_with(&["force", "-"], scene.as_bytes(), 0).out;
    assert!(told.contains("8747.1 N mm² (robot.bending_stiffness_nmm2)"));
}

#[test]
fn measured_points_that_make_no_sense_are_refused_by_row() {
    let scene = asset("free");
    for (points, sentence) in [
        (
            "",
            "there are no measured points; give at least 2, base to tip",
        ),
        (
            "x_mm,y_mm\n1,9\n",
            "there is only 1 of the at least 2 measured points that a comparison needs; add some",
        ),
        (
            "x_mm,y_mm\n0,0\n1;9\n",
            "row 3: x_mm is \"1;9\", which is not a number; write numbers as 12.5",
        ),
        ("0,0\n# a remark\n1,9\n2\n", "row 4: y_mm is missing"),
        (
            "0,0\n1,9\n0,0\n",
            "row 3 is the same point as row 1; leave one of them out",
        ),
        (
            "0,0\n0,90\n0,40\n",
            "row 3 turns back along the robot; order rows from base to tip, or name the nodes that they are",
        ),
        (
            "x,y\n0,0\n0.01,0.09\n0.02,0.18\n",
            "the points are 0.181 mm long and the robot there is 180 mm long, as if they were in \
             metres; write them in mm, or name the unit in the head of their table, as in x_m,y_m",
        ),
        (
            "0,0\n1,9\n2,18\n",
            "the points are 18.1 mm long and the robot there is 180 mm long, as if they were in \
             centimetres; write them in mm, or name the unit in the head of their table, as in \
             x_cm,y_cm",
        ),
        (
            "0,0,0\n1,0,90\n2,0,180\n",
            "row 1: there are 3 columns and no head that tells which are x and y; write one such as \
             node,x_mm,y_mm above the numbers, and numbers as 12.5, with a point",
        ),
        (
            "0,0\n0,10\n0,20000\n",
            "row 3 is 20000.0 mm from the base, and the robot is 180.0 mm long; check its unit (mm) \
             and its origin (the scene's)",
        ),
        (
            "node,x_mm,y_mm\n0,0,0\n1.5,0,10\n",
            "row 3: node is 1.5; nodes count 0, 1, 2 and so on from the base",
        ),
        (
            "left,right\n1,2\n",
            "row 1: the head names no columns x_mm and y_mm (a column node may be there too)",
        ),
    ] {
        let args = ["compare", &scene, "-"];
        let told = format!("standard input: {sentence}");
        check_refused(&args, points.as_bytes(), &told);
    }
    check_refused(
        &["compare", "-", "-"],
        b"",
        "the scene and the measured backbone cannot both be standard input",
    );
    check_refused(
        &["compare", &scene, "nowhere.csv"],
        b"",
        "nowhere.csv: there is no such file",
    );
}

#[test]
fn what_a_scene_says_was_measured_is_checked_as_it_is_compared() {
    let free = fs::read_to_string(asset("free")).unwrap();
    let with = |points: &str| format!("{free}\n[measured]\npoints_mm = {points}\n");
    for command in ["check", "compare"] {
        check_with(&[command, "-"], with("[[0, 90], [0, 180]]").as_bytes(), 0);
        for (points, sentence) in [
            ("[[0, 90]]", "has 1 of the at least 2 entries it needs"),
            (
                "[[0, 90], [0, 20000]]",
                "row 2 is 20000.0 mm from the base, and the robot is 180.0 mm long; check its \
                 unit (mm) and its origin (the scene's)",
            ),
        ] {
            let ran = sinew(&[command, "-"], with(points).as_bytes());
            assert_eq!(ran.code, 2, "{command}");
            let told = ran.err.contains("measured.points_mm") && ran.err.contains(sentence);
            assert!(told, "{command}: {}", ran.err);
        }
    }
}

#[test]
fn the_papers_figures_are_reproduced_into_a_report() {
    let folder = temporary("report");
    let out = folder.to_str().unwrap();
    let text = check(&["reproduce", "--out", out], 0).out;
    for name in [
        "Fig. 3b", "Fig. 4a", "Fig. 4b", "Fig. 5", "Fig. 7", "Fig. 9", "Fig. 10a", "Fig. 10b",
        "Table 1",
    ] {
        assert!(text.contains(&format!("{name}  ")), "{name}");
    }
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    // Everything it shows is inside: only its own data is linked.
    for outside in [
        "src=\"http",
        "href=\"http",
        "<script",
        "@import",
        "url(http",
    ] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.contains("<svg") && page.contains("prefers-color-scheme"));
    for name in ["data/table1-force.csv", "data/table1-comparison.csv"] {
        assert!(folder.join(name).is_file(), "{name}");
    }
    for link in page.split("href=\"data/").skip(1) {
        let name = link.split('"').next().unwrap();
        assert!(folder.join("data").join(name).is_file(), "{name}");
    }
    let some = json(
        &[
            "reproduce",
            "Fig. 4b",
            "table1",
            "--out",
            out,
            "--format",
            "json",
        ],
        0,
    );
    assert_eq!(some["schema"], "sinew-reproduce-1");
    let ids: Vec<_> = list(&some["items"]).iter().map(|i| &i["id"]).collect();
    assert_eq!(ids, ["fig4b", "table1"]);
    let errors = list(&some["items"][1]["checks"]).iter();
    let theory = errors.filter(|c| c["quantity"].as_str().unwrap().starts_with("Theory at"));
    let differences: Vec<_> = theory.map(|c| number(&c["difference"])).collect();
    assert_eq!(differences.len(), 7);
    assert!(
        differences.iter().all(|d| d.abs() <= 0.1),
        "{differences:?}"
    );
    check_refused(
        &["reproduce", "fig6", "--out", out],
        b"",
        "fig6 is no figure or table that can be recomputed; choose from fig3b, fig4a, fig4b, \
         fig5, fig7, fig9, fig10a, fig10b, table1",
    );
    let file = temporary("in-the-way");
    fs::write(&file, "").unwrap();
    let ran = sinew(&["reproduce", "fig5", "--out", file.to_str().unwrap()], b"");
    assert_eq!(ran.code, 1);
    assert!(
        ran.err.starts_with("error: cannot write the results: "),
        "{}",
        ran.err
    );
}

const PAIR: &str = r#"
    version = 2
    robot = { length_mm = 180, segments = 18, bending_stiffness_nmm2 = 8000 }
    loads = { gravity_m_s2 = [0, -9.8] }
    cable = [{ offset_mm = 8, pull_mm = 5.5 }, { offset_mm = -7, load_g = 0, to_disk = 5 }]
    obstacle = [{ name = "post", shape = "disc", center_mm = [37, 92], radius_mm = 12 }]
"#;

/// Two cables that slide, one of them slack, from a JSON of every key.
#[test]
fn sliding_cables_are_told_each_by_itself() {
    let scene = PAIR.as_bytes();
    let state = json_of_input(&["solve", "-", "--format", "json"], scene);
    check_state(&state, 18);
    assert_eq!(
        (&state["mechanics"], &state["space"]),
        (&"sliding".into(), &"plane".into())
    );
    assert_eq!(number(&state["share"]), 1.0);
    assert!(state.get("pull_mm").is_none() && state.get("cable_mm").is_none());
    assert_eq!(state["stable_under_load"], true);
    let [tense, slack] = list(&state["cables"]) else {
        panic!("{state}")
    };
    assert_eq!(
        keys(tense),
        [
            "angle_deg",
            "holes_mm",
            "load_n",
            "multiplier",
            "offset_mm",
            "points_mm",
            "pull_mm",
            "slack",
            "slips",
            "tension_n",
            "tensions_n",
            "to_disk"
        ]
    );
    assert!((number(&tense["pull_mm"]) - 5.5).abs() < 1e-9);
    assert_eq!(
        (&tense["slack"], &slack["slack"]),
        (&false.into(), &true.into())
    );
    let tension = number(&tense["tension_n"]);
    assert!(tension > 1.0 && number(&slack["tension_n"]) == 0.0);
    assert_eq!(list(&tense["tensions_n"]).len(), 9);
    assert!(
        list(&tense["tensions_n"])
            .iter()
            .all(|part| number(part) == tension)
    );
    assert_eq!(
        (
            list(&tense["points_mm"]).len(),
            list(&tense["holes_mm"]).len()
        ),
        (19, 10)
    );
    assert_eq!(
        (
            list(&slack["points_mm"]).len(),
            list(&slack["holes_mm"]).len()
        ),
        (11, 6)
    );
    assert_eq!(number(&slack["offset_mm"]), -7.0);
    // Between disks a cable is straight.
    let at = |place: &Value, axis: usize| number(&place[axis]);
    for k in 0..9 {
        for axis in 0..2 {
            let (low, high) = (&tense["holes_mm"][k], &tense["holes_mm"][k + 1]);
            let middle = 0.5 * (at(low, axis) + at(high, axis));
            assert!((middle - at(&tense["points_mm"][2 * k + 1], axis)).abs() < 1e-9);
        }
    }
    for contact in list(&state["contacts"]) {
        let force = number(&contact["force_n"]);
        let per_bend = 8000.0 / 20.0;
        assert!((force - per_bend * number(&contact["multiplier"])).abs() <= 1e-12 * force);
    }
    let warned = list(&state["cautions"])
        .iter()
        .any(|it| it["what"] == "weightless");
    assert!(warned, "{}", state["cautions"]);
    let event = &list(&state["events"])[0];
    let share = number(&event["share"]);
    assert!((number(&event["cables"][0]["pull_mm"]) - 5.5 * share).abs() < 1e-9);
    assert!(event["cables"][1]["pull_mm"].is_null());
    let text = check_with(&["solve", "-"], scene, 0).out;
    for part in [
        "mechanics    sliding: the cables slide through the disks",
        "  cable 0      at 8 mm to disk 9: pull 5.5 mm, tension ",
        "  cable 1      at -7 mm to disk 5: pull -",
        ", slack",
        " g (",
        "Gravity does nothing",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    let checked = check_with(&["check", "-"], scene, 0).out;
    for part in [
        "2 cables slide through the disks: at 8 mm by a pull of 5.5 mm, at -7 mm to disk 5 by a load of 0 g.",
        "Gravity does nothing",
    ] {
        assert!(checked.contains(part), "{part} is not in {checked}");
    }
    let other = [
        "solve", "-", "--load", "80", "--cable", "1", "--format", "json",
    ];
    let loaded = json_of_input(&other, scene);
    let load = number(&loaded["cables"][1]["load_n"]);
    assert!((load - 0.08 * 9.80665).abs() < 1e-9);
    let path = ["solve", "-", "--path", "4", "--format", "json"];
    for (index, state) in list(&json_of_input(&path, scene)["states"])
        .iter()
        .enumerate()
    {
        assert_eq!(number(&state["share"]), index as f64 / 4.0);
        check_state(state, 18);
    }
    check_with(&["solve", "-", "--path", "4"], scene, 0);
    check_with(&["solve", "-", "--path", "4", "--format", "csv"], scene, 0);
    check_with(&["solve", "-", "--repeat", "2"], scene, 0);
    check_with(&["draw", "-", "-o", "-"], scene, 0);
    for (args, sentence) in [
        (
            &["solve", "-", "--load", "3"][..],
            "--load names no cable, and standard input has 2; add --cable with 0 to 1",
        ),
        (
            &["draw", "-", "-o", "-", "--pull", "3"],
            "--pull names no cable, and standard input has 2; add --cable with 0 to 1",
        ),
        (
            &["solve", "-", "--pull", "3", "--cable", "2"],
            "--cable 2 is not there; standard input has cables 0 to 1",
        ),
        (
            &["solve", "-", "--load", "-3", "--cable", "1"],
            "standard input: --load is -3 g; set it to a value from 0 to 1000000 g",
        ),
        (
            &["force", "-", "--measured", "250:17.8"],
            "--measured is about virtual work, which is an estimate for the paper's model; leave \
             it out, or set model.mechanics to \"equal\"",
        ),
    ] {
        check_refused(args, scene, sentence);
    }
}

/// The load cell without friction: a force of 0.09 of the load, and no virtual work.
#[test]
fn forces_of_a_sliding_cable_come_without_virtual_work() {
    let scene = asset("load-cell");
    let force = |more: &[&str], code| {
        let args = [&["force", &scene, "--set", "model.mechanics=sliding"], more].concat();
        check(&args, code).out
    };
    let found: Value = serde_json::from_str(&force(&["--format", "json"], 0)).unwrap();
    assert_eq!(found["mechanics"], "sliding");
    assert!(found.get("mu").is_none());
    for row in list(&found["loads"]) {
        let share = number(&row["multipliers"]["force_g"]) / number(&row["load_g"]);
        assert!((0.085..0.1).contains(&share), "{share}");
        assert!(row.get("force_x_g").is_none());
    }
    // Forces of loads counted from contact do not depend on the stiffness by much.
    let stiffer: Value =
        serde_json::from_str(&force(&["--ei", "9000", "--format", "json"], 0)).unwrap();
    assert!((number(&stiffer["by_multipliers"]["ei_nmm2"]) - 9000.0).abs() < 1e-6);
    let table = force(&["--format", "csv"], 0);
    assert!(
        table.starts_with("load_g,pull_mm,tension_g,multipliers_g\n"),
        "{table}"
    );
    let text = force(&[], 0);
    assert!(
        text.contains("Cables that slide through the disks"),
        "{text}"
    );
    assert!(!text.contains("irtual"), "{text}");
    let solved = check(&["solve", &scene, "--set", "model.mechanics=sliding"], 0).out;
    assert!(!solved.contains("link"), "{solved}");
}

/// What a cable presses with that slides without friction stands beside the paper's
/// model, and beside friction; where nothing else is asked for it is not told twice.
#[test]
fn forces_without_friction_come_beside_others() {
    let scene = asset("load-cell");
    let sliding = ["--set", "model.mechanics=sliding"];
    let rubbing = [
        "--set",
        "friction.holes=0.275",
        "--set",
        "friction.contacts=0.275",
    ];
    let force = |more: &[&str]| json(&[&["force", &scene, "--format", "json"], more].concat(), 0);
    let alone = force(&sliding);
    assert!(alone.get("frictionless").is_none());
    let lists = [force(&[]), force(&[&sliding[..], &rubbing[..]].concat())];
    for found in &lists {
        let rows = list(&found["loads"]).iter().zip(list(&alone["loads"]));
        for (row, expected) in rows {
            let force = number(&row["frictionless_force_g"]);
            let expected = number(&expected["multipliers"]["force_g"]);
            assert!((force - expected).abs() < 1e-9, "{force} {expected}");
            assert!(number(&row["multipliers"]["force_g"]) < 0.95 * force);
        }
        let datum = |found: &Value, key: &str| number(&found[key]["tension_at_contact_g"]);
        let (beside, own) = (
            datum(found, "frictionless"),
            datum(&alone, "by_multipliers"),
        );
        assert!((beside - own).abs() < 1e-9);
    }
    let rubbed = check(
        &[&["force", &scene], &sliding[..], &rubbing[..]].concat(),
        0,
    )
    .out;
    assert!(rubbed.contains("no friction") && rubbed.contains("Without friction: contact"));
    let papers = check(&["force", &scene], 0).out;
    assert!(
        papers.contains("With a cable that slides without friction: contact"),
        "{papers}"
    );
}

/// Readings of the load cell, by the program: in every format, with what is the matter
/// told by its row.
#[test]
fn constants_are_fitted_to_readings() {
    let scene = asset("load-cell");
    let rows = "load_from_contact_g,force_g\n100,7.6\n200,15.1\n300,22.9\n";
    let with = |more: &[&str], rows: &str, code| {
        let args = [&["calibrate", &scene, "-"], more].concat();
        let ran = sinew(&args, rows.as_bytes());
        assert_eq!(ran.code, code, "{args:?}: {}", ran.err);
        assert_eq!(ran.err.is_empty(), code == 0, "{args:?}: {}", ran.err);
        // No state is any nearer to a fit than none.
        assert_eq!(ran.out.is_empty(), code != 0, "{args:?}: {}", ran.out);
        ran
    };
    let fit = ["--fit", "base_loss"];
    let told = with(&fit, rows, 0);
    for part in [
        "Load cell (Fig. 9)",
        "RMS",
        "over 3 forces",
        "friction.base_loss",
    ] {
        assert!(told.out.contains(part), "{part} in {}", told.out);
    }
    assert!(
        told.out.contains("sliding (the scene says equal"),
        "{}",
        told.out
    );
    let format = |format| with(&[&fit[..], &["--format", format]].concat(), rows, 0).out;
    let found: Value = serde_json::from_str(&format("json")).unwrap();
    assert_eq!(found["schema"], "sinew-calibration-1");
    let loss = &found["constants"][0];
    assert!((0.1..0.2).contains(&number(&loss["value"])), "{loss}");
    assert_eq!(loss["key"], "friction.base_loss");
    assert_eq!(list(&found["rows"]).len(), 3);
    let table = format("csv");
    assert!(table.starts_with("row,load_g,pull_mm,read_pull_mm,force_g,read_force_g\n2,"));

    // Two that nothing tells apart: a straight line fixes one number.
    let both = with(&["--fit", "contacts,base_loss"], rows, 0).out;
    let sentence = "The data cannot tell contacts and base_loss apart";
    assert!(both.contains(sentence), "{both}");

    for (more, rows, code, sentence) in [
        (
            &["--fit", "hole"],
            rows,
            2,
            "error: --fit: \"hole\" cannot be fitted",
        ),
        (
            &fit,
            "load_g,force_g\n1,x\n",
            2,
            "error: standard input: row 2: force_g is \"x\"",
        ),
        (
            &fit,
            "load_g\n1\n",
            2,
            "error: standard input: row 1: nothing was measured",
        ),
        (
            &fit,
            "pull_mm,force_g\n3,5\n90,5\n",
            3,
            "error: standard input: row 3: with base_loss = 0.1000 no equilibrium is found: ",
        ),
    ] {
        let told = with(more, rows, code).err;
        assert!(told.contains(sentence), "{told}");
    }
    let told = with(&[&fit[..], &["--force-error", "0"]].concat(), rows, 2).err;
    assert!(
        told.contains("--force-error is 0 g; it has to be above 0"),
        "{told}"
    );
}

/// A cable that would have to bend the robot further than its disks allow: told without
/// a word of linkages, with how far it got.
#[test]
fn a_sliding_robot_has_no_linkage_to_lock() {
    let scene = "version = 2
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 30 }
        actuation = { pull_mm = 175 }";
    let ran = check_with(&["solve", "-"], scene.as_bytes(), 3);
    for text in [&ran.out, &ran.err] {
        assert!(text.contains("what the robot's own parts allow"), "{text}");
        assert!(!text.contains("link"), "{text}");
    }
    assert!(
        ran.out.contains(" mm of the 175 mm asked for"),
        "{}",
        ran.out
    );
}
