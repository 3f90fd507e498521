//! Constraints of a study: comparisons of expressions over outputs.
//!
//! `force_max_n < 0.2`, `status == converged`, `abs(tip_x_mm - 40) <= 2 * reach_mm / 10`.

use super::output::Output;
use super::row::Verdict;

/// A constraint, read once.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    text: String,
    what: What,
}

#[derive(Clone, Debug, PartialEq)]
enum What {
    /// A comparison of the status with a word.
    Status { is: bool, verdict: Verdict },
    Numbers {
        left: Term,
        compare: Compare,
        right: Term,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Compare {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    Unequal,
}

#[derive(Clone, Debug, PartialEq)]
enum Term {
    Number(f64),
    Output(Output),
    Negative(Box<Term>),
    Amount(Box<Term>),
    Two(Operation, Box<Term>, Box<Term>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// Terms inside one another: more is a slip or an attack on the stack.
const DEEPEST: usize = 64;

impl Constraint {
    /// The constraint that a text says.
    ///
    /// # Errors
    /// The end of a sentence on what is wrong with it.
    pub fn new(text: &str) -> Result<Self, String> {
        let mut reader = Reader {
            rest: text,
            depth: 0,
        };
        let what = reader.constraint()?;
        Ok(Self {
            text: text.to_owned(),
            what,
        })
    }

    /// As it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The outputs that it looks at.
    pub fn outputs(&self) -> Vec<Output> {
        let mut outputs = Vec::new();
        match &self.what {
            What::Status { .. } => outputs.push(Output::Status),
            What::Numbers { left, right, .. } => {
                left.collect(&mut outputs);
                right.collect(&mut outputs);
            }
        }
        outputs
    }

    /// Whether a sample meets it; not where a number that it looks at is missing, `None`
    /// of `value`.
    pub(super) fn holds(&self, verdict: Verdict, value: impl Fn(Output) -> Option<f64>) -> bool {
        match &self.what {
            What::Status { is, verdict: word } => (verdict == *word) == *is,
            What::Numbers {
                left,
                compare,
                right,
            } => {
                let (Some(left), Some(right)) = (left.value(&value), right.value(&value)) else {
                    return false;
                };
                match compare {
                    Compare::Less => left < right,
                    Compare::LessOrEqual => left <= right,
                    Compare::Greater => left > right,
                    Compare::GreaterOrEqual => left >= right,
                    Compare::Equal => left == right,
                    Compare::Unequal => left != right,
                }
            }
        }
    }
}

impl Term {
    fn collect(&self, outputs: &mut Vec<Output>) {
        match self {
            Term::Number(_) => {}
            Term::Output(output) => outputs.push(*output),
            Term::Negative(term) | Term::Amount(term) => term.collect(outputs),
            Term::Two(_, left, right) => {
                left.collect(outputs);
                right.collect(outputs);
            }
        }
    }

    fn value(&self, of: &impl Fn(Output) -> Option<f64>) -> Option<f64> {
        let value = match self {
            Term::Number(number) => *number,
            Term::Output(output) => of(*output)?,
            Term::Negative(term) => -term.value(of)?,
            Term::Amount(term) => term.value(of)?.abs(),
            Term::Two(operation, left, right) => {
                let (left, right) = (left.value(of)?, right.value(of)?);
                match operation {
                    Operation::Add => left + right,
                    Operation::Subtract => left - right,
                    Operation::Multiply => left * right,
                    Operation::Divide => left / right,
                }
            }
        };
        value.is_finite().then_some(value)
    }
}

struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    fn take(&mut self, sign: &str) -> bool {
        self.rest = self.rest.trim_start();
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn compare(&mut self) -> Option<Compare> {
        // The longer ones first.
        let signs = [
            ("<=", Compare::LessOrEqual),
            (">=", Compare::GreaterOrEqual),
            ("==", Compare::Equal),
            ("!=", Compare::Unequal),
            ("<", Compare::Less),
            (">", Compare::Greater),
        ];
        signs
            .into_iter()
            .find(|(sign, _)| self.take(sign))
            .map(|(_, compare)| compare)
    }

    fn constraint(&mut self) -> Result<What, String> {
        let what = if self.begins_with_status() {
            self.status()?
        } else {
            let left = self.sum()?;
            let Some(compare) = self.compare() else {
                return Err(format!(
                    "compares nothing{}; write two terms with one of <, <=, >, >=, ==, != \
                     between them",
                    self.before_the_rest()
                ));
            };
            let right = self.sum()?;
            What::Numbers {
                left,
                compare,
                right,
            }
        };
        if !self.rest.trim().is_empty() {
            return Err(format!("goes on after its end{}", self.before_the_rest()));
        }
        Ok(what)
    }

    fn before_the_rest(&self) -> String {
        match self.rest.trim() {
            "" => String::new(),
            rest => format!(" at `{}`", rest.chars().take(20).collect::<String>()),
        }
    }

    fn begins_with_status(&mut self) -> bool {
        let before = self.rest;
        let is = self.word() == Output::Status.name();
        if !is {
            self.rest = before;
        }
        is
    }

    fn status(&mut self) -> Result<What, String> {
        let is = match self.compare() {
            Some(Compare::Equal) => true,
            Some(Compare::Unequal) => false,
            _ => return Err("compares the status; write it with == or !=".to_owned()),
        };
        let word = self.word().to_owned();
        let Some(verdict) = Verdict::of_word(&word) else {
            let words: Vec<_> = Verdict::ALL.iter().map(|verdict| verdict.word()).collect();
            return Err(format!(
                "compares the status with `{word}`, which is none; use one of {}",
                words.join(", ")
            ));
        };
        Ok(What::Status { is, verdict })
    }

    /// Letters, digits and underscores.
    fn word(&mut self) -> &str {
        self.rest = self.rest.trim_start();
        let end = self
            .rest
            .find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        word
    }

    fn sum(&mut self) -> Result<Term, String> {
        let mut sum = self.product()?;
        loop {
            let operation = if self.take("+") {
                Operation::Add
            } else if self.take("-") {
                Operation::Subtract
            } else {
                return Ok(sum);
            };
            sum = self.two(operation, sum, Self::product)?;
        }
    }

    fn product(&mut self) -> Result<Term, String> {
        let mut product = self.factor()?;
        loop {
            let operation = if self.take("*") {
                Operation::Multiply
            } else if self.take("/") {
                Operation::Divide
            } else {
                return Ok(product);
            };
            product = self.two(operation, product, Self::factor)?;
        }
    }

    fn two(
        &mut self,
        operation: Operation,
        left: Term,
        right: impl Fn(&mut Self) -> Result<Term, String>,
    ) -> Result<Term, String> {
        self.deeper()?;
        let right = right(self)?;
        Ok(Term::Two(operation, Box::new(left), Box::new(right)))
    }

    fn deeper(&mut self) -> Result<(), String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!(
                "has more than {DEEPEST} operations; write it shorter"
            ));
        }
        Ok(())
    }

    fn factor(&mut self) -> Result<Term, String> {
        if self.take("-") {
            self.deeper()?;
            return Ok(Term::Negative(Box::new(self.factor()?)));
        }
        if self.take("(") {
            return self.bracket();
        }
        self.rest = self.rest.trim_start();
        if self
            .rest
            .starts_with(|c: char| c.is_ascii_digit() || c == '.')
        {
            return self.number();
        }
        let word = self.word().to_owned();
        match word.as_str() {
            "" => Err(format!(
                "lacks a number or an output{}",
                self.before_the_rest()
            )),
            "abs" if self.take("(") => Ok(Term::Amount(Box::new(self.bracket()?))),
            "status" => {
                Err("compares the status with a number; write status == converged".to_owned())
            }
            name => match Output::of_name(name) {
                Ok(output) => Ok(Term::Output(output)),
                Err(Some(near)) => Err(format!(
                    "names `{name}`, which is no output; did you mean `{near}`?"
                )),
                Err(None) => Err(format!(
                    "names `{name}`, which is no output; `sinew explore --outputs` lists them"
                )),
            },
        }
    }

    fn bracket(&mut self) -> Result<Term, String> {
        self.deeper()?;
        let inner = self.sum()?;
        if !self.take(")") {
            return Err(format!("lacks a closing bracket{}", self.before_the_rest()));
        }
        Ok(inner)
    }

    fn number(&mut self) -> Result<Term, String> {
        // With the sign of an exponent, which would be an operation elsewhere.
        let mut before = ' ';
        let end = self.rest.find(|c: char| {
            let goes_on = c.is_ascii_alphanumeric()
                || c == '.'
                || (matches!(c, '+' | '-') && matches!(before, 'e' | 'E'));
            before = c;
            !goes_on
        });
        let (number, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        let parsed: Option<f64> = number.parse().ok().filter(|value: &f64| value.is_finite());
        let term = parsed.map(Term::Number);
        let term = term.ok_or_else(|| format!("has `{number}`, which is no number"))?;
        self.rest = rest;
        Ok(term)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether it holds of a converged sample with force 0.1 N, tip x −40 mm, and
    /// without a first contact.
    fn check(text: &str, expected: bool) {
        let constraint = Constraint::new(text).unwrap();
        let holds = constraint.holds(Verdict::Converged, |output| match output {
            Output::ForceMax => Some(0.1),
            Output::TipX => Some(-40.0),
            _ => None,
        });
        assert_eq!(holds, expected, "{text}");
    }

    #[test]
    fn comparisons_are_those_of_numbers() {
        check("force_max_n < 0.2", true);
        check("force_max_n>=0.2", false);
        check("force_max_n <= 1e-1", true);
        check("0.1 == force_max_n", true);
        check("force_max_n != 0.1", false);
        check("tip_x_mm < -39", true);
        check("abs(tip_x_mm + 30) <= 10", true);
        check("2 + 3 * 4 == 14", true);
        check("(2 + 3) * 4 == 20", true);
        check("8 - 4 - 2 == 2", true);
        check("8 / 4 / 2 == 1", true);
        check("-(-2) == 2", true);
    }

    #[test]
    fn the_status_is_compared_by_its_word() {
        check("status == converged", true);
        check("status != converged", false);
        check("status == branch_ended", false);
    }

    #[test]
    fn what_is_missing_meets_nothing() {
        check("first_contact_pull_mm < 3", false);
        check("first_contact_pull_mm >= 3", false);
        check("1 / (force_max_n - force_max_n) > 3", false);
    }

    #[test]
    fn slips_are_told() {
        let told = |text: &str, expected: &str| {
            let found = Constraint::new(text).unwrap_err();
            assert!(found.contains(expected), "{text}: {found}");
        };
        told("force_max < 0.2", "did you mean `force_max_n`?");
        told("banana < 0.2", "sinew explore --outputs");
        told("force_max_n", "compares nothing");
        told("force_max_n = 3", "compares nothing at `= 3`");
        told("force_max_n < ", "lacks a number or an output");
        told("(force_max_n < 2", "lacks a closing bracket");
        told("force_max_n < 2 < 3", "goes on after its end at `< 3`");
        told("force_max_n < 2.3.4", "`2.3.4`, which is no number");
        told("force_max_n < 1e999", "which is no number");
        told("status == fine", "converged, infeasible");
        told("status < 3", "== or !=");
        told("1 < status", "write status == converged");
        told("", "lacks a number");
        told(&"(".repeat(100_000), "write it shorter");
        told(
            &("1".to_owned() + &"+1".repeat(100_000)),
            "write it shorter",
        );
    }
}
