//! Arrows of the forces on a moving linkage.

use std::collections::BTreeMap;

use assur::Vector;
use assur::forces::{Cause, Component, ForceName, Reactions, Source};
use assur::mechanism::{BodyId, DriverSpec, FRAME, Mechanism, Pose};
use assur::motion::{Sampling, Shown, Spacing};
use assur_draw::{Acting, ForceArrow, ForceScale, Role, force_symbol, touching};

use super::Moving;
use crate::forces::{Forces, friction_circle};
use crate::polygons::body_number;

/// Sampling of the motion for the scale of the arrows.
const SAMPLING: Sampling = Sampling {
    turn: 120,
    coarsest: 30,
    most: 32 * 120,
    spacing: Spacing::Middles,
    shown: Shown::Spread,
};

impl Moving {
    /// Adds the arrows of all forces in a pose to a frame; none if reactions are unbounded.
    pub(super) fn add_arrows(&self, frame: &mut Vec<f32>, input: f64, pose: &Pose<3>) {
        let mut found = Reactions::default();
        if self.forces().balance(pose, input, &mut found).is_ok() {
            let scale = self.forces().scale.get_or_init(|| self.scale_of_forces());
            let arrows = self.arrows(pose, &found);
            self.figure.add_forces(frame, &arrows, *scale);
        }
    }

    fn scale_of_forces(&self) -> ForceScale {
        let mut poses = Vec::new();
        self.each_balanced(SAMPLING, |pose, found| poses.push(self.arrows(pose, found)));
        ForceScale::over(&poses, self.figure.size())
    }

    /// Names of the forces whose arrows have names: the reactions in the order of the pairs, then the torques and
    /// forces of the drivers.
    pub(super) fn names_of_forces(
        forces: &Forces,
        numbers: &BTreeMap<String, String>,
    ) -> Vec<String> {
        let mechanism = &forces.mechanism;
        let number = |body| body_number(mechanism, numbers, body);
        let symbol = |body, cause, is_couple| {
            let part = Component::Whole;
            force_symbol(&ForceName { body, cause, part }, is_couple, &number)
        };
        let reactions = forces.statics.pairs().map(|(pair, of)| {
            let [on, from] = of.bodies;
            symbol(on, Cause::Reaction { pair, from }, false)
        });
        let spec = mechanism.spec();
        let drives = forces.statics.drivers().zip(&spec.drivers);
        let drives = drives.map(|(driver, given)| {
            let link = spec.driven(given).and_then(|link| mechanism.link(link));
            let from = BodyId::FRAME;
            let is_couple = matches!(given, DriverSpec::Crank { .. });
            symbol(
                mechanism.body_of(link),
                Cause::Drive { driver, from },
                is_couple,
            )
        });
        reactions.chain(drives).collect()
    }

    /// Reactions, each on the link placed later, applied forces, and torques and forces of the drivers. Statically
    /// indeterminate ones are left out. The reaction of a hinge with friction touches the friction circle.
    fn arrows(&self, pose: &Pose<3>, found: &Reactions) -> Vec<ForceArrow> {
        let mechanism = self.mechanism();
        let mut arrows = Vec::new();
        for (id, _) in self.forces().statics.pairs() {
            let reaction = found.of(id);
            let (mut at, role) = (reaction.place(mechanism), Role::Reaction);
            let arrow = |at, acting, name| ForceArrow {
                role,
                at,
                acting,
                name,
            };
            let moment = reaction.moment.map(Acting::Torque);
            arrows.extend(moment.map(|acting| arrow(at, acting, None)));
            let force = reaction.vector();
            let circle = friction_circle(&self.forces().loading, found, id);
            if let Some((radius, couple)) = circle {
                arrows.push(arrow(at, Acting::Circle(radius), None));
                let drawn = self.figure.drawn_circle(radius);
                at += touching(force.unwrap_or_default(), couple, drawn);
            }
            let force = force.map(Acting::Force);
            arrows.extend(force.map(|acting| arrow(at, acting, Some(id.index()))));
        }
        let mut is_opposite = false;
        for one in found.applied() {
            if matches!(one.source, Source::Friction(_)) {
                // Friction comes in opposite pairs; like a reaction, it is drawn on one of the two links.
                is_opposite = !is_opposite;
                if !is_opposite {
                    continue;
                }
            }
            let role = match one.source {
                Source::Weight => Role::Weight,
                Source::Inertia => Role::Inertia,
                _ => Role::Force,
            };
            let at = one.place(mechanism);
            let mut parts = vec![Acting::Force(one.force)];
            // A friction couple has no arrow: it is shown by the displacement of its reaction.
            if !matches!(one.source, Source::Friction(_)) {
                parts.push(Acting::Torque(one.couple));
            }
            arrows.extend(parts.into_iter().map(|acting| ForceArrow {
                role,
                at,
                acting,
                name: None,
            }));
        }
        let pairs = self.forces().statics.pairs().len();
        let drivers = mechanism.spec().drivers.iter();
        for (driver, spec) in self.forces().statics.drivers().zip(drivers) {
            let value = found.drive(driver);
            let arrow = value.and_then(|value| drive(mechanism, pose, spec, value));
            arrows.extend(arrow.map(|arrow| ForceArrow {
                name: Some(pairs + driver.index()),
                ..arrow
            }));
        }
        arrows
    }
}

/// Arrow of a driver's torque, about the hinge of the crank on its base, or of its force, along the line of the slide.
fn drive(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    driver: &DriverSpec,
    value: f64,
) -> Option<ForceArrow> {
    let spec = mechanism.spec();
    let place = |name: &String| Some(mechanism.place(pose, mechanism.point(name)?).place());
    match driver {
        DriverSpec::Crank { link, base, .. } => {
            let points = |name: &String| spec.links.iter().find(|one| one.name == *name);
            let on_base = |point: &&String| match base.as_str() {
                FRAME => spec.frame.contains(point),
                _ => points(base).is_some_and(|base| base.points.contains(point)),
            };
            let pivot = points(link)?.points.iter().find(on_base)?;
            Some(ForceArrow {
                role: Role::Torque,
                at: place(pivot)?,
                acting: Acting::Torque(value),
                name: None,
            })
        }
        DriverSpec::Slide { slide, .. } => {
            let slide = spec.slides.get(*slide)?;
            let [from, to] = [place(&slide.line[0])?, place(&slide.line[1])?];
            let along: Vector = (to - from).try_normalize(0.0)?;
            Some(ForceArrow {
                role: Role::Torque,
                at: place(&slide.point)?,
                acting: Acting::Force(along * value),
                name: None,
            })
        }
    }
}
