//! Fig. 3b, 4a, 4b and 5: shapes, free and among posts, and their multipliers.

use super::ExperimentError;
use super::data::{Backbone, Data, PostMultipliers};
use super::item::{Check, Id, Item};
use super::scenes::{PaperScene, picture, solved_at};
use super::window::pull_window;
use crate::equilibrium::{Solution, Solved};
use crate::forces::share_of_tension;
use crate::geometry::Vector;
use crate::robot::{Line, part_name};
use crate::units::{millimetres, picometres};

/// Steps, in mm, at which a contact is looked for that stays once it is made; and
/// those, with how far they go, for a pair of contacts that holds over a third
/// of a millimetre only.
const STEP_MM: f64 = 0.25;
const FINE_STEP_MM: f64 = 0.05;
const REACH_MM: f64 = 8.0;

/// Half a digit of 0.75 %, which the paper's text rounds to.
const HALF_A_DIGIT: f64 = 0.005;

const NO_PHOTOGRAPH: &str = "The points of the photograph are not in the text, so that the paper's \
     distance between photograph and computed shape cannot be recomputed. “sinew compare” measures \
     it for points of your own.";

fn neither_pull_nor_photograph(pull_mm: f64) -> Vec<String> {
    vec![
        format!("The text gives no pull for this figure; ours is {pull_mm} mm."),
        NO_PHOTOGRAPH.to_owned(),
    ]
}

pub(super) fn figure_3b() -> Result<Item, ExperimentError> {
    let (scene, problem) = PaperScene::Free.problem()?;
    let robot = *problem.robot();
    let mut backbones = Vec::new();
    let mut worst = 0.0_f64;
    for pull_mm in [2.5, 5.0, 7.5, 10.0] {
        let solved = solved_at(&problem, pull_mm)?;
        worst = worst.max(off_the_arc(&solved));
        backbones.push(Backbone {
            pull_mm,
            points: solved.backbone().collect(),
        });
    }
    let solved = solved_at(&problem, scene.pull_mm())?;
    Ok(Item {
        id: Id::Fig3b,
        title: "Profile of the free robot",
        about:
            "Eq. 4 solved with the paper's 18 segments. Without obstacles its solution is known \
                in closed form: every segment bends by 2 asin(l/(2an)), and the nodes lie on a \
                circle."
                .to_owned(),
        checks: vec![
            Check::near(
                "Nodes of the backbone",
                "",
                19.0,
                solved.nodes.len() as f64,
                0.0,
            )
            .decimals(0),
            Check::near(
                "Error quoted for the photograph, 1.35 mm, over the length",
                "%",
                0.75,
                100.0 * 1.35 / millimetres(robot.length),
                HALF_A_DIGIT,
            ),
            Check::not_given("Distance from the photograph, RMS", "mm", 1.35),
            Check::ours(
                "Greatest distance of a node from the closed form",
                "pm",
                picometres(worst),
            ),
        ],
        data: vec![Data::Backbones(backbones)],
        pictures: vec![picture("robot", &scene, solved)],
        notes: Vec::new(),
        missing: neither_pull_nor_photograph(scene.pull_mm()),
    })
}

/// The greatest distance of a backbone node from where the closed form has it,
/// in metres.
fn off_the_arc(solved: &Solved) -> f64 {
    let problem = solved.problem();
    let robot = problem.robot();
    let n = robot.segments as f64;
    let bend = 2.0 * libm::asin(problem.pull() / (2.0 * robot.offset * n));
    let mut at = robot.base.position;
    let mut worst = 0.0_f64;
    for (i, node) in solved.nodes.iter().enumerate() {
        if i > 0 {
            // The link's direction is the mean of its two disks' normals.
            let angle = (i as f64 - 0.5) * bend;
            at += robot.length / n * Vector::new(libm::sin(angle), libm::cos(angle));
        }
        worst = worst.max((node.position - at).norm());
    }
    worst
}

pub(super) fn figure_4a() -> Result<Item, ExperimentError> {
    let (scene, problem) = PaperScene::OneDisc.problem()?;
    let pull_mm = scene.pull_mm();
    let solved = solved_at(&problem, pull_mm)?;
    let begins = pull_window(&problem, pull_mm, STEP_MM, |s| {
        s.pressing().next().is_some()
    })?
    .ok_or(ExperimentError::NoContact("the post of Fig. 4a"))?;
    let mut checks = vec![
        Check::not_given("Distance from the photograph over the length", "%", 0.58),
        Check::ours(
            "Pull at which the cable meets the post",
            "mm",
            begins.ends_mm().0,
        )
        .decimals(4),
    ];
    checks.extend(contact_checks(&solved));
    Ok(Item {
        id: Id::Fig4a,
        title: "The robot against one post",
        about: format!(
            "Eq. 5 with a post of 30 mm diameter at (44, 104) mm, followed from the straight robot \
             to a pull of {pull_mm} mm."
        ),
        checks,
        data: Vec::new(),
        pictures: vec![picture("robot", &scene, solved)],
        notes: Vec::new(),
        missing: neither_pull_nor_photograph(pull_mm),
    })
}

/// The contacts of the paper's Fig. 4b: cable nodes 10 and 16 here.
const BOTH_POSTS: [(usize, usize); 2] = [(10, 0), (16, 1)];

