//! What all plots have in common: a header with names, a read-out and a menu,
//! quiet axes with round numbers, and the way from values to the screen.

use super::data::Plot;
use crate::app::look::{Tokens, colour, icon_button, icons};
use crate::math::unsigned_zero;
use crate::view::{Quantity, Theme};
use eframe::egui::text::{ByteIndex, LayoutJob};
use eframe::egui::{
    Align, Align2, Color32, FontFamily, FontId, Galley, Layout, Painter, Popup, Pos2, Rangef, Rect,
    Response, RichText, Shape, Stroke, TextFormat, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use egui_plot::{AxisHints, GridInput, GridMark, Line, PlotPoint, PlotTransform};
use std::sync::Arc;

/// The size of all text on plots.
pub(super) const SMALL: f32 = 12.0;
/// Height of a header.
const HEADER: f32 = 24.0;
/// Height of the lowest plot that is drawn at all.
const LOWEST: f32 = 56.0;
/// Characters from which on a number is wider than the margin beside a plot.
const LONG: usize = 4;

/// A quantity on an axis: its name and its unit.
#[derive(Clone, Debug)]
pub(super) struct Quantities<'a> {
    pub name: &'a str,
    pub unit: &'a str,
}

/// The hue of a series, of Okabe and Ito's, as bright as the theme asks for:
/// blue, vermilion, green.
pub(super) fn hue(theme: Theme, series: usize) -> Color32 {
    let hues: [u32; 3] = match theme {
        Theme::Light => [0x0072b2, 0xc85200, 0x007f5f],
        Theme::Dark => [0x56b4e9, 0xff8a3c, 0x2fd0a2],
    };
    let [_, r, g, b] = hues[series % hues.len()].to_be_bytes();
    Color32::from_rgb(r, g, b)
}

/// The colour of a contact of this share of the greatest multiplier.
pub(super) fn heat(theme: Theme, share: f64) -> Color32 {
    colour(theme.contact(share))
}

/// Text in pieces of their own colours, at the plots' size.
#[derive(Clone, Default)]
pub(super) struct Text {
    job: LayoutJob,
    /// Where values end: the sections and bytes up to there.
    ends: Vec<(usize, usize)>,
}

impl Text {
    pub fn of(text: &str, ink: Color32) -> Self {
        Self::default().and(text, ink)
    }

    pub fn and(mut self, text: &str, ink: Color32) -> Self {
        let format = TextFormat::simple(FontId::new(SMALL, FontFamily::Proportional), ink);
        self.job.append(text, 0.0, format);
        self
    }

    /// An index, smaller and lower.
    pub fn index(mut self, text: &str, ink: Color32) -> Self {
        let mut format = TextFormat::simple(FontId::new(9.0, FontFamily::Proportional), ink);
        format.valign = Align::BOTTOM;
        self.job.append(text, 0.0, format);
        self
    }

    /// A name in a muted voice, then a number, then its unit, muted.
    pub fn value(self, name: &str, value: &Quantity, tokens: &Tokens) -> Self {
        let apart = if self.job.is_empty() { "" } else { "  " };
        let unit = match value.unit {
            "" | "°" => value.unit.to_owned(),
            unit => format!(" {unit}"),
        };
        self.and(&format!("{apart}{name} "), tokens.muted)
            .and(&value.digits, tokens.text)
            .and(&unit, tokens.muted)
            .ended()
    }

    /// Notes that a value ends here.
    pub fn ended(mut self) -> Self {
        self.ends
            .push((self.job.sections.len(), self.job.text.len()));
        self
    }

    /// As many of the values as a width has room for: a number that is cut is
    /// another number.
    pub fn within(mut self, painter: &Painter, width: f32) -> Arc<Galley> {
        self.job.wrap.max_rows = 1;
        loop {
            let galley = painter.layout_job(self.job.clone());
            if galley.size().x <= width || self.job.is_empty() {
                return galley;
            }
            self.ends.pop();
            let (sections, bytes) = self.ends.last().copied().unwrap_or_default();
            self.job.sections.truncate(sections);
            self.job.text.truncate(bytes);
            // What follows in the same voice is one section with the last.
            if let Some(last) = self.job.sections.last_mut() {
                last.byte_range.end = last.byte_range.end.min(ByteIndex(bytes));
            }
        }
    }

