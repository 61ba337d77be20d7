//! All ways to join an Assur group at known places of what it hangs on.

mod bilinear;
mod dixon;
mod homotopy;
mod newton;
mod solutions;
mod tracker;
mod tracking;

use super::{Cause, DriveLaw, Equation, Group, State, StepContext};
use crate::Vector;
use crate::index::BodyId;
use bilinear::{Affine, C, Moving, Pair, System};
use newton::Room;
use solutions::{ONE, REAL, Solutions, apart, apart_from_conjugate, conjugate, mean};
pub(crate) use tracker::Tracker;

/// So many bundles of paths are followed, until one finds nothing new.
const MOST_BUNDLES: u64 = 6;
/// So many hidden directions in which all solutions are found tell that these are all, where their number is not known.
const AGREED: usize = 2;

/// How all ways to join a group are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// By the determinant of the loops where there are only hinges, else by paths.
    Usual,
    /// By paths from equations whose solutions are known: slower, and a check of the other.
    Paths,
}

/// A way to join a group.
#[derive(Clone, Debug)]
pub(crate) struct GroupAssembly {
    /// Its unknowns.
    pub(crate) own: Vec<Vector>,
    /// How those bodies are turned that are driven against each other: their angles are told near it.
    pub(crate) turned: Vec<(BodyId, Vector)>,
}

/// All ways to join a group.
#[derive(Clone, Debug, Default)]
pub(crate) struct GroupAssemblies {
    /// The real ones.
    pub(crate) real: Vec<GroupAssembly>,
    /// Whether they are exact already, as those are that are followed, and nothing but places is asked for.
    pub(crate) solved: bool,
    /// How many there are over the complex numbers, the real ones among them.
    pub(crate) complex: usize,
    /// Of each that is not real how far it is from it.
    pub(crate) unreal: Vec<ComplexPair>,
}

/// How far a way to join links is from a real one: a square that goes through zero where two ways meet and become real,
/// about in proportion to the distance of the input from there; with its derivative by the input.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ComplexPair {
    pub(crate) square: f64,
    pub(crate) slope: f64,
}

impl Group {
    /// Whether all ways to join it can be found: no wheels are in mesh within it, and no equation is redundant.
    pub(crate) fn is_algebraic(&self) -> bool {
        !self.is_redundant()
            && self
                .angle_constraints
                .iter()
                .all(|mesh| mesh.drive.is_some())
    }

