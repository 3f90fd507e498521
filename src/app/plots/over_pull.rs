//! What the plots over the pull have in common: the cursor of the present pull
//! and the window of the fits, which a hand can drag, and the twin of a pull
//! that the pointer is on elsewhere.

use super::data::{Link, PlotData};
use super::pane::Surface;
use crate::app::look::Tokens;
use crate::app::workbench::Hovered;
use crate::units::{metres, millimetres};
use eframe::egui::{
    CursorIcon, PointerButton, Pos2, Rect, Response, Shape, Stroke, Ui, pos2, vec2,
};

/// How near a hand has to be to an edge to take it.
const REACH: f32 = 7.0;
/// The narrowest window, as a share of what the plot shows.
const NARROWEST: f64 = 0.02;

/// Whether the window of the fits is shown and can be changed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Edges {
    Shown,
    Hidden,
}

/// Whether the cursor has a handle on the axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Knob {
    Shown,
    Hidden,
}

/// The cursors of a plot over the pull.
#[derive(Clone, Copy)]
pub(super) struct Cursor {
    pub edges: Edges,
    pub knob: Knob,
}

/// What a hand holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hand {
    Pull,
    First,
    Last,
}

/// The shade of the window, to be drawn behind all curves.
pub(super) fn window_shade(data: &PlotData<'_>, tokens: &Tokens) -> egui_plot::Span {
    let (first, last) = (data.window.first, data.window.last);
    egui_plot::Span::new("", millimetres(first)..=millimetres(last))
        .fill(tokens.accent.gamma_multiply(0.07))
        .border_width(0.0)
}

impl Cursor {
    /// Draws the cursors on a plot over the pull, in mm, and follows the hand on
    /// it.
    pub fn show(
        self,
        ui: &Ui,
        surface: &Surface<'_>,
        response: &Response,
        data: &PlotData<'_>,
        link: &mut Link,
    ) {
        let tokens = Tokens::in_ui(ui);
        let hand = self.follow(ui, surface, response, data, link);
        let frame = surface.frame();
        let inside = |x: f32| frame.x_range().contains(x);
        if let Hovered::Pull(pull) = link.hovered {
            let x = surface.x(millimetres(pull));
            if inside(x) {
                let stroke = Stroke::new(1.0, tokens.muted.gamma_multiply(0.6));
                surface.painter.vline(x, frame.y_range(), stroke);
            }
        }
        if self.edges == Edges::Shown {
            for (edge, of) in [
                (link.window.first, Hand::First),
                (link.window.last, Hand::Last),
            ] {
                let x = surface.x(millimetres(edge));
                if inside(x) {
                    let held = hand == Some(of);
                    let ink = tokens.accent.gamma_multiply(if held { 0.9 } else { 0.45 });
                    surface
                        .painter
                        .vline(x, frame.y_range(), Stroke::new(1.0, ink));
                    let grip = Rect::from_center_size(pos2(x, frame.top() + 12.0), vec2(5.0, 16.0));
                    surface.painter.rect_filled(grip, 2.5, ink);
                }
            }
        }
        let x = surface.x(millimetres(data.solved.pull));
        if inside(x) {
            let width = if hand == Some(Hand::Pull) { 2.0 } else { 1.5 };
            let stroke = Stroke::new(width, tokens.accent);
            surface.painter.vline(x, frame.y_range(), stroke);
            if self.knob == Knob::Shown {
                surface.painter.add(knob(pos2(x, frame.bottom()), &tokens));
            }
        }
    }

    /// Follows the hand: returns what it holds or would take.
    fn follow(
        self,
        ui: &Ui,
        surface: &Surface<'_>,
        response: &Response,
        data: &PlotData<'_>,
        link: &mut Link,
    ) -> Option<Hand> {
        let (Some(pointer), Some(value)) = (surface.pointer, surface.value()) else {
            return None;
        };
        // A plot without room has no scale.
        if !value.is_finite() {
            return None;
        }
        let id = response.id.with("hand");
        let origin = ui.input(|input| input.pointer.press_origin());
        let reached = |at: Pos2| {
            let far = |pull: f64| (surface.x(millimetres(pull)) - at.x).abs();
            let first = (far(link.window.first), Hand::First);
            let last = (far(link.window.last), Hand::Last);
            let nearest = if last.0 <= first.0 { last } else { first };
            if self.edges == Edges::Shown && nearest.0 <= REACH {
                nearest.1
            } else {
                Hand::Pull
            }
        };
        if response.drag_started_by(PointerButton::Primary) {
            let taken = reached(origin.unwrap_or(pointer));
            ui.data_mut(|data| data.insert_temp(id, taken));
        }
        let dragged = response.dragged_by(PointerButton::Primary);
        let held = dragged.then(|| ui.data(|data| data.get_temp::<Hand>(id)));
        let hand = held.flatten().unwrap_or_else(|| reached(pointer));
        let pull = metres(value);
        let range = data.path.and_then(|path| path.range());
        let (least, most) = range.unwrap_or(data.asked.pull_range());
        let bounds = surface.transform.bounds();
        let gap = NARROWEST * metres(bounds.width());
        match hand {
            Hand::Pull if dragged || response.clicked() => {
                link.pull = Some(pull.clamp(least, most));
            }
            Hand::First if dragged => {
                link.window.first = pull.clamp(least, (link.window.last - gap).max(least));
            }
            Hand::Last if dragged => {
                link.window.last = pull.clamp((link.window.first + gap).min(most), most);
            }
            _ => {}
        }
        if hand == Hand::Pull {
            link.hovering = Hovered::Pull(pull.clamp(least, most));
        }
        ui.ctx().set_cursor_icon(match hand {
            Hand::Pull => CursorIcon::PointingHand,
            Hand::First | Hand::Last => CursorIcon::ResizeHorizontal,
        });
        (hand != Hand::Pull || dragged).then_some(hand)
    }
}

/// The handle of the present pull, on the axis.
fn knob(foot: Pos2, tokens: &Tokens) -> Shape {
    let outline = vec![
        foot + vec2(0.0, -7.0),
        foot + vec2(5.0, -1.0),
        foot + vec2(5.0, 4.0),
        foot + vec2(-5.0, 4.0),
        foot + vec2(-5.0, -1.0),
    ];
    Shape::convex_polygon(outline, tokens.accent, Stroke::NONE)
}

/// The pull that the plots read: the one the pointer is on, or else the present
/// one, in metres.
pub(super) fn read_at(data: &PlotData<'_>, link: &Link) -> f64 {
    match link.hovered {
        Hovered::Pull(pull) => pull,
        _ => data.solved.pull,
    }
}
