//! The fields of the inspector: a name, a value that can be typed or dragged,
//! and under it whatever was wrong with what was typed.

use super::row;
use super::typed::Kind;
use crate::app::look::{Tokens, icon, icons};
use crate::app::words;
use crate::app::workbench::Complaint;
use crate::math::unsigned_zero;
use crate::scene::SceneError;
use crate::scene::limits::{Limits, shown};
use crate::view::Quantity;
use eframe::egui::{
    self, Align, Align2, Color32, DragValue, Id, Layout, Response, RichText, Stroke, TextEdit, Ui,
    UiBuilder, Vec2, vec2,
};
use std::cell::RefCell;

/// Room for units beside fields, in points.
const UNIT: f32 = 20.0;
/// Width of number fields, in points.
const NUMBER: f32 = 80.0;

/// A number of the scene, as a field.
pub struct Number<'a> {
    /// The field's path in scene files, such as `obstacle[0].radius_mm`.
    pub path: String,
    /// What it is part of: a number may have a field in more than one place.
    pub place: &'a str,
    /// What it is called, such as `Radius`.
    pub name: &'a str,
    /// The paper's symbol for it; empty where it has none.
    pub symbol: &'a str,
    /// What it means, without a stop: told on hover. Empty where the name says it.
    pub meaning: &'a str,
    /// What is to be typed.
    pub kind: Kind,
    /// The values that are allowed.
    pub limits: Limits,
    /// Counts are multiples of this.
    pub step: u32,
    /// Whether it may be missing, which a value below its limits stands for.
    pub optional: bool,
}

impl<'a> Number<'a> {
    /// A length, in mm.
    pub fn length(path: impl Into<String>, name: &'a str, limits: Limits) -> Self {
        Self {
            path: path.into(),
            place: "inspector",
            name,
            symbol: "",
            meaning: "",
            kind: Kind::Length,
            limits,
            step: 1,
            optional: false,
        }
    }

    /// An angle, in degrees.
    pub fn angle(path: impl Into<String>, name: &'a str, limits: Limits) -> Self {
        Self {
            kind: Kind::Angle,
            ..Self::length(path, name, limits)
        }
    }

    fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Length => "mm",
            Kind::Angle => "°",
            Kind::Count => "",
            Kind::Plain => self.limits.unit.symbol(),
        }
    }

    fn decimals(&self) -> usize {
        match self.kind {
            Kind::Length => 2,
            Kind::Angle => 1,
            Kind::Count | Kind::Plain => 0,
        }
    }

    /// The value as the field shows it.
    fn shown(&self, value: f64) -> String {
        let quantity = match self.kind {
            Kind::Plain if self.is_missing(value) => return "none".to_owned(),
            Kind::Plain => Quantity::significant(value, ""),
            _ => Quantity::fixed(value, self.decimals(), ""),
        };
        quantity.digits
    }

    /// Whether a value stands for none.
    fn is_missing(&self, value: f64) -> bool {
        self.optional && value < self.limits.min
    }

    fn range(&self) -> String {
        match self.unit() {
            "" => self.limits.to_string(),
            "°" => format!("{}°", self.limits),
            unit => format!("{} {unit}", self.limits),
        }
    }

    /// What a text typed for the field means, or what is wrong with it.
    fn read(&self, text: &str) -> Result<f64, String> {
        if self.optional && matches!(text.trim(), "" | "none") {
            return Ok(0.0);
        }
        let value = self.kind.parse(text).map_err(|typo| typo.to_string())?;
        if !self.limits.contain(value) {
            return Err(format!(
                "{} is out of range; type a value {}.",
                text.trim(),
                self.range()
            ));
        }
        let step = f64::from(self.step.max(1));
        if self.kind == Kind::Count && value % step != 0.0 {
            let (fewer, more) = ((value / step).floor() * step, (value / step).ceil() * step);
            let fewer = if fewer > 0.0 {
                shown(fewer) + " or "
            } else {
                String::new()
            };
            return Err(format!(
                "With {step} to a bay, type {fewer}{}; or change the bays first.",
                shown(more)
            ));
        }
        Ok(value)
    }
}

/// The fields of one thing, and what there is to say under them.
pub struct Form<'a> {
    complaint: &'a mut Option<Complaint>,
    faults: &'a [SceneError],
    /// Faults that are not told yet.
    untold: Vec<bool>,
}

impl<'a> Form<'a> {
    /// A form with what was wrong last: with what was typed, and with an edit
    /// that was taken back.
    pub fn new(complaint: &'a mut Option<Complaint>, faults: &'a [SceneError]) -> Self {
        Self {
            complaint,
            faults,
            untold: vec![true; faults.len()],
        }
    }

    /// A field for a number. Whether it was changed.
    pub fn number(&mut self, ui: &mut Ui, number: &Number<'_>, value: &mut f64) -> bool {
        self.number_with(ui, number, value, |_| {})
    }

