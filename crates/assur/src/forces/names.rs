//! The parts of a loading, found in the mechanism by the names that a person gives.

use super::friction::{Friction, FrictionLaw};
use super::loading::{Damper, Load, Spring};
use super::pair::{self, Kind, PairId};
use super::spec::{AnchorSpec, DamperSpec, FrictionSpec, LoadSpec, SpringSpec};
use super::{Defect, Part};
use crate::Vector;
use crate::index::BodyId;
use crate::linkage::FRAME;
use crate::mechanism::{LinkOrFrame, Mechanism};
use crate::position::BodyPoint;
use crate::tolerance::FARTHEST;

/// Search for named links and points, which collects the defects of all parts.
pub(super) struct Names<'a> {
    mechanism: &'a Mechanism,
    pub(super) defects: Vec<Defect>,
    part: Part,
    index: usize,
}

impl<'a> Names<'a> {
    pub(super) fn new(mechanism: &'a Mechanism) -> Self {
        Self {
            mechanism,
            defects: Vec::new(),
            part: Part::Gravity,
            index: 0,
        }
    }

    /// Sets the part to which the defects that are found belong.
    pub(super) fn about(&mut self, part: Part, index: usize) -> &mut Self {
        (self.part, self.index) = (part, index);
        self
    }

    /// Notes a defect unless all numbers are finite and in range.
    pub(super) fn sound(&mut self, numbers: &[f64]) {
        let sound = |value: &f64| value.is_finite() && value.abs() <= FARTHEST;
        self.require(numbers.iter().all(sound));
    }

    /// Notes a defect unless all numbers are finite, in range and not negative.
    pub(super) fn not_negative(&mut self, numbers: &[f64]) {
        self.require(numbers.iter().all(|value| (0.0..=FARTHEST).contains(value)));
    }

    fn require(&mut self, is_number: bool) {
        if !is_number {
            let (part, index) = (self.part, self.index);
            self.defects.push(Defect::NoNumber { part, index });
        }
    }

    fn link(&mut self, name: &str) -> Option<LinkOrFrame> {
        let found = if name == FRAME {
            Some(None)
        } else {
            self.mechanism.link(name).map(Some)
        };
        if found.is_none() {
            let (part, index, name) = (self.part, self.index, name.to_owned());
            self.defects.push(Defect::OnNoLink { part, index, name });
        }
        found
    }

    fn anchor(&mut self, spec: &AnchorSpec) -> Option<(LinkOrFrame, BodyPoint)> {
        let link = self.link(&spec.link)?;
        let body = self.mechanism.body_of(link);
        let point = self.mechanism.point(&spec.point);
        let found = point.and_then(|point| self.mechanism.anchor(body, point));
        if found.is_none() {
            self.defects.push(Defect::OnNoPoint {
                part: self.part,
                index: self.index,
                link: spec.link.clone(),
                point: spec.point.clone(),
            });
        }
        Some((link, found?))
    }

    /// Anchors of the two ends of a spring or damper.
    fn ends(&mut self, ends: &[AnchorSpec; 2]) -> Option<[BodyPoint; 2]> {
        let [one, other] = ends.each_ref().map(|end| self.anchor(end));
        let ends = [one?.1, other?.1];
        self.parted(ends.map(|end| end.body)).map(|_| ends)
    }

    /// Bodies of two named links, each with the offset of the link's angle.
    fn both(&mut self, links: &[String; 2]) -> Option<([BodyId; 2], f64)> {
        let [one, other] = links.each_ref().map(|name| self.link(name));
        let links = [one?, other?];
        let bodies = self.parted(links.map(|link| self.mechanism.body_of(link)))?;
        let [one, other] = links.map(|link| self.mechanism.angle_offset(link));
        Some((bodies, one - other))
    }

    fn parted(&mut self, bodies: [BodyId; 2]) -> Option<[BodyId; 2]> {
        if bodies[0] == bodies[1] {
            let (part, index) = (self.part, self.index);
            self.defects.push(Defect::Idle { part, index });
            return None;
        }
        Some(bodies)
    }

