//! Reactions, torques and forces of the drivers, and applied forces of a linkage at an input, in the document's units.

use assur::Vector;
use assur::forces::{Pair, Reaction, Reactions, Source, Unbalanced};
use assur::mechanism::DriverSpec;
use assur::motion::Grid;
use assur_file::{ForceUnits, Problem};
use serde::Serialize;

use crate::force_quantity::{ForceQuantity, Part};
use crate::forces::Forces;
use crate::moving::Moving;

/// Steps of a turn of the crank, or of the range of a slide, in the search for the greatest reactions.
const STEPS: f64 = 360.0;

/// Forces in N and torques in N·m, or in the consistent units of a document without a unit of lengths.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForcesHere {
    reactions: Vec<ReactionHere>,
    drives: Vec<DriveHere>,
    applied: Vec<AppliedHere>,
    shaking: ShakingHere,
    /// Power that friction takes, W; none without friction.
    lost: Option<f64>,
    /// Efficiency of the first driver; none without friction, and if the driver does no work. Not positive: the loads cannot
    /// drive the linkage back.
    efficiency: Option<f64>,
}

/// Force with which the moving links shake the frame.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ShakingHere {
    /// Name of its magnitude among the quantities that can be plotted.
    name: String,
    value: f64,
    /// Direction of the force, radians from the x-axis; none for a force of zero.
    direction: Option<f64>,
    /// Moment about the origin.
    moment: f64,
}

/// Reaction of a pair on the link placed later; that on the other link is opposite.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ReactionHere {
    /// Name of its magnitude among the quantities that can be plotted, such as `B.reaction`.
    name: String,
    /// The point of the hinge or slide, or the two wheels.
    pair: String,
    #[cfg_attr(test, ts(type = "\"hinge\" | \"slide\" | \"mesh\""))]
    kind: &'static str,
    /// The link on which it acts, and the link from which it comes; `frame` for the frame.
    on: String,
    from: String,
    /// Components and moment; none for what is statically indeterminate.
    x: Option<f64>,
    y: Option<f64>,
    moment: Option<f64>,
    /// Magnitude of the force.
    value: Option<f64>,
    /// Direction of the force, radians from the x-axis; none for a force of zero.
    direction: Option<f64>,
}

/// What a driver exerts on its driven link: the torque of a crank, or the force of a slide.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DriveHere {
    /// Name of the quantity that can be plotted: `crank.torque` or `slider.force`.
    name: String,
    link: String,
    #[cfg_attr(test, ts(type = "\"torque\" | \"force\""))]
    kind: &'static str,
    value: Option<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AppliedHere {
    #[cfg_attr(
        test,
        ts(type = "\"weight\" | \"inertia\" | \"load\" | \"spring\" | \"damper\" | \"friction\"")
    )]
    kind: &'static str,
    /// Index of the load, spring, damper or friction in its list.
    index: Option<usize>,
    link: String,
    x: f64,
    y: f64,
    /// Magnitude of the force.
    value: f64,
    /// Couple, positive counter-clockwise.
    couple: f64,
}

/// The greatest forces over the motion.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GreatestForces {
    greatest: Vec<GreatestHere>,
    /// Number of poses in which they are sought, and in how many of these friction holds the linkage whatever the
    /// driver does, so that there are no reactions.
    poses: usize,
    locked: usize,
}

/// The greatest magnitude of a reaction, torque or force over the motion.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GreatestHere {
    /// Name of the quantity.
    name: String,
    /// Its value with the greatest magnitude; none if it is statically indeterminate everywhere.
    value: Option<f64>,
    /// The input at which it is reached: radians of a crank, otherwise in the unit of lengths.
    input: f64,
}