    /// Like [`Form::number`], with something before the field.
    pub fn number_with(
        &mut self,
        ui: &mut Ui,
        number: &Number<'_>,
        value: &mut f64,
        extra: impl FnOnce(&mut Ui),
    ) -> bool {
        let mut changed = false;
        stable(ui, &number.path, |ui| {
            ui.horizontal(|ui| {
                let mut label = name(ui, number.name, number.symbol);
                if !number.meaning.is_empty() {
                    label = label.on_hover_text(format!("{}.", number.meaning));
                }
                beside(ui, |ui| {
                    ui.spacing_mut().item_spacing.x = 4.0;
                    // Where the unit is long, at the field's expense.
                    let sign = number.unit();
                    let room = if sign.len() > 2 { 2.0 * UNIT } else { UNIT };
                    let (_, rect) = ui.allocate_space(vec2(room, row::height(ui)));
                    unit(ui, rect, sign);
                    let size = vec2(NUMBER + UNIT - room, row::height(ui));
                    changed =
                        self.value(ui, number, value, size, |field| field.labelled_by(label.id));
                    extra(ui);
                });
            });
            self.notes(ui, &number.path);
        });
        changed
    }

    /// The field of a number by itself. Whether it was changed.
    pub fn value(
        &mut self,
        ui: &mut Ui,
        number: &Number<'_>,
        value: &mut f64,
        size: Vec2,
        named: impl FnOnce(Response) -> Response,
    ) -> bool {
        let before = *value;
        let read: RefCell<Option<Result<(), String>>> = RefCell::new(None);
        let builder = UiBuilder::new()
            .scope_id(Id::unique((&number.path, number.place, "value")))
            .layout(Layout::top_down_justified(Align::Max));
        let (_, rect) = ui.allocate_space(size);
        let complained = self.complains_of(&number.path);
        let inner = ui.scope_builder(builder.max_rect(rect), |ui| {
            ui.spacing_mut().interact_size.y = size.y;
            if complained {
                let stroke = Stroke::new(1.0, Tokens::in_ui(ui).error);
                let widgets = &mut ui.visuals_mut().widgets;
                widgets.inactive.bg_stroke = stroke;
                widgets.hovered.bg_stroke = stroke;
            }
            let id = ui.next_auto_id();
            let editing = ui.memory(|memory| memory.has_focus(id));
            // All digits while they can be edited, or a glance at a field
            // would round its number.
            let text = move |value: f64| match editing && !number.is_missing(value) {
                true => shown(unsigned_zero(value)).replace('-', "−"),
                false => number.shown(value),
            };
            let untouched = text(before);
            let mut new = before;
            let step = f64::from(number.step.max(1));
            let speed = match number.kind {
                Kind::Length => 0.1,
                Kind::Angle => 0.5,
                Kind::Count if ui.ctx().is_being_dragged(id) => 0.1 * step,
                Kind::Count => step,
                // From nothing, too.
                Kind::Plain => (0.005 * before.abs()).max(1e-3),
            };
            let least = match number.optional {
                true => 0.0,
                false => number.limits.min,
            };
            let field = DragValue::new(&mut new)
                .speed(speed)
                .range(least..=number.limits.max)
                .clamp_existing_to_range(false)
                .min_size(size)
                .clip_text(true)
                .update_while_editing(false)
                .custom_formatter(move |value, _| text(value))
                .custom_parser(|text| {
                    let result = match text == untouched {
                        true => Ok(before),
                        false => number.read(text),
                    };
                    *read.borrow_mut() = Some(result.as_ref().map(|_| ()).map_err(String::clone));
                    result.ok()
                });
            let field = match number.kind {
                Kind::Plain => field,
                _ => field.fixed_decimals(number.decimals()),
            };
            let response = ui.add(field);
            if number.kind == Kind::Count {
                new = ((new / step).round() * step).max(step);
            }
            (response, new)
        });
        let (response, new) = inner.inner;
        let refocused = response.gained_focus();
        let meaning = match number.meaning {
            "" => String::new(),
            meaning => format!("{meaning}.\n"),
        };
        let tip = format!(
            "{meaning}{} {}\nClick to type, drag to change",
            number.name,
            number.range()
        );
        named(response.on_hover_text(tip));
        match read.into_inner() {
            Some(Err(text)) => {
                let path = number.path.clone();
                *self.complaint = Some(Complaint { path, text });
            }
            Some(Ok(())) if complained => *self.complaint = None,
            None if complained && (refocused || new != before) => *self.complaint = None,
            _ => {}
        }
        *value = new;
        new != before
    }

    /// A field for a number that may be missing: an empty field is none.
    pub fn optional(&mut self, ui: &mut Ui, number: &Number<'_>, value: &mut Option<f64>) {
        let mut real = value.unwrap_or(0.0);
        if self.number(ui, number, &mut real) {
            *value = (!number.is_missing(real)).then_some(real);
        }
    }

