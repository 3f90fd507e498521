//! Numbers written as people write them and TOML does not: with a unit, with a
//! decimal comma. It only words the advice; the parser finds the fault.

/// What to do about a line that TOML refuses, where it holds such a number.
pub(super) fn advice(line: &str) -> Option<String> {
    let (key, value) = match line.split_once('=') {
        Some((key, value)) => (key.trim(), value),
        // A list may go on over lines.
        None => ("", line),
    };
    let value = value.split('#').next().unwrap_or_default();
    // What is in quotes is no number.
    let value: String = value.split('"').step_by(2).collect();
    let scalar = value.trim();
    if let Some((whole, part)) = scalar.split_once(',')
        && number(whole) == whole.len()
        && !part.is_empty()
        && part.bytes().all(|byte| byte.is_ascii_digit())
    {
        return Some(format!(
            "a number has a decimal point; write {}",
            assigned(key, &format!("{whole}.{part}"))
        ));
    }
    let mut entries = value.split([',', '[', ']', '{', '}', '=']).map(str::trim);
    let (number, unit) = entries.find_map(with_unit)?;
    Some(match unit_of(key) {
        Some((name, signs)) if !signs.contains(&unit) => {
            format!("write the number alone and in {name}, the unit that the end of its key names")
        }
        Some((name, _)) if number.len() + unit.len() >= scalar.len().saturating_sub(1) => format!(
            "write the number alone, {}; the end of its key names the unit, {name}",
            assigned(key, number)
        ),
        Some((name, _)) => format!(
            "write the numbers alone, {number} for {number} {unit}; the end of their key names \
             the unit, {name}"
        ),
        None => format!(
            "write the number alone, {number} for {number} {unit}; the end of a key names the unit"
        ),
    })
}

/// The value with its key, as a line of the file.
fn assigned(key: &str, value: &str) -> String {
    if key.is_empty() {
        value.to_owned()
    } else {
        format!("`{key} = {value}`")
    }
}

/// The unit that a key ends in: its name, and signs that mean it.
fn unit_of(key: &str) -> Option<(&'static str, &'static [&'static str])> {
    let (_, end) = key.rsplit_once('_')?;
    Some(match end {
        "mm" => ("millimetres", &["mm", "millimetres", "millimeters"]),
        "deg" => ("degrees", &["°", "deg", "degrees"]),
        "g" => ("grams", &["g", "grams", "gram"]),
        "n" => ("newtons", &["N", "newton", "newtons"]),
        "nmm" => ("N mm", &["N mm", "Nmm", "N*mm"]),
        "s2" => ("m/s²", &["m/s²", "m/s2", "m/s^2"]),
        "nmm2" => (
            "N mm²",
            &["N mm²", "N mm2", "Nmm²", "Nmm2", "N*mm^2", "N mm^2"],
        ),
        _ => return None,
    })
}

/// A number and the word after it.
fn with_unit(entry: &str) -> Option<(&str, &str)> {
    let (number, rest) = entry.split_at(number(entry));
    let unit = rest.trim();
    let starts = |c: char| c.is_alphabetic() || matches!(c, '°' | '%');
    (!number.is_empty() && unit.starts_with(starts) && unit.chars().count() <= 16)
        .then_some((number, unit))
}

/// How many bytes at the start of a text are a decimal number.
fn number(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = text.bytes().skip(from);
        rest.take_while(u8::is_ascii_digit).count()
    };
    let sign = usize::from(text.starts_with(['+', '-']));
    let whole = digits(sign);
    if whole == 0 {
        return 0;
    }
    let mut length = sign + whole;
    if text[length..].starts_with('.') && digits(length + 1) > 0 {
        length += 1 + digits(length + 1);
    }
    if text[length..].starts_with(['e', 'E']) {
        let after = &text[length + 1..];
        let sign = usize::from(after.starts_with(['+', '-']));
        let power = digits(length + 1 + sign);
        if power > 0 {
            length += 1 + sign + power;
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(line: &str, expect: Option<&str>) {
        assert_eq!(advice(line).as_deref(), expect, "{line}");
    }

    #[test]
    fn units_and_commas_are_told_apart_from_other_faults() {
        let alone = "write the number alone, `pull_mm = 4.9`; the end of its key names the unit, \
                     millimetres";
        check("pull_mm = 4.9 mm", Some(alone));
        check("  pull_mm = 4.9mm # soft", Some(alone));
        check(
            "length_mm = 18e1 cm",
            Some(
                "write the number alone and in millimetres, the unit that the end of its key names",
            ),
        );
        check(
            "rotation_deg = -35°",
            Some(
                "write the number alone, `rotation_deg = -35`; the end of its key names the unit, \
                 degrees",
            ),
        );
        check(
            "center_mm = [30 mm, 105 mm]",
            Some(
                "write the numbers alone, 30 for 30 mm; the end of their key names the unit, \
                 millimetres",
            ),
        );
        check(
            "pull_mm = 4,9",
            Some("a number has a decimal point; write `pull_mm = 4.9`"),
        );
        check(
            "segments = 18 pieces",
            Some("write the number alone, 18 for 18 pieces; the end of a key names the unit"),
        );
        check(
            "robot = { length_mm = 180 mm, title = \"3 m, 4 m\" }",
            Some("write the number alone, 180 for 180 mm; the end of a key names the unit"),
        );
        for other in [
            "pull_mm = ",
            "pull_mm = four",
            "title = \"4.9 mm",
            "pull_mm == 4.9",
            "points_mm = [[1, 2], [3, 4]",
            "[robot",
        ] {
            check(other, None);
        }
    }
}
