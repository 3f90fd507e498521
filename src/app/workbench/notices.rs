//! What is being told in passing: what went well, for a few seconds; what did
//! not, until it is dismissed.

/// Seconds that a quiet notice stays.
const STAYS: f64 = 4.0;
/// Notices that are shown at a time.
const MOST: usize = 4;

/// How a notice is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Something was done.
    Success,
    /// Something is to be known.
    Information,
    /// Something went wrong.
    Trouble,
}

/// Something to be told.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// How it is meant.
    pub tone: Tone,
    /// A sentence.
    pub text: String,
    /// When it goes, in seconds of the window's clock, once it was shown.
    until: Option<f64>,
}

impl Notice {
    /// Something was done.
    pub fn success(text: impl Into<String>) -> Self {
        Self::new(Tone::Success, text)
    }

    /// Something is to be known.
    pub fn information(text: impl Into<String>) -> Self {
        Self::new(Tone::Information, text)
    }

    /// Something went wrong.
    pub fn trouble(text: impl Into<String>) -> Self {
        Self::new(Tone::Trouble, text)
    }

    fn new(tone: Tone, text: impl Into<String>) -> Self {
        Self {
            tone,
            text: text.into(),
            until: None,
        }
    }
}

/// What is being told.
#[derive(Debug, Default)]
pub struct Notices {
    shown: Vec<Notice>,
}

impl Notices {
    /// Tells something. What is being told already is told anew, not twice.
    pub fn tell(&mut self, notice: Notice) {
        self.shown.retain(|known| known.text != notice.text);
        self.shown.push(notice);
        if self.shown.len() > MOST {
            self.shown.remove(0);
        }
    }

    /// What is being told.
    pub fn iter(&self) -> impl Iterator<Item = &Notice> {
        self.shown.iter()
    }

    /// Drops those whose time has come, given the window's clock in seconds;
    /// how long, in seconds, until the next one goes.
    pub fn pass(&mut self, now: f64) -> Option<f64> {
        let mut next: Option<f64> = None;
        for notice in &mut self.shown {
            if notice.tone == Tone::Trouble {
                continue;
            }
            let until = *notice.until.get_or_insert(now + STAYS);
            if until > now {
                let left = until - now;
                next = Some(next.map_or(left, |other| other.min(left)));
            }
        }
        self.shown
            .retain(|notice| notice.until.is_none_or(|until| until > now));
        next
    }

    /// Whether nothing is being told.
    pub fn is_empty(&self) -> bool {
        self.shown.is_empty()
    }

    /// Drops one, by its place.
    pub fn dismiss(&mut self, index: usize) {
        self.shown.remove(index);
    }
}
