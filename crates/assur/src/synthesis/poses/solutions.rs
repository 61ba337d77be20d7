//! Dyads and linkages for a task, wanted points, and the ranking of the linkages.

use super::curve::{Curve, Kind};
use super::dyad::Dyad;
use super::five::Burmester;
use super::linkage::Linkage;
use super::locus::Locus;
use super::special::Special;
use super::task::{Place, Task};
use crate::sorting::sort_by_key;
use crate::synthesis::four_bar::{Assessed, Criterion, Key, Requirement, Requirements};
use crate::{Point, Vector, tolerance};

use super::verdict::Mechanism;

/// Number of dyads taken from the curves of four poses if no points are wanted.
const SAMPLES: usize = 16;
/// Reach of the search for dyads of four poses, in diagonals of the box around the poses.
const REACH: f64 = 2.0;

/// Wanted points and regions of the hinges. An empty list and an absent region require nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted {
    /// Hinges on the frame. For up to three poses each gives a dyad. For four poses the nearest point of the
    /// centre-point curve gives it. For five poses only dyads with one of these hinges are listed.
    pub pivots: Vec<Point>,
    /// Hinges on the body, by their places in the first pose, used in the same way.
    pub points: Vec<Point>,
    /// Opposite corners of a rectangle with all hinges on the frame.
    pub pivot_region: Option<[Point; 2]>,
    /// Opposite corners of a rectangle with all hinges on the body, in the first pose.
    pub point_region: Option<[Point; 2]>,
}

/// The dyads that guide the body through the poses of a task, and the linkages of all pairs of dyads.
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions {
    /// Special case of the poses; None if they are in general position.
    pub special: Option<Special>,
    /// Number of coordinates of a dyad that the poses leave free: 3 for two poses, 0 for five.
    pub freedoms: usize,
    /// The dyads.
    pub dyads: Vec<Dyad>,
    /// Number of pairs of five poses that are not real.
    pub complex: usize,
    /// Linkages of two dyads, in the order of the dyads until they are ranked.
    pub linkages: Vec<Linkage>,
    /// True if no dyad is missing: all pairs of five poses are found, or there is a dyad for each wanted point.
    pub complete: bool,
}

impl Solutions {
    /// Finds the dyads and linkages of a task.
    pub fn new(task: &Task, wanted: &Wanted) -> Self {
        let special = task.special();
        let conditions = task.distinct().len() - 1;
        let mut found = Self {
            special,
            freedoms: 4 - conditions,
            dyads: Vec::new(),
            complex: 0,
            linkages: Vec::new(),
            complete: false,
        };
        let isolated = special.is_none() && conditions >= 3;
        match (isolated, conditions) {
            (true, 3) => found.four(task, wanted),
            (true, _) => found.five(task, wanted),
            _ => found.few(task, wanted),
        }
        found.dyads.retain(|dyad| wanted.holds(dyad));
        for (k, first) in found.dyads.iter().enumerate() {
            for second in &found.dyads[k + 1..] {
                found.linkages.push(Linkage::new(task, [*first, *second]));
            }
        }
        found
    }

    fn add(&mut self, task: &Task, dyad: Option<Dyad>) -> bool {
        let size = tolerance::COINCIDENT * task.unit();
        let Some(dyad) = dyad else {
            return false;
        };
        // A link needs a length.
        if let Dyad::Hinges { pivot, point } = dyad
            && (point - pivot).norm() <= size
        {
            return false;
        }
        if !self.dyads.iter().any(|other| other.is_same(&dyad, size)) {
            self.dyads.push(dyad);
        }
        true
    }

    /// Adds a dyad for each wanted point, for up to three poses or special ones.
    fn few(&mut self, task: &Task, wanted: &Wanted) {
        let near = task.poses()[0].place();
        let mut all = !wanted.pivots.is_empty() || !wanted.points.is_empty();
        for pivot in &wanted.pivots {
            let centre = Place::Finite(*pivot);
            let point = one_of(task.circle_points(centre), near);
            all &= self.add(task, point.and_then(|point| Dyad::of(point, centre)));
        }
        for point in &wanted.points {
            let at = Place::Finite(*point);
            let centre = one_of(task.centre_points(at), near);
            all &= self.add(task, centre.and_then(|centre| Dyad::of(at, centre)));
        }
        self.complete = all || self.special == Some(Special::Parallel);
    }

