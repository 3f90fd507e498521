//! The page's solver without a browser: what the worker does with a request,
//! from its bytes to those of the answer, timed. `web/bench` compares the two.
//!
//! `native BATCHES SOLVES FILE…` prints for each file, which holds a request,
//! the median over the batches of the milliseconds that a solve takes.

use anyhow::{Context, Result, ensure};
use sinew::solving::wire::{read_order, write_update};
use sinew::solving::{Executor, Work};
use std::hint::black_box;
use std::time::Instant;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [batches, solves, files @ ..] = arguments.as_slice() else {
        anyhow::bail!("usage: native BATCHES SOLVES FILE…");
    };
    let (batches, solves): (usize, u32) = (batches.parse()?, solves.parse()?);
    ensure!(batches > 0 && solves > 0, "nothing to be timed");
    for file in files {
        let request = std::fs::read(file).with_context(|| format!("cannot read {file}"))?;
        let mut times = Vec::with_capacity(batches);
        for _ in 0..batches {
            let begin = Instant::now();
            for _ in 0..solves {
                answer(&request).with_context(|| format!("{file} cannot be answered"))?;
            }
            times.push(1e3 * begin.elapsed().as_secs_f64() / f64::from(solves));
        }
        times.sort_by(f64::total_cmp);
        println!("{}", times[batches / 2]);
    }
    Ok(())
}

/// Answers a request with its shape, as the worker does.
fn answer(request: &[u8]) -> Result<()> {
    let mut executor = Executor::default();
    executor.take(read_order(black_box(request))?);
    loop {
        match executor.work() {
            Work::More => {}
            Work::Found(update) => {
                black_box(write_update(&update)?);
                return Ok(());
            }
            Work::Done => anyhow::bail!("there is no shape"),
        }
    }
}
