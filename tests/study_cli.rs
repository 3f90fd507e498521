//! `sinew explore` and `sinew merge` as their users meet them: the same table on any
//! number of threads, in shards, and after being stopped anywhere; and what they refuse.

use std::fs::{self, OpenOptions};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use sinew::scene::Scene;
use sinew::study::{Study, StudyFile, log};

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");
const STUDY: &str = r#"
version = 1
title = "A small study"
scene = "scene.toml"
sampler = "latin"
samples = 200
seed = 3
outputs = ["tip_x_mm", "force_max_n", "status", "tension_n"]
constraints = ["force_max_n < 0.001", "status == converged"]
[[parameter]]
key = "robot.disks"
from = 3
to = 12
[[parameter]]
key = "robot.cable_offset_mm"
from = -1
to = 10
[[parameter]]
key = "actuation.pull_mm"
from = 0.5
to = 5
"#;

/// A folder that is empty at a test's start.
struct Desk(PathBuf);

impl Desk {
    /// With the study and its scene.
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("study-cli")
            .join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        let desk = Self(path);
        desk.put("study.toml", STUDY);
        desk.put("scene.toml", SCENE);
        desk
    }

    fn put(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).unwrap();
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).unwrap()
    }

    fn text(&self, name: &str) -> String {
        String::from_utf8(self.bytes(name)).unwrap()
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sinew"));
        command.current_dir(&self.0).args(args);
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        command
    }

    /// Runs the program. Returns what it says on standard output and error.
    #[track_caller]
    fn run(&self, args: &[&str], code: i32) -> (String, String) {
        let output = self.command(args).output().unwrap();
        let [out, err] =
            [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        assert_eq!(output.status.code(), Some(code), "{args:?}: {err}");
        assert!(!err.contains("panicked"), "{args:?}: {err}");
        (out, err)
    }

    #[track_caller]
    fn refused(&self, args: &[&str], code: i32, expected: &str) {
        let (out, err) = self.run(args, code);
        assert_eq!(
            (out.as_str(), err.as_str()),
            ("", format!("error: {expected}\n").as_str())
        );
    }

    fn study(&self) -> Study {
        let file = StudyFile::from_toml(&self.text("study.toml")).unwrap();
        let scene = Scene::from_toml(&self.text("scene.toml")).unwrap();
        Study::new(file, scene).unwrap()
    }
}

/// The table that the library makes of a study.
fn expected(study: &Study) -> String {
    let mut lines = vec![study.columns().join(",")];
    for index in 0..study.samples() {
        let cells = study.cells(index, &study.compute(index));
        // Reasons have commas.
        let quoted = cells.iter().map(|cell| match cell.contains([',', '"']) {
            true => format!("\"{}\"", cell.replace('"', "\"\"")),
            false => cell.clone(),
        });
        lines.push(quoted.collect::<Vec<_>>().join(","));
    }
    lines.join("\n") + "\n"
}

/// How many samples a run says that it computed.
fn computed(out: &str) -> u64 {
    let line = out
        .lines()
        .find_map(|line| line.trim().strip_prefix("computed"));
    let word = line.unwrap().split_whitespace().next().unwrap();
    match word {
        "nothing" => 0,
        count => count.parse().unwrap(),
    }
}

