//! Solutions as a report for people, with as many digits as mean something.

use std::io::{self, Write};

use super::{Labels, grams_shown, paragraph, pull_shown};
use crate::math::decimals;
use crate::mechanics::{Answers, Condition, ConditionKind, Input};
use crate::record::{Cable, Caution, Contact, Driven, Event, Solution, Timing};
use crate::scene::limits;
use crate::units::{RAD2_PER_MM, degrees, grams, metres};

/// Contacts or events that are listed one by one.
const LISTED: usize = 40;
/// The word of the mechanics whose cables slide.
const SLIDING: &str = "sliding";
/// What is to be known of forces by the paper's model.
const UNDERSTATED: &str = "The paper's cable cannot slide, and its model understates the forces of \
    contacts; model.mechanics = \"sliding\" gives those that a load cell would show.";

pub(super) fn solution(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    writeln!(out, "{}\n", labels.title)?;
    let mechanics = match state.mechanics {
        SLIDING => "the cables slide through the disks",
        _ => "every segment of the cable shortens alike, as in the paper",
    };
    writeln!(out, "  mechanics    {}: {mechanics}", state.mechanics)?;
    writeln!(out, "  status       {}: {}", state.status, state.reason)?;
    match &state.cables[..] {
        [cable] => one_cable(out, cable, labels.goal.first().copied())?,
        cables => {
            for (index, cable) in cables.iter().enumerate() {
                one_of_several(out, index, cable, labels.goal.get(index).copied())?;
            }
        }
    }
    let [x, y] = state.tip_mm.map(|coordinate| decimals(coordinate, 2));
    writeln!(out, "  tip          x {x} mm, y {y} mm")?;
    let slope = decimals(degrees(state.tip_slope_rad), 1);
    writeln!(out, "  slope        {slope}° clockwise from the base")?;
    energy(out, state)?;
    if let Some(stable) = state.stable_under_load {
        let held = if stable {
            "weights on the cables would hold it, too"
        } else {
            "held by the cables' lengths alone: under weights it would snap away"
        };
        writeln!(out, "  stability    {held}")?;
    }
    certificate(out, state)?;
    writeln!(out, "  iterations   {}", state.iterations)?;
    cautions(out, labels, state)?;
    contacts(out, labels, state)?;
    events(out, labels, state)?;
    state.timing_us.as_ref().map_or(Ok(()), |t| timing(out, t))
}

fn energy(out: &mut impl Write, state: &Solution) -> io::Result<()> {
    write!(out, "  energy       {} rad²", figures(state.energy))?;
    if let Some(energy) = state.energy_nmm {
        write!(out, " ({} N mm)", figures(energy))?;
    }
    match &state.cables[..] {
        // With friction the cable's work is not all stored.
        [cable] if cable.slips.is_none() => writeln!(
            out,
            ", changing by {} rad² per mm of pull",
            figures(cable.multiplier)
        ),
        _ => writeln!(out),
    }
}

/// A cable's pull, as far as it was got where more was asked for.
fn pull(cable: &Cable, goal: Option<Input>) -> String {
    let pull = pull_shown(metres(cable.pull_mm));
    match goal {
        Some(Input::Pull(goal)) if pull_shown(goal) != pull => {
            format!("{pull} mm of the {} mm asked for", pull_shown(goal))
        }
        _ => format!("{pull} mm"),
    }
}

/// A cable's load or tension in grams and newtons, as far as it was got where more was asked
/// for.
fn tension(cable: &Cable, goal: Option<Input>) -> Option<String> {
    if cable.slack {
        return Some("none: it hangs slack".to_owned());
    }
    let tension = match goal {
        Some(Input::Load(_)) => cable.load_n?,
        _ => cable.tension_n?,
    };
    let (shown, newtons) = (grams_shown(tension), figures(tension));
    Some(match goal {
        Some(Input::Load(goal)) if grams_shown(goal) != shown => {
            format!("{shown} g of the {} g asked for", grams_shown(goal))
        }
        _ => format!("{shown} g ({newtons} N)"),
    })
}

/// Where friction takes from a cable: what hangs on it, and its tension at both ends.
fn rubbing(cable: &Cable) -> Option<String> {
    cable.slips.as_ref()?;
    let tensions = cable.tensions_n.as_ref()?;
    Some(format!(
        "load {} g below the base; tension {} g above it and {} g at its end",
        grams_shown(cable.load_n?),
        grams_shown(*tensions.first()?),
        grams_shown(*tensions.last()?)
    ))
}

fn one_cable(out: &mut impl Write, cable: &Cable, goal: Option<Input>) -> io::Result<()> {
    writeln!(out, "  pull         {}", pull(cable, goal))?;
    if let Some(told) = rubbing(cable) {
        writeln!(out, "  friction     {told}")?;
    }
    match (tension(cable, goal), goal) {
        (Some(tension), Some(Input::Load(_))) => writeln!(out, "  load         {tension}"),
        (Some(tension), _) => writeln!(out, "  tension      {tension}"),
        (None, _) => Ok(()),
    }
}

