//! What the curves of the force's plot are computed from, in its upper corner: a stroke
//! and a name each, how much each obstacle takes, and the readings' dots.

use super::cache::PlotCache;
use super::data::PlotData;
use super::pane::{Surface, Text, hue};
use crate::app::look::{Tokens, theme_of};
use crate::app::words;
use crate::app::workbench::Assumed;
use crate::units::grams;
use crate::view::{Quantity, Theme};
use eframe::egui::{Align2, Color32, Pos2, Rangef, Stroke, Ui, pos2, vec2};

/// Room for a stroke before its name, in points.
const STROKE: f32 = 20.0;
/// Height of a line, in points.
const LINE: f32 = 16.0;

/// The colour of a model's curve: each its own in every scene.
pub(super) fn ink(assumed: Assumed, theme: Theme) -> Color32 {
    match assumed {
        Assumed::Equal => Tokens::of(theme).other,
        Assumed::Sliding => hue(theme, 2),
        Assumed::Rubbing => hue(theme, 0),
    }
}

/// What a model's curve is called beside that of the scene's own.
pub(super) fn word(assumed: Assumed, own: Assumed) -> &'static str {
    match (assumed, own) {
        (Assumed::Equal, _) => "multipliers",
        (Assumed::Sliding, Assumed::Rubbing) => "sliding, no friction",
        (Assumed::Sliding, _) => "sliding",
        (Assumed::Rubbing, _) => "sliding, with friction",
    }
}

/// Paints it from a corner on, downwards.
pub(super) fn paint(
    ui: &Ui,
    surface: &Surface<'_>,
    data: &PlotData<'_>,
    cache: &PlotCache,
    corner: Pos2,
) {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let forces = &cache.forces;
    let own = Assumed::of(data.problem());
    let mut y = corner.y + 2.0;
    let mut line = |stroke: Option<Stroke>, text: Text| {
        let at = pos2(corner.x + STROKE, y);
        let area = surface.name(at, Align2::LEFT_TOP, text);
        let middle = area.center().y;
        match stroke {
            Some(stroke) => {
                let across = Rangef::new(corner.x, corner.x + STROKE - 6.0);
                surface.painter.hline(across, middle, stroke);
            }
            None => {
                let dot = pos2(corner.x + 0.5 * (STROKE - 6.0), middle);
                surface.painter.circle_filled(dot, 3.5, tokens.text);
            }
        }
        y += LINE;
    };
    if forces.curve.is_some() {
        let ink = ink(own, theme);
        line(Some(Stroke::new(2.0, ink)), Text::of(word(own, own), ink));
    }
    for (assumed, _) in &forces.others {
        let ink = ink(*assumed, theme);
        let text = Text::of(word(*assumed, own), ink);
        line(Some(Stroke::new(1.25, ink)), text);
    }
    if let Some(Ok(work)) = &forces.work {
        let ink = hue(theme, 1);
        let friction = Quantity::fixed(work.friction(), 3, "").digits;
        let text = Text::of("virtual work", ink).and(&format!("  μ = {friction}"), tokens.muted);
        line(Some(Stroke::new(2.0, ink)), text);
    }
    if !data.readings().is_empty() {
        line(None, Text::of("measured", tokens.text));
    }
    // Which obstacle takes how much now, where there are several.
    if let Some(curve) = &forces.curve
        && curve.obstacles.len() > 1
        && let Some(stiffness) = data.stiffness()
    {
        let per_bend = stiffness.per_bend(data.problem());
        let mut text = Text::default();
        for index in &curve.obstacles {
            let contacts = data.solved.contacts.iter();
            let on = contacts.filter(|contact| contact.obstacle == *index);
            let force = per_bend * on.map(|contact| contact.multiplier).sum::<f64>();
            let name = words::obstacle_of(data.scene, *index);
            let shown = Quantity::significant(grams(force), "g");
            text = text.value(&name, &shown, &tokens);
        }
        // As many as there is room for.
        let room = surface.frame().width() - 16.0;
        let galley = text.within(surface.painter, room);
        let at = pos2(corner.x, y + 2.0);
        surface.clear(eframe::egui::Rect::from_min_size(at, galley.size()).expand2(vec2(2.0, 0.0)));
        surface.painter.galley(at, galley, tokens.text);
    }
}