    pub(super) fn load(&mut self, load: &LoadSpec) -> Option<Load> {
        match load {
            LoadSpec::Force {
                at,
                direction,
                turns,
                law,
            } => {
                self.require(law.is_valid(self.mechanism.turns()));
                self.sound(&[*direction]);
                let (link, at) = self.anchor(at)?;
                let offset = if *turns {
                    self.mechanism.angle_offset(link)
                } else {
                    0.0
                };
                let (sin, cos) = (direction + offset).sin_cos();
                Some(Load::Force {
                    at,
                    direction: Vector::new(cos, sin),
                    turns: *turns,
                    law: law.clone(),
                })
            }
            LoadSpec::Torque { link, law } => {
                self.require(law.is_valid(self.mechanism.turns()));
                let body = self.body(link)?;
                let law = law.clone();
                Some(Load::Torque { body, law })
            }
            LoadSpec::Drag { at, coefficients } => {
                self.sound(coefficients);
                let (_, at) = self.anchor(at)?;
                let coefficients = *coefficients;
                Some(Load::Drag { at, coefficients })
            }
            LoadSpec::AngularDrag { link, coefficients } => {
                self.sound(coefficients);
                let body = self.body(link)?;
                let coefficients = *coefficients;
                Some(Load::AngularDrag { body, coefficients })
            }
        }
    }

    fn body(&mut self, link: &str) -> Option<BodyId> {
        let link = self.link(link)?;
        Some(self.mechanism.body_of(link))
    }

    pub(super) fn spring(&mut self, spring: &SpringSpec) -> Option<Spring> {
        match spring {
            SpringSpec::Straight {
                ends,
                stiffness,
                free_length,
            } => {
                self.not_negative(&[*stiffness, *free_length]);
                Some(Spring::Straight {
                    ends: self.ends(ends)?,
                    stiffness: *stiffness,
                    free_length: *free_length,
                })
            }
            SpringSpec::Torsion {
                links,
                stiffness,
                free_angle,
            } => {
                self.not_negative(&[*stiffness]);
                self.sound(&[*free_angle]);
                let (bodies, offset) = self.both(links)?;
                Some(Spring::Torsion {
                    bodies,
                    stiffness: *stiffness,
                    free_angle: free_angle - offset,
                })
            }
        }
    }

    pub(super) fn damper(&mut self, damper: &DamperSpec) -> Option<Damper> {
        match damper {
            DamperSpec::Straight { ends, damping } => {
                self.not_negative(&[*damping]);
                let ends = self.ends(ends)?;
                let damping = *damping;
                Some(Damper::Straight { ends, damping })
            }
            DamperSpec::Torsion { links, damping } => {
                self.not_negative(&[*damping]);
                let (bodies, _) = self.both(links)?;
                let damping = *damping;
                Some(Damper::Torsion { bodies, damping })
            }
        }
    }

    pub(super) fn friction(&mut self, friction: &FrictionSpec) -> Option<Vec<Friction>> {
        let (FrictionSpec::Hinge { coefficient, .. } | FrictionSpec::Slide { coefficient, .. }) =
            friction;
        let (name, law) = match friction {
            FrictionSpec::Hinge { point, radius, .. } => {
                self.not_negative(&[*coefficient, *radius]);
                let circle = coefficient * radius;
                (point, FrictionLaw::Hinge { circle })
            }
            FrictionSpec::Slide { link, length, .. } => {
                let length = length.unwrap_or(0.0);
                self.not_negative(&[*coefficient, length]);
                let coefficient = *coefficient;
                (
                    link,
                    FrictionLaw::Slide {
                        coefficient,
                        length,
                    },
                )
            }
        };
        let pairs = pair::pairs(self.mechanism);
        let own = pairs
            .iter()
            .enumerate()
            .filter(|(_, pair)| match pair.kind {
                Kind::Hinge(_, point) => {
                    matches!(law, FrictionLaw::Hinge { .. })
                        && self.mechanism.point_name(point) == name
                }
                Kind::Slide(guide) => {
                    let link = self.mechanism.link(name);
                    let body = link.map(|link| self.mechanism.body_of(Some(link)));
                    matches!(law, FrictionLaw::Slide { .. }) && body == Some(guide.at.body)
                }
                Kind::Mesh(_) => false,
            });
        let index = self.index;
        let own: Vec<Friction> = own
            .map(|(pair, _)| Friction {
                pair: PairId(pair),
                index,
                law,
            })
            .collect();
        if own.is_empty() {
            let name = name.clone();
            self.defects.push(Defect::NoPair { index, name });
            return None;
        }
        Some(own)
    }

    /// Notes a defect for each entry that names a pair which an earlier entry names already.
    pub(super) fn once(&mut self, friction: &[Friction]) {
        let pairs = pair::pairs(self.mechanism);
        for (k, one) in friction.iter().enumerate() {
            let earlier = |other: &Friction| other.pair == one.pair && other.index < one.index;
            let is_noted = |defect: &Defect| matches!(defect, Defect::RubsTwice { index, .. } if *index == one.index);
            if friction[..k].iter().any(earlier) && !self.defects.iter().any(is_noted) {
                self.defects.push(Defect::RubsTwice {
                    index: one.index,
                    name: pairs[one.pair.0].name(self.mechanism),
                });
            }
        }
    }
}
