//! Mobility in a general pose near the drawn pose. In the drawn pose itself, links may be in line by chance.

use super::constraints::Constraints;
use super::displaced::{Displaced, Placement};
use super::elimination::System;
use super::screw::{Form, Screw};
use super::{NoRank, Scheme, Space};
use crate::numeric::max_abs;
use crate::numeric::newton::MAX_STEPS_FROM_DRAWING;
use crate::sorting::sort_by_key;
use crate::tolerance;

/// Steps tried from the drawn pose: rotations in radians, displacements relative to the size of the scheme.
const STEPS: [f64; 3] = [0.05, 0.02, 0.005];

/// Mobility by rank away from the drawn pose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Generic {
    /// Mobility in a pose nearby; zero if the links cannot move in the drawn pose.
    At {
        /// Mobility W.
        mobility: usize,
    },
    /// No other pose was reached: the freedoms in the drawn pose are instantaneous.
    Instantaneous,
    /// Redundant constraints involve surfaces in contact. The curvature of the surfaces, which a scheme does not
    /// contain, determines whether these constraints remain redundant.
    Contact {
        /// The pairs with these surfaces, in the order of names.
        pairs: Vec<usize>,
    },
}

impl Scheme {
    /// Mobility by rank in a pose near the drawn one. The links are moved by a small step along the velocities possible
    /// in the drawn pose; then the pairs are closed again.
    ///
    /// # Errors
    /// The scheme lacks data that the rank needs, or motions in the plane are requested for a scheme that is not
    /// planar.
    pub fn generic(&self, space: Space) -> Result<Generic, NoRank> {
        let verdict = self.rank_report(space)?;
        let mut contacts: Vec<usize> = verdict
            .redundancies
            .iter()
            .flat_map(|part| part.pairs.iter().copied())
            .filter(|pair| self.pairs()[*pair].kind.touches())
            .collect();
        if verdict.mobility == 0 {
            return Ok(Generic::At { mobility: 0 });
        }
        if !contacts.is_empty() {
            sort_by_key(&mut contacts, |pair| &self.pairs()[*pair].name);
            return Ok(Generic::Contact { pairs: contacts });
        }
        let drawn = self.forms(space)?;
        let way = self.way(&drawn, space);
        for step in STEPS {
            let start: Vec<Placement> = way
                .iter()
                .map(|twist| Placement::drawn().moved(&(twist * step)))
                .collect();
            if let Some((placements, forms)) = self.closed(&drawn, start, space) {
                let distances = placements.iter().map(Placement::distance);
                if max_abs(distances) > step / 10.0 {
                    let mobility =
                        space.freedoms() * (self.links().len() - 1) - self.rank_of(&forms, space);
                    return Ok(Generic::At { mobility });
                }
            }
        }
        Ok(Generic::Instantaneous)
    }

    /// Twists of the links in a combination of all motions of the drawn pose, scaled to a greatest component of 1.
    fn way(&self, forms: &[Form], space: Space) -> Vec<Screw> {
        let motions = Constraints::new(self, forms, space)
            .motions(self)
            .eliminated(None);
        let width = space.freedoms();
        let way = motions.mixture(|_| true);
        let scale = match max_abs(way.iter().copied()) {
            0.0 => 1.0,
            greatest => 1.0 / greatest,
        };
        let twists = way
            .chunks_exact(width)
            .map(|values| twist(values, space) * scale);
        [Screw::zeros()].into_iter().chain(twists).collect()
    }

