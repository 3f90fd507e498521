//! Tables of measurements, good and bad.

use super::*;
use crate::scene::MAX_FILE_BYTES;

#[track_caller]
fn check_refused(text: &str, expected: &str) {
    assert_eq!(
        Sheet::read(text.as_bytes()).unwrap_err().to_string(),
        expected
    );
}

fn rows(text: &str) -> Vec<usize> {
    let (all, _) = backbone(text.as_bytes()).unwrap();
    all.iter().map(|point| point.row).collect()
}

#[test]
fn heads_name_columns_in_any_order() {
    let (all, _) = backbone(b"node, y, x\n0, 0, 0\n1, 10, 0.5\n").unwrap();
    let expected = BackboneRow {
        row: 3,
        node: Some(1),
        point_mm: [0.5, 10.0],
    };
    assert_eq!(all[1], expected);
    let point = MeasuredPoint::from(all[1]);
    assert_eq!((point.row, point.node), (3, Some(1)));
    assert_eq!(point.position, Vector::new(metres(0.5), metres(10.0)));
    let (sheet, _) = Sheet::read(b"force_g,remark,LOAD_G\n3.5,ok,50\n").unwrap();
    let reading = ForceReading {
        load_g: 50.0,
        force_g: 3.5,
    };
    assert_eq!(sheet, Sheet::Forces(vec![reading]));
}

#[test]
fn rows_count_as_an_editor_counts_lines() {
    assert_eq!(rows("# none\n1,2\n"), [2]);
    assert_eq!(rows("\n1,2\r\n\r\n# a\n# b\n3,4\n5,6"), [2, 6, 7]);
    assert_eq!(rows("\u{feff}x,y\n1,2"), [2]);
    assert!(rows("").is_empty());
}

#[test]
fn spreadsheets_of_every_country_are_read() {
    for text in [
        "x_mm,y_mm\n1,2.5\n",
        "x_mm;y_mm\r\n1;2.5\r\n",
        "# tabs\nx_mm\ty_mm\n1\t2.5\n",
        "sep=;\r\nx_mm;y_mm\r\n1;2.5\r\n",
        "\u{feff}\"sep=|\"\nx_mm|y_mm\n1|2.5\n",
        "sep=\t\nx_mm\ty_mm\n1\t2.5\n",
        "x_mm y_mm\n  1.0   2.5\n",
        "X (mm)  Y (mm)\n1 2.5\n",
    ] {
        let (sheet, _) = Sheet::read(text.as_bytes()).unwrap();
        let Sheet::Backbone(rows) = sheet else {
            panic!("{sheet:?}");
        };
        assert_eq!((rows.len(), rows[0].point_mm), (1, [1.0, 2.5]), "{text:?}");
    }
}

/// The point of the one row below a head, in mm.
#[track_caller]
fn point(head: &str, row: &str) -> [f64; 2] {
    let text = format!("{head}\n{row}\n");
    let (sheet, _) = Sheet::read(text.as_bytes()).unwrap();
    let (rows, _) = backbone(text.as_bytes()).unwrap();
    assert_eq!(sheet, Sheet::Backbone(rows.clone()));
    rows[0].point_mm
}

#[test]
fn heads_name_units() {
    for (head, row) in [
        ("x,y", "1,2"),
        ("x_mm,y_mm", "1,2"),
        ("X (mm),Y (mm)", "1,2"),
        ("x [mm];y [mm]", "1;2"),
        ("y/mm,x/mm", "2,1"),
        ("x millimeters\ty millimeters", "1\t2"),
    ] {
        assert_eq!(point(head, row), [1.0, 2.0], "{head}");
    }
    assert_eq!(point("x_m,y_m", "0.05,0.125"), [50.0, 125.0]);
    assert_eq!(point("X [cm],Y [cm]", "5,12.5"), [50.0, 125.0]);
    assert_eq!(point("x (in),y (in)", "1,2"), [25.4, 50.8]);
    assert_eq!(point("x (µm),y_um", "1000,2000"), [1.0, 2.0]);
    assert_eq!(point("x_cm,y_mm", "1,2"), [10.0, 2.0]);
    let (sheet, _) = Sheet::read(b"force (N);load [kg]\n0.1;0.25\n").unwrap();
    let Sheet::Forces(readings) = sheet else {
        panic!("{sheet:?}");
    };
    // 0.1 N weigh 100/9.80665 g.
    assert!((readings[0].force_g - 10.197_162).abs() < 1e-6);
    assert_eq!(readings[0].load_g, 250.0);
    check_refused(
        "x_ft,y_ft\n1,2\n",
        "row 1: the unit of \"x_ft\" is not known; write one of mm, cm, m, um, in",
    );
    check_refused(
        "load (lb),force (lb)\n1,2\n",
        "row 1: the unit of \"load (lb)\" is not known; write one of g, kg, N, mN",
    );
    check_refused(
        "x,y (m)\n1,2\n",
        "row 1: \"y (m)\" names a unit and \"x\" does not; name that of both",
    );
    // A column that only begins like one of ours is none of ours.
    assert_eq!(point("x_std,y_std,x_m,y_m", "9,9,0.001,0.002"), [1.0, 2.0]);
    check_refused(
        "x_cm,y_cm\n1e6,0\n",
        "row 2: x_cm is 10000000 mm; it has to be from -1000000 to 1000000 mm",
    );
}

