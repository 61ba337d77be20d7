//! Instant centres by Kennedy's theorem: pairs give the first centres, and lines through known centres the others.

use super::projective::{Place, at, towards};
use super::{InstantCentre, Source};
use crate::index::{BodyId, PointId};
use crate::mechanism::{Joint, Mechanism, Pose};
use crate::perpendicular;
use crate::tolerance;

/// A known centre or line: a unit vector of homogeneous coordinates, with a bound on its error.
#[derive(Clone, Copy)]
struct Known {
    place: Place,
    off: f64,
}

impl Known {
    /// The line through two points, or the intersection of two lines; none if they coincide within their errors.
    fn joined(self, other: Self) -> Option<Self> {
        let product = self.place.cross(&other.place);
        let sine = product.norm();
        let off = (self.off + other.off + tolerance::EXACT) / sine;
        // If the error is larger, the two points or lines nearly coincide, and their line or intersection is not used.
        (off < tolerance::DOUBLE_ROOT).then(|| Self {
            place: product / sine,
            off,
        })
    }
}

struct Table<'a> {
    mechanism: &'a Mechanism,
    known: Vec<Option<Known>>,
    found: Vec<InstantCentre>,
}

/// Finds the centres of a pose, and lists them in the order in which they are found.
pub(super) fn centres<const N: usize>(mechanism: &Mechanism, pose: &Pose<N>) -> Vec<InstantCentre> {
    let bodies = mechanism.bodies().len();
    let mut table = Table {
        mechanism,
        known: vec![None; bodies * bodies],
        found: Vec::new(),
    };
    for joint in mechanism.joints() {
        table.join(pose, &joint);
    }
    loop {
        let mut best: Option<([BodyId; 2], [BodyId; 2], Known)> = None;
        let before = table.found.len();
        for first in mechanism.bodies() {
            for second in mechanism.bodies().skip(first.index() + 1) {
                let bodies = [first, second];
                if table.of(bodies).is_some() {
                    continue;
                }
                match table.crossing(bodies) {
                    Some((by, place)) if place.off <= tolerance::NEGLIGIBLE => {
                        table.add(bodies, place, Source::Kennedy(by));
                    }
                    Some((by, place)) if best.is_none_or(|(.., best)| place.off < best.off) => {
                        best = Some((bodies, by, place));
                    }
                    _ => {}
                }
            }
        }
        if table.found.len() > before {
            continue;
        }
        match best {
            Some((bodies, by, place)) => table.add(bodies, place, Source::Kennedy(by)),
            None => return table.found,
        }
    }
}

impl Table<'_> {
    fn place(&self, [first, second]: [BodyId; 2]) -> usize {
        first.index() * self.mechanism.bodies().len() + second.index()
    }

    fn of(&self, bodies: [BodyId; 2]) -> Option<Known> {
        self.known[self.place(bodies)]
    }

    fn add(&mut self, [first, second]: [BodyId; 2], known: Known, source: Source) {
        for bodies in [[first, second], [second, first]] {
            let place = self.place(bodies);
            self.known[place] = Some(known);
        }
        self.found.push(InstantCentre {
            bodies: [first.min(second), first.max(second)],
            centre: self.mechanism.centre_at(known.place),
            source,
        });
    }

    /// Adds the instant centres that a pair gives.
    fn join<const N: usize>(&mut self, pose: &Pose<N>, joint: &Joint) {
        let mechanism = self.mechanism;
        let hinge = |point: PointId| {
            let place = mechanism.place(pose, point).place();
            at(mechanism.scaled(place))
        };
        let mut tell = |bodies: [BodyId; 2], place: Place| {
            let place = place.normalize();
            // If two bodies share two joints, the first joint gives the centre.
            if place.norm_squared().is_finite() && self.of(bodies).is_none() {
                self.add(
                    bodies,
                    Known {
                        place,
                        off: tolerance::EXACT,
                    },
                    Source::Joint,
                );
            }
        };
        match joint {
            Joint::Hinge { point, bodies } => {
                for (k, first) in bodies.iter().enumerate() {
                    for second in &bodies[k + 1..] {
                        tell([*first, *second], hinge(*point));
                    }
                }
            }
            Joint::Slide { bodies, line, .. } => {
                if let Some(along) = mechanism.heading(pose, bodies[0], *line) {
                    let across = perpendicular(along);
                    tell(*bodies, towards(across));
                }
            }
            Joint::Mesh {
                bodies,
                carrier,
                teeth,
            } => {
                let axes = bodies.map(|wheel| mechanism.shared_by([wheel, *carrier]));
                if let [Some(first), Some(second)] = axes {
                    // Relative to the carrier, wheels with z₁ and z₂ teeth turn at speeds in the ratio z₂ : −z₁.
                    let pitch = hinge(first) * teeth[1] + hinge(second) * teeth[0];
                    tell(*bodies, pitch);
                }
            }
        }
    }

    /// Finds the centre of two bodies as the intersection of two of Kennedy's lines. Also returns the third body on
    /// each of these lines. Of the intersections, the first accurate one is taken; if none is accurate, the one with
    /// the smallest error.
    fn crossing(&self, [first, second]: [BodyId; 2]) -> Option<([BodyId; 2], Known)> {
        let lines = self.mechanism.bodies().filter_map(|by| {
            let line = self.of([first, by])?.joined(self.of([by, second])?)?;
            Some((by, line))
        });
        let lines: Vec<(BodyId, Known)> = lines.collect();
        let mut best: Option<([BodyId; 2], Known)> = None;
        for (k, (by, line)) in lines.iter().enumerate() {
            for (also, other) in &lines[k + 1..] {
                let Some(place) = line.joined(*other) else {
                    continue;
                };
                if best.is_none_or(|(_, best)| place.off < best.off) {
                    best = Some(([*by, *also], place));
                }
                if place.off <= tolerance::NEGLIGIBLE {
                    return best;
                }
            }
        }
        best
    }
}
