//! Willis's equations of wheels in mesh, in integers: their linear dependence, and the ratios of the angles of a train
//! (R. Willis, *Principles of Mechanism*, 1841).

use crate::index::BodyId;
use crate::mechanism::plan::body::Gear;

/// Linear equation between the angles of bodies, with a constant right side: the bodies, in ascending order, with the
/// coefficients of their angles. The frame is left out, because its angle is zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::mechanism) struct Equation(Vec<(BodyId, i128)>);

impl Equation {
    /// Equation `z₁(θ₁ − θ₀) ± z₂(θ₂ − θ₀) = const` of two wheels with z₁ and z₂ teeth; θ₁ and θ₂ are the angles of the
    /// wheels and θ₀ that of their carrier.
    pub(in crate::mechanism) fn of(gear: &Gear) -> Self {
        // The casts are exact, because numbers of teeth are whole.
        let [first, second] = gear.signed_teeth().map(|teeth| teeth as i128);
        let [a, b] = gear.bodies;
        let mut equation = Self::default();
        for (body, by) in [(a, first), (b, second), (gear.carrier, -first - second)] {
            if body != BodyId::FRAME {
                // `add` cannot fail here: sums of a few numbers of teeth do not overflow.
                equation.add(body, by);
            }
        }
        equation.0.retain(|(_, by)| *by != 0);
        equation
    }

    pub(in crate::mechanism) fn terms(&self) -> impl Iterator<Item = (BodyId, i128)> {
        self.0.iter().copied()
    }

    fn factor(&self, body: BodyId) -> Option<i128> {
        let found = self.0.binary_search_by_key(&body, |(body, _)| *body);
        found.ok().map(|at| self.0[at].1)
    }

    /// Adds to the coefficient of a body's angle; None on overflow.
    fn add(&mut self, body: BodyId, by: i128) -> Option<()> {
        match self.0.binary_search_by_key(&body, |(body, _)| *body) {
            Ok(at) => self.0[at].1 = self.0[at].1.checked_add(by)?,
            Err(at) => self.0.insert(at, (body, by)),
        }
        Some(())
    }

    /// This equation after a body is eliminated by means of another equation, with the smallest integer coefficients;
    /// None on overflow.
    fn without(&self, body: BodyId, other: &Self) -> Option<Self> {
        let (Some(own), Some(its)) = (self.factor(body), other.factor(body)) else {
            return Some(self.clone());
        };
        let mut sum = Self::default();
        for (equation, by) in [(self, its), (other, own.checked_neg()?)] {
            for (body, factor) in equation.terms() {
                sum.add(body, factor.checked_mul(by)?)?;
            }
        }
        sum.0.retain(|(_, by)| *by != 0);
        let divisor = sum
            .terms()
            .fold(0, |divisor, (_, by)| num_integer::gcd(divisor, by));
        sum.0.iter_mut().for_each(|(_, by)| *by /= divisor);
        Some(sum)
    }
}

/// Independent equations, each solved for a different body.
#[derive(Clone, Debug, Default)]
pub(in crate::mechanism) struct Solved(Vec<(BodyId, Equation)>);

/// Effect of an equation added to earlier equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::mechanism) enum Adds {
    /// The equation determines one more angle.
    Angle,
    /// The equation follows from the earlier ones.
    Nothing,
    /// The equation relates only angles that are not sought.
    Elsewhere,
}

impl Solved {
    /// Adds an equation, to be solved for one of the sought bodies; None on overflow.
    pub(in crate::mechanism) fn add(
        &mut self,
        equation: &Equation,
        sought: impl Fn(BodyId) -> bool,
    ) -> Option<Adds> {
        let mut left = equation.clone();
        for (body, other) in &self.0 {
            left = left.without(*body, other)?;
        }
        let found = left
            .terms()
            .map(|(body, _)| body)
            .find(|body| sought(*body));
        let Some(body) = found else {
            let is_empty = left.terms().next().is_none();
            return Some(if is_empty {
                Adds::Nothing
            } else {
                Adds::Elsewhere
            });
        };
        for (_, other) in &mut self.0 {
            *other = other.without(body, &left)?;
        }
        self.0.push((body, left));
        Some(Adds::Angle)
    }

