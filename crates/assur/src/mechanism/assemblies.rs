//! All assemblies at an input: all combinations of the assemblies of the groups.

use std::sync::Arc;

use crate::Jet;
use crate::index::{List, StepId};
use crate::mechanism::{AssemblySigns, Configuration, Defect, Layout, Mechanism, Pose};
use crate::position::{Cause, ComplexPair, Method, Sign, State, Step, StepContext, Tracker};

/// Maximum number of assemblies. A linkage of n dyads has 2ⁿ combinations of signs, but perhaps only a few close.
const MAX_ASSEMBLIES: usize = 4096;
/// Maximum number of steps solved to find the assemblies.
const MAX_TRIES: usize = 1 << 16;
/// Maximum work of solving groups over the complex numbers, approximately in microseconds. It is enough for a group of
/// four loops of hinges, or of three with slides, but not for a long chain of such groups with many assemblies each.
const MAX_WORK: usize = 60_000;

/// The assemblies of a linkage at an input.
///
/// ```
/// use assur::mechanism::Method;
/// use assur::mixer::{Case, Mixer};
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let assemblies = motion.mechanism().assemblies_at(1.0, Method::Usual);
/// assert!(assemblies.whole);
/// assert_eq!(assemblies.poses.len(), 2); // of the four-bar
/// ```
#[derive(Clone, Debug)]
pub struct Assemblies {
    /// Pose of each assembly.
    pub poses: Vec<Pose<1>>,
    /// Numbers of complex solutions of the groups that are solved over the complex numbers. A group is listed once for
    /// each assembly of the groups before it. A Baranov truss of five links has six solutions; one of seven links has
    /// 14, 16 or 18. Special dimensions have fewer.
    pub complex: Vec<usize>,
    /// True if no assembly is missing. Some may be missing if wheels mesh within a group, if the maximum number is
    /// exceeded, or if the search would take too long.
    pub whole: bool,
}

/// Assemblies of a linkage at successive inputs. If an input is near the previous one, the solutions of groups are
/// tracked from the previous input, in at most a tenth of the time of a new search. The tracked set is complete if its
/// solutions are distinct and as numerous as in the general case. If in doubt, all solutions are computed anew.
#[derive(Clone, Debug)]
pub struct Following {
    mechanism: Mechanism,
    groups: List<StepId, Tracker>,
    /// Buffer for solving.
    room: State<1>,
}

impl Following {
    /// All assemblies at an input: see [`Mechanism::assemblies_at`].
    pub fn at(&mut self, input: f64) -> Assemblies {
        let Self {
            mechanism,
            groups,
            room,
        } = self;
        groups.iter_mut().for_each(Tracker::begin);
        let Mechanism { layout, drawn, .. } = mechanism;
        let found = layout.found_with(drawn, input, Method::Usual, Some(groups), room);
        found.into()
    }
}

/// Assemblies found at an input, with derivatives.
#[derive(Clone, Debug, Default)]
pub(crate) struct Found<const N: usize> {
    /// Pose and assembly signs of each assembly.
    pub(crate) ways: Vec<(Pose<N>, AssemblySigns)>,
    complex: Vec<usize>,
    /// Complex conjugate pairs of solutions, for groups and for dyads out of reach. Empty if `N` is 1.
    pub(crate) unreal: Vec<ComplexPair>,
    /// For each pair of guides that must cross: the squared sine of the angle between them, with its derivative. At an
    /// input at which the guides are parallel, the bodies on them are at infinity. Near this input the links joined to
    /// these bodies may close over a short interval.
    pub(crate) parallel: Vec<ComplexPair>,
    pub(crate) whole: bool,
}

impl Mechanism {
    /// All assemblies at an input, in radians or as the coordinate of a driven slide. Dyads are solved in closed form,
    /// other groups over the complex numbers, so that no solution is missed. Wheels keep their mounting.
    ///
    /// The assemblies are in no particular order and without repetition. Assemblies that meet in a singular pose are
    /// left out.
    pub fn assemblies_at(&self, input: f64, method: Method) -> Assemblies {
        let state = &mut self.blank_state();
        let found = self
            .layout
            .found_with::<1>(&self.drawn, input, method, None, state);
        found.into()
    }

    /// All assemblies at successive inputs.
    pub fn following(&self) -> Following {
        Following {
            mechanism: self.clone(),
            groups: self.steps().iter().map(|_| Tracker::default()).collect(),
            room: self.blank_state(),
        }
    }

    /// All assemblies at an input, with derivatives and complex pairs.
    pub(crate) fn found_at<const N: usize>(&self, input: f64) -> Found<N> {
        self.layout.found_at(&self.drawn, input)
    }

    /// The mechanism redrawn in an assembly found at an input.
    pub(crate) fn in_assembly(
        &self,
        input: f64,
        (pose, signs): &(Pose<4>, AssemblySigns),
    ) -> Result<Self, Vec<Defect>> {
        let spec = self.drawn_by(&pose.state);
        let drawn = Configuration {
            input,
            signs: signs.clone(),
            ..self.drawn.clone()
        };
        let drawn = drawn.posed(&pose.state);
        Ok(Self {
            start: self.layout.start(&spec, &drawn)?,
            layout: Arc::clone(&self.layout),
            spec: Arc::new(spec),
            drawn,
        })
    }
}

impl Layout {
    /// All assemblies at an input. A nearby configuration gives the whole turns of angles and the mounting of wheels.
    pub(super) fn found_at<const N: usize>(&self, at: &Configuration, input: f64) -> Found<N> {
        self.found_with(at, input, Method::Usual, None, &mut self.blank_state())
    }

