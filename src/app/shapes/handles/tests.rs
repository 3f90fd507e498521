//! Tests of the handles.

use super::*;
use crate::scene::Scene;

const PER_POINT: f64 = 0.35;

fn disc() -> Shape {
    Shape::Disc {
        center_mm: [33.0, 89.0],
        radius_mm: 12.5,
    }
}

fn turned_box() -> Shape {
    Shape::Box {
        center_mm: [40.0, 60.0],
        size_mm: [36.0, 28.0],
        rotation_deg: 30.0,
        corner_radius_mm: 2.0,
    }
}

fn capsule() -> Shape {
    Shape::Capsule {
        center_mm: [40.0, 60.0],
        length_mm: 30.0,
        radius_mm: 5.0,
        rotation_deg: -20.0,
    }
}

fn polygon() -> Shape {
    Shape::Polygon {
        points_mm: vec![[50.0, 50.0], [80.0, 55.0], [85.0, 80.0], [60.0, 90.0]],
        rotation_deg: 25.0,
        corner_radius_mm: 1.0,
    }
}

fn wall() -> Shape {
    Shape::Wall {
        point_mm: [70.0, 40.0],
        rotation_deg: 160.0,
        corner_radius_mm: 0.0,
    }
}

fn all() -> [Shape; 5] {
    [disc(), turned_box(), capsule(), polygon(), wall()]
}

fn place(shape: &Shape, handle: Handle) -> Vector {
    let all = handles(shape, PER_POINT);
    let found = all.iter().find(|(other, _)| *other == handle);
    found.unwrap_or_else(|| panic!("no {handle:?}")).1
}

fn dragged(shape: &Shape, handle: Handle, by: [f64; 2], modifiers: Modifiers) -> Shape {
    let to = place(shape, handle) + Vector::from(by);
    drag(shape, handle, to, modifiers, PER_POINT)
}

/// A disc around everything that is checked, to fill a scene with.
fn faults(shape: &Shape) -> Vec<crate::scene::SceneError> {
    let scene = Scene {
        obstacles: vec![shape.clone().into()],
        ..Scene::default()
    };
    scene.faults()
}

fn close(a: &Shape, b: &Shape, within: f64) -> bool {
    let numbers = |shape: &Shape| -> Vec<f64> {
        let mut all = match shape {
            Shape::Disc { radius_mm, .. } => vec![*radius_mm],
            Shape::Wall {
                corner_radius_mm, ..
            } => vec![*corner_radius_mm],
            Shape::Box {
                size_mm,
                corner_radius_mm,
                ..
            } => vec![size_mm[0], size_mm[1], *corner_radius_mm],
            Shape::Capsule {
                length_mm,
                radius_mm,
                ..
            } => vec![*length_mm, *radius_mm],
            Shape::Polygon { points_mm, .. } => points_mm.as_flattened().to_vec(),
        };
        all.extend(shape.anchor_mm());
        all.push(shape.rotation_deg());
        all
    };
    let (a, b) = (numbers(a), numbers(b));
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= within)
}

/// To rounding at the size of the numbers, about 1e-14 of 100 mm.
#[test]
fn a_handle_dragged_to_where_it_is_changes_nothing() {
    for shape in all() {
        let handles = handles(&shape, PER_POINT);
        assert!(!handles.is_empty());
        for (handle, at) in handles {
            if let Handle::Vertex(_) = handle {
                // A vertex is rounded to what the screen can show.
                continue;
            }
            let same = drag(&shape, handle, at, Modifiers::NONE, PER_POINT);
            assert!(
                close(&same, &shape, 1e-9),
                "{handle:?} of {shape:?}: {same:?}"
            );
        }
        let same = moved(&shape, Vector::zeros(), Modifiers::NONE, PER_POINT);
        assert!(close(&same, &shape, 1e-9));
    }
}