    pub fn job(mut self) -> LayoutJob {
        self.job.wrap.max_rows = 1;
        self.job
    }
}

/// What a plot asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// Its numbers as a file.
    Csv,
    /// Its picture as a file.
    Svg,
    /// The backbone's stiffness is to be given.
    Stiffness,
    /// A force reading is to be given.
    Reading,
    /// The sliding cable.
    Slide,
}

/// The header of a plot: what its ordinate is on the left, what the cursor
/// reads on the right, and the menu of what can be saved.
pub(super) fn header(
    ui: &mut Ui,
    plot: Plot,
    ordinate: Text,
    reading: Text,
    more: impl FnOnce(&mut Ui),
) -> Option<Asked> {
    let mut asked = None;
    let size = vec2(ui.available_width(), HEADER);
    let layout = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.spacing_mut().interact_size = Vec2::splat(HEADER);
        let name = format!("Save the plot of {}", plot.title().to_lowercase());
        let menu = icon_button(ui, icons::DOTS_THREE, &name);
        Popup::menu(&menu).show(|ui| {
            if ui.button("Export CSV").clicked() {
                asked = Some(Asked::Csv);
            }
            if ui.button("Export SVG").clicked() {
                asked = Some(Asked::Svg);
            }
            more(ui);
        });
        // The read-out gives way where there is no room for both.
        let ordinate = ui.painter().layout_job(ordinate.job());
        let rect = ui.available_rect_before_wrap();
        let room = rect.width() - ordinate.size().x - 16.0;
        let reading = reading.within(ui.painter(), room);
        let y = |height: f32| rect.center().y - 0.5 * height;
        let ink = ui.visuals().text_color();
        let at = pos2(rect.right() - 4.0 - reading.size().x, y(reading.size().y));
        ui.painter().galley(at, reading, ink);
        let at = pos2(rect.left() + 4.0, y(ordinate.size().y));
        ui.painter().galley(at, ordinate, ink);
    });
    asked
}

/// The name of an ordinate, its unit muted.
pub(super) fn ordinate(of: &Quantities<'_>, tokens: &Tokens) -> Text {
    let text = Text::of(of.name, tokens.text);
    match of.unit {
        "" => text,
        unit => text.and(&format!("  {unit}"), tokens.muted),
    }
}

/// What a plot that has nothing to draw says, in the middle of its room.
pub(super) fn empty(ui: &mut Ui, sentence: &str, ways_out: impl FnOnce(&mut Ui)) {
    let room = ui.available_size();
    ui.allocate_ui_with_layout(room, Layout::top_down(Align::Center), |ui| {
        ui.add_space((0.5 * room.y - 36.0).max(8.0));
        ui.set_max_width(room.x.min(300.0).max(0.9 * room.x.min(300.0)));
        ui.label(RichText::new(sentence).size(SMALL).weak());
        ui.add_space(8.0);
        ways_out(ui);
    });
}

/// A plot of a height, without a legend, a crosshair or a frame: the primary
/// button is left to cursors; the secondary one zooms, and so do pinching and
/// the wheel with the command key.
pub(super) fn canvas<'a>(
    id: &'a str,
    height: f32,
    abscissa: &Quantities<'_>,
    tokens: &Tokens,
    whole: Whole,
) -> egui_plot::Plot<'a> {
    let font = FontId::new(SMALL, FontFamily::Proportional);
    let hints = |hints: AxisHints<'a>| {
        hints
            .tick_label_color(tokens.muted)
            .tick_label_font(font.clone())
            .label_spacing(Rangef::new(1.0, 2.0))
    };
    let mut x = hints(AxisHints::new_x()).formatter(|mark, range| {
        let text = tick(mark);
        // A long number at the very end would be cut off by the panel's edge.
        let share = (mark.value - range.start()) / (range.end() - range.start());
        match text.chars().count() >= LONG && share > 0.97 {
            true => String::new(),
            false => text,
        }
    });
    let y = hints(AxisHints::new_y()).formatter(|mark, _| tick(mark));
    if !abscissa.name.is_empty() {
        x = x.label(ordinate(abscissa, tokens).job());
    }
    egui_plot::Plot::new(id)
        .height(height.max(LOWEST))
        .custom_x_axes(vec![x])
        .custom_y_axes(vec![y.min_thickness(44.0)])
        .x_grid_spacer(move |input| round_marks(&input, 1.7, whole))
        .y_grid_spacer(|input| round_marks(&input, 1.0, Whole::No))
        .grid_spacing(Rangef::new(34.0, 68.0))
        .grid_fade(0.0)
        .grid_color(tokens.line)
        .show_grid([false, true])
        .show_background(false)
        .show_crosshair(false)
        .show_x(false)
        .show_y(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(true)
}

