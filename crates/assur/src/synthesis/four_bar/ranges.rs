//! Exact ranges of lengths and coupler angles over a family. They follow from the ends of the family and from the zeros
//! of derivatives, which are roots of polynomials.

use crate::sorting::sort_by;
use nalgebra::Complex;

use crate::angle::nearest_to;

use super::closure::{Direction, cross, dot};
use super::family::{Family, Range, Shape};
use crate::numeric::newton::descended;
use crate::numeric::polynomial::positive_roots;

/// The ranges of z₂ and z₃.
pub(super) fn lengths(shape: &Shape) -> [Range; 2] {
    match *shape {
        // From a/z₂ + b/z₃ = 1 with τ = z₂/z₃: z₂ = a + bτ and z₃ = b + a/τ.
        Shape::Directions { a, b, .. } => [[a, b], [b, a]].map(|[rest, scale]| match scale {
            _ if scale > 0.0 => Range {
                from: rest.max(0.0),
                to: None,
            },
            _ => Range {
                from: if scale < 0.0 { 0.0 } else { rest },
                to: Some(rest),
            },
        }),
        Shape::Sizes { .. } => {
            [Range {
                from: 0.0,
                to: None,
            }; 2]
        }
    }
}

/// Coefficients of the gap r along a family, for the powers −1, 0, 1 of the parameter x. In a family of directions x =
/// τ = z₂/z₃ and r = (e₀ − a e₂ − b e₃) − b e₂ τ − a e₃/τ; e₀, e₂ and e₃ are the unit vectors of frame, output and
/// input. In a family of sizes x is the size, and r is linear in x.
fn gap(shape: &Shape, at: &Direction) -> [Complex<f64>; 3] {
    let one = Complex::new(1.0, 0.0);
    match *shape {
        Shape::Directions { a, b, .. } => [
            -at.input * a,
            one - at.output * a - at.input * b,
            -at.output * b,
        ],
        Shape::Sizes { direction } => {
            let (sin, cos) = direction.sin_cos();
            [
                Complex::new(0.0, 0.0),
                one,
                -at.output * sin - at.input * cos,
            ]
        }
    }
}

/// Parameters x of the ends of a family; None for an end at infinity.
fn ends(shape: &Shape) -> [Option<f64>; 2] {
    match *shape {
        Shape::Directions { a, b, .. } if a < 0.0 => [Some(-a / b), None],
        Shape::Directions { a, b, .. } if b < 0.0 => [Some(0.0), Some(-a / b)],
        _ => [Some(0.0), None],
    }
}

fn between(shape: &Shape, x: f64) -> bool {
    let [from, to] = ends(shape);
    from.is_none_or(|from| x > from) && to.is_none_or(|to| x < to)
}

/// Coefficients of x²|p/x + q + r x|², the squared gap times x², as a polynomial in x, lowest power first.
fn square(gap: [Complex<f64>; 3]) -> [f64; 5] {
    let [p, q, r] = gap;
    [
        dot(p, p),
        2.0 * dot(p, q),
        dot(q, q) + 2.0 * dot(p, r),
        2.0 * dot(q, r),
        dot(r, r),
    ]
}

fn value([p, q, r]: [Complex<f64>; 3], x: f64) -> Complex<f64> {
    // If p is zero, an x that has underflowed to zero must not give NaN.
    q + r * x + if p.norm_sqr() == 0.0 { p } else { p / x }
}

/// The range of z₁.
pub(super) fn coupler(family: &Family) -> Range {
    let shape = &family.shape;
    let gap = gap(shape, &family.directions()[0]);
    let [n0, n1, _, n3, n4] = square(gap);
    let mut from = f64::INFINITY;
    let mut to = Some(0.0_f64);
    let mut take = |z: f64| {
        from = from.min(z);
        to = to.map(|to| to.max(z));
    };
    // Zeros of d|r|²/dx.
    let turns = positive_roots(&[-2.0 * n0, -n1, 0.0, n3, 2.0 * n4]);
    for x in turns.into_iter().filter(|x| between(shape, *x)) {
        take(value(gap, x).norm());
    }
    let [p, q, r] = gap;
    let mut unbounded = false;
    for (end, (grows, rest)) in ends(shape).into_iter().zip([(p, q), (r, q)]) {
        match end {
            Some(x) if x > 0.0 => take(value(gap, x).norm()),
            _ if grows.norm_sqr() > 0.0 => unbounded = true,
            _ => take(rest.norm()),
        }
    }
    Range {
        from,
        to: to.filter(|_| !unbounded),
    }
}