#[test]
fn any_number_of_threads_and_shards_gives_the_librarys_table() {
    let desk = Desk::new("threads");
    let expected = expected(&desk.study());
    for verdict in ["converged", "bad_scene"] {
        assert!(expected.contains(verdict), "{verdict}");
    }
    for threads in ["1", "2", "3"] {
        let (out, err) = desk.run(
            &[
                "explore",
                "study.toml",
                "--threads",
                threads,
                "--out",
                threads,
            ],
            0,
        );
        assert_eq!(err, "");
        assert_eq!(computed(&out), 200, "{out}");
        assert!(out.starts_with("A small study\n"), "{out}");
        assert_eq!(desk.text(&format!("{threads}/results.csv")), expected);
    }
    // In shards, in one folder and in several, merged in any order.
    for (shard, folder) in [("1/3", "a"), ("3/3", "a"), ("2/3", "b")] {
        let args = ["explore", "study.toml", "--shard", shard, "--out", folder];
        let (out, _) = desk.run(&args, 0);
        assert!((66..=67).contains(&computed(&out)), "{out}");
        assert!(out.contains(&format!("sinew merge {folder}")), "{out}");
    }
    assert!(!desk.0.join("a/results.csv").exists());
    let (out, _) = desk.run(&["merge", "b", "a"], 0);
    assert!(out.contains("200 of 200"), "{out}");
    assert_eq!(desk.text("b/results.csv"), expected);
    desk.run(&["merge", "a", "b", "--out", "all.csv"], 0);
    assert_eq!(desk.text("all.csv"), expected);
    let (out, _) = desk.run(&["merge", "a", "b", "--out", "-"], 0);
    assert_eq!(out, expected);
    // What is missing is named.
    desk.refused(
        &["merge", "a"],
        2,
        "67 of the 200 samples are missing: 66 to 132; compute them with sinew explore --resume, \
         name the folders that have them, or add --partial",
    );
    desk.run(&["merge", "a", "--partial", "--out", "part.csv"], 0);
    let part = desk.text("part.csv");
    assert_eq!(part.lines().count(), 1 + 133);
    assert!(part.lines().all(|line| expected.contains(line)));
    // The table of its own copy of the study.
    desk.run(&["explore", "b/results.study.toml", "--out", "again"], 0);
    assert_eq!(desk.text("again/results.csv"), expected);
}

/// Where the whole chunks of a log end, and the samples up to there.
fn ends(bytes: &[u8], width: u32) -> Vec<(usize, u64)> {
    let mut ends = vec![(log::HEAD_BYTES, 0)];
    let mut at = log::HEAD_BYTES;
    let mut samples = 0;
    while let Some(length) = log::chunk_bytes(&bytes[at..], width) {
        let (_, rows) = log::rows(&bytes[at..at + length], width).unwrap();
        at += length;
        samples += rows.len() as u64;
        ends.push((at, samples));
    }
    assert_eq!(at, bytes.len());
    ends
}

#[test]
fn stopped_at_any_byte_a_study_goes_on_and_loses_one_chunk() {
    let desk = Desk::new("stopped");
    desk.run(
        &["explore", "study.toml", "--threads", "1", "--out", "out"],
        0,
    );
    let expected = desk.bytes("out/results.csv");
    let whole = desk.bytes("out/results.log");
    let ends = ends(&whole, desk.study().computed().len() as u32);
    assert!(ends.len() > 3, "{ends:?}");
    let step = whole.len() / 24;
    let near = ends.iter().flat_map(|(end, _)| [end - 1, *end, end + 1]);
    let mut cuts: Vec<usize> = near.chain((0..whole.len()).step_by(step)).collect();
    cuts.retain(|cut| *cut < whole.len());
    for cut in cuts {
        fs::write(desk.0.join("out/results.log"), &whole[..cut]).unwrap();
        let _ = fs::remove_file(desk.0.join("out/results.csv"));
        let args = [
            "explore",
            "study.toml",
            "--out",
            "out",
            "--resume",
            "--threads",
            "2",
        ];
        let (out, err) = desk.run(&args, 0);
        let kept = ends.iter().rfind(|(end, _)| *end <= cut);
        let (at, kept) = kept.copied().unwrap_or((0, 0));
        assert_eq!(computed(&out), 200 - kept, "{cut}: {out}");
        assert_eq!(desk.bytes("out/results.csv"), expected, "{cut}");
        // What is cut off is told.
        let told = format!("its last {} bytes were cut off", cut - at);
        assert_eq!(err.contains(&told), cut > at, "{cut}: {err}");
        assert_eq!(err.is_empty(), cut == at, "{cut}: {err}");
    }
    // Nothing more is done by going on again.
    let args = ["explore", "study.toml", "--out", "out", "--resume"];
    let (out, err) = desk.run(&args, 0);
    assert_eq!((computed(&out), err.as_str()), (0, ""));
    assert_eq!(desk.bytes("out/results.csv"), expected);
}

