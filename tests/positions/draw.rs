//! Random tasks and linkages from a fixed seed.

use std::f64::consts::TAU;

use assur::synthesis::four_bar::{Frame, Position, Proportions, Task};

/// A generator of numbers (Steele, Lea and Flood's SplitMix64, 2014).
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly between two numbers.
    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (self.bits() >> 11) as f64 / (1_u64 << 53) as f64 * (to - from)
    }

    pub(crate) fn angle(&mut self) -> f64 {
        self.between(0.0, TAU)
    }

    /// A ratio of lengths.
    pub(crate) fn ratio(&mut self, most: f64) -> f64 {
        self.between(-most.ln(), most.ln()).exp()
    }

    pub(crate) fn proportions(&mut self, most: f64) -> Proportions {
        let [coupler, output, input] = [(); 3].map(|()| self.ratio(most));
        Proportions {
            coupler,
            output,
            input,
        }
    }

    pub(crate) fn positions(&mut self, count: usize) -> Vec<Position> {
        (0..count)
            .map(|_| Position::new(self.angle(), self.angle()))
            .collect()
    }

    /// Positions that a linkage takes up at random inputs, each in either assembly; none where it
    /// cannot be closed at any of a hundred.
    pub(crate) fn taken(&mut self, z: &Proportions, count: usize) -> Option<Vec<Position>> {
        let mut found = Vec::new();
        for _ in 0..100 {
            let input = self.angle();
            let up = self.between(0.0, 1.0) < 0.5;
            found.extend(output(z, input, up).map(|output| Position::new(output, input)));
            if found.len() == count {
                return Some(found);
            }
        }
        None
    }
}

/// φ₂ of a linkage whose frame is along the x-axis, apart from the engine: from B and D to C by the
/// cosine rule, then from C to D.
pub(crate) fn output(z: &Proportions, input: f64, up: bool) -> Option<f64> {
    let [x, y] = [1.0 - z.input * input.cos(), -z.input * input.sin()];
    let diagonal = x.hypot(y);
    let cos = (diagonal * diagonal + z.output * z.output - z.coupler * z.coupler)
        / (2.0 * diagonal * z.output);
    if cos.abs() > 1.0 {
        return None;
    }
    let at_d = if up { -cos.acos() } else { cos.acos() };
    // D − C is turned from D − B by the angle at D.
    Some(y.atan2(x) - at_d)
}

pub(crate) fn task(positions: &[Position]) -> Task {
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    Task::new(frame, positions, Task::RATIOS).unwrap()
}
