//! The distance of many points from one line of links. Its parts are bounded by
//! their chords: no point of a part is farther from its chord than it sags.

use crate::geometry::Vector;

/// Links in the shortest parts.
const SHORTEST: usize = 4;

/// A line of links.
pub(super) struct Links {
    /// Where links begin and end, at least two.
    joints: Vec<Vector>,
    /// How far each part sags from its chord at most, in metres: a binary tree,
    /// the whole line at 1, the halves of the part at k at 2k and 2k + 1.
    sags: Vec<f64>,
    /// The link that was nearest to the last point.
    nearest: usize,
}

/// A part of the line.
#[derive(Clone, Copy)]
struct Part {
    /// Its place in the tree.
    index: usize,
    /// Its first link, from 0.
    first: usize,
    /// How many links it has, unless the line ends before.
    size: usize,
}

impl Part {
    fn halves(self) -> [Part; 2] {
        let size = self.size / 2;
        [0, 1].map(|k| Part {
            index: 2 * self.index + k,
            first: self.first + k * size,
            size,
        })
    }
}

impl Links {
    /// A line through its joints, at least two.
    pub fn new(joints: Vec<Vector>) -> Self {
        let leaves = (joints.len() - 1).div_ceil(SHORTEST).next_power_of_two();
        let mut links = Self {
            joints,
            sags: vec![0.0; 2 * leaves],
            nearest: 0,
        };
        links.find_sag(links.whole());
        links
    }

    /// The distance of a point from the nearest link, in metres.
    pub fn distance(&mut self, point: Vector) -> f64 {
        let known = self.chord_distance(self.nearest, self.nearest + 1, point);
        let whole = self.whole();
        self.nearer(whole, self.bound(whole, point), point, known)
    }

    fn whole(&self) -> Part {
        Part {
            index: 1,
            first: 0,
            size: SHORTEST * self.sags.len() / 2,
        }
    }

    /// The joints at a part's ends; the same one where the line ends before.
    fn ends(&self, part: Part) -> (usize, usize) {
        let last = self.joints.len() - 1;
        (part.first.min(last), (part.first + part.size).min(last))
    }

    /// A part sags by no more than its middle joint or ends do, and its halves
    /// from their own chords.
    fn find_sag(&mut self, part: Part) -> f64 {
        let (start, end) = self.ends(part);
        let chord_distance =
            |links: &Self, joint| links.chord_distance(start, end, links.joints[joint]);
        let sag = if part.size == SHORTEST {
            (start..end)
                .map(|joint| chord_distance(self, joint))
                .fold(0.0, f64::max)
        } else {
            let halves = part.halves();
            let (middle, _) = self.ends(halves[1]);
            let [a, b] = halves.map(|half| self.find_sag(half));
            chord_distance(self, middle) + a.max(b)
        };
        self.sags[part.index] = sag;
        sag
    }

    /// Below the distance of every link of a part.
    fn bound(&self, part: Part, point: Vector) -> f64 {
        let (start, end) = self.ends(part);
        self.chord_distance(start, end, point) - self.sags[part.index]
    }

    /// The distance from the nearest link of a part, if that is below what is
    /// known, and else what is known.
    fn nearer(&mut self, part: Part, bound: f64, point: Vector, known: f64) -> f64 {
        if bound >= known {
            return known;
        }
        let mut least = known;
        if part.size > SHORTEST {
            let mut halves = part.halves().map(|half| (half, self.bound(half, point)));
            if halves[1].1 < halves[0].1 {
                halves.reverse();
            }
            for (half, bound) in halves {
                least = self.nearer(half, bound, point, least);
            }
            return least;
        }
        let (start, end) = self.ends(part);
        for link in start..end {
            let distance = self.chord_distance(link, link + 1, point);
            if distance < least {
                (least, self.nearest) = (distance, link);
            }
        }
        least
    }

    /// The distance of a point from the straight line between two joints.
    fn chord_distance(&self, start: usize, end: usize, point: Vector) -> f64 {
        let (start, end) = (self.joints[start], self.joints[end]);
        let (way, offset) = (end - start, point - start);
        let squared = way.norm_squared();
        let along = if squared > 0.0 {
            (offset.dot(&way) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (offset - along * way).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line of links of length 1, each turned from the one before by twice the
    /// angle of this tangent.
    fn line(tangents: impl Iterator<Item = f64>) -> Vec<Vector> {
        let (mut place, mut link) = (Vector::zeros(), Vector::new(0.0, 1.0));
        let mut joints = vec![place];
        for t in tangents {
            let turned = (1.0 - t * t) * link + 2.0 * t * Vector::new(-link.y, link.x);
            link = turned / (1.0 + t * t);
            place += link;
            joints.push(place);
        }
        joints
    }

    #[test]
    fn the_nearest_link_is_found_wherever_the_last_was() {
        let straight = line((0..50).map(|_| 0.0));
        // A spiral of four turns, which lies beside itself.
        let spiral = line((0..400).map(|k| 0.05 - 1e-4 * f64::from(k)));
        let wave = line((0..301).map(|k| 0.01 * f64::from(k % 33 - 16)));
        for joints in [line([0.3].into_iter()), straight, spiral, wave] {
            let count = joints.len() - 1;
            let mut links = Links::new(joints);
            for k in 0..2000 {
                let (x, y) = (f64::from(k * 37 % 101), f64::from(k * 53 % 97));
                let point = Vector::new(1.3 * x - 65.0, 1.7 * y - 60.0);
                let all = (0..count).map(|link| links.chord_distance(link, link + 1, point));
                let least = all.fold(f64::INFINITY, f64::min);
                // Chords and links round differently.
                assert!((links.distance(point) - least).abs() < 1e-11, "{point}");
            }
        }
    }
}
