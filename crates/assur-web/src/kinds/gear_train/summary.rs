//! Summary of a differential: speeds, ratios, conditions, torques, and the end of a run.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use assur::dynamics::{Body, Halt};
use assur::gears::train::{
    Condition, Identity, Kind, Member, PointVelocity, Ratio, Relation, Shaft, Shafts, Suggestion,
    Train, Turning,
};
use assur_draw::TrainFigure;
use serde::Serialize;

use super::GearTrain;
use super::quantity::{BODIES, NUMBERS, Quantity};
use crate::summary::{CourseSummary, CycleSummary, ListedSummary};

/// Maximum number of suggested trains.
const SUGGESTED: usize = 5;

/// Upper limit of the load, as a multiple of the greatest static torque that the magnets hold on the free shaft.
const OVERLOAD: f64 = 1.5;

/// Summary of a differential. Speeds are in revolutions per minute, after all drives have reached full speed.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GearTrainSummary<'a> {
    #[serde(flatten)]
    course: CourseSummary<'a>,
    bounds: [f64; 4],
    roles: BTreeMap<&'static str, &'static str>,
    /// The shaft that is not driven.
    free: &'static str,
    speeds: BodyNumbers,
    /// Weights a and b in Willis's equation, a ω₁ + b ω₄ = (a + b) ω₃.
    weights: [i64; 2],
    ratios: Vec<RatioSummary>,
    identities: Vec<IdentitySummary>,
    conditions: Vec<TrainConditionSummary>,
    /// Whether all conditions are met.
    builds: bool,
    /// Similar trains that can be built; empty if this train can be built.
    suggestions: Vec<SuggestionSummary>,
    /// For a planar train: number of teeth z₂ of the satellite that fits between gears with these z₁ (sun) and z₄
    /// (ring), if there is one.
    in_contact: Option<u32>,
    mobility: MobilitySummary,
    /// Gaps between pitch circles of magnets at sun and ring, mm; null for gears in contact and bevel wheels.
    gaps: Option<[f64; 2]>,
    axis_distance: f64,
    /// Distances (mm) and velocities (mm/s) of points of the first satellite, at the final speeds of the shafts; null
    /// for bevel wheels.
    velocities: Option<VelocitySummary>,
    /// External torques on the shafts, neglecting losses, as multiples of the torque on the sun.
    #[serde(with = "ShaftNumbers")]
    #[cfg_attr(test, ts(as = "ShaftNumbers"))]
    torques: Shafts,
    /// Power that each shaft takes in: its value in `torques` times its speed in revolutions per minute.
    #[serde(with = "ShaftNumbers")]
    #[cfg_attr(test, ts(as = "ShaftNumbers"))]
    powers: Shafts,
    /// Greatest static torque that the magnets can hold on each body, N·m, with the other shafts held; for the
    /// satellites, on all of them together.
    limits: Option<BodyNumbers>,
    /// Natural frequencies of the meshes with sun and ring, Hz.
    swings: Option<[f64; 2]>,
    /// The greatest torque of the load, and its upper limit, N·m.
    load: Option<PullSummary>,
    /// Slips of the meshes with sun and ring at the end of a run, in periods of the field.
    slips: Option<[i64; 2]>,
    halt: Option<HaltSummary>,
}

/// A number for each body.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct BodyNumbers {
    sun: f64,
    satellite: f64,
    carrier: f64,
    ring: f64,
}

/// A number for each shaft.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(remote = "Shafts")]
pub(crate) struct ShaftNumbers {
    sun: f64,
    carrier: f64,
    ring: f64,
}

/// Ratio u = numerator/denominator of the speeds of links `of` and `to`, with link `held` held.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RatioSummary {
    name: String,
    of: u8,
    to: u8,
    held: u8,
    numerator: i64,
    denominator: i64,
    value: f64,
    /// Whether this is the largest positive ratio.
    largest: bool,
}

