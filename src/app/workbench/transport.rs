//! The pull over time: playing it back and forth, and the span that its slider
//! covers.

use crate::units::{METRES_PER_MM, metres, millimetres};
use std::f64::consts::PI;

/// Frames that take longer than this many seconds play on as if they had not.
const LONGEST_FRAME: f64 = 0.1;

/// Playing the pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transport {
    playing: Option<Direction>,
    /// Whether it turns round at the ends of the span; otherwise it stops.
    pub looping: bool,
    /// Millimetres of cable a second.
    pub speed_mm: f64,
    /// Grams a second, where the load is held.
    pub speed_g: f64,
    /// Whether in the paper's model, where the stiffness is known, the slider and the
    /// field beside it set the load that hangs on the cable in the place of the pull.
    /// Where cables slide it is the scene that says what is held.
    pub by_load: bool,
    /// The cable that slider and field are of, where there are several, from 0.
    pub cable: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    In,
    Out,
}

impl Default for Transport {
    fn default() -> Self {
        Self {
            playing: None,
            looping: true,
            speed_mm: 2.0,
            speed_g: 50.0,
            by_load: false,
            cable: 0,
        }
    }
}

impl Transport {
    /// Speeds that are offered, in millimetres of cable a second.
    pub const SPEEDS_MM: [f64; 5] = [0.5, 1.0, 2.0, 5.0, 10.0];

    /// Speeds that are offered where the load is held, in grams a second.
    pub const SPEEDS_G: [f64; 6] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0];

    /// Whether the pull is moving.
    pub fn is_playing(&self) -> bool {
        self.playing.is_some()
    }

    /// Starts at a pull, or stops. At the end of the span it starts over.
    pub fn toggle(&mut self, value: &mut f64, span: (f64, f64)) {
        if self.playing.take().is_none() {
            if *value >= span.1 && !self.looping {
                *value = span.0;
            }
            self.playing = Some(Direction::In);
        }
    }

    /// Stops.
    pub fn stop(&mut self) {
        self.playing = None;
    }

    /// Moves a pull or a load as far as it gets in some seconds, at so much a second.
    pub fn advance(&mut self, value: &mut f64, span: (f64, f64), speed: f64, seconds: f64) {
        let Some(direction) = self.playing else {
            return;
        };
        let step = speed * seconds.clamp(0.0, LONGEST_FRAME);
        match direction {
            Direction::In => *value += step,
            Direction::Out => *value -= step,
        }
        if *value >= span.1 {
            *value = span.1;
            self.playing = self.looping.then_some(Direction::Out);
        } else if *value <= span.0 {
            *value = span.0;
            self.playing = self.looping.then_some(Direction::In);
        }
    }
}

/// The pulls that the slider offers, in mm: from none to half a turn of the
/// free robot, as far as the linkages allow, and to the present pull where it
/// is beyond. The cable's offset is in mm, what the linkages allow in metres.
pub fn span_mm(offset_mm: f64, allowed: (f64, f64), pull_mm: f64) -> (f64, f64) {
    let half_turn = PI * metres(offset_mm);
    // Ends that the linkages allow, and that read well.
    let most = half_turn.min(0.98 * allowed.1);
    let most_mm = (millimetres(most) * 2.0).floor() / 2.0;
    let most_mm = if most_mm > 0.0 {
        most_mm
    } else {
        most / METRES_PER_MM
    };
    (0.0_f64.min(pull_mm), most_mm.max(pull_mm))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPAN: (f64, f64) = (0.0, 10.0);

    #[test]
    fn a_loop_turns_round_at_both_ends() {
        let mut transport = Transport::default();
        let mut pull = 9.9;
        transport.toggle(&mut pull, SPAN);
        transport.advance(&mut pull, SPAN, 2.0, 0.1);
        assert_eq!(pull, 10.0);
        transport.advance(&mut pull, SPAN, 2.0, 0.1);
        assert!((pull - 9.8).abs() < 1e-12, "{pull}");
        pull = 0.1;
        transport.advance(&mut pull, SPAN, 2.0, 0.1);
        transport.advance(&mut pull, SPAN, 2.0, 0.1);
        assert!(pull > 0.1 && transport.is_playing());
    }

    #[test]
    fn without_a_loop_it_stops_at_the_end_and_starts_over() {
        let mut transport = Transport {
            looping: false,
            ..Transport::default()
        };
        let mut pull = 9.9;
        transport.toggle(&mut pull, SPAN);
        transport.advance(&mut pull, SPAN, 2.0, 0.1);
        assert!(!transport.is_playing());
        assert_eq!(pull, 10.0);
        transport.toggle(&mut pull, SPAN);
        assert_eq!(pull, 0.0);
        // A frame that hangs does not make it jump.
        transport.advance(&mut pull, SPAN, 2.0, 60.0);
        assert!((pull - 0.2).abs() < 1e-12, "{pull}");
    }

    #[test]
    fn the_slider_reaches_half_a_turn_and_the_present_pull() {
        assert_eq!(span_mm(8.0, (-1.0, 1.0), 4.9), (0.0, 25.0));
        assert_eq!(span_mm(8.0, (-1.0, 0.01), 4.9), (0.0, 9.5));
        assert_eq!(span_mm(8.0, (-1.0, 1.0), -3.0), (-3.0, 25.0));
        assert_eq!(span_mm(8.0, (-1.0, 1.0), 40.0), (0.0, 40.0));
    }
}
