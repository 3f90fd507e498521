//! Simulation of cable-driven continuum robots in contact with obstacles.
//!
//! This page is the architecture: what there is, where it is and what holds
//! everywhere. For how to use it start at [`equilibrium`], or at the README for
//! the program.
//!
//! # Bird's-eye view
//!
//! A continuum robot is an elastic backbone with disks; cables beside it are
//! drawn in and bend it. In the plane, cut into n segments, its shape is the
//! one of least Σ bend² among all that keep their lengths and stay clear
//! of the obstacles (eq. 5 of the paper that the README names): the length of every
//! link of the cable in the paper's model, of the whole cable where it slides. Sinew
//! finds that shape, what the robot presses on and how hard, and proves it:
//!
//! ```text
//! text ── scene ──▶ Scene ── mechanics ──▶ Problem ── equilibrium ──▶ Solved
//!                                             │                          │
//!                contact, geometry: clearances of obstacles         Certificate
//!                solver: least cost along a chain           view, report, record
//! ```
//!
//! A [`scene::Scene`] is what a file says and may be half-edited nonsense.
//! [`mechanics::Problem`] is made of it once and cannot be wrong. In the paper's model
//! each segment is a four-bar linkage with one degree of freedom, so all length
//! constraints are eliminated exactly and only its turn is unknown; where cables slide
//! the backbone's arcs bend, and a cable's length is one row summed over all of them,
//! whose multiplier is the tension. The [`solver`] minimises
//! along the chain in time proportional to n. [`equilibrium`] follows the shape
//! from the straight robot along what drives it, as a real robot would get there, and
//! certifies where it arrives by other code: in the paper's own coordinates, or by the
//! forces and moments on every section. What it finds is
//! an [`equilibrium::Solution`]; with the problem that it is one of, an
//! [`equilibrium::Solved`], which is all that draws, plots or writes a shape.
//!
//! # Code map
//!
//! Each layer uses those above it in this list, and never one below it;
//! [`solver`] and [`geometry`] do not know each other.
//!
//! - [`units`]: millimetres and degrees at the edge, SI inside.
//! - [`math`]: small numerical tools that know nothing of robots.
//! - [`solver`]: constrained minimisation along a chain of stages (SQP with an
//!   active set on a Riccati recursion).
//! - [`geometry`]: obstacles as outlines; clearances with exact derivatives.
//! - [`scene`]: the scene file: its types, its checks, its schema.
//! - [`robot`]: its dimensions, its parts and their names, the pose of a node.
//! - [`contact`]: the parts that may touch against the obstacles, as rows of eq. 5.
//! - [`mechanics`]: what bends the robot, as a chain, from a scene: the four-bar
//!   linkages of eq. 4 ([`mechanics::Equal`]) and cables that slide
//!   ([`mechanics::Sliding`]), each with its certificate.
//! - [`equilibrium`]: from a problem to a certified solution, step by step.
//! - [`forces`]: newtons, from multipliers with a bending stiffness and from
//!   kinematics by virtual work; the balance of the whole robot.
//! - [`experiments`]: the numbers of the paper's figures and table, measurements
//!   from CSV, measured shapes against computed ones, and stiffness and friction
//!   fitted to measured forces.
//! - [`explore`]: the robot along its whole pull: its path, its jumps, the
//!   forces under every load.
//! - [`study`]: what designs lead to: parameters of a scene, samples of them, and what
//!   is asked of each.
//! - [`record`]: what is written of a result, in the units of files: keys of
//!   JSON, columns of tables, and their versions.
//! - [`solving`]: live requests, of which the newest counts, and in their pauses
//!   tasks, one after the other; all in slices.
//! - [`view`]: a solution as plain draw data: marks in the world and what they
//!   mean, and curves over an axis; the same for every picture.
//! - [`report`]: drawings, charts and pages as the contents of files.
//! - `render`: the clearance field and the robot in space, on the graphics
//!   processor. With the feature `app`.
//! - `app`: the window. With the feature `app`.
//! - `cli`: the command line. With the feature `cli`; both are on by default.
//!
//! The programs over them are thin: `src/main.rs`, and in `src/web` the page's
//! and its solver's, which `web/build` makes. `web/` holds the page around
//! them, the tool that bundles it, and its tests.
//!
//! # Invariants
//!
//! Mostly absences; `tests/layers.rs` holds the first four.
//!
//! - Imports lead downward only.
//! - Below the window and the command line there is no IO, no clock, no thread and no hash
//!   order, and sines and their like come from the crate libm and not from the system: the
//!   same scene gives the same answer, bit for bit, on every run, processor and page
//!   (`tests/same_bits.rs`).
//! - Only [`geometry`] knows parry; the rest sees outlines and clearances.
//! - [`solver`] knows no lengths, angles or obstacles, in words either.
//! - Lengths are in metres and angles in radians. A name that carries a unit
//!   (`length_mm`) is at the edge: scene files, messages, reports.
//! - A faulty scene is a [`scene::SceneError`] that names the field, its value
//!   and its range. How a solve ended is data, an [`equilibrium::Status`],
//!   never an error.
//! - Every converged solution holds an [`mechanics::Certificate`] that was
//!   recomputed from the shape alone, by code that shares nothing with the
//!   solver but the obstacles' clearances.
//! - No shape is reached by moving a part that may touch through an obstacle
//!   (`nodes`, the paper's choice, leaves the links between them out). Where a
//!   branch ends and the robot goes over to another, an [`equilibrium::Event`]
//!   says so.
//! - No `unsafe`, and no `unwrap` outside tests.
//!
//! # Notation
//!
//! Indices count from 0 at the base, the paper's from 1: its node 15 is 14.
//!
//! | paper | here | meaning |
//! |---|---|---|
//! | L_0 | [`robot::Robot::length`] | length of the backbone |
//! | n | [`robot::Robot::segments`] | number of segments |
//! | a | [`robot::Robot::offset`] | cable offset, backbone to cable |
//! | l | [`mechanics::Problem::pull`] | pull, the length of cable drawn in |
//! | l_0 | [`mechanics::FourBar::backbone`] | a segment's backbone link, L_0/n |
//! | l_a | [`mechanics::FourBar::cable`] | a segment's cable link, l_0 − l/n |
//! | x_0 | [`robot::PlanarNode::position`] | a backbone point |
//! | x_a | [`robot::PlanarNode::at`] | a cable point, at the cable offset |
//! | | [`robot::PlanarNode::angle`] | φ, direction of a disk towards the cable |
//! | f(x) | [`contact::RowKind::Contact`] | clearance from an obstacle, ⪰ 0 |
//! | (x_e, y_e, θ_e) | [`equilibrium::Solution::tip`] | the tip |
//! | | [`equilibrium::Solution::bends`] | β, angle between neighbouring disks |
//! | | [`equilibrium::Solution::shears`] | ψ, backbone link against disks |
//! | | [`equilibrium::Solution::turns`] | τ, the one unknown of a segment; b where cables slide |
//! | | [`mechanics::CableState::tension`] | T, of a cable that slides |
//! | | [`equilibrium::Solution::energy`] | J = Σ β², what is minimised |
//! | P_l | [`forces::VirtualWork::force`]'s `load` | the weight on the cable, from contact on |
//! | P_x, P_y | [`forces::PressingForce`] | what the robot exerts on an obstacle |
//! | f′_x, f′_y, f′_θ | [`forces::Rates`] | motion of a node per pull |
//! | μ | [`forces::VirtualWork::friction`] | P_y / P_x |
//! | R_x, R_y, M_r | [`forces::Statics::clamp`] | reaction at the base |
//! | B | [`forces::Stiffness`] | EI, bending stiffness |
//! | | [`forces::Statics::tension`] | T = (EI/2l_0) dJ/dl |
//! | | [`contact::Contact::multiplier`] | λ, how J rises with the clearance asked for |

#![warn(clippy::unwrap_used, clippy::expect_used)]

#[cfg(feature = "app")]
pub mod app;
#[cfg(feature = "cli")]
pub mod cli;
pub mod contact;
pub mod equilibrium;
pub mod experiments;
pub mod explore;
pub mod forces;
pub mod geometry;
pub mod math;
pub mod mechanics;
pub mod record;
#[cfg(feature = "app")]
pub mod render;
pub mod report;
pub mod robot;
pub mod scene;
pub mod solver;
pub mod solving;
pub mod study;
pub mod units;
pub mod view;

/// The README's example, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
