//! What happened along the path, as marks over the pull, and where their names
//! find room.

use super::data::PlotData;
use super::pane::{SMALL, Surface};
use crate::app::look::{Tokens, icon_font, icons};
use crate::app::words;
use crate::equilibrium::{Occurrence, Status};
use crate::explore::Path;
use crate::robot::disk_name;
use crate::units::millimetres;
use crate::view::Quantity;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Stroke, pos2};

/// An event of the path.
pub(super) struct Happening {
    /// In mm.
    pub pull: f64,
    /// In metres.
    pub at: f64,
    pub kind: Kind,
    /// In a word or two, beside the mark.
    pub short: String,
    /// In a sentence, with the pull.
    pub long: String,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Made,
    Lost,
    Jump,
    End,
}

/// Lanes for names above the curve.
const LANES: usize = 3;
/// Height of a lane.
const LANE: f32 = 16.0;
/// How near the pointer has to be to a mark.
const NEAR: f32 = 6.0;

/// The marks of a path, by pull.
pub(super) fn of(path: &Path, data: &PlotData<'_>) -> Vec<Happening> {
    let robot = data.problem().robot();
    let obstacle = |index: usize| words::obstacle_of(data.scene, index);
    let disk = |node: usize| disk_name(robot, node);
    let events = path.events.iter().filter_map(|event| {
        let (kind, short) = match event.what {
            Occurrence::ContactMade {
                node,
                obstacle: index,
                ..
            } => (
                Kind::Made,
                format!("{} meets {}", disk(node), obstacle(index)),
            ),
            Occurrence::ContactLost {
                node,
                obstacle: index,
                ..
            } => (
                Kind::Lost,
                format!("{} leaves {}", disk(node), obstacle(index)),
            ),
            Occurrence::Jump { distance, .. } => {
                let far = Quantity::fixed(millimetres(distance), 1, "mm").text();
                (Kind::Jump, format!("jumps {far}"))
            }
            Occurrence::FrictionGaveWay => (Kind::Jump, "slips free".to_owned()),
            Occurrence::BranchEnded { .. } => (Kind::End, "branch ends".to_owned()),
            Occurrence::PushedAside { .. } | Occurrence::StartRefused => return None,
        };
        Some(Happening {
            pull: millimetres(event.pull),
            at: event.pull,
            kind,
            short,
            long: words::event(event, data.scene),
        })
    });
    let mut marks: Vec<Happening> = events.collect();
    // Ends for other reasons are noted as the path's end only.
    for end in [&path.start, &path.end].into_iter().flatten() {
        let noted = matches!(end.status, Status::BranchEnded { .. });
        if !noted || !marks.iter().any(|mark| mark.kind == Kind::End) {
            let pull = Quantity::fixed(millimetres(end.pull), 2, "mm").text();
            marks.push(Happening {
                pull: millimetres(end.pull),
                at: end.pull,
                kind: Kind::End,
                short: "path ends".to_owned(),
                long: format!("{pull}: {}", end.status.reason()),
            });
        }
    }
    marks.sort_by(|a, b| a.pull.total_cmp(&b.pull));
    marks
}

impl Kind {
    fn ink(self, tokens: &Tokens) -> Color32 {
        match self {
            Kind::Made => tokens.contact,
            Kind::Lost => tokens.muted,
            Kind::Jump | Kind::End => tokens.warning,
        }
    }

    fn glyph(self, painter: &Painter, at: Pos2, tokens: &Tokens) {
        let ink = self.ink(tokens);
        match self {
            Kind::Made => {
                painter.circle_filled(at, 3.5, ink);
            }
            Kind::Lost => {
                painter.circle_filled(at, 3.5, tokens.panel);
                painter.circle_stroke(at, 3.0, Stroke::new(1.25, ink));
            }
            Kind::Jump => {
                let text = icons::LIGHTNING;
                painter.text(at, Align2::CENTER_CENTER, text, icon_font(13.0), ink);
            }
            Kind::End => {
                let font = FontId::proportional(15.0);
                painter.text(at, Align2::CENTER_CENTER, "×", font, ink);
            }
        }
    }
}

