//! The mixer on the page: a linkage described by its parameters.

use assur::gears::GearPair;
use assur::mechanism::{LinkId, Mechanism, Quantity, Unsolved};
use assur::mixer::{Dragged, Joint, Mixer as Parameters, Tracer};
use assur::{Assembly, Point, Pose, Relation};
use assur_draw::Annotations;
use assur_file::{
    LinkageDocument, LinkageProblem, MixerDocument, MixerTracerDocument, Problem, State,
};
use serde::Serialize;
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::assemblies::AssembliesHere;
use crate::capabilities::{Capabilities, Edited, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::moving::Moving;
use crate::summary::MotionSummary;

pub(crate) struct Mixer {
    parameters: Parameters,
    moving: Moving,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MixerSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    /// Speed ratios of the peripheral wheels to the rocker.
    ratios: Vec<f64>,
    /// Pairs of peripheral wheels that would overlap, as indices from 0.
    overlaps: Vec<[usize; 2]>,
    /// Direction from wheel 4 in which another wheel has the most room, radians.
    free_direction: f64,
}

/// Lengths and assembly number after a joint is dragged; `l2` and `l4` are none if the drag does not change them.
#[derive(Serialize)]
struct Lengths {
    #[serde(skip_serializing_if = "Option::is_none")]
    l2: Option<f64>,
    l3: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    l4: Option<f64>,
    assembly: u8,
}

/// The change of the traced points after one of them was added or moved.
fn retraced(tracers: &[Tracer]) -> Change {
    let tracers = tracers.iter().map(Into::into);
    let tracers: Vec<MixerTracerDocument> = tracers.collect();
    Change::document(&json!({ "tracers": tracers }))
}

impl Mixer {
    pub(crate) fn new(state: &State, document: &MixerDocument) -> Result<Self, Vec<Problem>> {
        let moved = state.moved()?;
        let parameters = document.mixer()?;
        let linkage = parameters.linkage;
        let assembly = parameters.assembly;
        // For a four-bar, the reason can be more precise than "two links do not meet".
        let explain = move |mechanism: &Mechanism, unsolved: &Unsolved| match linkage
            .pose::<3>(assembly, unsolved.input)
        {
            Err(closed) => closed.into(),
            Ok(_) => LinkageProblem::unsolved(unsolved, mechanism).into(),
        };
        let annotations = Annotations::from(&parameters);
        let quantities = readouts(&moved.document, moved.motion.mechanism());
        let angles = quantities.iter().filter_map(|one| match one {
            Quantity::Angle(link) => Some(*link),
            _ => None,
        });
        let angles: Vec<LinkId> = angles.collect();
        let moving = Moving::new(
            &state.view,
            moved,
            annotations,
            quantities,
            Box::new(explain),
        )?;
        let moving = moving.listing(angles.into_iter());
        Ok(Self { parameters, moving })
    }

    fn pose(&self, input: f64) -> Result<Pose<1>, Problem> {
        let Parameters {
            linkage, assembly, ..
        } = &self.parameters;
        Ok(linkage.pose(*assembly, input)?)
    }
}

/// Number of an assembly in the document.
fn number_of(assembly: Assembly) -> u8 {
    match assembly {
        Assembly::First => 1,
        Assembly::Second => 2,
    }
}

/// Read-outs of a mixer: all quantities except coordinates of frame points, and except the angles of the crank and of
/// links fixed to another link.
fn readouts(document: &LinkageDocument, mechanism: &Mechanism) -> Vec<Quantity> {
    let driven = document
        .drivers
        .iter()
        .filter_map(|driver| driver.crank.as_ref());
    let driven: Vec<&String> = driven.collect();
    let links = document.links.iter();
    let idle = links.filter(|link| link.fixed_to.is_some() || driven.contains(&&link.name));
    let still: Vec<String> = idle
        .map(|link| format!("{}.angle", link.name))
        .chain(
            document
                .frame
                .iter()
                .flat_map(|point| [format!("{point}.x"), format!("{point}.y")]),
        )
        .collect();
    let mut quantities = Quantity::all(mechanism);
    quantities.retain(|one| !still.contains(&one.name(mechanism, 0)));
    quantities
}

impl Capabilities for Mixer {
    fn summary(&self) -> JsValue {
        let gears = &self.parameters.gears;
        to_js(&MixerSummary {
            motion: MotionSummary::new(&self.moving),
            ratios: gears.pairs().iter().map(GearPair::ratio).collect(),
            overlaps: gears.overlaps(),
            free_direction: gears.free_direction(),
        })
    }

    fn linkage(&self) -> Option<&Moving> {
        Some(&self.moving)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn relations(&self, input: f64) -> Result<Vec<Relation>, Problem> {
        Ok(self.parameters.relations(input)?)
    }
}

impl Edited for Mixer {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        let mixer = &self.parameters;
        let joint = match point {
            "B" => Joint::B,
            "C" => Joint::C,
            "D" => Joint::D,
            other => {
                let traced = mixer.tracers().iter().enumerate();
                let mut traced = traced.filter(|(k, _)| other == format!("P{}", k + 1));
                let (index, tracer) = traced.next().ok_or_else(|| unknown(other))?;
                let moved = mixer.tracer_at(&self.pose(input)?, tracer.carrier, to);
                let mut tracers = mixer.tracers().to_vec();
                tracers[index] = moved;
                return Ok(retraced(&tracers));
            }
        };
        Ok(match mixer.dragged(joint, input, to)? {
            Dragged::Crank(input) => Change::input(input),
            Dragged::Lengths {
                lengths: [_, l2, l3, l4],
                assembly,
            } => Change::document(&Lengths {
                l2: (joint == Joint::C).then_some(l2),
                l3,
                l4: (joint == Joint::D).then_some(l4),
                assembly: number_of(assembly),
            }),
        })
    }

    fn assemblies(&self, input: f64) -> Option<AssembliesHere> {
        let mut here = self.moving.assemblies(input);
        let drawn = usize::from(number_of(self.parameters.assembly));
        // A dyad has only two assemblies, numbered 1 and 2.
        if let Some(shown) = here.shown {
            for (k, one) in here.all.iter_mut().enumerate() {
                one.number = if k == shown { drawn } else { 3 - drawn };
            }
        }
        Some(here)
    }

    fn assemble(&self, number: usize, _input: f64) -> Result<Change, Vec<Problem>> {
        let mut all = Assembly::ALL.map(number_of).into_iter();
        let assembly = all.find(|one| usize::from(*one) == number);
        let assembly = assembly.ok_or_else(|| vec![unknown("assembly")])?;
        Ok(Change::document(&json!({ "assembly": assembly })))
    }

    fn trace(&self, input: f64, at: Point) -> Result<Change, Problem> {
        let pose = self.moving.pose(input)?;
        let link = self.moving.figure().link_at(&pose, at);
        let carrier = link.and_then(|(link, _)| {
            MixerTracerDocument::carrier(self.moving.mechanism().link_name(link))
        });
        let carrier = carrier.ok_or_else(|| unknown("tracer"))?;
        let mut tracers = self.parameters.tracers().to_vec();
        tracers.push(self.parameters.tracer_at(&self.pose(input)?, carrier, at));
        Ok(retraced(&tracers))
    }
}
