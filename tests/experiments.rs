//! The paper's numbers, recomputed: each figure and table against what the
//! paper's text says.

use sinew::experiments::{
    Check, ForceRow, ForceTable, Id, Item, PaperScene, TableFault, Verdict, pull_window, reproduce,
};
use sinew::mechanics::Problem;
use sinew::units::millimetres;
use sinew::view::charts;

/// Table 1, as in its text.
fn table() -> ForceTable {
    let row = |load_g: f64, measured: [f64; 4], theory_g: f64| ForceRow {
        load_g,
        measured_g: measured.to_vec(),
        theory_g,
    };
    let rows = vec![
        row(50.0, [3.0, 4.0, 3.0, 3.0], 3.5),
        row(100.0, [7.0, 7.0, 7.0, 7.0], 7.1),
        row(150.0, [10.2, 10.8, 10.0, 10.0], 10.7),
        row(200.0, [13.7, 14.0, 14.0, 14.0], 14.2),
        row(250.0, [17.0, 17.8, 17.0, 17.0], 17.8),
        row(300.0, [20.2, 21.0, 20.5, 21.0], 21.3),
        row(350.0, [23.0, 24.8, 23.8, 24.0], 24.9),
    ];
    ForceTable::new(vec![24.0, 31.0, 36.0, 51.0], rows).unwrap()
}

fn item(id: Id) -> Item {
    reproduce(id, &table()).unwrap()
}

#[track_caller]
fn check_of<'a>(item: &'a Item, quantity: &str) -> &'a Check {
    let mut found = item.checks.iter().filter(|c| c.quantity == quantity);
    found
        .next()
        .unwrap_or_else(|| panic!("no {quantity} in {:?}", item.id))
}

#[track_caller]
fn ours(item: &Item, quantity: &str) -> f64 {
    check_of(item, quantity).ours.unwrap()
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} is not {expected}"
    );
}

#[test]
fn every_item_says_something_and_nothing_is_invented() {
    for id in Id::ALL {
        let item = item(id);
        assert_eq!(item.id, id);
        assert!(!item.checks.is_empty(), "{id:?}");
        for check in &item.checks {
            for value in [check.paper, check.ours].into_iter().flatten() {
                assert!(value.is_finite(), "{id:?}: {check:?}");
            }
            let both = check.paper.is_some() && check.ours.is_some();
            let compared = matches!(check.verdict, Verdict::Agrees | Verdict::Differs);
            assert_eq!(both, compared, "{id:?}: {check:?}");
        }
        for picture in &item.pictures {
            assert!(picture.solved.certificate.holds(), "{id:?}");
        }
        assert_eq!(Id::of_word(id.word()), Some(id));
        assert_eq!(Id::of_word(id.name()), Some(id));
    }
    assert_eq!(Id::of_word("Figure 4a"), Some(Id::Fig4a));
    for wrong in ["", "fig", "4", "fig6", "table2", "table"] {
        assert_eq!(Id::of_word(wrong), None, "{wrong}");
    }
}

#[test]
fn the_free_profile_is_the_circle() {
    let item = item(Id::Fig3b);
    // Picometres: rounding of a chain of 18 links of 10 mm.
    assert!(ours(&item, "Greatest distance of a node from the closed form") < 1.0);
    assert_eq!(ours(&item, "Nodes of the backbone"), 19.0);
}

#[test]
fn both_posts_press_where_the_paper_says() {
    for id in [Id::Fig4b, Id::Fig5] {
        let item = item(id);
        for (quantity, expected) in [
            ("Node on the lower post, from 1", 11.0),
            ("Node on the upper post, from 1", 17.0),
            ("Disk on the lower post, from 1", 6.0),
            ("Disk on the upper post, from 1", 9.0),
        ] {
            assert_eq!(ours(&item, quantity), expected, "{quantity}");
            assert_eq!(check_of(&item, quantity).verdict, Verdict::Agrees);
        }
    }
    let item = item(Id::Fig4b);
    near(
        ours(&item, "Both posts press at these nodes from a pull of"),
        4.768,
        5e-4,
    );
    near(ours(&item, "… to a pull of"), 5.102, 5e-4);
}

