//! The ways to join a group at places one after another: each is followed from where it was found last by Newton's method. They
//! are all of them where they are as many as there are at a general place, none twice; on any doubt they are found anew.
//!
//! Two real ways that meet go on as two that are each other's conjugates, and the other way round. Half of what is between the
//! two has a square that goes through zero evenly: from two places before it tells how far they are apart behind it.

use super::bilinear::{C, System};
use super::newton::{Room, is_exact};
use super::solutions::{ONE, REAL, Solutions, apart, apart_either_way, apart_from_conjugate, mean};
use super::tracker::{Extrapolation, FAR, Sample, Tracker};
use crate::Vector;
use crate::position::{Group, State, StepContext};

/// Newton's method takes no more turns.
const MOST_TURNS: usize = 8;

impl Group {
    /// All ways where they can be followed to here, as the group has received what it hangs on.
    pub(super) fn followed<const N: usize>(
        &self,
        followed: &mut Tracker,
        system: &System,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Option<Solutions> {
        let place = self.place(state);
        if !followed.agreed {
            return None;
        }
        let (at, off) = followed.nearest(&place)?;
        if off > FAR {
            return None;
        }
        let chain = &followed.chains[at];
        let ahead = chain.ahead(&place);
        let (found, same) = self.all_ahead(&ahead, system, state, given)?;
        if found.complex() != followed.general {
            return None;
        }
        let chain = &mut followed.chains[at];
        let sample = Sample {
            given: place,
            found: found.clone(),
        };
        // Where it is still the one before stays, too.
        if off > 0.0 {
            let last = std::mem::replace(&mut chain.last, sample);
            if same {
                chain.before.truncate(1);
                chain.before.insert(0, last);
            } else {
                chain.before.clear();
            }
        }
        chain.used = true;
        Some(found)
    }

    /// What the forms of its equations have of what it hangs on, and how far driven pairs are.
    pub(super) fn place<const N: usize>(&self, state: &State<N>) -> Vec<Vector> {
        let known = state.work.known.iter().copied();
        let driven = state.work.given.iter();
        let driven = driven.map(|mesh| Vector::new(mesh.angle.value(), 0.0));
        known.chain(driven).collect()
    }

    /// All that is where it is expected, none twice, and whether it is of the same kind as it was.
    fn all_ahead<const N: usize>(
        &self,
        ahead: &Extrapolation<'_>,
        system: &System,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Option<(Solutions, bool)> {
        let last = &ahead.chain.last.found;
        let expected = ahead.expected();
        let mut found = expected.clone();
        let mut room = Room::new(system.unknowns);
        let real = found.real.chunks_exact_mut(last.size);
        let real = real.zip(expected.real()).map(|(at, expected)| {
            self.join(at, state, given)?;
            Some(apart(at, expected))
        });
        let mut real: Vec<Option<f64>> = real.collect();
        let unreal = found.unreal.chunks_exact_mut(2 * last.size);
        let unreal = unreal.zip(expected.unreal()).map(|(at, expected)| {
            system.polish_own(at, &mut room)?;
            (unreal_by(at) > REAL).then(|| apart(at, expected))
        });
        let mut unreal: Vec<Option<f64>> = unreal.collect();
        drop_strays(&mut real, &found.real, apart);
        drop_strays(&mut unreal, &found.unreal, apart_either_way);
        if real.iter().chain(&unreal).all(Option::is_some) {
            return Some((found, true));
        }
        let mut all = Solutions {
            size: last.size,
            real: those(&found.real, &real, last.size),
            unreal: those(&found.unreal, &unreal, 2 * last.size),
        };
        let mut lost: Vec<usize> = (0..real.len()).filter(|k| real[*k].is_none()).collect();
        while let Some(one) = lost.pop() {
            let at =
                |found: &Solutions, k: usize| found.real[k * last.size..][..last.size].to_vec();
            let to = |k: &usize| apart(&at(last, *k), &at(last, one));
            let other = lost
                .iter()
                .copied()
                .min_by(|a, b| to(a).total_cmp(&to(b)))?;
            lost.retain(|k| *k != other);
            let middle = mean(&at(&expected, one), &at(&expected, other));
            let half = |found: &Solutions| half_way(&at(found, one), &at(found, other));
            let grown = ahead.grown(|found| square(&half(found)))?;
            self.put_pair(
                &mut all,
                [&middle, &half(last)],
                grown,
                system,
                state,
                given,
            )?;
        }
        for one in (0..unreal.len()).filter(|k| unreal[*k].is_none()) {
            // z = m + i d, w = m̄ + i d̄.
            let both = |found: &Solutions| {
                let at = &found.unreal[2 * one * last.size..][..2 * last.size];
                let (z, w) = at.split_at(last.size);
                let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
                let half = half_way(z, &conjugates);
                let half: Vec<C> = half.iter().map(|d| d / C::i()).collect();
                (mean(z, &conjugates), half)
            };
            let (middle, _) = both(&expected);
            let grown = ahead.grown(|found| square(&both(found).1))?;
            self.put_pair(
                &mut all,
                [&middle, &both(last).1],
                -grown,
                system,
                state,
                given,
            )?;
        }
        all.are_distinct().then_some((all, false))
    }

    /// Adds the two ways about a middle, where half of what was between them has grown so: real where its square is
    /// positive, else conjugate to each other.
    fn put_pair<const N: usize>(
        &self,
        all: &mut Solutions,
        [middle, half]: [&[C]; 2],
        grown: f64,
        system: &System,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Option<()> {
        let by = grown.abs().sqrt();
        let both = || middle.iter().zip(half);
        if grown > 0.0 {
            for by in [by, -by] {
                let mut at: Vec<C> = both().map(|(m, d)| m + d * by).collect();
                self.join(&mut at, state, given)?;
                all.real.extend(at);
            }
        } else {
            let off = C::i() * by;
            let z = both().map(|(m, d)| m + off * d);
            let w = both().map(|(m, d)| m.conj() + off * d.conj());
            let mut at: Vec<C> = z.chain(w).collect();
            system.polish_own(&mut at, &mut Room::new(system.unknowns))?;
            if unreal_by(&at) <= REAL {
                return None;
            }
            all.unreal.extend(at);
        }
        Some(())
    }

    /// Newton's method from a guess of a real way, unknowns in their units, in its place; none where it goes nowhere.
    fn join<const N: usize>(
        &self,
        at: &mut [C],
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Option<()> {
        let units = || self.units.iter();
        for (place, (at, unit)) in state.work.unknowns.iter_mut().zip(at.iter().zip(units())) {
            place[0] = super::vector(at * unit);
        }
        let mut last = f64::INFINITY;
        for _ in 0..MOST_TURNS {
            let change = self.turn(state, given.step).ok()?;
            self.correct(&mut state.work);
            if is_exact(change, last) {
                let found = state.work.unknowns.iter().zip(units());
                for (at, (place, unit)) in at.iter_mut().zip(found) {
                    *at = super::number(place[0]) / unit;
                }
                return Some(());
            }
            last = change;
        }
        None
    }
}

/// Of those that came to the same end the one that came from afar is lost.
fn drop_strays(off: &mut [Option<f64>], all: &[C], apart: fn(&[C], &[C]) -> f64) {
    let size = all.len() / off.len().max(1);
    let at = |k: usize| &all[k * size..][..size];
    for k in 1..off.len() {
        for other in 0..k {
            if let (Some(one), Some(before)) = (off[k], off[other])
                && apart(at(k), at(other)) <= ONE
            {
                off[if one > before { k } else { other }] = None;
            }
        }
    }
}

/// Those that are not lost.
fn those(all: &[C], off: &[Option<f64>], size: usize) -> Vec<C> {
    let all = all.chunks_exact(size).zip(off);
    let kept = all.filter(|(_, off)| off.is_some());
    kept.flat_map(|(at, _)| at).copied().collect()
}

/// How far a solution is from its conjugate.
fn unreal_by(at: &[C]) -> f64 {
    apart_from_conjugate(at, at)
}

fn half_way(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a - b) / 2.0).collect()
}

fn square(all: &[C]) -> f64 {
    all.iter().map(|c| c.norm_sqr()).sum()
}