/// The height that marks and their names take above a curve.
pub(super) fn height(marks: &[Happening]) -> f32 {
    if marks.is_empty() {
        0.0
    } else {
        LANE * (LANES + 1) as f32
    }
}

/// Draws the marks and as many of their names as find room; returns the one
/// that the pointer is on.
pub(super) fn draw<'a>(
    surface: &Surface<'_>,
    marks: &'a [Happening],
    tokens: &Tokens,
) -> Option<&'a Happening> {
    let frame = surface.frame();
    let painter = surface.painter;
    let lane = frame.top() + LANE * (LANES as f32 + 0.5);
    let near = |mark: &&Happening| {
        surface
            .pointer
            .is_some_and(|pointer| (surface.x(mark.pull) - pointer.x).abs() <= NEAR)
    };
    let distance = |mark: &&Happening| {
        let pointer = surface.pointer.map_or(0.0, |pointer| pointer.x);
        (surface.x(mark.pull) - pointer).abs()
    };
    let hovered = marks
        .iter()
        .filter(near)
        .min_by(|a, b| distance(a).total_cmp(&distance(b)));
    for mark in marks {
        let x = surface.x(mark.pull);
        if !frame.x_range().contains(x) {
            continue;
        }
        let chosen = hovered.is_some_and(|other| std::ptr::eq(other, mark));
        let strength = if chosen { 1.0 } else { 0.45 };
        let stroke = Stroke::new(1.0, mark.kind.ink(tokens).gamma_multiply(strength));
        painter.vline(x, lane..=frame.bottom(), stroke);
        if !outshone(surface, mark, marks) {
            mark.kind.glyph(painter, pos2(x, lane), tokens);
        }
    }
    names(surface, marks, hovered, tokens);
    hovered
}

/// Whether a mark is that of a contact which a jump makes or ends: the jump
/// tells of it.
fn outshone(surface: &Surface<'_>, mark: &Happening, marks: &[Happening]) -> bool {
    let telling = |mark: &Happening| matches!(mark.kind, Kind::Jump | Kind::End);
    !telling(mark)
        && marks
            .iter()
            .any(|other| telling(other) && same(surface, mark, other))
}

/// Whether two marks are one on the screen.
pub(super) fn same(surface: &Surface<'_>, a: &Happening, b: &Happening) -> bool {
    (surface.x(a.pull) - surface.x(b.pull)).abs() < 1.0
}

/// Names from the most telling on: a jump or an end comes before contacts, and
/// what the pointer is on before all. One that finds no room is left out.
fn names(surface: &Surface<'_>, marks: &[Happening], hovered: Option<&Happening>, tokens: &Tokens) {
    let frame = surface.frame();
    let mut order: Vec<&Happening> = marks
        .iter()
        .filter(|mark| frame.x_range().contains(surface.x(mark.pull)))
        .filter(|mark| !outshone(surface, mark, marks))
        .collect();
    order.sort_by_key(|mark| {
        let chosen = hovered.is_some_and(|other| std::ptr::eq(other, *mark));
        let telling = matches!(mark.kind, Kind::Jump | Kind::End);
        (!chosen, !telling)
    });
    let mut taken: Vec<Rect> = Vec::new();
    for mark in order {
        let x = surface.x(mark.pull);
        let ink = if hovered.is_some_and(|other| std::ptr::eq(other, mark)) {
            tokens.text
        } else {
            tokens.muted
        };
        let font = FontId::proportional(SMALL);
        let galley = surface
            .painter
            .layout_no_wrap(mark.short.clone(), font, ink);
        let size = galley.size();
        let left = (x - 0.5 * size.x)
            .min(frame.right() - size.x - 2.0)
            .max(frame.left() + 2.0);
        let place = (0..LANES).rev().find_map(|lane| {
            let top = frame.top() + LANE * lane as f32;
            let area = Rect::from_min_size(pos2(left, top), size);
            let free = taken
                .iter()
                .all(|other| !other.intersects(area.expand2([4.0, 0.0].into())));
            free.then_some(area)
        });
        if let Some(area) = place {
            surface.clear(area);
            surface.painter.galley(area.min, galley, ink);
            taken.push(area);
        }
    }
}
