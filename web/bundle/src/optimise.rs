//! Binaryen's optimiser over a program, once for each: it takes minutes.

use crate::site::checksum;
use anyhow::{Context, Result, ensure};
use std::path::Path;
use std::process::Command;

/// What the program's instructions are, named one by one: told of all there
/// are, the optimiser uses some that browsers do not have yet.
const FLAGS: &[&str] = &[
    "-O2",
    "--enable-bulk-memory",
    "--enable-bulk-memory-opt",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
    "--strip-debug",
    "--strip-producers",
];

/// The same program, smaller and faster. Keeps it in `scratch` for the next
/// time.
pub fn optimise(wasm_opt: &Path, wasm: &[u8], scratch: &Path) -> Result<Vec<u8>> {
    let key = [wasm, FLAGS.concat().as_bytes()].concat();
    let key = hex(&checksum(&key)[..8]);
    let done = scratch.join(format!("{key}.opt.wasm"));
    if !done.exists() {
        let given = scratch.join(format!("{key}.wasm"));
        let made = scratch.join(format!("{key}.part.wasm"));
        std::fs::write(&given, wasm)?;
        let mut command = Command::new(wasm_opt);
        command.args(FLAGS).arg(&given).arg("-o").arg(&made);
        let status = command
            .status()
            .with_context(|| format!("{} cannot be run", wasm_opt.display()))?;
        ensure!(status.success(), "{} failed", wasm_opt.display());
        std::fs::remove_file(&given)?;
        std::fs::rename(&made, &done)?;
    }
    Ok(std::fs::read(done)?)
}

/// Bytes as two digits each.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
