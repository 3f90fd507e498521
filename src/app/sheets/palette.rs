//! The palette: every command, example and recent file by a few of its
//! letters.

use super::frame::{Stays, at_top};
use crate::app::commands::{ALL, Command};
use crate::app::examples::{EXAMPLES, Example};
use crate::app::files;
use crate::app::look::{Tokens, icon, icons};
use crate::app::words::shown;
use crate::app::workbench::Workbench;
use eframe::egui::{
    Context, Key, Label, Modifiers, Rect, RichText, ScrollArea, Sense, TextEdit, TextStyle, Ui,
    UiBuilder, WidgetInfo, pos2, vec2,
};
use std::path::PathBuf;

/// Height of a line, in points: enough for a finger.
const LINE: f32 = 34.0;

/// What was typed, and which line it has come to.
#[derive(Debug, Default)]
pub(super) struct Palette {
    typed: String,
    line: usize,
}

/// What a line does.
#[derive(Clone, Debug)]
enum Action {
    Command(Command),
    Example(&'static Example),
    Recent(PathBuf),
}

#[derive(Clone, Debug)]
struct Choice {
    action: Action,
    icon: &'static str,
    title: String,
    /// At the end of the line: its keys or its group.
    aside: String,
    enabled: bool,
}

/// How well a title answers what was typed: `None` where its letters do not
/// occur in their order; more where they begin words or follow each other.
fn score(title: &str, typed: &str) -> Option<i32> {
    let title: Vec<char> = title.chars().flat_map(char::to_lowercase).collect();
    let wanted = typed.chars().flat_map(char::to_lowercase);
    let wanted: Vec<char> = wanted.filter(|c| !c.is_whitespace()).collect();
    // best[i]: the best score of what was typed so far with its last letter at
    // title[i].
    let mut best: Vec<Option<i32>> = Vec::new();
    for (place, letter) in wanted.iter().enumerate() {
        let mut next = vec![None; title.len()];
        // The best end of the letters before, anywhere to the left.
        let mut left: Option<i32> = (place == 0).then_some(0);
        for (i, known) in title.iter().enumerate() {
            if known == letter {
                let begins = i == 0 || !title[i - 1].is_alphanumeric();
                let worth = if begins { 8 } else { 1 };
                let follows = if i > 0 && place > 0 {
                    best[i - 1]
                } else {
                    None
                };
                let joined = follows.map(|score| score + 10);
                next[i] = left.max(joined).map(|score| score + worth);
            }
            if place > 0 {
                left = left.max(best[i]);
            }
        }
        best = next;
    }
    if wanted.is_empty() {
        return Some(0);
    }
    // Of two titles that answer alike, the shorter.
    let found = best.into_iter().flatten().max()?;
    Some(16 * found - title.len().min(15) as i32)
}

fn lines(bench: &Workbench, ctx: &Context) -> Vec<Choice> {
    let commands = ALL.iter().filter(|entry| entry.command != Command::Palette);
    let mut lines: Vec<Choice> = commands
        .map(|entry| Choice {
            action: Action::Command(entry.command),
            icon: entry.icon,
            title: entry.title.to_owned(),
            aside: entry
                .shortcut
                .map_or_else(String::new, |keys| ctx.format_shortcut(&keys)),
            enabled: bench.allows(entry.command),
        })
        .collect();
    lines.extend(EXAMPLES.iter().map(|example| Choice {
        action: Action::Example(example),
        icon: icons::GRADUATION_CAP,
        title: format!("Open example: {}", example.title),
        aside: example.group.title().to_owned(),
        enabled: true,
    }));
    lines.extend(bench.files.recent.iter().map(|path| Choice {
        action: Action::Recent(path.clone()),
        icon: icons::FOLDER_OPEN,
        title: format!("Open recent: {}", shown(path)),
        aside: String::new(),
        enabled: true,
    }));
    lines
}

/// The lines that answer what was typed, the best first.
fn found(lines: Vec<Choice>, typed: &str) -> Vec<Choice> {
    let mut scored: Vec<(i32, Choice)> = lines
        .into_iter()
        .filter_map(|line| Some((score(&line.title, typed)?, line)))
        .collect();
    // Stable: those that answer alike stay in the order of menus.
    scored.sort_by_key(|(score, line)| (!line.enabled, -score));
    scored.into_iter().map(|(_, line)| line).collect()
}

pub(super) fn show(
    ctx: &Context,
    palette: &mut Palette,
    bench: &mut Workbench,
    fresh: bool,
) -> Stays {
    let mut chosen = None;
    let again = ctx.input_mut(|input| {
        input.consume_key(Modifiers::COMMAND, Key::K)
            || input.consume_key(Modifiers::COMMAND | Modifiers::SHIFT, Key::P)
    });
    let stays = at_top(ctx, "palette", 560.0, |ui| {
        // Before the field sees them.
        let (up, down, enter) = ui.input_mut(|input| {
            let mut pressed = |key| input.consume_key(Modifiers::NONE, key);
            (
                pressed(Key::ArrowUp),
                pressed(Key::ArrowDown),
                pressed(Key::Enter),
            )
        });
        let field = TextEdit::singleline(&mut palette.typed)
            .hint_text("Search commands, examples and recent files")
            .margin(vec2(10.0, 8.0))
            .desired_width(f32::INFINITY);
        let field = ui.add(field).on_hover_text("Search");
        if fresh || !field.has_focus() {
            field.request_focus();
        }
        if field.changed() {
            palette.line = 0;
        }
        let typed = palette.typed.clone();
        let found = found(lines(bench, ui.ctx()), &typed);
        let last = found.len().saturating_sub(1);
        let before = palette.line;
        if down {
            palette.line = if palette.line >= last {
                0
            } else {
                palette.line + 1
            };
        }
        if up {
            palette.line = if palette.line == 0 {
                last
            } else {
                palette.line - 1
            };
        }
        palette.line = palette.line.min(last);
        ui.add_space(4.0);
        if found.is_empty() {
            ui.add_space(8.0);
            ui.vertical_centered(|ui| ui.weak("Nothing is called that."));
            ui.add_space(8.0);
        }
        let height = (0.6 * ui.ctx().content_rect().height()).min(12.0 * LINE);
        ScrollArea::vertical()
            .max_height(height)
            .min_scrolled_height(height)
            .show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                for (index, line) in found.iter().enumerate() {
                    let chosen_by_keys = index == palette.line;
                    let response = row(ui, line, chosen_by_keys);
                    if chosen_by_keys && palette.line != before {
                        response.scroll_to_me(None);
                    }
                    // A pointer that rests does not take the line from the keys.
                    if response.hovered() && ui.input(|input| input.pointer.is_moving()) {
                        palette.line = index;
                    }
                    if response.clicked() || (enter && chosen_by_keys) {
                        chosen = Some(line.clone());
                    }
                }
            });
    });
    match chosen {
        Some(line) if line.enabled => {
            match line.action {
                Action::Command(command) => bench.commands.push(command),
                Action::Example(example) => super::gallery::open(bench, example, ctx),
                Action::Recent(path) => files::reopen(bench, path),
            }
            Stays::Closed
        }
        _ if again => Stays::Closed,
        _ => stays,
    }
}