    /// Closes the pairs with the smallest motion of the links (Gauss-Newton with Levenberg-Marquardt damping). Returns
    /// the placements of the links and the forms of the pairs; None if the iteration does not converge.
    fn closed(
        &self,
        drawn: &[Form],
        mut placements: Vec<Placement>,
        space: Space,
    ) -> Option<(Vec<Placement>, Vec<Form>)> {
        for _ in 0..MAX_STEPS_FROM_DRAWING {
            let halves = self.halves(drawn, &placements);
            let gaps = halves.iter().flatten().flat_map(|half| &half.gaps);
            let worst = max_abs(gaps.copied());
            if worst < tolerance::NEGLIGIBLE {
                let forms = halves
                    .into_iter()
                    .filter_map(|halves| halves.into_iter().next());
                return Some((placements, forms.map(|half| half.form).collect()));
            }
            // Beyond gaps of this size the links are no longer near the drawn pose.
            if worst.is_nan() || worst > 1.0 {
                return None;
            }
            let correction = self.correction(&halves, space, 1e-3 * worst)?;
            let twists = correction.chunks_exact(space.freedoms());
            for (placement, values) in placements.iter_mut().skip(1).zip(twists) {
                *placement = placement.moved(&twist(values, space));
            }
        }
        None
    }

    /// For each pair, the displaced pairs that its first link forms with each of its other links.
    fn halves(&self, drawn: &[Form], placements: &[Placement]) -> Vec<Vec<Displaced>> {
        let pairs = self.pairs().iter().zip(drawn);
        let between = pairs.map(|(pair, form)| {
            let others = pair.links.iter().skip(1);
            let ends = others.map(|other| [pair.links[0], *other].map(|link| &placements[link]));
            ends.map(|ends| Displaced::new(form, ends)).collect()
        });
        between.collect()
    }

    /// Smallest motion x of the links that closes the gaps: J x + gaps = 0 with the Jacobian J. It follows from x = Jᵀλ
    /// and (J Jᵀ + damping) λ = − gaps.
    fn correction(
        &self,
        halves: &[Vec<Displaced>],
        space: Space,
        damping: f64,
    ) -> Option<Vec<f64>> {
        let (moving, width) = (self.links().len() - 1, space.freedoms());
        let rows = |pair: usize| {
            halves[pair]
                .iter()
                .map(|half| half.gaps.len())
                .sum::<usize>()
        };
        let forces = (0..halves.len()).map(rows);
        let sizes = std::iter::repeat_n(width, moving).chain(forces).chain([1]);
        let (mut system, constant) = (System::new(sizes), moving + halves.len());
        for (at, pair) in self.pairs().iter().enumerate() {
            let links = pair.links.iter().filter(|link| **link > 0);
            let mut blocks: Vec<usize> = links.map(|link| link - 1).collect();
            let (mut entries, size, mut row) = (vec![], rows(at), 0);
            for (other, half) in halves[at].iter().enumerate() {
                for (wrench, gap) in half.form.constraints().iter().zip(&half.gaps) {
                    for block in &blocks {
                        let sign = pair.sign(block + 1, other);
                        entries.extend(space.components().iter().map(|at| sign * wrench[*at]));
                    }
                    entries.extend((0..size).map(|own| if own == row { damping } else { 0.0 }));
                    entries.push(*gap);
                    row += 1;
                }
            }
            blocks.extend([moving + at, constant]);
            system.push(blocks, entries);
        }
        for (link, pairs) in self.pairs_of().into_iter().enumerate().skip(1) {
            let mut entries = vec![];
            for (row, &component) in space.components().iter().enumerate() {
                entries.extend((0..width).map(|own| if own == row { -1.0 } else { 0.0 }));
                for &pair in &pairs {
                    let signs = self.pairs()[pair].signs(link);
                    for (sign, half) in signs.zip(&halves[pair]) {
                        let wrenches = half.form.constraints().into_iter();
                        entries.extend(wrenches.map(|wrench| sign * wrench[component]));
                    }
                }
            }
            let forces = pairs.iter().map(|pair| moving + pair);
            system.push([link - 1].into_iter().chain(forces).collect(), entries);
        }
        // The column of the gaps was kept free, so its solution is the last one.
        let mut solution = system.eliminated(Some(constant)).solutions().next_back()?;
        solution.truncate(moving * width);
        Some(solution)
    }
}

fn twist(values: &[f64], space: Space) -> Screw {
    let mut twist = Screw::zeros();
    for (component, value) in space.components().iter().zip(values) {
        twist[*component] = *value;
    }
    twist
}