#[test]
fn multipliers_are_zero_off_the_contacts() {
    let item = item(Id::Fig5);
    for (series, node) in charts(&item)[0].series.iter().zip([11.0, 17.0]) {
        for (x, y) in &series.points {
            assert_eq!(*y > 0.0, *x == node, "{series:?}");
        }
    }
}

#[test]
fn the_theory_column_comes_from_one_measured_point() {
    let item = item(Id::Table1);
    for row in table().rows() {
        let check = check_of(&item, &format!("Theory at {} g", row.load_g));
        assert_eq!(check.paper, Some(row.theory_g));
        assert!(check.difference().unwrap().abs() <= 0.1, "{check:?}");
        assert_eq!(check.verdict, Verdict::Agrees);
    }
    // By hand from the table: 0.0712 P_l against the columns.
    for (distance, mean) in [(24, 0.797), (31, 0.200), (36, 0.626), (51, 0.526)] {
        let quantity = format!("Average error at d = {distance} mm");
        near(ours(&item, &quantity), mean, 5e-4);
    }
    near(ours(&item, "Average error over all"), 0.537, 5e-4);
}

/// By another solver of the same mechanics: force over load and the average errors.
#[test]
fn one_set_of_constants_of_friction_comes_near_all_measured_forces() {
    let item = item(Id::Table1);
    let found = [
        (24, 0.0688, 0.341),
        (31, 0.0684, 0.530),
        (36, 0.0684, 0.209),
        (51, 0.0692, 0.269),
    ];
    for (distance, ratio, mean) in found {
        let of = format!("sliding cable with friction (fitted), d = {distance} mm");
        near(ours(&item, &format!("Force over load, {of}")), ratio, 6e-5);
        near(ours(&item, &format!("Average error, {of}")), mean, 6e-4);
    }
    let all = "Average error over all 28, sliding cable with friction (fitted)";
    near(ours(&item, all), 0.337, 6e-4);
}