impl Moving {
    /// The forces at an input.
    ///
    /// # Errors
    /// No pose at this input, or unbounded derivatives or reactions.
    pub(crate) fn forces_at(&self, input: f64) -> Result<ForcesHere, Vec<Problem>> {
        let (_, found) = self.balanced(input)?;
        let forces = self.forces();
        let units = forces.units;
        let (mut reactions, mut drives, mut shaking) = (Vec::new(), Vec::new(), String::new());
        let pairs = forces.statics.pairs();
        let pairs: Vec<&Pair> = pairs.map(|(_, pair)| pair).collect();
        for one in ForceQuantity::all(forces) {
            let name = one.name(forces);
            match one {
                ForceQuantity::Reaction(id, Part::Magnitude) => {
                    reactions.push(self.reaction(name, pairs[id.index()], found.of(id), units));
                }
                ForceQuantity::Shaking(Part::Magnitude) => shaking = name,
                ForceQuantity::Reaction(..) | ForceQuantity::Shaking(_) => {}
                ForceQuantity::Drive(driver) => {
                    let spec = &self.mechanism().spec().drivers[driver.index()];
                    let crank = matches!(spec, DriverSpec::Crank { .. });
                    let link = self.mechanism().spec().driven(spec).unwrap_or_default();
                    drives.push(DriveHere {
                        name,
                        link: link.to_owned(),
                        kind: if crank { "torque" } else { "force" },
                        value: found.drive(driver).map(|value| value * units.drive(crank)),
                    });
                }
            }
        }
        let applied = found.applied().iter().map(|one| {
            let (kind, index) = source(one.source);
            let force = one.force * units.force();
            AppliedHere {
                kind,
                index,
                link: self.mechanism().body_name(one.body).to_owned(),
                x: force.x,
                y: force.y,
                value: force.norm(),
                couple: one.couple * units.torque(),
            }
        });
        let (force, moment) = found.shaking(self.mechanism());
        let force = force * units.force();
        let rubs = !found.friction().is_empty();
        Ok(ForcesHere {
            reactions,
            drives,
            applied: applied.collect(),
            shaking: ShakingHere {
                name: shaking,
                value: force.norm(),
                direction: direction(force),
                moment: moment * units.torque(),
            },
            lost: rubs.then(|| found.loss() * units.torque()),
            efficiency: found.efficiency(forces.rates[0]),
        })
    }

    fn reaction(
        &self,
        name: String,
        pair: &Pair,
        reaction: &Reaction,
        units: ForceUnits,
    ) -> ReactionHere {
        let [on, from] = pair
            .bodies
            .map(|body| self.mechanism().body_name(body).to_owned());
        let [x, y] = reaction.force.map(|one| one.map(|one| one * units.force()));
        let vector = reaction.vector().map(|force| force * units.force());
        ReactionHere {
            name,
            pair: pair.name(self.mechanism()),
            kind: if pair.is_slide() {
                "slide"
            } else if pair.is_mesh() {
                "mesh"
            } else {
                "hinge"
            },
            on,
            from,
            x,
            y,
            moment: reaction.moment.map(|moment| moment * units.torque()),
            value: vector.map(|force| force.norm()),
            direction: vector.and_then(direction),
        }
    }

    /// The greatest magnitudes of reactions, of what drivers exert and of the shaking force, at steps of one degree
    /// over the motion.
    pub(crate) fn greatest_forces(&self) -> &GreatestForces {
        let forces = self.forces();
        forces.greatest.get_or_init(|| {
            let mut quantities = ForceQuantity::all(forces);
            quantities.retain(|one| one.is_greatest());
            let start = |one: &ForceQuantity| GreatestHere {
                name: one.name(forces),
                value: None,
                input: self.motion().drawn_input(),
            };
            let mut greatest: Vec<GreatestHere> = quantities.iter().map(start).collect();
            let mut found = Reactions::default();
            let mut pose = self.mechanism().blank::<3>();
            let (mut poses, mut locked) = (0, 0);
            for at in self.motion().rows(self.steps_of_forces()) {
                if self.motion().place(at.input, &mut pose).is_err() {
                    continue;
                }
                poses += 1;
                let Forces {
                    statics, loading, ..
                } = forces;
                let balanced = statics.balance(loading, &pose, at.input, forces.rates, &mut found);
                if let Err(why) = balanced {
                    locked += usize::from(why == Unbalanced::Locked);
                    continue;
                }
                for (one, most) in quantities.iter().zip(&mut greatest) {
                    let value = one.value(forces, &found);
                    let more = |value: &f64| most.value.is_none_or(|most| value.abs() > most.abs());
                    if let Some(value) = value.filter(more) {
                        (most.value, most.input) = (Some(value), at.input);
                    }
                }
            }
            GreatestForces {
                greatest,
                poses,
                locked,
            }
        })
    }

    fn steps_of_forces(&self) -> Grid {
        let [start, end] = self.motion().cycle().axis();
        if self.mechanism().turns() {
            Grid {
                unit: 1_f64.to_radians(),
                origin: 0.0,
                step: 1.0,
            }
        } else {
            Grid {
                unit: 1.0,
                origin: start,
                step: (end - start) / STEPS,
            }
        }
    }
}

/// Direction of a force, radians from the x-axis; None for a force of zero.
fn direction(force: Vector) -> Option<f64> {
    (force != Vector::zeros()).then(|| force.y.atan2(force.x))
}

fn source(source: Source) -> (&'static str, Option<usize>) {
    match source {
        Source::Weight => ("weight", None),
        Source::Inertia => ("inertia", None),
        Source::Load(index) => ("load", Some(index)),
        Source::Spring(index) => ("spring", Some(index)),
        Source::Damper(index) => ("damper", Some(index)),
        Source::Friction(index) => ("friction", Some(index)),
    }
}
