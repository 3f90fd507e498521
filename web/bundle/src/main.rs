//! Makes the folder that a web server serves, from two programs that cargo has
//! built: `web/build` calls it.
//!
//! ```text
//! bundle PAGE.wasm WORKER.wasm FILES WASM-OPT SCRATCH OUT
//! ```
//!
//! Fails where what a browser downloads has become too large.

mod glue;
mod icons;
mod optimise;
mod site;
mod sizes;

use anyhow::{Context, Result, bail};
use std::path::PathBuf;

fn main() -> Result<()> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [page, worker, source, wasm_opt, scratch, out] = arguments.as_slice() else {
        bail!("bundle PAGE.wasm WORKER.wasm FILES WASM-OPT SCRATCH OUT");
    };
    std::fs::create_dir_all(scratch)?;
    let mut app = Vec::new();
    for program in [page, worker] {
        let glued = glue::glue(program).with_context(|| program.display().to_string())?;
        let small = optimise::optimise(wasm_opt, &glued.wasm, scratch)?;
        app.push((format!("{}.js", glued.name), glued.script.into_bytes()));
        let pieces = glued.pieces.into_iter();
        app.extend(pieces.map(|(path, script)| (path, script.into_bytes())));
        app.push((format!("{}_bg.wasm", glued.name), small));
    }
    let site = site::Site::of(app, source)?;
    site.write(out)?;
    sizes::report(&site)
}
