//! Replacements of pairs after which no constraint in space is redundant.
//!
//! A pair with more freedoms has fewer constraints. No constraint is redundant any more, and the mobility is unchanged,
//! if two conditions hold. The number of removed constraints equals the number of redundant ones, and no self-stress
//! remains. Each added freedom gives a linear form on the self-stresses: the power of the pair's wrench on the twist of
//! this freedom. No self-stress remains if these forms are linearly independent.

use crate::numeric::linear::remainder;
use crate::numeric::max_abs;
use crate::sorting::sort_by_key;
use crate::tolerance;
use std::f64::consts::PI;

use super::constraints::Constraints;
use super::screw::{Form, across};
use super::{NoRank, Pair, PairKind, Scheme, SchemeSpec, Space, Vector3};

/// Maximum number of multiplications in a search.
const WORK: usize = 20_000_000;

/// Linear form of an added freedom: power of the pair's wrench on the freedom's twist, for each self-stress of a basis.
type PowerForm = nalgebra::DVector<f64>;

/// Replacement of one or more pairs by pairs with more freedoms.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacement {
    /// Changes, in the order of the names of the pairs.
    pub changes: Vec<Change>,
}

/// Replacement of one pair by another form at the same place. The new form has all freedoms of the pair and more.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Index of the pair.
    pub pair: usize,
    /// New kind of the pair.
    pub kind: PairKind,
    /// New axis of the pair; None if the new kind has no axis.
    pub axis: Option<Vector3>,
    /// New second direction of the pair; None if the new kind has none.
    pub second: Option<Vector3>,
}

/// Possible replacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacements {
    /// Replacements, sorted by the number of changed pairs, then by name. Empty if no constraint is redundant.
    pub list: Vec<Replacement>,
    /// True if the list is complete.
    pub complete: bool,
}

impl Scheme {
    /// At most `most` replacements of pairs after which no constraint in space is redundant and the mobility W is
    /// unchanged. Every replacement adds one freedom for each redundant constraint, so no replacement contains another.
    ///
    /// # Errors
    /// The scheme lacks data that the rank of the constraints needs.
    pub fn replacements(&self, most: usize) -> Result<Replacements, NoRank> {
        let forms = self.forms(Space::Whole)?;
        let constraints = Constraints::new(self, &forms, Space::Whole);
        let equilibrium = constraints.equilibrium(self).eliminated(None);
        let stresses: Vec<Vec<f64>> = equilibrium.solutions().map(scaled).collect();
        let mut order: Vec<usize> = (0..self.pairs().len()).collect();
        sort_by_key(&mut order, |pair| &self.pairs()[*pair].name);
        let raises = order.iter().enumerate().map(|(place, &pair)| {
            let bears: Vec<_> = stresses
                .iter()
                .map(|stress| constraints.wrenches_of(stress, pair))
                .collect();
            let raise = |change: Change| {
                let wanted = change.form(&forms[pair]).freedoms();
                let joints = 0..self.pairs()[pair].count();
                let powers = joints.flat_map(|joint| {
                    let bears = &bears;
                    wanted.iter().map(move |twist| {
                        let powers = bears.iter().map(|wrenches| wrenches[joint].dot(twist));
                        PowerForm::from_iterator(bears.len(), powers)
                    })
                });
                // A change is useful only if the forms of its added freedoms are independent. The forms of existing
                // freedoms are zero and drop out.
                let added = change.kind.freedoms() - self.pairs()[pair].kind.freedoms();
                let forms = independent(&[], powers);
                let helps = forms.len() == usize::from(added) * self.pairs()[pair].count();
                helps.then_some(Raise { change, forms })
            };
            let others = self.others(pair, place).into_iter();
            others.filter_map(raise).collect()
        });
        let raises: Vec<Vec<Raise>> = raises.collect();
        let added = raises.iter().flatten().map(|raise| raise.forms.len());
        let mut search = Search {
            greatest: added.max().unwrap_or(0),
            raises,
            most,
            work: WORK,
            chosen: vec![],
            found: vec![],
        };
        let redundant = stresses.len();
        let (mut pairs, mut complete) = (1, true);
        while complete && pairs <= order.len().min(redundant) {
            complete = search.choose(0, pairs, redundant, &[]);
            pairs += 1;
        }
        Ok(Replacements {
            list: search.found,
            complete,
        })
    }

    /// Specification of the scheme after a replacement.
    pub fn replaced(&self, replacement: &Replacement) -> SchemeSpec {
        let mut spec = self.spec();
        for change in &replacement.changes {
            let pair = &mut spec.pairs[change.pair];
            (pair.kind, pair.axis, pair.second) = (change.kind, change.axis, change.second);
        }
        spec
    }

