//! Start data by monodromy: solutions of one generic instance are carried along closed ways of the parameters.
//!
//! A closed way permutes the solutions, so known ones end in others. One four-bar is made with points on its curve; the
//! ways go on until all [`CURVES`] are known (Sommese and Wampler 2005, *The Numerical Solution of Systems of
//! Polynomials Arising in Engineering and Science*, ch. 15).

use super::alt::{Displacements, Dyads};
use super::curve::{Distinct, invariants, smallest};
use super::start::Start;
use super::tracker::{Ending, USUAL, Way, polished, track};
use super::{C, CURVES, ZERO};

/// Closed ways after which the search is given up.
const MAX_WAYS: usize = 60;

/// Pseudorandom numbers, the same for the same seed (splitmix64), without functions that differ between platforms.
#[derive(Clone, Debug)]
pub(super) struct Random(pub(super) u64);

impl Random {
    /// A number from 0 to 1.
    pub(super) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A complex number whose magnitude is from ½ to 3/2.
    pub(super) fn complex(&mut self) -> C {
        loop {
            let z = C::new(3.0 * self.unit() - 1.5, 3.0 * self.unit() - 1.5);
            if (0.25..=2.25).contains(&z.norm_sqr()) {
                return z;
            }
        }
    }

    pub(super) fn displacements(&mut self) -> Displacements {
        Displacements {
            forward: [(); 8].map(|()| self.complex()),
            backward: [(); 8].map(|()| self.complex()),
        }
    }
}

/// Random dyads, and nine points on their curve.
pub(super) fn first(random: &mut Random) -> (Dyads, Displacements) {
    let at = [(); 8].map(|()| random.complex());
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = at;
    let mut displacements = Displacements {
        forward: [ZERO; 8],
        backward: [ZERO; 8],
    };
    for j in 0..8 {
        // With T = e^(iθ) a dyad is at length if δδ̄ + pδ + qδ̄ + k = 0.
        let turn = random.complex();
        let back = turn.inv();
        let terms = |x: C, a: C, x_bar: C, a_bar: C| {
            let constant = x_bar * a + x * a_bar - x * a_bar * turn - a * x_bar * back;
            [x_bar * back - a_bar, x * turn - a, constant]
        };
        let [p, q, k] = terms(x, a, x_bar, a_bar);
        let [r, s, l] = terms(y, b, y_bar, b_bar);
        // The difference of both gives δ = mδ̄ + n.
        let part = (p - r).inv();
        let (m, n) = ((s - q) * part, (l - k) * part);
        let half = (n + p * m + q) / (m * 2.0);
        let root = (half * half - (p * n + k) / m).sqrt();
        let bar = root - half;
        displacements.forward[j] = m * bar + n;
        displacements.backward[j] = bar;
    }
    (at, displacements)
}

impl Start {
    /// Start data made anew; None if not all curves are found.
    pub fn make(seed: u64, mut progress: impl FnMut(usize)) -> Option<Self> {
        let mut random = Random(seed);
        let (at, here) = first(&mut random);
        let mut distinct = Distinct::default();
        distinct.add(&at, 0);
        let mut found = vec![at];
        for _ in 0..MAX_WAYS {
            let (p, q) = (random.displacements(), random.displacements());
            let ways = [Way::new(here, &p), Way::new(p, &q), Way::new(q, &here)];
            for k in 0..found.len() {
                let end = ways
                    .iter()
                    .try_fold(found[k], |at, way| match track(&at, way, USUAL) {
                        Ending::Solution(at) => Some(at),
                        Ending::Singular | Ending::Lost => None,
                    });
                if let Some(end) = end.and_then(|end| polished(smallest(&end), &here))
                    && distinct.add(&end, found.len()).is_none()
                {
                    found.push(end);
                }
            }
            progress(found.len());
            if found.len() >= CURVES {
                break;
            }
        }
        found.sort_by(|p, q| invariants(p)[0].re.total_cmp(&invariants(q)[0].re));
        (found.len() == CURVES).then_some(Self {
            displacements: here,
            dyads: found,
        })
    }
}
