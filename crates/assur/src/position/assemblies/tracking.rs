//! Tracking of the assemblies of a group from input to input, each by Newton's method from its extrapolation. The set
//! is complete if it has as many distinct assemblies as for general dimensions. If not, all assemblies are computed
//! again.
//!
//! Two real assemblies that meet continue as a pair of conjugate assemblies, and conversely. The square of half their
//! difference passes through zero almost linearly. So two samples before the meeting predict the difference after it.

use super::bilinear::{C, System};
use super::complex_newton::Workspace;
use super::solutions::{REAL, Solutions, distance, distance_to_conjugate, distance_to_pair, mean};
use super::tracker::{Extrapolation, MAX_DISTANCE, Sample, Tracker};
use crate::Vector;
use crate::numeric::newton::{MAX_STEPS, is_exact, newton};
use crate::position::{Group, State, StepContext};
use crate::tolerance;

impl Group {
    /// All assemblies for the substituted inputs; None if they cannot be tracked.
    pub(super) fn tracked<const N: usize>(
        &self,
        tracker: &mut Tracker,
        system: &System,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Option<Solutions> {
        let parameters = self.parameters(state);
        if !tracker.agreed {
            return None;
        }
        let (k, distance) = tracker.nearest(&parameters)?;
        if distance > MAX_DISTANCE {
            return None;
        }
        let extrapolation = tracker.branches[k].extrapolation(&parameters);
        let (solutions, same_kinds) = self.track(&extrapolation, system, state, context)?;
        if solutions.count() != tracker.general_count {
            return None;
        }
        let branch = &mut tracker.branches[k];
        let sample = Sample {
            parameters,
            solutions: solutions.clone(),
        };
        // Unchanged parameters give no new sample.
        if distance > 0.0 {
            let last = std::mem::replace(&mut branch.last, sample);
            if same_kinds {
                branch.before.truncate(1);
                branch.before.insert(0, last);
            } else {
                branch.before.clear();
            }
        }
        branch.used = true;
        Some(solutions)
    }

    /// Values on which the group's equations depend: each form without its unknowns, and the known part of each driven
    /// pair's equation (the angles of solved bodies less the constant and the driven coordinate).
    pub(super) fn parameters<const N: usize>(&self, state: &State<N>) -> Vec<Vector> {
        let known = state.work.known_values.iter().copied();
        let driven = state.work.known_angles.iter();
        let driven = driven.map(|known| Vector::new(known.angle.value(), 0.0));
        known.chain(driven).collect()
    }

    /// Tracks all assemblies from their extrapolations; None if some are lost or do not stay distinct. The flag is
    /// false if a pair was lost and then found again from its mean. In this case a real pair may have become complex,
    /// or a complex pair real.
    fn track<const N: usize>(
        &self,
        extrapolation: &Extrapolation<'_>,
        system: &System,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Option<(Solutions, bool)> {
        let last = &extrapolation.branch.last.solutions;
        let expected = extrapolation.solutions();
        let mut found = expected.clone();
        let mut workspace = Workspace::new(system.unknowns);
        let real = found.real.chunks_exact_mut(last.size);
        let real = real.zip(expected.real()).map(|(at, expected)| {
            self.polish_real(at, state, context)?;
            Some(distance(at, expected))
        });
        let mut real: Vec<Option<f64>> = real.collect();
        let pairs = found.complex_pairs.chunks_exact_mut(2 * last.size);
        let pairs = pairs.zip(expected.complex_pairs()).map(|(at, expected)| {
            system.polish_own(at, &mut workspace)?;
            (distance_to_conjugate(at, at) > REAL).then(|| distance(at, expected))
        });
        let mut pairs: Vec<Option<f64>> = pairs.collect();
        drop_duplicates(&mut real, &found.real, distance);
        drop_duplicates(&mut pairs, &found.complex_pairs, distance_to_pair);
        if real.iter().chain(&pairs).all(Option::is_some) {
            return Some((found, true));
        }
        let mut all = Solutions {
            size: last.size,
            real: kept(&found.real, &real, last.size),
            complex_pairs: kept(&found.complex_pairs, &pairs, 2 * last.size),
        };
        let mut lost: Vec<usize> = (0..real.len()).filter(|k| real[*k].is_none()).collect();
        while let Some(one) = lost.pop() {
            let at = |solutions: &Solutions, k: usize| {
                solutions.real[k * last.size..][..last.size].to_vec()
            };
            let to = |k: &usize| distance(&at(last, *k), &at(last, one));
            let other = lost
                .iter()
                .copied()
                .min_by(|a, b| to(a).total_cmp(&to(b)))?;
            lost.retain(|k| *k != other);
            let middle = mean(&at(&expected, one), &at(&expected, other));
            let half = |all: &Solutions| half_difference(&at(all, one), &at(all, other));
            let growth = extrapolation.growth(|all| square(&half(all)))?;
            self.add_pair(
                &mut all,
                [&middle, &half(last)],
                growth,
                system,
                state,
                context,
            )?;
        }
        for one in (0..pairs.len()).filter(|k| pairs[*k].is_none()) {
            // A conjugate pair with the mean m and the half difference i d is stored as z = m + i d and w = m̄ + i d̄.
            let both = |all: &Solutions| {
                let at = &all.complex_pairs[2 * one * last.size..][..2 * last.size];
                let (z, w) = at.split_at(last.size);
                let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
                let half = half_difference(z, &conjugates);
                let half: Vec<C> = half.iter().map(|d| d / C::i()).collect();
                (mean(z, &conjugates), half)
            };
            let (middle, _) = both(&expected);
            let growth = extrapolation.growth(|all| square(&both(all).1))?;
            self.add_pair(
                &mut all,
                [&middle, &both(last).1],
                -growth,
                system,
                state,
                context,
            )?;
        }
        all.are_distinct().then_some((all, false))
    }

    /// Adds two assemblies from their mean and their half difference, whose square is multiplied by `growth`. The
    /// assemblies are real if `growth` is positive, and conjugate otherwise.
    fn add_pair<const N: usize>(
        &self,
        all: &mut Solutions,
        [middle, half]: [&[C]; 2],
        growth: f64,
        system: &System,
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Option<()> {
        let factor = growth.abs().sqrt();
        let both = || middle.iter().zip(half);
        if growth > 0.0 {
            for factor in [factor, -factor] {
                let mut at: Vec<C> = both().map(|(m, d)| m + d * factor).collect();
                self.polish_real(&mut at, state, context)?;
                all.real.extend(at);
            }
        } else {
            let factor = C::i() * factor;
            let z = both().map(|(m, d)| m + factor * d);
            let w = both().map(|(m, d)| m.conj() + factor * d.conj());
            let mut at: Vec<C> = z.chain(w).collect();
            system.polish_own(&mut at, &mut Workspace::new(system.unknowns))?;
            if distance_to_conjugate(&at, &at) <= REAL {
                return None;
            }
            all.complex_pairs.extend(at);
        }
        Some(())
    }

    /// Refines a real assembly in place by Newton's method. `at` holds the unknowns as multiples of their units. None
    /// without convergence.
    fn polish_real<const N: usize>(
        &self,
        at: &mut [C],
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Option<()> {
        let units = || self.units.iter();
        for (unknown, (at, unit)) in state.work.unknowns.iter_mut().zip(at.iter().zip(units())) {
            unknown[0] = super::vector(at * unit);
        }
        let step = || {
            let change = self.newton_step(state, context.step).ok();
            self.apply_step(&mut state.work);
            change
        };
        newton(MAX_STEPS, step, is_exact).ok()?;
        let found = state.work.unknowns.iter().zip(units());
        for (at, (unknown, unit)) in at.iter_mut().zip(found) {
            *at = super::number(unknown[0]) / unit;
        }
        Some(())
    }
}

/// Drops duplicates. If several solutions converged to the same point, the one closest to its extrapolation is kept.
fn drop_duplicates(distances: &mut [Option<f64>], all: &[C], distance: fn(&[C], &[C]) -> f64) {
    let size = all.len() / distances.len().max(1);
    let at = |k: usize| &all[k * size..][..size];
    for k in 1..distances.len() {
        for other in 0..k {
            if let (Some(one), Some(before)) = (distances[k], distances[other])
                && distance(at(k), at(other)) <= tolerance::DOUBLE_ROOT
            {
                distances[if one > before { k } else { other }] = None;
            }
        }
    }
}

/// Solutions that were not dropped: they have a distance.
fn kept(all: &[C], distances: &[Option<f64>], size: usize) -> Vec<C> {
    let all = all.chunks_exact(size).zip(distances);
    let kept = all.filter(|(_, distance)| distance.is_some());
    kept.flat_map(|(at, _)| at).copied().collect()
}

fn half_difference(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a - b) / 2.0).collect()
}

fn square(all: &[C]) -> f64 {
    all.iter().map(|c| c.norm_sqr()).sum()
}
