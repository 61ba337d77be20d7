//! Synthesis of a four-bar for given positions on the page. The positions are drawn under one of the solutions.

pub(crate) mod options;
pub(crate) mod plane;
pub(crate) mod summary;
pub(crate) mod wanted;

use std::f64::consts::PI;

use assur::mechanism::Quantity;
use assur::synthesis::four_bar::{Drawn, Options, Proportions};
use assur::{Point, Relation, Vector};
use assur_draw::{Annotations, GivenPosition, Role};
use assur_file::{Document, LinkageProblem, Moved, Problem, State, SynthesisDocument};
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::handle::{Handle, HandlePlace};
use crate::moving::Moving;
use summary::SynthesisSummary;

/// Distance of an angle's handle from the pivot of its link: the greater of these fractions of the frame and of the
/// link. The handle is then clear of the link's joint.
const HANDLE_DISTANCE: [f64; 2] = [0.62, 1.25];

/// Distance of a coupler's handle from the coupler's joint with the input: the greater of these fractions of the frame
/// and of the coupler. The handle is then clear of both ends.
const REACH_OF_COUPLER: [f64; 2] = [0.25, 0.6];

/// Step of a dragged direction, degrees. A hand cannot set an angle more precisely.
const STEP_DEG: f64 = 0.1;

/// The links and their colours.
const ROLES: [(&str, Role); 3] = [
    ("crank", Role::Crank),
    ("coupler", Role::Coupler),
    ("rocker", Role::Rocker),
];

/// The links, and the numbers of their angles in the paper.
const NUMBERS: [(&str, &str); 3] = [("crank", "3"), ("coupler", "1"), ("rocker", "2")];

pub(crate) struct Synthesis {
    document: SynthesisDocument,
    solved: assur_file::Synthesis,
    /// The shown solution, as a linkage document for the simulator.
    linkage: Document,
    moving: Moving,
}

/// A direction that can be dragged: its link, and the index of its position.
#[derive(Clone, Copy)]
enum Direction {
    Output(usize),
    Input(usize),
    Coupler(usize),
}

impl Direction {
    /// All given directions, each with its pivot and handle. A coupler has a direction only if the document gives it.
    fn all<'a>(
        document: &'a SynthesisDocument,
        solved: &'a assur_file::Synthesis,
    ) -> impl Iterator<Item = (Self, [Point; 2])> + 'a {
        let frame = solved.task.frame();
        let along = move |angle: f64| Vector::new(angle.cos(), angle.sin()) * frame.length;
        let [a, d] = [Point::origin(), Point::origin() + along(frame.angle)];
        let Proportions {
            output,
            input,
            coupler,
        } = solved.shown.proportions;
        let [far_output, far_input] =
            [output, input].map(|z| HANDLE_DISTANCE[0].max(HANDLE_DISTANCE[1] * z));
        let far_coupler = REACH_OF_COUPLER[0].max(REACH_OF_COUPLER[1] * coupler);
        let positions = solved.task.positions().iter().zip(&document.positions);
        positions
            .enumerate()
            .flat_map(move |(k, (position, saved))| {
                let input = [a, a + along(position.input) * far_input];
                let output = [d, d - along(position.output) * far_output];
                let drawn = solved.shown.drawn(&solved.task, k).zip(saved.coupler_deg);
                let coupler = drawn.map(|(drawn, angle)| {
                    let tip = drawn.b + along(angle.to_radians()) * far_coupler;
                    (Self::Coupler(k), [drawn.b, tip])
                });
                let both = [(Self::Input(k), input), (Self::Output(k), output)];
                both.into_iter().chain(coupler)
            })
    }

    fn name(self) -> String {
        match self {
            Self::Output(k) => format!("output{}", k + 1),
            Self::Input(k) => format!("input{}", k + 1),
            Self::Coupler(k) => format!("coupler{}", k + 1),
        }
    }

    fn role(self) -> Role {
        match self {
            Self::Output(_) => Role::Rocker,
            Self::Input(_) => Role::Crank,
            Self::Coupler(_) => Role::Coupler,
        }
    }
}

