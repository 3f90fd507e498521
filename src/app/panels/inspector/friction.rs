//! Where a robot rubs, and how much: its cables in their holes and below the base, its
//! body on what it touches.

use crate::app::widgets::{Form, Kind, Number};
use crate::scene::Scene;
use crate::scene::limits::{BASE_LOSS, FRICTION, Limits};
use eframe::egui::Ui;

fn share<'a>(key: &str, name: &'a str, limits: Limits) -> Number<'a> {
    Number {
        kind: Kind::Plain,
        ..Number::length(format!("friction.{key}"), name, limits)
    }
}

/// Shows the fields.
pub(super) fn show(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let friction = &mut scene.friction;
    let number = Number {
        symbol: "μ",
        meaning: "Friction of a cable in every hole: where it slips, the tension changes by the \
                  factor e to the μ times its turn there. 0 for none; steel in plastic 0.1 to 0.3",
        ..share("holes", "In holes", FRICTION)
    };
    form.number(ui, &number, &mut friction.holes);
    let number = Number {
        symbol: "μw",
        meaning: "Friction of the robot on obstacles: along the surface, at most μw times the \
                  force against it. The cone on the canvas is that wide",
        ..share("contacts", "At contacts", FRICTION)
    };
    form.number(ui, &number, &mut friction.contacts);
    let number = Number {
        symbol: "1−η",
        meaning: "The share of a load that is lost below the base, in pulleys or a sheath: 0.165 \
                  leaves 83.5 % of the load for the robot",
        ..share("base_loss", "Lost at base", BASE_LOSS)
    };
    form.number(ui, &number, &mut friction.base_loss);
    form.notes(ui, "friction");
}
