//! The script between a program and its page.

use anyhow::{Context, Result};
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// A program that a page can load.
pub struct Glued {
    /// The program's file without its ending.
    pub name: String,
    /// The module that loads it.
    pub script: String,
    /// The pieces of script that the module loads, with their paths from it.
    pub pieces: Vec<(String, String)>,
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
    let mut pieces = Vec::new();
    for (of, inline) in output.snippets() {
        let inline = inline.iter().enumerate();
        pieces.extend(
            inline.map(|(index, js)| (format!("snippets/{of}/inline{index}.js"), js.clone())),
        );
    }
    for (path, js) in output.local_modules() {
        pieces.push((format!("snippets/{path}"), js.clone()));
    }
    Ok(Glued {
        name,
        script: output.js().to_owned(),
        pieces,
        wasm: output.wasm_mut().emit_wasm(),
    })
}