#[test]
fn a_byte_that_changed_costs_its_chunk_and_no_other() {
    let desk = Desk::new("changed");
    let args = ["explore", "study.toml", "--threads", "1", "--out", "out"];
    desk.run(&args, 0);
    let expected = desk.bytes("out/results.csv");
    let mut bytes = desk.bytes("out/results.log");
    let ends = ends(&bytes, desk.study().computed().len() as u32);
    let [(start, before), (end, after), (_, whole), ..] = ends[..] else {
        panic!("{ends:?}");
    };
    assert!(before < after && after < whole);
    bytes[(start + end) / 2] ^= 4;
    fs::write(desk.0.join("out/results.log"), &bytes).unwrap();
    let (out, _) = desk.run(&["explore", "study.toml", "--out", "out", "--resume"], 0);
    assert_eq!(computed(&out), after - before);
    assert_eq!(desk.bytes("out/results.csv"), expected);
}

#[test]
fn a_killed_process_leaves_what_it_had() {
    let desk = Desk::new("killed");
    let more = STUDY.replace("samples = 200", "samples = 4000");
    desk.put("study.toml", &more);
    let args = ["explore", "study.toml", "--out", "out", "--threads", "2"];
    let mut child = desk.command(&args).stdout(Stdio::null()).spawn().unwrap();
    let path = desk.0.join("out/results.log");
    let bytes = || fs::metadata(&path).map_or(0, |about| about.len());
    // As soon as something is there.
    while bytes() < 1000 && child.try_wait().unwrap().is_none() {
        thread::yield_now();
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let there = bytes();
    let resume = ["explore", "study.toml", "--out", "out", "--resume"];
    let (out, _) = desk.run(&resume, 0);
    assert!(there >= 1000 && computed(&out) < 4000, "{there}: {out}");
    desk.run(
        &[
            "explore",
            "study.toml",
            "--out",
            "at-once",
            "--threads",
            "1",
        ],
        0,
    );
    assert!(desk.bytes("out/results.csv") == desk.bytes("at-once/results.csv"));
}

#[test]
fn what_it_would_take_is_told_before_it_is_done() {
    let desk = Desk::new("explain");
    let args = [
        "explore",
        "study.toml",
        "--explain",
        "--out",
        "none",
        "--threads",
        "2",
    ];
    let (out, err) = desk.run(&args, 0);
    assert_eq!(err, "");
    for told in [
        "A small study",
        "samples     200 of a Latin hypercube with seed 3",
        "robot.cable_offset_mm: -1 to 10",
        "outputs     tip_x_mm, force_max_n, status, tension_n",
        "in steps of at most 1/16 of its cable",
        " on 2 threads, by ",
        " of log and ",
    ] {
        assert!(out.contains(told), "{told}: {out}");
    }
    assert!(!desk.0.join("none").exists());
    let (out, _) = desk.run(&["explore", "study.toml", "--explain", "--shard", "1/4"], 0);
    assert!(out.contains("samples     200 of a Latin hypercube with seed 3, 50 of them to do"));
    // The room is about what the files then have.
    desk.run(&["explore", "study.toml", "--out", "out"], 0);
    let line = out
        .lines()
        .find(|line| line.trim().starts_with("room"))
        .unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    let told = |at: usize| -> f64 {
        let unit = if words[at + 1] == "kB" { 1e3 } else { 1.0 };
        unit * words[at].parse::<f64>().unwrap()
    };
    for (at, name) in [(2, "out/results.log"), (7, "out/results.csv")] {
        let quarter = desk.bytes(name).len() as f64 / 4.0;
        let share = told(at) / quarter;
        assert!((0.7..1.4).contains(&share), "{name}: {line}");
    }
    let (out, _) = desk.run(
        &[
            "explore",
            "study.toml",
            "--explain",
            "--resume",
            "--out",
            "out",
        ],
        0,
    );
    assert!(out.contains("nothing is left to do"), "{out}");
}

#[test]
fn a_row_is_what_solve_prints() {
    let desk = Desk::new("solve");
    desk.run(&["explore", "study.toml", "--out", "out"], 0);
    let mut table = csv(&desk.text("out/results.csv"));
    let head = table.remove(0);
    let column = |name: &str| head.iter().position(|one| one == name).unwrap();
    let mut solved = 0;
    for row in table.iter().step_by(23) {
        let mut args = vec![
            "solve".to_owned(),
            "scene.toml".to_owned(),
            "--format=json".to_owned(),
        ];
        for key in ["robot.disks", "robot.cable_offset_mm", "actuation.pull_mm"] {
            let value = row[column(key)].trim_end_matches(".0");
            args.push("--set".to_owned());
            args.push(format!("{key}={value}"));
        }
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let output = desk.command(&args).output().unwrap();
        let status = &row[column("status")];
        if status == "bad_scene" {
            assert_eq!(output.status.code(), Some(2));
            let told = String::from_utf8(output.stderr).unwrap();
            assert!(told.contains(&row[column("reason")]), "{told}");
            continue;
        }
        // Text for text: the very same bits.
        let printed = String::from_utf8(output.stdout).unwrap();
        let check = |told: String| assert!(printed.contains(&told), "{told}: {printed}");
        check(format!("\"status\":\"{status}\""));
        if status == "converged" {
            solved += 1;
            check(format!("\"tip_mm\":[{},", row[column("tip_x_mm")]));
            check(format!("\"tension_n\":{},", row[column("tension_n")]));
        }
    }
    assert!(solved > 4, "{solved}");
}

/// The cells of a table without line breaks in them.
fn csv(text: &str) -> Vec<Vec<String>> {
    let line = |line: &str| {
        let mut cells = vec![String::new()];
        let mut quoted = false;
        for letter in line.chars() {
            match letter {
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                letter => cells.last_mut().unwrap().push(letter),
            }
        }
        cells
    };
    text.lines().map(line).collect()
}

#[test]
fn another_studys_results_are_refused_and_left() {
    let desk = Desk::new("another");
    desk.run(&["explore", "study.toml", "--out", "out"], 0);
    let files = [
        "results.log",
        "results.csv",
        "results.study.toml",
        "results.scene.toml",
    ];
    let all = || files.map(|name| desk.bytes(&format!("out/{name}")));
    let before = all();
    desk.refused(
        &["explore", "study.toml", "--out", "out"],
        2,
        "out has 200 of these 200 samples already; go on with --resume, or name another folder \
         with --out",
    );
    let other = "has results of another study, scene or version of this program; they are as \
                 they were; name another folder with --out";
    let moved = [
        "explore",
        "study.toml",
        "--out",
        "out",
        "--set",
        "robot.length_mm=170",
    ];
    for more in [
        &[][..],
        &["--resume"],
        &["--shard", "1/2"],
        &["--explain", "--resume"],
    ] {
        let args = [&moved, more].concat();
        desk.refused(&args, 2, &format!("out/results.log {other}"));
    }
    desk.put("other.toml", &STUDY.replace("seed = 3", "seed = 4"));
    let args = ["explore", "other.toml", "--out", "out", "--resume"];
    desk.refused(&args, 2, &format!("out/results.log {other}"));
    desk.run(&["explore", "other.toml", "--out", "beside"], 0);
    desk.refused(
        &["merge", "out", "beside"],
        2,
        &format!("beside/results.log {other}"),
    );
    assert!(all() == before);
    // Whatever else is in the way.
    for (name, told) in [
        (
            "results.log",
            "the file is no log of a study's results; it is as it was; name another folder with --out",
        ),
        (
            "results.csv",
            "is there already, without the results that it would be made of; name another folder with --out",
        ),
        (
            "results.study.toml",
            "is there already and is not of this study; name another folder with --out",
        ),
    ] {
        let desk = Desk::new("in-the-way");
        fs::create_dir(desk.0.join("out")).unwrap();
        desk.put(
            &format!("out/{name}"),
            "something of mine, and long enough to be told from a log",
        );
        let colon = if name == "results.log" { ":" } else { "" };
        let expected = format!("out/{name}{colon} {told}");
        desk.refused(&["explore", "study.toml", "--out", "out"], 2, &expected);
        assert!(
            desk.text(&format!("out/{name}"))
                .starts_with("something of mine")
        );
    }
}

#[test]
fn two_at_one_log_do_not_mix() {
    let desk = Desk::new("two");
    fs::create_dir(desk.0.join("out")).unwrap();
    let path = desk.0.join("out/results.log");
    let mut options = OpenOptions::new();
    let file = options
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)
        .unwrap();
    file.try_lock().unwrap();
    desk.refused(
        &["explore", "study.toml", "--out", "out", "--resume"],
        2,
        "out/results.log is being written by another sinew; wait for it, or name another folder \
         with --out",
    );
    file.unlock().unwrap();
    desk.run(&["explore", "study.toml", "--out", "out", "--resume"], 0);
}

