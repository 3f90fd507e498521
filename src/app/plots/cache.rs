//! What the plots draw, in the units of their axes, computed when it changes.

use super::data::PlotData;
use super::marks::{self, Happening};
use crate::app::workbench::{Assumed, nodes_of_stretch};
use crate::contact::Class;
use crate::explore::{LoadCurve, Path, usual_end};
use crate::forces::{Rates, Sections, Sweep, VirtualWork, VirtualWorkError, Window};
use crate::mechanics::Slip;
use crate::robot::Line;
use crate::scene::ForceReading;
use crate::units::{degrees, grams, millimetres, newtons, per_millimetre};
use egui_plot::PlotPoint;

/// Pulls of the free robot's lines in a window.
const FREE_PULLS: usize = 41;

/// Everything the plots draw, kept from frame to frame.
#[derive(Default)]
pub struct PlotCache {
    pub(super) shape: Shape,
    pub(super) along: AlongPull,
    pub(super) fits: Fits,
    pub(super) forces: Forces,
    /// The generation of the shape and of the path, whether there is a path.
    keys: Option<(u64, u64, bool)>,
    force_keys: Option<ForceKeys>,
}

/// All that the forces depend on besides the path.
#[derive(PartialEq)]
struct ForceKeys {
    stiffness: Option<f64>,
    readings: Vec<ForceReading>,
    calibration: Option<usize>,
    window: Window,
    models: u64,
}

/// The present shape.
#[derive(Default)]
pub(super) struct Shape {
    pub stems: Vec<Stem>,
    /// The greatest multiplier, in rad²/mm.
    pub greatest: f64,
    /// Bends and shears by segment from 1, in degrees: the corners of steps.
    pub bends: Vec<PlotPoint>,
    pub shears: Vec<PlotPoint>,
    /// The bend of the free robot, in degrees.
    pub free_bend: f64,
    /// How the cables pull, in their order.
    pub pulls: Vec<Pull>,
}

/// How a cable pulls along the robot.
#[derive(Default)]
pub(super) struct Pull {
    /// The tension of each stretch, base first, in N or, where the stiffness is not
    /// known, in rad²/m.
    pub levels: Vec<f64>,
    /// Disks that a stretch spans: less than one of a link in the paper's model.
    pub per_stretch: f64,
    pub is_slack: bool,
    /// How the cable went through the hole before each stretch; nothing where it does
    /// not rub.
    pub slips: Vec<Slip>,
}

impl Pull {
    /// The disks, from 0 at the base, that a stretch is between.
    pub fn ends(&self, stretch: usize) -> [f64; 2] {
        [stretch, stretch + 1].map(|end| end as f64 * self.per_stretch)
    }

    /// Where a hole is: its disk, and the tension between those on its two sides.
    pub fn hole(&self, hole: usize) -> Option<(f64, f64)> {
        let beyond = *self.levels.get(hole)?;
        let below = hole.checked_sub(1).map(|below| self.levels[below]);
        let level = 0.5 * (below.unwrap_or(beyond) + beyond);
        Some((self.ends(hole)[0], level))
    }

    /// The corners of a curve that is level along each stretch.
    pub fn steps(&self, factor: f64) -> Vec<PlotPoint> {
        let levels = self.levels.iter().enumerate();
        let corners = levels.flat_map(|(stretch, level)| {
            self.ends(stretch)
                .map(|end| PlotPoint::new(end, factor * level))
        });
        corners.collect()
    }
}

/// The side of the robot that a contact is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Cable,
    Backbone,
}

impl Side {
    pub fn of(line: Line) -> Self {
        match line {
            Line::Cable | Line::CableLink | Line::RimCableSide => Side::Cable,
            Line::Backbone | Line::BackboneLink | Line::RimFarSide | Line::DiskFace => {
                Side::Backbone
            }
        }
    }
}

