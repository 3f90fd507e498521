//! Every command of the window in one list, which drives the shortcuts, the
//! palette and the help.

use super::look::icons;
use super::shapes::Tool;
use eframe::egui::{Context, Id, Key, KeyboardShortcut, Modifiers, Popup};

/// Something the user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Begins with the paper's robot and nothing around it.
    New,
    /// Opens a file.
    Open,
    /// Shows the examples.
    Examples,
    /// Saves the scene.
    Save,
    /// Saves the scene in another place.
    SaveAs,
    /// Brings in a measured backbone or force readings.
    ImportMeasurements,
    /// Lays a photograph behind the robot.
    PlacePhoto,
    /// Writes a picture of lines.
    ExportSvg,
    /// Writes a picture of pixels.
    ExportPng,
    /// Copies a link that holds the scene.
    CopyLink,
    /// Opens a link that was copied.
    PasteLink,
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
    /// Goes to the next mark of the path.
    NextMark,
    /// Goes to the mark before.
    PreviousMark,
    /// Keeps the robot as it is to be compared with what it becomes.
    Pin,
    /// Changes from setting the pull to setting the load, or back.
    Load,
    /// Changes from the sliding cable to the paper's model, or back.
    Mechanics,
    /// Draws the shape in the other mechanics, too, or no more.
    Compare,
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
    /// Groups plots and tables in tabs.
    GroupPlots,
    /// Shows all plots at once.
    SpreadPlots,
    /// Shows or hides the clearance field.
    Field,
    /// Shows or hides the grid.
    Grid,
    /// Shows or hides the tip's trace.
    Trace,
    /// Changes from light to dark or back.
    Theme,
    /// Enlarges everything.
    Larger,
    /// Makes everything smaller.
    Smaller,
    /// Gives everything its usual size.
    UsualSize,
    /// Lists all commands.
    Palette,
    /// Shows the settings.
    Settings,
    /// Explains.
    Help,
}

/// What commands are listed under.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Files, pictures and links.
    File,
    /// Steps and what is selected.
    Edit,
    /// What clicks on the canvas do.
    Tools,
    /// The pull.
    Robot,
    /// What is shown.
    View,
    /// What explains and what suits everything else.
    Help,
}

impl Group {
    /// All groups, in the order of menus.
    pub const ALL: [Group; 6] = [
        Group::File,
        Group::Edit,
        Group::Tools,
        Group::Robot,
        Group::View,
        Group::Help,
    ];

    /// What the group is called.
    pub fn title(self) -> &'static str {
        match self {
            Group::File => "File",
            Group::Edit => "Edit",
            Group::Tools => "Tools",
            Group::Robot => "Robot",
            Group::View => "View",
            Group::Help => "Help",
        }
    }
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
    entry(Command::New, Group::File, "New scene", icons::FILE_PLUS, ctrl(Key::N)),
    entry(Command::Open, Group::File, "Open …", icons::FOLDER_OPEN, ctrl(Key::O)),
    entry(Command::Examples, Group::File, "Examples …", icons::GRADUATION_CAP, ctrl(Key::E)),
    entry(Command::Save, Group::File, "Save", icons::FLOPPY_DISK, ctrl(Key::S)),
    entry(Command::SaveAs, Group::File, "Save as …", icons::FLOPPY_DISK, ctrl_shift(Key::S)),
    entry(Command::ImportMeasurements, Group::File, "Import measurements …", icons::TABLE, ctrl(Key::I)),
    entry(Command::PlacePhoto, Group::File, "Place a photograph …", icons::IMAGE, ctrl_shift(Key::I)),
    entry(Command::ExportSvg, Group::File, "Export as SVG …", icons::EXPORT, ctrl_shift(Key::V)),
    entry(Command::ExportPng, Group::File, "Export as PNG …", icons::EXPORT, ctrl_shift(Key::E)),
    entry(Command::CopyLink, Group::File, "Copy a link to the scene", icons::LINK, ctrl_shift(Key::C)),
    entry(Command::PasteLink, Group::File, "Open the link that was copied", icons::ARROW_SQUARE_OUT, ctrl_shift(Key::O)),
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
    entry(Command::NextMark, Group::Robot, "Go to the next mark", icons::CARET_RIGHT, key(Key::Period)),
    entry(Command::PreviousMark, Group::Robot, "Go to the mark before", icons::CARET_LEFT, key(Key::Comma)),
    entry(Command::Pin, Group::Robot, "Pin the robot as it is", icons::LOCK_SIMPLE, key(Key::N)),
    entry(Command::Load, Group::Robot, "Set the load or the pull", icons::GAUGE, key(Key::L)),
    entry(Command::Mechanics, Group::Robot, "Switch between sliding cable and paper’s model", icons::REPEAT, key(Key::M)),
    entry(Command::Compare, Group::View, "Draw both models", icons::COPY, key(Key::O)),
    entry(Command::Fit, Group::View, "Show everything", icons::CORNERS_OUT, key(Key::F)),
    entry(Command::ViewPlane, Group::View, "Show the plane", icons::SQUARE, key(Key::Num1)),
    entry(Command::ViewSpace, Group::View, "Show the robot in space", icons::CUBE, key(Key::Num2)),
    entry(Command::ViewBoth, Group::View, "Show plane and space side by side", icons::COLUMNS, key(Key::Num3)),
    entry(Command::Outline, Group::View, "Show or hide the outline", icons::LIST, ctrl(Key::B)),
    entry(Command::Dock, Group::View, "Show or hide the plots", icons::CHART_LINE, ctrl(Key::J)),
    entry(Command::GroupPlots, Group::View, "Group the plots in tabs", icons::SIDEBAR, None),
    entry(Command::SpreadPlots, Group::View, "Show all plots at once, or group them", icons::CHART_BAR, key(Key::A)),
    entry(Command::Field, Group::View, "Show or hide the clearance field", icons::WAVES, key(Key::C)),
    entry(Command::Grid, Group::View, "Show or hide the grid", icons::GRID_FOUR, key(Key::G)),
    entry(Command::Trace, Group::View, "Show or hide the tip's trace", icons::PATH, key(Key::T)),
    entry(Command::Larger, Group::View, "Enlarge everything", icons::PLUS, ctrl(Key::Plus)),
    entry(Command::Smaller, Group::View, "Make everything smaller", icons::MINUS, ctrl(Key::Minus)),
    entry(Command::UsualSize, Group::View, "Usual size", icons::TEXT_AA, ctrl(Key::Num0)),
    entry(Command::Theme, Group::View, "Change between light and dark", icons::MOON, ctrl_shift(Key::L)),
    entry(Command::Palette, Group::Help, "Search all commands", icons::MAGNIFYING_GLASS, ctrl(Key::K)),
    entry(Command::Settings, Group::Help, "Settings", icons::GEAR_SIX, ctrl(Key::Comma)),
    entry(Command::Help, Group::Help, "Help", icons::QUESTION, key(Key::F1)),
];

