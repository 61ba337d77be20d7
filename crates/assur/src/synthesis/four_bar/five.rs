//! Five positions with free starting angles: at most three linkages, in closed form.
//!
//! Let the frame have the length 1, and let z₁, z₂ and z₃ be the lengths of coupler, output and input link. Let w₂ =
//! z₂e^{iφ₂₀} and w₃ = z₃e^{iφ₃₀} with the unknown starting angles φ₂₀ and φ₃₀, and let A = e^{iφ₂} and B = e^{iφ₃} be
//! the given rotations from these angles. Then |w₂A + w₃B − 1|² = z₁² reads
//!
//! s + Re(m A B̄) − Re(w₂A) − Re(w₃B) = 0,  s = (|w₂|² + |w₃|² + 1 − z₁²)/2,  m = w₂ w̄₃.
//!
//! This equation is linear and homogeneous in seven real numbers: s and the real and imaginary parts of w₂, w₃ and m.
//! Five positions leave a plane of solutions λX + μY. Let X₂, X₃ and Xₘ be the components of X for w₂, w₃ and m, let
//! Y₂, Y₃ and Yₘ be those of Y, and let t = μ/λ. Then m = w₂ w̄₃ reads Xₘ + tYₘ = λ(X₂ + tY₂)(X₃ + tY₃)̄. As λ is
//! real, Xₘ + tYₘ and the product have a real ratio, which makes t a root of a cubic.

use crate::sorting::sort_by;
use crate::tolerance;
use nalgebra::Complex;

use super::closure::dot;
use super::{Proportions, Solution, Task};
use crate::numeric::newton::descended;
use crate::numeric::{linear, max_abs, polynomial};

/// Reasons why positions with free starting angles cannot be solved in closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartsError {
    /// Fewer than five positions have a family of solutions with this many degrees of freedom.
    Family {
        /// Five less the number of positions.
        freedoms: usize,
    },
    /// More than five positions have only approximate solutions, which [`Search`](super::Search) finds.
    TooMany,
    /// Special positions, such as those of a parallelogram: they have infinitely many linkages.
    Degenerate,
}

/// Finds all linkages through the five positions of a task, at most three, by increasing √(z₂² + z₃²). φ₂ and φ₃ of the
/// task are measured from unknown starting angles, which are found together with the lengths.
///
/// # Errors
/// The number of positions is not five, or the positions are special.
pub fn five_positions(task: &Task) -> Result<Vec<Solution>, StartsError> {
    match task.positions().len() {
        5 => {
            let found = of(task, [0, 1, 2, 3, 4])?.into_iter();
            let all =
                found.map(|(proportions, starts)| Solution::started(task, proportions, starts));
            Ok(all.collect())
        }
        count if count < 5 => Err(StartsError::Family {
            freedoms: 5 - count,
        }),
        _ => Err(StartsError::TooMany),
    }
}

/// Proportions with the starting angles φ₂₀ and φ₃₀ of output and input, radians.
pub(super) type Started = (Proportions, [f64; 2]);

