//! Any planar linkage: links with points, hinges, slides, gears, a driver.
//!
//! A [`Draft`] may be anything; a [`Mechanism`] is always one that can be
//! assembled, because only [`Mechanism::new`] makes it. It is solved Assur group
//! by Assur group in the order that [`crate::structure`] finds.

mod body;
mod check;
mod constraint;
mod draft;
mod natural;
mod plan;
mod quantity;

use std::f64::consts::TAU;
use std::fmt;

pub use constraint::{Constraint, Demand, LinkOrFrame, Sides};
pub use draft::{Defect, Draft, DraftDriver, DraftGear, DraftLink, DraftPoint, DraftSlide, FRAME};

pub use crate::position::Obstacle;
use crate::position::{Anchor, Followed, Near, Stand, State};
use crate::structure::{self, Driver, Fault, Structure, decompose};
use crate::{Jet, JetPoint, Point, Vector};
use body::{Bodies, Seat, driven};
use plan::Step;
pub use quantity::Quantity;

/// A linkage that can be assembled as it is drawn.
#[derive(Clone, Debug)]
pub struct Mechanism {
    draft: Draft,
    points: Vec<(String, Anchor)>,
    links: Vec<Part>,
    steps: Vec<Step>,
    structure: Structure,
    /// Of each link of the structure the bodies' names.
    body_names: Vec<String>,
    /// Of each body its points, with their places on it.
    bodies: Vec<Vec<(usize, Vector)>>,
    constraints: Vec<Constraint>,
    size: f64,
    /// The drawn pose: input, signs of the steps, how the bodies stand.
    home: f64,
    signs: Vec<f64>,
    stands: Vec<Stand>,
    natural: Vec<f64>,
    assemblies: Vec<Vec<f64>>,
    range: Option<[f64; 2]>,
}

/// A moving link, or a part fixed to one.
#[derive(Clone, Debug)]
struct Part {
    name: String,
    body: usize,
    lead: f64,
    points: Vec<usize>,
}

/// Why a mechanism has no pose at an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unsolved {
    /// The input.
    pub input: f64,
    /// The step of the plan that fails; [`Mechanism::links_of`] names its links.
    pub step: usize,
    /// What is in its way.
    pub obstacle: Obstacle,
}

impl fmt::Display for Unsolved {
    /// For the programmer's log; the words for people live in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Unsolved {}

/// Where all links are, with `N − 1` derivatives by the input. Only
/// [`crate::motion::Motion`] fills one.
#[derive(Clone, Debug)]
pub struct Pose<const N: usize> {
    state: State<N>,
    /// Room for what is guessed of it before it is solved.
    guess: Vec<f64>,
}

/// A point may be drawn this far, beside the size, from where the links put it.
const MISDRAWN: f64 = 0.3;
/// How far beside a singular drawn pose a motion is taken up, radians or lengths
/// beside the range.
const ASIDE: f64 = 1e-3;

impl Mechanism {
    /// The mechanism that a draft describes, in the drawn position.
    ///
    /// # Errors
    /// Every reason why it is none, with the names of what is at fault.
    pub fn new(draft: &Draft) -> Result<Self, Vec<Defect>> {
        let defects = check::defects(draft);
        if !defects.is_empty() {
            return Err(defects);
        }
        let (bodies, seats) = Bodies::new(draft);
        let body_names = names_of_bodies(draft, &seats, bodies.count());
        let structure = structured(draft, &bodies, &seats, &body_names)?;
        if let [_, further @ ..] = &draft.drivers[..]
            && !further.is_empty()
        {
            let links = further.iter().filter_map(|driver| driven(draft, driver));
            let links = links.map(str::to_owned).collect();
            return Err(vec![Defect::FurtherDrivers { links }]);
        }
        let plan = plan::plan(draft, &bodies, &seats, &structure);
        let plan = plan.map_err(|group| {
            let links = group.iter().map(|body| body_names[*body].clone()).collect();
            vec![Defect::Unsupported { links }]
        })?;
        let index = |name: &String| draft.points.iter().position(|point| point.name == *name);
        let nowhere = Anchor {
            body: 0,
            local: Vector::zeros(),
        };
        let mut points: Vec<(String, Anchor)> = Vec::new();
        for (k, point) in draft.points.iter().enumerate() {
            let anchor = bodies.anchor_of(k, |_| true);
            // A point that no link has stays where it is drawn.
            let anchor = anchor.unwrap_or(Anchor {
                local: point.at.coords,
                ..nowhere
            });
            points.push((point.name.clone(), anchor));
        }
        let links = draft.links.iter().zip(&seats).map(|(link, seat)| Part {
            name: link.name.clone(),
            body: seat.body,
            lead: seat.lead,
            points: link.points.iter().filter_map(index).collect(),
        });
        let mut mechanism = Self {
            draft: draft.clone(),
            points,
            links: links.collect(),
            signs: vec![1.0; plan.steps.len()],
            steps: plan.steps,
            natural: plan.natural,
            structure,
            stands: (0..bodies.count())
                .map(|body| Stand {
                    angle: bodies.drawn_angle(body),
                    turn: bodies.drawn_turn(body),
                })
                .collect(),
            size: draft.size(),
            home: plan.home,
            assemblies: Vec::new(),
            range: range_of(draft),
            body_names,
            bodies: (0..bodies.count())
                .map(|body| bodies.of(body).to_vec())
                .collect(),
            constraints: Vec::new(),
        };
        mechanism.settle()?;
        mechanism.constraints = constraint::all(draft, &bodies, &seats, &mechanism.stands);
        Ok(mechanism)
    }

