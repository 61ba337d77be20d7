//! Which pairs to replace so that no constraint in space is redundant.
//!
//! A pair with more freedoms gives up constraints. None is redundant any more, and no motion is won, where exactly
//! as many are given up as are redundant and no self-stress does without them: each freedom that is added is a
//! linear form on the self-stresses (the power of their wrench on its twist), and these forms must be independent.

use crate::sorting::sort_by_key;
use crate::tolerance;
use std::f64::consts::PI;

use super::constraints::Constraints;
use super::screw::{Form, across};
use super::{NoRank, Pair, PairKind, Scheme, SchemeSpec, Space, Vector3};

/// How long is searched: so many products of forms.
const WORK: usize = 20_000_000;

/// Pairs replaced by others with more freedoms.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacement {
    /// The changes, by the names of the pairs.
    pub changes: Vec<Change>,
}

/// A pair replaced by another form at its place, which leaves the freedoms that it has and more.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The pair.
    pub pair: usize,
    /// What it becomes.
    pub kind: PairKind,
    /// Its axis then.
    pub axis: Option<Vector3>,
    /// Its second direction then.
    pub second: Option<Vector3>,
}

/// Replacements that do it.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacements {
    /// Those with the fewest changed pairs first, then by names. Empty where nothing is redundant.
    pub list: Vec<Replacement>,
    /// Whether these are all.
    pub complete: bool,
}

impl Scheme {
    /// Replacements of pairs after which no constraint in space is redundant and W is what it was, `most` at most.
    /// None is contained in another: all add as many freedoms as constraints are redundant.
    ///
    /// # Errors
    /// What is missing for the rank.
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
                        powers.collect::<Vec<f64>>()
                    })
                });
                // Freedoms that the pair has already are no form, and what bears on no self-stress is of no help.
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

    /// The scheme with pairs replaced.
    pub fn replaced(&self, replacement: &Replacement) -> SchemeSpec {
        let mut spec = self.spec();
        for change in &replacement.changes {
            let pair = &mut spec.pairs[change.pair];
            (pair.kind, pair.axis, pair.second) = (change.kind, change.axis, change.second);
        }
        spec
    }

    /// The forms that leave the freedoms of a pair and more. Directions that are free to choose are at no special
    /// angle: `place` is that of the pair in the order of names.
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
        // A cylinder or its line lies along the axis, on a plane whose normal is across.
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

    /// A direction across an axis; of a planar scheme one in the plane.
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
    /// The pair after the change; before it, it was this.
    fn form(&self, before: &Form) -> Form {
        let axis = self.axis.unwrap_or(before.frame[0]);
        Form::new(self.kind, before.place, axis, self.second)
    }
}

/// A change with the linear forms on the self-stresses that it adds, at right angles to each other.
struct Raise {
    change: Change,
    forms: Vec<Vec<f64>>,
}

/// The search for choices of raises.
struct Search {
    /// Of each pair in the order of names.
    raises: Vec<Vec<Raise>>,
    /// The most forms that one adds.
    greatest: usize,
    /// How many results are wanted.
    most: usize,
    /// How many products may still be taken.
    work: usize,
    chosen: Vec<Change>,
    found: Vec<Replacement>,
}

impl Search {
    /// Raises as many `pairs` from this one on so that so many more forms are independent of those taken. False
    /// where there are more results than wanted, or it takes too long.
    fn choose(&mut self, from: usize, pairs: usize, missing: usize, taken: &[Vec<f64>]) -> bool {
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
                // Each pair still to be raised adds one at least.
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

/// What is independent of forms that are taken, at right angles to them and to each other, in length 1.
fn independent(taken: &[Vec<f64>], forms: impl Iterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut new: Vec<Vec<f64>> = vec![];
    for mut form in forms {
        // Twice, so that rounding leaves nothing of what is taken out.
        for _ in 0..2 {
            for unit in taken.iter().chain(&new) {
                let part = dot(unit, &form);
                form.iter_mut()
                    .zip(unit)
                    .for_each(|(value, unit)| *value -= part * unit);
            }
        }
        let length = dot(&form, &form).sqrt();
        if length > tolerance::TRIPLE_ROOT {
            form.iter_mut().for_each(|value| *value /= length);
            new.push(form);
        }
    }
    new
}

/// The values relative to the greatest.
fn scaled(mut values: Vec<f64>) -> Vec<f64> {
    let greatest = values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    if greatest > 0.0 {
        values.iter_mut().for_each(|value| *value /= greatest);
    }
    values
}
