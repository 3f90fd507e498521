//! Scene files of version 1: each still opens, means what its successor of
//! version 2 means, and is written as one.

use sinew::mechanics::Problem;
use sinew::scene::{Drive, Mechanics, Scene, SceneError, VERSION};
use std::fs;
use std::path::{Path, PathBuf};

fn folder(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(of)
}

/// The files of version 1, with their names.
fn old_files() -> Vec<(String, String)> {
    let entries = fs::read_dir(folder("tests/cases/version-1")).unwrap();
    let mut files: Vec<_> = entries
        .map(|entry| {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect();
    files.sort();
    files
}

#[test]
fn every_old_example_opens_and_is_saved_as_version_2() {
    let files = old_files();
    assert!(files.len() >= 14);
    for (name, text) in files {
        assert!(text.contains("version = 1\n"), "{name}");
        let scene = Scene::from_toml(&text).unwrap();
        assert_eq!(scene.faults(), [], "{name}");
        assert_eq!(scene.version, VERSION, "{name}");
        assert_eq!(scene.model.mechanics, Mechanics::Equal, "{name}");
        let written = scene.to_toml().unwrap();
        assert!(written.starts_with("version = 2\n"), "{name}:\n{written}");
        assert!(
            written.contains("\n[model]\nmechanics = \"equal\"\n"),
            "{name}:\n{written}"
        );
        assert_eq!(Scene::from_toml(&written), Ok(scene), "{name}");
    }
}

#[test]
fn every_old_example_means_what_its_successor_means() {
    let mut compared = 0;
    for (name, text) in old_files() {
        let path = folder("assets/scenes").join(&name);
        // The scene of every key has no successor that means the same.
        let Ok(successor) = fs::read_to_string(path) else {
            assert_eq!(name, "full.toml");
            continue;
        };
        assert!(successor.contains("version = 2\n"), "{name}");
        let old = Scene::from_toml(&text).unwrap();
        let new = Scene::from_toml(&successor).unwrap();
        assert_eq!(old, new, "{name}");
        let problem = |scene| format!("{:?}", Problem::new(scene).unwrap());
        assert_eq!(problem(&old), problem(&new), "{name}");
        compared += 1;
    }
    // Examples of sliding cables came later.
    let files = fs::read_dir(folder("assets/scenes")).unwrap();
    let texts = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
    let scenes = texts.map(|text| Scene::from_toml(&text).unwrap());
    let papers = scenes.filter(|scene| scene.model.mechanics == Mechanics::Equal);
    assert_eq!(compared, papers.count());
}

#[test]
fn keys_of_version_2_are_told_in_a_file_of_version_1() {
    let old = "version = 1
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
        actuation = { pull_mm = 5 }
        contact = { candidates = \"listed\", listed = [{ line = \"cable\", node = 14 }] }";
    assert_eq!(Scene::from_toml(old).unwrap().faults(), []);
    let told = |from: &str, to: &str| {
        assert!(old.contains(from), "{from}");
        let error = Scene::from_toml(&old.replacen(from, to, 1)).unwrap_err();
        let SceneError::NewerKey { path, since: 2 } = &error else {
            panic!("{error}");
        };
        let advice = "needs version = 2; write `version = 2` and, to keep the paper's model, [model] with mechanics = \"equal\"";
        assert_eq!(error.to_string(), format!("{path} {advice}"));
        path.clone()
    };
    let added = |line: &str| told("version = 1", &format!("version = 1\n{line}"));
    assert_eq!(added("model = { mechanics = \"equal\" }"), "model");
    assert_eq!(added("friction = { holes = 0.1 }"), "friction");
    assert_eq!(added("loads = {}"), "loads");
    assert_eq!(added("cable = []"), "cable");
    assert_eq!(told("pull_mm = 5", "load_g = 5"), "actuation.load_g");
    assert_eq!(
        told("segments = 18", "segments = 18, disk_mass_g = 1"),
        "robot.disk_mass_g"
    );
    assert_eq!(
        told("node = 14", "cable = 0, node = 14"),
        "contact.listed[0].cable"
    );
    // What is not there is not asked for, nor offered, in words of version 2.
    let missing = Scene::from_toml(&old.replace("pull_mm = 5", "")).unwrap_err();
    assert!(!missing.to_string().contains("load_g"), "{missing}");
    let typo = Scene::from_toml(&old.replace("pull_mm", "laod_g")).unwrap_err();
    assert!(!typo.to_string().contains("load_g"), "{typo}");
}

#[test]
fn a_file_of_version_2_slides_where_it_does_not_say() {
    let text = "version = 2
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
        actuation = { pull_mm = 5 }";
    let scene = Scene::from_toml(text).unwrap();
    assert_eq!(scene.model.mechanics, Mechanics::Sliding);
    assert_eq!(scene.faults(), []);
    assert_eq!(scene.cable(0).drive, Drive::PullMm(5.0));
    let written = scene.to_toml().unwrap();
    assert!(written.contains("mechanics = \"sliding\""), "{written}");
    assert_eq!(Scene::from_toml(&written), Ok(scene));
}