    /// The drawn pose as the one nearby.
    fn drawn(&self) -> Near<'_> {
        Near {
            stands: &self.stands,
            natural: &self.natural,
        }
    }

    /// Finds the assembly that is drawn, and all others at the drawn input.
    fn settle(&mut self) -> Result<(), Vec<Defect>> {
        let mut state: State<1> = self.blank_state();
        let input = Jet::constant(self.home);
        for step in 0..self.steps.len() {
            let mut best: Option<(f64, f64)> = None;
            let mut met = None;
            for sign in [1.0, -1.0] {
                match self.steps[step].solve(&mut state, input, sign, self.drawn(), step) {
                    Ok(()) => {
                        let off = self.misdrawn(&state, step).map_or(0.0, |(_, by)| by);
                        if best.is_none_or(|(least, _)| off < least) {
                            best = Some((off, sign));
                        }
                    }
                    Err(obstacle) => met = Some(obstacle),
                }
                if !self.steps[step].has_sign() {
                    break;
                }
            }
            let Some((off, sign)) = best else {
                return Err(vec![self.open(step, met)]);
            };
            self.signs[step] = sign;
            // The try that counts, last: the state is that of the drawn pose.
            let _ = self.steps[step].solve(&mut state, input, sign, self.drawn(), step);
            if let Step::Group(group) = &mut self.steps[step] {
                group.plan_as(&state);
            }
            if off > MISDRAWN * self.size
                && let Some((point, by)) = self.misdrawn(&state, step)
            {
                return Err(vec![Defect::Misdrawn { point, by }]);
            }
        }
        for (body, stand) in self.stands.iter_mut().enumerate() {
            *stand = state.stand(body);
        }
        for (k, place) in state.natural.iter().enumerate() {
            self.natural[2 * k..][..2].copy_from_slice(place.value().as_slice());
        }
        let mut found = Vec::new();
        let mut tries = MOST_TRIES;
        let mut signs = vec![1.0; self.steps.len()];
        self.assemble(0, &mut signs, &mut state, &mut found, &mut tries);
        // The search may have ended before it came to the drawn one.
        if !found.contains(&self.signs) {
            found.push(self.signs.clone());
        }
        let mut state = self.blank_state();
        found.retain(|signs| self.entry(signs, &mut state).is_some());
        if !found.contains(&self.signs) {
            let last = self.steps.len() - 1;
            return Err(vec![self.open(last, None)]);
        }
        self.assemblies = found;
        Ok(())
    }

