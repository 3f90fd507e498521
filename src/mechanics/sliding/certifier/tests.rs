//! Every condition fails alone where it should, and the second-order one where a closed
//! form says.

use super::super::chain::Sliding;
use super::*;
use crate::contact::Contact;
use crate::geometry::Obstacle;
use crate::mechanics::{CableState, Drive, Mechanics};
use crate::scene::{self, Scene};
use crate::solver::{Outcome, Settings, Sqp, Tunnelling};

/// What a certificate is made of.
#[derive(Clone)]
struct Told {
    problem: Problem,
    nodes: Vec<PlanarNode>,
    contacts: Vec<Contact>,
    cables: Vec<CableState>,
}

impl Told {
    fn failed(&self) -> Vec<Condition> {
        let found = Found {
            nodes: &self.nodes,
            contacts: &self.contacts,
            cables: &self.cables,
            strands: &[],
        };
        let sliding: Sliding<2> = Sliding::new(self.problem.clone());
        let certificate = Certifier::default().certify(&sliding, found);
        let conditions = certificate.conditions();
        let failed = conditions.filter(|(condition, value)| !condition.is_met(*value));
        failed.map(|(condition, _)| condition).collect()
    }
}

/// The robot that leans on two posts.
fn on_two_posts() -> Told {
    let text = include_str!("../../../../assets/scenes/two-posts.toml");
    let problem = Problem::new(&Scene::from_toml(text).unwrap()).unwrap();
    let sliding: Sliding<2> = Sliding::new(problem.clone());
    let mut sqp = Sqp::default();
    let settings = Settings {
        tunnelling: Tunnelling::Allowed,
        ..Settings::default()
    };
    sqp.start(&sliding, &sliding.free_controls(), &[], settings);
    assert_eq!(sqp.run(&sliding), Outcome::Converged);
    let (point, multipliers) = (sqp.point(), sqp.multipliers());
    let shape = point.nodes.as_slice();
    let found = crate::contact::Multipliers {
        multipliers,
        unit: sliding.cost_unit(),
    };
    let (mut contacts, mut cables) = (Vec::new(), Vec::new());
    let around = problem.around();
    around.find_contacts(&point.rows, shape, found, &mut contacts);
    sliding.write_cables(point, multipliers, &mut cables);
    assert_eq!(contacts.len(), 2);
    Told {
        nodes: shape.each().copied().collect(),
        problem,
        contacts,
        cables,
    }
}

#[test]
fn each_condition_fails_where_it_is_spoilt() {
    let told = on_two_posts();
    assert_eq!(told.failed(), []);
    let check = |spoil: &dyn Fn(&mut Told), expected: &[Condition]| {
        let mut spoilt = told.clone();
        spoil(&mut spoilt);
        assert_eq!(spoilt.failed(), expected);
    };
    use Condition::{Complementarity, Dual, Links, Penetration, Stationarity};
    check(&|told| told.cables[0].tension *= 1.000_01, &[Stationarity]);
    check(
        &|told| told.contacts[0].multiplier *= 1.000_1,
        &[Stationarity],
    );
    check(
        &|told| {
            told.contacts.pop();
        },
        &[Stationarity],
    );
    check(
        &|told| told.contacts[1].multiplier *= -1.0,
        &[Stationarity, Dual],
    );
    check(
        &|told| told.contacts[0].normal *= -1.0,
        &[Stationarity, Complementarity],
    );
    check(&|told| told.problem.set_pull(5.550_001e-3), &[Links]);
    check(&|told| told.nodes[7].angle += 1e-7, &[Stationarity, Links]);
    check(
        &|told| told.cables[0].tension *= -1.0,
        &[Stationarity, Dual],
    );
    // What is told to be slack and carries a tension is held to its length.
    check(
        &|told| {
            told.cables[0].is_slack = true;
            told.problem.set_pull(5.549e-3);
        },
        &[Links],
    );
    let moved = |told: &mut Told, by: f64| {
        let post: Obstacle = told.problem.obstacles()[1].clone();
        let normal = told.contacts[1].normal;
        told.problem.set_obstacle(1, post.moved(by * normal));
    };
    check(&|told| moved(told, 1e-8), &[Penetration, Complementarity]);
    check(&|told| moved(told, -1e-8), &[Complementarity]);
}

/// Two opposite cables under loads press the straight robot together. It buckles
/// between its disks at ΣT = 12 EI/l² with the bay's length l: 240 N here, up to what
/// two arcs a bay leave of it.
#[test]
fn a_straight_robot_is_a_minimum_up_to_where_it_buckles_between_disks() {
    let minimum = |sum: f64| {
        let mut scene = Scene::default();
        scene.model.mechanics = scene::Mechanics::Sliding;
        scene.robot.bending_stiffness_nmm2 = Some(8000.0);
        scene.robot.cable_offset_mm = None;
        scene.actuation = None;
        let cable = |offset_mm| scene::Cable {
            offset_mm,
            drive: scene::Drive::PullMm(0.0),
            to_disk: None,
            axial_stiffness_n: None,
            diameter_mm: 0.0,
        };
        scene.cables = vec![cable(8.0), cable(-8.0)];
        let mut problem = Problem::new(&scene).unwrap();
        let mut drive: Drive = problem.drive().clone();
        let per_bend = 8e-3 / (2.0 * problem.robot().segment_length());
        for driven in &mut drive.cables {
            driven.input = Input::Load(0.5 * sum);
        }
        problem.set_drive(&drive);
        let mut nodes = vec![problem.robot().base; 19];
        for (i, node) in nodes.iter_mut().enumerate() {
            node.position.y = 0.01 * i as f64;
        }
        let state = CableState {
            pull: 0.0,
            tension: 0.5 * sum / per_bend,
            load: 0.5 * sum / per_bend,
            is_slack: false,
        };
        let told = Told {
            problem,
            nodes,
            contacts: Vec::new(),
            cables: vec![state; 2],
        };
        match told.failed()[..] {
            [] => true,
            [Condition::Minimum] => false,
            ref other => panic!("{other:?}"),
        }
    };
    assert!(minimum(1.0) && minimum(239.0));
    assert!(!minimum(242.0) && !minimum(500.0));
}
