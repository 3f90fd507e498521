//! Reproduced items as one HTML page that needs nothing else: styles and
//! figures are inside. It reads on a phone, by day and night, and in print.

use super::chart::{self, ChartError, escaped};
use crate::experiments::{Check, Item, Verdict};
use crate::math::typeset;
use crate::view;
use std::fmt::Write;

/// A picture for an item: its title and the page's element that shows it.
pub struct Figure {
    /// What it shows.
    pub title: String,
    /// An element, such as an image.
    pub element: String,
}

/// An image element that holds an SVG picture itself.
pub fn image(svg: &str, title: &str) -> String {
    let mut address = String::from("data:image/svg+xml,");
    for byte in svg.bytes() {
        match byte {
            b'a'..=b'z'
            | b'A'..=b'Z'
            | b'0'..=b'9'
            | b' '
            | b'-'
            | b'_'
            | b'.'
            | b'/'
            | b'='
            | b':'
            | b';'
            | b','
            | b'('
            | b')' => address.push(char::from(byte)),
            _ => {
                let _ = write!(address, "%{byte:02X}");
            }
        }
    }
    format!("<img alt=\"{}\" src=\"{address}\">", escaped(title))
}

/// A check's numbers as they are shown: the paper's, ours and the difference;
/// empty where there is none.
pub fn cells(check: &Check) -> [String; 3] {
    let number = |value: Option<f64>| value.map(|v| typeset(v, check.decimals));
    let paper = number(check.paper).map(|value| match check.relation {
        "" => value,
        relation => format!("{relation} {value}"),
    });
    let difference = check.difference().map(|value| {
        let text = typeset(value, check.decimals);
        if value > 0.0 && text.bytes().any(|b| b.is_ascii_digit() && b != b'0') {
            format!("+{text}")
        } else {
            text
        }
    });
    [paper, number(check.ours), difference].map(Option::unwrap_or_default)
}

/// The page. `pictures` holds each item's, in its order.
///
/// # Errors
/// If a chart cannot be drawn.
pub fn html(items: &[Item], pictures: &[Vec<Figure>]) -> Result<String, ChartError> {
    let mut body = String::new();
    body.push_str("<header><h1>The paper’s figures and table, recomputed</h1>\n");
    let _ = writeln!(
        body,
        "<p class=lead>“Profile and contact force estimation of cable-driven continuum robots in \
         presence of obstacles”, by Sinew {}.</p>",
        env!("CARGO_PKG_VERSION")
    );
    body.push_str(
        "<p>What each model assumes: <em>virtual work</em>, the paper’s eq. 11, takes the motion of \
         the free robot for that of the robot in contact, and fits one factor, its μ, to one \
         measured force. The <em>multipliers</em> of its eq. 5 hold the cable in every disk, so \
         that all its segments shorten alike, and understate forces near contact. The \
         <em>sliding cable without friction</em> runs through the disks with one tension all \
         along, and fits nothing. The <em>sliding cable with friction</em> loses tension at \
         every hole, rubs on what it touches and loses a share of its load below the base, by \
         three constants that are fitted to all 28 forces of Table 1 at once and that these \
         cannot tell apart. All of them take a backbone that bends and does not stretch, in one \
         plane, drawn in slowly; only what no constant was fitted to is called \
         predicted.</p>\n",
    );
    body.push_str(&tally(items));
    body.push_str("<nav aria-label=Contents>");
    for item in items {
        let word = item.id.word();
        let _ = write!(body, "<a href=\"#{word}\">{}</a>", item.id.name());
    }
    body.push_str("</nav></header>\n<main>\n");
    for (index, item) in items.iter().enumerate() {
        let none: &[Figure] = &[];
        section(
            &mut body,
            item,
            pictures.get(index).map_or(none, |p| &p[..]),
        )?;
    }
    body.push_str("</main>\n");
    Ok(format!(
        "<!doctype html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n\
         <meta name=viewport content=\"width=device-width,initial-scale=1\">\n\
         <meta name=color-scheme content=\"light dark\">\n\
         <title>Sinew: the paper recomputed</title>\n<style>\n{}\n{}\n</style>\n</head>\n\
         <body>\n{body}</body>\n</html>\n",
        include_str!("page.css"),
        chart::STYLE
    ))
}