    /// The point of a step's links that is farthest from where it is drawn.
    fn misdrawn(&self, state: &State<1>, step: usize) -> Option<(String, f64)> {
        let mut farthest: Option<(String, f64)> = None;
        for body in self.steps[step].bodies() {
            for (point, local) in &self.bodies[body] {
                let local = *local;
                let at = state.place(Anchor { body, local }).value();
                let by = (at - self.draft.points[*point].at.coords).norm();
                if farthest.as_ref().is_none_or(|(_, most)| by > *most) {
                    farthest = Some((self.points[*point].0.clone(), by));
                }
            }
        }
        farthest
    }

    /// All ways to join the groups from `step` on.
    fn assemble(
        &self,
        step: usize,
        signs: &mut Vec<f64>,
        state: &mut State<1>,
        found: &mut Vec<Vec<f64>>,
        tries: &mut usize,
    ) {
        if step == self.steps.len() {
            found.push(signs.clone());
            return;
        }
        for sign in [1.0, -1.0] {
            signs[step] = sign;
            let input = Jet::constant(self.home);
            let solved = self.steps[step].solve(state, input, sign, self.drawn(), step);
            *tries = tries.saturating_sub(1);
            if solved.is_ok() && found.len() < MOST_ASSEMBLIES && *tries > 0 {
                self.assemble(step + 1, signs, state, found, tries);
            }
            if !self.steps[step].has_sign() {
                break;
            }
        }
        signs[step] = 1.0;
    }

    fn open(&self, step: usize, met: Option<Obstacle>) -> Defect {
        let links: Vec<String> = self.links_of(step).map(str::to_owned).collect();
        match met {
            Some(Obstacle::Parallel) => Defect::ParallelGuides { links },
            Some(Obstacle::Apart { by } | Obstacle::OutOfReach { by }) => {
                Defect::Open { links, by }
            }
            _ => Defect::Open { links, by: 0.0 },
        }
    }

    /// The linkage as it is drawn.
    pub fn draft(&self) -> &Draft {
        &self.draft
    }

    /// The same linkage drawn in this pose.
    pub fn drawn_in(&self, pose: &Pose<1>) -> Draft {
        self.drawn_by(&pose.state)
    }

    /// The same linkage drawn in this pose, with one point drawn elsewhere: the
    /// links that list it are then as drawn, the others keep their dimensions.
    pub fn redrawn(&self, pose: &Pose<1>, point: usize, to: Point) -> Draft {
        let mut draft = self.drawn_in(pose);
        if let Some(moved) = draft.points.get_mut(point) {
            moved.at = to;
            for link in &mut draft.links {
                if link.points.contains(&moved.name) {
                    link.shape = None;
                }
            }
        }
        draft
    }

    /// The same linkage drawn in one of its assemblies (0 … count − 1) at the drawn
    /// input, or just next to it where assemblies meet in one pose. None where there
    /// is no such assembly, or no drawing tells it from the others.
    pub fn assembly(&self, number: usize) -> Option<Self> {
        let signs = self.assemblies.get(number)?;
        let mut state: Followed = self.blank_state();
        self.entries().into_iter().find_map(|input| {
            let solved = self.solve(input, signs, self.drawn(), &mut state);
            let other = solved.ok().map(|()| Self::new(&self.drawn_by(&state)))?;
            other.ok().filter(|other| other.signs == *signs)
        })
    }

    fn drawn_by<const N: usize>(&self, state: &State<N>) -> Draft {
        let mut draft = self.draft.clone();
        for (drawn, (_, anchor)) in draft.points.iter_mut().zip(&self.points) {
            drawn.at = Point::from(state.place(*anchor).value());
        }
        draft
    }

    /// The moving links in the order of the draft, by name.
    pub fn links(&self) -> impl ExactSizeIterator<Item = &str> {
        self.links.iter().map(|link| link.name.as_str())
    }

