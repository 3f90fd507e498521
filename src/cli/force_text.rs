//! What `sinew force` found, as a report for people.

use std::io::{self, Write};

use super::output::pull_shown;
use crate::math::{decimals, typeset, unsigned_zero};
use crate::record::force::{ByVirtualWork, Forces, Frictionless};
use crate::scene::limits;
use crate::units::metres;

/// The report: the lines of virtual work, the multipliers, the table of loads.
pub(super) fn text(out: &mut impl Write, found: &Forces) -> io::Result<()> {
    writeln!(out, "{}\n", found.title)?;
    if is_papers(found) {
        writeln!(out, "Virtual work (eq. 11)\n")?;
        match &found.virtual_work {
            Some(known) => virtual_work(out, known)?,
            None => writeln!(out, "  The robot does not get through the window.")?,
        }
        writeln!(out, "\nMultipliers of the paper's model\n")?;
    } else {
        writeln!(out, "Cables that slide through the disks\n")?;
    }
    multipliers(out, found)?;
    if let Some(beside) = &found.frictionless {
        frictionless(out, beside, is_papers(found))?;
    }
    table(out, found)
}

fn virtual_work(out: &mut impl Write, known: &ByVirtualWork) -> io::Result<()> {
    let [first, last] = known.window_mm;
    let whose = match known.motion {
        "free" => "free robot",
        _ => "robot among its obstacles",
    };
    writeln!(
        out,
        "  motion   node {} of the {whose}, pulls of {} to {} mm",
        known.node,
        shown_mm(first),
        shown_mm(last)
    )?;
    for (name, line, unit) in [
        ("x", &known.x, "mm"),
        ("y", &known.y, "mm"),
        ("slope", &known.slope, "deg"),
    ] {
        writeln!(
            out,
            "  {name:<7}  {:>9} {unit}/mm, R² {:.5}, residual {:.3} {unit} RMS, {:.3} at most",
            typeset(line.per_mm, 4),
            line.r_squared,
            line.rms_residual,
            line.max_residual
        )?;
    }
    writeln!(
        out,
        "  mu       {:>9} ({})",
        typeset(known.mu, 4),
        known.mu_from
    )?;
    writeln!(
        out,
        "  force    {:>9} of the load",
        typeset(known.force_per_load, 5)
    )?;
    for caveat in &known.caveats {
        writeln!(out, "  caution: {caveat}")?;
    }
    Ok(())
}

/// Whether it is about the paper's model.
fn is_papers(found: &Forces) -> bool {
    found.mechanics == "equal"
}

fn multipliers(out: &mut impl Write, found: &Forces) -> io::Result<()> {
    match &found.by_multipliers {
        Some(known) => {
            writeln!(
                out,
                "  EI       {:.1} N mm² ({})",
                known.ei_nmm2, known.ei_from
            )?;
            match known.contact_pull_mm {
                Some(pull) => writeln!(
                    out,
                    "  contact  from a pull of {} mm, with {} g on the cable; loads count from there",
                    decimals(pull, 3),
                    decimals(known.tension_at_contact_g, 1)
                )?,
                None => writeln!(out, "  contact  none; loads count from the straight robot")?,
            }
        }
        None => writeln!(
            out,
            "  Forces need a stiffness: --ei, --rod, --weighed or the scene's. Without one:"
        )?,
    }
    let Some(pull_mm) = found.pull_mm.map(|pull| pull_shown(metres(pull))) else {
        return Ok(());
    };
    if found.contacts.is_empty() {
        writeln!(out, "  At a pull of {pull_mm} mm nothing touches.")?;
    }
    for contact in &found.contacts {
        if let Some(share) = contact.force_over_tension {
            let name = &contact.contact;
            writeln!(
                out,
                "  At a pull of {pull_mm} mm: {} of the cable's tension at {name} (node {})",
                decimals(share, 5),
                contact.node
            )?;
        }
    }
    Ok(())
}

fn frictionless(out: &mut impl Write, beside: &Frictionless, papers: bool) -> io::Result<()> {
    let what = if papers {
        "With a cable that slides without friction"
    } else {
        "Without friction"
    };
    match beside.contact_pull_mm {
        Some(pull) => writeln!(
            out,
            "  {what}: contact from a pull of {} mm, with {} g on the cable",
            decimals(pull, 3),
            decimals(beside.tension_at_contact_g, 1)
        ),
        None => writeln!(out, "  {what}: no contact"),
    }
}

fn table(out: &mut impl Write, found: &Forces) -> io::Result<()> {
    let both = found.by_multipliers.is_some();
    let beside = found.frictionless.is_some();
    if found.loads.is_empty() {
        return Ok(());
    }
    let papers = is_papers(found);
    write!(out, "\n  {:>8}", "load")?;
    if papers {
        write!(out, "  {:>8}  {:>8}", "P_x", "P_y")?;
    }
    if both {
        write!(out, "  {:>8}  {:>8}  {:>8}", "pull", "tension", "force")?;
        if beside {
            let name = if papers { "sliding" } else { "no friction" };
            write!(out, "  {name:>11}")?;
        }
        write!(out, "  {}", if papers { "by multipliers" } else { "on" })?;
    }
    write!(out, "\n  {:>8}", "g")?;
    if papers {
        write!(out, "  {:>8}  {:>8}", "g", "g")?;
    }
    if both {
        write!(out, "  {:>8}  {:>8}  {:>8}", "mm", "g", "g")?;
        if beside {
            write!(out, "  {:>11}", "g")?;
        }
    }
    writeln!(out)?;
    let force = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |g| typeset(g, 2));
    for row in &found.loads {
        write!(out, "  {:>8}", row.load_g)?;
        if papers {
            let (x, y) = (force(row.force_x_g), force(row.force_y_g));
            write!(out, "  {x:>8}  {y:>8}")?;
        }
        if let Some(loaded) = &row.multipliers {
            let parts = loaded.contacts.iter();
            let parts = parts.map(|c| format!("{} g at {}", typeset(c.force_g, 2), c.contact));
            write!(
                out,
                "  {:>8}  {:>8}  {:>8}",
                decimals(loaded.pull_mm, 3),
                decimals(loaded.tension_g, 1),
                decimals(loaded.force_g, 2)
            )?;
            if beside {
                write!(out, "  {:>11}", force(row.frictionless_force_g))?;
            }
            write!(out, "  {}", parts.collect::<Vec<_>>().join("; "))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A number that was given, in as many digits.
fn shown_mm(value: f64) -> String {
    limits::shown(unsigned_zero(value))
}
