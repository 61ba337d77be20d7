//! Hinges of the shown pair of dyads, and the curves on which those of four poses lie.

use assur::Point;
use assur::synthesis::poses::{Curve, Dyad, Kind, Place};
use assur_draw::Role;
use assur_file::{Guidance, HingeDocument, PosesDocument};

/// Colours of the two dyads.
pub(super) const ROLES: [Role; 2] = [Role::Crank, Role::Rocker];

/// Distance from a curve within which a press chooses its point, in symbol units.
pub(super) const PRESSED: f64 = 3.0;

/// Number of distinct poses that leave curves for the hinges.
const ON_CURVES: usize = 4;

/// Reach of the curves beyond the poses, as a part of their diagonal.
const REACH: f64 = 1.5;

/// Hinges of the two shown dyads.
pub(super) struct Hinges {
    /// The shown dyads, with the wanted hinge of each; empty if the poses leave no choice, or there are no dyads.
    pairs: Vec<(Dyad, HingeDocument)>,
    /// The hinges in the last pose, on the body.
    carried: Vec<Option<Point>>,
    /// Centre-point curve and circle-point curve of four poses.
    pub(super) curves: Option<[Curve; 2]>,
}

impl Hinges {
    pub(super) fn new(document: &PosesDocument, found: &Guidance) -> Self {
        let poses = found.task.distinct().len();
        let dyads = found.shown().filter(|_| poses <= ON_CURVES);
        let dyads = dyads.map_or(&[][..], |pair| &pair.dyads);
        let wanted = dyads.iter().filter_map(|dyad| {
            let mut given = document.hinges.iter();
            let given = given.find(|hinge| found.is_at(dyad, hinge)).copied();
            let hinge = given.or_else(|| match (dyad.centre(), dyad.point()) {
                (Place::Finite(at), _) => Some(HingeDocument::Frame(at.into())),
                (_, Place::Finite(at)) => Some(HingeDocument::Body(found.own(at).into())),
                _ => None,
            });
            Some((*dyad, hinge?))
        });
        let last = found.task.poses().len() - 1;
        let carried = dyads.iter().map(|dyad| match dyad.point() {
            Place::Finite(at) => Some(found.task.carried(at, last)),
            Place::Infinite(_) => None,
        });
        let curves = (poses == ON_CURVES).then(|| {
            let corners = corners(found, dyads);
            let curve = |kind| Curve::new(&found.task, kind, corners);
            Some([curve(Kind::Centre)?, curve(Kind::Circle)?])
        });
        Self {
            pairs: wanted.collect(),
            carried: carried.collect(),
            curves: curves.flatten(),
        }
    }

    /// Hinges that may be dragged: for each, whether it is on the frame, the number of its dyad, and its place. The
    /// places of hinges on the body are in the last pose.
    pub(super) fn places(&self) -> impl Iterator<Item = (bool, usize, Point)> + '_ {
        let frame = self.pairs.iter().enumerate();
        let frame = frame.filter_map(|(k, (dyad, _))| match dyad.centre() {
            Place::Finite(at) => Some((true, k, at)),
            Place::Infinite(_) => None,
        });
        let body = self.carried.iter().zip(&self.pairs).enumerate();
        let body = body.filter_map(|(k, (at, _))| Some((false, k, (*at)?)));
        frame.chain(body)
    }

    /// The hinges by which the shown dyads are chosen, one for each dyad.
    pub(super) fn wanted(&self) -> Vec<HingeDocument> {
        self.pairs.iter().map(|(_, hinge)| *hinge).collect()
    }

    /// The wanted hinges after one of them is dragged to a place or, for four poses, to the nearest point of its curve.
    pub(super) fn moved(
        &self,
        found: &Guidance,
        is_on_frame: bool,
        dyad: usize,
        to: Point,
    ) -> Vec<HingeDocument> {
        let mut hinges = self.wanted();
        let to = if is_on_frame { to } else { found.first(to) };
        let curve = self
            .curves
            .as_ref()
            .map(|both| &both[usize::from(!is_on_frame)]);
        let at = curve.map_or(Some(to), |curve| Some(curve.nearest(to)?.at));
        if let (Some(at), Some(hinge)) = (at, hinges.get_mut(dyad)) {
            *hinge = hinge_at(found, is_on_frame, at);
        }
        hinges
    }

    /// The wanted hinges after a press on a curve, whose point takes the place of the nearer hinge; none if no curve is
    /// near.
    pub(super) fn pressed(
        &self,
        found: &Guidance,
        at: Point,
        within: f64,
    ) -> Option<Vec<HingeDocument>> {
        let curves = self.curves.as_ref()?.iter().zip([true, false]);
        let near = curves.filter_map(|(curve, is_centre)| Some((curve.nearest(at)?.at, is_centre)));
        let off = |place: Point| (place - at).norm();
        let nearest = near.min_by(|a, b| off(a.0).total_cmp(&off(b.0)))?;
        let (place, is_centre) = Some(nearest).filter(|(place, _)| off(*place) <= within)?;
        let mut hinges = self.wanted();
        let of = |(dyad, _): &(Dyad, HingeDocument)| {
            let here = if is_centre {
                dyad.centre()
            } else {
                dyad.point()
            };
            match here {
                Place::Finite(here) => (here - place).norm(),
                Place::Infinite(_) => f64::INFINITY,
            }
        };
        let distances: Vec<f64> = self.pairs.iter().map(of).collect();
        let nearer = (0..distances.len()).min_by(|a, b| distances[*a].total_cmp(&distances[*b]));
        let chosen = hinge_at(found, is_centre, place);
        match nearer {
            Some(k) => hinges[k] = chosen,
            None => hinges.push(chosen),
        }
        Some(hinges)
    }
}

fn hinge_at(found: &Guidance, is_on_frame: bool, at: Point) -> HingeDocument {
    if is_on_frame {
        HingeDocument::Frame(at.into())
    } else {
        HingeDocument::Body(found.own(at).into())
    }
}

/// Corners of the rectangle in which the curves are drawn, around the poses and the shown hinges.
fn corners(found: &Guidance, dyads: &[Dyad]) -> [Point; 2] {
    let poses = found
        .task
        .poses()
        .iter()
        .map(assur::synthesis::poses::Pose::place);
    let places = dyads.iter().flat_map(|dyad| [dyad.centre(), dyad.point()]);
    let hinges = places.filter_map(|place| match place {
        Place::Finite(at) => Some(at),
        Place::Infinite(_) => None,
    });
    let around = |points: &mut dyn Iterator<Item = Point>| {
        let mut corners = [
            Point::from([f64::INFINITY; 2]),
            Point::from([f64::NEG_INFINITY; 2]),
        ];
        for at in points {
            corners[0] = corners[0].inf(&at);
            corners[1] = corners[1].sup(&at);
        }
        corners
    };
    let of_poses = around(&mut poses.clone());
    let room = REACH * (of_poses[1] - of_poses[0]).norm();
    // Hinges far away do not make the curves coarse.
    let middle = Point::from(0.5 * (of_poses[0].coords + of_poses[1].coords));
    let near = hinges.filter(|at| (at - middle).norm() <= 2.0 * room);
    let [low, high] = around(&mut poses.chain(near));
    let room = assur::Vector::repeat(room);
    [low - room, high + room]
}
