//! Positions of the linkage's points, their differences, and the ratios of sides of the rigid triangles.

use crate::position::quotient;
use crate::{JetPoint, Vector};

/// A vector with two derivatives with respect to the crank angle.
pub(super) type Way = [Vector; 3];

/// Positions of the linkage's points relative to A, each with two derivatives.
#[derive(Clone, Debug)]
pub(super) struct Places {
    pub(super) b: Way,
    pub(super) c: Way,
    pub(super) e: Way,
    pub(super) f: Way,
    pub(super) g: Way,
    pub(super) k: Way,
    pub(super) l: Way,
    d: Way,
    h: Way,
}

impl Places {
    /// Calculates the relative positions from the points A, B, C, D, E, F, G, H, K, L, in this order.
    pub(super) fn new(points: [JetPoint<3>; 10]) -> Self {
        let of = |point: &JetPoint<3>| [0, 1, 2].map(|order| point.derivative(order));
        let [a, rest @ ..] = points;
        let a = of(&a);
        let [b, c, d, e, f, g, h, k, l] = rest.map(|point| between(of(&point), a));
        Self {
            b,
            c,
            e,
            f,
            g,
            k,
            l,
            d,
            h,
        }
    }

    pub(super) fn eb(&self) -> Way {
        between(self.e, self.b)
    }

    pub(super) fn eg(&self) -> Way {
        between(self.e, self.g)
    }

    pub(super) fn gh(&self) -> Way {
        between(self.g, self.h)
    }

    pub(super) fn gf(&self) -> Way {
        between(self.g, self.f)
    }

    pub(super) fn fk(&self) -> Way {
        between(self.f, self.k)
    }

    pub(super) fn kc(&self) -> Way {
        between(self.k, self.c)
    }

    pub(super) fn lc(&self) -> Way {
        between(self.l, self.c)
    }

    pub(super) fn cd(&self) -> Way {
        between(self.c, self.d)
    }

    pub(super) fn fe(&self) -> Way {
        between(self.f, self.e)
    }

    pub(super) fn lg(&self) -> Way {
        between(self.l, self.g)
    }

    pub(super) fn lk(&self) -> Way {
        between(self.l, self.k)
    }

    pub(super) fn lh(&self) -> Way {
        between(self.l, self.h)
    }

    /// f_L of (3): the ratio of the vectors HL and HG as complex numbers.
    pub(super) fn f_l(&self) -> Vector {
        quotient(self.lh()[0], self.gh()[0])
    }

    /// f_F of (4): the ratio of the vectors GF and GE as complex numbers.
    pub(super) fn f_f(&self) -> Vector {
        quotient(-self.gf()[0], self.eg()[0])
    }

    /// f_K of (5): the ratio of the vectors CK and CL as complex numbers.
    pub(super) fn f_k(&self) -> Vector {
        quotient(self.kc()[0], self.lc()[0])
    }

    /// First or second derivative, ψ′ or ψ″, of the angle of the link CD, from `c`, the derivative of the same order of
    /// the position of C. The component of `c` along CD has no effect.
    pub(super) fn turned(&self, c: Vector) -> f64 {
        let cd = self.cd()[0];
        cd.perp(&c) / cd.norm_squared()
    }
}

fn between(to: Way, from: Way) -> Way {
    [0, 1, 2].map(|order| to[order] - from[order])
}
