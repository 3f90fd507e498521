//! The status chip: whether what is on the screen is to be believed, in a word
//! and three numbers. Click it for the certificate.

mod certificate;
mod plot;
mod verdict;

pub use certificate::show as certificate;
pub use verdict::Verdict;

use crate::app::look::{Tokens, icon_font, icons};
use crate::app::widgets::row;
use crate::app::words;
use crate::app::workbench::{Live, Workbench};
use crate::equilibrium::Solution;
use crate::view::Quantity;
use eframe::egui::{Align2, CornerRadius, FontId, Role, Sense, Ui, WidgetInfo, pos2, vec2};
use web_time::Duration;

/// Solves that take less than this many seconds are not told while they last:
/// a word that flickers tells nothing.
const PATIENCE: f64 = 0.25;
/// Widths of the chip's parts, in points; fixed, so that nothing moves while
/// the numbers do.
const WORD: f32 = 124.0;
const RESIDUAL: f32 = 56.0;
const ITERATIONS: f32 = 48.0;
const TIME: f32 = 60.0;
/// Bars that are narrower than this, in points, have no room for the numbers.
const ROOMY: f32 = 900.0;

/// What the chip and the certificate keep from frame to frame.
#[derive(Debug, Default)]
pub struct StatusChip {
    /// Whether the certificate is open.
    pub certificate: bool,
    /// What the chip told last, and when.
    told: Option<(Verdict, f64)>,
}

/// The chip's width, in points, in a bar of some width.
pub fn width(bar: f32) -> f32 {
    if bar < ROOMY {
        WORD
    } else {
        WORD + RESIDUAL + ITERATIONS + TIME
    }
}

/// Shows the chip at the right end of a bar of some width.
pub fn show(ui: &mut Ui, chip: &mut StatusChip, bench: &mut Workbench, bar: f32) {
    let verdict = steady(ui, chip, &bench.live);
    let size = vec2(width(bar), ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let tokens = Tokens::in_ui(ui);
    let painter = ui.painter();
    if response.is_pointer_button_down_on() {
        painter.rect_filled(rect, CornerRadius::same(6), tokens.held);
    } else if response.hovered() || chip.certificate {
        painter.rect_filled(rect, CornerRadius::same(6), tokens.hover);
    }
    row::focus(ui, &response);
    let ink = verdict.colour(&tokens);
    let middle = rect.center().y;
    let written = |x: f32, text: &str, font| {
        let at = pos2(rect.left() + x, middle);
        painter.text(at, Align2::LEFT_CENTER, text, font, ink)
    };
    written(8.0, verdict.icon(), icon_font(16.0));
    let word = written(28.0, verdict.word(), FontId::proportional(14.0));
    let mut taken = word.right();
    let sign = match bench.live.cautions() {
        [] if bench.live.has_history() => Some((icons::CLOCK_COUNTER_CLOCKWISE, tokens.muted)),
        [] => None,
        _ => Some((icons::WARNING, tokens.warning)),
    };
    if let Some((glyph, ink)) = sign {
        let sign = painter.layout_no_wrap(glyph.into(), icon_font(14.0), ink);
        let right = (rect.left() + WORD - 8.0).max(taken + 4.0 + sign.size().x);
        let place = Align2::RIGHT_CENTER.anchor_size(pos2(right, middle), sign.size());
        painter.galley(place.min, sign, ink);
        taken = right;
    }
    if let Some(solution) = bench.live.solution()
        && bar >= ROOMY
    {
        let mut x = rect.left() + WORD;
        for (text, width) in [
            (residual(solution), RESIDUAL),
            (format!("{} it", solution.iterations), ITERATIONS),
            (time(bench.live.time()), TIME),
        ] {
            x += width;
            let font = FontId::proportional(12.0);
            let number = painter.layout_no_wrap(text, font, tokens.muted);
            let place = Align2::RIGHT_CENTER.anchor_size(pos2(x - 8.0, middle), number.size());
            // A long word, or a sign, takes the place of the number beside it.
            if place.left() > taken + 4.0 {
                painter.galley(place.min, number, tokens.muted);
            }
        }
    }
    response.widget_info(|| {
        let told = format!("Status: {}", verdict.word());
        WidgetInfo::labeled(Role::Button, ui.is_enabled(), told)
    });
    if response.on_hover_text(tip(bench, verdict)).clicked() {
        chip.certificate ^= true;
    }
}

/// The verdict, or what it was before while a solve has only just begun.
fn steady(ui: &Ui, chip: &mut StatusChip, live: &Live) -> Verdict {
    let now = ui.input(|input| input.time);
    let verdict = Verdict::of(live);
    let told = &mut chip.told;
    if verdict != Verdict::Solving {
        *told = Some((verdict, now));
        return verdict;
    }
    match *told {
        Some((before, since)) if now - since < PATIENCE => {
            let left = Duration::from_secs_f64(PATIENCE);
            ui.ctx().request_repaint_after(left);
            before
        }
        _ => verdict,
    }
}

fn tip(bench: &Workbench, verdict: Verdict) -> String {
    let Some(solution) = bench.live.solution() else {
        return "The solver is looking for the robot's shape".to_owned();
    };
    let what = match verdict {
        Verdict::Solving => "The solver is looking for the robot's shape.".to_owned(),
        _ => words::outcome(solution, &bench.document.scene),
    };
    let cautions = bench.live.cautions().iter();
    let cautions = cautions.map(|one| format!("\n{}", words::caution(one, &bench.document.scene)));
    let cautions: String = cautions.collect();
    let history = match bench.live.has_history() {
        true => {
            "\nFriction remembers the way here; from straight the robot comes to another shape \
                 at this pull. R resets the history"
        }
        false => "",
    };
    format!(
        "{what}{cautions}{history}\nKKT residual {}, {} iterations, {}\nClick for the certificate",
        residual(solution),
        solution.iterations,
        time(bench.live.time())
    )
}

fn residual(solution: &Solution) -> String {
    Quantity::order(solution.certificate.residual(), "").digits
}

/// A time with as many digits as mean something.
fn time(time: Duration) -> String {
    let micros = time.as_secs_f64() * 1e6;
    let (value, unit) = match micros {
        ..999.5 => (micros, "µs"),
        ..999_500.0 => (micros / 1e3, "ms"),
        _ => (micros / 1e6, "s"),
    };
    let decimals = if value < 10.0 && unit != "µs" { 1 } else { 0 };
    Quantity::fixed(value, decimals, unit).text()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_the_unit_that_suits_them() {
        let check = |micros, expect: &str| assert_eq!(time(Duration::from_micros(micros)), expect);
        check(14, "14 µs");
        check(999, "999 µs");
        check(2_340, "2.3 ms");
        check(23_400, "23 ms");
        check(1_500_000, "1.5 s");
    }
}