    /// The points in the order of the draft, by name.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &str> {
        self.points.iter().map(|(name, _)| name.as_str())
    }

    /// The points of a link, by index.
    pub fn points_of(&self, link: usize) -> &[usize] {
        &self.links[link].points
    }

    /// Driver and Assur groups; its links are bodies, which
    /// [`Mechanism::body_name`] names: 0 the frame, fixed links one with theirs.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// The name of a link of the structure.
    pub fn body_name(&self, body: usize) -> &str {
        self.body_names.get(body).map_or(FRAME, String::as_str)
    }

    /// The links that a step of the plan places, by name.
    pub fn links_of(&self, step: usize) -> impl Iterator<Item = &str> {
        let bodies = self.steps.get(step).map(|step| step.bodies());
        bodies
            .into_iter()
            .flatten()
            .map(|body| self.body_name(body))
    }

    /// The diagonal of the drawing.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The drawn input.
    pub fn home(&self) -> f64 {
        self.home
    }

    /// True where the driver is a crank; else it is a slide.
    pub fn turns(&self) -> bool {
        self.range.is_none()
    }

    /// How many assemblies there are at the drawn input.
    pub fn assemblies(&self) -> usize {
        self.assemblies.len()
    }

    /// Which of them is drawn, from 0.
    pub fn drawn_assembly(&self) -> usize {
        let drawn = self
            .assemblies
            .iter()
            .position(|signs| *signs == self.signs);
        drawn.unwrap_or(0)
    }

    /// A pose to be filled again and again.
    pub fn blank<const N: usize>(&self) -> Pose<N> {
        Pose {
            state: self.blank_state(),
            guess: Vec::new(),
        }
    }

    /// The angle of a link, from its first to its second point, in a pose.
    pub fn angle<const N: usize>(&self, pose: &Pose<N>, link: usize) -> Jet<N> {
        let part = &self.links[link];
        pose.state.angle(part.body) + part.lead
    }

    /// Where a point is in a pose.
    pub fn place<const N: usize>(&self, pose: &Pose<N>, point: usize) -> JetPoint<N> {
        pose.state.place(self.points[point].1).into()
    }

    /// Where a link carries one of its points in a pose: the same as
    /// [`Self::place`], whichever of the links that are hinged there is asked. None
    /// where the point is not the link's.
    pub fn carried<const N: usize>(
        &self,
        pose: &Pose<N>,
        link: usize,
        point: usize,
    ) -> Option<JetPoint<N>> {
        let body = self.links[link].body;
        let (_, local) = self.bodies[body]
            .iter()
            .find(|(index, _)| *index == point)?;
        let anchor = Anchor {
            body,
            local: *local,
        };
        Some(pose.state.place(anchor).into())
    }

    pub(crate) fn blank_state<const N: usize>(&self) -> State<N> {
        let steps = self.steps.len();
        State::new(self.stands.len(), steps, self.natural.len() / 2, self.size)
    }

    /// Solves every step for an input; the numbers of the step that fails.
    pub(crate) fn solve<const N: usize>(
        &self,
        input: f64,
        signs: &[f64],
        near: Near<'_>,
        state: &mut State<N>,
    ) -> Result<(), (usize, Obstacle)> {
        if !input.is_finite() {
            return Err((0, Obstacle::Input));
        }
        let input = Jet::linear(input, 1.0);
        state.doubt = 0.0;
        for (k, step) in self.steps.iter().enumerate() {
            let solved = step.solve(state, input, signs[k], near, k);
            solved.map_err(|obstacle| (k, obstacle))?;
        }
        Ok(())
    }

    /// Input, signs and pose from which the motion is followed: the drawn ones, or
    /// those just next to them where the drawn pose is singular.
    pub(crate) fn start(&self) -> (f64, &[f64], Followed) {
        let mut state = self.blank_state();
        let input = self.entry(&self.signs, &mut state).unwrap_or(self.home);
        (input, &self.signs, state)
    }

    /// The input at, or beside, the drawn one where the pose has derivatives.
    fn entry(&self, signs: &[f64], state: &mut Followed) -> Option<f64> {
        let mut inputs = self.entries().into_iter();
        inputs.find(|input| self.solve(*input, signs, self.drawn(), state).is_ok())
    }

    /// The drawn input and those next to it.
    fn entries(&self) -> [f64; 3] {
        [0.0, ASIDE, -ASIDE].map(|aside| self.home + aside * self.span() / TAU)
    }

    /// One turn, or the range of the driven slide.
    pub(crate) fn span(&self) -> f64 {
        self.range.map_or(TAU, |[from, to]| to - from)
    }

    /// Whether every link that matters stands in two poses alike. A wheel that
    /// moves nothing else may stand anywhere.
    pub(crate) fn stands_alike(&self, a: &Followed, b: &Followed, within: f64) -> bool {
        let driving = |body: usize| self.steps.iter().any(|step| step.leans_on(body));
        (0..self.stands.len()).all(|body| {
            let idle = self.steps.iter().any(|step| step.is_wheel(body)) && !driving(body);
            let turned = [a, b].map(|state| state.turn[body].value());
            let moved = [a, b].map(|state| state.origin[body].value());
            idle || (turned[0] - turned[1]).norm() <= within
                && (moved[0] - moved[1]).norm() <= within * self.size
        })
    }

    /// Whether a body's angle was found by its turn, to a whole turn.
    pub(crate) fn is_wound(&self, body: usize) -> bool {
        self.steps
            .iter()
            .any(|step| step.winds() && step.bodies().any(|b| b == body))
    }

    pub(crate) fn steps(&self) -> usize {
        self.steps.len()
    }

    pub(crate) fn margin_scale(&self, step: usize) -> f64 {
        self.steps[step].scale()
    }

    pub(crate) fn passes(&self, step: usize) -> bool {
        self.steps[step].passes()
    }

    pub(crate) fn is_group(&self, step: usize) -> bool {
        matches!(self.steps[step], Step::Group(_))
    }

    pub(crate) fn has_two_margins(&self, step: usize) -> bool {
        matches!(self.steps[step], Step::Rrr(_) | Step::Closed(_))
    }
}