#[test]
fn what_cannot_be_done_is_told() {
    let desk = Desk::new("told");
    desk.put(
        "wrong.toml",
        &STUDY.replace("\"tension_n\"", "\"tensoin_n\""),
    );
    desk.refused(
        &["explore", "wrong.toml"],
        2,
        "wrong.toml: outputs[3], \"tensoin_n\", is not an output; did you mean `tension_n`?",
    );
    desk.put("wrong.toml", &STUDY.replace("scene.toml", "scne.toml"));
    desk.refused(
        &["explore", "wrong.toml"],
        2,
        "scne.toml: there is no such file",
    );
    desk.refused(
        &["explore", "none.toml"],
        2,
        "none.toml: there is no such file",
    );
    desk.refused(
        &["explore", "."],
        2,
        ".: this is a directory; a study is a TOML text file",
    );
    desk.refused(
        &["explore", "study.toml", "--shard", "3/2"],
        2,
        "--shard is \"3/2\"; write K/N with K from 1 to N, and N at most 100000, such as 2/8",
    );
    desk.refused(
        &["merge", "."],
        2,
        ". has no results.study.toml; name a folder that sinew explore has written",
    );
    // A file where the folder should be.
    let (out, err) = desk.run(&["explore", "study.toml", "--out", "study.toml/in"], 1);
    assert_eq!(out, "");
    assert!(
        err.starts_with("error: cannot write the results: study.toml/in"),
        "{err}"
    );
    assert!(!desk.0.join("sinew-study").exists());
    // Nothing is asked for.
    let (_, err) = desk.run(&["explore"], 2);
    assert!(err.contains("STUDY"), "{err}");
}

