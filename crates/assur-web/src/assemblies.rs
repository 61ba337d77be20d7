//! All assemblies of a document: their poses at an input and, found in a worker of the page, all their motions.

use std::f64::consts::{PI, TAU};

use assur::circuits::{Branch, Circuits, Meeting, Reach};
use assur::mechanism::{Assemblies, LinkId, Pose};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::capabilities::Capabilities;
use crate::convert::{read, thrown, to_js};
use crate::kinds::open;
use crate::moving::Moving;
use crate::simulator::{bad, one};

/// All assemblies at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AssembliesHere {
    /// Assemblies in ascending order of `angle`.
    pub(crate) all: Vec<AssemblyHere>,
    /// Index of the assembly in which the document moves; none if the document has no pose at this input, or if this
    /// assembly was not found.
    pub(crate) shown: Option<usize>,
    /// Number of all solutions, real and complex, of the Assur group that was solved over the complex numbers. It is
    /// given only if exactly one such group was solved, and only once.
    complex: Option<usize>,
    /// Whether all assemblies were found.
    whole: bool,
}

/// An assembly at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AssemblyHere {
    /// Number by which the page shows and chooses the assembly. A mixer has its own numbering.
    pub(crate) number: usize,
    /// Angle of the link by which assemblies are numbered, in [0, 2π); 0 if there is no such link.
    angle: f64,
    /// Poses of the bodies, in the format of a frame of the animation.
    bodies: Vec<f32>,
}

impl Moving {
    /// The link whose angle numbers the assemblies.
    pub(crate) fn numbering(&self) -> Option<LinkId> {
        self.document().output(self.mechanism())
    }

    /// Finds all assemblies at an input, in order of number, and the index of the one in which the document moves.
    pub(crate) fn assembled(&self, input: f64) -> (Assemblies, Option<usize>) {
        let mechanism = self.mechanism();
        let following = &mut *self.following().borrow_mut();
        let found = match self.numbering() {
            Some(output) => following.numbered(self.motion(), input, output),
            None => following.at(input),
        };
        let shown = self.motion().pose(input).ok();
        let shown = shown.and_then(|pose| mechanism.number_of(&pose, &found.poses));
        (found, shown)
    }

    /// All assemblies at an input, for the page.
    pub(crate) fn assemblies(&self, input: f64) -> AssembliesHere {
        let (found, shown) = self.assembled(input);
        let numbering = self.numbering();
        let mechanism = self.mechanism();
        let angle = |pose| numbering.map_or(0.0, |link| mechanism.folded_angle(pose, link));
        let all = found.poses.iter().enumerate();
        let all = all.map(|(k, pose)| AssemblyHere {
            number: k + 1,
            angle: angle(pose),
            bodies: self.figure().bodies(pose),
        });
        AssembliesHere {
            all: all.collect(),
            shown,
            complex: match found.complex[..] {
                [complex] => Some(complex),
                _ => None,
            },
            whole: found.whole,
        }
    }
}

/// The motions of a document in all assemblies. The page finds them in a worker, since this takes time.
#[wasm_bindgen]
pub struct AllMotions {
    document: Box<dyn Capabilities>,
    circuits: Circuits,
}

/// Curves of the output against the input, for all branches.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MotionsMap {
    /// Name of the link whose angle numbers the assemblies.
    output: String,
    branches: Vec<BranchLine>,
    meetings: Vec<MeetingPlace>,
    circuits: usize,
    /// Whether all branches were found and each was followed to its ends.
    whole: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct BranchLine {
    /// Index of the branch's circuit.
    circuit: usize,
    /// Curve, split where the input or the output wraps. Inputs and outputs alternate. Angles are in [0, 2π); the input
    /// of a slide is a displacement.
    pieces: Vec<Vec<f64>>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MeetingPlace {
    #[cfg_attr(test, ts(type = "\"fold\" | \"crossing\""))]
    kind: &'static str,
    branches: [usize; 2],
    input: f64,
    output: f64,
}

/// Branches of the assemblies at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Belonging {
    /// For each assembly, in the order of their numbers, the index of its branch.
    branches: Vec<usize>,
    /// For each assembly, indices of the meetings of branches on the way to it from the chosen assembly. Empty if both
    /// are on the same branch; null if the assembly cannot be reached.
    reached: Vec<Option<Vec<usize>>>,
}

/// Number of sampling steps along a branch, per turn of a crank or per arc of a driven slide.
const STEPS: f64 = 240.0;
/// Minimum number of sampling steps along an arc of a branch.
const MIN_STEPS: f64 = 24.0;