    fn found_with<const N: usize>(
        &self,
        near: &Configuration,
        input: f64,
        method: Method,
        following: Option<&mut List<StepId, Tracker>>,
        state: &mut State<N>,
    ) -> Found<N> {
        let search = Search {
            method: Some(method),
            following,
            ..Search::new(self, near, input)
        };
        search.result(state)
    }

    /// Signs of the assemblies at the input of a configuration. The search stops after `most` assemblies or `tries`
    /// solved steps. Groups without closed form are solved only near the configuration.
    pub(super) fn found_by_signs(
        &self,
        near: &Configuration,
        [most, tries]: [usize; 2],
    ) -> Vec<AssemblySigns> {
        let search: Search<'_, 1> = Search {
            most,
            tries,
            ..Search::new(self, near, near.input)
        };
        let found = search.result(&mut self.blank_state()).ways;
        found.into_iter().map(|(_, signs)| signs).collect()
    }
}

impl From<Found<1>> for Assemblies {
    fn from(found: Found<1>) -> Self {
        Self {
            poses: found.ways.into_iter().map(|(pose, _)| pose).collect(),
            complex: found.complex,
            whole: found.whole,
        }
    }
}

struct Search<'a, const N: usize> {
    layout: &'a Layout,
    near: &'a Configuration,
    input: Jet<N>,
    /// Signs and unknowns of the steps solved so far, and approximate orientations of the bodies. Angles are unwrapped
    /// to be nearest to these orientations.
    at: Configuration,
    most: usize,
    tries: usize,
    work: usize,
    /// Method for groups; None if groups are solved near the configuration only.
    method: Option<Method>,
    following: Option<&'a mut List<StepId, Tracker>>,
    found: Found<N>,
}

impl<'a, const N: usize> Search<'a, N> {
    fn new(layout: &'a Layout, near: &'a Configuration, input: f64) -> Self {
        Self {
            layout,
            near,
            input: Jet::linear(input, 1.0),
            at: near.clone(),
            most: MAX_ASSEMBLIES,
            tries: MAX_TRIES,
            work: MAX_WORK,
            method: None,
            following: None,
            found: Found {
                whole: true,
                ..Found::default()
            },
        }
    }

    fn result(mut self, state: &mut State<N>) -> Found<N> {
        let steps: Vec<StepId> = self.layout.steps.ids().collect();
        self.join(&steps, state);
        self.found
    }

    fn join(&mut self, steps: &[StepId], state: &mut State<N>) {
        let [step, rest @ ..] = steps else {
            let pose = Pose::of(state.placed());
            self.found.ways.push((pose, self.at.signs.clone()));
            return;
        };
        if let Some(method) = self.method
            && let Step::Group(group) = &self.layout.steps[*step]
            && group.has_unknowns()
        {
            let (mut left, mut following) = (self.work, self.following.take());
            let followed = following.as_deref_mut();
            let followed = followed.map(|groups| &mut groups[*step]);
            let given = self.given(*step);
            let ways = group.assemblies(state, &given, (method, &mut left), followed);
            (self.work, self.following) = (left, following);
            let Ok(Some(ways)) = ways else {
                self.found.whole &= ways.is_err();
                if ways.is_ok() {
                    self.go_on(*step, rest, state, false);
                }
                return;
            };
            self.found.complex.push(ways.complex);
            self.found.unreal.extend(ways.complex_pairs);
            for way in &ways.real {
                group.set(&mut self.at.natural, &way.unknowns);
                for (body, turn) in &way.turns {
                    let drawn = self.near.orientations[*body];
                    self.at.orientations[*body] = drawn.turned_to(*turn);
                }
                self.go_on(*step, rest, state, ways.solved);
            }
            return;
        }
        for sign in self.layout.joinings(*step) {
            self.at.signs[*step] = *sign;
            self.go_on(*step, rest, state, false);
        }
        self.at.signs[*step] = Sign::Plus;
    }

    /// Places the bodies of a step, then the bodies of the remaining steps. `solved` is true if the unknowns of the
    /// step are already known.
    fn go_on(&mut self, step: StepId, rest: &[StepId], state: &mut State<N>, solved: bool) {
        if self.tries == 0 || self.found.ways.len() == self.most {
            self.found.whole = false;
            return;
        }
        self.tries -= 1;
        match self.put(step, state, solved) {
            Ok(()) => {
                let crosses = matches!(self.layout.steps[step], Step::Prp(_) | Step::Rpp(_));
                if N > 1 && crosses {
                    let [square, _] = state.margins[step];
                    self.found.parallel.push(ComplexPair {
                        square: square.value(),
                        slope: square.derivative(1),
                    });
                }
                self.join(rest, state);
            }
            // A group gives no complex pair here, because its margin is not a quantity under a square root.
            Err(_) if matches!(self.layout.steps[step], Step::Group(_)) => {}
            Err(Cause::Apart { .. } | Cause::OutOfReach { .. }) if N > 1 => {
                let negative = state.margins[step].into_iter();
                let negative = negative.filter(|margin| margin.value() < 0.0);
                self.found.unreal.extend(negative.map(|margin| ComplexPair {
                    square: -margin.value(),
                    slope: -margin.derivative(1),
                }));
            }
            Err(_) => {}
        }
    }

    fn put(&self, step: StepId, state: &mut State<N>, solved: bool) -> Result<(), Cause> {
        let given = self.given(step);
        match &self.layout.steps[step] {
            Step::Group(group) if solved => group.put_solved(state, &given),
            step => step.put(state, &given),
        }
    }

    fn given(&self, step: StepId) -> StepContext<'_, N> {
        StepContext {
            step,
            input: self.input,
            sign: self.at.signs[step],
            near: self.at.near(),
            mounting: &self.at.mounting,
        }
    }
}