/// Each handle ends under the pointer: what one drags stays in the hand.
#[test]
fn a_handle_follows_the_pointer() {
    let check = |shape: Shape, handle, by: [f64; 2]| {
        let to = place(&shape, handle) + Vector::from(by);
        let now = drag(&shape, handle, to, Modifiers::NONE, PER_POINT);
        let off = (place(&now, handle) - to).norm();
        // Sizes are rounded to 0.01 mm, turns to 0.1° of some 40 mm.
        assert!(off < 0.05, "{handle:?}: {off} mm off, {now:?}");
        assert_eq!(faults(&now), []);
    };
    check(disc(), Handle::Rim(0), [5.0, 0.0]);
    check(disc(), Handle::Rim(3), [0.0, 3.0]);
    check(turned_box(), Handle::Side { x: 1, y: 1 }, [7.0, 3.0]);
    check(turned_box(), Handle::Side { x: -1, y: 1 }, [-2.0, 8.0]);
    check(capsule(), Handle::End(1), [6.0, 11.0]);
    check(capsule(), Handle::End(-1), [-3.0, -20.0]);
    check(polygon(), Handle::Vertex(2), [6.0, 3.0]);
    check(polygon(), Handle::Vertex(0), [-2.0, 3.0]);
}

#[test]
fn the_opposite_side_of_a_box_stays() {
    for (x, y) in [(1, 1), (1, -1), (-1, 0), (0, 1), (0, -1), (1, 0)] {
        let opposite = Handle::Side { x: -x, y: -y };
        let before = turned_box();
        let after = dragged(&before, Handle::Side { x, y }, [6.0, -4.0], Modifiers::NONE);
        assert_ne!(before, after);
        let moved = place(&after, opposite) - place(&before, opposite);
        // The centre is written to the nanometre.
        assert!(moved.norm() < 2e-6, "{x} {y}: {moved}");
    }
    // With Alt it mirrors, so that the centre stays.
    let right = Handle::Side { x: 1, y: 0 };
    let after = dragged(&turned_box(), right, [6.0, 0.0], Modifiers::ALT);
    assert_eq!(after.anchor_mm(), turned_box().anchor_mm());
}

#[test]
fn shift_keeps_a_boxs_proportions() {
    let corner = Handle::Side { x: 1, y: 1 };
    let Shape::Box { size_mm, .. } = dragged(&turned_box(), corner, [9.0, 1.0], Modifiers::SHIFT)
    else {
        panic!("no box");
    };
    assert!(size_mm[0] > 36.0);
    // Each side is rounded to 0.01 mm.
    assert!((size_mm[0] / size_mm[1] - 36.0 / 28.0).abs() < 1e-3);
}

#[test]
fn nothing_is_dragged_to_nothing_or_inside_out() {
    let check = |shape: Shape, handle, to: [f64; 2]| {
        let now = drag(&shape, handle, Vector::from(to), Modifiers::NONE, PER_POINT);
        assert_eq!(faults(&now), [], "{now:?}");
    };
    check(disc(), Handle::Rim(0), [33.0, 89.0]);
    check(turned_box(), Handle::Side { x: 1, y: 1 }, [-40.0, -60.0]);
    check(turned_box(), Handle::Side { x: -1, y: 0 }, [400.0, 60.0]);
    check(turned_box(), Handle::Corner, [-40.0, -60.0]);
    check(turned_box(), Handle::Corner, [400.0, 600.0]);
    check(turned_box(), Handle::Turn, [40.0, 60.0]);
    check(capsule(), Handle::Flank(1), [40.0, -60.0]);
    check(capsule(), Handle::End(1), [25.0, 65.0]);
}

#[test]
fn turns_follow_the_pointer_and_snap_with_shift() {
    let angle = |shape: &Shape, modifiers| {
        // 97.3° from +x as seen from the anchor.
        let (sine, cosine) = 97.3_f64.to_radians().sin_cos();
        let to = Vector::from(shape.anchor_mm()) + 50.0 * Vector::new(cosine, sine);
        drag(shape, Handle::Turn, to, modifiers, PER_POINT).rotation_deg()
    };
    assert!((angle(&turned_box(), Modifiers::NONE) - 7.3).abs() < 1e-9);
    assert_eq!(angle(&turned_box(), Modifiers::SHIFT), 0.0);
    assert!((angle(&polygon(), Modifiers::NONE) - 7.3).abs() < 1e-9);
    assert!((angle(&wall(), Modifiers::NONE) - 97.3).abs() < 1e-9);
    assert_eq!(angle(&wall(), Modifiers::SHIFT), 90.0);
    // More than a whole turn becomes one within half of it.
    assert_eq!(turned(400.0, 100.0, Modifiers::NONE), 100.0);
    assert_eq!(turned(400.0, 40.0, Modifiers::NONE), 400.0);
}

