//! Start data by monodromy: solutions of one generic instance are carried along closed ways of the parameters.
//!
//! A closed way permutes the solutions, so a known solution may lead to an unknown one. The first solution is a random
//! four-bar, with points on its curve. Closed ways are followed until all [`CURVES`] are known (Sommese and Wampler
//! 2005, *The Numerical Solution of Systems of Polynomials Arising in Engineering and Science*, ch. 15).

use crate::numeric::random::Random;

use super::alt::{Displacements, Dyads};
use super::curve::{Distinct, invariants, smallest};
use super::start::Start;
use super::tracker::{Ending, USUAL, Way, polished, track};
use super::{C, CURVES, ZERO};

/// Maximum number of closed ways.
const MAX_WAYS: usize = 60;

/// A complex number whose magnitude is from ½ to 3/2.
fn complex(random: &mut Random) -> C {
    loop {
        let z = C::new(random.between(-1.5, 1.5), random.between(-1.5, 1.5));
        if (0.25..=2.25).contains(&z.norm_sqr()) {
            return z;
        }
    }
}

pub(super) fn displacements(random: &mut Random) -> Displacements {
    Displacements {
        forward: [(); 8].map(|()| complex(random)),
        backward: [(); 8].map(|()| complex(random)),
    }
}

/// Random dyads, and nine points on their curve.
pub(super) fn first(random: &mut Random) -> (Dyads, Displacements) {
    let at = [(); 8].map(|()| complex(random));
    let [x, a, y, b, x_bar, a_bar, y_bar, b_bar] = at;
    let mut given = Displacements {
        forward: [ZERO; 8],
        backward: [ZERO; 8],
    };
    for j in 0..8 {
        // With T = e^(iθ), the link of a dyad has its length if δδ̄ + pδ + qδ̄ + k = 0.
        let turn = complex(random);
        let back = turn.inv();
        let terms = |x: C, a: C, x_bar: C, a_bar: C| {
            let constant = x_bar * a + x * a_bar - x * a_bar * turn - a * x_bar * back;
            [x_bar * back - a_bar, x * turn - a, constant]
        };
        let [p, q, k] = terms(x, a, x_bar, a_bar);
        let [r, s, l] = terms(y, b, y_bar, b_bar);
        // The difference of the equations of both dyads gives δ = mδ̄ + n.
        let part = (p - r).inv();
        let (m, n) = ((s - q) * part, (l - k) * part);
        let half = (n + p * m + q) / (m * 2.0);
        let root = (half * half - (p * n + k) / m).sqrt();
        let bar = root - half;
        given.forward[j] = m * bar + n;
        given.backward[j] = bar;
    }
    (at, given)
}

impl Start {
    /// Computes start data; None if not all curves are found.
    pub fn make(seed: u64, mut progress: impl FnMut(usize)) -> Option<Self> {
        let mut random = Random(seed);
        let (at, here) = first(&mut random);
        let mut distinct = Distinct::default();
        distinct.add(&at, 0);
        let mut found = vec![at];
        for _ in 0..MAX_WAYS {
            let (p, q) = (displacements(&mut random), displacements(&mut random));
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
