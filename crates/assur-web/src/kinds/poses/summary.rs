//! Summary of poses: the dyads and their pairs with verdicts, and the motion of the shown linkage.

use assur::Point;
use assur::synthesis::poses::{Dyad, Linkage, Mechanism, Place, Special};
use assur_file::{Document, Guidance, HingeDocument, Problem};
use serde::Serialize;

use super::Poses;
use crate::kinds::synthesis::summary::{order, passage};
use crate::kinds::task::StillSummary;
use crate::summary::MotionSummary;

/// Summary of poses, with a linkage or without.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub(crate) enum PosesSummary<'a> {
    Guided(Box<GuidedSummary<'a>>),
    Alone(Box<AloneSummary<'a>>),
}

/// Summary of poses through which a linkage guides the body.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GuidedSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    #[serde(flatten)]
    task: TaskSummary<'a>,
}

/// Summary of poses without a linkage.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AloneSummary<'a> {
    #[serde(flatten)]
    still: StillSummary<'a>,
    #[serde(flatten)]
    task: TaskSummary<'a>,
}

/// The task and all its solutions.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TaskSummary<'a> {
    /// Inputs at which the shown linkage meets the poses, radians or in the unit of lengths; null if it does not meet the
    /// pose. Empty without a linkage.
    met: &'a [Option<f64>],
    special: Option<SpecialSummary>,
    /// Numbers of the poses, from 1, that equal an earlier one.
    repeated: Vec<usize>,
    dyads: Vec<GuideSummary>,
    /// A hinge of each shown dyad that chooses it; empty if the poses leave no choice.
    #[cfg_attr(test, ts(type = "readonly HingeDocument[]"))]
    hinges: Vec<HingeDocument>,
    /// Number of dyads that are complex, of five poses.
    complex: usize,
    /// Whether no dyad is missing. Up to four poses leave more dyads than can be listed.
    complete: bool,
    /// Number of coordinates of a dyad that the poses leave free.
    freedoms: usize,
    /// The pairs of dyads, in numerical order.
    pairs: Vec<DyadPairSummary>,
    /// Numbers of the pairs, from 1, the best first.
    ranking: Vec<usize>,
    /// Number of the shown pair, from 1; null if there is none.
    number: Option<usize>,
    /// The reasons why the shown pair is no linkage; empty if it is one.
    #[cfg_attr(test, ts(type = "readonly Problem[]"))]
    reasons: &'a [Problem],
    /// The shown linkage, for the simulator.
    #[cfg_attr(
        test,
        ts(type = "{ kind: \"linkage\", document: LinkageDocument } | null")
    )]
    linkage: Option<&'a Document>,
}

/// Special poses, with the dyads that guide the body exactly.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SpecialSummary {
    #[cfg_attr(
        test,
        ts(type = "\"still\" | \"rotation\" | \"line\" | \"parallelogram\" | \"parallel\"")
    )]
    code: &'static str,
    /// The pole; the direction of the line; the vector from a hinge of the body to its pivot.
    at: Option<[f64; 2]>,
}

/// A dyad that guides the body.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GuideSummary {
    #[cfg_attr(test, ts(type = "\"RR\" | \"PR\" | \"RP\""))]
    code: &'static str,
    /// Centre point; null for a slider on the frame.
    centre: Option<[f64; 2]>,
    /// Circle point in the first pose; null for a block.
    point: Option<[f64; 2]>,
    /// Circle point in the body's own coordinates; null for a block.
    own: Option<[f64; 2]>,
    /// Greatest distance by which a pose is missed.
    residual: f64,
}

/// A pair of dyads with its verdict.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DyadPairSummary {
    /// Numbers of the dyads, from 1, the driving one first.
    dyads: [usize; 2],
    /// Whether the pair passes through all poses without a break, in order.
    sound: bool,
    verdict: Option<GuidanceVerdict>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GuidanceVerdict {
    #[cfg_attr(
        test,
        ts(
            type = "\"four_bar\" | \"slider_crank\" | \"inverted_slider_crank\" | \"double_slider\" | \"slider_block\" | \"double_block\""
        )
    )]
    mechanism: &'static str,
    /// Grashof type of a four-bar.
    grashof: Option<&'static str>,
    #[cfg_attr(
        test,
        ts(
            type = "\"continuous\" | \"through_change_point\" | \"across_dead_point\" | \"other_circuit\" | \"unreached\""
        )
    )]
    passage: &'static str,
    #[cfg_attr(test, ts(type = "\"growing\" | \"falling\" | \"either\" | \"mixed\""))]
    order: &'static str,
    turns: bool,
    /// Minimum transmission angle from the first pose to the last, radians.
    transmission: Option<f64>,
    size_ratio: f64,
}