/// numpy separates by spaces and puts heads into comments.
#[test]
fn what_numpy_and_solve_print_is_read() {
    let (rows, _) = backbone(b"0.000e+00 0.000e+00\n1.000e+00 1.250e+01\n").unwrap();
    assert_eq!((rows[1].row, rows[1].point_mm), (2, [1.0, 12.5]));
    let saved = "# taken on Monday\n# x_m y_m\n0 0\n0.001 0.0125\n";
    let (rows, _) = backbone(saved.as_bytes()).unwrap();
    assert_eq!((rows[1].row, rows[1].point_mm), (4, [1.0, 12.5]));
    // A head may be written with other separators than the numbers.
    assert_eq!(point("# y (cm), x (cm)", "2 1"), [10.0, 20.0]);
    check_refused(
        "# x_ft y_ft\n1 2\n",
        "row 1: the unit of \"x_ft\" is not known; write one of mm, cm, m, um, in",
    );
    check_refused(
        "# two numbers\n1 2\n",
        "row 2: there is no head; write x_mm,y_mm or load_g,force_g above the numbers",
    );
    let solved = "node,backbone_x_mm,backbone_y_mm,cable_x_mm,cable_y_mm,bend_rad,shear_rad\n\
                  0,1.0,2.0,9.0,2.0,,\n";
    let (rows, _) = backbone(solved.as_bytes()).unwrap();
    assert_eq!((rows[0].node, rows[0].point_mm), (Some(0), [1.0, 2.0]));
}

#[test]
fn rows_that_hold_nothing_are_left_out_and_told() {
    let check = |text: &str, kept: &[usize], told: &str| {
        let (rows, left_out) = backbone(text.as_bytes()).unwrap();
        let rows: Vec<usize> = rows.iter().map(|row| row.row).collect();
        assert_eq!(
            (&rows[..], &*left_out.to_string()),
            (kept, told),
            "{text:?}"
        );
    };
    check("x,y\n1,2\n3,4\n\n", &[2, 3], "");
    check("x,y\r\n1,2\r\n3,4\r\n\r\n", &[2, 3], "");
    check(
        "x,y\r\n1,2\r\n\r\n3,4\r\n",
        &[2, 4],
        "row 3 holds no numbers and was left out",
    );
    check(
        "x,y\n1,2\nNaN,nan\n3,4\n",
        &[2, 4],
        "row 3 holds no numbers and was left out",
    );
    check(
        "1 2\n\n3 4\n   \nnan 3\n5 6\n",
        &[1, 3, 6],
        "rows 2, 4 and 5 hold no numbers and were left out",
    );
    check(
        "\nnode,x,y\n0,1,2\n,,\n# none\n2,,\n3,4,nan\n4,5,6\n,,\n\n",
        &[3, 8],
        "rows 4, 6 and 7 hold no numbers and were left out",
    );
    let gaps = "x,y\n1,2\n".to_owned() + &",\n".repeat(7) + "3,4\n";
    check(
        &gaps,
        &[2, 10],
        "rows 3, 4, 5, 6, 7 and 2 more hold no numbers and were left out",
    );
    let (sheet, left_out) = Sheet::read(b"load_g,force_g\n50,4\nnan,7\n").unwrap();
    assert!(matches!(sheet, Sheet::Forces(readings) if readings.len() == 1));
    assert_eq!(left_out.rows(), [3]);
}

#[test]
fn nodes_order_the_points_that_name_them() {
    let (rows, _) = backbone(b"node,x,y\n9,0,90\n0,0,0\n4,0,40\n").unwrap();
    let nodes: Vec<_> = rows.iter().map(|row| (row.row, row.node)).collect();
    assert_eq!(nodes, [(3, Some(0)), (4, Some(4)), (2, Some(9))]);
}

