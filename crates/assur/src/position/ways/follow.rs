//! The ways to join a group at places one after another: each is followed from where it was found last by Newton's method. They
//! are all of them where they are as many as there are at a general place, none twice; on any doubt they are found anew.
//!
//! Two real ways that meet go on as two that are each other's conjugates, and the other way round. Half of what is between the
//! two has a square that goes through zero evenly: from two places before it tells how far they are apart behind it.

use super::bilinear::{C, ROUNDING, Room, System};
use super::{ONE, REAL, Solutions, apart, apart_from_conjugate};
use crate::Vector;
use crate::position::group::Group;
use crate::position::{Given, State};

/// What a group takes from what is solved may have changed by so much, relative to its links, since they were found.
const FAR: f64 = 0.25;
/// Places that differ by more tell independently how many ways there are.
const APART: f64 = 1e-3;
/// It is not extrapolated by more than so many times the last way.
const MOST_AHEAD: f64 = 4.0;
/// Newton's method takes no more turns.
const MOST_TURNS: usize = 8;
/// No more places are kept at which the group hangs.
const MOST_CHAINS: usize = 64;

/// What is known of the ways to join a group, wherever it hangs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Followed {
    chains: Vec<Chain>,
    /// How many ways there are at most, over the complex numbers, as far as is known: at a general place. Whether a second
    /// place agreed.
    general: usize,
    agreed: bool,
    /// The equations at the last place.
    pub(super) system: Option<System>,
}

/// What was found where the group hung on one way of those before it.
#[derive(Clone, Debug)]
struct Chain {
    last: Sample,
    /// Up to two before, the newer first, with the same ways in the same order.
    before: Vec<Sample>,
    used: bool,
}

#[derive(Clone, Debug)]
struct Sample {
    given: Vec<Vector>,
    found: Solutions,
}

/// Where something is expected, by the last samples.
struct Ahead<'a> {
    chain: &'a Chain,
    /// How far ahead it is, in ways between the last two.
    times: f64,
    /// What each sample counts, the last one first.
    weights: [f64; 3],
}

impl Followed {
    /// All ways are asked for once more.
    pub(crate) fn begin(&mut self) {
        self.chains.retain(|chain| chain.used);
        for chain in &mut self.chains {
            chain.used = false;
        }
    }

    /// The chain that is nearest to a place, and how far it is.
    fn nearest(&self, given: &[Vector]) -> Option<(usize, f64)> {
        let chains = self.chains.iter().enumerate();
        let unused = chains.filter(|(_, chain)| !chain.used);
        let off = unused.map(|(k, chain)| (k, distance(&chain.last.given, given)));
        off.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Takes what was found anew.
    pub(super) fn take(&mut self, given: Vec<Vector>, found: &Solutions) {
        let count = found.complex();
        if count > self.general {
            self.agreed = false;
            self.general = count;
            self.chains.clear();
        } else if count == self.general {
            self.agreed |= self
                .chains
                .iter()
                .any(|chain| distance(&chain.last.given, &given) > APART);
        } else {
            return;
        }
        let chain = Chain {
            last: Sample {
                given,
                found: found.clone(),
            },
            before: Vec::new(),
            used: true,
        };
        match self.nearest(&chain.last.given) {
            Some((k, off)) if off < FAR => self.chains[k] = chain,
            _ if self.chains.len() < MOST_CHAINS => self.chains.push(chain),
            _ => {}
        }
    }
}

impl Ahead<'_> {
    /// Where all are, by where they were.
    fn expected(&self) -> Solutions {
        let Chain { last, before, .. } = self.chain;
        let mut expected = last.found.clone();
        let [by, rest @ ..] = self.weights;
        let all = expected.real.iter_mut().chain(&mut expected.unreal);
        all.for_each(|at| *at *= by);
        for (before, by) in before.iter().zip(rest) {
            let found = before.found.real.iter().chain(&before.found.unreal);
            let all = expected.real.iter_mut().chain(&mut expected.unreal);
            for (at, before) in all.zip(found) {
                *at += before * by;
            }
        }
        expected
    }

