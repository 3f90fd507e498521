//! The mark on forces in grams that the paper's model understates, with the way to
//! true ones.

use crate::app::commands::Command;
use crate::app::look::{Tokens, icon, icons};
use crate::app::workbench::Workbench;
use crate::mechanics::Model;
use eframe::egui::{Align, Button, Layout, Pos2, Rect, RichText, Ui, UiBuilder, Vec2, vec2};

/// What the mark says.
const MARK: &str = "Forces understated";

/// Room for the mark over a view, in points.
const ROOM: Vec2 = vec2(220.0, 24.0);

/// Shows the mark over a view of the robot, with its lower right corner here, while
/// something presses with a force that is understated.
pub fn understated_over(ui: &mut Ui, bench: &mut Workbench, corner: Pos2) {
    let greyed = bench.live.drawing().standing.is_greyed();
    let solution = bench.live.solution();
    let presses = solution.is_some_and(|solution| solution.pressing().next().is_some());
    if greyed || !presses || !is_understated(bench) {
        return;
    }
    let room = Rect::from_min_max(corner - ROOM, corner);
    let layout = Layout::right_to_left(Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(room).layout(layout), |ui| {
        understated(ui, bench);
    });
}

/// Whether forces are shown in grams that are the paper's.
fn is_understated(bench: &Workbench) -> bool {
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