fn both_posts(solution: &Solution) -> bool {
    let found: Vec<_> = solution
        .pressing()
        .map(|c| (c.line, c.node, c.obstacle))
        .collect();
    found == BOTH_POSTS.map(|(node, obstacle)| (Line::Cable, node, obstacle))
}

pub(super) fn figure_4b() -> Result<Item, ExperimentError> {
    let (scene, problem) = PaperScene::TwoDiscs.problem()?;
    let window = pull_window(&problem, REACH_MM, FINE_STEP_MM, both_posts)?
        .ok_or(ExperimentError::NoContact("the posts of Fig. 4b"))?;
    let (first, last) = window.ends_mm();
    let pull_mm = scene.pull_mm();
    let solved = solved_at(&problem, pull_mm)?;
    let mut checks = post_checks(&solved);
    checks.push(Check::not_given(
        "Distance from the photograph over the length",
        "%",
        0.58,
    ));
    checks.push(
        Check::ours(
            "Both posts press at these nodes from a pull of",
            "mm",
            first,
        )
        .decimals(4),
    );
    checks.push(Check::ours("… to a pull of", "mm", last).decimals(4));
    checks.extend(contact_checks(&solved));
    Ok(Item {
        id: Id::Fig4b,
        title: "The robot against two posts",
        about: format!(
            "Eq. 5 with posts of 25 and 30 mm diameter at (33, 89) and (59, 140) mm. The text gives \
             no pull; bisection with the solver finds that both posts press at the paper's nodes \
             only between {first:.3} and {last:.3} mm. Shown is {pull_mm} mm."
        ),
        checks,
        data: Vec::new(),
        pictures: vec![picture("robot", &scene, solved)],
        notes: Vec::new(),
        missing: neither_pull_nor_photograph(pull_mm),
    })
}

/// Nodes and disks of Fig. 4b's and 5's two contacts, as the paper counts them.
fn post_checks(solved: &Solved) -> Vec<Check> {
    let problem = solved.problem();
    let mut checks = Vec::new();
    for (obstacle, which, node, disk) in [(0, "lower", 11.0, 6.0), (1, "upper", 17.0, 9.0)] {
        let of_post: Vec<_> = solved
            .pressing()
            .filter(|c| c.obstacle == obstacle)
            .collect();
        // The peak: the one that presses hardest.
        let peak = of_post
            .iter()
            .max_by(|a, b| a.multiplier.total_cmp(&b.multiplier));
        let Some(peak) = peak else { continue };
        let bay = problem.robot().segments_per_bay;
        let near = |quantity, paper, ours: usize| {
            Check::near(quantity, "", paper, ours as f64, 0.0).decimals(0)
        };
        checks.push(near(
            format!("Node on the {which} post, from 1"),
            node,
            peak.node + 1,
        ));
        checks.push(near(
            format!("Disk on the {which} post, from 1"),
            disk,
            peak.node / bay + 1,
        ));
    }
    checks
}

/// Each contact's place, and its force over the cable's tension.
fn contact_checks(solved: &Solved) -> Vec<Check> {
    let problem = solved.problem();
    let mut checks = Vec::new();
    for contact in solved.pressing() {
        let part = part_name(problem.robot(), contact.line, contact.node);
        checks.push(Check::ours(
            format!("Contact at {part}: height above the base"),
            "mm",
            millimetres(contact.point.y),
        ));
        if let Some(share) = share_of_tension(solved, contact) {
            checks.push(
                Check::ours(
                    format!("Contact at {part}: force over cable tension"),
                    "",
                    share,
                )
                .decimals(6),
            );
        }
    }
    checks
}

pub(super) fn figure_5() -> Result<Item, ExperimentError> {
    let (scene, problem) = PaperScene::TwoDiscs.problem()?;
    let pull_mm = scene.pull_mm();
    let solved = solved_at(&problem, pull_mm)?;
    let nodes = solved.nodes.len();
    let of_post = |name: &'static str, obstacle: usize| {
        let at = |node: usize| {
            let here = solved
                .pressing()
                .filter(|c| c.obstacle == obstacle && c.node == node && c.line == Line::Cable);
            here.map(|c| c.multiplier).sum()
        };
        PostMultipliers {
            name,
            by_node: (1..nodes).map(at).collect(),
        }
    };
    let posts = vec![of_post("f₁, lower post", 0), of_post("f₂, upper post", 1)];
    Ok(Item {
        id: Id::Fig5,
        title: "Contacts from Lagrange multipliers",
        about: format!(
            "The multipliers of the inequality constraints at a pull of {pull_mm} mm. Nodes that do \
             not touch have exactly none: the active set decides, not a threshold."
        ),
        checks: post_checks(&solved),
        data: vec![Data::Multipliers(posts)],
        pictures: Vec::new(),
        notes: vec![
            "A clearance is measured in millimetres here and the energy is Σ bend², so that a \
             multiplier is the energy that a millimetre more would cost. The paper's constraint is \
             a squared distance, which scales its multipliers by the post's diameter; where they \
             peak does not change."
                .to_owned(),
        ],
        missing: vec![
            "The heights of the figure's peaks are not in the text, and neither is its pull."
                .to_owned(),
        ],
    })
}
