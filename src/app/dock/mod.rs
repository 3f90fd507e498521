//! The dock on the right: plots and tables in tabs, which can be dragged to
//! where they are wanted.

pub mod tables;

use super::commands::Command;
use super::files;
use super::platform::Errand;
use super::plots::{Link, Plot, PlotAction, PlotCache, PlotData};
use super::workbench::{Hovered, Playing, Selection, Workbench};
use crate::equilibrium::Occurrence;
use crate::forces::{Statics, Window};
use crate::units::{METRES_PER_MM, millimetres};
use eframe::egui::{
    Align, Color32, Frame, Id, Layout, Margin, ScrollArea, Stroke, Style, Ui, Visuals, WidgetText,
    vec2,
};
use egui_tiles::{
    Behavior, SimplificationOptions, TabState, Tile, TileId, Tiles, Tree, UiResponse,
};
use serde::{Deserialize, Serialize};

/// A dock that is lower than this, in points, shows one pane at a time.
const LOW: f32 = 460.0;
/// Groups are no lower than this, in points: more than there is room for scroll.
const LEAST: f32 = 190.0;

/// Something in the dock.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Pane {
    /// A plot.
    Plot(Plot),
    /// The table of contacts.
    Contacts,
    /// The table of obstacles.
    Obstacles,
}

impl Pane {
    fn title(self) -> &'static str {
        match self {
            Pane::Plot(plot) => plot.title(),
            Pane::Contacts => "Contacts",
            Pane::Obstacles => "Obstacles",
        }
    }
}

/// The dock's panes and what their plots have computed.
pub struct Dock {
    tree: Tree<Pane>,
    /// All panes in one group, for where there is no room for more.
    stack: Tree<Pane>,
    cache: PlotCache,
    /// The pulls that lines are fitted on, once a hand has dragged them …
    window: Option<Window>,
    /// … in this document, see [`Workbench::opened`].
    opened: u64,
    statics: Forces,
}

/// The forces on a shape, computed once.
#[derive(Default)]
struct Forces {
    revision: Option<u64>,
    statics: Option<Statics>,
}

impl Default for Dock {
    fn default() -> Self {
        Self {
            tree: arranged(&groups()),
            stack: arranged(&[groups().concat()]),
            cache: PlotCache::default(),
            window: None,
            opened: 0,
            statics: Forces::default(),
        }
    }
}

impl Forces {
    /// Computes the forces anew if the shape has changed.
    fn refresh(&mut self, bench: &Workbench) {
        let revision = Some(bench.live.revision());
        if self.revision == revision {
            return;
        }
        self.revision = revision;
        let stiffness = bench.document.stiffness();
        let solution = bench.live.solution().filter(|_| bench.live.is_settled());
        self.statics = stiffness
            .zip(solution)
            .map(|(stiffness, solved)| Statics::of(solved, stiffness));
    }
}

/// The pulls that lines are fitted on before a hand drags them: until something touches,
/// as far as the paper's.
fn before_contact(bench: &Workbench) -> Window {
    let paper = 10.0 * METRES_PER_MM;
    let events = bench.live.path().into_iter().flat_map(|path| &path.events);
    let made = events.filter(|event| matches!(event.what, Occurrence::ContactMade { .. }));
    let made = made.map(|event| event.pull);
    // A contact that there is from the start leaves nothing to fit.
    let first = made
        .filter(|pull| *pull > 0.01 * paper)
        .fold(paper, f64::min);
    Window {
        first: 0.0,
        last: first,
    }
}

/// Groups of panes below each other.
fn rows(tree: &Tree<Pane>) -> usize {
    let root = tree.root.and_then(|root| tree.tiles.get(root));
    match root {
        Some(Tile::Container(egui_tiles::Container::Linear(rows)))
            if rows.dir == egui_tiles::LinearDir::Vertical =>
        {
            rows.children.len()
        }
        _ => 1,
    }
}

/// Where the panes are.
pub type Arrangement = Tree<Pane>;

impl Dock {
    /// Groups the panes in tabs, as they are at first.
    pub fn group(&mut self) {
        self.tree = arranged(&groups());
    }

