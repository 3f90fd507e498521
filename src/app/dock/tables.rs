//! Tables of what touches and of what stands around, for the dock. A row
//! lights up with its twin on the canvas; clicking it selects the obstacle.

use crate::app::look::{Tokens, colour, theme_of};
use crate::app::widgets::{
    Number,
    row::{self, Emphasis},
    understated, with_form,
};
use crate::app::words;
use crate::app::workbench::{Hovered, Selection, Workbench};
use crate::contact::Class;
use crate::forces::Statics;
use crate::robot::part_name;
use crate::scene::limits::{COORDINATE, Limits, RADIUS};
use crate::scene::{Obstacle, Shape};
use crate::units::{grams, millimetres, per_millimetre};
use crate::view::Quantity;
use eframe::egui::{
    Align, CornerRadius, Id, Rect, RichText, ScrollArea, Sense, Ui, UiBuilder, pos2, vec2,
};

/// Space before and after a row's contents, in points.
const MARGIN: f32 = 8.0;
/// Space between columns, in points.
const GAP: f32 = 16.0;
/// Height of the headings, in points.
const HEAD: f32 = 24.0;

/// A column: its heading, its least width in points, its share of the width
/// that is left, and where its cells are aligned.
struct Column {
    head: &'static str,
    width: f32,
    grows: f32,
    align: Align,
}

const fn column(head: &'static str, width: f32, grows: f32, align: Align) -> Column {
    Column {
        head,
        width,
        grows,
        align,
    }
}

/// The places of a table's columns.
struct Columns {
    edges: Vec<(f32, f32)>,
    aligns: Vec<Align>,
    width: f32,
}

impl Columns {
    fn of(columns: &[Column], available: f32) -> Self {
        let gaps = GAP * columns.len().saturating_sub(1) as f32;
        let least: f32 = columns.iter().map(|it| it.width).sum::<f32>() + gaps + 2.0 * MARGIN;
        let grow: f32 = columns.iter().map(|it| it.grows).sum();
        let spare = (available - least).max(0.0) / grow.max(f32::MIN_POSITIVE);
        let mut x = MARGIN;
        let edges = columns.iter().map(|it| {
            let from = x;
            x += it.width + it.grows * spare;
            let edge = (from, x);
            x += GAP;
            edge
        });
        Self {
            edges: edges.collect(),
            aligns: columns.iter().map(|it| it.align).collect(),
            width: least.max(available),
        }
    }

    fn cell(&self, row: Rect, index: usize) -> Rect {
        let (from, to) = self.edges.get(index).copied().unwrap_or_default();
        let left = row.left();
        Rect::from_min_max(pos2(left + from, row.top()), pos2(left + to, row.bottom()))
    }

    fn text(&self, ui: &mut Ui, row: Rect, index: usize, text: impl Into<RichText>) {
        let align = self.aligns.get(index).copied().unwrap_or(Align::Min);
        row::text(ui, self.cell(row, index), text, align);
    }

    fn heads(&self, ui: &mut Ui, columns: &[Column]) {
        let muted = Tokens::in_ui(ui).muted;
        let (rect, _) = ui.allocate_exact_size(vec2(self.width, HEAD), Sense::hover());
        for (index, column) in columns.iter().enumerate() {
            let head = RichText::new(column.head).small().color(muted);
            self.text(ui, rect, index, head);
        }
    }
}

/// A table that scrolls both ways, its headings above it.
fn table(
    ui: &mut Ui,
    id: &str,
    columns: &[Column],
    rows: usize,
    mut row: impl FnMut(&mut Ui, &Columns, usize),
) {
    let places = Columns::of(columns, ui.available_width());
    ScrollArea::horizontal()
        .id_salt((id, "across"))
        .auto_shrink([false, false])
        .show(ui, |ui| {
            ui.set_width(places.width);
            ui.spacing_mut().item_spacing.y = 0.0;
            places.heads(ui, columns);
            let height = row::height(ui);
            ScrollArea::vertical()
                .id_salt((id, "down"))
                .auto_shrink([false, false])
                .show_rows(ui, height, rows, |ui, range| {
                    for index in range {
                        row(ui, &places, index);
                    }
                });
        });
}

