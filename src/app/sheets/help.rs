//! The help: keys and gestures, what the colours mean, the model in a few
//! sentences. The keys come from the list of commands.

use super::frame::{Stays, caption, large};
use crate::app::commands::{ALL, Group};
use crate::app::look::{Tokens, colour, contact_scale, semibold, theme_of};
use crate::view::{Role, Standing};
use eframe::egui::{
    Color32, Context, Frame, Grid, Label, Margin, Rect, RichText, Sense, Shape, Stroke, Ui, vec2,
};

/// The paper whose model this is.
const PAPER: &str = "The model is that of the paper “Profile and contact force estimation of \
                     cable-driven continuum robots in presence of obstacles”.";

pub(super) fn show(ctx: &Context) -> Stays {
    large(ctx, "help", "Help", (860.0, 640.0), |ui| {
        ui.spacing_mut().interact_size.y = 20.0;
        model(ui);
        ui.add_space(20.0);
        let wide = ui.available_width() > 620.0;
        if wide {
            ui.columns(2, |columns| {
                if let [left, right] = columns {
                    gestures(left);
                    left.add_space(20.0);
                    colours(left);
                    keys(right);
                }
            });
        } else {
            gestures(ui);
            ui.add_space(20.0);
            colours(ui);
            ui.add_space(20.0);
            keys(ui);
        }
        ui.add_space(20.0);
        let version = concat!("Sinew ", env!("CARGO_PKG_VERSION"), ", MIT licence");
        ui.label(
            RichText::new(version)
                .small()
                .color(Tokens::in_ui(ui).muted),
        );
    })
}

fn model(ui: &mut Ui) {
    caption(ui, "The model");
    ui.label(MODEL);
    ui.add_space(4.0);
    ui.label(RichText::new(PAPER).small().color(Tokens::in_ui(ui).muted));
}

/// The models in five sentences.
const MODEL: &str = "A continuum robot is an elastic backbone with disks; a cable beside it is drawn in \
    and bends it. The cable slides through the disks, and the robot takes the shape of least bending \
    energy that keeps the cable's length and enters no obstacle; arrows are the forces that hold it \
    there. In the paper's model the cable cannot slide: every segment is a four-bar linkage whose links \
    all keep their lengths, and forces are multipliers λ, how fast the energy rises when an obstacle \
    comes nearer. The shape is followed from the straight robot along pull or load, as a real robot \
    would get there, and every shape in full colour has passed a check of its own.";

/// What can be done with a pointer: where, with a mouse, with fingers.
const GESTURES: &[(&str, &str)] = &[
    ("Move an obstacle", "drag it"),
    ("Move the view", "drag, or two fingers"),
    ("Zoom", "wheel, or pinch"),
    ("Select", "click or tap"),
    ("Pull the cable", "drag the tip, or the slider below"),
    (
        "Push the tip",
        "drag the arrow out of it, with the robot selected",
    ),
    ("Turn gravity", "drag its arrow, or its ends on the dial"),
    ("Change a number", "drag it, or click and type"),
    ("Open or import", "drop a file on the window"),
    ("Open a link", "paste it"),
];

fn gestures(ui: &mut Ui) {
    caption(ui, "Mouse and touch");
    let muted = Tokens::in_ui(ui).muted;
    Grid::new("gestures")
        .num_columns(2)
        .spacing(vec2(16.0, 6.0))
        .show(ui, |ui| {
            for (what, how) in GESTURES {
                ui.label(*what);
                ui.label(RichText::new(*how).color(muted));
                ui.end_row();
            }
        });
}

