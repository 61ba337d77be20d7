//! A valid loading of a mechanism: masses of its bodies, and forces at places of its bodies.

use std::f64::consts::TAU;

use super::friction::Friction;
use super::masses::{BodyMass, crank, mass};
use super::names::Names;
use super::spec::LoadingSpec;
use super::{Defect, Law, Part};
use crate::Vector;
use crate::index::{BodyId, List};
use crate::mechanism::Mechanism;
use crate::position::BodyPoint;
use crate::tolerance;

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
    /// Every defect of gravity, loads, springs, dampers, friction and flywheel. Masses are checked by [`Mechanism::new`].
    pub fn new(mechanism: &Mechanism, spec: &LoadingSpec) -> Result<Self, Vec<Defect>> {
        let mut names = Names::new(mechanism);
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
        let friction = all(friction).map(|friction| friction.concat());
        if let Some(friction) = &friction {
            names.once(friction);
        }
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
                    friction,
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

    /// Way from an input in a sense, ±1, to the next knot of a table of the loads; infinite if there is none. A step
    /// beyond a knot would not see it if no stage is behind it.
    pub(super) fn way_to_knot(&self, input: f64, sense: f64) -> f64 {
        let laws = self.loads.iter().filter_map(|load| match load {
            Load::Force { law, .. } | Load::Torque { law, .. } => Some(law),
            Load::Drag { .. } | Load::AngularDrag { .. } => None,
        });
        let knots = laws.flat_map(|law| match law {
            Law::Table(knots) => knots.as_slice(),
            Law::Constant(_) | Law::Harmonics(_) => &[],
        });
        let ways = knots.map(|[knot, _]| {
            let way = sense * (knot - input);
            // The tables of a crank repeat each turn.
            if self.turns { way.rem_euclid(TAU) } else { way }
        });
        let ahead = ways.filter(|way| *way > tolerance::NEGLIGIBLE);
        ahead.fold(f64::INFINITY, f64::min)
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