    /// A field for a whole number. Whether it was changed.
    pub fn count(&mut self, ui: &mut Ui, number: &Number<'_>, value: &mut u32) -> bool {
        let mut real = f64::from(*value);
        let changed = self.number(ui, number, &mut real);
        if changed {
            // In range, as the field's limits are those of counts.
            *value = real as u32;
        }
        changed
    }

    /// A field for a text; an empty one is none.
    pub fn text(&mut self, ui: &mut Ui, path: &str, called: &str, value: &mut Option<String>) {
        stable(ui, path, |ui| {
            ui.horizontal(|ui| {
                let label = name(ui, called, "");
                beside(ui, |ui| {
                    let mut text = value.clone().unwrap_or_default();
                    let size = vec2(ui.available_width(), row::height(ui));
                    let field = TextEdit::singleline(&mut text)
                        .id(Id::unique((path, "text")))
                        .align(Align2::LEFT_CENTER)
                        .min_size(size)
                        .desired_width(size.x)
                        .hint_text(RichText::new("none").weak());
                    if ui.add(field).labelled_by(label.id).changed() {
                        *value = (!text.is_empty()).then_some(text);
                    }
                });
            });
            self.notes(ui, path);
        });
    }

    /// A field for a choice. Whether it was changed.
    pub fn choice<T: Copy + PartialEq>(
        &mut self,
        ui: &mut Ui,
        path: &str,
        (called, tip): (&str, &str),
        value: &mut T,
        choices: &[(T, String)],
    ) -> bool {
        let before = *value;
        stable(ui, path, |ui| {
            ui.horizontal(|ui| {
                let label = name(ui, called, "");
                beside(ui, |ui| {
                    ui.spacing_mut().item_spacing.x = 4.0;
                    ui.allocate_space(vec2(UNIT, row::height(ui)));
                    let current = choices.iter().find(|(choice, _)| *choice == *value);
                    let current = current.map_or("", |(_, word)| word.as_str());
                    let combo = egui::ComboBox::from_id_salt("choice")
                        .width(NUMBER)
                        .selected_text(current);
                    let shown = combo.show_ui(ui, |ui| {
                        for (choice, word) in choices {
                            ui.selectable_value(value, *choice, word);
                        }
                    });
                    shown.response.on_hover_text(tip).labelled_by(label.id);
                });
            });
            self.notes(ui, path);
        });
        *value != before
    }

    /// Something read only beside its name.
    pub fn fixed(&mut self, ui: &mut Ui, called: &str, text: &str) {
        ui.horizontal(|ui| {
            name(ui, called, "");
            beside(ui, |ui| {
                ui.weak(text);
            });
        });
    }

    /// What is wrong with a field, on lines of its own: what was typed, and
    /// the faults of it and of what is inside it.
    pub fn notes(&mut self, ui: &mut Ui, path: &str) {
        if self.complains_of(path)
            && let Some(complaint) = &self.complaint
        {
            note(ui, &complaint.text);
        }
        for (fault, untold) in self.faults.iter().zip(&mut self.untold) {
            let inside = fault.field().is_some_and(|field| {
                field
                    .strip_prefix(path)
                    .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[', ' ']))
            });
            if *untold && inside {
                *untold = false;
                note(ui, &format!("Taken back. {}", words::refusal(fault)));
            }
        }
    }

    fn complains_of(&self, path: &str) -> bool {
        let complaint = self.complaint.as_ref();
        complaint.is_some_and(|complaint| complaint.path == path)
    }
}

/// A part of the form whose ids do not depend on what is above it.
fn stable(ui: &mut Ui, path: &str, add: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().scope_id(Id::unique((path, "row"))), add);
}

/// The name before a field, with the paper's symbol.
fn name(ui: &mut Ui, name: &str, symbol: &str) -> Response {
    ui.set_min_height(row::height(ui));
    let muted = Tokens::in_ui(ui).muted;
    let label = ui.label(RichText::new(name).color(muted));
    if !symbol.is_empty() {
        ui.label(RichText::new(symbol).color(muted));
    }
    label
}

/// What is beside a name, from the right.
fn beside(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ui.with_layout(Layout::right_to_left(Align::Center), add);
}

fn unit(ui: &mut Ui, rect: egui::Rect, sign: &str) {
    let font = egui::FontId::proportional(12.0);
    let muted = Tokens::in_ui(ui).muted;
    let at = rect.left_center();
    ui.painter()
        .text(at, egui::Align2::LEFT_CENTER, sign, font, muted);
}

/// A sentence on what is wrong.
fn note(ui: &mut Ui, text: &str) {
    let error: Color32 = Tokens::in_ui(ui).error;
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.label(icon(icons::WARNING_CIRCLE).size(14.0).color(error));
        let text = RichText::new(text).small().color(error);
        ui.add(egui::Label::new(text).wrap());
    });
    ui.add_space(4.0);
}
