//! The script between a program and its page.

use anyhow::{Context, Result, ensure};
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// A program that a page can load.
pub struct Glued {
    /// The program's file without its ending.
    pub name: String,
    /// The module that loads it.
    pub script: String,
    /// The program.
    pub wasm: Vec<u8>,
}

/// Makes a program out of cargo's fit for a page.
pub fn glue(program: &Path) -> Result<Glued> {
    let name = program.file_stem().context("a program has a name")?;
    let name = name.to_string_lossy().into_owned();
    let mut output = Bindgen::new()
        .input_path(program)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate_output()?;
    // Pieces of script beside the module would need addresses of their own.
    ensure!(output.snippets().is_empty() && output.local_modules().is_empty());
    Ok(Glued {
        name,
        script: output.js().to_owned(),
        wasm: output.wasm_mut().emit_wasm(),
    })
}