/// The contacts: what presses where, and how hard. With forces where the
/// bending stiffness is known; `forces` are those of the live solution.
pub fn contacts(ui: &mut Ui, bench: &mut Workbench, forces: Option<&Statics>) {
    let count = bench.live.solution().map_or(0, |it| it.contacts.len());
    if count == 0 {
        ui.weak("Nothing touches the robot.");
        return;
    }
    let mut columns = vec![
        column("Part", 168.0, 2.0, Align::Min),
        column("Obstacle", 80.0, 1.0, Align::Min),
        column("State", 64.0, 0.0, Align::Min),
        column("Multiplier λ, rad²/mm", 152.0, 0.0, Align::Max),
        column("Clearance, mm", 88.0, 0.0, Align::Max),
    ];
    if forces.is_some() {
        columns.push(column("Force, g", 64.0, 0.0, Align::Max));
        understated(ui, bench);
    }
    table(ui, "contacts", &columns, count, |ui, places, index| {
        contact(ui, bench, forces, places, index);
    });
}

fn contact(
    ui: &mut Ui,
    bench: &mut Workbench,
    forces: Option<&Statics>,
    places: &Columns,
    index: usize,
) {
    let Some(shape) = bench.live.shape() else {
        return;
    };
    let Some(contact) = shape.solved.contacts.get(index) else {
        return;
    };
    let part = words::capital(&part_name(
        shape.solved.problem().robot(),
        contact.line,
        contact.node,
    ));
    let obstacle = contact.obstacle;
    let name = words::obstacle_of(&bench.document.scene, obstacle);
    let emphasis = Emphasis {
        selected: bench.selection == Selection::Obstacle(obstacle),
        lit: bench.hovered == Hovered::Contact(index),
    };
    let class = match contact.class {
        Class::Pressing => "presses",
        Class::Grazing => "grazes",
    };
    let id = Id::unique(("contact", index));
    let response = row::row(ui, id, &format!("{part} {class} on {name}"), emphasis);
    let rect = response.rect;
    places.text(ui, rect, 0, part);
    places.text(ui, rect, 1, name);
    places.text(ui, rect, 2, class);
    bar(
        ui,
        places.cell(rect, 3),
        bench.live.drawing().scale.of(contact),
    );
    let multiplier = Quantity::significant(per_millimetre(contact.multiplier), "");
    places.text(ui, rect, 3, multiplier.digits);
    let clearance = Quantity::order(millimetres(contact.clearance), "");
    places.text(ui, rect, 4, clearance.digits);
    if let Some(forces) = forces {
        let force = forces.contacts.get(index);
        let force = force.map(|it| Quantity::significant(grams(it.normal_force), "").digits);
        places.text(ui, rect, 5, force.unwrap_or_default());
    }
    if response.hovered() {
        bench.hovering = Hovered::Contact(index);
    }
    if response.clicked() {
        bench.selection = Selection::Obstacle(obstacle);
    }
}

/// A bar in the contact scale at the left of a cell.
fn bar(ui: &Ui, cell: Rect, share: f64) {
    const LONG: f32 = 80.0;
    let theme = theme_of(ui);
    let share = share.clamp(0.0, 1.0);
    let middle = cell.left_center();
    let rail = Rect::from_min_size(middle - vec2(0.0, 3.0), vec2(LONG, 6.0));
    let mut filled = rail;
    filled.set_width((LONG * share as f32).max(2.0));
    let radius = CornerRadius::same(3);
    let painter = ui.painter();
    painter.rect_filled(rail, radius, Tokens::of(theme).sunken);
    painter.rect_filled(filled, radius, colour(theme.contact(share)));
}

/// The obstacles: what stands where, and whether the robot presses on it.
pub fn obstacles(ui: &mut Ui, bench: &mut Workbench) {
    let count = bench.document.scene.obstacles.len();
    if count == 0 {
        ui.weak("Nothing stands around the robot.");
        return;
    }
    let columns = [
        column("Name", 112.0, 1.0, Align::Min),
        column("Shape", 64.0, 0.0, Align::Min),
        column("x, mm", 72.0, 0.0, Align::Max),
        column("y, mm", 72.0, 0.0, Align::Max),
        column("Size or radius, mm", 128.0, 0.0, Align::Max),
        column("Contact", 64.0, 0.0, Align::Min),
    ];
    table(ui, "obstacles", &columns, count, |ui, places, index| {
        obstacle(ui, bench, places, index);
    });
}

