//! The drawing of poses: the body in each, and where the hinges of its dyads lie.

use assur::synthesis::poses::{Locus, Place};
use assur::{Point, Vector};
use assur_draw::{DrawnPose, Guidance as Drawing, GuidanceSheet, Role};
use assur_file::Guidance;

use super::hinges::{Hinges, ROLES};

/// Length of the body's x-axis up to its handle, as a multiple of the body's size.
const ARM: f64 = 1.5;

/// Role of a pose that the shown linkage meets, and of one that it does not meet.
const MET: Role = Role::Accent2;
const MISSED: Role = Role::Locked;

/// Reach of a perpendicular bisector, as a multiple of the distance of its two points.
const REACH: f64 = 1.2;

/// Digits as subscripts.
const DIGITS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

/// The poses as they are drawn.
pub(super) struct Scene {
    pub(super) guidance: Drawing,
    /// Greatest distance of a corner of the body from its origin.
    pub(super) size: f64,
}

impl Scene {
    pub(super) fn new(found: &Guidance, hinges: &Hinges) -> Self {
        let size = found.body.iter().map(|corner| corner.coords.norm());
        let size = size.fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        let poses = found.task.poses().iter().enumerate();
        let poses = poses.map(|(k, pose)| {
            let placed = |at: Point| found.placed(at, k);
            DrawnPose {
                number: (k + 1).to_string(),
                outline: found.body.iter().copied().map(placed).collect(),
                origin: pose.place(),
                tip: placed(Point::new(ARM * size, 0.0)),
                role: MET,
            }
        });
        let mut guidance = Drawing {
            poses: poses.collect(),
            ..Drawing::default()
        };
        match found.task.distinct().len() {
            2 => bisectors(found, &mut guidance),
            3 => poles(found, &mut guidance),
            4 => {
                for (curve, role) in hinges.curves.iter().flatten().zip([Role::Secondary, MET]) {
                    let lines = curve.lines().iter();
                    let lines = lines.map(|line| line.iter().map(|one| one.at).collect());
                    let lines = lines.map(|line| (line, role, false));
                    guidance.curves.extend(lines);
                }
            }
            _ => points(found, &mut guidance),
        }
        for (is_on_frame, k, at) in hinges.places() {
            let name = if is_on_frame { "" } else { ["B", "C"][k] };
            guidance.points.push((name.to_owned(), at, ROLES[k], true));
        }
        Self { guidance, size }
    }

    /// Marks the poses that the shown linkage does not meet.
    pub(super) fn judge(&mut self, met: &[Option<f64>]) {
        for (pose, input) in self.guidance.poses.iter_mut().zip(met) {
            if input.is_none() {
                pose.role = MISSED;
                pose.number.push_str(" ✗");
            }
        }
    }

    /// The symbol unit of the drawing of the poses alone.
    pub(super) fn unit(&self, sheet: &GuidanceSheet) -> f64 {
        let [left, bottom, right, top] = sheet.bounds();
        (right - left).hypot(top - bottom) / 100.0
    }
}

/// A symbol with numbers as subscripts.
fn symbol(letter: char, numbers: &[usize]) -> String {
    let digits = numbers.iter().filter_map(|number| DIGITS.get(*number));
    [letter].into_iter().chain(digits.copied()).collect()
}

/// The pole of two poses, and the perpendicular bisectors on which the centre points of the shown hinges lie.
fn bisectors(found: &Guidance, to: &mut Drawing) {
    let [first, second] = found.task.distinct() else {
        return;
    };
    let dyads = found.shown().map_or(&[][..], |pair| &pair.dyads);
    for (dyad, role) in dyads.iter().zip(ROLES) {
        let Place::Finite(point) = dyad.point() else {
            continue;
        };
        let ends = [first, second].map(|k| found.task.carried(point, *k));
        to.curves.push((ends.to_vec(), role, true));
        if let Locus::Line { through, along } = found.task.centre_points(dyad.point()) {
            let middle: Point = Point::from(0.5 * (ends[0].coords + ends[1].coords));
            let foot = through + along * along.dot(&(middle - through));
            let reach = match dyad.centre() {
                Place::Finite(at) => (at - foot).norm(),
                Place::Infinite(_) => 0.0,
            };
            let reach: Vector = along * (REACH * (ends[1] - ends[0]).norm().max(reach));
            to.curves
                .push((vec![foot - reach, foot + reach], role, true));
        }
    }
    if let Some(Place::Finite(pole)) = found.task.pole(*first, *second) {
        let name = symbol('P', &[first + 1, second + 1]);
        to.points.push((name, pole, Role::Secondary, false));
    }
}

/// The pole triangle of three poses.
fn poles(found: &Guidance, to: &mut Drawing) {
    let [a, b, c] = found.task.distinct() else {
        return;
    };
    let poles = [[a, b], [b, c], [a, c]].map(|[j, k]| match found.task.pole(*j, *k) {
        Some(Place::Finite(at)) => Some((symbol('P', &[j + 1, k + 1]), at)),
        _ => None,
    });
    let corners: Vec<Point> = poles.iter().flatten().map(|(_, at)| *at).collect();
    if let [a, b, c] = corners[..] {
        to.curves.push((vec![a, b, c, a], Role::Secondary, true));
    }
    let poles = poles.into_iter().flatten();
    to.points
        .extend(poles.map(|(name, at)| (name, at, Role::Secondary, false)));
}

/// The centre points of five poses, and the circle points in the first pose.
fn points(found: &Guidance, to: &mut Drawing) {
    for (k, dyad) in found.solutions.dyads.iter().enumerate() {
        let shown = found
            .shown()
            .and_then(|pair| pair.dyads.iter().position(|one| one == dyad));
        let role = shown.map_or(Role::Secondary, |k| ROLES[k]);
        let places =
            [('C', dyad.centre()), ('W', dyad.point())].map(|(letter, place)| match place {
                Place::Finite(at) => Some((symbol(letter, &[k + 1]), at)),
                Place::Infinite(_) => None,
            });
        if let [Some((_, centre)), Some((_, point))] = &places
            && shown.is_some()
        {
            to.curves.push((vec![*centre, *point], role, true));
        }
        let places = places.into_iter().flatten();
        to.points
            .extend(places.map(|(name, at)| (name, at, role, shown.is_some())));
    }
}