/// A multiplier.
#[derive(Clone, Copy)]
pub(super) struct Stem {
    /// Its index among the solution's contacts.
    pub contact: usize,
    /// The node, or where between two on a link.
    pub at: f64,
    pub side: Side,
    /// What of the robot touches, in a word or two.
    pub part: &'static str,
    /// In rad²/mm; 0 for a contact that grazes.
    pub multiplier: f64,
    /// As a share of the scale that forces are drawn by.
    pub share: f64,
    pub twin: Twin,
}

/// Whether there is another stem at the same node.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Twin {
    None,
    OtherSide,
}

/// The path, by smooth pieces.
#[derive(Default)]
pub(super) struct AlongPull {
    pub pieces: Vec<Piece>,
    pub marks: Vec<Happening>,
}

/// A smooth piece of the path over the pull, in mm.
pub(super) struct Piece {
    /// Displacement of the tip, in mm.
    pub x: Vec<PlotPoint>,
    pub y: Vec<PlotPoint>,
    /// Its turn, counterclockwise, in degrees.
    pub slope: Vec<PlotPoint>,
    /// J, in rad².
    pub energy: Vec<PlotPoint>,
}

impl AlongPull {
    /// The value of a curve at a pull in mm; after a jump, where there are two.
    pub fn value(&self, of: fn(&Piece) -> &Vec<PlotPoint>, pull: f64) -> Option<f64> {
        let mut pieces = self.pieces.iter().rev();
        pieces.find_map(|piece| value_at(of(piece), pull))
    }
}

/// Lines through the window.
#[derive(Default)]
pub(super) struct Fits {
    /// Through the path; `None` without a path.
    pub path: Option<Result<Rates, VirtualWorkError>>,
    /// Through the free robot, which virtual work takes its rates from.
    pub free: Option<Result<Rates, VirtualWorkError>>,
}

/// Force against load, in grams.
#[derive(Default)]
pub(super) struct Forces {
    /// By multipliers, where the stiffness and the path are known.
    pub curve: Option<LoadCurve>,
    /// Its total, by smooth pieces.
    pub total: Vec<Vec<PlotPoint>>,
    /// The same in other models.
    pub others: Vec<(Assumed, Vec<Vec<PlotPoint>>)>,
    /// The load on the first cable over its pull, in mm, in N or, where the stiffness is
    /// not known, in rad²/m; by smooth pieces.
    pub loads: Vec<Vec<PlotPoint>>,
    /// The greatest load before the last few shapes of a branch, which need more
    /// without bound.
    pub widest_load: f64,
    /// By virtual work, where a reading fixes μ.
    pub work: Option<Result<VirtualWork, VirtualWorkError>>,
    /// What is outside the estimate's assumptions, a sentence each.
    pub caveats: Vec<String>,
    /// The greatest load that is worth showing.
    pub widest: f64,
}

impl PlotCache {
    /// Computes what has changed.
    pub fn refresh(&mut self, data: &PlotData<'_>) {
        let path = data.path.filter(|path| !path.states.is_empty());
        let keys = (data.shape_generation, data.path_generation, path.is_some());
        let shape_is_known = self.keys.is_some_and(|known| known.0 == keys.0);
        let path_is_known = self
            .keys
            .is_some_and(|known| (known.1, known.2) == (keys.1, keys.2));
        self.keys = Some(keys);
        if !shape_is_known {
            self.shape.fill(data);
        }
        if !path_is_known {
            self.along = path.map_or_else(AlongPull::default, |path| AlongPull::of(path, data));
        }
        let stiffness = data.stiffness();
        let known = self.force_keys.as_ref();
        let forces_are_known = path_is_known
            && known.is_some_and(|known| {
                known.stiffness == stiffness.map(|s| s.value())
                    && known.readings == data.readings()
                    && known.calibration == data.calibration()
                    && known.window == data.window
                    && known.models == data.models_generation
            });
        if !forces_are_known {
            self.force_keys = Some(ForceKeys {
                stiffness: stiffness.map(|stiffness| stiffness.value()),
                readings: data.readings().to_vec(),
                calibration: data.calibration(),
                window: data.window,
                models: data.models_generation,
            });
            self.fits = Fits::of(data, path);
            self.forces = Forces::of(data, path, &self.fits);
        }
    }
}