/// `index,x,y` and decimal commas.
#[test]
fn columns_without_a_head_are_not_guessed() {
    for (text, row, fields) in [
        ("0,1,2\n1,3,4\n", 1, 3),
        ("0 1 2\n1 3 4\n", 1, 3),
        ("1,2\n3,4,5\n", 2, 3),
        ("0,5,1,25\n", 1, 4),
        ("0,5;1,25\n", 1, 3),
    ] {
        let fault = backbone(text.as_bytes()).unwrap_err();
        assert_eq!(fault, SheetFault::Nameless { row, fields }, "{text:?}");
    }
    assert_eq!(
        backbone(b"0,1,2\n").unwrap_err().to_string(),
        "row 1: there are 3 columns and no head that tells which are x and y; write one such as \
         node,x_mm,y_mm above the numbers, and numbers as 12.5, with a point"
    );
    // Columns at the end that hold nothing are none.
    assert_eq!(rows("1,2,\n3,4,,\n"), [1, 2]);
}

#[test]
fn a_sheet_takes_the_place_of_its_kind_only() {
    let mut held = Measurements {
        points_mm: vec![[1.0, 1.0], [2.0, 2.0]],
        nodes: vec![],
        calibration: Some(0),
        forces: vec![ForceReading {
            load_g: 1.0,
            force_g: 1.0,
        }],
    };
    let before = held.clone();
    let read = |text: &str| Sheet::read(text.as_bytes()).unwrap().0;
    read("node,x_mm,y_mm\n0,0,0\n9,0,90\n").put_into(&mut held);
    assert_eq!(held.points_mm, [[0.0, 0.0], [0.0, 90.0]]);
    assert_eq!(held.nodes, [0, 9]);
    assert_eq!((held.calibration, &held.forces), (Some(0), &before.forces));
    read("x_mm,y_mm\n0,0\n0,90\n0,95\n").put_into(&mut held);
    assert_eq!((held.points_mm.len(), held.nodes.len()), (3, 0));
    read("load_g,force_g\n50,4\n100,7\n").put_into(&mut held);
    assert_eq!((held.forces.len(), held.calibration), (2, None));
    assert_eq!(held.points_mm.len(), 3);
}

#[test]
fn faults_name_row_and_column() {
    let empty =
        "there are no rows of numbers; write them below a head such as x_mm,y_mm or load_g,force_g";
    check_refused("", empty);
    check_refused("# only this\n\n", empty);
    check_refused("load_g,force_g\n", empty);
    check_refused(
        "\n0,0\n1,2\n",
        "row 2: there is no head; write x_mm,y_mm or load_g,force_g above the numbers",
    );
    for head in ["left,right", "x_mm,force_g", "x_mm,y_mm,load_g,force_g"] {
        check_refused(
            &format!("{head}\n1,2,3,4\n"),
            &format!(
                "row 1: the head is \"{head}\"; it has to name either x_mm and y_mm, for a backbone, or load_g and force_g, for readings of forces"
            ),
        );
    }
    check_refused(
        "load_g,force_g\n50,4\n\n100,\n",
        "row 4: force_g is missing",
    );
    check_refused("load_g,force_g\n50\n", "row 2: force_g is missing");
    check_refused(
        "load_g,force_g\n50,3,5\n",
        "row 2: there are 3 fields below a head of 2; write numbers as 12.5, with a point",
    );
    for field in ["4 g", "inf", "4;5"] {
        check_refused(
            &format!("load_g,force_g\n50,{field}\n"),
            &format!("row 2: force_g is \"{field}\", which is not a number; write numbers as 12.5"),
        );
    }
    check_refused(
        "load_g,force_g\n-50,4\n",
        "row 2: load_g is -50 g; it has to be from 0 to 1000000 g",
    );
    check_refused(
        "x_mm,y_mm\n0,0\n1e7,0\n",
        "row 3: x_mm is 10000000 mm; it has to be from -1000000 to 1000000 mm",
    );
    check_refused(
        "node,x_mm,y_mm\n1.5,0,0\n",
        "row 2: node is 1.5; nodes count 0, 1, 2 and so on from the base",
    );
    let long = format!("load_g,force_g\n50,{}\n", "x".repeat(100_000));
    let told = Sheet::read(long.as_bytes()).unwrap_err().to_string();
    assert!(told.len() < 200 && told.contains('…'), "{told}");
}

#[test]
fn what_is_no_table_is_refused() {
    let of = |bytes: &[u8]| Sheet::read(bytes).unwrap_err().to_string();
    assert_eq!(
        of(b"x_mm,y_mm\n1,\xff\n"),
        "row 2: this is not UTF-8 text; measurements are a CSV text file"
    );
    assert_eq!(
        of(&vec![b'1'; MAX_FILE_BYTES + 1]),
        "the file has 4194305 bytes; measurements have at most 4194304"
    );
    let many = format!("load_g,force_g\n{}", "1,1\n".repeat(1001));
    assert_eq!(
        of(many.as_bytes()),
        "there are 1001 rows; at most 1000 are allowed: leave out every other one"
    );
}