/// z₂ and z₃ of the members with this z₁.
pub(super) fn with_coupler(family: &Family, coupler: f64) -> Vec<[f64; 2]> {
    if !(coupler > 0.0 && coupler.is_finite()) {
        return Vec::new();
    }
    let shape = &family.shape;
    let at = &family.directions()[0];
    let mut polynomial = square(gap(shape, at));
    polynomial[2] -= coupler * coupler;
    let places = positive_roots(&polynomial).into_iter();
    places
        .filter(|x| between(shape, *x))
        .map(|x| match *shape {
            Shape::Directions { a, b, .. } => [a + b * x, b + a / x],
            Shape::Sizes { direction } => [x * direction.sin(), x * direction.cos()],
        })
        .map(|lengths| polished(shape, at, coupler, lengths))
        .collect()
}

/// The member of a family near these z₂ and z₃ with |r| = z₁. Newton's method along the family restores the digits that
/// the polynomial has lost. At a double root, where the step is not finite, the lengths are returned unchanged.
fn polished(shape: &Shape, at: &Direction, coupler: f64, lengths: [f64; 2]) -> [f64; 2] {
    let open = |[output, input]: [f64; 2]| at.gap(output, input).norm() - coupler;
    let step = |&[output, input]: &[f64; 2]| {
        let r = at.gap(output, input);
        // Tangent of the family, and the derivative of |r| along it.
        let way = match *shape {
            Shape::Directions { a, b, .. } => [b * output * output, -a * input * input],
            Shape::Sizes { .. } => [output, input],
        };
        let slope = -(dot(r, at.output) * way[0] + dot(r, at.input) * way[1]) / r.norm();
        let step = open([output, input]) / slope;
        let by_output = way[0].abs() > way[1].abs();
        let next = match (*shape, by_output) {
            (Shape::Directions { a, b, .. }, true) => {
                let output = output - step * way[0];
                [output, b * output / (output - a)]
            }
            (Shape::Directions { a, b, .. }, false) => {
                let input = input - step * way[1];
                [a * input / (input - b), input]
            }
            (Shape::Sizes { .. }, _) => way.map(|length| length - step * length),
        };
        Some((next, open(next).abs()))
    };
    descended(lengths, open(lengths).abs(), step).0
}

/// Range of arg r at a position; the angle is continuous along the family. Between crossings of the axes r stays in one
/// quadrant, where its angle is unambiguous. Within a quadrant the angle has an extremum where r × r′ = 0.
pub(super) fn coupler_angle(shape: &Shape, at: &Direction) -> [f64; 2] {
    let gap = gap(shape, at);
    let [p, q, r] = gap;
    let mut places = vec![];
    for part in [|z: Complex<f64>| z.re, |z: Complex<f64>| z.im] {
        places.extend(positive_roots(&[part(p), part(q), part(r)]));
    }
    // The gap g = p/x + q + r x has g × g′ x² = p × q + 2 p × r x + q × r x².
    places.extend(positive_roots(&[
        cross(p, q),
        2.0 * cross(p, r),
        cross(q, r),
    ]));
    places.retain(|x| between(shape, *x));
    sort_by(&mut places, f64::total_cmp);
    let [first, last] = ends(shape);
    let start = match first {
        Some(x) if x > 0.0 => value(gap, x),
        _ if p.norm_sqr() > 0.0 => p,
        _ => q,
    };
    let end = match last {
        Some(x) => value(gap, x),
        None if r.norm_sqr() > 0.0 => r,
        None => q,
    };
    let mut angle = start.arg();
    let [mut least, mut greatest] = [angle; 2];
    let inner = places.into_iter().map(|x| value(gap, x));
    for next in inner.chain([end]) {
        angle = nearest_to(next.arg(), angle);
        [least, greatest] = [least.min(angle), greatest.max(angle)];
    }
    [least, greatest]
}
