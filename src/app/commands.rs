//! Every command of the window in one list, which drives the shortcuts, the
//! palette and the help.

mod run;

pub use run::run;

use super::canvas::Tool;
use super::look::icons;
use super::state::State;
use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};

/// Something the user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Takes the last step back.
    Undo,
    /// Takes the step again.
    Redo,
    /// Adds a copy of the obstacle that is selected.
    Duplicate,
    /// Deletes what is selected.
    Delete,
    /// Gives up what is being dragged or drawn, or deselects.
    Deselect,
    /// Takes a tool of the canvas in hand.
    Tool(Tool),
    /// Plays or pauses.
    Play,
    /// Follows the scene anew from the straight robot.
    FromStraight,
    /// Shows everything.
    Fit,
    /// Shows the plane alone.
    ViewPlane,
    /// Shows the robot in space alone.
    ViewSpace,
    /// Shows both, side by side.
    ViewBoth,
    /// Shows or hides the outline.
    Outline,
    /// Shows or hides the plots.
    Dock,
    /// Shows or hides the clearance field.
    Field,
    /// Shows or hides the grid.
    Grid,
    /// Shows or hides the tip's trace.
    Trace,
    /// Changes from light to dark or back.
    Theme,
}

/// What commands are listed under.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Steps and what is selected.
    Edit,
    /// What clicks on the canvas do.
    Tools,
    /// The pull.
    Robot,
    /// What is shown.
    View,
}

/// What there is to know of a command.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The command.
    pub command: Command,
    /// Where it is listed.
    pub group: Group,
    /// What it does, beginning with a verb.
    pub title: &'static str,
    /// Its icon.
    pub icon: &'static str,
    /// Its keys, if any.
    pub shortcut: Option<KeyboardShortcut>,
}

const fn entry(
    command: Command,
    group: Group,
    title: &'static str,
    icon: &'static str,
    shortcut: Option<KeyboardShortcut>,
) -> Entry {
    Entry {
        command,
        group,
        title,
        icon,
        shortcut,
    }
}

const fn key(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::NONE, key))
}

const fn ctrl(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND, key))
}

const fn ctrl_shift(key: Key) -> Option<KeyboardShortcut> {
    let both = Modifiers {
        shift: true,
        ..Modifiers::COMMAND
    };
    Some(KeyboardShortcut::new(both, key))
}

/// All commands, in the order of menus.
#[rustfmt::skip]
pub const ALL: &[Entry] = &[
    entry(Command::Undo, Group::Edit, "Undo", icons::ARROW_U_UP_LEFT, ctrl(Key::Z)),
    entry(Command::Redo, Group::Edit, "Redo", icons::ARROW_U_UP_RIGHT, ctrl_shift(Key::Z)),
    entry(Command::Duplicate, Group::Edit, "Duplicate", icons::COPY, ctrl(Key::D)),
    entry(Command::Delete, Group::Edit, "Delete", icons::TRASH, key(Key::Delete)),
    entry(Command::Deselect, Group::Edit, "Give up or deselect", icons::X, key(Key::Escape)),
    entry(Command::Tool(Tool::Select), Group::Tools, "Select and move", Tool::Select.icon(), key(Key::V)),
    entry(Command::Tool(Tool::Disc), Group::Tools, "Add a disc", Tool::Disc.icon(), key(Key::D)),
    entry(Command::Tool(Tool::Box), Group::Tools, "Add a box", Tool::Box.icon(), key(Key::B)),
    entry(Command::Tool(Tool::Capsule), Group::Tools, "Add a capsule", Tool::Capsule.icon(), key(Key::K)),
    entry(Command::Tool(Tool::Polygon), Group::Tools, "Draw a polygon", Tool::Polygon.icon(), key(Key::P)),
    entry(Command::Tool(Tool::Wall), Group::Tools, "Add a wall", Tool::Wall.icon(), key(Key::W)),
    entry(Command::Play, Group::Robot, "Play or pause", icons::PLAY, key(Key::Space)),
    entry(Command::FromStraight, Group::Robot, "Start from straight", icons::CLOCK_COUNTER_CLOCKWISE, key(Key::R)),
    entry(Command::Fit, Group::View, "Show everything", icons::CORNERS_OUT, key(Key::F)),
    entry(Command::ViewPlane, Group::View, "Show the plane", icons::SQUARE, key(Key::Num1)),
    entry(Command::ViewSpace, Group::View, "Show the robot in space", icons::CUBE, key(Key::Num2)),
    entry(Command::ViewBoth, Group::View, "Show plane and space side by side", icons::COLUMNS, key(Key::Num3)),
    entry(Command::Outline, Group::View, "Show or hide the outline", icons::LIST, ctrl(Key::B)),
    entry(Command::Dock, Group::View, "Show or hide the plots", icons::CHART_LINE, ctrl(Key::J)),
    entry(Command::Field, Group::View, "Show or hide the clearance field", icons::WAVES, key(Key::C)),
    entry(Command::Grid, Group::View, "Show or hide the grid", icons::GRID_FOUR, key(Key::G)),
    entry(Command::Trace, Group::View, "Show or hide the tip's trace", icons::PATH, key(Key::T)),
    entry(Command::Theme, Group::View, "Change between light and dark", icons::MOON, ctrl_shift(Key::L)),
];

impl Command {
    /// What there is to know of the command.
    pub fn entry(self) -> &'static Entry {
        let found = ALL.iter().find(|entry| entry.command == self);
        found.unwrap_or(&ALL[0])
    }

    /// The title with the shortcut, as for a tip.
    pub fn tip(self, ctx: &Context) -> String {
        let entry = self.entry();
        match &entry.shortcut {
            Some(keys) => format!("{} ({})", entry.title, ctx.format_shortcut(keys)),
            None => entry.title.to_owned(),
        }
    }

    /// Whether the command would do anything.
    pub fn is_enabled(self, state: &State) -> bool {
        match self {
            Command::Undo => state.history.can_undo(&state.document.scene),
            Command::Redo => state.history.can_redo(),
            Command::Delete | Command::Duplicate => state.selection.obstacle().is_some(),
            Command::Deselect => {
                state.canvas.is_giving_up_something()
                    || state.selection != super::state::Selection::Nothing
            }
            _ => true,
        }
    }
}

/// The commands whose keys were pressed. Keys without Ctrl count only while no
/// text is being written.
pub fn pressed(ctx: &Context) -> Vec<Command> {
    let writing = ctx.text_edit_focused();
    ctx.input_mut(|input| {
        let mut found = Vec::new();
        // Longer combinations first: Ctrl+Shift+Z is not Ctrl+Z.
        let mut entries: Vec<&Entry> = ALL.iter().collect();
        entries.sort_by_key(|entry| !entry.shortcut.is_some_and(|keys| keys.modifiers.shift));
        for entry in entries {
            if let Some(keys) = &entry.shortcut
                && (keys.modifiers.command || !writing)
                && input.consume_shortcut(keys)
            {
                found.push(entry.command);
            }
        }
        found
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_one_entry_and_no_two_share_their_keys() {
        for (index, entry) in ALL.iter().enumerate() {
            assert_eq!(entry.command.entry().title, entry.title);
            for other in &ALL[index + 1..] {
                assert_ne!(entry.command, other.command);
                assert!(
                    entry.shortcut.is_none() || entry.shortcut != other.shortcut,
                    "{} and {}",
                    entry.title,
                    other.title
                );
            }
        }
    }
}
