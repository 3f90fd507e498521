//! The layers of the library and of its window, read from the source: imports
//! lead downward only, what only the top may do (IO, clocks, threads) stays
//! there, the window's files do not all hang together, and the solver speaks of
//! nothing but chains. Also what is easily forgotten in a file: its first
//! sentence, its length.

use std::collections::{BTreeMap, BTreeSet};
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
    ("equilibrium", 7),
    ("forces", 8),
    ("experiments", 9),
    ("explore", 9),
    ("study", 10),
    ("record", 11),
    ("solving", 11),
    ("view", 11),
    ("report", 12),
    ("render", 12),
    ("app", 13),
    ("cli", 13),
    ("web", 14),
];

/// The same within the window. What all parts of it share knows none of them,
/// and they do not know each other.
const WINDOW: &[(&str, u32)] = &[
    ("backend", 0),
    ("examples", 0),
    ("link", 0),
    ("look", 0),
    ("pixels", 0),
    ("paint", 1),
    ("platform", 1),
    ("shapes", 1),
    ("words", 1),
    ("commands", 2),
    ("workbench", 3),
    ("measured", 4),
    ("photo", 4),
    ("widgets", 4),
    ("files", 5),
    ("canvas", 6),
    ("panels", 6),
    ("plots", 6),
    ("sheets", 6),
    ("space", 6),
    ("dock", 7),
    ("window", 8),
    ("desktop", 9),
    ("page", 9),
];

/// Files of the window in a circle of imports, at most.
const CIRCLE: usize = 8;

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

/// What a chain may stand for, and the solver does not know, in names and
/// comments either.
const NOT_THE_SOLVERS: &[&str] = &[
    "angle",
    "backbone",
    "cable",
    "clearance",
    "contact",
    "disc",
    "disk",
    "friction",
    "geometric",
    "geometry",
    "length",
    "metre",
    "millimetre",
    "obstacle",
    "planar",
    "radian",
    "robot",
    "segment",
    "shear",
    "tendon",
    "tension",
];

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

/// Layers, and the module that they are in.
struct House {
    root: &'static str,
    layers: &'static [(&'static str, u32)],
}

const LIBRARY: House = House {
    root: "crate::",
    layers: LAYERS,
};

const APP: House = House {
    root: "crate::app::",
    layers: WINDOW,
};

impl House {
    fn height(&self, layer: &str) -> Option<u32> {
        let found = self.layers.iter().find(|(name, _)| *name == layer);
        found.map(|(_, height)| *height)
    }

    /// The layers that code in a module of this depth names: through the root,
    /// or through as many `super::` as lead to it.
    fn named<'a>(&self, code: &'a str, depth: usize) -> Vec<&'a str> {
        let mut names = named_after(code, self.root);
        names.extend(named_after(code, &"super::".repeat(depth)));
        names
    }

    /// The arrows of a source that lead upward or sideways. `modules` are those
    /// that it is, from the layer on.
    fn wrong_arrows(&self, source: &Source, modules: &[&str]) -> Vec<String> {
        // The root names layers, and is none; so is the program.
        let Some(layer) = modules.first() else {
            return Vec::new();
        };
        let own = self.height(layer);
        let own = own.unwrap_or_else(|| panic!("{layer} is not in the table of layers"));
        let (shipped, tests) = source.parts();
        let mut named = self.named(&shipped, modules.len());
        named.extend(self.named(&tests, modules.len() + 1));
        named.sort_unstable();
        named.dedup();
        let wrong = named.iter().filter(|name| {
            let other = self.height(name);
            let other = other.unwrap_or_else(|| panic!("{}: what is {name}?", source.path));
            *name != layer && other >= own
        });
        wrong
            .map(|name| format!("{} names {name}", source.path))
            .collect()
    }
}