#[test]
fn a_wall_moves_along_its_normal_only() {
    let by = Vector::new(10.0, 0.0);
    let now = moved(&wall(), by, Modifiers::NONE, PER_POINT);
    let step = Vector::from(now.anchor_mm()) - Vector::from(wall().anchor_mm());
    let normal = Turned::by(160.0).x;
    assert!((step - normal.dot(&by) * normal).norm() < 0.01);
    assert!(crate::geometry::cross(step, normal).abs() < 1e-5);
}

#[test]
fn only_the_dragged_vertex_moves_and_the_polygon_stays_convex() {
    let before = vertices(&polygon());
    for index in 0..4 {
        for by in [
            [3.0, 2.0],
            [60.0, 0.0],
            [-60.0, 5.0],
            [0.0, 70.0],
            [2.0, -70.0],
            [300.0, 300.0],
        ] {
            let now = dragged(&polygon(), Handle::Vertex(index), by, Modifiers::NONE);
            assert_eq!(faults(&now), [], "vertex {index} by {by:?}");
            for (i, (a, b)) in before.iter().zip(vertices(&now)).enumerate() {
                assert!(i == index || (a - b).norm() < 1e-9, "vertex {i} by {by:?}");
            }
        }
    }
}

#[test]
fn a_triangle_cannot_be_turned_over() {
    for points_mm in [
        vec![[0.0, 0.0], [10.0, 0.0], [5.0, 8.0]],
        vec![[5.0, 8.0], [10.0, 0.0], [0.0, 0.0]],
    ] {
        let top = points_mm.iter().position(|p| p[1] == 8.0).unwrap();
        let triangle = Shape::Polygon {
            points_mm,
            rotation_deg: 0.0,
            corner_radius_mm: 0.0,
        };
        let now = dragged(
            &triangle,
            Handle::Vertex(top),
            [1.0, -30.0],
            Modifiers::NONE,
        );
        assert_eq!(faults(&now), []);
        assert!(vertices(&now)[top].y > 0.0);
    }
}

#[test]
fn vertices_are_added_on_edges_and_removed_down_to_a_triangle() {
    let corners = vertices(&polygon());
    let middle = 0.5 * (corners[1] + corners[2]);
    let (more, index) = add_vertex(&polygon(), middle + Vector::new(0.4, -0.2)).unwrap();
    assert_eq!(index, 2);
    assert_eq!(faults(&more), []);
    assert!((vertices(&more)[2] - middle).norm() < 0.5);
    assert_eq!(add_vertex(&polygon(), corners[1]), None);
    let fewer = remove_vertex(&more, 2).unwrap();
    assert!(close(&fewer, &polygon(), 1e-9), "{fewer:?}");
    let triangle = remove_vertex(&fewer, 0).unwrap();
    assert_eq!(remove_vertex(&triangle, 0), None);
    assert_eq!(add_vertex(&disc(), middle), None);
}

#[test]
fn points_become_a_convex_polygon() {
    let points = |all: &[[f64; 2]]| all.iter().map(|p| Vector::from(*p)).collect::<Vec<_>>();
    let square = points(&[
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 10.0],
        [0.0, 10.0],
        [0.0, 10.0],
    ]);
    let found = convex(&square).unwrap();
    assert_eq!((found.points.len(), found.left_out), (4, 0));
    let dented = points(&[[0.0, 0.0], [10.0, 0.0], [3.0, 3.0], [0.0, 10.0]]);
    assert_eq!(convex(&dented).unwrap().left_out, 1);
    assert_eq!(convex(&points(&[[0.0, 0.0], [5.0, 5.0], [9.0, 9.0]])), None);
    assert_eq!(convex(&points(&[[0.0, 0.0], [5.0, 5.0]])), None);
}
