//! Solutions as a report for people, with as many digits as mean something.

use std::io::{self, Write};

use super::{Labels, paragraph, pull_shown};
use crate::math::decimals;
use crate::mechanics::{Answers, Condition, ConditionKind};
use crate::record::{Caution, Contact, Event, Solution, Timing};
use crate::units::{RAD2_PER_MM, degrees, metres};

/// Contacts or events that are listed one by one.
const LISTED: usize = 40;

pub(super) fn solution(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    writeln!(out, "{}\n", labels.title)?;
    writeln!(out, "  status       {}: {}", state.status, state.reason)?;
    let pull = pull_shown(metres(state.pull_mm));
    let goal = pull_shown(metres(labels.goal_mm));
    if pull == goal {
        writeln!(out, "  pull         {pull} mm")?;
    } else {
        writeln!(out, "  pull         {pull} mm of the {goal} mm asked for")?;
    }
    let [x, y] = state.tip_mm.map(|coordinate| decimals(coordinate, 2));
    writeln!(out, "  tip          x {x} mm, y {y} mm")?;
    let slope = decimals(degrees(state.tip_slope_rad), 1);
    writeln!(out, "  slope        {slope}° clockwise from the base")?;
    let energy = figures(state.energy);
    let rate = figures(state.certificate.energy_slope);
    writeln!(
        out,
        "  energy       {energy} rad², changing by {rate} rad² per mm of pull"
    )?;
    if let Some(tension) = state.tension_n {
        let tension = figures(tension);
        writeln!(out, "  tension      {tension} N along the cable")?;
    }
    certificate(out, state)?;
    writeln!(out, "  iterations   {}", state.iterations)?;
    cautions(out, labels, state)?;
    contacts(out, labels, state)?;
    events(out, labels, state)?;
    state.timing_us.as_ref().map_or(Ok(()), |t| timing(out, t))
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
    writeln!(
        out,
        "  {:<14}  {:>6}  {:<width$}  {:<8}  {:>10}  {:>8}  {:>8}",
        "line", "node", "obstacle", "class", "multiplier", "x", "y"
    )?;
    writeln!(
        out,
        "  {:<14}  {:>6}  {:<width$}  {:<8}  {:>10}  {:>8}  {:>8}",
        "", "", "", "", RAD2_PER_MM, "mm", "mm"
    )?;
    for (contact, name) in shown.iter().zip(&names) {
        let [x, y] = contact.point_mm.map(|coordinate| decimals(coordinate, 2));
        writeln!(
            out,
            "  {:<14}  {:>6}  {name:<width$}  {:<8}  {:>10}  {x:>8}  {y:>8}",
            line(contact.line),
            contact.node,
            contact.class,
            figures(contact.multiplier),
        )?;
    }
    and_more(out, state.contacts.len())?;
    if !state.unique_split {
        let note = "The split between the contacts is not unique; the sum at a node is.";
        writeln!(out, "\n  {note}")?;
    }
    Ok(())
}

fn events(out: &mut impl Write, labels: &Labels, state: &Solution) -> io::Result<()> {
    if state.events.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nOn the way\n")?;
    for event in state.events.iter().take(LISTED) {
        let pull = decimals(event.pull_mm, 3);
        writeln!(out, "  {pull:>8} mm  {}", told(labels, event))?;
    }
    and_more(out, state.events.len())
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
        writeln!(
            out,
            "{:>9}  {:>8}  {:>8}  {:>7}  {:>10}  {:<28}  events",
            "pull", "tip x", "tip y", "slope", "energy", "pressing (node on obstacle)"
        )?;
        writeln!(
            out,
            "{:>9}  {:>8}  {:>8}  {:>7}  {:>10}",
            "mm", "mm", "mm", "deg", "rad²"
        )?;
    }
    let [x, y] = state.tip_mm;
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
        decimals(state.pull_mm, 3),
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
