//! All assemblies at an input: the links joined in every way, group by group.

use super::{Mechanism, Pose, Signs};
use crate::Jet;
use crate::index::StepId;
use crate::position::{Cause, Given, Method, Nearby, Sign, State, Step};

/// No more ways are found, and no more steps solved to find them: n dyads can be joined in 2ⁿ ways, few of which may close.
const MOST: usize = 4096;
const MOST_TRIES: usize = 1 << 16;

/// The assemblies of a linkage at an input.
#[derive(Clone, Debug)]
pub struct Assemblies {
    /// A pose of each.
    pub poses: Vec<Pose<1>>,
    /// Of each group that was solved over the complex numbers, once for every way in which it could hang, how many
    /// solutions there are: six of five links of a Baranov truss, 14, 16 or 18 of seven, fewer of special dimensions.
    pub complex: Vec<usize>,
    /// Whether these are all. They are not where wheels are in mesh within a group, and where there are very many.
    pub whole: bool,
}

impl Mechanism {
    /// All assemblies at an input: radians, or the way of a driven slide. Dyads are joined in closed form; the equations
    /// of other groups are solved over the complex numbers, so that none is missed. Wheels stay as they are mounted.
    ///
    /// They come in no particular order, none twice; those that meet in a singular pose are none.
    pub fn assemblies_at(&self, input: f64, method: Method) -> Assemblies {
        let mut search = Search {
            mechanism: self,
            input: Jet::linear(input, 1.0),
            signs: self.signs.clone(),
            natural: self.natural.clone(),
            found: Vec::new(),
            tries: MOST_TRIES,
            method,
            complex: Vec::new(),
            whole: true,
        };
        let steps: Vec<StepId> = self.steps.ids().collect();
        let mut state: State<1> = self.blank_state();
        search.join(&steps, &mut state);
        Assemblies {
            poses: search.found,
            complex: search.complex,
            whole: search.whole,
        }
    }
}

struct Search<'a> {
    mechanism: &'a Mechanism,
    input: Jet<1>,
    signs: Signs,
    natural: Vec<f64>,
    found: Vec<Pose<1>>,
    tries: usize,
    method: Method,
    complex: Vec<usize>,
    whole: bool,
}

impl Search<'_> {
    fn join(&mut self, steps: &[StepId], state: &mut State<1>) {
        let [step, rest @ ..] = steps else {
            self.found
                .push(Pose::of(state.clone(), self.natural.clone()));
            return;
        };
        if let Step::Group(group) = &self.mechanism.steps[*step] {
            let ways = group.ways(state, &self.given(*step), self.method);
            let Ok(Some(ways)) = ways else {
                self.whole &= ways.is_err();
                if ways.is_ok() {
                    self.go_on(*step, rest, state);
                }
                return;
            };
            self.complex.push(ways.complex);
            for way in &ways.real {
                group.set(&mut self.natural, way);
                self.go_on(*step, rest, state);
            }
            return;
        }
        for sign in self.mechanism.joinings(*step) {
            self.signs[*step] = *sign;
            self.go_on(*step, rest, state);
        }
        self.signs[*step] = Sign::Plus;
    }

    fn go_on(&mut self, step: StepId, rest: &[StepId], state: &mut State<1>) {
        if self.tries == 0 || self.found.len() == MOST {
            self.whole = false;
            return;
        }
        self.tries -= 1;
        if self.put(step, state).is_ok() {
            self.join(rest, state);
        }
    }

    fn put(&self, step: StepId, state: &mut State<1>) -> Result<(), Cause> {
        self.mechanism.steps[step].put(state, &self.given(step))
    }

    fn given(&self, step: StepId) -> Given<'_, 1> {
        Given {
            step,
            input: self.input,
            sign: self.signs[step],
            near: Nearby {
                orientations: &self.mechanism.orientations,
                natural: &self.natural,
                smooth_roots: &[],
            },
        }
    }
}
