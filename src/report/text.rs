//! How wide text is, without a font at hand: the widths of Inter, rounded up,
//! which is wider than most system fonts. Layout keeps clear of what it says;
//! nothing is positioned so that a few percent would show.

/// The width of a text in pixels at a size in pixels.
pub fn width(text: &str, size: f64) -> f64 {
    let ems: f64 = text.chars().map(ems).sum();
    1.04 * size * ems
}

fn ems(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | ' ' | '·' => 0.29,
        'f' | 't' | 'r' | '(' | ')' | '-' | '/' | '°' | 'I' => 0.40,
        '⁰' | '¹' | '²' | '³' | '⁴' | '⁵' | '⁶' | '⁷' | '⁸' | '⁹' | '⁻' => 0.44,
        'm' | 'w' | 'M' | 'W' | '@' | '%' => 0.95,
        'a'..='z' => 0.60,
        '0'..='9' | '−' | '+' | '×' | '=' => 0.67,
        'A'..='Z' => 0.74,
        c if (c as u32) < 0x500 => 0.70,
        _ => 1.0,
    }
}

/// The text in lines no wider than `limit` at a size, both in pixels, broken at
/// spaces; a longer word
/// has a line of its own. Never empty.
pub fn lines(text: &str, size: f64, limit: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let Some(line) = lines.last_mut() else { break };
        let longer = format!("{line} {word}");
        if line.is_empty() {
            *line = word.to_owned();
        } else if width(&longer, size) <= limit {
            *line = longer;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// The text cut to a width in pixels, with an ellipsis where something is missing.
pub fn cut(text: &str, size: f64, limit: f64) -> String {
    if width(text, size) <= limit {
        return text.to_owned();
    }
    let mut kept = String::new();
    for c in text.chars() {
        if width(&kept, size) + size * (ems(c) + 1.0) > limit {
            break;
        }
        kept.push(c);
    }
    format!("{}…", kept.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_cut_or_broken_to_its_width() {
        let text = "no shape near the last good one keeps clear of the obstacles";
        let broken = lines(text, 12.0, 120.0);
        assert_eq!(broken.join(" "), text);
        assert!(broken.iter().all(|line| width(line, 12.0) <= 120.0));
        let cut = cut(text, 12.0, 120.0);
        assert!(cut.ends_with('…') && width(&cut, 12.0) <= 120.0, "{cut}");
        assert_eq!(lines("", 12.0, 100.0), [""]);
    }
}