fn one_of_several(
    out: &mut impl Write,
    index: usize,
    cable: &Cable,
    goal: Option<Input>,
) -> io::Result<()> {
    let name = format!("cable {index}");
    let offset = limits::shown(cable.offset_mm);
    write!(
        out,
        "  {name:<11}  at {offset} mm to disk {}: ",
        cable.to_disk
    )?;
    write!(out, "pull {}", pull(cable, goal))?;
    match (tension(cable, goal), goal) {
        (Some(_), _) if cable.slack => writeln!(out, ", slack"),
        (Some(tension), Some(Input::Load(_))) => writeln!(out, ", load {tension}"),
        (Some(tension), _) => writeln!(out, ", tension {tension}"),
        (None, _) => writeln!(out),
    }
}

fn certificate(out: &mut impl Write, state: &Solution) -> io::Result<()> {
    let certificate = &state.certificate;
    let verdict = if certificate.holds {
        "holds"
    } else {
        "does not hold"
    };
    write!(
        out,
        "  certificate  {verdict}: residual {:.0e} (at most {:.0e})",
        certificate.residual,
        Condition::BOUND
    )?;
    // What says most of the shape, that it is a minimum, is certified last.
    for (condition, value) in certificate.conditions.iter().rev() {
        if let ConditionKind::YesOrNo(Answers { yes, no, .. }) = condition.kind() {
            let answer = if condition.is_met(*value) { yes } else { no };
            write!(out, ", {answer}")?;
        }
    }
    writeln!(out)
}

fn cautions(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    if state.cautions.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nCautions\n")?;
    for caution in state.cautions.iter().take(LISTED) {
        paragraph(out, "  ", &labels.caution(&caution.finding))?;
    }
    and_more(out, state.cautions.len())
}

fn contacts(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    if state.contacts.is_empty() {
        return writeln!(out, "\nNothing touches.");
    }
    writeln!(
        out,
        "\nContacts (nodes and obstacles count from 0, nodes from the base)\n"
    )?;
    let shown = &state.contacts[..state.contacts.len().min(LISTED)];
    let names: Vec<String> = shown
        .iter()
        .map(|contact| labels.obstacle(contact.obstacle))
        .collect();
    let width = names.iter().map(|name| name.chars().count());
    let width = width.max().unwrap_or(0).max("obstacle".len());
    let has_forces = shown.iter().any(|contact| contact.force_n.is_some());
    let force = |text: &str| match has_forces {
        true => format!("{text:>8}  "),
        false => String::new(),
    };
    for (titles, text) in [
        (
            ["line", "node", "obstacle", "class"],
            ["force", "multiplier", "x", "y"],
        ),
        (["", "", "", ""], ["g", RAD2_PER_MM, "mm", "mm"]),
    ] {
        let [line, node, obstacle, class] = titles;
        let [grams, multiplier, x, y] = text;
        writeln!(
            out,
            "  {line:<14}  {node:>6}  {obstacle:<width$}  {class:<8}  {}{multiplier:>10}  {x:>8}  {y:>8}",
            force(grams)
        )?;
    }
    for (contact, name) in shown.iter().zip(&names) {
        let [x, y] = contact.point_mm.map(|coordinate| decimals(coordinate, 2));
        let grams = contact.force_n.map_or_else(String::new, grams_shown);
        writeln!(
            out,
            "  {:<14}  {:>6}  {name:<width$}  {:<8}  {}{:>10}  {x:>8}  {y:>8}",
            on_line(state, contact.line, contact.cable),
            contact.node,
            contact.class,
            force(&grams),
            figures(contact.multiplier),
        )?;
    }
    and_more(out, state.contacts.len())?;
    if !state.unique_split {
        let note = "The split between the contacts is not unique; the sum at a node is.";
        writeln!(out, "\n  {note}")?;
    }
    if state.mechanics != SLIDING && has_forces {
        paragraph(out, "\n  ", UNDERSTATED)?;
    }
    Ok(())
}

/// The line of a contact in words: of several cables, which.
fn on_line(state: &Solution, name: &str, cable: Option<usize>) -> String {
    match cable {
        Some(cable) if state.cables.len() > 1 => format!("{} {cable}", line(name)),
        _ => line(name),
    }
}

fn events(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    if state.events.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nOn the way\n")?;
    for event in state.events.iter().take(LISTED) {
        let (at, unit) = when(&event.cables, event.share);
        writeln!(out, "  {at:>8} {unit}  {}", told(labels, event))?;
    }
    and_more(out, state.events.len())
}

/// What tells how far the robot has come, with its unit: the one cable's pull or load,
/// or the share of all that drives it.
fn when(cables: &[Driven], share: f64) -> (String, &'static str) {
    match cables {
        [
            Driven {
                pull_mm: Some(pull),
                ..
            },
        ] => (decimals(*pull, 3), "mm"),
        [
            Driven {
                load_n: Some(load), ..
            },
        ] => (decimals(grams(*load), 2), "g "),
        _ => (decimals(100.0 * share, 2), "% "),
    }
}

