//! The mark on forces in grams that the paper's model understates, with the way to
//! true ones.

use crate::app::commands::Command;
use crate::app::look::{Tokens, icon, icons};
use crate::app::workbench::Workbench;
use crate::mechanics::Model;
use eframe::egui::{Button, RichText, Ui};

/// What the mark says.
const MARK: &str = "Forces understated";

/// Whether forces are shown in grams that are the paper's.
pub fn is_understated(bench: &Workbench) -> bool {
    bench.model() == Model::Equal && bench.document.stiffness().is_some()
}

/// A quiet button that says so and lets the cable slide; nothing where forces are true.
pub fn understated(ui: &mut Ui, bench: &mut Workbench) {
    if !is_understated(bench) {
        return;
    }
    let tokens = Tokens::in_ui(ui);
    let text = RichText::new(MARK).small().color(tokens.muted);
    let button = Button::new((icon(icons::WARNING).size(14.0).color(tokens.warning), text))
        .frame_when_inactive(false);
    let possible = bench.allows(Command::Mechanics);
    let tip = "The paper’s model does not let the cable slide, so that contact forces come out \
               too small, near first contact 6 to 40 times.";
    let tip = match possible {
        true => format!(
            "{tip} {}",
            Command::Mechanics.tip_saying("Click to let the cable slide", ui.ctx())
        ),
        false => tip.to_owned(),
    };
    let response = ui
        .add_enabled(possible, button)
        .on_hover_text(&tip)
        .on_disabled_hover_text(&tip);
    if response.clicked() {
        bench.commands.push(Command::Mechanics);
    }
}