    /// The ranges of pairs that are driven within it, and how these go with the input.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = (DriveLaw, [f64; 2])> {
        let drives = self
            .angle_constraints
            .iter()
            .filter_map(|mesh| mesh.drive.as_ref());
        drives.filter_map(|drive| Some((drive.course, drive.range?)))
    }

    /// All ways to join it where what it hangs on is. None where its equations are not algebraic: wheels in mesh; and
    /// where finding them is more than the work that is left, of which it takes its part. Those that can be followed from
    /// where they were found last are not found anew.
    pub(crate) fn ways<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
        (method, left): (Method, &mut usize),
        mut followed: Option<&mut Tracker>,
    ) -> Result<Option<GroupAssemblies>, Cause> {
        self.receive(state, given)?;
        let kept = followed
            .as_deref_mut()
            .and_then(|followed| followed.system.take());
        let kept = kept.and_then(|system| self.refreshed(system, state));
        let kept = kept.map(|system| (system, Turning::new()));
        let Some((system, turning)) = kept.or_else(|| self.system(state)) else {
            return Ok(None);
        };
        let near = followed.as_deref_mut();
        let near = near.and_then(|near| self.followed(near, &system, state, given));
        let solved = N == 1 && near.is_some();
        let found = match near {
            Some(found) => found,
            None => {
                let Some(rest) = left.checked_sub(system.work(method)) else {
                    return Ok(None);
                };
                *left = rest;
                let found = system.solutions(method);
                if let Some(followed) = &mut followed {
                    followed.take(self.place(state), &found);
                }
                found
            }
        };
        // Without derivatives of what it hangs on there are none of how far a way is from a real one.
        let unreal = found.unreal().filter(|_| N > 1);
        let unreal = unreal.filter_map(|at| system.unreal(&system.reduced(at)));
        let real = found.real().map(|own| GroupAssembly {
            own: own
                .iter()
                .zip(&self.units)
                .map(|(place, unit)| vector(place * unit))
                .collect(),
            turned: turning
                .iter()
                .map(|(body, turn)| (*body, vector(turn.at(own))))
                .collect(),
        });
        let ways = GroupAssemblies {
            solved,
            complex: found.complex(),
            // Each is as far from it as its conjugate.
            unreal: unreal.flat_map(|one| [one; 2]).collect(),
            real: real.collect(),
        };
        if let Some(followed) = followed {
            followed.system = Some(system);
        }
        Ok(Some(ways))
    }

    /// Equations of a place before with what the group has received now: only constants differ. None where more does.
    fn refreshed<const N: usize>(&self, mut system: System, state: &State<N>) -> Option<System> {
        let of = system.given.as_ref().filter(|_| N == 1)?;
        let value = |form: usize| number(state.work.values[form][0]);
        for (pair, k) in system.pairs.iter_mut().zip(of) {
            match (pair, self.equations[*k]) {
                (Pair::Unit(one), Equation::Unit(form)) => one.constant = value(form),
                (Pair::Parallel(one, other), Equation::Line { direction, way }) => {
                    one.constant = value(direction);
                    other.constant = value(way);
                }
                _ => return None,
            }
        }
        Some(system)
    }

    /// Its equations over the complex numbers, as it has received what it hangs on, unknowns in their units, with what
    /// their forms change by with the input; and the turns of driven bodies.
    fn system<const N: usize>(&self, state: &State<N>) -> Option<(System, Turning)> {
        if self.is_redundant() {
            return None;
        }
        let angles = state.work.given.iter().map(|mesh| {
            [0, 1].map(|order| {
                if order < N {
                    -mesh.angle.coefficient(order)
                } else {
                    0.0
                }
            })
        });
        let angles: Vec<[f64; 2]> = angles.collect();
        let values = &state.work.values[..self.equated];
        let forms = values.iter().map(|value| {
            [0, 1].map(|order| {
                let own = (order < N).then(|| number(value[order]));
                Affine::constant(own.unwrap_or_default(), self.units.len())
            })
        });
        let mut forms: Vec<Moving> = forms.collect();
        for term in &self.sought {
            forms[term.form][0].by[term.of] += number(term.by) * self.units[term.of];
        }
        let form = |k: usize| forms[k].clone();
        let (mut pairs, mut zeros, mut turning) = (Vec::new(), Vec::new(), Vec::new());
        for equation in &self.equations {
            match *equation {
                Equation::Unit(one) => pairs.push(Pair::Unit(form(one))),
                // The imaginary part goes with it.
                Equation::Real(one) => zeros.push(form(one)),
                Equation::Imaginary(_) => {}
                Equation::Line { direction, way } => {
                    pairs.push(Pair::Parallel(form(direction), form(way)));
                }
                Equation::Along {
                    direction,
                    way,
                    mesh,
                } => {
                    pairs.push(Pair::Along(form(direction), form(way), angles[mesh]));
                }
                Equation::Angle {
                    turns: [Some((link, 1.0)), Some((base, -1.0)), None],
                    mesh,
                } if self.angle_constraints[mesh].drive.is_some() => {
                    let [angle, rate] = angles[mesh];
                    let turn = C::from_polar(1.0, angle);
                    let spin = turn * C::new(0.0, rate);
                    let turns = [form(link), form(base)].map(|[turn, _]| turn);
                    turning.extend(
                        self.angle_constraints[mesh]
                            .turning
                            .iter()
                            .copied()
                            .zip(turns),
                    );
                    let ([mut zero, mut rates], [base, base_rates]) = (form(link), form(base));
                    zero.add(-turn, &base);
                    rates.add(-turn, &base_rates);
                    rates.add(-spin, &base);
                    zeros.push([zero, rates]);
                }
                Equation::Angle { .. } => return None,
            }
        }
        let system = System::new(self.units.len(), pairs, zeros)?;
        Some((system, turning))
    }
}

/// How many directions of a group of so many unknowns are hidden, unless its dimensions are special.
fn directions_hidden(unknowns: usize) -> usize {
    if unknowns < 4 { 1 } else { AGREED }
}

/// Bodies with the forms of their turns.
type Turning = Vec<(BodyId, Affine)>;

fn number(v: Vector) -> C {
    C::new(v.x, v.y)
}

fn vector(c: C) -> Vector {
    Vector::new(c.re, c.im)
}

impl System {
    /// About how long it takes to solve, in microseconds: with n solutions, C(2m, m) for m unknowns, the determinant of
    /// loops takes about n³/20 for each hidden direction, a path more than half a millisecond.
    fn work(&self, method: Method) -> usize {
        let solutions =
            (1..=self.unknowns).fold(1, |n: usize, k| n.saturating_mul(self.unknowns + k) / k);
        let by_loops = self.pairs.iter().all(|pair| matches!(pair, Pair::Unit(_)));
        if by_loops && method == Method::Usual {
            solutions.saturating_pow(3) / 20 * directions_hidden(self.unknowns)
        } else {
            solutions.saturating_mul(800)
        }
    }