    /// Shows all plots at once, the tables behind the last, or groups them again.
    pub fn spread(&mut self) {
        if rows(&self.tree) >= Plot::ALL.len() {
            self.group();
            return;
        }
        let plots = Plot::ALL.map(|plot| vec![Pane::Plot(plot)]);
        let mut groups = plots.to_vec();
        if let Some(last) = groups.last_mut() {
            last.extend([Pane::Contacts, Pane::Obstacles]);
        }
        self.tree = arranged(&groups);
    }

    /// Where the panes are.
    pub fn arrangement(&self) -> &Arrangement {
        &self.tree
    }

    /// Puts the panes where they were once, if that is a place for each of
    /// them.
    pub fn arrange(&mut self, arrangement: Arrangement) {
        let all: Vec<Pane> = groups().concat();
        let panes = arrangement.tiles.tiles().filter_map(|tile| match tile {
            Tile::Pane(pane) => Some(*pane),
            Tile::Container(_) => None,
        });
        let panes: Vec<Pane> = panes.collect();
        if panes.len() == all.len() && all.iter().all(|pane| panes.contains(pane)) {
            self.tree = arrangement;
        }
    }
}

/// The panes in groups, the paper's figures in front.
fn groups() -> [Vec<Pane>; 3] {
    [
        vec![
            Pane::Plot(Plot::Multipliers),
            Pane::Plot(Plot::Tension),
            Pane::Plot(Plot::Bends),
            Pane::Contacts,
        ],
        vec![Pane::Plot(Plot::Tip), Pane::Plot(Plot::Energy)],
        vec![
            Pane::Plot(Plot::Force),
            Pane::Plot(Plot::Load),
            Pane::Obstacles,
        ],
    ]
}

/// Groups of tabs below each other.
fn arranged(groups: &[Vec<Pane>]) -> Arrangement {
    let mut tiles = Tiles::default();
    let groups = groups.iter().map(|panes| {
        let panes = panes.iter().copied();
        let panes: Vec<TileId> = panes.map(|pane| tiles.insert_pane(pane)).collect();
        tiles.insert_tab_tile(panes)
    });
    let groups = groups.collect();
    let root = tiles.insert_vertical_tile(groups);
    Tree::new(Id::unique("dock"), root, tiles)
}

/// Shows the dock in all the room there is.
pub fn show(ui: &mut Ui, dock: &mut Dock, bench: &mut Workbench) {
    dock.statics.refresh(bench);
    if dock.opened != bench.opened {
        dock.opened = bench.opened;
        dock.window = None;
    }
    let window = dock.window.unwrap_or_else(|| before_contact(bench));
    let link = Link {
        hovered: bench.hovered,
        hovering: Hovered::Nothing,
        pull: None,
        window,
        calibrate: None,
    };
    let mut shown = Shown {
        bench,
        cache: &mut dock.cache,
        statics: dock.statics.statics.as_ref(),
        link,
        actions: Vec::new(),
    };
    let tree = if ui.available_height() < LOW {
        &mut dock.stack
    } else {
        &mut dock.tree
    };
    let least = LEAST * rows(tree) as f32;
    if ui.available_height() >= least {
        tree.ui(&mut shown, ui);
    } else {
        ScrollArea::vertical()
            .id_salt("dock")
            .auto_shrink([false, false])
            .show(ui, |ui| {
                let size = vec2(ui.available_width(), least);
                let layout = Layout::top_down(Align::Min);
                ui.allocate_ui_with_layout(size, layout, |ui| {
                    ui.set_min_size(size);
                    tree.ui(&mut shown, ui);
                });
            });
    }
    let Shown { link, actions, .. } = shown;
    if link.window != window {
        dock.window = Some(link.window);
    }
    heed(bench, link);
    for action in actions {
        act(bench, action);
    }
}

/// Does what a hand did on a plot.
fn heed(bench: &mut Workbench, link: Link) {
    if link.hovering != Hovered::Nothing {
        bench.hovering = link.hovering;
    }
    if let Some(pull) = link.pull {
        bench.set_pull_within_span(millimetres(pull), Playing::Stops);
    }
    if let Some(index) = link.calibrate
        && let Some(measured) = &mut bench.document.scene.measured
    {
        measured.calibration = u32::try_from(index).ok();
    }
}

