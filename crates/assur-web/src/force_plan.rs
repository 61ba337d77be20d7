//! Force plans, Zhukovsky's lever and free bodies of a linkage at an input, as drawings and as equations.

use assur::forces::{Acting, Cause, Component, ForceName, Lever, PlanStep, Reactions, StepKind};
use assur::mechanism::BodyId;
use assur::motion::{Sampling, Shown, Spacing};
use assur_draw::{
    ForcePicture, FrictionCircle, PlanRooms, force_symbol, free_body_picture, lever_picture,
    plan_picture,
};
use assur_file::{ForceUnits, LinkageProblem, Problem};
use serde::Serialize;

use crate::forces::{Forces, friction_circle};
use crate::moving::Moving;

/// Sampling of the motion for the scales of the plans.
const SAMPLING: Sampling = Sampling {
    turn: 48,
    coarsest: 24,
    most: 8 * 48,
    spacing: Spacing::Middles,
    shown: Shown::Spread,
};

/// Construction of the reactions, step by step. Forces are in newtons, torques in newton metres.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForcePlanHere {
    /// False if nothing acts on the links, so that there is nothing to draw.
    loaded: bool,
    steps: Vec<ForceStepHere>,
    /// Picture of the last of the requested steps: its plan with the steps before it or, for a sum of moments, its links.
    picture: ForcePictureHere,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForcePictureHere {
    /// Display list.
    list: Vec<f32>,
    /// Names to which the labels of the list refer.
    names: Vec<String>,
    /// Rectangle of the picture in the coordinates of `list`: left, bottom, right, top.
    bounds: [f64; 4],
    /// Force that a unit of these coordinates stands for in a plan to scale; null for a drawing of links.
    scale: Option<f64>,
}

/// A step: a sum of moments, of components along a line, or of forces.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForceStepHere {
    #[cfg_attr(
        test,
        ts(type = "\"moments\" | \"along\" | \"polygon\" | \"group\" | \"indeterminate\"")
    )]
    kind: &'static str,
    /// Number of the plan in which the step is drawn.
    plan: usize,
    /// Numbers of the links in equilibrium.
    links: Vec<String>,
    /// Name of the pair about which moments are taken, or of the slide along whose line components are taken.
    about: Option<String>,
    terms: Vec<ForceTermHere>,
    /// Symbols of what is statically indeterminate.
    open: Vec<String>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForceTermHere {
    symbol: String,
    couple: bool,
    /// False if this step finds it.
    known: bool,
    /// Magnitude of the force, or the couple.
    size: f64,
    /// Direction of the force from the x-axis, radians.
    direction: f64,
    /// Moment, or component along the line.
    value: f64,
    /// Arm of the force, in the unit of lengths; null if there is none.
    arm: Option<f64>,
}

/// Zhukovsky's lever. Moments are those of the velocities at the unit rate of the input: torques at a crank, forces at a
/// driven slide.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LeverHere {
    terms: Vec<ForceTermHere>,
    /// Sum of the moments about the pole.
    sum: f64,
    /// Symbol of the balancing torque or force.
    symbol: String,
    /// Whether a torque balances the lever, not a force.
    turns: bool,
    /// Balancing torque or force by the lever; null if there are several drivers.
    by_lever: Option<f64>,
    /// The same by the reactions; null if it is indeterminate.
    by_reactions: Option<f64>,
    picture: ForcePictureHere,
}

/// All forces and couples on a link.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FreeBodyHere {
    /// Numbers and names of the links that can be chosen.
    links: Vec<(String, String)>,
    acting: Vec<ActingHere>,
    picture: ForcePictureHere,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ActingHere {
    symbol: String,
    couple: bool,
    /// Components of the force; null if indeterminate, and for a couple.
    x: Option<f64>,
    y: Option<f64>,
    /// Magnitude of the force, or the couple; null if indeterminate.
    size: Option<f64>,
    /// Direction of the force from the x-axis, radians.
    direction: Option<f64>,
}

