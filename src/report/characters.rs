//! Which characters of a text that somebody else wrote may be shown, and what
//! stands for the others. It knows no markup.

/// Whether a character does not stand for itself: it moves what is written
/// after it, turns its direction, or ends the line. Joiners, which letters and
/// emoji need, do not count.
fn steers(c: char) -> bool {
    let turns = matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{206f}');
    c.is_control() || turns || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}')
}

/// The text with a replacement for every character that XML forbids or that
/// steers what is written after it, but for tabs and ends of lines.
pub fn printable(text: &str) -> String {
    let shown = |c: char| {
        let kept = matches!(c, '\n' | '\t');
        let forbidden = (steers(c) && !kept) || matches!(c, '\u{fffe}' | '\u{ffff}');
        if forbidden { '\u{fffd}' } else { c }
    };
    text.chars().map(shown).collect()
}

/// The text on one line as a terminal may show it: characters that would move
/// its cursor or turn its text are written as escapes. What it returns it
/// leaves alone.
pub fn on_a_terminal(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        if steers(c) {
            safe.extend(c.escape_default());
        } else {
            safe.push(c);
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_that_steer_a_text_do_not_get_through() {
        // A clear screen, a C1 introducer, a line's end, a turn to the left.
        let tricky = "a\u{1b}[2Jb\u{9b}2Jc\nd\u{202e}e\u{2066}f\u{2028}g\u{200f}";
        assert_eq!(
            on_a_terminal(tricky),
            "a\\u{1b}[2Jb\\u{9b}2Jc\\nd\\u{202e}e\\u{2066}f\\u{2028}g\\u{200f}"
        );
        assert_eq!(
            printable(tricky),
            "a\u{fffd}[2Jb\u{fffd}2Jc\nd\u{fffd}e\u{fffd}f\u{fffd}g\u{fffd}"
        );
        for plain in [
            "Rö\u{308}hre",
            "\u{1f468}\u{200d}\u{1f52c}",
            "می\u{200c}خواهم",
            "\\n",
        ] {
            assert_eq!(on_a_terminal(plain), plain);
            assert_eq!(printable(plain), plain);
        }
    }
}