/// Names of two ratios, and their sum, which is 1.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct IdentitySummary {
    terms: [String; 2],
    sum: f64,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TrainConditionSummary {
    kind: &'static str,
    left: f64,
    relation: &'static str,
    right: f64,
    met: bool,
    /// Whether gears with profile shift could still meet the condition.
    shifted: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SuggestionSummary {
    z1: u32,
    z2: u32,
    z2_step: Option<u32>,
    z4: u32,
}

/// Numbers of links n and of pairs P₁ and P₂ with one and two freedoms, W by count, and number of passive constraints.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MobilitySummary {
    links: u32,
    one_freedom: u32,
    two_freedoms: u32,
    mobility: i64,
    passive: i64,
}

/// Points of the first satellite on the radius through its centre: distance from the main axis, and velocity.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct VelocitySummary {
    sun: [f64; 2],
    centre: [f64; 2],
    ring: [f64; 2],
    instantaneous_centre: Option<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PullSummary {
    value: f64,
    max: f64,
}

/// Early end of a run: its time, and the body that turned too fast.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct HaltSummary {
    body: &'static str,
    time: f64,
}

/// The greatest magnitude of the torque among the knots of a load; 0 if there are no knots.
pub(super) fn greatest(load: &[[f64; 2]]) -> f64 {
    load.iter()
        .map(|[_, torque]| torque.abs())
        .fold(0.0, f64::max)
}

impl<'a> GearTrainSummary<'a> {
    pub(crate) fn new(of: &'a GearTrain) -> Self {
        let GearTrain {
            document,
            course,
            figure,
        } = of;
        let train = &course.train;
        let (layout, coupling) = (&train.layout, train.coupling);
        let wheels = layout.train();
        let differential = wheels.differential();
        let speeds = train.turning.last_speeds();
        let last = train.turning.at(Turning::MAX_TIME).speeds;
        let in_radians = Shafts {
            sun: last[0],
            carrier: last[2],
            ring: last[3],
        };
        let torques = differential.torques_relative_to(Shaft::Sun);
        let powers = torques.powers(&speeds);
        let builds = layout.can_be_built(coupling);
        let suggestions = if builds {
            Vec::new()
        } else {
            layout.suggestions(coupling, SUGGESTED)
        };
        let counts = layout.counts();
        let meshes = assur::dynamics::Mesh::ALL;
        let limits = train.differential.as_ref();
        let free = train.turning.free();
        let roles = BODIES.into_iter().zip(TrainFigure::roles());
        let reading = course.last();
        Self {
            course: CourseSummary {
                moves: "time",
                input: "",
                cycle: CycleSummary {
                    start: 0.0,
                    end: course.end(),
                    full: !course.loaded(),
                    arcs: vec![[0.0, course.end()]],
                },
                home: 0.0,
                dead_points: Vec::new(),
                change_points: &[],
                unsearched: None,
                numbers: course.numbers(),
                listed: listed(course.loaded()),
                overviews: if course.loaded() {
                    &["angles", "load"]
                } else {
                    &["angles"]
                },
                plotted: course.plotted().iter().map(|one| one.name()).collect(),
                curves: course.curves().iter().map(|one| one.name()).collect(),
                handles: Vec::new(),
                traceable: false,
                becomes: &[],
            },
            bounds: figure.bounds(),
            roles: roles.map(|(name, role)| (name, role.name())).collect(),
            free: BODIES[free.index()],
            speeds: BodyNumbers {
                sun: speeds.sun,
                satellite: last[1] * 60.0 / TAU,
                carrier: speeds.carrier,
                ring: speeds.ring,
            },
            weights: [Shaft::Sun, Shaft::Ring].map(|shaft| differential.weight(shaft)),
            ratios: (differential.ratios().iter())
                .map(|ratio| RatioSummary::new(ratio, differential.is_largest(ratio)))
                .collect(),
            identities: differential.identities().map(IdentitySummary::new).into(),
            conditions: (layout.conditions(coupling).iter())
                .map(TrainConditionSummary::new)
                .collect(),
            builds,
            suggestions: suggestions.iter().map(SuggestionSummary::new).collect(),
            in_contact: in_contact(wheels),
            mobility: MobilitySummary {
                links: counts.links,
                one_freedom: counts.one_freedom,
                two_freedoms: counts.two_freedoms,
                mobility: counts.mobility(),
                passive: counts.passive(),
            },
            gaps: layout
                .gaps()
                .filter(|_| coupling == assur::gears::train::Coupling::Magnetic),
            axis_distance: layout.axis_distance(coupling),
            velocities: layout
                .velocities(coupling, &in_radians)
                .map(|found| VelocitySummary {
                    sun: of_point(found.sun),
                    centre: of_point(found.centre),
                    ring: of_point(found.ring),
                    instantaneous_centre: found.instantaneous_centre,
                }),
            torques,
            powers,
            limits: limits.map(|one| {
                let [sun, satellite, carrier, ring] = Body::ALL.map(|body| one.static_limit(body));
                BodyNumbers {
                    sun,
                    satellite,
                    carrier,
                    ring,
                }
            }),
            swings: limits.map(|one| meshes.map(|mesh| one.swing_rate(mesh) / TAU)),
            load: limits.map(|one| PullSummary {
                value: greatest(&document.load),
                max: OVERLOAD * one.static_limit(free.body()),
            }),
            slips: reading.map(|reading| reading.meshes.map(|mesh| mesh.slipped)),
            halt: course
                .halt()
                .map(|Halt::TooFast { body, time }| HaltSummary {
                    body: BODIES[body.index()],
                    time,
                }),
        }
    }
}