/// How many comparisons came out how.
fn tally(items: &[Item]) -> String {
    let count = |verdict: Verdict| {
        let checks = items.iter().flat_map(|item| &item.checks);
        checks.filter(|check| check.verdict == verdict).count()
    };
    let mut list = String::from("<ul class=tally>");
    for (verdict, about) in [
        (Verdict::Agrees, "agree with the paper"),
        (Verdict::Differs, "differ"),
        (Verdict::NotGiven, "need data that the text does not give"),
        (Verdict::OursOnly, "are ours only"),
    ] {
        let _ = write!(
            list,
            "<li class={}><b>{}</b> {about}</li>",
            class(verdict),
            count(verdict)
        );
    }
    list.push_str("</ul>\n");
    list
}

fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Agrees => "agrees",
        Verdict::Differs => "differs",
        Verdict::OursOnly => "ours",
        Verdict::NotGiven => "absent",
    }
}

fn section(body: &mut String, item: &Item, pictures: &[Figure]) -> Result<(), ChartError> {
    let (word, name, title) = (item.id.word(), item.id.name(), item.title);
    let _ = writeln!(
        body,
        "<section id={word}>\n<h2><span>{name}</span> {}</h2>\n<p>{}</p>",
        escaped(title),
        escaped(&item.about)
    );
    let charts = view::charts(item);
    if !(pictures.is_empty() && charts.is_empty()) {
        body.push_str("<div class=figures>\n");
        for picture in pictures {
            figure(body, &picture.element, &picture.title, None);
        }
        for chart in &charts {
            let data = format!("data/{word}-{}.csv", chart.word);
            figure(body, &chart::svg(chart)?, &chart.title, Some(&data));
        }
        body.push_str("</div>\n");
    }
    checks(body, &item.checks);
    for note in &item.notes {
        let _ = writeln!(body, "<p class=note>{}</p>", escaped(note));
    }
    if !item.missing.is_empty() {
        body.push_str("<div class=missing><h3>Not in the text</h3><ul>");
        for sentence in &item.missing {
            let _ = write!(body, "<li>{}</li>", escaped(sentence));
        }
        body.push_str("</ul></div>\n");
    }
    body.push_str("</section>\n");
    Ok(())
}

fn figure(body: &mut String, element: &str, title: &str, data: Option<&str>) {
    let _ = write!(body, "<figure>{element}<figcaption>{}", escaped(title));
    if let Some(data) = data {
        let _ = write!(body, " <a href=\"{data}\">CSV</a>");
    }
    body.push_str("</figcaption></figure>\n");
}

fn checks(body: &mut String, checks: &[Check]) {
    body.push_str(
        "<table><thead><tr><th scope=col>Quantity<th scope=col>Paper<th scope=col>Ours\
         <th scope=col>Difference<th scope=col>Verdict</tr></thead><tbody>\n",
    );
    for check in checks {
        let [paper, ours, difference] = cells(check);
        let unit = match check.unit {
            "" => String::new(),
            unit => format!(" <span class=unit>{}</span>", escaped(unit)),
        };
        let cell = |label: &str, text: &str| {
            if text.is_empty() {
                "<td class=none>".to_owned()
            } else {
                format!("<td data-label={label}>{}{unit}", escaped(text))
            }
        };
        let _ = writeln!(
            body,
            "<tr><th scope=row>{}{}{}{}<td class=verdict><span class={}>{}</span></tr>",
            escaped(&check.quantity),
            cell("Paper", &paper),
            cell("Ours", &ours),
            cell("Difference", &difference),
            class(check.verdict),
            check.verdict.word()
        );
    }
    body.push_str("</tbody></table>\n");
}
