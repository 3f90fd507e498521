//! What an experiment leaves for a report: plain data with labels, no layout.

use super::data::Data;
use crate::equilibrium::Solved;

/// A figure or table of the paper that can be reproduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Id {
    /// The free robot.
    Fig3b,
    /// The robot against one post.
    Fig4a,
    /// The robot against two posts.
    Fig4b,
    /// Multipliers by node.
    Fig5,
    /// The tip's displacement over the pull.
    Fig7,
    /// The robot against the load cell.
    Fig9,
    /// Force over load, third disk from the top.
    Fig10a,
    /// Force over load for other contact points.
    Fig10b,
    /// Force over load at four distances.
    Table1,
}

impl Id {
    /// Every item, in the paper's order.
    pub const ALL: [Id; 9] = [
        Id::Fig3b,
        Id::Fig4a,
        Id::Fig4b,
        Id::Fig5,
        Id::Fig7,
        Id::Fig9,
        Id::Fig10a,
        Id::Fig10b,
        Id::Table1,
    ];

    /// Its word on command lines and in files' names, such as `fig4a`.
    pub fn word(self) -> &'static str {
        match self {
            Id::Fig3b => "fig3b",
            Id::Fig4a => "fig4a",
            Id::Fig4b => "fig4b",
            Id::Fig5 => "fig5",
            Id::Fig7 => "fig7",
            Id::Fig9 => "fig9",
            Id::Fig10a => "fig10a",
            Id::Fig10b => "fig10b",
            Id::Table1 => "table1",
        }
    }

    /// Its name in the paper, such as `Fig. 4a`.
    pub fn name(self) -> &'static str {
        match self {
            Id::Fig3b => "Fig. 3b",
            Id::Fig4a => "Fig. 4a",
            Id::Fig4b => "Fig. 4b",
            Id::Fig5 => "Fig. 5",
            Id::Fig7 => "Fig. 7",
            Id::Fig9 => "Fig. 9",
            Id::Fig10a => "Fig. 10a",
            Id::Fig10b => "Fig. 10b",
            Id::Table1 => "Table 1",
        }
    }

    /// The item of a word, as people write it: `4a`, `Fig. 4a`, `fig-4a`.
    pub fn of_word(text: &str) -> Option<Self> {
        let mut word: String = text
            .chars()
            .filter(char::is_ascii_alphanumeric)
            .map(|c| c.to_ascii_lowercase())
            .collect();
        for prefix in ["figure", "fig"] {
            if let Some(rest) = word.strip_prefix(prefix) {
                word = rest.to_owned();
                break;
            }
        }
        if word == "tab1" {
            return Some(Id::Table1);
        }
        Id::ALL
            .into_iter()
            .find(|id| id.word().trim_start_matches("fig") == word)
    }
}

/// One figure or table, recomputed.
#[derive(Clone, Debug)]
pub struct Item {
    /// Which.
    pub id: Id,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// How it was recomputed: a paragraph.
    pub about: String,
    /// Numbers compared.
    pub checks: Vec<Check>,
    /// What it shows, as numbers.
    pub data: Vec<Data>,
    /// Shapes.
    pub pictures: Vec<Picture>,
    /// What to know when reading it, a paragraph each.
    pub notes: Vec<String>,
    /// What the paper's text does not give, a sentence each.
    pub missing: Vec<String>,
}

/// A number of the paper's beside ours.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What the number is.
    pub quantity: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The paper's value, in `unit`, where the text gives one.
    pub paper: Option<f64>,
    /// What is left out before the paper's value: `<` for a bound.
    pub relation: &'static str,
    /// Ours, in `unit`, where it can be computed.
    pub ours: Option<f64>,
    /// Decimals that mean something.
    pub decimals: usize,
    /// What the comparison says.
    pub verdict: Verdict,
}

/// What a comparison says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within the tolerance.
    Agrees,
    /// Outside it.
    Differs,
    /// The paper gives no value for what we compute.
    OursOnly,
    /// The text does not give what it takes to compute it.
    NotGiven,
}

impl Verdict {
    /// The verdict in one or two words.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Agrees => "agrees",
            Verdict::Differs => "differs",
            Verdict::OursOnly => "ours only",
            Verdict::NotGiven => "not given",
        }
    }
}

impl Check {
    /// A value that should be the paper's to within a tolerance.
    pub fn near(
        quantity: impl Into<String>,
        unit: &'static str,
        paper: f64,
        ours: f64,
        tolerance: f64,
    ) -> Self {
        // A last digit of the paper's that was rounded is no disagreement.
        let agrees = (ours - paper).abs() <= tolerance * (1.0 + 1e-12);
        Self::of(quantity, unit, Some(paper), Some(ours), agrees)
    }

    /// A value that the paper says is below a bound.
    pub fn below(quantity: impl Into<String>, unit: &'static str, paper: f64, ours: f64) -> Self {
        Self {
            relation: "<",
            ..Self::of(quantity, unit, Some(paper), Some(ours), ours < paper)
        }
    }

    /// A value that only we give.
    pub fn ours(quantity: impl Into<String>, unit: &'static str, ours: f64) -> Self {
        Self {
            verdict: Verdict::OursOnly,
            ..Self::of(quantity, unit, None, Some(ours), true)
        }
    }

    /// A value of the paper's that its text does not let us compute.
    pub fn not_given(quantity: impl Into<String>, unit: &'static str, paper: f64) -> Self {
        Self {
            verdict: Verdict::NotGiven,
            ..Self::of(quantity, unit, Some(paper), None, true)
        }
    }

    /// With so many decimals.
    pub fn decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }

    /// Ours less the paper's, in `unit`, where there are both and the paper's is no bound.
    pub fn difference(&self) -> Option<f64> {
        match (self.paper, self.ours, self.relation) {
            (Some(paper), Some(ours), "") => Some(ours - paper),
            _ => None,
        }
    }

    fn of(
        quantity: impl Into<String>,
        unit: &'static str,
        paper: Option<f64>,
        ours: Option<f64>,
        agrees: bool,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            unit,
            paper,
            relation: "",
            ours,
            decimals: 2,
            verdict: if agrees {
                Verdict::Agrees
            } else {
                Verdict::Differs
            },
        }
    }
}

/// A shape to be drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    /// What it shows, with its pull.
    pub title: String,
    /// A word for files, unique in its item.
    pub word: &'static str,
    /// The robot in its shape, and the obstacles.
    pub solved: Solved,
    /// The obstacles' names.
    pub names: Vec<Option<String>>,
}