#[wasm_bindgen]
impl AllMotions {
    /// Finds all motions of the document in a state.
    ///
    /// # Errors
    /// Every problem of the state; a document without a moving linkage, or without a link to number its assemblies.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
    ) -> Result<Self, JsValue> {
        let document = open(&read(&state)?).map_err(thrown)?;
        let none = || one(bad("", "no linkage moves"));
        let moving = document.linkage().ok_or_else(none)?;
        let output = moving.numbering().ok_or_else(none)?;
        let circuits = Circuits::of(moving.mechanism(), output);
        Ok(Self { document, circuits })
    }

    /// Returns the map of all branches: `{output, branches: [{circuit, pieces}], meetings: [{kind, branches, input,
    /// output}], circuits, whole}`.
    #[wasm_bindgen(unchecked_return_type = "MotionsMap")]
    pub fn map(&self) -> JsValue {
        let Some(moving) = self.document.linkage() else {
            return JsValue::NULL;
        };
        let branches = self.circuits.branches().iter();
        let branches = branches.map(|branch| BranchLine {
            circuit: branch.circuit,
            pieces: self.pieces(moving, branch),
        });
        let meetings = self.circuits.meetings().iter();
        to_js(&MotionsMap {
            output: moving
                .mechanism()
                .link_name(self.circuits.output())
                .to_owned(),
            branches: branches.collect(),
            meetings: meetings.filter_map(|one| self.place(moving, one)).collect(),
            circuits: self.circuits.count(),
            whole: self.circuits.is_whole(),
        })
    }

    /// Returns the branches of the assemblies at an input, and the way to each assembly from the one with index
    /// `number`: `{branches, reached}`. Both lists are empty if any assembly is on no known branch.
    #[wasm_bindgen(unchecked_return_type = "Belonging")]
    pub fn belonging(&self, input: f64, number: usize) -> JsValue {
        let branches = self.branches_at(input).unwrap_or_default();
        let reached = branches.iter().map(|to| {
            let from = *branches.get(number)?;
            match self.circuits.reach(from, *to) {
                Reach::SameBranch => Some(Vec::new()),
                Reach::SameCircuit(through) => Some(through),
                Reach::OtherCircuit => None,
            }
        });
        let reached = reached.collect();
        to_js(&Belonging { branches, reached })
    }
}

impl AllMotions {
    /// The branch of each assembly at an input, in order of number; none if an assembly is on no known branch.
    fn branches_at(&self, input: f64) -> Option<Vec<usize>> {
        let moving = self.document.linkage()?;
        let mechanism = moving.mechanism();
        let on_branches = self.circuits.at(input);
        let poses: Vec<Pose<1>> = on_branches.iter().map(|one| one.pose.clone()).collect();
        let (all, _) = moving.assembled(input);
        let branch = |pose| Some(on_branches[mechanism.number_of(pose, &poses)?].branch);
        all.poses.iter().map(branch).collect()
    }

    fn pieces(&self, moving: &Moving, branch: &Branch) -> Vec<Vec<f64>> {
        let cycle = branch.motion.cycle();
        let turns = moving.mechanism().turns();
        let mut pieces: Vec<Vec<f64>> = Vec::new();
        for arc in cycle.arcs() {
            let [from, to] = *arc;
            let unit = if turns { TAU } else { to - from };
            let steps = (STEPS * (to - from) / unit).max(MIN_STEPS).round();
            let mut last: Option<[f64; 2]> = None;
            for step in 0..=steps as usize {
                let part = step as f64 / steps;
                // Near a fold the output varies as the square root of the input's distance from it. More samples are
                // therefore taken near the ends of the arc.
                let part = if cycle.is_full() {
                    part
                } else {
                    0.5 - 0.5 * (PI * part).cos()
                };
                let input = from + part * (to - from);
                let Ok(pose) = branch.motion.pose::<1>(input) else {
                    last = None;
                    continue;
                };
                let output = moving
                    .mechanism()
                    .folded_angle(&pose, self.circuits.output());
                let input = if turns { input.rem_euclid(TAU) } else { input };
                let wraps =
                    |[a, b]: &[f64; 2]| turns && (a - input).abs() > PI || (b - output).abs() > PI;
                if last.as_ref().is_none_or(wraps) {
                    pieces.push(Vec::new());
                }
                if let Some(piece) = pieces.last_mut() {
                    piece.extend([input, output]);
                }
                last = Some([input, output]);
            }
        }
        pieces
    }

    fn place(&self, moving: &Moving, meeting: &Meeting) -> Option<MeetingPlace> {
        let [first, _] = meeting.branches;
        let [input, _] = meeting.inputs;
        let pose = self.circuits.branches()[first].motion.pose::<1>(input);
        let mechanism = moving.mechanism();
        Some(MeetingPlace {
            kind: meeting.kind.code(),
            branches: meeting.branches,
            input: if mechanism.turns() {
                input.rem_euclid(TAU)
            } else {
                input
            },
            output: mechanism.folded_angle(&pose.ok()?, self.circuits.output()),
        })
    }
}