impl Shape {
    fn fill(&mut self, data: &PlotData<'_>) {
        let solution = data.solved;
        let multiplier = |contact: &crate::contact::Contact| match contact.class {
            Class::Pressing => per_millimetre(contact.multiplier),
            Class::Grazing => 0.0,
        };
        let contacts = solution.contacts.iter();
        self.greatest = contacts.map(multiplier).fold(0.0, f64::max);
        self.stems.clear();
        for (index, contact) in solution.contacts.iter().enumerate() {
            let link = matches!(contact.line, Line::BackboneLink | Line::CableLink);
            let node = contact.node as f64;
            let multiplier = multiplier(contact);
            self.stems.push(Stem {
                contact: index,
                at: if link {
                    node - 1.0 + contact.along
                } else {
                    node
                },
                side: Side::of(contact.line),
                part: match contact.line {
                    Line::Cable | Line::CableLink => "cable",
                    Line::Backbone | Line::BackboneLink => "backbone",
                    Line::RimCableSide => "cable-side rim",
                    Line::RimFarSide => "far rim",
                    Line::DiskFace => "disk",
                },
                multiplier,
                share: match contact.class {
                    Class::Pressing => data.scale.of(contact),
                    Class::Grazing => 0.0,
                },
                twin: Twin::None,
            });
        }
        for index in 0..self.stems.len() {
            let Stem { at, side, .. } = self.stems[index];
            let mut others = self.stems.iter();
            if others.any(|other| other.at == at && other.side != side) {
                self.stems[index].twin = Twin::OtherSide;
            }
        }
        steps(&mut self.bends, &solution.bends);
        steps(&mut self.shears, &solution.shears);
        self.free_bend = degrees(data.free_bend());
        self.pulls = pulls(data);
    }
}

/// How the cables pull; nothing without a shape.
fn pulls(data: &PlotData<'_>) -> Vec<Pull> {
    let (solved, problem) = (data.solved, data.problem());
    if solved.nodes.is_empty() {
        return Vec::new();
    }
    let per_bend = data.stiffness().map_or(1.0, |ei| ei.per_bend(problem));
    let tensions = Sections::of(solved, per_bend).tensions;
    let bay = problem.robot().segments_per_bay as f64;
    let per_stretch = nodes_of_stretch(problem, 0).len() as f64 / bay;
    let tensions = tensions.into_iter().zip(&solved.cables);
    let friction = &solved.drive.friction;
    let rubs = friction.holes > 0.0 || friction.base_loss > 0.0;
    let mut slips = solved.strands.iter().filter(|_| rubs);
    tensions
        .map(|(levels, state)| Pull {
            levels,
            per_stretch,
            is_slack: state.is_slack,
            slips: match slips.next() {
                Some(strand) if !state.is_slack => strand.slips.clone(),
                _ => Vec::new(),
            },
        })
        .collect()
}

/// The corners of a curve that is level over each segment, in degrees.
fn steps(corners: &mut Vec<PlotPoint>, angles: &[f64]) {
    corners.clear();
    for (index, angle) in angles.iter().enumerate() {
        let segment = (index + 1) as f64;
        corners.push(PlotPoint::new(segment - 0.5, degrees(*angle)));
        corners.push(PlotPoint::new(segment + 0.5, degrees(*angle)));
    }
}

impl AlongPull {
    fn of(path: &Path, data: &PlotData<'_>) -> Self {
        let straight = data.problem().robot().base;
        let tip = straight.position + data.problem().length() * straight.normal();
        let over = |piece: &[crate::explore::PathState],
                    of: &dyn Fn(&crate::explore::PathState) -> f64| {
            let points = piece.iter();
            points
                .map(|state| PlotPoint::new(millimetres(state.pull), of(state)))
                .collect()
        };
        let pieces = path.pieces().map(|piece| Piece {
            x: over(piece, &|s| millimetres(s.tip.position.x - tip.x)),
            y: over(piece, &|s| millimetres(s.tip.position.y - tip.y)),
            slope: over(piece, &|s| degrees(s.tip.angle - straight.angle)),
            energy: over(piece, &|s| s.energy),
        });
        Self {
            pieces: pieces.collect(),
            marks: marks::of(path, data),
        }
    }
}