fn obstacle(ui: &mut Ui, bench: &mut Workbench, places: &Columns, index: usize) {
    let Some(found) = bench.document.scene.obstacles.get(index) else {
        return;
    };
    let name = words::obstacle(index, found);
    let this = Selection::Obstacle(index);
    let emphasis = Emphasis {
        selected: bench.selection == this,
        lit: bench.hovered == Hovered::Obstacle(index),
    };
    let response = row::row(ui, Id::unique(("obstacle row", index)), &name, emphasis);
    let rect = response.rect;
    places.text(ui, rect, 0, &name);
    places.text(ui, rect, 1, words::shape(&found.shape));
    if !matches!(found.shape, Shape::Disc { .. }) {
        places.text(ui, rect, 4, size(found));
    }
    let cells = [2, 3, 4].map(|column| places.cell(rect, column).shrink2(vec2(0.0, 2.0)));
    let edited = numbers(ui, bench, cells, index, &name);
    let contacts = bench.live.solution().map_or(&[][..], |it| &it.contacts);
    let mut on = contacts.iter().filter(|it| it.obstacle == index).peekable();
    let touches = on.peek().is_some();
    let word = match on.any(|it| it.class == Class::Pressing) {
        true => "presses",
        false if touches => "grazes",
        false => "",
    };
    places.text(ui, rect, 5, word);
    if response.hovered() {
        bench.hovering = Hovered::Obstacle(index);
    }
    if response.clicked() || edited {
        // What is wrong with a number is told in the inspector.
        bench.selection = this;
    }
}

/// The fields of an obstacle's place and of a disc's radius. Whether one of
/// them is in use.
fn numbers(
    ui: &mut Ui,
    bench: &mut Workbench,
    [x, y, size]: [Rect; 3],
    index: usize,
    name: &str,
) -> bool {
    let mut used = false;
    with_form(bench, |scene, form| {
        let Some(obstacle) = scene.obstacles.get_mut(index) else {
            return;
        };
        let shape = &mut obstacle.shape;
        let mut field = |cell: Rect, key: &str, called: &str, limits: Limits, value: &mut f64| {
            let number = Number {
                place: "table",
                ..Number::length(format!("obstacle[{index}].{key}"), called, limits)
            };
            let mut ui = ui.new_child(UiBuilder::new().max_rect(cell));
            let name = format!("{called} of {name}");
            form.value(&mut ui, &number, value, cell.size(), |field| {
                used |= field.has_focus() || field.dragged();
                field.accessible_name(&name)
            })
        };
        let key = match shape {
            Shape::Wall { .. } => "point_mm",
            Shape::Polygon { .. } => "points_mm",
            _ => "center_mm",
        };
        let mut at = shape.anchor_mm();
        let moved = [
            field(x, &format!("{key}[0]"), "x", COORDINATE, &mut at[0]),
            field(y, &format!("{key}[1]"), "y", COORDINATE, &mut at[1]),
        ];
        if moved.contains(&true) {
            shape.move_to_mm(at);
        }
        if let Shape::Disc { radius_mm, .. } = shape {
            field(size, "radius_mm", "Radius", RADIUS, radius_mm);
        }
    });
    used
}

/// An obstacle's size, in mm.
fn size(obstacle: &Obstacle) -> String {
    let mm = |value: f64| Quantity::fixed(value, 2, "").digits;
    match &obstacle.shape {
        Shape::Disc { radius_mm, .. } => mm(*radius_mm),
        Shape::Wall { .. } => "without end".to_owned(),
        Shape::Box { size_mm, .. } => format!("{} × {}", mm(size_mm[0]), mm(size_mm[1])),
        Shape::Capsule {
            length_mm,
            radius_mm,
            ..
        } => format!(
            "{} × {}",
            mm(length_mm + 2.0 * radius_mm),
            mm(2.0 * radius_mm)
        ),
        Shape::Polygon { points_mm, .. } => format!("{} vertices", points_mm.len()),
    }
}