    fn solutions(&self, method: Method) -> Solutions {
        let mut found: Vec<Vec<C>> = Vec::new();
        if method == Method::Paths || !self.add_by_loops(&mut found) {
            self.add_by_paths(&mut found);
        }
        let mut solutions = Solutions {
            size: self.own_unknowns().max(1),
            ..Solutions::default()
        };
        let mut unreal: Vec<Vec<C>> = Vec::new();
        let mut room = Room::new(self.unknowns);
        for at in found {
            if let Some(real) = self.real(&at, &mut room) {
                solutions.real.extend(self.own(&real));
                continue;
            }
            if !unreal
                .iter()
                .any(|other| apart_from_conjugate(other, &at) < ONE)
            {
                solutions.unreal.extend(self.own_both(&at));
                unreal.push(at);
            }
        }
        solutions
    }

    /// How far a solution is from a real one: from its conjugate, which is one as well.
    fn unreal(&self, at: &[C]) -> Option<ComplexPair> {
        let rate = self.rate(at)?;
        let off = |all: &[C]| -> Vec<C> {
            let (z, w) = all.split_at(self.unknowns);
            z.iter().zip(w).map(|(z, w)| z - w.conj()).collect()
        };
        let ways = off(at).into_iter().zip(off(&rate));
        let nothing = ComplexPair {
            square: 0.0,
            slope: 0.0,
        };
        Some(ways.fold(nothing, |sum, (off, rate)| ComplexPair {
            square: sum.square + off.norm_sqr(),
            slope: sum.slope + 2.0 * (off.conj() * rate).re,
        }))
    }

    /// Adds what the loops of a group of hinges tell; false where it is none. Where fewer are found than groups of
    /// general dimensions have, further directions are hidden as well: one may be lost to rounding, and those are that
    /// have the hidden direction in common. How many solutions there are in general is known of up to three unknowns; of
    /// more, two directions in which all are found, and none is new in the second, tell that these are all.
    fn add_by_loops(&self, found: &mut Vec<Vec<C>>) -> bool {
        self.directions_tried(found) > 0
    }

    /// The same; how many directions have been hidden.
    fn directions_tried(&self, found: &mut Vec<Vec<C>>) -> usize {
        let mut agreed = 0;
        for hidden in 0..2 * self.unknowns {
            let Some(candidates) = dixon::candidates(self, hidden) else {
                return hidden;
            };
            let before = found.len();
            let told = self.add(candidates, found);
            let is_new = found.len() > before;
            agreed = match told == found.len() {
                true if is_new => 1,
                true => agreed + 1,
                false if is_new => 0,
                false => agreed,
            };
            let usual = match self.unknowns {
                1 => found.len() == 2,
                2 => found.len() == 6,
                3 => matches!(found.len(), 14 | 16 | 18 | 20),
                _ => agreed == AGREED,
            };
            if usual {
                return hidden + 1;
            }
        }
        2 * self.unknowns
    }

    /// Adds what paths lead to. Of two that come close to each other one may be left for the other: then others lead to
    /// its end.
    fn add_by_paths(&self, found: &mut Vec<Vec<C>>) {
        for beginning in 0..MOST_BUNDLES {
            let before = found.len();
            self.add(homotopy::candidates(self, beginning), found);
            if beginning > 0 && found.len() == before {
                return;
            }
        }
    }

    /// Adds what is new among guesses that are none else; how many solutions the guesses lead to.
    fn add(&self, candidates: Vec<Vec<C>>, found: &mut Vec<Vec<C>>) -> usize {
        let mut room = Room::new(self.unknowns);
        let mut told = vec![false; found.len()];
        for candidate in candidates {
            let Some(at) = self.polished(candidate, &mut room) else {
                continue;
            };
            // With a solution its conjugate is one.
            let conjugate = conjugate(&at);
            for at in [at, conjugate] {
                match found.iter().position(|other| apart(other, &at) < ONE) {
                    Some(known) => told[known] = true,
                    None => {
                        found.push(at);
                        told.push(true);
                    }
                }
            }
        }
        told.into_iter().filter(|told| *told).count()
    }

    /// The real solution that this is.
    fn real(&self, at: &[C], room: &mut Room) -> Option<Vec<C>> {
        let (z, w) = at.split_at(self.unknowns);
        let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
        if apart(z, &conjugates) > REAL {
            return None;
        }
        let middle = mean(z, &conjugates);
        let both: Vec<C> = middle
            .iter()
            .copied()
            .chain(middle.iter().map(|z| z.conj()))
            .collect();
        let polished = self.polished(both, room)?;
        let (z, w) = polished.split_at(self.unknowns);
        let conjugates: Vec<C> = w.iter().map(|w| w.conj()).collect();
        (apart(z, &conjugates) < ONE && apart(z, &middle) < REAL).then(|| z.to_vec())
    }
}

#[cfg(test)]
mod tests;