impl<const N: usize> Pose<N> {
    pub(crate) fn parts(&mut self) -> (&mut State<N>, &mut Vec<f64>) {
        (&mut self.state, &mut self.guess)
    }
}

/// No more assemblies are counted, and no more steps solved to find them: n groups
/// can be put together in 2ⁿ ways, few of which may close.
const MOST_ASSEMBLIES: usize = 256;
const MOST_TRIES: usize = 1 << 14;

/// Of every body the link that it was made for; the frame first.
fn names_of_bodies(draft: &Draft, seats: &[Seat], count: usize) -> Vec<String> {
    let mut names = vec![FRAME.to_owned(); count];
    for (link, seat) in draft.links.iter().zip(seats) {
        if link.fixed_to.is_none() {
            names[seat.body].clone_from(&link.name);
        }
    }
    names
}

/// The range of the driver, if it is a slide.
fn range_of(draft: &Draft) -> Option<[f64; 2]> {
    draft.drivers.iter().find_map(|driver| match driver {
        DraftDriver::Slide { range, .. } => Some(*range),
        DraftDriver::Crank { .. } => None,
    })
}

/// The structure of the bodies.
fn structured(
    draft: &Draft,
    bodies: &Bodies,
    seats: &[Seat],
    names: &[String],
) -> Result<Structure, Vec<Defect>> {
    let graph = bodies.graph(draft.points.len());
    let drivers: Vec<Driver> = draft
        .drivers
        .iter()
        .filter_map(|driver| bodies.driver(draft, seats, driver, &graph))
        .collect();
    if drivers.len() < draft.drivers.len() {
        return Err(vec![Defect::NoDriver]);
    }
    let mobility = graph.mobility();
    let named = |links: &[usize]| links.iter().map(|link| names[*link].clone()).collect();
    decompose(&graph, &drivers).map_err(|faults| {
        let defect = |fault: structure::Fault| match fault {
            Fault::Apart { links } => Defect::Loose(named(&links)),
            Fault::Undriven { links, .. } => Defect::Underdriven {
                mobility,
                links: named(&links),
            },
            Fault::Overconstrained { links, .. } => Defect::Locked {
                mobility,
                links: named(&links),
            },
            Fault::Sliding { links } => Defect::Locked {
                mobility,
                links: named(&links),
            },
            Fault::SelfJoined { link, .. } => Defect::WithItself(names[link].clone()),
            _ => Defect::NoDriver,
        };
        faults.into_iter().map(defect).collect()
    })
}
