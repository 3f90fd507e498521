//! The gallery of examples: cards with the real solved drawing, solved while
//! the gallery is open, a few milliseconds a frame.

use super::frame::{Stays, caption, large};
use crate::app::examples::{EXAMPLES, Example, Group};
use crate::app::files;
use crate::app::look::{Tokens, semibold, theme_of};
use crate::app::paint;
use crate::app::words::sentence;
use crate::app::workbench::{Arrival, Intent, Notice, Workbench};
use crate::equilibrium::{Progress, Run, Settings, Start};
use crate::geometry::Vector;
use crate::mechanics::Problem;
use crate::view::{Bounds, Drawing, Frame, Notes, draw};
use eframe::egui::emath::TSTransform;
use eframe::egui::{
    Align, Context, CornerRadius, Layout, Painter, Rect, RichText, Sense, Stroke, StrokeKind, Ui,
    UiBuilder, Vec2, WidgetInfo, pos2, vec2,
};
use web_time::{Duration, Instant};

/// Time a frame may take for solving.
const PATIENCE: Duration = Duration::from_millis(6);
/// Iterations between two looks at the clock.
const SLICE: usize = 32;
/// Least width of a card, and the room between two.
const LEAST: f32 = 216.0;
const GAP: f32 = 16.0;
/// Height of a card's picture over its width.
const PICTURE: f32 = 0.68;
/// Height of a card's words.
const WORDS: f32 = 84.0;
/// Size of a picture's lines over their usual size.
const SCALE: f32 = 0.6;

/// The pictures, as far as they are there.
#[derive(Default)]
pub(super) struct Gallery {
    /// By example, as far as they have been made.
    pictures: Vec<Picture>,
    /// The one being solved.
    run: Option<Run>,
}

/// An example's picture.
#[derive(Debug, PartialEq)]
enum Picture {
    There(Box<Drawing>),
    /// The example cannot be solved.
    Missing,
}

impl Gallery {
    /// Works on the pictures for a moment; whether any is left to make.
    fn work(&mut self) -> bool {
        let begin = Instant::now();
        while let Some(example) = EXAMPLES.get(self.pictures.len()) {
            let Ok(scene) = example.scene() else {
                self.pictures.push(Picture::Missing);
                continue;
            };
            if self.run.is_none() {
                let Ok(problem) = Problem::new(&scene) else {
                    self.pictures.push(Picture::Missing);
                    continue;
                };
                self.run = Some(Run::new(&problem, Start::Straight, Settings::default()));
            }
            let Some(run) = &mut self.run else {
                return false;
            };
            if run.advance(SLICE) == Progress::Done {
                let picture = draw(&run.solved(), &Notes::of(&scene));
                self.pictures.push(Picture::There(Box::new(picture)));
                self.run = None;
            }
            if begin.elapsed() > PATIENCE {
                return true;
            }
        }
        false
    }
}

/// Opens an example, after asking where unsaved work would be lost.
pub(super) fn open(bench: &mut Workbench, example: &'static Example, ctx: &Context) {
    match example.scene() {
        Ok(scene) => {
            let arrival = Arrival::of(scene);
            files::request(bench, Intent::Scene(Box::new(arrival)), ctx);
        }
        Err(fault) => bench
            .notices
            .tell(Notice::trouble(sentence(&fault.to_string()))),
    }
}

pub(super) fn show(
    ctx: &Context,
    gallery: &mut Gallery,
    bench: &mut Workbench,
    fresh: bool,
) -> Stays {
    if gallery.work() {
        ctx.request_repaint();
    }
    let mut chosen = None;
    let pictures = &gallery.pictures;
    let stays = large(ctx, "gallery", "Examples", (960.0, 680.0), |ui| {
        let wide = ui.available_width();
        let columns = ((wide + GAP) / (LEAST + GAP)).floor().max(1.0);
        let width = ((wide - GAP * (columns - 1.0)) / columns).floor();
        let size = vec2(width, (PICTURE * width).round() + WORDS);
        for group in Group::ALL {
            let examples: Vec<(usize, &'static Example)> = EXAMPLES
                .iter()
                .enumerate()
                .filter(|(_, e)| e.group == group)
                .collect();
            if examples.is_empty() {
                continue;
            }
            caption(ui, group.title());
            for row in examples.chunks(columns as usize) {
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = GAP;
                    for (index, example) in row {
                        let picture = pictures.get(*index);
                        let card = card(ui, example, picture, size);
                        if fresh && *index == 0 {
                            card.request_focus();
                        }
                        if card.gained_focus() {
                            card.scroll_to_me(None);
                        }
                        if card.clicked() {
                            chosen = Some(*example);
                        }
                    }
                });
                ui.add_space(GAP - 4.0);
            }
            ui.add_space(8.0);
        }
    });
    if let Some(example) = chosen {
        open(bench, example, ctx);
        return Stays::Open;
    }
    stays
}

