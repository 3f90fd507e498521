//! How many samples of a design are computed in a second.
//!
//! `cargo bench --bench study` prints, of the robot against two discs with 6 to 44
//! segments, two a bay, cable offsets of 4 to 14 mm and pulls of 0.5 to 5 mm:
//!
//! | figure | goal |
//! |---|---|
//! | certified samples a second on one thread, the paper's model | ≥ 15 000 |
//! | the same with cables that slide | ≥ 10 000 |
//! | two threads against one, over what two threads give on plain arithmetic | ≥ 0.95 |
//! | memory of the program while it computes | < 200 MB |
//!
//! The first two are of the library; the others of the program, `sinew explore`, as it
//! prints them. Not with divan: a ratio of rates in one run is what it does not tell.

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Instant;

use sinew::scene::Scene;
use sinew::study::{Output, Study, StudyFile};

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");
/// Samples of the library's rate.
const SAMPLES: u64 = 8192;
/// Samples of the program's rates.
const MANY: u64 = 65_536;
/// Rates are the best of so many, ratios their median.
const TRIES: usize = 3;

fn study(samples: u64) -> String {
    format!(
        r#"
version = 1
scene = "scene.toml"
sampler = "sobol"
samples = {samples}
outputs = ["tip_x_mm", "tip_y_mm", "force_max_n", "tension_n", "certificate"]
parameter = [
    {{ key = "robot.disks", from = 3, to = 22 }},
    {{ key = "robot.cable_offset_mm", from = 4, to = 14 }},
    {{ key = "actuation.pull_mm", from = 0.5, to = 5 }},
]
"#
    )
}

fn scene(mechanics: &str) -> Result<Scene, Box<dyn Error>> {
    let mut scene = Scene::from_toml(SCENE)?;
    scene.set("model.mechanics", mechanics)?;
    Ok(scene)
}

/// Certified samples a second on one thread, and their share of all.
fn rate(mechanics: &str) -> Result<(f64, f64), Box<dyn Error>> {
    let study = Study::new(StudyFile::from_toml(&study(SAMPLES))?, scene(mechanics)?)?;
    let outputs = study.outputs().iter();
    let place = outputs
        .clone()
        .position(|output| *output == Output::Certificate)
        .ok_or("the study asks for no certificate")?;
    let mut best = (0.0_f64, 0.0);
    for _ in 0..TRIES {
        let started = Instant::now();
        let each = (0..study.samples()).map(|index| study.compute(index));
        let certified = each.filter(|row| row.numbers[place] == 1.0).count();
        let rate = certified as f64 / started.elapsed().as_secs_f64();
        if rate > best.0 {
            best = (rate, certified as f64 / SAMPLES as f64);
        }
    }
    Ok(best)
}

/// What the program says of its rate, and the most memory it had, in MB, where the system
/// tells.
fn program(desk: &Path, threads: usize) -> Result<(f64, Option<f64>), Box<dyn Error>> {
    let out = desk.join(format!("on-{threads}"));
    let _ = fs::remove_dir_all(&out);
    let mut child = Command::new(env!("CARGO_BIN_EXE_sinew"))
        .current_dir(desk)
        .args(["explore", "study.toml", "--threads", &threads.to_string()])
        .arg("--out")
        .arg(&out)
        .stdout(Stdio::piped())
        .spawn()?;
    let status = format!("/proc/{}/status", child.id());
    let mut memory = None;
    while child.try_wait()?.is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
        memory = kilobytes.map(|kilobytes| 1e-3 * kilobytes).or(memory);
        thread::sleep(std::time::Duration::from_millis(20));
    }
    let said = String::from_utf8(child.wait_with_output()?.stdout)?;
    let line = said
        .lines()
        .find(|line| line.trim().starts_with("computed"));
    let rate = line
        .and_then(|line| line.split(" a second").next()?.split_whitespace().last())
        .ok_or("the program told no rate")?;
    Ok((rate.parse()?, memory))
}

/// Steps of plain arithmetic a second, on so many threads.
fn arithmetic(threads: usize) -> f64 {
    const STEPS: u64 = 200_000_000;
    let work = || {
        let mut x = black_box(0.5_f64);
        for _ in 0..STEPS {
            x = 3.9 * x * (1.0 - x);
        }
        black_box(x);
    };
    let started = Instant::now();
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    (threads as u64 * STEPS) as f64 / started.elapsed().as_secs_f64()
}

fn main() -> Result<(), Box<dyn Error>> {
    for mechanics in ["equal", "sliding"] {
        let (rate, share) = rate(mechanics)?;
        println!("{mechanics}: {rate:.0} certified samples a second, {share:.4} of all");
    }
    let desk: PathBuf = Path::new(env!("CARGO_TARGET_TMPDIR")).join("study-bench");
    fs::create_dir_all(&desk)?;
    fs::write(desk.join("study.toml"), study(MANY))?;
    fs::write(desk.join("scene.toml"), scene("equal")?.to_toml()?)?;
    let mut ratios = Vec::new();
    for _ in 0..TRIES {
        // One after the other, so that all meet the same machine.
        let (one, _) = program(&desk, 1)?;
        let plain_one = arithmetic(1);
        let (two, memory) = program(&desk, 2)?;
        let plain_two = arithmetic(2);
        let (here, plain) = (two / one, plain_two / plain_one);
        let memory = memory.map_or(String::new(), |memory| format!(", {memory:.0} MB"));
        println!(
            "program: {one:.0} a second on 1 thread, {two:.0} on 2, {here:.3} times as many; \
             arithmetic {plain:.3} times; ratio {:.3}{memory}",
            here / plain
        );
        ratios.push(here / plain);
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[TRIES / 2];
    println!("two threads against one, over arithmetic: {median:.3}, the median");
    Ok(())
}