    /// Changes that keep the freedoms of a pair and add others. A new direction is in general position, unless the
    /// plane of a planar scheme fixes it. This direction depends on `place`, the pair's index in the order of names.
    fn others(&self, pair: usize, place: usize) -> Vec<Change> {
        let Pair { kind, links, .. } = &self.pairs()[pair];
        let (axis, second) = (self.pairs()[pair].axis, self.pairs()[pair].second);
        let change = |kind, axis, second| Change {
            pair,
            kind,
            axis,
            second,
        };
        let beside = axis.map(|axis| self.beside(&axis, place));
        let on_axis = |kind| change(kind, axis, None);
        // A cylinder with its line of contact along the axis, on a plane whose normal is perpendicular to the axis.
        let lying = || change(PairKind::CylinderOnPlane, beside, axis);
        let any = if self.is_planar() {
            Vector3::z()
        } else {
            (self.beside(&Vector3::z(), place) + Vector3::z()).normalize()
        };
        let others = match kind {
            PairKind::Revolute => vec![
                on_axis(PairKind::Cylindrical),
                change(PairKind::Universal, axis, beside),
                change(PairKind::Spherical, None, None),
                on_axis(PairKind::SphereInCylinder),
                lying(),
            ],
            PairKind::Prismatic => vec![
                on_axis(PairKind::Cylindrical),
                change(PairKind::Planar, beside, None),
                on_axis(PairKind::SphereInCylinder),
            ],
            PairKind::Screw { .. } => vec![on_axis(PairKind::Cylindrical)],
            PairKind::Cylindrical => vec![on_axis(PairKind::SphereInCylinder), lying()],
            PairKind::Universal => vec![change(PairKind::Spherical, None, None)],
            PairKind::Spherical => vec![change(PairKind::SphereInCylinder, Some(any), None)],
            PairKind::Planar => vec![change(PairKind::CylinderOnPlane, axis, beside)],
            PairKind::SphereInCylinder => vec![change(PairKind::SphereOnPlane, beside, None)],
            PairKind::CylinderOnPlane => vec![change(PairKind::SphereOnPlane, axis, second)],
            PairKind::SphereOnPlane | PairKind::Class(_) => vec![],
        };
        let fits = |other: &Change| links.len() == 2 || other.kind.joins_many();
        others.into_iter().filter(fits).collect()
    }

    /// A direction perpendicular to an axis, in the plane for a planar scheme.
    fn beside(&self, axis: &Vector3, place: usize) -> Vector3 {
        let in_plane = Vector3::z().cross(axis);
        if self.is_planar() && in_plane.norm() > tolerance::TRIPLE_ROOT {
            return in_plane.normalize();
        }
        let golden = PI * (3.0 - 5.0_f64.sqrt());
        let (sin, cos) = (golden * (place + 1) as f64).sin_cos();
        let first = across(axis);
        first * cos + axis.cross(&first) * sin
    }
}

impl Change {
    /// The pair after the change, at the place of `before`.
    fn form(&self, before: &Form) -> Form {
        let axis = self.axis.unwrap_or(before.frame[0]);
        Form::new(self.kind, before.place, axis, self.second)
    }
}

/// A change, with an orthonormal basis of the linear forms given by its added freedoms.
struct Raise {
    change: Change,
    forms: Vec<PowerForm>,
}

/// Search for sets of changes that leave no constraint redundant.
struct Search {
    /// Possible changes of each pair, with the pairs in the order of names.
    raises: Vec<Vec<Raise>>,
    /// Maximum number of forms that one change adds.
    greatest: usize,
    /// Maximum number of results.
    most: usize,
    /// Number of multiplications left.
    work: usize,
    chosen: Vec<Change>,
    found: Vec<Replacement>,
}

impl Search {
    /// Chooses changes of `pairs` pairs, from index `from` on, that add `missing` forms independent of the forms in
    /// `taken`. Returns false if there are more results than wanted, or the work is exhausted.
    fn choose(&mut self, from: usize, pairs: usize, missing: usize, taken: &[PowerForm]) -> bool {
        if pairs == 0 {
            if missing > 0 {
                return true;
            }
            let full = self.found.len() >= self.most;
            if !full {
                let changes = self.chosen.clone();
                self.found.push(Replacement { changes });
            }
            return !full;
        }
        for pair in from..self.raises.len() {
            for raise in 0..self.raises[pair].len() {
                let raise = &self.raises[pair][raise];
                let (added, forms) = (raise.forms.len(), &raise.forms);
                // Each of the remaining pairs adds at least one form and at most `greatest`.
                let most = self.greatest * (pairs - 1);
                let rest = missing.checked_sub(added);
                let Some(rest) = rest.filter(|rest| (pairs - 1..=most).contains(rest)) else {
                    continue;
                };
                let length = taken.len() + missing;
                let products = (added + 1) * (taken.len() + 1) * length;
                let Some(left) = self.work.checked_sub(products) else {
                    return false;
                };
                self.work = left;
                let new = independent(taken, forms.iter().cloned());
                if new.len() < added {
                    continue;
                }
                let all = [taken, &new].concat();
                self.chosen.push(raise.change.clone());
                let go_on = self.choose(pair + 1, pairs - 1, rest, &all);
                self.chosen.pop();
                if !go_on {
                    return false;
                }
            }
        }
        true
    }
}

/// Orthonormal basis of the part of `forms` that is independent of the forms in `taken`.
fn independent(taken: &[PowerForm], forms: impl Iterator<Item = PowerForm>) -> Vec<PowerForm> {
    let mut new: Vec<PowerForm> = vec![];
    for form in forms {
        let rest = remainder(form, taken.iter().chain(&new));
        new.extend(rest.try_normalize(tolerance::TRIPLE_ROOT));
    }
    new
}

/// The values divided by their greatest absolute value.
fn scaled(mut values: Vec<f64>) -> Vec<f64> {
    let greatest = max_abs(values.iter().copied());
    if greatest > 0.0 {
        values.iter_mut().for_each(|value| *value /= greatest);
    }
    values
}
