//! Short words at the window's edge: what went well, for a few seconds; what
//! did not, until it is dismissed.
//!
//! Its own few lines rather than a crate's, because they wrap on a phone, can
//! be reached by keyboard and are read out by screen readers.

use super::look::{Tokens, icon_button, icon_font, icons};
use eframe::egui::{
    Align, Align2, Area, Context, Frame, Id, Label, Layout, Margin, Order, RichText, Ui, vec2,
};

/// Seconds that a quiet notice stays.
const STAYS: f64 = 4.0;
/// Notices that are shown at a time.
const MOST: usize = 4;

/// How a notice is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Something was done.
    Success,
    /// Something is to be known.
    Information,
    /// Something went wrong.
    Trouble,
}

/// Something to be told.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// How it is meant.
    pub tone: Tone,
    /// A sentence.
    pub text: String,
    /// When it goes, in seconds of the window's clock, once it was shown.
    until: Option<f64>,
}

impl Notice {
    /// Something was done.
    pub fn success(text: impl Into<String>) -> Self {
        Self::new(Tone::Success, text)
    }

    /// Something is to be known.
    pub fn information(text: impl Into<String>) -> Self {
        Self::new(Tone::Information, text)
    }

    /// Something went wrong.
    pub fn trouble(text: impl Into<String>) -> Self {
        Self::new(Tone::Trouble, text)
    }

    fn new(tone: Tone, text: impl Into<String>) -> Self {
        Self {
            tone,
            text: text.into(),
            until: None,
        }
    }
}

/// What is being told.
#[derive(Debug, Default)]
pub struct Notices {
    shown: Vec<Notice>,
}

impl Notices {
    /// Tells something. What is being told already is told anew, not twice.
    pub fn tell(&mut self, notice: Notice) {
        self.shown.retain(|known| known.text != notice.text);
        self.shown.push(notice);
        if self.shown.len() > MOST {
            self.shown.remove(0);
        }
    }

    /// What is being told.
    pub fn iter(&self) -> impl Iterator<Item = &Notice> {
        self.shown.iter()
    }

    /// Shows the notices above the bottom edge and drops those whose time has
    /// come.
    pub fn show(&mut self, ctx: &Context) {
        if self.shown.is_empty() {
            return;
        }
        let now = ctx.input(|input| input.time);
        for notice in &mut self.shown {
            if notice.tone == Tone::Trouble {
                continue;
            }
            let until = *notice.until.get_or_insert(now + STAYS);
            if until > now {
                let left = web_time::Duration::from_secs_f64(until - now);
                ctx.request_repaint_after(left);
            }
        }
        self.shown
            .retain(|notice| notice.until.is_none_or(|until| until > now));
        let mut dismissed = None;
        Area::new(Id::unique("notices"))
            .order(Order::Foreground)
            .anchor(Align2::CENTER_BOTTOM, vec2(0.0, -72.0))
            .show(ctx, |ui| {
                ui.set_width((ctx.content_rect().width() - 32.0).min(400.0));
                for (index, notice) in self.shown.iter().enumerate() {
                    if show(ui, notice) {
                        dismissed = Some(index);
                    }
                }
            });
        if let Some(index) = dismissed {
            self.shown.remove(index);
        }
    }
}

/// Shows a notice; whether it was dismissed.
fn show(ui: &mut Ui, notice: &Notice) -> bool {
    let tokens = Tokens::in_ui(ui);
    let (glyph, colour) = match notice.tone {
        Tone::Success => (icons::CHECK_CIRCLE, tokens.good),
        Tone::Information => (icons::INFO, tokens.accent),
        Tone::Trouble => (icons::WARNING_CIRCLE, tokens.error),
    };
    let frame = Frame::popup(ui.style())
        .corner_radius(10)
        .inner_margin(Margin::symmetric(12, 8));
    frame
        .show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 8.0;
                ui.label(RichText::new(glyph).font(icon_font(18.0)).color(colour));
                let height = ui.spacing().interact_size.y;
                let words = vec2(ui.available_width() - 36.0, height);
                let layout = Layout::left_to_right(Align::Center);
                ui.allocate_ui_with_layout(words, layout, |ui| {
                    ui.set_min_width(words.x);
                    ui.add(Label::new(&notice.text).wrap());
                });
                icon_button(ui, icons::X, "Dismiss").clicked()
            })
            .inner
        })
        .inner
}
