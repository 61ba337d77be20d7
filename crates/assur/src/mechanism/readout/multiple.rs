//! Angles that follow from others in a constant ratio: of wheels, and of parts
//! fixed to links.

use crate::index::LinkId;
use crate::mechanism::{Layout, Mechanism};
use crate::position::{Mounting, Step};

/// An angle as a linear function of a link's angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiple {
    /// The link.
    pub of: LinkId,
    /// The angle is `factor` times that link's, plus `offset`.
    pub factor: f64,
    /// Radians.
    pub offset: f64,
}

impl Mechanism {
    /// The angle of a link as a constant multiple of another link's, at all inputs: for a wheel or a carrier, of the
    /// only body that turns it in a train. Of its own if there is none.
    pub fn multiple_of(&self, link: LinkId) -> Multiple {
        self.layout.multiple_of(link, self.mounting())
    }
}

impl Layout {
    pub(in crate::mechanism) fn multiple_of(&self, link: LinkId, mounting: &Mounting) -> Multiple {
        let own = Multiple {
            of: link,
            factor: 1.0,
            offset: 0.0,
        };
        let part = &self.links[link];
        let (mut body, mut factor, mut offset) = (part.body, 1.0, part.angle_offset);
        // A chain of wheels is not longer than the number of steps.
        for _ in 0..self.steps.len() {
            let trains = self.steps.iter().filter_map(|step| match step {
                Step::Epicyclic(train) => Some(&train.members),
                _ => None,
            });
            let member = trains.flatten().find(|member| member.body == body);
            let Some(member) = member else { break };
            let [(turned_by, ratio)] = member.ratios[..] else {
                break;
            };
            offset += factor * (member.shift + mounting.shifts[body]);
            factor *= ratio;
            body = turned_by;
        }
        match self.made_for[body] {
            Some(of) => Multiple { of, factor, offset },
            None => own,
        }
    }
}
