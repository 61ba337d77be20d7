//! Angles that are linear functions of other angles: the angles of wheels, and of links fixed to other links.

use crate::index::LinkId;
use crate::mechanism::{Layout, Mechanism};
use crate::position::{Mounting, Step};

/// Angle as a linear function of the angle of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiple {
    /// Link whose angle is the argument.
    pub of: LinkId,
    /// Factor by which this angle is multiplied.
    pub factor: f64,
    /// Angle added to the product, radians.
    pub offset: f64,
}

impl Mechanism {
    /// Angle of a link as a linear function of the angle of one link, the same at all inputs. For a link fixed to
    /// another link, the argument is the angle of the base. For a wheel or carrier that only one link turns, it is the
    /// angle of this driving link. For any other link it is the link's own angle.
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
