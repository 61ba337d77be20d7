//! Which wheels in mesh belong to a group, how its wheels are mounted, and the plan of a group that is nothing but an
//! epicyclic train.

use crate::Vector;
use crate::index::BodyId;
use crate::mechanism::plan::Placed;
use crate::mechanism::plan::body::Gear;
use crate::mechanism::plan::driver::DrivenPair;
use crate::mechanism::plan::willis::{Adds, Equation, Solved};
use crate::position::{EpicyclicStep, Member, Orientation};

/// The meshes of a group do not determine how its bodies turn: where its mates turn alike, any angle will do.
pub(in crate::mechanism) struct Singular;

impl Placed<'_> {
    /// The gear couplings whose equations count for a group: all their bodies are of it or solved before.
    pub(in crate::mechanism) fn couplings(&self, group: &[BodyId]) -> Vec<&Gear> {
        let inside = |body: &BodyId| group.contains(body);
        let of_it = |gear: &&Gear| {
            let all = gear.all();
            all.iter().any(inside) && all.iter().all(|body| inside(body) || self.solved[*body])
        };
        self.bodies.gears.iter().filter(of_it).collect()
    }

    /// Turns the wheels of a group whose angle no point and no guide shows: each from where a mate is at zero, seen
    /// from their carrier, that of the first coupling that gives it. The coordinate of a driven one gives its angle.
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

    /// A wheel that waits while neither its mate nor their carrier does, and its angle.
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

    /// What other bodies make of an angle in the drawing.
    fn turned(&self, ratios: &[(BodyId, f64)]) -> f64 {
        ratios
            .iter()
            .map(|(body, ratio)| self.orientations[*body].angle * ratio)
            .fold(0.0, |sum, term| sum + term)
    }

    /// The train that a group is; none where anything but a hinge each and as many meshes holds its bodies.
    ///
    /// # Errors
    /// That the numbers of teeth do not determine its angles.
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
                let (at, hinge) = points.find_map(|(point, hinge)| {
                    Some((self.bodies.anchor_of(*point, is_placed)?, *hinge))
                })?;
                Some((*body, at, hinge, ratios.clone()))
            });
            let Some((body, at, hinge, ratios)) = next else {
                return Ok(None);
            };
            let shift = self.orientations[body].angle - self.turned(&ratios);
            members.push(Member {
                body,
                at,
                hinge,
                ratios,
                shift,
            });
        }
        Ok(Some(EpicyclicStep { members }))
    }
}