/// A curve of a series through points that are kept.
pub(super) fn curve<'a>(name: &str, points: &'a [PlotPoint], ink: Color32) -> Line<'a> {
    let line = Line::new(name, points).stroke(Stroke::new(2.0, ink));
    // Points of one column of pixels are not to be drawn as a band.
    line.allow_hover(false).allow_band(false)
}

/// Whether an axis counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Whole {
    Yes,
    No,
}

/// A step is finer than another where it is so by more than this share: powers
/// of ten are rounded, to 1e-16 each.
const SAME_STEP: f64 = 1e-9;

/// An axis has so many marks, if need be with less room for each …
const FEWEST: usize = 3;
/// … but no less than this, over what is usual.
const TIGHT: f64 = 0.5;

/// Marks at round numbers, the finest of 1, 2 and 5 times a power of ten that
/// leaves each `room` times the least room, or the least that there are enough of.
fn round_marks(input: &GridInput, room: f64, whole: Whole) -> Vec<GridMark> {
    let least = room * input.base_step_size;
    if !(least > 0.0 && least.is_finite()) {
        return Vec::new();
    }
    let power = 10f64.powf(least.log10().floor());
    let steps = [0.2, 0.5, 1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let usual = steps
        .iter()
        .position(|step| *step > least * (1.0 + SAME_STEP))
        .unwrap_or(steps.len() - 1);
    let count = |step: f64| {
        let (first, last) = (input.bounds.0 / step, input.bounds.1 / step);
        (last.floor() - first.ceil() + 1.0).max(0.0) as usize
    };
    let finer = steps[..=usual].iter().rev();
    let fine: Vec<f64> = finer
        .copied()
        .take_while(|step| *step >= TIGHT * least)
        .collect();
    let enough = fine.iter().find(|step| count(**step) >= FEWEST);
    let mut step = *enough.or(fine.last()).unwrap_or(&steps[usual]);
    if whole == Whole::Yes {
        step = step.max(1.0);
    }
    let (first, last) = (input.bounds.0 / step, input.bounds.1 / step);
    // A range far from zero has steps that rounding swallows.
    let readable = last - first < 1e3 && first.abs().max(last.abs()) < 1e12;
    if !readable {
        return Vec::new();
    }
    (first.ceil() as i64..=last.floor() as i64)
        .map(|k| GridMark {
            value: k as f64 * step,
            step_size: step,
        })
        .collect()
}

/// A round number as text, with a minus sign.
fn tick(mark: GridMark) -> String {
    let decimals = (-mark.step_size.log10().floor()).clamp(0.0, 9.0) as usize;
    Quantity::fixed(mark.value, decimals, "").digits
}

/// What is painted on after a plot has found its scale.
pub(super) struct Surface<'a> {
    pub painter: &'a Painter,
    pub transform: PlotTransform,
    /// The pointer, while it is on the plot.
    pub pointer: Option<Pos2>,
    /// What is behind the plot.
    paper: Color32,
}

impl<'a> Surface<'a> {
    pub fn of(
        painter: &'a Painter,
        response: &Response,
        transform: PlotTransform,
        tokens: &Tokens,
    ) -> Self {
        Self {
            paper: tokens.panel,
            painter,
            transform,
            pointer: response.hover_pos().or(response.interact_pointer_pos()),
        }
    }

    pub fn frame(&self) -> Rect {
        *self.transform.frame()
    }