fn row(ui: &mut Ui, line: &Choice, current: bool) -> eframe::egui::Response {
    let tokens = Tokens::in_ui(ui);
    let size = vec2(ui.available_width(), LINE);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| {
        WidgetInfo::selected(
            eframe::egui::Role::Button,
            line.enabled,
            current,
            &line.title,
        )
    });
    if !ui.is_rect_visible(rect) {
        return response;
    }
    if current {
        ui.painter().rect_filled(rect, 6.0, tokens.accent_soft);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 6.0, tokens.hover);
    }
    let colour = if line.enabled {
        tokens.text
    } else {
        tokens.muted.gamma_multiply(0.7)
    };
    let quiet = if line.enabled { tokens.muted } else { colour };
    let middle = rect.center().y;
    let part =
        |from: f32, to: f32| Rect::from_min_max(pos2(from, rect.top()), pos2(to, rect.bottom()));
    let _ = middle;
    let font = TextStyle::Body.resolve(ui.style());
    let small = TextStyle::Small.resolve(ui.style());
    let aside = ui
        .painter()
        .layout_no_wrap(line.aside.clone(), small, quiet);
    let width = aside.size().x;
    let at = pos2(
        rect.right() - 10.0 - width,
        rect.center().y - 0.5 * aside.size().y,
    );
    ui.painter().galley(at, aside, quiet);
    let glyph = part(rect.left() + 8.0, rect.left() + 32.0);
    let mut inner = ui.new_child(UiBuilder::new().max_rect(glyph));
    inner.centered_and_justified(|ui| {
        ui.add(Label::new(icon(line.icon).color(quiet)).selectable(false))
    });
    let title = part(rect.left() + 40.0, at.x - 12.0);
    let layout = eframe::egui::Layout::left_to_right(eframe::egui::Align::Center);
    let mut inner = ui.new_child(UiBuilder::new().max_rect(title).layout(layout));
    let text = RichText::new(&line.title).font(font).color(colour);
    inner.add(Label::new(text).truncate().selectable(false));
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_in_their_order_are_found() {
        assert!(score("Save as …", "sas").is_some());
        assert!(score("Save as …", "sx").is_none());
        assert!(score("Save as …", "as as s").is_none());
        assert_eq!(score("Anything", ""), Some(0));
        assert!(score("", "a").is_none());
    }

    #[test]
    fn beginnings_of_words_come_before_letters_inside_them() {
        let better = |one, other, typed| {
            let (one, other) = (score(one, typed), score(other, typed));
            assert!(one > other, "{one:?} {other:?}");
        };
        better("Undo", "Show or hide the outline", "und");
        better("Export as PNG …", "Open example: a big one", "png");
        better("Show or hide the grid", "Start from straight", "grid");
        better("Save", "Save as …", "save");
        better("Open example: Two discs", "Open example: One disc", "two");
    }
}
