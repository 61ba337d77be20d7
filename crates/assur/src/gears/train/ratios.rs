//! Transmission ratios with one shaft held.

use std::fmt;

use super::{Differential, Shaft};

/// The ratio u = ω_i/ω_j of two shafts' speeds with the third shaft held, as a fraction of whole numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// Shaft i of the numerator.
    pub of: Shaft,
    /// Shaft j of the denominator.
    pub to: Shaft,
    /// The shaft that is held.
    pub held: Shaft,
    /// Numerator, which carries the sign.
    pub numerator: i64,
    /// Denominator, positive.
    pub denominator: i64,
}

impl Ratio {
    /// Value of the ratio u.
    pub fn value(&self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

impl fmt::Display for Ratio {
    /// Writes the notation `1/3(4)`: the speed of link 1 divided by the speed of link 3, with link 4 held.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [of, to, held] = [self.of, self.to, self.held].map(Shaft::number);
        write!(f, "{of}/{to}({held})")
    }
}

/// The identity u_ij⁽ᵏ⁾ + u_ik⁽ʲ⁾ = 1 for a shaft i; the superscript is the shaft held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Identity {
    /// The two ratios, with a common denominator.
    pub terms: [Ratio; 2],
}

impl Identity {
    /// The sum of both terms as a fraction: numerator and denominator.
    pub fn sum(&self) -> (i64, i64) {
        let [first, second] = self.terms;
        (first.numerator + second.numerator, first.denominator)
    }
}

impl Differential {
    /// The ratio u_ij with the third shaft held, for different i and j.
    fn ratio(&self, of: Shaft, to: Shaft, held: Shaft) -> Ratio {
        // With the third shaft held, w_i ω_i + w_j ω_j = 0 for the weights w.
        let (numerator, denominator) = (-self.weight(to), self.weight(of));
        Ratio {
            of,
            to,
            held,
            numerator: numerator * denominator.signum(),
            denominator: denominator.abs(),
        }
    }

    /// The six ratios: 1/3(4), 3/1(4), 3/4(1), 4/3(1), 1/4(3), 4/1(3). The second and third are the paper's (5), (6).
    pub fn ratios(&self) -> [Ratio; 6] {
        use Shaft::{Carrier, Ring, Sun};
        [
            self.ratio(Sun, Carrier, Ring),
            self.ratio(Carrier, Sun, Ring),
            self.ratio(Carrier, Ring, Sun),
            self.ratio(Ring, Carrier, Sun),
            self.ratio(Sun, Ring, Carrier),
            self.ratio(Ring, Sun, Carrier),
        ]
    }

    /// Identities (8), (9), (10) of the source paper.
    pub fn identities(&self) -> [Identity; 3] {
        use Shaft::{Carrier, Ring, Sun};
        let identity = |of, one, other| Identity {
            terms: [self.ratio(of, one, other), self.ratio(of, other, one)],
        };
        [
            identity(Sun, Carrier, Ring),
            identity(Carrier, Ring, Sun),
            identity(Ring, Sun, Carrier),
        ]
    }

    /// True if no ratio of the differential is larger than this ratio. The largest ratio characterizes the
    /// differential; if z₁ = z₄, two ratios are largest.
    pub fn is_largest(&self, ratio: &Ratio) -> bool {
        let greater = |other: &Ratio| {
            other.numerator * ratio.denominator > ratio.numerator * other.denominator
        };
        !self.ratios().iter().any(greater)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_ratios_of_a_sun_of_20_and_a_ring_of_40() {
        let ratios = Differential::planar([20.0, 40.0]).unwrap().ratios();
        let found = ratios.map(|ratio| ratio.to_string());
        assert_eq!(
            found,
            ["1/3(4)", "3/1(4)", "3/4(1)", "4/3(1)", "1/4(3)", "4/1(3)"]
        );
        let found = ratios.map(|ratio| (ratio.numerator, ratio.denominator));
        assert_eq!(
            found,
            [(60, 20), (20, 60), (40, 60), (60, 40), (-40, 20), (-20, 40)]
        );
        let found = ratios.map(|ratio| ratio.value());
        assert_eq!(found, [3.0, 1.0 / 3.0, 2.0 / 3.0, 1.5, -2.0, -0.5]);
    }

    #[test]
    fn ratios_of_one_shaft_to_the_two_others_add_up_to_one() {
        let identities = Differential::planar([20.0, 40.0]).unwrap().identities();
        assert_eq!(
            identities.map(|one| one.sum()),
            [(20, 20), (60, 60), (40, 40)]
        );
    }

    /// If z₁ < z₄, the largest ratio is ω₁/ω₃ of sun to carrier, 1 + z₄/z₁. If z₁ = z₄, the ratio of ring to carrier is
    /// as large.
    #[test]
    fn the_largest_ratio_is_of_the_shaft_with_the_least_weight() {
        for (sun, ring, expected) in [
            (20, 40, vec!["1/3(4)"]),
            (40, 20, vec!["4/3(1)"]),
            (20, 20, vec!["1/3(4)", "4/3(1)"]),
        ] {
            let differential = Differential::of(sun, ring);
            let ratios = differential.ratios();
            let largest = ratios.iter().filter(|ratio| differential.is_largest(ratio));
            let largest: Vec<String> = largest.map(ToString::to_string).collect();
            assert_eq!(largest, expected);
        }
    }
}