impl Moving {
    /// The force plan at an input; its picture shows the step `shown`, from 1.
    ///
    /// # Errors
    /// Those of [`Self::balanced`].
    pub(crate) fn force_plan(
        &self,
        input: f64,
        shown: usize,
    ) -> Result<ForcePlanHere, Vec<Problem>> {
        let (pose, found) = self.balanced(input)?;
        let mechanism = self.mechanism();
        let plan = self.forces().statics.plan(&found);
        let plan = plan.map_err(|why| vec![LinkageProblem::unbalanced(why, mechanism).into()])?;
        let numbers = |body: BodyId| self.body_number(body);
        let units = self.forces().units;
        let rooms = self.forces().rooms.get_or_init(|| self.plan_rooms());
        let picture = plan_picture(mechanism, &pose, (&plan, rooms), shown, &numbers);
        let steps = plan.steps.iter().map(|step| self.force_step(step, units));
        Ok(ForcePlanHere {
            loaded: is_loaded(&found),
            steps: steps.collect(),
            picture: here(picture, units),
        })
    }

    fn plan_rooms(&self) -> PlanRooms {
        let mut plans = Vec::new();
        self.each_balanced(SAMPLING, |_, found| {
            plans.extend(self.forces().statics.plan(found).ok());
        });
        PlanRooms::over(&plans)
    }

    /// Zhukovsky's lever at an input.
    ///
    /// # Errors
    /// Those of [`Self::balanced`].
    pub(crate) fn force_lever(&self, input: f64) -> Result<LeverHere, Vec<Problem>> {
        let (pose, found) = self.balanced(input)?;
        let mechanism = self.mechanism();
        let lever = Lever::new(mechanism, &pose, &found);
        let numbers = |body: BodyId| self.body_number(body);
        let units = self.forces().units;
        let turns = mechanism.turns();
        let drive = units.drive(turns);
        let terms = lever.terms.iter().map(|term| {
            let is_couple = term.couple != 0.0;
            let name = whole(term.body, term.cause);
            let size = term.force.norm();
            ForceTermHere {
                symbol: force_symbol(&name, is_couple, &numbers),
                couple: is_couple,
                known: true,
                size: if is_couple {
                    term.couple * units.torque()
                } else {
                    size * units.force()
                },
                direction: term.force.y.atan2(term.force.x),
                value: term.moment * drive,
                arm: (!is_couple).then(|| term.moment / size),
            }
        });
        let spec = mechanism.spec();
        let driven = spec.drivers.first().and_then(|driver| spec.driven(driver));
        let body = driven.and_then(|link| mechanism.link(link));
        let body = mechanism.body_of(body);
        let first = self.forces().statics.drivers().next();
        let symbol = first.map(|driver| {
            let from = BodyId::FRAME;
            force_symbol(&whole(body, Cause::Drive { driver, from }), turns, &numbers)
        });
        let by_reactions = first.and_then(|first| found.drive(first));
        Ok(LeverHere {
            sum: lever.sum * drive,
            symbol: symbol.unwrap_or_default(),
            turns,
            by_lever: lever.balancing.map(|value| value * drive),
            by_reactions: by_reactions.map(|value| value * drive),
            terms: terms.collect(),
            picture: here(lever_picture(mechanism, &pose, &lever, &numbers), units),
        })
    }

    /// The free body of a moving link at an input, by its place in the list of moving bodies, from 0.
    ///
    /// # Errors
    /// Those of [`Self::balanced`].
    pub(crate) fn free_body(
        &self,
        input: f64,
        chosen: usize,
    ) -> Result<FreeBodyHere, Vec<Problem>> {
        let (pose, found) = self.balanced(input)?;
        let mechanism = self.mechanism();
        let numbers = |body: BodyId| self.body_number(body);
        let units = self.forces().units;
        let mut moving = mechanism.bodies().skip(1);
        let links = moving.clone().map(|body| {
            let name = mechanism.body_name(body).to_owned();
            (numbers(body), name)
        });
        let links = links.collect();
        let (mut acting, mut picture) = (Vec::new(), None);
        if let Some(body) = moving.nth(chosen) {
            let all = self.forces().statics.free_body(&found, body);
            let circles = self.friction_circles(&found, body);
            let drawn = free_body_picture(mechanism, &pose, body, &all, &circles, &numbers);
            picture = Some(here(drawn, units));
            for one in &all {
                self.act((body, one), units, &mut acting);
            }
        }
        Ok(FreeBodyHere {
            links,
            acting,
            picture: picture.unwrap_or(ForcePictureHere {
                list: Vec::new(),
                names: Vec::new(),
                bounds: [0.0, 0.0, 1.0, 1.0],
                scale: None,
            }),
        })
    }