fn colours(ui: &mut Ui) {
    caption(ui, "What the colours mean");
    let theme = theme_of(ui);
    let style = |role| theme.style(role, &Standing::Certified);
    let ink = |role| style(role).stroke.map_or(Color32::GRAY, colour);
    let tokens = Tokens::in_ui(ui);
    let rows: [(Swatch, &str); 11] = [
        (
            Swatch::Line(ink(Role::Backbone), 3.0),
            "The backbone of the robot",
        ),
        (
            Swatch::Line(tokens.accent, 2.0),
            "The cable, and whatever can be touched",
        ),
        (
            Swatch::Scale,
            "Contacts: the stronger the colour, the harder",
        ),
        (
            Swatch::Ring(tokens.warning, 2.0),
            "A part that presses, with an arrow of its force; a thin ring only touches",
        ),
        (
            Swatch::Cone(tokens.warning),
            "Where it rubs: all that friction can hold; darker where the robot slides",
        ),
        (
            Swatch::Line(tokens.accent.gamma_multiply(0.45), 1.5),
            "Where the tip has been",
        ),
        (
            Swatch::Dot(theme_contact(ui)),
            "On the slider: a contact begins; a hollow dot: it ends. Hover for what happens",
        ),
        (
            Swatch::Line(tokens.other, 1.5),
            "The other model, and pinned robots beside it",
        ),
        (
            Swatch::Line(tokens.muted.gamma_multiply(0.5), 3.0),
            "A shape that is not certified, with its reason",
        ),
        (Swatch::Dot(tokens.warning), "Mind this"),
        (Swatch::Dot(tokens.error), "This has not worked"),
    ];
    for (swatch, meaning) in rows {
        ui.horizontal_top(|ui| {
            swatch.show(ui);
            ui.add(Label::new(meaning).wrap());
        });
    }
}

/// The colour of a contact that presses well.
fn theme_contact(ui: &Ui) -> Color32 {
    colour(theme_of(ui).contact(0.7))
}

/// A sample of a colour.
enum Swatch {
    Line(Color32, f32),
    Dot(Color32),
    Ring(Color32, f32),
    Cone(Color32),
    /// The contact scale.
    Scale,
}

impl Swatch {
    fn show(&self, ui: &mut Ui) {
        let (rect, _) = ui.allocate_exact_size(vec2(36.0, 20.0), Sense::hover());
        let painter = ui.painter();
        match self {
            Swatch::Line(colour, width) => {
                painter.hline(
                    rect.x_range(),
                    rect.center().y,
                    Stroke::new(*width, *colour),
                );
            }
            Swatch::Dot(colour) => {
                painter.circle_filled(rect.center(), 5.0, *colour);
            }
            Swatch::Ring(colour, width) => {
                let stroke = Stroke::new(*width, *colour);
                painter.circle_stroke(rect.center(), 6.0, stroke);
                painter.circle_filled(rect.center(), 2.5, *colour);
            }
            Swatch::Cone(colour) => {
                let corners = [vec2(-12.0, 0.0), vec2(12.0, -6.0), vec2(12.0, 6.0)];
                let corners = corners.map(|corner| rect.center() + corner);
                let fill = colour.gamma_multiply(0.25);
                let cone = Shape::convex_polygon(corners.to_vec(), fill, Stroke::new(1.0, *colour));
                painter.add(cone);
            }
            Swatch::Scale => {
                let bar = Rect::from_center_size(rect.center(), vec2(rect.width(), 10.0));
                painter.add(contact_scale(bar, theme_of(ui)));
            }
        }
    }
}

/// Width of the commands' titles, in points.
const TITLES: f32 = 208.0;

fn keys(ui: &mut Ui) {
    for group in Group::ALL {
        let entries = ALL.iter().filter(|entry| entry.group == group);
        let entries: Vec<_> = entries.filter(|entry| entry.shortcut.is_some()).collect();
        if entries.is_empty() {
            continue;
        }
        caption(ui, group.title());
        Grid::new(group.title())
            .num_columns(2)
            .spacing(vec2(16.0, 4.0))
            .show(ui, |ui| {
                for entry in entries {
                    ui.horizontal(|ui| {
                        // The keys of all groups below each other.
                        ui.set_min_width(TITLES);
                        ui.label(entry.title);
                    });
                    if let Some(keys) = &entry.shortcut {
                        let keys = ui.ctx().format_shortcut(keys);
                        key(ui, &keys);
                    }
                    ui.end_row();
                }
            });
        ui.add_space(14.0);
    }
}

/// A shortcut as a key's cap.
fn key(ui: &mut Ui, text: &str) {
    let tokens = Tokens::in_ui(ui);
    Frame::new()
        .fill(tokens.sunken)
        .stroke(Stroke::new(1.0, tokens.line))
        .corner_radius(4)
        .inner_margin(Margin::symmetric(6, 1))
        .show(ui, |ui| {
            ui.label(RichText::new(text).font(semibold(12.0)).color(tokens.muted));
        });
}