    pub fn x(&self, value: f64) -> f32 {
        self.transform.position_from_point_x(value)
    }

    pub fn y(&self, value: f64) -> f32 {
        self.transform.position_from_point_y(value)
    }

    pub fn at(&self, x: f64, y: f64) -> Pos2 {
        pos2(self.x(x), self.y(y))
    }

    /// The abscissa under the pointer.
    pub fn value(&self) -> Option<f64> {
        let pointer = self.pointer?;
        Some(self.transform.value_from_position(pointer).x)
    }

    /// The line that ordinates are counted from, where it can be seen.
    pub fn zero(&self, tokens: &Tokens) {
        let y = self.y(0.0);
        if self.frame().y_range().contains(y) {
            let stroke = Stroke::new(1.0, tokens.muted.gamma_multiply(0.7));
            self.painter.hline(self.frame().x_range(), y, stroke);
        }
    }

    /// A dashed line: a model of what another curve shows.
    pub fn dashed(&self, ends: [Pos2; 2], ink: Color32) {
        let stroke = Stroke::new(1.25, ink);
        self.painter
            .extend(Shape::dashed_line(&ends, stroke, 5.0, 4.0));
    }

    /// A jump from one piece of a curve to the next.
    pub fn jump(&self, before: Option<&PlotPoint>, after: Option<&PlotPoint>, ink: Color32) {
        if let (Some(a), Some(b)) = (before, after) {
            let ends = [self.at(a.x, a.y), self.at(b.x, b.y)];
            let dots = Shape::dotted_line(&ends, ink.gamma_multiply(0.7), 4.0, 0.9);
            self.painter.extend(dots);
        }
    }

    /// The place of a curve now.
    pub fn dot(&self, at: Pos2, ink: Color32, tokens: &Tokens) {
        self.painter.circle_filled(at, 4.5, tokens.panel);
        self.painter.circle_filled(at, 3.25, ink);
    }

    /// Makes what is behind text step back.
    pub fn clear(&self, area: Rect) {
        let paper = self.paper.gamma_multiply(0.75);
        self.painter
            .rect_filled(area.expand2(vec2(2.0, 0.0)), 3.0, paper);
    }

    /// Text beside a point of a curve, inside the frame.
    pub fn name(&self, at: Pos2, anchor: Align2, text: Text) -> Rect {
        let galley = self.painter.layout_job(text.job());
        let frame = self.frame().shrink(2.0);
        let size = galley.size();
        let mut rect = anchor.anchor_size(at, size);
        let shift = vec2(
            (frame.right() - rect.right()).min(0.0) + (frame.left() - rect.left()).max(0.0),
            (frame.bottom() - rect.bottom()).min(0.0) + (frame.top() - rect.top()).max(0.0),
        );
        rect = rect.translate(shift);
        self.clear(rect);
        self.painter.galley(rect.min, galley, Color32::PLACEHOLDER);
        rect
    }
}

/// Gives a plot its name for those who do not see it.
pub(super) fn named(response: &Response, name: &str) {
    response.widget_info(|| WidgetInfo::labeled(eframe::egui::Role::Figure, true, name));
}

/// A number in a table, with all its digits.
pub(super) fn cell(value: f64) -> String {
    unsigned_zero(value).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_has_three_marks_where_there_is_room_for_them() {
        let marks = |bounds: (f64, f64), points: f64| {
            let base_step_size = 34.0 * (bounds.1 - bounds.0) / points;
            let input = GridInput {
                bounds,
                base_step_size,
            };
            let marks = round_marks(&input, 1.0, Whole::No);
            marks.iter().map(|mark| mark.value).collect::<Vec<_>>()
        };
        // The usual ones where they are enough.
        assert_eq!(marks((0.0, 10.0), 200.0), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
        // Nearer to each other on a plot that is low.
        for bounds in [(-12.0, 55.0), (-40.0, 3.0), (0.0, 1.9), (0.3, 0.9)] {
            let found = marks(bounds, 80.0);
            assert!(found.len() >= FEWEST, "{bounds:?} {found:?}");
        }
        // Not on one that has no room for their names.
        assert!(marks((0.0, 1.9), 20.0).len() < FEWEST);
    }
}