/// Says how many entries of a list are left out.
fn and_more(out: &mut impl Write, count: usize) -> io::Result<()> {
    match count.checked_sub(LISTED) {
        None | Some(0) => Ok(()),
        Some(more) => writeln!(out, "  … and {more} more, which --format json lists"),
    }
}

fn timing(out: &mut impl Write, timing: &Timing) -> io::Result<()> {
    writeln!(out, "\nTime of a solve, µs\n")?;
    writeln!(out, "            median         p99  converged")?;
    for (name, sample) in [
        ("cold", &timing.cold),
        ("path", &timing.path),
        ("warm", &timing.warm),
    ] {
        let (median, p99) = (sample.median, sample.p99);
        let converged = sample.converged;
        writeln!(
            out,
            "  {name:<6}{median:>10.1}  {p99:>10.1}  {converged:>9}"
        )?;
    }
    Ok(())
}

pub(super) fn path_state(
    out: &mut impl Write,
    labels: &Labels,
    index: usize,
    state: &Solution,
) -> io::Result<()> {
    if index == 0 {
        writeln!(out, "{}\n", labels.title)?;
        let (what, unit) = match labels.goal[..] {
            [Input::Pull(_)] => ("pull", "mm"),
            [Input::Load(_)] => ("load", "g"),
            _ => ("share", "%"),
        };
        writeln!(
            out,
            "{what:>9}  {:>8}  {:>8}  {:>7}  {:>10}  {:<28}  events",
            "tip x", "tip y", "slope", "energy", "pressing (node on obstacle)"
        )?;
        writeln!(
            out,
            "{unit:>9}  {:>8}  {:>8}  {:>7}  {:>10}",
            "mm", "mm", "deg", "rad²"
        )?;
    }
    let [x, y] = state.tip_mm;
    let at = match (&labels.goal[..], &state.cables[..]) {
        ([Input::Pull(_)], [cable]) => decimals(cable.pull_mm, 3),
        ([Input::Load(_)], [cable]) => decimals(grams(cable.tension_n.unwrap_or_default()), 2),
        _ => decimals(100.0 * state.share, 2),
    };
    let pressing = state.contacts.iter().filter(|c| c.class == "pressing");
    let pressing: Vec<String> = pressing.map(place).collect();
    let pressing = if pressing.is_empty() {
        "-".to_owned()
    } else {
        pressing.join(", ")
    };
    let events = state.events.iter().map(|event| told(labels, event));
    let cautions = state.cautions.iter().map(|caution| warned(labels, caution));
    let notes: Vec<String> = events.chain(cautions).collect();
    let text = format!(
        "{:>9}  {:>8}  {:>8}  {:>7}  {:>10}  {pressing:<28}  {}",
        at,
        decimals(x, 2),
        decimals(y, 2),
        decimals(degrees(state.tip_slope_rad), 1),
        figures(state.energy),
        notes.join("; ")
    );
    writeln!(out, "{}", text.trim_end())
}

fn place(contact: &Contact) -> String {
    let line = line(contact.line);
    format!("{line} {} on {}", contact.node, contact.obstacle)
}

/// A caution in a few words.
fn warned(labels: &Labels, caution: &Caution) -> String {
    let what = caution.what.replace('_', " ");
    match caution.place.obstacle {
        Some(index) => format!("caution: {what} {}", labels.obstacle(index)),
        None => format!("caution: {what}"),
    }
}

/// An event in words.
fn told(labels: &Labels, event: &Event) -> String {
    let what = event.what.replace('_', " ");
    let place = &event.place;
    let on = place.obstacle.map(|index| labels.obstacle(index));
    match (place.line, place.node, on, event.distance_mm) {
        (Some(name), Some(node), Some(on), _) => {
            format!("{what}: {} node {node} on obstacle {on}", line(name))
        }
        (_, _, Some(on), _) => {
            let direction = event.direction.unwrap_or_default();
            let [x, y] = direction.map(|coordinate| decimals(coordinate, 2));
            format!("{what} by obstacle {on}, towards ({x}, {y})")
        }
        (_, Some(node), _, Some(distance)) => {
            format!("{what}: node {node} moved by {} mm", decimals(distance, 2))
        }
        _ => match (event.reason, event.segment) {
            (Some(reason), Some(segment)) => {
                format!("{what} at segment {segment}: {}", reason.replace('_', " "))
            }
            _ => what,
        },
    }
}

fn line(name: &str) -> String {
    name.replace('_', " ")
}

/// A number with four figures that mean something, as a power of ten where it
/// is very small or large.
fn figures(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e4).contains(&size) {
        let count = (3.0 - libm::log10(size).floor()).clamp(0.0, 6.0) as usize;
        decimals(value, count)
    } else {
        format!("{value:.3e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_mean_something() {
        assert_eq!(figures(0.0), "0");
        assert_eq!(figures(0.020_843_21), "0.02084");
        assert_eq!(figures(-12.345_6), "-12.35");
        assert_eq!(figures(9_999.9), "10000");
        assert_eq!(figures(1.234_1e-7), "1.234e-7");
    }
}
