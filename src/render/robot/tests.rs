//! The robot's solids against the solution and against its picture in the plane.

use super::*;
use crate::equilibrium::{Settings, Start, solve};
use crate::scene::{self, Scene};
use crate::view::{Notes, draw};

const TWO_DISCS: &str = include_str!("../../../assets/scenes/two-discs.toml");

fn greyed() -> Standing {
    Standing::Greyed {
        what: "Unfinished",
        reason: String::new(),
    }
}

fn built(edit: impl Fn(&mut Scene), theme: Theme, standing: &Standing) -> (Solved, Mesh) {
    let mut scene = Scene::from_toml(TWO_DISCS).unwrap();
    edit(&mut scene);
    let problem = Problem::new(&scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    let scale = draw(&solution, &Notes::of(&scene)).scale;
    let mesh = mesh(&solution, problem.obstacles(), scale, theme, standing);
    (solution, mesh)
}

#[test]
fn every_corner_can_be_drawn() {
    let (_, mesh) = built(|_| (), Theme::Light, &Standing::Certified);
    mesh.solids.check();
    mesh.overlay.check();
    assert_eq!(mesh.glows.len(), 12);
    let box3 = &mesh.focus;
    assert!(box3.least.x < 0.0 && box3.most.y > 0.17, "{box3:?}");
}

/// Far from the world's origin nothing loses its digits.
#[test]
fn a_robot_elsewhere_is_the_same_robot() {
    let elsewhere = |scene: &mut Scene| {
        scene.robot.base_mm = [1e5, -2e5];
        for obstacle in &mut scene.obstacles {
            if let scene::Shape::Disc { center_mm, .. } = &mut obstacle.shape {
                center_mm[0] += 1e5;
                center_mm[1] -= 2e5;
            }
        }
    };
    let (_, here) = built(|_| (), Theme::Light, &Standing::Certified);
    let (_, there) = built(elsewhere, Theme::Light, &Standing::Certified);
    assert_eq!(here.solids.indices, there.solids.indices);
    for (a, b) in here.solids.vertices.iter().zip(&there.solids.vertices) {
        let off = Point::from(a.position) - Point::from(b.position);
        assert!(off.norm() < 1e-7, "{off}");
    }
}

/// The disks at the two contacts have the contacts' colours; of a shape
/// that is not believed nothing shines.
#[test]
fn pressing_disks_shine() {
    for theme in [Theme::Light, Theme::Dark] {
        let (solution, mesh) = built(|_| (), theme, &Standing::Certified);
        let scale = draw(&solution, &Notes::of(&Scene::from_toml(TWO_DISCS).unwrap())).scale;
        for contact in &solution.contacts {
            let [red, green, blue] = theme.contact(scale.of(contact)).rgb;
            let node = &solution.nodes[contact.node];
            let centre = node.position - mesh.origin.xy();
            let shining: Vec<&_> = mesh
                .solids
                .vertices
                .iter()
                .filter(|v| v.finish[0] > 50 && v.colour == [red, green, blue, 255])
                .collect();
            assert!(shining.len() > 100, "{} corners", shining.len());
            for v in shining {
                let away = Vector::new(f64::from(v.position[0]), f64::from(v.position[1]));
                assert!((away - centre).norm() < 0.009);
            }
        }
        let (_, mesh) = built(|_| (), theme, &greyed());
        let all = mesh.solids.vertices.iter().chain(&mesh.overlay.vertices);
        assert!(mesh.glows.is_empty() && all.into_iter().all(|v| v.finish[0] == 0));
    }
}

/// How far from a node's centre its disk reaches in space, along the disk.
fn reach(mesh: &Mesh, node: &PlanarNode) -> f64 {
    let corners = mesh.solids.vertices.iter().map(|vertex| {
        let [x, y, _] = vertex.position.map(f64::from);
        mesh.origin.xy() + Vector::new(x, y) - node.position
    });
    // What lies in the disk's plane, to half its thickness.
    let level = corners.filter(|away| away.dot(&node.normal()).abs() < 0.0016);
    level
        .map(|away| away.dot(&node.disk).abs())
        .fold(0.0, f64::max)
}

#[test]
fn plane_and_space_draw_disks_of_one_size_whatever_may_touch() {
    for candidates in [
        scene::Candidates::Nodes,
        scene::Candidates::Listed,
        scene::Candidates::Body,
    ] {
        let mut scene = Scene::default();
        scene.set_pull_mm(4.0);
        scene.contact.candidates = candidates;
        if candidates == scene::Candidates::Listed {
            let (line, node) = (scene::Line::Cable, 18);
            scene.contact.listed = vec![scene::Listed {
                line,
                cable: 0,
                node,
            }];
        }
        scene.robot.disk_radius_mm = Some(12.0);
        scene.robot.disk_thickness_mm = 3.0;
        let problem = Problem::new(&scene).unwrap();
        let solution = solve(&problem, Start::Straight, Settings::default());
        let drawing = draw(&solution, &Notes::of(&scene));
        let disks = drawing.marks.iter().filter(|mark| mark.role == Role::Disk);
        for disk in disks.clone() {
            let ends = disk.geometry.points(1e-6, &drawing.bounds);
            assert!(((ends[1] - ends[0]).norm() - 0.024).abs() < 1e-12);
            assert_eq!(disk.thickness, 0.003);
        }
        assert_eq!(disks.count(), 10);
        let mesh = mesh(
            &solution,
            problem.obstacles(),
            drawing.scale,
            Theme::Light,
            &Standing::Certified,
        );
        let tip = reach(&mesh, &solution.tip());
        assert!((tip - 0.012).abs() < 1e-5, "{candidates:?}: {tip}");
    }
}

#[test]
fn plane_and_space_colour_the_disks_that_press_and_no_others() {
    let scene = Scene::from_toml(TWO_DISCS).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let solved = solve(&problem, Start::Straight, Settings::default());
    let mut solution = solved.into_solution();
    // The lower one only grazes, the upper one presses.
    solution.contacts[0].class = Class::Grazing;
    solution.contacts[0].multiplier = 0.0;
    let solution = Solved::pair(problem.clone(), solution).unwrap();
    let drawing = draw(&solution, &Notes::of(&scene));
    let coloured = drawing
        .marks
        .iter()
        .filter(|mark| matches!(mark.role, Role::TouchedDisk(_)));
    assert_eq!(coloured.count(), 1);
    let mesh = mesh(
        &solution,
        problem.obstacles(),
        drawing.scale,
        Theme::Light,
        &Standing::Certified,
    );
    let shining = |node: &PlanarNode| {
        let centre = node.position - mesh.origin.xy();
        let vertices = mesh.solids.vertices.iter();
        vertices
            .filter(|vertex| vertex.finish[0] > 50)
            .any(|vertex| {
                let [x, y, _] = vertex.position.map(f64::from);
                (Vector::new(x, y) - centre).norm() < 0.004
            })
    };
    let disks = (0..solution.nodes.len()).filter(|node| problem.robot().has_disk(*node));
    let disks: Vec<usize> = disks
        .filter(|node| shining(&solution.nodes[*node]))
        .collect();
    assert_eq!(disks, [solution.contacts[1].node]);
}

#[test]
fn a_solution_without_nodes_shows_the_obstacles() {
    let scene = Scene::from_toml(TWO_DISCS).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let nothing = Solved::unsolved(problem);
    let obstacles = nothing.problem().obstacles();
    let scale = draw(&nothing, &Notes::of(&scene)).scale;
    let mesh = mesh(&nothing, obstacles, scale, Theme::Dark, &greyed());
    mesh.solids.check();
    assert!(!mesh.solids.indices.is_empty() && !mesh.focus.is_empty());
}
