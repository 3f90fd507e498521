//! The record of contact forces against loads: by virtual work (eq. 11) and,
//! where the stiffness is known, by multipliers.
//!
//! Loads count from contact, as the paper's P_l. Forces are those of the robot
//! on the obstacle, unless their name says otherwise.

use serde::Serialize;

use super::statics::{Balance, Base};
use crate::contact::Contact;
use crate::forces::{LineFit, Loaded as Reached};
use crate::math::shortest;
use crate::units::{grams, millimetres, per_millimetre};

/// The version of the keys below.
pub const SCHEMA: &str = "sinew-force-2";

/// The word of the paper's mechanics, which alone has virtual work.
const EQUAL: &str = "equal";

/// Forces against loads, in the order of its keys in JSON.
#[derive(Serialize)]
pub struct Forces {
    /// The version of the keys.
    pub schema: &'static str,
    /// What the scene is called.
    pub title: String,
    /// `sliding` or `equal`, as in the scene.
    pub mechanics: &'static str,
    /// In the paper's model, where the robot gets through the window.
    #[serde(flatten)]
    pub virtual_work: Option<ByVirtualWork>,
    /// At `pull_mm`.
    pub contacts: Vec<Share>,
    /// The scene's own pull, or the last before it that the robot gets to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pull_mm: Option<f64>,
    /// Where the stiffness is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by_multipliers: Option<ByMultipliers>,
    /// Where the stiffness is known: a cable that slides without friction, beside the
    /// paper's model and beside one that rubs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frictionless: Option<Frictionless>,
    /// The loads that are reached.
    pub loads: Vec<Row>,
    /// Why something is missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// What eq. 11 rests on.
#[derive(Serialize)]
pub struct ByVirtualWork {
    /// The node that presses, from 0 at the base.
    pub node: usize,
    /// Whose motion it is: `free` or `contact`.
    pub motion: &'static str,
    /// The pulls of the lines.
    pub window_mm: [f64; 2],
    /// The line of the node's x, in mm.
    pub x: Line,
    /// The line of the node's y, in mm.
    pub y: Line,
    /// The line of its disk's direction, in degrees, counterclockwise.
    pub slope: Line,
    /// μ = P_y / P_x, a factor that makes the estimate meet a measured point and seldom
    /// a coefficient of friction.
    pub mu: f64,
    /// Where it comes from: an option, a field of the scene, or neither.
    pub mu_from: String,
    /// P_x / P_l.
    pub force_per_load: f64,
    /// Where the estimate leaves its assumptions, a sentence each.
    pub caveats: Vec<String>,
}

/// A straight line over the pull: x and y in mm, the slope in degrees.
#[derive(Serialize)]
pub struct Line {
    /// How steep it is, a mm of pull.
    pub per_mm: f64,
    /// Its value at no pull.
    pub intercept: f64,
    /// The root of the mean squared residual.
    pub rms_residual: f64,
    /// The greatest residual.
    pub max_residual: f64,
    /// R², at most 1.
    pub r_squared: f64,
    /// How many points it goes through.
    pub points: usize,
}

impl Line {
    /// The record of a line over the pull in metres; `unit` turns its values
    /// into those of files.
    pub fn of(fit: &LineFit, unit: fn(f64) -> f64) -> Self {
        Self {
            per_mm: unit(per_millimetre(fit.slope)),
            intercept: unit(fit.intercept),
            rms_residual: unit(fit.rms_residual),
            max_residual: unit(fit.max_residual),
            r_squared: fit.r_squared,
            points: fit.points,
        }
    }
}

/// A contact's force over the cable's tension, which needs no stiffness.
#[derive(Serialize)]
pub struct Share {
    /// The part of the robot and the obstacle, in words.
    pub contact: String,
    /// From 0 at the base.
    pub node: usize,
    /// Its place in the file, from 0.
    pub obstacle: usize,
    /// Not where the cable is slack.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_over_tension: Option<f64>,
}

/// What forces by multipliers rest on.
#[derive(Serialize)]
pub struct ByMultipliers {
    /// The bending stiffness, N mm².
    pub ei_nmm2: f64,
    /// Where it comes from: an option or a field of the scene.
    pub ei_from: &'static str,
    /// The pull at which the robot begins to press; none where it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_pull_mm: Option<f64>,
    /// The tension there, which loads count from.
    pub tension_at_contact_g: f64,
}

/// The same robot with a cable that slides without friction. Its loads count from its
/// own contact.
#[derive(Serialize)]
pub struct Frictionless {
    /// The pull at which it begins to press; none where it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_pull_mm: Option<f64>,
    /// The tension there, which loads count from.
    pub tension_at_contact_g: f64,
}

/// A load with the forces under it.
#[derive(Serialize)]
pub struct Row {
    /// The load P_l.
    pub load_g: f64,
    /// P_x by virtual work, towards the cable's side of the straight robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_x_g: Option<f64>,
    /// P_y by virtual work, along the straight robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_y_g: Option<f64>,
    /// By multipliers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub multipliers: Option<Loaded>,
    /// The sum of the normal forces on obstacles of [`Forces::frictionless`], where it
    /// gets there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frictionless_force_g: Option<f64>,
}

/// The state under a load, by multipliers.
#[derive(Serialize)]
pub struct Loaded {
    /// The pull that the load draws in.
    pub pull_mm: f64,
    /// The cable's tension.
    pub tension_g: f64,
    /// The sum of the normal forces on obstacles.
    pub force_g: f64,
    /// The same, in N.
    pub force_n: f64,
    /// What presses.
    pub contacts: Vec<Pressed>,
    /// What the base exerts on the robot.
    pub base: Option<Base>,
    /// What is left of sums that should vanish.
    pub balance: Option<Balance>,
}

impl Loaded {
    /// The record of a state; `named` gives a contact in words.
    pub fn of(state: &Reached, named: impl Fn(&Contact) -> String) -> Self {
        let statics = &state.statics;
        let total: f64 = statics.contacts.iter().map(|c| c.normal_force).sum();
        let contacts = statics.contacts.iter().map(|force| {
            let contact = &force.contact;
            Pressed {
                contact: named(contact),
                node: contact.node,
                obstacle: contact.obstacle,
                point_mm: [millimetres(contact.point.x), millimetres(contact.point.y)],
                normal: [contact.normal.x, contact.normal.y],
                force_g: grams(force.normal_force),
                on_robot_n: [force.on_robot.x, force.on_robot.y],
            }
        });
        Self {
            pull_mm: millimetres(state.pull),
            tension_g: grams(statics.tension),
            force_g: grams(total),
            force_n: total,
            contacts: contacts.collect(),
            base: Base::of(statics),
            balance: Balance::of(statics),
        }
    }
}

/// A contact with its force.
#[derive(Serialize)]
pub struct Pressed {
    /// The part of the robot and the obstacle, in words.
    pub contact: String,
    /// From 0 at the base.
    pub node: usize,
    /// Its place in the file, from 0.
    pub obstacle: usize,
    /// Of the obstacle's surface, in the scene's frame.
    pub point_mm: [f64; 2],
    /// Out of the obstacle, of length 1.
    pub normal: [f64; 2],
    /// Along the normal.
    pub force_g: f64,
    /// What the obstacle exerts on the robot.
    pub on_robot_n: [f64; 2],
}

impl Forces {
    /// The names of a table's columns, a row a load.
    pub fn columns(&self) -> Vec<&'static str> {
        let mut head = vec!["load_g"];
        if self.mechanics == EQUAL {
            head.extend(["virtual_work_x_g", "virtual_work_y_g"]);
        }
        if self.by_multipliers.is_some() {
            head.extend(["pull_mm", "tension_g", "multipliers_g"]);
        }
        if self.frictionless.is_some() {
            head.push("frictionless_g");
        }
        head
    }

    /// Its rows, every number with all its digits; empty where there is none.
    pub fn rows(&self) -> impl Iterator<Item = Vec<String>> + '_ {
        self.loads.iter().map(|row| {
            let mut fields = vec![Some(row.load_g)];
            if self.mechanics == EQUAL {
                fields.extend([row.force_x_g, row.force_y_g]);
            }
            if let Some(loaded) = &row.multipliers {
                let numbers = [loaded.pull_mm, loaded.tension_g, loaded.force_g];
                fields.extend(numbers.map(Some));
            }
            if self.frictionless.is_some() {
                fields.push(row.frictionless_force_g);
            }
            let written = fields
                .iter()
                .map(|value| value.map_or_else(String::new, shortest));
            written.collect()
        })
    }
}