/// The arrows of a source that lead upward or sideways, in the library and in
/// the window.
fn wrong_arrows(source: &Source) -> Vec<String> {
    let modules = source.modules();
    let mut wrong = LIBRARY.wrong_arrows(source, &modules);
    if let Some(("app", inner)) = modules.split_first().map(|(first, rest)| (*first, rest)) {
        wrong.extend(APP.wrong_arrows(source, inner));
    }
    wrong
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
    check("robot/node.rs", "use crate::geometry::Vector;", &[]);
    check("robot/node.rs", "use super::Robot;", &[]);
    check("robot/node.rs", "// use crate::cli::run;", &[]);
    check(
        "solver/sqp.rs",
        "use crate::geometry::Vector;",
        &["solver/sqp.rs names geometry"],
    );
    check(
        "geometry/mod.rs",
        "use crate::{math::asinc, robot::{Line, Node}, scene};",
        &["geometry/mod.rs names robot", "geometry/mod.rs names scene"],
    );
    check(
        "scene/mod.rs",
        "use super::robot::Robot;",
        &["scene/mod.rs names robot"],
    );
    check(
        "scene/walk.rs",
        "let problem = super::super::robot::Robot::new();",
        &["scene/walk.rs names robot"],
    );
    check(
        "scene/walk.rs",
        "#[cfg(test)]\nmod tests {\n    use super::super::robot;\n}",
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
    check("app/canvas/hit.rs", "use super::view::Canvas;", &[]);
    check("app/canvas/hit.rs", "use crate::app::words;", &[]);
    check(
        "app/canvas/hit.rs",
        "use crate::app::{look::icons, sheets, words};",
        &["app/canvas/hit.rs names sheets"],
    );
    check(
        "app/space.rs",
        "use super::canvas::Canvas;",
        &["app/space.rs names canvas"],
    );
    check(
        "app/workbench/live.rs",
        "let canvas = super::super::canvas::Canvas::default();",
        &["app/workbench/live.rs names canvas"],
    );
}

/// All paths in code of more than one module, those in braces written out: `a::b`
/// and `a::c` for `a::{b, c}`.
fn paths(code: &str) -> Vec<Vec<&str>> {
    let mut all = words_and_paths(code);
    all.retain(|path| path.len() > 1);
    all
}

fn words_and_paths(code: &str) -> Vec<Vec<&str>> {
    let (mut all, mut rest) = (Vec::new(), code);
    while !rest.is_empty() {
        let mut path = vec![word(rest)];
        if path[0].is_empty() {
            let mut letters = rest.chars();
            letters.next();
            rest = letters.as_str();
            continue;
        }
        rest = &rest[path[0].len()..];
        while let Some(next) = rest.strip_prefix("::") {
            let name = word(next);
            rest = &next[name.len()..];
            if let Some(list) = rest.strip_prefix('{').filter(|_| name.is_empty()) {
                let list = &list[..length_in_braces(list)];
                let inner = words_and_paths(list).into_iter();
                all.extend(inner.map(|more| [path.clone(), more].concat()));
                rest = &rest[1 + list.len()..];
                path.clear();
            }
            if name.is_empty() {
                break;
            }
            path.push(name);
        }
        if !path.is_empty() {
            all.push(path);
        }
    }
    all
}

/// What lies before the brace that closes a list, in bytes.
fn length_in_braces(list: &str) -> usize {
    let mut depth = 0;
    for (at, character) in list.char_indices() {
        match character {
            '{' => depth += 1,
            '}' if depth == 0 => return at,
            '}' => depth -= 1,
            _ => {}
        }
    }
    list.len()
}

/// The file that a path leads to from a module: the last of its modules that is
/// one. `None` where it leads out of these files.
fn file_at<'a>(
    module: &[&'a str],
    path: &[&'a str],
    files: &BTreeSet<Vec<&'a str>>,
) -> Option<Vec<&'a str>> {
    let supers = path.iter().take_while(|name| **name == "super").count();
    let (from, names) = match path[0] {
        "crate" => (&module[..0], &path[1..]),
        "self" => (module, &path[1..]),
        _ => (
            &module[..module.len().checked_sub(supers)?],
            &path[supers..],
        ),
    };
    // The module's own children go without a word before them.
    let least = usize::from(path.len() == names.len());
    let mut led = (least..=names.len()).rev();
    led.find_map(|count| files.get(&[from, &names[..count]].concat()).cloned())
}

/// The circles of imports among sources, each with its modules' names: what is
/// shipped, not what is tested.
fn circles(sources: &[Source]) -> Vec<Vec<String>> {
    let codes: Vec<_> = sources
        .iter()
        .map(|it| (it.modules(), it.parts().0))
        .collect();
    let files: BTreeSet<Vec<&str>> = codes.iter().map(|(module, _)| module.clone()).collect();
    let mut arrows = BTreeMap::new();
    for (module, code) in &codes {
        let paths = paths(code).into_iter();
        let named = paths.filter_map(|path| file_at(module, &path, &files));
        let named: BTreeSet<_> = named.filter(|other| other != module).collect();
        arrows.insert(module.clone(), named);
    }
    let reached = |from: &Vec<&str>| {
        let (mut known, mut next) = (BTreeSet::new(), vec![from]);
        while let Some(module) = next.pop() {
            for other in &arrows[module] {
                if known.insert(other.clone()) {
                    next.push(other);
                }
            }
        }
        known
    };
    let reached: BTreeMap<_, _> = files.iter().map(|file| (file, reached(file))).collect();
    let circle = |file: &Vec<&str>| {
        let around = reached[file].iter();
        let around = around.filter(|other| reached[other].contains(file));
        around.map(|module| module.join("::")).collect::<Vec<_>>()
    };
    let circles: BTreeSet<_> = files.iter().map(circle).collect();
    circles.into_iter().filter(|it| !it.is_empty()).collect()
}

#[test]
fn the_windows_files_do_not_all_hang_together() {
    let mut sources = sources();
    sources.retain(|source| source.modules().first() == Some(&"app"));
    assert!(sources.len() > 100);
    let circles = circles(&sources);
    // The scan sees something: who shows a window and who lays it out.
    assert!(
        circles
            .iter()
            .any(|it| it.contains(&"app::window".to_owned()))
    );
    for circle in circles {
        let count = circle.len();
        assert!(count <= CIRCLE, "{count} files in a circle: {circle:?}");
    }
}

#[test]
fn a_circle_of_imports_would_be_found() {
    let check = |files: &[(&str, &str)], expected: &[&[&str]]| {
        let sources: Vec<_> = files
            .iter()
            .map(|(path, text)| Source {
                path: (*path).to_owned(),
                text: (*text).to_owned(),
            })
            .collect();
        assert_eq!(circles(&sources), expected);
    };
    let a = ("app/a.rs", "use super::b::{B, c};\nuse crate::math::x;");
    let b = ("app/b/mod.rs", "mod c;\npub use c::C;\n// super::a::A");
    let c = ("app/b/c.rs", "use crate::app::{a::A, d};");
    let d = ("app/d.rs", "fn f() { d::f(); a.b::<C>(); }");
    check(&[a, b, c, d], &[&["app::a", "app::b", "app::b::c"]]);
    let c = ("app/b/c.rs", "use crate::app::d;");
    check(&[a, b, c, d], &[]);
    let d = ("app/d.rs", "let c = super::b::c::C::new();");
    check(&[a, b, c, d], &[&["app::b::c", "app::d"]]);
    let d = (
        "app/d.rs",
        "#[cfg(test)]\nmod tests {\n    use crate::app::b;\n}",
    );
    check(&[a, b, c, d], &[]);
    let b = ("app/b/mod.rs", "use self::c::C;");
    let c = ("app/b/c.rs", "use super::B;");
    check(&[a, b, c], &[&["app::b", "app::b::c"]]);
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

/// The words of [`NOT_THE_SOLVERS`] in a text, whether one or many of each, by
/// themselves or within a name.
fn not_the_solvers(text: &str) -> Vec<&'static str> {
    let mut words = vec![String::new()];
    let mut last = ' ';
    for character in text.chars() {
        let starts = !last.is_alphabetic() || last.is_lowercase() && character.is_uppercase();
        if starts {
            words.push(String::new());
        }
        if let (true, Some(word)) = (character.is_alphabetic(), words.last_mut()) {
            word.extend(character.to_lowercase());
        }
        last = character;
    }
    let told = |known: &&&str| {
        words
            .iter()
            .any(|word| word.strip_suffix('s').unwrap_or(word) == **known)
    };
    NOT_THE_SOLVERS.iter().filter(told).copied().collect()
}

#[test]
fn the_solver_speaks_of_chains_only() {
    let mut wrong = Vec::new();
    let mut read = 0;
    for source in sources() {
        if source.modules().first() == Some(&"solver") {
            read += 1;
            let words = not_the_solvers(&source.text);
            wrong.extend(
                words
                    .iter()
                    .map(|word| format!("{} says {word}", source.path)),
            );
        }
    }
    assert!(read > 10, "{read}");
    assert_eq!(wrong, [""; 0]);
}

#[test]
fn a_word_that_is_not_the_solvers_would_be_found() {
    let check = |text: &str, expected: &[&str]| {
        assert_eq!(not_the_solvers(text), expected, "{text}");
    };
    check(
        "// The robot's links keep their lengths.",
        &["length", "robot"],
    );
    check("fn cable_length(&self) -> f64", &["cable", "length"]);
    check("struct ContactRow;", &["contact"]);
    check("const LEAST_ANGLE: f64", &["angle"]);
    check("let robot2 = 1;", &["robot"]);
    check("a rectangle, tangled in discussions", &[]);
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
