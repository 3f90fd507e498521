//! The files of the folder that is served: all that the page loads in a folder
//! whose name changes with its contents, so that no browser mixes two
//! versions; the page itself and what has to have one address beside it.

use crate::icons;
use crate::optimise::hex;
use anyhow::{Context, Result};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};
use std::fs;
use std::path::Path;

/// Files with their names.
type Files = Vec<(String, Vec<u8>)>;

/// What is served.
pub struct Site {
    /// The folder of what the page loads.
    pub folder: String,
    /// What is in it.
    pub app: Files,
    /// What is beside it.
    pub beside: Files,
}

impl Site {
    /// The site of two programs with their scripts, and of the page's files.
    pub fn of(mut app: Files, source: &Path) -> Result<Self> {
        let read = |name: &str| {
            let file = source.join(name);
            fs::read_to_string(&file).with_context(|| file.display().to_string())
        };
        let page = app.iter().find(|(name, _)| name == "sinew-page_bg.wasm");
        let bytes = page.context("the page has a program")?.1.len().to_string();
        let main = read("main.js")?.replace("%PAGE_BYTES%", &bytes);
        app.push(("main.js".to_owned(), main.into_bytes()));
        for name in ["drawers.js", "worker.js", "style.css"] {
            app.push((name.to_owned(), read(name)?.into_bytes()));
        }
        app.sort();
        let folder = format!("app-{}", version(&app));

        let icon = read("icon.svg")?;
        let mut beside = icons::pixels(&icon)?;
        beside.push(("icon.svg".to_owned(), icon.into_bytes()));
        let manifest = read("manifest.webmanifest")?;
        beside.push(("manifest.webmanifest".to_owned(), manifest.into_bytes()));
        let index = read("index.html")?.replace("%APP%", &folder);
        beside.push(("index.html".to_owned(), index.into_bytes()));
        beside.sort();
        let worker = read("sw.js")?
            .replace("%VERSION%", &format!("{folder}-{}", version(&beside)))
            .replace("%APP%", &folder)
            .replace("%CHECKED%", &checked(&folder, &app))
            .replace("%BESIDE%", &names(&beside));
        beside.push(("sw.js".to_owned(), worker.into_bytes()));
        Ok(Self {
            folder,
            app,
            beside,
        })
    }

    /// Writes all files; what was in the folder before is gone.
    pub fn write(&self, out: &Path) -> Result<()> {
        if out.exists() {
            fs::remove_dir_all(out)?;
        }
        let folder = out.join(&self.folder);
        for (path, bytes) in &self.app {
            let file = folder.join(path);
            fs::create_dir_all(file.parent().unwrap_or(&folder))?;
            fs::write(file, bytes)?;
        }
        for (name, bytes) in &self.beside {
            fs::write(out.join(name), bytes)?;
        }
        Ok(())
    }
}

/// SHA-256.
pub fn checksum(bytes: &[u8]) -> [u8; 32] {
    Sha256::digest(bytes).into()
}

/// A short word that changes with the files.
fn version(files: &Files) -> String {
    let sums = files
        .iter()
        .flat_map(|(name, bytes)| [checksum(name.as_bytes()), checksum(bytes)]);
    hex(&checksum(&sums.flatten().collect::<Vec<_>>())[..5])
}

/// Paths with what browsers check them against, as JSON.
fn checked(folder: &str, files: &Files) -> String {
    let entries = files.iter().map(|(name, bytes)| {
        let sum = STANDARD.encode(checksum(bytes));
        format!("  [\"{folder}/{name}\", \"sha256-{sum}\"],\n")
    });
    format!("[\n{}]", entries.collect::<String>())
}

/// The names of all but the page itself, which has the folder's, as JSON.
fn names(files: &Files) -> String {
    let names = files.iter().filter(|(name, _)| name != "index.html");
    let names: Vec<_> = names.map(|(name, _)| format!("{name:?}")).collect();
    format!("[{}]", names.join(", "))
}
