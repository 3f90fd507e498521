//! The layers of the library, read from its source: imports lead downward
//! only, and what only the top may do (IO, clocks, threads) stays there. Also
//! what is easily forgotten in a file: its first sentence, its length.

use std::fs;
use std::path::{Path, PathBuf};

/// Every layer with its height. An arrow may lead to a lesser height only, so
/// two layers of the same height do not know each other.
const LAYERS: &[(&str, u32)] = &[
    ("units", 0),
    ("math", 1),
    ("solver", 2),
    ("geometry", 2),
    ("scene", 3),
    ("robot", 4),
    ("contact", 5),
    ("mechanics", 6),
    ("model", 7),
    ("equilibrium", 8),
    ("forces", 9),
    ("experiments", 10),
    ("explore", 10),
    ("record", 11),
    ("solving", 11),
    ("view", 11),
    ("report", 12),
    ("render", 12),
    ("app", 13),
    ("cli", 13),
    ("web", 14),
];

/// The layers that may do what [`TOP_ONLY`] lists.
const TOP: &[&str] = &["app", "cli", "web"];

/// Below the top: no IO, no clock, no thread, no order that changes from run
/// to run.
const TOP_ONLY: &[&str] = &[
    "std::time",
    "web_time",
    "std::thread",
    "std::fs",
    "std::env",
    "std::io",
    "std::net",
    "std::process",
    "HashMap",
    "HashSet",
    "println!",
    "print!",
];

/// What does no IO and still has to name [`TOP_ONLY`]'s `std::io`: serde_json
/// formats numbers through its trait Write, in memory.
const IN_MEMORY: (&str, &str) = ("record/json.rs", "std::io");

/// Below the window: none of std's functions that the system or the processor
/// compute, whose last digits differ from machine to machine; libm has them.
const SYSTEMS_OWN: &[&str] = &[
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
    "asinh", "acosh", "atanh", "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10",
    "powf", "powi", "cbrt", "hypot", "mul_add",
];

/// The layers that draw on a screen, where the last digits mean nothing.
const SCREEN: &[&str] = &["app", "render"];

/// Lines of a file in src.
const LONGEST: usize = 500;

struct Source {
    /// Below src, with forward slashes.
    path: String,
    text: String,
}

impl Source {
    /// The modules that the file is, outermost first; none for `lib.rs`.
    fn modules(&self) -> Vec<&str> {
        let path = self.path.strip_suffix(".rs").unwrap();
        let mut modules: Vec<_> = path.split('/').collect();
        if matches!(modules.last(), Some(&"mod" | &"lib" | &"main")) {
            modules.pop();
        }
        modules
    }

    /// The file without comments, from its start to its tests and from there
    /// to its end.
    fn parts(&self) -> (String, String) {
        let code = without_comments(&self.text);
        match code.split_once("#[cfg(test)]\nmod ") {
            Some((shipped, tests)) => (shipped.to_owned(), tests.to_owned()),
            None => (code, String::new()),
        }
    }
}