#[test]
fn the_calibration_point_is_the_one_nearest_to_the_theory_column() {
    let table = table();
    let mut all = Vec::new();
    for row in table.rows() {
        for (distance, force) in table.distances_mm().iter().zip(&row.measured_g) {
            let ratio = force / row.load_g;
            let rows = table.rows().iter();
            let off = rows.map(|r| (ratio * r.load_g - r.theory_g).abs());
            all.push((off.fold(0.0, f64::max), row.load_g, *distance));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!((all[0].1, all[0].2), (250.0, 31.0));
    // Only one other stays within 0.1 g, and that by a hair.
    assert!(
        all[0].0 < 0.065 && all[1].0 > 0.099 && all[2].0 > 0.3,
        "{all:?}"
    );
}

#[test]
fn the_load_cell_meets_the_papers_node() {
    let item = item(Id::Fig9);
    assert_eq!(ours(&item, "Node that touches, from 1"), 15.0);
    assert_eq!(ours(&item, "Disk that touches, from the top"), 3.0);
    near(ours(&item, "x of the cable's node there"), 26.0, 1e-6);
    near(ours(&item, "Pull at which it touches"), 2.70, 0.005);
}

#[test]
fn other_pulls_and_photographs_are_named_as_missing() {
    for id in [Id::Fig3b, Id::Fig4a, Id::Fig4b, Id::Fig10b] {
        assert!(!item(id).missing.is_empty(), "{id:?}");
    }
    let photograph = item(Id::Fig4a);
    let check = check_of(&photograph, "Distance from the photograph over the length");
    assert_eq!((check.verdict, check.ours), (Verdict::NotGiven, None));
}

#[test]
fn tables_that_are_none_are_refused() {
    let row = |load_g, forces: &[f64]| ForceRow {
        load_g,
        measured_g: forces.to_vec(),
        theory_g: 1.0,
    };
    let check = |rows: Vec<ForceRow>, fault| {
        assert_eq!(ForceTable::new(vec![24.0], rows), Err(fault));
    };
    check(vec![], TableFault::Empty);
    check(vec![row(1.0, &[])], TableFault::Ragged(1));
    check(
        vec![row(1.0, &[1.0]), row(0.0, &[1.0])],
        TableFault::NotPositive(2),
    );
    let other = ForceTable::new(vec![24.0], vec![row(1.0, &[1.0])]).unwrap();
    assert!(reproduce(Id::Table1, &other).is_err());
    assert!(reproduce(Id::Fig4b, &other).is_ok());
}

#[test]
fn windows_of_pulls_are_found_to_their_ends() {
    let problem = Problem::new(&PaperScene::Free.scene().unwrap()).unwrap();
    let between = |low: f64, high: f64| {
        pull_window(&problem, 8.0, 0.25, move |s| {
            (low..=high).contains(&millimetres(s.pull))
        })
        .unwrap()
    };
    let (first, last) = between(1.234, 5.678).unwrap().ends_mm();
    near(first, 1.234, 2e-5);
    near(last, 5.678, 2e-5);
    // Open at both ends, and nowhere.
    assert_eq!(between(-1.0, 9.0).unwrap().ends_mm(), (0.0, 8.0));
    assert_eq!(between(9.0, 10.0), None);
}

/// A cable that slides without friction, with no number fitted: the force over the load
/// at each distance of the cell, and at each of the four upper disks, to the four digits
/// that another solver gave.
#[test]
fn the_sliding_cable_presses_as_another_solver_says() {
    let table_1 = item(Id::Table1);
    for (distance, expected) in [(24, 0.0896), (31, 0.0916), (36, 0.0935), (51, 0.1013)] {
        let quantity =
            format!("… sliding cable without friction, d = {distance} mm (measured, through 0)");
        near(ours(&table_1, &quantity), expected, 2e-4);
    }
    let figure = item(Id::Fig10b);
    for (node, expected) in [(19, 0.0698), (17, 0.0792), (15, 0.0916), (13, 0.1091)] {
        let quantity = format!("… of a sliding cable without friction, d = 31 mm (node {node})");
        near(ours(&figure, &quantity), expected, 2e-4);
    }
}

/// The same with the friction that was fitted to Table 1: at disk 3 it was fitted, and
/// what it says of the others is called a prediction.
#[test]
fn constants_of_the_third_disk_predict_the_others() {
    let figure = item(Id::Fig10b);
    let found = [
        (19, 0.0534, ", predicted"),
        (17, 0.0599, ", predicted"),
        (15, 0.0683, ", fitted there"),
        (13, 0.0798, ", predicted"),
    ];
    // Another solver's are for a loss of 0.166, a thousandth more.
    for (node, expected, told) in found {
        let quantity = format!("… of a sliding cable with friction{told}, d = 31 mm (node {node})");
        near(ours(&figure, &quantity), expected, 2e-4);
    }
    let words: Vec<_> = charts(&figure).iter().map(|chart| chart.word).collect();
    assert_eq!(words, ["force", "sliding", "friction"]);
}

#[test]
fn both_sliding_cables_stand_beside_the_papers_theory() {
    let table = item(Id::Table1);
    for (model, mean) in [
        ("the paper's theory", 0.514),
        ("sliding cable without friction", 5.020),
        ("sliding cable with friction (fitted)", 0.337),
    ] {
        let at = |d: &str| ours(&table, &format!("Average error, {model}, d = {d} mm"));
        let over_all = ours(&table, &format!("Average error over all 28, {model}"));
        let by_distance = ["24", "31", "36", "51"].map(at);
        near(by_distance.iter().sum::<f64>() / 4.0, over_all, 1e-9);
        near(over_all, mean, 6e-4);
    }
    let figure = item(Id::Fig10a);
    let of = "sliding cable with friction, d = 24 mm";
    near(
        ours(&figure, &format!("Force over load, {of}")),
        0.0688,
        6e-5,
    );
    near(ours(&figure, &format!("Average error, {of}")), 0.341, 6e-4);
    let figure = item(Id::Fig9);
    for (what, pull_mm, load_g) in [("without", 2.711, 189.8), ("with", 2.652, 232.8)] {
        let of = format!("sliding cable {what} friction");
        near(ours(&figure, &format!("The same, {of}")), pull_mm, 6e-4);
        let load = ours(&figure, &format!("Load at which it touches, {of}"));
        near(load, load_g, 0.06);
    }
}

/// Where constants were fitted nothing is called predicted.
#[test]
fn nothing_fitted_is_called_predicted() {
    for id in Id::ALL {
        for check in item(id).checks {
            let told = check.quantity.contains("predicted");
            let fitted = check.quantity.contains("node 15)") || check.quantity.contains("fitted");
            assert!(!(told && fitted), "{}", check.quantity);
        }
    }
}