fn act(bench: &mut Workbench, action: PlotAction) {
    match action {
        PlotAction::Save {
            name,
            extension,
            bytes,
        } => files::export::plot(bench, &name, extension, bytes),
        PlotAction::AskStiffness => bench.selection = Selection::Robot,
        PlotAction::AskReading => files::pick(bench, Errand::Measurements),
        PlotAction::Slide => {
            if bench.allows(Command::Mechanics) {
                bench.commands.push(Command::Mechanics);
            }
        }
    }
}

/// The panes with what they show and what is done on them.
struct Shown<'a> {
    bench: &'a mut Workbench,
    cache: &'a mut PlotCache,
    /// The forces, where the stiffness is known.
    statics: Option<&'a Statics>,
    link: Link,
    actions: Vec<PlotAction>,
}

impl Behavior<Pane> for Shown<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        let margin = Margin::symmetric(12, 8);
        Frame::new().inner_margin(margin).show(ui, |ui| match pane {
            Pane::Plot(plot) => self.plot(ui, *plot),
            Pane::Contacts => {
                ScrollArea::both().show(ui, |ui| {
                    tables::contacts(ui, self.bench, self.statics);
                });
            }
            Pane::Obstacles => {
                ScrollArea::both().show(ui, |ui| tables::obstacles(ui, self.bench));
            }
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> WidgetText {
        pane.title().into()
    }

    fn tab_bar_height(&self, _style: &Style) -> f32 {
        32.0
    }

    fn gap_width(&self, _style: &Style) -> f32 {
        1.0
    }

    fn tab_title_spacing(&self, _visuals: &Visuals) -> f32 {
        10.0
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions {
            all_panes_must_have_tabs: true,
            ..SimplificationOptions::default()
        }
    }

    fn tab_bar_color(&self, visuals: &Visuals) -> Color32 {
        visuals.panel_fill
    }

    fn tab_bg_color(
        &self,
        visuals: &Visuals,
        _tiles: &Tiles<Pane>,
        _tile: TileId,
        tab: &TabState,
    ) -> Color32 {
        if tab.active {
            visuals.widgets.hovered.bg_fill
        } else {
            visuals.panel_fill
        }
    }

    fn tab_outline_stroke(
        &self,
        _visuals: &Visuals,
        _tiles: &Tiles<Pane>,
        _tile: TileId,
        _tab: &TabState,
    ) -> Stroke {
        Stroke::NONE
    }

    fn tab_bar_hline_stroke(&self, visuals: &Visuals) -> Stroke {
        Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color)
    }

    fn tab_text_color(
        &self,
        visuals: &Visuals,
        _tiles: &Tiles<Pane>,
        _tile: TileId,
        tab: &TabState,
    ) -> Color32 {
        if tab.active {
            visuals.text_color()
        } else {
            visuals.weak_text_color()
        }
    }
}

impl Shown<'_> {
    fn plot(&mut self, ui: &mut Ui, plot: Plot) {
        self.bench.models.wanted |= plot == Plot::Force;
        let live = &self.bench.live;
        let data = PlotData {
            scene: &self.bench.document.scene,
            asked: live.problem(),
            solved: &live.solved(),
            path: live.path().map(|path| &**path),
            models: self.bench.models.followed(),
            models_generation: self.bench.models.revision(),
            pins: self.bench.pins.all(),
            walked: self.bench.load_trace.steps(),
            cable: self.bench.cable(),
            scale: live.drawing().scale,
            window: self.link.window,
            shape_generation: live.revision(),
            path_generation: live.path_revision(),
        };
        let action = super::plots::show(ui, plot, &data, self.cache, &mut self.link);
        self.actions.extend(action);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn lines_are_fitted_until_something_touches() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        bench.poll();
        let window = before_contact(&bench);
        let events = &bench.live.path().unwrap().events;
        let mut touched = events.iter().map(|event| event.pull);
        assert!(touched.any(|pull| pull == window.last), "{window:?}");
        assert!(window.first == 0.0 && window.last < 5.35e-3, "{window:?}");
        // Where nothing does, as far as the paper's.
        let mut bench = Workbench::with(Scene::default());
        bench.poll();
        assert_eq!(before_contact(&bench).last, 10.0 * METRES_PER_MM);
    }
}
