//! What a browser downloads, packed as servers pack it, against what it may
//! be.

use crate::site::Site;
use anyhow::{Result, ensure};
use brotli::enc::BrotliEncoderParams;

/// The most that opening the page may take, in bytes, the worker's part
/// included.
const MOST_IN_ALL: usize = 2_240_000;
/// The most that the worker's part may take, in bytes.
const MOST_OF_WORKER: usize = 232_000;

/// Prints the sizes; fails where they are too large.
pub fn report(site: &Site) -> Result<()> {
    println!("{:>10} {:>10}  file", "bytes", "brotli");
    let (mut all, mut worker) = (0, 0);
    let opened = ["index.html", "icon.svg"];
    let beside = site.beside.iter();
    let beside = beside.filter(|(name, _)| opened.contains(&name.as_str()));
    for (name, bytes) in site.app.iter().chain(beside) {
        let packed = packed(bytes)?;
        println!("{:>10} {packed:>10}  {name}", bytes.len());
        all += packed;
        if name.contains("worker") {
            worker += packed;
        }
    }
    println!(
        "{:>10} {all:>10}  in all, of which the solver's worker {worker}",
        ""
    );
    ensure!(
        all <= MOST_IN_ALL,
        "opening the page takes {all} bytes, and may take {MOST_IN_ALL}"
    );
    ensure!(
        worker <= MOST_OF_WORKER,
        "the solver's worker takes {worker} bytes, and may take {MOST_OF_WORKER}"
    );
    Ok(())
}

fn packed(bytes: &[u8]) -> Result<usize> {
    let parameters = BrotliEncoderParams {
        size_hint: bytes.len(),
        ..BrotliEncoderParams::default()
    };
    let mut packed = Vec::new();
    brotli::BrotliCompress(&mut &bytes[..], &mut packed, &parameters)?;
    Ok(packed.len())
}