impl<'a> PosesSummary<'a> {
    pub(super) fn new(poses: &'a Poses) -> Self {
        let task = TaskSummary::new(poses);
        if let Ok(shown) = &poses.shown {
            return Self::Guided(Box::new(GuidedSummary {
                motion: MotionSummary::new(&shown.moving),
                task,
            }));
        }
        Self::Alone(Box::new(AloneSummary {
            still: StillSummary::new(&poses.sheet, &poses.held),
            task,
        }))
    }
}

impl<'a> TaskSummary<'a> {
    fn new(poses: &'a Poses) -> Self {
        let found = &poses.found;
        let solutions = &found.solutions;
        let shown = poses.shown.as_ref();
        let repeated = found.task.repeated();
        Self {
            met: shown.map_or(&[], |shown| &shown.met),
            // Two poses are always special.
            special: (solutions.special)
                .filter(|_| found.task.distinct().len() != 2)
                .map(SpecialSummary::from),
            repeated: repeated.into_iter().map(|k| k + 1).collect(),
            dyads: (solutions.dyads.iter())
                .map(|dyad| GuideSummary::new(dyad, found))
                .collect(),
            hinges: poses.hinges.wanted(),
            complex: solutions.complex,
            complete: solutions.complete,
            freedoms: solutions.freedoms,
            pairs: (solutions.linkages.iter())
                .map(|pair| DyadPairSummary::new(pair, found))
                .collect(),
            ranking: found.order.iter().map(|number| number + 1).collect(),
            number: found.number.map(|number| number + 1),
            reasons: shown.err().map_or(&[], Vec::as_slice),
            linkage: shown.ok().map(|shown| &shown.linkage),
        }
    }
}

impl From<Special> for SpecialSummary {
    fn from(special: Special) -> Self {
        let (code, at) = match special {
            Special::Still => ("still", None),
            Special::Rotation { pole } => ("rotation", Some(pole.into())),
            Special::Line { along } => ("line", Some(along.into())),
            Special::Parallelogram { arm } => ("parallelogram", Some(arm.into())),
            Special::Parallel => ("parallel", None),
        };
        Self { code, at }
    }
}

impl GuideSummary {
    fn new(dyad: &Dyad, found: &Guidance) -> Self {
        let finite = |place: Place| match place {
            Place::Finite(at) => Some(Point::into(at)),
            Place::Infinite(_) => None,
        };
        Self {
            code: dyad.code(),
            centre: finite(dyad.centre()),
            point: finite(dyad.point()),
            own: finite(dyad.point()).map(|at| found.own(at.into()).into()),
            residual: dyad.residual(&found.task),
        }
    }
}

impl DyadPairSummary {
    fn new(pair: &Linkage, found: &Guidance) -> Self {
        let dyads = &found.solutions.dyads;
        let number = |dyad: &Dyad| {
            dyads
                .iter()
                .position(|one| one == dyad)
                .map_or(0, |k| k + 1)
        };
        let verdict = pair.verdict.as_ref().ok();
        Self {
            dyads: pair.dyads.each_ref().map(number),
            sound: pair.unmet(&found.requirements()).is_empty(),
            verdict: verdict.map(|verdict| GuidanceVerdict {
                mechanism: verdict.mechanism.code(),
                grashof: match verdict.mechanism {
                    Mechanism::FourBar(grashof) => Some(grashof.code()),
                    _ => None,
                },
                passage: passage(verdict.passage),
                order: order(verdict.order),
                turns: verdict.turns,
                transmission: verdict.transmission,
                size_ratio: verdict.size_ratio,
            }),
        }
    }
}