/// Keys that other programs have accustomed people to.
const ALIASES: &[(Command, Option<KeyboardShortcut>)] = &[
    (Command::Palette, ctrl_shift(Key::P)),
    (Command::Redo, ctrl(Key::Y)),
    (Command::Help, key(Key::Questionmark)),
    (Command::Larger, ctrl(Key::Equals)),
    (Command::Delete, key(Key::Backspace)),
];

impl Command {
    /// What there is to know of the command.
    pub fn entry(self) -> &'static Entry {
        let found = ALL.iter().find(|entry| entry.command == self);
        found.unwrap_or(&ALL[0])
    }

    /// The title with the shortcut, as for a tip.
    pub fn tip(self, ctx: &Context) -> String {
        self.tip_saying(self.entry().title, ctx)
    }

    /// Other words than the title with the shortcut.
    pub fn tip_saying(self, words: &str, ctx: &Context) -> String {
        match &self.entry().shortcut {
            Some(keys) => format!("{words} ({})", ctx.format_shortcut(keys)),
            None => words.to_owned(),
        }
    }
}

/// The commands whose keys were pressed. Keys without Ctrl count only while no
/// text is being written, and Escape first closes an open menu or leaves a field.
pub fn pressed(ctx: &Context) -> Vec<Command> {
    let writing = ctx.text_edit_focused();
    // Escape has already taken the focus from a field, which is to see the key.
    let was_writing = ctx.data_mut(|data| {
        let known = data.get_temp_mut_or_default::<bool>(Id::unique("writing"));
        std::mem::replace(known, writing)
    });
    let menu = Popup::is_any_open(ctx);
    let listed = ALL.iter().map(|entry| (entry.command, entry.shortcut));
    let mut keys: Vec<_> = listed.chain(ALIASES.iter().copied()).collect();
    // Longer combinations first: Ctrl+Shift+Z is not Ctrl+Z.
    keys.sort_by_key(|(_, keys)| !keys.is_some_and(|keys| keys.modifiers.shift));
    ctx.input_mut(|input| {
        let mut found = Vec::new();
        for (command, keys) in keys {
            if let Some(keys) = &keys
                && (keys.modifiers.command || !writing)
                && !((menu || was_writing) && keys.logical_key == Key::Escape)
                && input.consume_shortcut(keys)
            {
                found.push(command);
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
            for (_, alias) in ALIASES {
                assert_ne!(*alias, entry.shortcut, "{}", entry.title);
            }
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