impl Fits {
    fn of(data: &PlotData<'_>, path: Option<&Path>) -> Self {
        let window = data.window;
        let tip = data.problem().robot().segments;
        let pulls = Sweep::pulls(window.first, window.last, FREE_PULLS);
        Self {
            path: path.map(|path| Rates::fit(&path.tip_sweep(tip), window)),
            free: Some(Rates::fit(&Sweep::free(data.problem(), &pulls), window)),
        }
    }
}

impl Forces {
    /// The load on the first cable at a pull in mm; after a jump, where there are two.
    pub fn load_at(&self, pull: f64) -> Option<f64> {
        let mut pieces = self.loads.iter().rev();
        pieces.find_map(|piece| value_at(piece, pull))
    }

    fn of(data: &PlotData<'_>, path: Option<&Path>, fits: &Fits) -> Self {
        let curve = match (path, data.stiffness()) {
            (Some(path), Some(stiffness)) => Some(LoadCurve::of(path, data.problem(), stiffness)),
            _ => None,
        };
        let points = curve.iter().flat_map(|curve| &curve.points);
        let others = data.stiffness().into_iter().flat_map(|stiffness| {
            data.models.iter().map(move |it| {
                let curve = LoadCurve::of(&it.path, &it.problem, stiffness);
                (it.assumed, totals(&curve))
            })
        });
        let per_bend = data.stiffness();
        let per_bend = per_bend.map_or(1.0, |ei| ei.per_bend(data.problem()));
        let pieces = path.into_iter().flat_map(Path::pieces);
        let loads: Vec<Vec<PlotPoint>> = pieces
            .map(|piece| {
                let states = piece.iter();
                states
                    .map(|s| PlotPoint::new(millimetres(s.pull), per_bend * s.load()))
                    .collect()
            })
            .collect();
        let robot = data.problem().robot();
        let reading = data.calibration().map(|index| data.readings()[index]);
        let work = reading.zip(fits.free).map(|(reading, rates)| {
            let (load, force) = (newtons(reading.load_g), newtons(reading.force_g));
            VirtualWork::calibrated(robot.offset, rates?, load, force)
        });
        let caveats = match &work {
            Some(Ok(work)) => work
                .caveats(robot.segments)
                .iter()
                .map(|caveat| format!("{caveat}."))
                .collect(),
            Some(Err(error)) => vec![error.to_string()],
            None => Vec::new(),
        };
        let read = data.readings().iter().map(|reading| reading.load_g);
        let read = 1.2 * read.fold(0.0, f64::max);
        let reached = usual_end(points.map(|point| grams(point.load)));
        Self {
            total: curve.as_ref().map(totals).unwrap_or_default(),
            others: others.collect(),
            widest: if read > 0.0 { read } else { reached },
            widest_load: usual_end(loads.iter().flatten().map(|point| point.y)),
            loads,
            work,
            caveats,
            curve,
        }
    }
}

/// All forces over the load, in grams, by smooth pieces.
fn totals(curve: &LoadCurve) -> Vec<Vec<PlotPoint>> {
    let pieces = curve.points.chunk_by(|a, b| a.branch == b.branch);
    let pieces = pieces.map(|piece| {
        let points = piece.iter();
        points
            .map(|point| PlotPoint::new(grams(point.load), grams(point.total)))
            .collect()
    });
    pieces.collect()
}

/// The value of a curve at an abscissa, straight between its points.
pub(super) fn value_at(points: &[PlotPoint], x: f64) -> Option<f64> {
    let after = points.partition_point(|point| point.x < x);
    let b = points.get(after)?;
    let Some(a) = after.checked_sub(1).map(|before| points[before]) else {
        return (b.x == x).then_some(b.y);
    };
    let t = (x - a.x) / (b.x - a.x);
    Some((1.0 - t) * a.y + t * b.y)
}
