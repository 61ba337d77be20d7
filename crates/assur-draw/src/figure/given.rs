//! Given positions of a linkage, drawn behind its links.

use assur::{Point, Vector};

use super::names::Names;
use crate::annotations::{Annotations, GivenPosition};
use crate::guidance::Guidance;
use crate::list::{List, Look, Role};

/// Given positions, each with the index of its number in the list of names; poses of a guided body, with the indices of
/// their labels.
#[derive(Clone, Debug)]
pub(super) struct Given {
    positions: Vec<(GivenPosition, usize)>,
    guidance: Guidance,
    labels: Vec<usize>,
}

impl Given {
    pub(super) fn new(annotations: &Annotations, names: &mut Names) -> Self {
        let positions = annotations.given.iter();
        let positions = positions.map(|one| (one.clone(), names.add(one.number.clone())));
        let positions = positions.collect();
        let labels = annotations.guidance.labels();
        Self {
            positions,
            labels: labels.map(|label| names.add(label.clone())).collect(),
            guidance: annotations.guidance.clone(),
        }
    }

    /// Returns the points that must be within the drawing.
    pub(super) fn reach(&self) -> impl Iterator<Item = Point> + '_ {
        let lines = |one: &GivenPosition| [&one.directions[..], &one.links[..]].concat();
        let lines = self.positions.iter().flat_map(move |(one, _)| lines(one));
        lines
            .flat_map(|(ends, _)| ends)
            .chain(self.guidance.reach())
    }

    /// Draws each position: links as lines, directions as dashed lines with handles, and its number beyond each handle.
    pub(super) fn draw(&self, list: &mut List, unit: f64) {
        self.guidance.draw(list, &self.labels, unit);
        for (position, number) in &self.positions {
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