fn card(
    ui: &mut Ui,
    example: &Example,
    picture: Option<&Picture>,
    size: Vec2,
) -> eframe::egui::Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| {
        let name = format!("{}. {}", example.title, example.lesson);
        WidgetInfo::labeled(eframe::egui::Role::Button, true, name)
    });
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let tokens = Tokens::in_ui(ui);
    let radius = CornerRadius::same(10);
    let fill = if response.hovered() {
        tokens.hover
    } else {
        tokens.panel
    };
    let edge = if response.has_focus() || response.hovered() {
        Stroke::new(if response.has_focus() { 2.0 } else { 1.0 }, tokens.accent)
    } else {
        Stroke::new(1.0, tokens.line)
    };
    ui.painter().rect_filled(rect, radius, fill);
    let split = rect.bottom() - WORDS;
    let window = Rect::from_min_max(rect.min, pos2(rect.right(), split));
    let upper = CornerRadius {
        sw: 0,
        se: 0,
        ..radius
    };
    ui.painter().rect_filled(window, upper, tokens.canvas);
    if let Some(Picture::There(drawing)) = picture {
        miniature(ui, drawing, window);
    }
    ui.painter()
        .rect_stroke(rect, radius, edge, StrokeKind::Inside);
    let words = Rect::from_min_max(pos2(rect.left(), split), rect.max).shrink2(vec2(12.0, 10.0));
    let layout = Layout::top_down(Align::Min);
    let mut inner = ui.new_child(UiBuilder::new().max_rect(words).layout(layout));
    inner.spacing_mut().item_spacing.y = 2.0;
    let title = RichText::new(example.title)
        .font(semibold(14.0))
        .color(tokens.text);
    let label = |text| eframe::egui::Label::new(text).selectable(false);
    inner.add(label(title).truncate());
    let lesson = RichText::new(example.lesson).small().color(tokens.muted);
    inner.add(label(lesson).wrap());
    response
}

/// The picture as it would be in a larger window, made smaller with all of its
/// lines and arrows.
fn miniature(ui: &Ui, drawing: &Drawing, window: Rect) {
    let large = Rect::from_min_size(window.min, window.size() / SCALE);
    let corner = window.min.to_vec2();
    let smaller = TSTransform::from_translation(corner)
        * TSTransform::from_scaling(SCALE)
        * TSTransform::from_translation(-corner);
    // A card that is scrolled half out of sight is cut there.
    let visible = ui.clip_rect().intersect(window);
    let clip = smaller.inverse() * visible;
    let painter = Painter::new(ui.ctx().clone(), ui.layer_id(), clip);
    let inner = bounds(large.shrink(12.0));
    let frame = Frame {
        window: bounds(large),
        ..Frame::fitting(&drawing.bounds, inner)
    };
    let next = |ui: &Ui| {
        ui.ctx()
            .graphics_mut(|all| all.entry(ui.layer_id()).next_idx())
    };
    let from = next(ui);
    paint::drawing(&painter, drawing, &frame, theme_of(ui));
    let to = next(ui);
    ui.ctx().graphics_mut(|all| {
        all.entry(ui.layer_id()).transform_range(from, to, smaller);
    });
}

fn bounds(rect: Rect) -> Bounds {
    Bounds {
        least: Vector::new(f64::from(rect.left()), f64::from(rect.top())),
        most: Vector::new(f64::from(rect.right()), f64::from(rect.bottom())),
    }
}