    /// Adds dyads for four poses: both slides, and the points of the curves nearest to the wanted points.
    fn four(&mut self, task: &Task, wanted: &Wanted) {
        for kind in [Kind::Centre, Kind::Circle] {
            if let Some([at, partner]) = Curve::infinite(task, kind) {
                let [point, centre] = match kind {
                    Kind::Centre => [partner, at],
                    Kind::Circle => [at, partner],
                };
                let dyad = Dyad::of_triples(task, point, centre);
                self.add(task, dyad);
            }
        }
        let given = [
            (Kind::Centre, &wanted.pivots),
            (Kind::Circle, &wanted.points),
        ];
        let any = given.iter().any(|(_, points)| !points.is_empty());
        let mut all = any;
        for (kind, points) in given {
            if points.is_empty() {
                continue;
            }
            let curve = Curve::new(task, kind, around(task, points));
            for point in points {
                let nearest = curve.as_ref().and_then(|curve| curve.nearest(*point));
                all &= self.add(task, nearest.and_then(|one| one.dyad(kind)));
            }
        }
        if !any {
            let corners = wanted.pivot_region.unwrap_or_else(|| around(task, &[]));
            let curve = Curve::new(task, Kind::Centre, corners);
            for point in curve.iter().flat_map(|curve| curve.spread(SAMPLES)) {
                self.add(task, point.dyad(Kind::Centre));
            }
        }
        self.complete = all;
    }

    fn five(&mut self, task: &Task, wanted: &Wanted) {
        let Some(found) = Burmester::new(task) else {
            return;
        };
        let size = tolerance::NEAR * task.unit();
        let near = |place: Place, points: &[Point]| match place {
            Place::Finite(at) => points.iter().any(|point| (point - at).norm() <= size),
            Place::Infinite(_) => false,
        };
        for dyad in found.dyads {
            let met = (wanted.pivots.is_empty() || near(dyad.centre(), &wanted.pivots))
                && (wanted.points.is_empty() || near(dyad.point(), &wanted.points));
            if met {
                self.add(task, Some(dyad));
            }
        }
        self.complex = found.complex;
        self.complete = found.complete;
    }

    /// Sorts the linkages, the best first: by the number of failed requirements, then by the criterion; stable. Both
    /// criteria of transmission use the transmission angle between the poses.
    pub fn rank(&mut self, task: &Task, requirements: &Requirements, criterion: Criterion) {
        sort_by_key(&mut self.linkages, |linkage| Key {
            unmet: linkage.unmet(requirements).len(),
            cost: linkage.cost(task, criterion),
        });
    }
}

impl Linkage {
    /// Requirements that the linkage fails; empty if it is acceptable. Only a four-bar can have a required Grashof
    /// type.
    pub fn unmet(&self, requirements: &Requirements) -> Vec<Requirement> {
        let Ok(verdict) = &self.verdict else {
            return vec![Requirement::Linkage];
        };
        let grashof = match verdict.mechanism {
            Mechanism::FourBar(grashof) => Some(grashof),
            _ => None,
        };
        requirements.unmet_by(&Assessed {
            passage: verdict.passage,
            order: verdict.order,
            turns: verdict.turns,
            grashof,
            transmission: verdict.transmission,
            size_ratio: verdict.size_ratio,
        })
    }

    fn cost(&self, task: &Task, criterion: Criterion) -> f64 {
        let Ok(verdict) = &self.verdict else {
            return f64::INFINITY;
        };
        match criterion {
            Criterion::Closure => {
                let off = self.dyads.iter().map(|dyad| dyad.residual(task));
                off.fold(0.0, f64::max)
            }
            Criterion::Transmission | Criterion::TransmissionOverall => {
                -verdict.transmission.unwrap_or(0.0)
            }
            Criterion::SizeRatio => verdict.size_ratio,
        }
    }
}

impl Wanted {
    /// True if the hinges of a dyad are within the regions. Where a dyad slides, it has no hinge, and no region
    /// applies.
    fn holds(&self, dyad: &Dyad) -> bool {
        let within = |place: Place, region: Option<[Point; 2]>| match (place, region) {
            (Place::Finite(point), Some([a, b])) => (0..2).all(|k| {
                let [low, high] = [a[k].min(b[k]), a[k].max(b[k])];
                (low..=high).contains(&point[k])
            }),
            _ => true,
        };
        within(dyad.centre(), self.pivot_region) && within(dyad.point(), self.point_region)
    }
}

/// A point of a locus; if there are several, the one nearest to a given point.
fn one_of(locus: Locus, near: Point) -> Option<Place> {
    match locus {
        Locus::Any => Some(Place::Finite(near)),
        Locus::Line { through, along } => Some(Place::Finite(
            through + along * along.dot(&(near - through)),
        )),
        Locus::One(place) => Some(place),
        Locus::None => None,
    }
}

/// Corners of a rectangle around all poses and given points, with space on every side.
fn around(task: &Task, points: &[Point]) -> [Point; 2] {
    let poses = task.poses().iter().map(|pose| pose.place());
    let all = poses.chain(points.iter().copied());
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for point in all {
        low = low.inf(&point.coords);
        high = high.sup(&point.coords);
    }
    let space = Vector::repeat(REACH * (high - low).norm().max(task.unit()));
    [Point::from(low - space), Point::from(high + space)]
}