fn without_comments(text: &str) -> String {
    let lines = text.lines().map(|line| match line.find("//") {
        // A string may hold slashes, as an address does; nothing after them
        // is an import.
        Some(start) => &line[..start],
        None => line,
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files_below(&root);
    let rust = files
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"));
    rust.map(|path| Source {
        path: slashed(path.strip_prefix(&root).unwrap()),
        text: fs::read_to_string(path).unwrap(),
    })
    .collect()
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn slashed(path: &Path) -> String {
    let parts = path.iter().map(|part| part.to_str().unwrap());
    parts.collect::<Vec<_>>().join("/")
}

/// The first modules of all paths that start with `prefix`, those in braces
/// after it included: `a` and `b` for `prefix{a::c, b}`.
fn named_after<'a>(code: &'a str, prefix: &str) -> Vec<&'a str> {
    let mut names = Vec::new();
    for (at, _) in code.match_indices(prefix) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':') {
            continue;
        }
        let rest = &code[at + prefix.len()..];
        match rest.strip_prefix('{') {
            Some(list) => names.extend(first_of_each(list)),
            None => names.push(word(rest)),
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// The first words of the entries of a list that ends with its brace.
fn first_of_each(list: &str) -> Vec<&str> {
    let (mut names, mut depth, mut start) = (Vec::new(), 0, 0);
    for (at, character) in list.char_indices() {
        match character {
            '{' => depth += 1,
            '}' if depth == 0 => {
                names.push(word(list[start..at].trim_start()));
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                names.push(word(list[start..at].trim_start()));
                start = at + 1;
            }
            _ => {}
        }
    }
    names
}

fn word(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_'));
    &text[..end.unwrap_or(text.len())]
}

/// The layers that code in a module of this depth names: through `crate::`, or
/// through as many `super::` as lead to the crate's root.
fn layers_named(code: &str, depth: usize) -> Vec<&str> {
    let mut names = named_after(code, "crate::");
    names.extend(named_after(code, &"super::".repeat(depth)));
    names
}

fn height(layer: &str) -> Option<u32> {
    let found = LAYERS.iter().find(|(name, _)| *name == layer);
    found.map(|(_, height)| *height)
}

/// The arrows of a source that lead upward or sideways.
fn wrong_arrows(source: &Source) -> Vec<String> {
    let modules = source.modules();
    // The crate's root and the program name layers, and are none.
    let Some(layer) = modules.first() else {
        return Vec::new();
    };
    let own = height(layer).unwrap_or_else(|| panic!("{layer} is not in the table of layers"));
    let (shipped, tests) = source.parts();
    let mut named = layers_named(&shipped, modules.len());
    named.extend(layers_named(&tests, modules.len() + 1));
    named.sort_unstable();
    named.dedup();
    let wrong = named.iter().filter(|name| {
        let other = height(name).unwrap_or_else(|| panic!("{}: what is {name}?", source.path));
        *name != layer && other >= own
    });
    wrong
        .map(|name| format!("{} names {name}", source.path))
        .collect()
}

#[test]
fn imports_lead_downward_only() {
    let sources = sources();
    assert!(sources.len() > 10);
    let wrong: Vec<_> = sources.iter().flat_map(wrong_arrows).collect();
    assert_eq!(wrong, [""; 0]);
}

#[test]
fn an_upward_or_sideways_arrow_would_be_found() {
    let check = |path: &str, text: &str, expected: &[&str]| {
        let source = Source {
            path: path.to_owned(),
            text: text.to_owned(),
        };
        assert_eq!(wrong_arrows(&source), expected, "{path}: {text}");
    };
    check("model/node.rs", "use crate::geometry::Vector;", &[]);
    check("model/node.rs", "use super::Problem;", &[]);
    check("model/node.rs", "// use crate::cli::run;", &[]);
    check(
        "solver/sqp.rs",
        "use crate::geometry::Vector;",
        &["solver/sqp.rs names geometry"],
    );
    check(
        "geometry/mod.rs",
        "use crate::{math::asinc, model::{Line, Node}, scene};",
        &["geometry/mod.rs names model", "geometry/mod.rs names scene"],
    );
    check(
        "scene/mod.rs",
        "use super::model::Problem;",
        &["scene/mod.rs names model"],
    );
    check(
        "scene/walk.rs",
        "let problem = super::super::model::Problem::new();",
        &["scene/walk.rs names model"],
    );
    check(
        "scene/walk.rs",
        "#[cfg(test)]\nmod tests {\n    use super::super::model;\n}",
        &[],
    );
    check(
        "units.rs",
        "use crate::math::asinc;",
        &["units.rs names math"],
    );
    check(
        "app/mod.rs",
        "use crate::cli::run;",
        &["app/mod.rs names cli"],
    );
}

#[test]
fn only_the_top_does_io_and_only_geometry_knows_parry() {
    let mut wrong = Vec::new();
    for source in sources() {
        let modules = source.modules();
        let layer = modules.first().copied().unwrap_or_default();
        let (shipped, tests) = source.parts();
        if layer != "geometry" && (shipped.contains("parry2d") || tests.contains("parry2d")) {
            wrong.push(format!("{} knows parry", source.path));
        }
        // The program is the top as well.
        if TOP.contains(&layer) || source.path == "main.rs" {
            continue;
        }
        let grouped = named_after(&shipped, "std::");
        for word in TOP_ONLY {
            let module = word.strip_prefix("std::");
            let named =
                shipped.contains(word) || module.is_some_and(|name| grouped.contains(&name));
            if named && (source.path.as_str(), *word) != IN_MEMORY {
                wrong.push(format!("{} has {word}", source.path));
            }
        }
    }
    assert_eq!(wrong, [""; 0]);
}

/// The calls of [`SYSTEMS_OWN`] in code, as methods or by path.
fn systems_own(code: &str) -> Vec<&'static str> {
    let called = |name: &&&str| {
        code.contains(&format!(".{name}(")) || code.contains(&format!("f64::{name}"))
    };
    SYSTEMS_OWN.iter().filter(called).copied().collect()
}

#[test]
fn what_is_computed_is_the_same_on_every_machine() {
    let mut wrong = Vec::new();
    for source in sources() {
        let layer = source.modules().first().copied().unwrap_or_default();
        if SCREEN.contains(&layer) {
            continue;
        }
        for name in systems_own(&source.parts().0) {
            wrong.push(format!("{} calls {name}", source.path));
        }
    }
    assert_eq!(wrong, [""; 0]);
    assert_eq!(systems_own("x.sin() + libm::cos(x)"), ["sin"]);
    assert_eq!(systems_own("xs.iter().copied().map(f64::exp)"), ["exp"]);
}

#[test]
fn every_file_says_what_it_is_and_is_short() {
    for source in sources() {
        let path = &source.path;
        assert!(
            source.text.starts_with("//! "),
            "{path} opens with no sentence"
        );
        let lines = source.text.lines().count();
        assert!(lines <= LONGEST, "{path} has {lines} lines: split it");
    }
}

#[test]
fn every_case_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let tests = root.join("tests");
    let files = [files_below(&root.join("src")), files_below(&tests)].concat();
    let rust = files
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"));
    let texts: Vec<_> = rust.map(|path| fs::read_to_string(path).unwrap()).collect();
    for case in files_below(&tests.join("cases")) {
        let case = slashed(case.strip_prefix(&tests).unwrap());
        // By its own name, or as one of all files in a folder under cases.
        let folder = case.rsplit_once('/').map_or("", |(folder, _)| folder);
        let whole_folder = format!("{folder}\"");
        let used = texts.iter().any(|text| {
            text.contains(&format!("{case}\"")) || folder != "cases" && text.contains(&whole_folder)
        });
        assert!(used, "no test reads {case}");
    }
}
