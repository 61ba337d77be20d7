//! Measurements on a drawing: distance between two points, angle at one of three points, angle between two links.

use crate::Jet;
use crate::index::{LinkId, PointId};
use crate::mechanism::{Mechanism, Pose};
use crate::tolerance;

impl Mechanism {
    /// Distance between two points. If the points coincide, the derivatives are those just after the pose; they are
    /// zero if the points stay together.
    pub(in crate::mechanism) fn between_points<const N: usize>(
        &self,
        pose: &Pose<N>,
        [from, to]: [PointId; 2],
    ) -> Jet<N> {
        let [p, q] = [from, to].map(|point| self.place(pose, point));
        let ways = [q.x - p.x, q.y - p.y];
        if span(ways) > tolerance::NEGLIGIBLE * self.size() {
            return norm(ways);
        }
        // The points separate by the vector t u, where t is the change of the input; their distance is t |u|.
        let parting: [Jet<N>; 2] = ways.map(|way| {
            Jet::of_derivatives(std::array::from_fn(|order| {
                let next = order + 1;
                if next < N {
                    way.derivative(next) / next as f64
                } else {
                    0.0
                }
            }))
        });
        if span(parting) <= tolerance::COINCIDENT * self.size() {
            return Jet::constant(0.0);
        }
        let rate = norm(parting);
        Jet::of_derivatives(std::array::from_fn(|order| match order {
            0 => 0.0,
            _ => order as f64 * rate.derivative(order - 1),
        }))
    }

    /// Angle at the second of three points, counter-clockwise from the first to the third, between minus and plus half
    /// a turn; 0 if the first or third point coincides with the second.
    pub(in crate::mechanism) fn corner<const N: usize>(
        &self,
        pose: &Pose<N>,
        points: [PointId; 3],
    ) -> Jet<N> {
        let [a, b, c] = points.map(|point| self.place(pose, point));
        let [u, v] = [a, c].map(|end| [end.x - b.x, end.y - b.y]);
        if span(u).min(span(v)) <= tolerance::NEGLIGIBLE * self.size() {
            return Jet::constant(0.0);
        }
        (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
    }

    pub(in crate::mechanism) fn two_points(&self, names: &str) -> Option<[PointId; 2]> {
        two(names, |name| self.point(name))
    }

    pub(in crate::mechanism) fn two_links(&self, names: &str) -> Option<[LinkId; 2]> {
        two(names, |name| self.link(name))
    }

    /// Three different points given by their names with hyphens in between.
    pub(in crate::mechanism) fn three_points(&self, names: &str) -> Option<[PointId; 3]> {
        let mut parts = names.match_indices('-');
        parts.find_map(|(at, _)| {
            let first = self.point(&names[..at])?;
            let [second, third] = self.two_points(&names[at + 1..])?;
            (first != second && first != third).then_some([first, second, third])
        })
    }
}

/// Two different objects given by their names with a hyphen in between; a name may contain hyphens.
fn two<T: PartialEq>(names: &str, named: impl Fn(&str) -> Option<T>) -> Option<[T; 2]> {
    let mut parts = names.match_indices('-');
    parts.find_map(|(at, _)| {
        let [from, to] = [named(&names[..at])?, named(&names[at + 1..])?];
        (from != to).then_some([from, to])
    })
}

fn span<const N: usize>([x, y]: [Jet<N>; 2]) -> f64 {
    x.value().hypot(y.value())
}

/// Length, with its derivatives, of a vector that is not zero.
fn norm<const N: usize>([x, y]: [Jet<N>; 2]) -> Jet<N> {
    (x.square() + y.square()).sqrt()
}

#[cfg(test)]
mod tests;
