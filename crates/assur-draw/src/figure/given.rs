//! Given positions of a linkage, drawn behind its links.

use assur::{Point, Vector};

use super::names::Names;
use crate::annotations::GivenPosition;
use crate::list::{List, Look, Role};

/// Given positions, each with the index of its number in the list of names.
#[derive(Clone, Debug)]
pub(super) struct Given(Vec<(GivenPosition, usize)>);

impl Given {
    pub(super) fn new(positions: &[GivenPosition], names: &mut Names) -> Self {
        let numbered = positions.iter();
        let numbered = numbered.map(|one| (one.clone(), names.add(one.number.clone())));
        Self(numbered.collect())
    }

    /// Returns the points that must be within the drawing.
    pub(super) fn reach(&self) -> impl Iterator<Item = Point> + '_ {
        let lines = |one: &GivenPosition| [&one.directions[..], &one.links[..]].concat();
        let lines = self.0.iter().flat_map(move |(one, _)| lines(one));
        lines.flat_map(|(ends, _)| ends)
    }

    /// Draws each position: links as lines, directions as dashed lines with handles, and its number beyond each handle.
    pub(super) fn draw(&self, list: &mut List, unit: f64) {
        for (position, number) in &self.0 {
            for (ends, role) in &position.links {
                list.polyline(*role, Look::Line, ends);
            }
            for (ends, role) in &position.directions {
                direction(list, *ends, *role, *number, unit);
            }
        }
    }
}

fn direction(list: &mut List, [from, tip]: [Point; 2], role: Role, number: usize, unit: f64) {
    list.polyline(role, Look::Dashed, &[from, tip]);
    list.circle(role, Look::Hollow, tip, 1.6 * unit);
    let along: Vector = tip - from;
    let length = along.norm();
    if length > 0.0 {
        let off = along * (1.6 / length);
        list.name(role, number, tip, [off.x, off.y]);
    }
}