    /// Friction circles of the hinges of a body, with the couples on it.
    fn friction_circles(&self, found: &Reactions, body: BodyId) -> Vec<FrictionCircle> {
        let Forces {
            statics, loading, ..
        } = self.forces();
        let pairs = statics.pairs().filter_map(|(pair, of)| {
            let (radius, couple) = friction_circle(loading, found, pair)?;
            let sign = match of.bodies {
                [on, _] if on == body => 1.0,
                [_, from] if from == body => -1.0,
                _ => return None,
            };
            let couple = sign * couple;
            Some(FrictionCircle {
                pair,
                radius,
                couple,
            })
        });
        pairs.collect()
    }

    fn act(&self, (body, one): (BodyId, &Acting), units: ForceUnits, list: &mut Vec<ActingHere>) {
        let numbers = |body: BodyId| self.body_number(body);
        let name = whole(body, one.cause);
        if one.force != Some(assur::Vector::zeros()) {
            let force = one.force.map(|force| force * units.force());
            list.push(ActingHere {
                symbol: force_symbol(&name, false, &numbers),
                couple: false,
                x: force.map(|force| force.x),
                y: force.map(|force| force.y),
                size: force.map(|force| force.norm()),
                direction: force.map(|force| force.y.atan2(force.x)),
            });
        }
        if one.couple != Some(0.0) {
            list.push(ActingHere {
                symbol: force_symbol(&name, true, &numbers),
                couple: true,
                x: None,
                y: None,
                size: one.couple.map(|couple| couple * units.torque()),
                direction: None,
            });
        }
    }

    fn force_step(&self, step: &PlanStep, units: ForceUnits) -> ForceStepHere {
        let numbers = |body: BodyId| self.body_number(body);
        let unit = match step.kind {
            StepKind::Along => units.force(),
            _ => units.torque(),
        };
        let terms = step.terms.iter().map(|term| ForceTermHere {
            symbol: force_symbol(&term.name, term.is_couple, &numbers),
            couple: term.is_couple,
            known: term.known,
            size: if term.is_couple {
                term.value * units.torque()
            } else {
                term.force.norm() * units.force()
            },
            direction: term.force.y.atan2(term.force.x),
            value: term.value * unit,
            arm: term.arm(),
        });
        let about = step.about.and_then(|pair| {
            let mut pairs = self.forces().statics.pairs();
            let (_, pair) = pairs.find(|(id, _)| *id == pair)?;
            Some(pair.name(self.mechanism()))
        });
        let open = step.open.iter();
        ForceStepHere {
            kind: match step.kind {
                StepKind::Moments => "moments",
                StepKind::Along => "along",
                StepKind::Polygon => "polygon",
                StepKind::Group => "group",
                StepKind::Indeterminate => "indeterminate",
            },
            plan: step.plan,
            links: step.bodies.iter().map(|body| numbers(*body)).collect(),
            about,
            terms: terms.collect(),
            open: open
                .map(|name| force_symbol(name, false, &numbers))
                .collect(),
        }
    }
}

fn whole(body: BodyId, cause: Cause) -> ForceName {
    let part = Component::Whole;
    ForceName { body, cause, part }
}

fn is_loaded(found: &Reactions) -> bool {
    let mut applied = found.applied().iter();
    applied.any(|one| one.force != assur::Vector::zeros() || one.couple != 0.0)
}

pub(crate) fn here(picture: ForcePicture, units: ForceUnits) -> ForcePictureHere {
    ForcePictureHere {
        list: picture.list.numbers().to_vec(),
        names: picture.names,
        bounds: picture.bounds,
        scale: picture.is_plan.then(|| units.force()),
    }
}
