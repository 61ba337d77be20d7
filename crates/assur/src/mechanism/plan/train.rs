//! Meshes of a group, mounting of its wheels, and the step of a group that is an epicyclic train.

use crate::Vector;
use crate::index::BodyId;
use crate::mechanism::plan::Placed;
use crate::mechanism::plan::body::Gear;
use crate::mechanism::plan::driver::DrivenPair;
use crate::mechanism::plan::willis::{Adds, Equation, Solved};
use crate::position::{EpicyclicStep, Member, Orientation};

/// Error if the meshes of a group do not determine the angles of its bodies. For example, the wheels in mesh with a
/// body of the group may turn alike, so that any angle of this body satisfies the equations.
pub(in crate::mechanism) struct Singular;

impl Placed<'_> {
    /// Gear couplings with at least one body in a group; their other bodies are in the group or already solved.
    pub(in crate::mechanism) fn couplings(&self, group: &[BodyId]) -> Vec<&Gear> {
        let inside = |body: &BodyId| group.contains(body);
        let of_it = |gear: &&Gear| {
            let all = gear.all();
            all.iter().any(inside) && all.iter().all(|body| inside(body) || self.solved[*body])
        };
        self.bodies.active_gears().filter(of_it).collect()
    }

    /// Mounts those wheels of a group whose orientation no point or guide shows. Such a wheel is set by its first mesh
    /// with a wheel of known orientation, so that the angles of both wheels relative to the carrier are zero together.
    /// Driven wheels are left out, because their coordinates give their angles.
    pub(in crate::mechanism) fn mount(&mut self, group: &[BodyId], driven: &[DrivenPair]) {
        let round = group.iter().copied();
        let round = round.filter(|body| {
            let is_driven = driven.iter().any(|pair| pair.turns(*body));
            !is_driven && !self.bodies.shows_its_angle(*body)
        });
        let mut waiting: Vec<BodyId> = round.collect();
        while let Some((wheel, angle)) = self.mounted(group, &waiting) {
            let (sin, cos) = angle.sin_cos();
            let turn = Vector::new(cos, sin);
            self.orientations[wheel] = Orientation { angle, turn };
            waiting.retain(|body| *body != wheel);
        }
    }

    /// A wheel not yet mounted, with its angle, if the orientations of its mating wheel and carrier are known.
    fn mounted(&self, group: &[BodyId], waiting: &[BodyId]) -> Option<(BodyId, f64)> {
        self.couplings(group).into_iter().find_map(|gear| {
            let mut unknown = gear.all().into_iter().filter(|body| waiting.contains(body));
            let wheel = unknown.next().filter(|body| *body != gear.carrier)?;
            if unknown.next().is_some() {
                return None;
            }
            let mut solved = Solved::default();
            solved.add(&Equation::of(gear), |body| body == wheel)?;
            let (_, ratios) = solved.ratios().next()?;
            Some((wheel, self.turned(&ratios)))
        })
    }

    /// Angle that follows from the drawn angles of other bodies and the given ratios.
    fn turned(&self, ratios: &[(BodyId, f64)]) -> f64 {
        ratios
            .iter()
            .map(|(body, ratio)| self.orientations[*body].angle * ratio)
            .fold(0.0, |sum, term| sum + term)
    }

    /// Step of a group that is a train, with hinges and one mesh per body but no slides. None for any other group.
    ///
    /// # Errors
    /// The numbers of teeth do not determine the angles of the train.
    pub(in crate::mechanism) fn train(
        &self,
        group: &[BodyId],
    ) -> Result<Option<EpicyclicStep>, Singular> {
        let couplings = self.couplings(group);
        let slides = self.bodies.slides.iter().any(|slide| {
            group.iter().any(|body| {
                slide
                    .joins(*body)
                    .is_some_and(|other| self.solved[other] || group.contains(&other))
            })
        });
        if couplings.len() != group.len() || slides {
            return Ok(None);
        }
        let mut solved = Solved::default();
        for gear in couplings {
            match solved.add(&Equation::of(gear), |body| group.contains(&body)) {
                Some(Adds::Angle) => {}
                Some(Adds::Nothing | Adds::Elsewhere) => return Err(Singular),
                None => return Ok(None),
            }
        }
        let angles: Vec<_> = solved.ratios().collect();
        let mut members: Vec<Member> = Vec::new();
        while members.len() < group.len() {
            let is_placed = |body: BodyId| {
                self.solved[body] || members.iter().any(|member| member.body == body)
            };
            let next = angles.iter().find_map(|(body, ratios)| {
                if is_placed(*body) {
                    return None;
                }
                let mut points = self.bodies.of(*body).iter();
                let (joint, at, hinge) = points.find_map(|(point, hinge)| {
                    Some((*point, self.bodies.anchor_of(*point, is_placed)?, *hinge))
                })?;
                Some((*body, at, hinge, joint, ratios.clone()))
            });
            let Some((body, at, hinge, joint, ratios)) = next else {
                return Ok(None);
            };
            let shift = self.orientations[body].angle - self.turned(&ratios);
            members.push(Member {
                body,
                at,
                hinge,
                joint,
                ratios,
                shift,
            });
        }
        Ok(Some(EpicyclicStep { members }))
    }
}