/// Proportions with starting angles for five positions of a task.
pub(super) fn of(task: &Task, five: [usize; 5]) -> Result<Vec<Started>, StartsError> {
    let turns = five.map(|k| {
        let at = task.direction(k, [0.0; 2]);
        [at.output, at.input]
    });
    let rows = turns.map(|[a, b]| {
        let c = a * b.conj();
        [1.0, -a.re, a.im, -b.re, b.im, c.re, -c.im]
    });
    // An orthonormal basis keeps the roots t moderate.
    let [x, y] = linear::null_plane(&rows).ok_or(StartsError::Degenerate)?;
    let parts = |v: &[f64; 7]| [1, 3, 5].map(|k| Complex::new(v[k], v[k + 1]));
    let ([x2, x3, xm], [y2, y3, ym]) = (parts(&x), parts(&y));
    // The cubic: (Xₘ + tYₘ) times the conjugate of (X₂ + tY₂)(X₃ + tY₃)̄ has the imaginary part 0.
    let product = [
        x2 * x3.conj(),
        x2 * y3.conj() + y2 * x3.conj(),
        y2 * y3.conj(),
    ];
    let imaginary = |a: Complex<f64>, b: Complex<f64>| (a * b.conj()).im;
    let cubic = [
        imaginary(xm, product[0]),
        imaginary(xm, product[1]) + imaginary(ym, product[0]),
        imaginary(xm, product[2]) + imaginary(ym, product[1]),
        imaginary(ym, product[2]),
    ];
    if max_abs(cubic) < tolerance::CONVERGED {
        return Err(StartsError::Degenerate);
    }
    let mut found: Vec<Started> = Vec::new();
    for [p, q] in polynomial::directions(&cubic) {
        let m = xm * p + ym * q;
        let w = (x2 * p + y2 * q) * (x3 * p + y3 * q).conj();
        let scale = dot(m, w) / w.norm_sqr();
        let at = |a: Complex<f64>, b: Complex<f64>| (a * p + b * q) * scale;
        if let Some(next) = polished(&turns, [at(x2, y2), at(x3, y3)]) {
            let twice = found.iter().any(|earlier| same(earlier, &next));
            if !twice {
                found.push(next);
            }
        }
    }
    sort_by(&mut found, |a, b| size(a).total_cmp(&size(b)));
    Ok(found)
}

fn size((proportions, _): &Started) -> f64 {
    proportions.output.hypot(proportions.input)
}

fn same(a: &Started, b: &Started) -> bool {
    let points = [a, b].map(|(z, [output, input])| {
        [
            Complex::from_polar(z.output, *output),
            Complex::from_polar(z.input, *input),
        ]
    });
    let off = (0..2).map(|k| (points[0][k] - points[1][k]).norm());
    max_abs(off) <= tolerance::COINCIDENT * size(a).max(size(b))
}

/// Refines w₂, w₃ and z₁ by Newton's method on the closure equations; none if the loop does not close.
fn polished(turns: &[[Complex<f64>; 2]; 5], start: [Complex<f64>; 2]) -> Option<Started> {
    let [w2, w3] = start;
    let gap = |k: usize, w2, w3| Complex::new(1.0, 0.0) - turns[k][0] * w2 - turns[k][1] * w3;
    let open = |w2: Complex<f64>, w3: Complex<f64>, z: f64| -> [f64; 5] {
        std::array::from_fn(|k| gap(k, w2, w3).norm() - z)
    };
    let worst = |w2, w3, z| max_abs(open(w2, w3, z));
    let z = (0..5).map(|k| gap(k, w2, w3).norm()).sum::<f64>() / 5.0;
    if !(w2.norm() > 0.0 && w3.norm() > 0.0 && z > 0.0 && z.is_finite()) {
        return None;
    }
    let step = |&(w2, w3, z): &(Complex<f64>, Complex<f64>, f64)| {
        let jacobian = std::array::from_fn(|k| {
            let r = gap(k, w2, w3);
            let [a, b] = turns[k].map(|turn| turn * r.conj() / r.norm());
            [-a.re, a.im, -b.re, b.im, -1.0]
        });
        let [a, b, c, d, e] = linear::solve(jacobian, open(w2, w3, z))?;
        let (w2, w3, z) = (w2 - Complex::new(a, b), w3 - Complex::new(c, d), z - e);
        Some(((w2, w3, z), worst(w2, w3, z)))
    };
    let ((w2, w3, z), left) = descended((w2, w3, z), worst(w2, w3, z), step);
    let closes = left <= tolerance::NEGLIGIBLE * (1.0 + w2.norm() + w3.norm());
    let proportions = Proportions {
        coupler: z,
        output: w2.norm(),
        input: w3.norm(),
    };
    (closes && z > 0.0).then_some((proportions, [w2.arg(), w3.arg()]))
}