impl Synthesis {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &SynthesisDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let solved = document.synthesis()?;
        let moved = Moved::new(solved.drawn()?, &state.view.plot)?;
        let annotations = Annotations {
            roles: ROLES.map(|(link, role)| (link.to_owned(), role)).to_vec(),
            numbers: NUMBERS
                .map(|both| (both.0.to_owned(), both.1.to_owned()))
                .to_vec(),
            input: Some("φ₃".to_owned()),
            given: given(document, &solved),
            ..Annotations::default()
        };
        let quantities = Quantity::all(moved.motion.mechanism());
        let explain =
            |mechanism: &_, unsolved: &_| LinkageProblem::unsolved(unsolved, mechanism).into();
        let handles = Direction::all(document, &solved).map(|(direction, [_, tip])| Handle {
            name: direction.name(),
            role: direction.role().name(),
            at: HandlePlace::Fixed(tip),
        });
        let moving = Moving::new(
            &state.view,
            moved,
            annotations,
            quantities,
            Box::new(explain),
        )?;
        let moving = moving.held_by(handles);
        Ok(Self {
            document: document.clone(),
            linkage: Document::Linkage(solved.linkage()?),
            moving,
            solved,
        })
    }
}

/// Draws the shown solution in each given position, with its gap at the coupler.
fn given(document: &SynthesisDocument, solved: &assur_file::Synthesis) -> Vec<GivenPosition> {
    let (task, shown) = (&solved.task, &solved.shown);
    let drawn = (0..task.positions().len()).filter_map(|k| shown.drawn(task, k));
    let position = |(k, at): (usize, Drawn)| GivenPosition {
        number: (k + 1).to_string(),
        directions: Vec::new(),
        links: vec![
            ([at.a, at.b], Role::Crank),
            ([at.b, at.coupler_end], Role::Coupler),
            ([at.d, at.c], Role::Rocker),
        ],
    };
    let mut all: Vec<GivenPosition> = drawn.enumerate().map(position).collect();
    for (direction, ends) in Direction::all(document, solved) {
        let (Direction::Output(k) | Direction::Input(k) | Direction::Coupler(k)) = direction;
        all[k].directions.push((ends, direction.role()));
    }
    all
}

impl Capabilities for Synthesis {
    fn summary(&self) -> JsValue {
        to_js(&SynthesisSummary::new(
            &self.document,
            &self.solved,
            &self.linkage,
            &self.moving,
        ))
    }

    fn linkage(&self) -> Option<&Moving> {
        Some(&self.moving)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }

    fn relations(&self, _input: f64) -> Result<Vec<Relation>, Problem> {
        let assur_file::Synthesis { task, shown, .. } = &self.solved;
        Ok(wanted::formulas(&self.document, task, shown))
    }
}

impl Edited for Synthesis {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        let mechanism = self.moving.mechanism();
        if let Some(driven) = mechanism.point(point) {
            let to = self.moving.driven_to(driven, input, to);
            return to.unwrap_or_else(|| Err(unknown(point))).map(Change::input);
        }
        let mut directions = Direction::all(&self.document, &self.solved);
        let found = directions.find(|(direction, _)| direction.name() == point);
        let (direction, [pivot, _]) = found.ok_or_else(|| unknown(point))?;
        let along = to - pivot;
        let angle = along.y.atan2(along.x);
        let mut positions = self.document.positions.clone();
        match direction {
            Direction::Input(k) => positions[k].input_deg = degrees(angle),
            Direction::Output(k) => positions[k].output_deg = degrees(angle + PI),
            Direction::Coupler(k) => positions[k].coupler_deg = Some(degrees(angle)),
        }
        Ok(Change::document(&json!({ "positions": positions })))
    }

    /// Sets the output's length, which is the only dimension and selects a member of a family.
    fn set(&self, field: &str, value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        let Options::Family(family) = &self.solved.options else {
            return Err(vec![unknown(field)]);
        };
        if field != "output" {
            return Err(vec![unknown(field)]);
        }
        let length = self.solved.task.frame().length;
        let range = family.output_range();
        let found = family.with_output(value / length).map_err(|_| {
            vec![Problem::OutOfRange {
                field: "output".into(),
                value,
                min: range.from * length,
                max: range.to.map_or(f64::MAX, |to| to * length),
            }]
        })?;
        let member = [value, found.proportions.input * length];
        Ok(Change::document(
            &json!({ "member": member, "trial": null }),
        ))
    }
}

/// Converts an angle to degrees from 0° to 360°, rounded to the step of a drag.
fn degrees(angle: f64) -> f64 {
    let steps = (angle.to_degrees().rem_euclid(360.0) / STEP_DEG).round();
    (steps / STEP_DEG.recip()).rem_euclid(360.0)
}
