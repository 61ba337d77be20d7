//! Arrows of the forces on a moving linkage.

use assur::Vector;
use assur::forces::{Reactions, Source};
use assur::mechanism::{DriverSpec, FRAME, Mechanism, Pose};
use assur::motion::{Sampling, Shown, Spacing};
use assur_draw::{Acting, ForceArrow, ForceScale, Role};

use super::Moving;

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
        let mut found = Reactions::default();
        let mut pose = self.mechanism().blank::<3>();
        let mut poses = Vec::new();
        for at in self.motion.samples(SAMPLING).into_iter().flatten() {
            let placed = self.motion.place(at, &mut pose).is_ok();
            if placed && self.forces().balance(&pose, at, &mut found).is_ok() {
                poses.push(self.arrows(&pose, &found));
            }
        }
        ForceScale::over(&poses, self.figure.size())
    }

    /// Reactions, each on the link placed later, applied forces, and what the drivers exert. What is statically
    /// indeterminate is left out.
    fn arrows(&self, pose: &Pose<3>, found: &Reactions) -> Vec<ForceArrow> {
        let mechanism = self.mechanism();
        let mut arrows = Vec::new();
        for (id, _) in self.forces().statics.pairs() {
            let reaction = found.of(id);
            let (at, role) = (reaction.place(mechanism), Role::Reaction);
            let force = reaction.vector().map(Acting::Force);
            let moment = reaction.moment.map(Acting::Torque);
            let parts = force.into_iter().chain(moment);
            arrows.extend(parts.map(|acting| ForceArrow { role, at, acting }));
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
            let parts = [Acting::Force(one.force), Acting::Torque(one.couple)];
            arrows.extend(parts.map(|acting| ForceArrow { role, at, acting }));
        }
        let drivers = mechanism.spec().drivers.iter();
        for (driver, spec) in self.forces().statics.drivers().zip(drivers) {
            let value = found.drive(driver);
            arrows.extend(value.and_then(|value| drive(mechanism, pose, spec, value)));
        }
        arrows
    }
}

/// Arrow of what a driver exerts: about the hinge of a crank on its base, or along the line of a slide.
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
            })
        }
    }
}