#[cfg(target_os = "linux")]
#[test]
fn where_no_more_can_be_written_it_is_told_and_what_was_there_is_kept() {
    let desk = Desk::new("full");
    // Files of more than 2 kB are refused to it, as on a disk that is full.
    let limited = "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$@\"";
    let output = Command::new("sh")
        .current_dir(&desk.0)
        .args(["-c", limited, env!("CARGO_BIN_EXE_sinew")])
        .args(["explore", "study.toml", "--out", "out", "--threads", "1"])
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert!(
        err.starts_with("error: cannot write the results: out/results.log: "),
        "{err}"
    );
    let kept = "; what was computed is kept, and --resume goes on\n";
    assert!(err.ends_with(kept), "{err}");
    let (out, _) = desk.run(&["explore", "study.toml", "--out", "out", "--resume"], 0);
    assert!((1..200).contains(&computed(&out)), "{out}");
    assert_eq!(desk.text("out/results.csv"), expected(&desk.study()));
}

#[test]
fn outputs_are_listed_with_their_units() {
    let desk = Desk::new("outputs");
    let (out, _) = desk.run(&["explore", "--outputs"], 0);
    assert_eq!(out.lines().count(), sinew::study::Output::all().count());
    let line = out
        .lines()
        .find(|line| line.starts_with("tension_n "))
        .unwrap();
    assert_eq!(
        line.split_whitespace().collect::<Vec<_>>()[..3],
        ["tension_n", "N", "largest"]
    );
}