    /// By how much a square has grown, relative to its last value; none where nothing tells.
    fn grown(&self, square: impl Fn(&Solutions) -> f64) -> Option<f64> {
        let before = self.chain.before.first()?;
        let last = square(&self.chain.last.found);
        Some(1.0 + (1.0 - square(&before.found) / last) * self.times)
    }
}

impl Group {
    /// All ways where they can be followed to here, as the group has received what it hangs on.
    pub(super) fn followed<const N: usize>(
        &self,
        followed: &mut Followed,
        system: &System,
        state: &mut State<N>,
        given: &Given<'_, N>,
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
        ahead: &Ahead<'_>,
        system: &System,
        state: &mut State<N>,
        given: &Given<'_, N>,
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
        given: &Given<'_, N>,
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
        given: &Given<'_, N>,
    ) -> Option<()> {
        let units = || self.units.iter();
        for (place, (at, unit)) in state.work.unknowns.iter_mut().zip(at.iter().zip(units())) {
            place[0] = super::vector(at * unit);
        }
        let mut last = f64::INFINITY;
        for _ in 0..MOST_TURNS {
            let change = self.turn(state, given.step).ok()?;
            self.correct(&mut state.work);
            if last.is_finite() && change * (change / last).powi(2) <= ROUNDING {
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

impl Chain {
    /// What is expected at a place: by a line through the last two samples, or a parabola through three.
    fn ahead(&self, place: &[Vector]) -> Ahead<'_> {
        let mut ahead = Ahead {
            chain: self,
            times: 0.0,
            weights: [1.0, 0.0, 0.0],
        };
        let [before, earlier @ ..] = &self.before[..] else {
            return ahead;
        };
        let terms = place.iter().zip(&self.last.given).zip(&before.given);
        let (along, way) = terms.fold((0.0, 0.0), |(along, way), ((here, last), before)| {
            let step = last - before;
            (along + (here - last).dot(&step), way + step.norm_squared())
        });
        let t = along / way;
        if t.is_nan() || t.abs() > MOST_AHEAD {
            return ahead;
        }
        ahead.times = t;
        ahead.weights = [1.0 + t, -t, 0.0];
        let [earlier] = earlier else {
            return ahead;
        };
        // At 0, −1 and −r of that way.
        let r = 1.0
            + distance(&before.given, &earlier.given) / distance(&self.last.given, &before.given);
        if r > 1.0 + MOST_AHEAD.recip() && r < 1.0 + MOST_AHEAD {
            ahead.weights = [
                (t + 1.0) * (t + r) / r,
                -t * (t + r) / (r - 1.0),
                t * (t + 1.0) / (r * (r - 1.0)),
            ];
        }
        ahead
    }
}

impl Solutions {
    fn are_distinct(&self) -> bool {
        let (mut real, mut unreal) = (self.real().enumerate(), self.unreal().enumerate());
        real.all(|(k, one)| self.real().take(k).all(|other| apart(one, other) > ONE))
            && unreal.all(|(k, one)| {
                let mut others = self.unreal().take(k);
                others.all(|other| apart_either_way(one, other) > ONE)
            })
    }
}

/// How far a solution is from another one or from its conjugate.
fn apart_either_way(one: &[C], other: &[C]) -> f64 {
    f64::min(apart(one, other), apart_from_conjugate(one, other))
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

fn mean(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a + b) / 2.0).collect()
}

fn half_way(a: &[C], b: &[C]) -> Vec<C> {
    a.iter().zip(b).map(|(a, b)| (a - b) / 2.0).collect()
}

fn square(all: &[C]) -> f64 {
    all.iter().map(|c| c.norm_sqr()).sum()
}

fn distance(a: &[Vector], b: &[Vector]) -> f64 {
    let all = a.iter().zip(b).map(|(a, b)| (a - b).norm_squared());
    all.fold(0.0, f64::max).sqrt()
}
