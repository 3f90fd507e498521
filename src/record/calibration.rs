//! The record of constants that were fitted to measured data.

use serde::Serialize;

use crate::experiments::calibration::{
    Calibration as Found, Compared, Constant as Kind, Fitted, Unseparated as Group,
};
use crate::mechanics::Model;
use crate::scene::{Mechanics, Scene};

/// The version of the keys below.
pub const SCHEMA: &str = "sinew-calibration-1";

/// A fit, in the order of its keys in JSON.
#[derive(Serialize)]
pub struct Calibration {
    /// The version of the keys.
    pub schema: &'static str,
    /// What the scene is called.
    pub title: String,
    /// Its program's version.
    pub version: &'static str,
    /// `sliding`: the mechanics that was fitted.
    pub mechanics: &'static str,
    /// What the scene says, `sliding` or `equal`.
    pub scene_mechanics: &'static str,
    /// The constants.
    pub constants: Vec<Constant>,
    /// The correlation of each constant with each, in their order; null where one has
    /// no error.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Groups of constants that the data cannot tell apart.
    pub unseparated: Vec<Unseparated>,
    /// Constants that the data leave open even where the others are known.
    pub open: Vec<&'static str>,
    /// Constants that nothing which was read depends on.
    pub without_effect: Vec<&'static str>,
    /// The root of the mean squared difference of forces; null where none was read.
    pub force_rms_g: Option<f64>,
    /// The same of pulls under weights.
    pub pull_rms_mm: Option<f64>,
    /// Steps of the fit.
    pub iterations: usize,
    /// By row of the measured file.
    pub rows: Vec<Row>,
}

/// A constant.
#[derive(Serialize)]
pub struct Constant {
    /// Its word: `ei`, `holes`, `contacts`, `base_loss`.
    pub name: &'static str,
    /// Its key in a scene, which tells its unit.
    pub key: &'static str,
    /// Its value.
    pub value: f64,
    /// Its standard error; null at a bound, and where nothing depends on it.
    pub error: Option<f64>,
    /// Where the fit started.
    pub start: f64,
    /// Whether the data ask for a value beyond the range of scenes.
    pub at_bound: bool,
}

/// Constants that the data cannot tell apart.
#[derive(Serialize)]
pub struct Unseparated {
    /// Their words.
    pub names: Vec<&'static str>,
    /// An exchange that the data hardly notice, within one standard error: all at once,
    /// with these signs or all the others.
    pub exchange: Vec<Exchange>,
}

/// A constant's part in an exchange.
#[derive(Serialize)]
pub struct Exchange {
    /// Its word.
    pub name: &'static str,
    /// How much it changes, in the unit of its key.
    pub by: f64,
}

/// A row of the measured file.
#[derive(Serialize)]
pub struct Row {
    /// Its line in the file, from 1.
    pub row: usize,
    /// The whole weight on the first cable, given or what would hold its pull.
    pub load_g: f64,
    /// The pull computed.
    pub pull_mm: f64,
    /// The pull that was read under a weight.
    pub read_pull_mm: Option<f64>,
    /// The force on all obstacles computed.
    pub force_g: f64,
    /// The force that was read.
    pub read_force_g: Option<f64>,
}

impl Calibration {
    /// The record of a fit to a scene.
    pub fn of(found: &Found, title: String, scene: &Scene) -> Self {
        let uncertainty = &found.uncertainty;
        let group = |group: &Group| Unseparated {
            names: group.constants.iter().map(|it| it.word()).collect(),
            exchange: group
                .exchange
                .iter()
                .map(|(constant, by)| Exchange {
                    name: constant.word(),
                    by: *by,
                })
                .collect(),
        };
        let words = |of: &[Kind]| of.iter().map(|it| it.word()).collect();
        Self {
            schema: SCHEMA,
            title,
            version: env!("CARGO_PKG_VERSION"),
            mechanics: Model::Sliding.word(),
            scene_mechanics: match scene.model.mechanics {
                Mechanics::Sliding => Model::Sliding.word(),
                Mechanics::Equal => Model::Equal.word(),
            },
            constants: found.constants.iter().map(Constant::of).collect(),
            correlation: uncertainty.correlation.clone(),
            unseparated: uncertainty.unseparated.iter().map(group).collect(),
            open: words(&uncertainty.open),
            without_effect: words(&uncertainty.without_effect),
            force_rms_g: found.force_rms_g,
            pull_rms_mm: found.pull_rms_mm,
            iterations: found.iterations,
            rows: found.rows.iter().map(Row::of).collect(),
        }
    }
}

impl Constant {
    fn of(fitted: &Fitted) -> Self {
        Self {
            name: fitted.constant.word(),
            key: fitted.constant.key(),
            value: fitted.value,
            error: fitted.error,
            start: fitted.start,
            at_bound: fitted.at_bound,
        }
    }
}

impl Row {
    fn of(row: &Compared) -> Self {
        Self {
            row: row.row,
            load_g: row.load_g,
            pull_mm: row.pull_mm,
            read_pull_mm: row.read_pull_mm,
            force_g: row.force_g,
            read_force_g: row.read_force_g,
        }
    }
}
