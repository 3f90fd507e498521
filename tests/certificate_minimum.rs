//! The certificate's second-order condition against the solver's derivatives:
//! as the posts that a robot leans on get thinner, the robot comes to balance
//! on needles and slips off. The certificate, in the paper's coordinates, and
//! a dense Hessian, by differences in the turns, see it at the same radius.

mod rolled_out;

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rolled_out::at;
use sinew::contact::Contact;
use sinew::contact::RowKind;
use sinew::equilibrium::{Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::{Core, Obstacle};
use sinew::mechanics::{Certifier, Condition, Equal, Mechanics, Problem};
use sinew::scene::Scene;
use sinew::solver::{Control, Hessian, RowId};

/// The solver's row of a contact and its multiplier there.
fn row(problem: &Problem, contact: &Contact) -> (RowId, f64) {
    let kind = RowKind::Contact {
        candidate: contact.candidate,
        obstacle: contact.obstacle,
        vertex: contact.vertex,
    };
    let scale = problem.segment().free_bend().powi(2);
    let id = kind.id(problem.obstacles().len());
    (id, contact.multiplier / scale)
}

/// The least eigenvalue of the Lagrangian's Hessian in the turns, on the null
/// space of the contacts' gradients.
fn least_curvature(problem: &Problem, solution: &Solution) -> f64 {
    let problem = &Equal::new(problem.clone());
    let n = solution.turns.len();
    let turns = solution.turns.iter();
    let controls: Vec<_> = turns.map(|u| Control::<1>::from_element(*u)).collect();
    let contacts = solution.contacts.iter();
    let rows: Vec<_> = contacts.map(|contact| row(problem, contact)).collect();
    let gradient = |index: usize, by: f64| {
        let mut moved = controls.clone();
        moved[index][0] += by;
        let point = at(problem, &moved);
        let multiplier = |id| rows.iter().find(|row| row.0 == id).map_or(0.0, |row| row.1);
        let multipliers: Vec<f64> = point.rows.iter().map(|row| multiplier(row.id)).collect();
        let mut hessian = Hessian::default();
        let gradient = hessian.gradient(&point, &multipliers);
        DVector::from_iterator(n, gradient.iter().map(|g| g[0]))
    };
    let h = 1e-7;
    let columns: Vec<_> = (0..n)
        .map(|index| (gradient(index, h) - gradient(index, -h)) / (2.0 * h))
        .collect();
    let hessian = DMatrix::from_columns(&columns);
    let here = at(problem, &controls);
    let mut along = DMatrix::identity(n, n);
    let mut directions: Vec<DVector<f64>> = Vec::new();
    for (id, _) in &rows {
        let row = here.rows.iter().find(|row| row.id == *id).unwrap();
        let gradient = here.row_gradient(row);
        let mut across = DVector::from_iterator(n, gradient.iter().map(|g| g[0]));
        for direction in &directions {
            across -= direction.dot(&across) * direction;
        }
        let across = across.normalize();
        along -= &across * across.transpose();
        directions.push(across);
    }
    // Across the null space any large number will do.
    let across = 1e6 * (DMatrix::identity(n, n) - &along);
    let symmetric = 0.5 * (&hessian + hessian.transpose());
    let reduced = &along * symmetric * &along + across;
    SymmetricEigen::new(reduced).eigenvalues.min()
}

fn is_minimum(problem: &Problem, solution: &Solution) -> bool {
    let offset = problem.robot().offset;
    let nodes = solution.nodes.iter();
    let points = nodes.map(|node| (node.position, node.at(offset)));
    let certificate = Certifier::default().certify(problem, points, &solution.contacts);
    assert!(certificate.residual() < 1e-9, "{certificate:?}");
    certificate.get(Condition::Minimum) == Some(1.0)
}

/// The same shape with the same forces where every contact has a post of its
/// own, of one radius, at its place.
fn on_posts(problem: &Problem, solution: &Solution, radius: f64) -> (Problem, Solution) {
    let mut solution = solution.clone();
    let mut posts = Vec::new();
    for contact in &mut solution.contacts {
        let center = contact.point - radius * contact.normal;
        contact.obstacle = posts.len();
        contact.vertex = contact.vertex.map(|_| 0);
        posts.push(Obstacle::new(Core::Point, radius, center, 0.0));
    }
    let (robot, candidates) = (*problem.robot(), problem.candidates().to_vec());
    let problem = Problem::from_parts(robot, problem.pull(), candidates, posts);
    (problem, solution)
}

/// The radius below which a property that holds of thick posts does not.
fn edge(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut thin, mut thick) = (1e-6_f64.ln(), 1e-2_f64.ln());
    assert!(holds(thick.exp()) && !holds(thin.exp()));
    while thick - thin > 1e-5 {
        let middle = 0.5 * (thick + thin);
        if holds(middle.exp()) {
            thick = middle;
        } else {
            thin = middle;
        }
    }
    thick.exp()
}

/// A solution of a scene at a pull, in millimetres.
fn solved(text: &str, pull_mm: f64, edit: impl Fn(&mut Scene)) -> (Problem, Solved) {
    let mut scene = Scene::from_toml(text).unwrap();
    scene.set_pull_mm(pull_mm);
    edit(&mut scene);
    let problem = Problem::new(&scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    (problem, solution)
}

const ONE_DISC: &str = include_str!("../assets/scenes/one-disc.toml");
const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");

/// Differences of step 1e-7 leave 1e-6 of the curvatures.
#[test]
fn a_robot_slips_off_posts_of_the_same_radius_in_both() {
    for (text, pull_mm) in [
        (ONE_DISC, 6.0),
        (ONE_DISC, 10.0),
        (TWO_DISCS, 6.0),
        (TWO_DISCS, 10.0),
    ] {
        let (problem, solution) = solved(text, pull_mm, |_| ());
        let on = |radius| on_posts(&problem, &solution, radius);
        let certified = edge(|radius| {
            let (problem, solution) = on(radius);
            is_minimum(&problem, &solution)
        });
        let dense = edge(|radius| {
            let (problem, solution) = on(radius);
            least_curvature(&problem, &solution) > 0.0
        });
        let ratio = certified / dense;
        assert!((ratio - 1.0).abs() < 1e-4, "{certified:e} {dense:e}");
    }
}