    /// Ratios of each solved body: the other bodies of its equation, each with the factor of its angle. The sum of the
    /// products of factors and angles is the angle of the solved body.
    pub(in crate::mechanism) fn ratios(
        &self,
    ) -> impl Iterator<Item = (BodyId, Vec<(BodyId, f64)>)> {
        // Every equation contains the body for which it is solved.
        self.0.iter().filter_map(|(body, equation)| {
            let own = equation.factor(*body)? as f64;
            let others = equation.terms().filter(|(other, _)| other != body);
            let ratios = others.map(|(other, by)| (other, -(by as f64) / own));
            Some((*body, ratios.collect()))
        })
    }
}

/// Marks the passive gear couplings, whose equations follow from earlier ones. The couplings of a second satellite are
/// an example.
pub(in crate::mechanism) fn mark_passive(gears: &mut [Gear]) {
    let mut solved = Solved::default();
    for gear in gears {
        let adds = solved.add(&Equation::of(gear), |_| true);
        // A body in mesh with itself is a defect, not a passive coupling.
        gear.is_passive = gear.bodies[0] != gear.bodies[1] && adds == Some(Adds::Nothing);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::Id;

    /// The equation of bodies by their numbers: sun 1, satellite 2, carrier 3, ring 4.
    fn equation(terms: &[(usize, i128)]) -> Equation {
        Equation(
            terms
                .iter()
                .map(|&(body, by)| (BodyId::at(body), by))
                .collect(),
        )
    }

    /// Sun 20, satellite 20 and a held ring of 60: 20θ₁ + 20θ₂ − 40θ₃ and 20θ₂ + 40θ₃ are constant, so the carrier
    /// turns at 1/4 and the satellite at −1/2 of the speed of the sun.
    #[test]
    fn carrier_and_satellite_in_a_held_ring() {
        let mut solved = Solved::default();
        let sought = |body: BodyId| body != BodyId::at(1);
        for terms in [&[(1, 20), (2, 20), (3, -40)][..], &[(2, 20), (3, 40)]] {
            assert_eq!(solved.add(&equation(terms), sought), Some(Adds::Angle));
        }
        let ratios: Vec<_> = solved.ratios().collect();
        let sun = BodyId::at(1);
        let expected = [(2, -0.5), (3, 0.25)].map(|(body, by)| (BodyId::at(body), vec![(sun, by)]));
        assert_eq!(ratios, expected);
    }

    /// A multiple of an earlier equation, or the sum of two, adds nothing; an equation between other bodies contains no
    /// sought angle.
    #[test]
    fn an_equation_that_follows_adds_nothing() {
        let mut solved = Solved::default();
        let sought = |body: BodyId| body.index() < 4;
        for (terms, expected) in [
            (&[(1, 20), (2, 20), (3, -40)][..], Adds::Angle),
            (&[(1, 30), (2, 30), (3, -60)], Adds::Nothing),
            (&[(2, 20), (3, 40)], Adds::Angle),
            (&[(1, 20), (2, 40)], Adds::Nothing),
            (&[(4, 1), (5, 1)], Adds::Elsewhere),
        ] {
            assert_eq!(
                solved.add(&equation(terms), sought),
                Some(expected),
                "{terms:?}"
            );
        }
    }

    /// Without θ₂, 20θ₁ + 20θ₂ − 40θ₃ and 20θ₂ + 40θ₃ leave θ₁ − 4θ₃, in the smallest integers.
    #[test]
    fn elimination_leaves_the_smallest_integers() {
        let left = equation(&[(1, 20), (2, 20), (3, -40)]);
        let other = equation(&[(2, 20), (3, 40)]);
        let found = left.without(BodyId::at(2), &other);
        assert_eq!(found, Some(equation(&[(1, 1), (3, -4)])));
        // The other equation does not contain θ₁.
        assert_eq!(left.without(BodyId::at(1), &other), Some(left.clone()));
        let huge = equation(&[(1, i128::MAX), (2, 1)]);
        assert_eq!(
            huge.without(BodyId::at(2), &equation(&[(1, 1), (2, 3)])),
            None
        );
    }
}
