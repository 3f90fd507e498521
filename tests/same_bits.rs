//! The same scene gives the same bits on every machine: thousands of solutions,
//! as the bytes that go from the solver to the window, against one number that
//! is written down. The page's solver is held to the same bytes by `web/test`,
//! for which `SINEW_BITS=FILE` writes what was asked and what was answered.

mod random_scene;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use random_scene::{config, scene};
use sinew::mechanics::Problem;
use sinew::scene::Candidates;
use sinew::solving::wire::{write_order, write_update};
use sinew::solving::{Executor, Order, Request, StartFrom, Work};
use std::process::Command;

/// Scenes of each kind of candidates; not all of them can be solved.
const SCENES: u32 = 1500;

/// What the bytes of all answers come to. It changes where answers do: look
/// at what has changed before it is written anew.
const EXPECTED: u64 = include!("cases/same_bits.txt");

/// The variable that names the file for [`record`].
const RECORD: &str = "SINEW_BITS";

/// Requests for random robots among random obstacles.
fn requests() -> Vec<Request> {
    let mut requests = Vec::new();
    for candidates in [Candidates::Nodes, Candidates::Body] {
        let mut runner = TestRunner::new(config(SCENES));
        let scenes = scene(candidates);
        for _ in 0..SCENES {
            let scene = scenes.new_tree(&mut runner).unwrap().current();
            let Ok(problem) = Problem::new(&scene) else {
                continue;
            };
            requests.push(Request {
                generation: requests.len() as u64,
                course: requests.len() as u64,
                span: (0.0, problem.pull().abs()),
                problem,
                from: StartFrom::Straight,
            });
        }
    }
    requests
}

/// The bytes of the shape that a live order leads to.
fn answer(order: Order) -> Vec<u8> {
    let mut executor = Executor::default();
    executor.take(order);
    loop {
        match executor.work() {
            Work::More => {}
            Work::Found(update) => return write_update(&update).unwrap(),
            Work::Done => panic!("no shape"),
        }
    }
}

/// The hash FNV-1a of 64 bits (Fowler, Noll and Vo), continued.
fn hash(so_far: u64, bytes: &[u8]) -> u64 {
    let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(so_far, mix)
}

/// What the system's own sines come to: where these differ, the processors do.
fn systems_sines() -> u64 {
    let sines = (0..100_000).map(|i| (f64::from(i) * 0.37).sin());
    sines.fold(0, |so_far, sine| hash(so_far, &sine.to_le_bytes()))
}

/// Adds a message to a record, its length before it.
fn record(to: &mut Vec<u8>, message: &[u8]) {
    to.extend(u32::try_from(message.len()).unwrap().to_le_bytes());
    to.extend(message);
}

#[test]
fn thousands_of_solutions_have_the_bits_that_are_written_down() {
    let (mut all, mut recorded) = (0xcbf2_9ce4_8422_2325, Vec::new());
    let requests = requests();
    assert!(requests.len() > SCENES as usize, "{}", requests.len());
    for request in requests {
        let order = Order::Live(request);
        let asked = write_order(&order).unwrap();
        let answered = answer(order);
        all = hash(all, &answered);
        record(&mut recorded, &asked);
        record(&mut recorded, &answered);
    }
    println!("the system's sines: {:#018x}", systems_sines());
    if let Some(file) = std::env::var_os(RECORD) {
        std::fs::write(file, recorded).unwrap();
    }
    assert_eq!(all, EXPECTED, "{all:#018x}");
}

/// Linux's C library chooses its sines by what the processor has; it can be
/// told to do without.
#[test]
#[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
fn a_processor_with_fewer_features_gives_the_same_bits() {
    let masked = "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable,-AVX512F";
    let status = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "thousands_of_solutions_have_the_bits_that_are_written_down",
            "--nocapture",
        ])
        .env("GLIBC_TUNABLES", masked)
        .env_remove(RECORD)
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&status.stdout);
    assert!(status.status.success(), "{told}");
    assert!(told.contains("1 passed"), "{told}");
    // It did without: the system's own sines are others now.
    let ours = format!("{:#018x}", systems_sines());
    let has_fma = std::arch::is_x86_feature_detected!("fma");
    assert_eq!(told.contains(&ours), !has_fma, "{told}");
}
