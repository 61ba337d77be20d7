//! A valid loading of a mechanism: masses of its bodies, and forces at places of its bodies.

use super::friction::{Friction, FrictionLaw};
use super::masses::{BodyMass, crank, mass};
use super::pair::{self, Kind, PairId};
use super::spec::{AnchorSpec, DamperSpec, FrictionSpec, LoadSpec, LoadingSpec, SpringSpec};
use super::{Defect, Law, Part};
use crate::Vector;
use crate::index::{BodyId, List};
use crate::linkage::FRAME;
use crate::mechanism::{LinkOrFrame, Mechanism};
use crate::position::BodyPoint;
use crate::tolerance::FARTHEST;

/// Masses and loads of a mechanism, with everything named found in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Loading {
    /// Mass of each body with the links fixed to it; that of the frame is zero.
    pub(super) masses: List<BodyId, BodyMass>,
    pub(super) gravity: Vector,
    pub(super) loads: Vec<Load>,
    pub(super) springs: Vec<Spring>,
    pub(super) dampers: Vec<Damper>,
    pub(super) friction: Vec<Friction>,
    /// True if the input is the angle of a crank.
    pub(super) turns: bool,
    /// The crank of the first driver, with its moment of inertia without the flywheel.
    crank: Option<(BodyId, f64)>,
    flywheel: f64,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Load {
    Force {
        at: BodyPoint,
        /// Unit vector of the force, in the frame or on the body.
        direction: Vector,
        turns: bool,
        law: Law,
    },
    Torque {
        body: BodyId,
        law: Law,
    },
    Drag {
        at: BodyPoint,
        coefficients: [f64; 2],
    },
    AngularDrag {
        body: BodyId,
        coefficients: [f64; 2],
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spring {
    Straight {
        ends: [BodyPoint; 2],
        stiffness: f64,
        free_length: f64,
    },
    Torsion {
        bodies: [BodyId; 2],
        stiffness: f64,
        /// Relative angle of the bodies without load.
        free_angle: f64,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Damper {
    Straight { ends: [BodyPoint; 2], damping: f64 },
    Torsion { bodies: [BodyId; 2], damping: f64 },
}

impl Loading {
    /// The loading of a mechanism: the masses in its specification, and what `spec` gives.
    ///
    /// ```
    /// # use assur::{linkage::LinkageSpec, mechanism::Mechanism};
    /// use assur::forces::{AnchorSpec, Defect, Law, LoadSpec, Loading, LoadingSpec, Part};
    /// # let slider_crank = LinkageSpec::default()
    /// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
    /// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
    /// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
    /// let mechanism = Mechanism::new(&slider_crank).unwrap();
    /// let at = AnchorSpec::new("slider", "E");
    /// let (direction, turns, law) = (0.0, false, Law::Constant(5.0));
    /// let loads = vec![LoadSpec::Force { at, direction, turns, law }];
    /// let refused = Loading::new(&mechanism, &LoadingSpec { loads, ..LoadingSpec::default() });
    /// let (part, index, link, point) = (Part::Load, 0, "slider".to_owned(), "E".to_owned());
    /// assert_eq!(refused.unwrap_err(), [Defect::OnNoPoint { part, index, link, point }]);
    /// ```
    ///
    /// # Errors
    /// Every defect of the loads, springs and dampers. Masses are checked by [`Mechanism::new`].
    pub fn new(mechanism: &Mechanism, spec: &LoadingSpec) -> Result<Self, Vec<Defect>> {
        let mut names = Names {
            mechanism,
            defects: Vec::new(),
            part: Part::Gravity,
            index: 0,
        };
        names.sound(spec.gravity.as_slice());
        let loads = spec.loads.iter().enumerate();
        let loads = loads.map(|(index, load)| names.about(Part::Load, index).load(load));
        let loads = all(loads);
        let springs = spec.springs.iter().enumerate();
        let springs =
            springs.map(|(index, spring)| names.about(Part::Spring, index).spring(spring));
        let springs = all(springs);
        let dampers = spec.dampers.iter().enumerate();
        let dampers =
            dampers.map(|(index, damper)| names.about(Part::Damper, index).damper(damper));
        let dampers = all(dampers);
        let friction = spec.friction.iter().enumerate();
        let friction =
            friction.map(|(index, one)| names.about(Part::Friction, index).friction(one));
        let friction = all(friction);
        names
            .about(Part::Flywheel, 0)
            .not_negative(&[spec.flywheel]);
        let own = Self::of_masses(mechanism);
        if spec.flywheel > 0.0 && own.crank.is_none() {
            names.defects.push(Defect::NoCrank);
        }
        match (loads, springs, dampers, friction) {
            (Some(loads), Some(springs), Some(dampers), Some(friction))
                if names.defects.is_empty() =>
            {
                let loading = Self {
                    gravity: spec.gravity,
                    loads,
                    springs,
                    dampers,
                    friction: friction.concat(),
                    ..own
                };
                Ok(loading.with_flywheel(spec.flywheel))
            }
            _ => Err(names.defects),
        }
    }

    /// True if a pair has friction.
    pub fn has_friction(&self) -> bool {
        !self.friction.is_empty()
    }

    /// Moment of inertia of the flywheel; zero without one.
    pub fn flywheel(&self) -> f64 {
        self.flywheel
    }

    /// The same loading with a flywheel of another moment of inertia, which is not negative, instead of its own. If the
    /// first driver is no crank, nothing changes.
    pub fn with_flywheel(&self, flywheel: f64) -> Self {
        let mut loading = self.clone();
        if let Some((body, own)) = self.crank {
            loading.masses[body].inertia = own + flywheel;
            loading.flywheel = flywheel;
        }
        loading
    }

    /// Inputs at which the tables of the loads have knots.
    pub(super) fn knots(&self) -> impl Iterator<Item = f64> {
        let laws = self.loads.iter().filter_map(|load| match load {
            Load::Force { law, .. } | Load::Torque { law, .. } => Some(law),
            Load::Drag { .. } | Load::AngularDrag { .. } => None,
        });
        laws.flat_map(|law| match law {
            Law::Table(knots) => knots.as_slice(),
            Law::Constant(_) | Law::Harmonics(_) => &[],
        })
        .map(|[input, _]| *input)
    }

    /// True if the first driver is a crank, which can bear a flywheel.
    pub fn bears_flywheel(&self) -> bool {
        self.crank.is_some()
    }

    /// The masses of a mechanism alone, without gravity, loads and flywheel.
    pub fn of_masses(mechanism: &Mechanism) -> Self {
        let masses = mechanism.bodies().map(|body| mass(mechanism, body));
        let masses: List<BodyId, BodyMass> = masses.collect();
        Self {
            crank: crank(mechanism).map(|body| (body, masses[body].inertia)),
            flywheel: 0.0,
            masses,
            gravity: Vector::zeros(),
            loads: Vec::new(),
            springs: Vec::new(),
            dampers: Vec::new(),
            friction: Vec::new(),
            turns: mechanism.turns(),
        }
    }
}

/// All parts, or none if one is missing. Every part is looked at, so that all defects are found.
fn all<T>(parts: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    let parts: Vec<Option<T>> = parts.collect();
    parts.into_iter().collect()
}

/// Search for named links and points, which collects the defects of all parts.
struct Names<'a> {
    mechanism: &'a Mechanism,
    defects: Vec<Defect>,
    part: Part,
    index: usize,
}

impl Names<'_> {
    fn about(&mut self, part: Part, index: usize) -> &mut Self {
        (self.part, self.index) = (part, index);
        self
    }

    /// Notes a defect unless all numbers are finite and in range.
    fn sound(&mut self, numbers: &[f64]) {
        let sound = |value: &f64| value.is_finite() && value.abs() <= FARTHEST;
        self.require(numbers.iter().all(sound));
    }

    /// Notes a defect unless all numbers are finite, in range and not negative.
    fn not_negative(&mut self, numbers: &[f64]) {
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

    fn load(&mut self, load: &LoadSpec) -> Option<Load> {
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

    fn spring(&mut self, spring: &SpringSpec) -> Option<Spring> {
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

    fn damper(&mut self, damper: &DamperSpec) -> Option<Damper> {
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

    fn friction(&mut self, friction: &FrictionSpec) -> Option<Vec<Friction>> {
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
}
