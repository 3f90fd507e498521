//! Numbers in options: pairs, lists and ranges, with errors that name the
//! option, the text and what is allowed.

use super::input::BadInput;
use super::output::printable;

/// The most numbers a range may stand for.
const MOST: usize = 10_000;

fn bad(option: &str, text: &str, what: &str) -> BadInput {
    BadInput::Arguments(format!("{option} is \"{}\"; {what}", printable(text)))
}

fn number(text: &str) -> Option<f64> {
    text.trim()
        .parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
}

/// Two numbers with a colon between.
pub(super) fn pair(option: &str, text: &str, what: &str) -> Result<(f64, f64), BadInput> {
    let parts: Vec<Option<f64>> = text.split(':').map(number).collect();
    match parts[..] {
        [Some(a), Some(b)] => Ok((a, b)),
        _ => Err(bad(option, text, what)),
    }
}

/// At least two waypoints, with colons between.
pub(super) fn course(option: &str, text: &str, unit: &str) -> Result<Vec<f64>, BadInput> {
    let list: Option<Vec<f64>> = text.split(':').map(number).collect();
    match list {
        Some(list) if (2..=100).contains(&list.len()) => Ok(list),
        _ => Err(bad(
            option,
            text,
            &format!("write 2 to 100 waypoints in {unit} with colons between, such as 0:5:0"),
        )),
    }
}

/// Positive numbers: FIRST:LAST:STEP or a list with commas.
pub(super) fn loads(option: &str, text: &str) -> Result<Vec<f64>, BadInput> {
    const WHAT: &str = "write FIRST:LAST:STEP or a list such as 50,100,350, in grams";
    let list = if text.contains(':') {
        let parts: Vec<Option<f64>> = text.split(':').map(number).collect();
        let [Some(first), Some(last), Some(step)] = parts[..] else {
            return Err(bad(option, text, WHAT));
        };
        let steps = (last - first) / step;
        if !(step > 0.0 && steps >= 0.0) {
            return Err(bad(
                option,
                text,
                "LAST may not be below FIRST, nor STEP zero",
            ));
        }
        // A last load that rounding puts a hair beyond the end is meant.
        let steps = (steps + 1e-9).floor();
        if steps >= MOST as f64 {
            return Err(bad(option, text, "that is more than 10000 loads"));
        }
        (0..=steps as usize)
            .map(|k| first + step * k as f64)
            .collect()
    } else {
        let list: Option<Vec<f64>> = text.split(',').map(number).collect();
        list.ok_or_else(|| bad(option, text, WHAT))?
    };
    match list.iter().position(|load| *load <= 0.0) {
        Some(k) => Err(BadInput::Arguments(format!(
            "load {} of {option} is {} g; loads count from contact and are positive",
            k + 1,
            list[k]
        ))),
        None => Ok(list),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_both_ends() {
        let of = |text| loads("--loads", text).unwrap();
        assert_eq!(of("50:350:50").len(), 7);
        assert_eq!(of("0.1:0.3:0.1").len(), 3);
        assert_eq!(of("50:120:50"), [50.0, 100.0]);
        assert_eq!(of("5"), [5.0]);
        for wrong in [
            "", "a", "1:2", "2:1:1", "1:2:0", "1:2:-1", "0", "1,,2", "nan", "1:1e9:1",
        ] {
            assert!(loads("--loads", wrong).is_err(), "{wrong}");
        }
    }
}
