//! The photograph's path. In the window it is absolute, so that it stays right
//! wherever the scene is saved to; in a scene's file it is told from the
//! file's folder where the picture lies in or below that, so that both can be
//! moved together.

use crate::scene::Scene;
use std::path::{Component, Path, PathBuf};

/// The scene as the window has it, read from a file in a folder.
pub fn as_opened_from(mut scene: Scene, folder: Option<&Path>) -> Scene {
    if let (Some(photo), Some(folder)) = (&mut scene.photo, folder)
        && !photo.file.trim().is_empty()
    {
        let joined = folder.join(&photo.file);
        photo.file = without_detours(&joined).to_string_lossy().into_owned();
    }
    scene
}

/// The scene as a file in a folder has it.
pub fn as_kept_in(scene: &Scene, folder: Option<&Path>) -> Scene {
    let mut scene = scene.clone();
    if let (Some(photo), Some(folder)) = (&mut scene.photo, folder)
        && let Ok(below) = Path::new(&photo.file).strip_prefix(folder)
        && !folder.as_os_str().is_empty()
    {
        let parts = below
            .components()
            .map(|part| part.as_os_str().to_string_lossy());
        photo.file = parts.collect::<Vec<_>>().join("/");
    }
    scene
}

/// A path without `.` and, where it can be told from the path alone, `..`.
fn without_detours(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(plain.components().next_back(), Some(Component::Normal(_))) =>
            {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Photo;

    fn with(file: &str) -> Scene {
        Scene {
            photo: Some(Photo {
                file: file.to_owned(),
                center_mm: [0.0, 0.0],
                width_mm: 100.0,
                rotation_deg: 0.0,
                opacity: 1.0,
            }),
            ..Scene::default()
        }
    }

    fn file(scene: &Scene) -> &str {
        &scene.photo.as_ref().unwrap().file
    }

    #[test]
    #[cfg(unix)]
    fn a_path_survives_moving_the_scene() {
        let opened = as_opened_from(
            with("../pictures/./a.png"),
            Some(Path::new("/home/x/scenes")),
        );
        assert_eq!(file(&opened), "/home/x/pictures/a.png");
        let check = |folder, expect| {
            assert_eq!(file(&as_kept_in(&opened, Some(Path::new(folder)))), expect);
        };
        check("/home/x/scenes", "/home/x/pictures/a.png");
        check("/home/x", "pictures/a.png");
        check("/home/x/pictures", "a.png");
        let back = as_opened_from(
            as_kept_in(&opened, Some(Path::new("/home/x"))),
            Some(Path::new("/home/x")),
        );
        assert_eq!(back, opened);
    }

    #[test]
    fn a_bare_name_stays_where_there_are_no_folders() {
        let scene = with("a.png");
        assert_eq!(as_opened_from(scene.clone(), None), scene);
        assert_eq!(as_kept_in(&scene, Some(Path::new(""))), scene);
    }
}