/// The quantities listed beside the drawing, whatever is plotted.
fn listed(loaded: bool) -> Vec<ListedSummary<'static>> {
    let one = |quantity: Quantity| ListedSummary {
        name: quantity.name(),
        what: match quantity {
            Quantity::Angle(_) => "angle",
            Quantity::LoadAngle(_) => "load_angle",
        },
        of: vec![BODIES[quantity.body()]],
        number: Some(NUMBERS[quantity.body()]),
        role: quantity.role().name(),
    };
    Quantity::all(loaded).map(one).collect()
}

fn in_contact(train: &Train) -> Option<u32> {
    if train.kind() != Kind::Planar {
        return None;
    }
    let [sun, ring] = [Member::Sun, Member::Ring].map(|member| f64::from(train.teeth(member)));
    let found = Train::in_contact([sun, ring]).ok()??;
    Some(found.teeth(Member::Satellite))
}

fn of_point(point: PointVelocity) -> [f64; 2] {
    [point.radius, point.velocity]
}

impl RatioSummary {
    fn new(ratio: &Ratio, largest: bool) -> Self {
        Self {
            name: ratio.to_string(),
            of: ratio.of.number(),
            to: ratio.to.number(),
            held: ratio.held.number(),
            numerator: ratio.numerator,
            denominator: ratio.denominator,
            value: ratio.value(),
            largest,
        }
    }
}

impl IdentitySummary {
    fn new(identity: Identity) -> Self {
        let (numerator, denominator) = identity.sum();
        Self {
            terms: identity.terms.map(|ratio| ratio.to_string()),
            sum: numerator as f64 / denominator as f64,
        }
    }
}

impl TrainConditionSummary {
    fn new(condition: &Condition) -> Self {
        Self {
            kind: condition.kind.code(),
            left: condition.left,
            relation: match condition.relation {
                Relation::Equal => "=",
                Relation::Greater => ">",
                Relation::Less => "<",
                Relation::Multiple => "multiple",
            },
            right: condition.right,
            met: condition.met(),
            shifted: condition.within_profile_shift(),
        }
    }
}

impl SuggestionSummary {
    fn new(suggestion: &Suggestion) -> Self {
        let train = &suggestion.train;
        let step = train.teeth(Member::Step);
        Self {
            z1: train.teeth(Member::Sun),
            z2: train.teeth(Member::Satellite),
            z2_step: (train.kind() == Kind::Stepped).then_some(step),
            z4: train.teeth(Member::Ring),
        }
    }
}
