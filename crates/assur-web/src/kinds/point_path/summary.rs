//! Summary of a path: how the shown linkage traces it, the cognates, and the motion of the linkage.

use assur::synthesis::approximation::{PathVerdict, Special, Tracing};
use assur::synthesis::cognates::GearedFiveBar;
use assur_file::{Document, TracingDocument};
use serde::Serialize;

use super::Path;
use crate::kinds::synthesis::summary::{order, passage};
use crate::kinds::task::StillSummary;
use crate::summary::MotionSummary;

/// Summary of a path, with a linkage or without.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub(crate) enum PathSummary<'a> {
    Traced(Box<TracedSummary<'a>>),
    Alone(Box<LonePathSummary<'a>>),
}

/// Summary of a path that a linkage traces.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TracedSummary<'a> {
    #[serde(flatten)]
    motion: MotionSummary<'a>,
    #[serde(flatten)]
    task: PathTaskSummary<'a>,
}

/// Summary of a path without a linkage.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LonePathSummary<'a> {
    #[serde(flatten)]
    still: StillSummary<'a>,
    #[serde(flatten)]
    task: PathTaskSummary<'a>,
}

/// The path, and the linkage that traces it.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PathTaskSummary<'a> {
    /// Inputs at which the traced point is nearest to the points, radians or in the unit of lengths; null for a point that
    /// the motion does not reach. Empty without a linkage.
    met: &'a [Option<f64>],
    /// Distances of the points from the traced curve.
    distances: &'a [f64],
    /// Diagonal of the bounding box of the path.
    size: f64,
    /// The line or circle on which all points lie.
    #[cfg_attr(test, ts(type = "\"line\" | \"circle\" | null"))]
    special: Option<&'static str>,
    /// The shown linkage; null if there is none.
    traced: Option<FoundTracing>,
    /// The cognates of the shown linkage, which trace the same curve; null if it has no such cognate.
    #[cfg_attr(test, ts(type = "readonly (TracingDocument | null)[]"))]
    cognates: Vec<Option<TracingDocument>>,
    /// Geared five-bars that trace the same curve, for the simulator.
    #[cfg_attr(
        test,
        ts(type = "readonly { kind: \"linkage\", document: LinkageDocument }[]")
    )]
    geared: Vec<Document>,
    /// The shown linkage, for the simulator.
    #[cfg_attr(
        test,
        ts(type = "{ kind: \"linkage\", document: LinkageDocument } | null")
    )]
    linkage: Option<&'a Document>,
}

/// A linkage that traces a path, with its verdict.
#[derive(Clone, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FoundTracing {
    #[cfg_attr(test, ts(type = "TracingDocument"))]
    pub(crate) linkage: TracingDocument,
    /// Greatest distance between path and curve.
    pub(crate) greatest: f64,
    /// Root of the mean square of the distances; null if it was not computed.
    pub(crate) root_mean_square: Option<f64>,
    pub(crate) verdict: Option<TracingVerdict>,
    /// Number of the coupler curve among those through nine points, from 1; its cognates share it.
    pub(crate) curve: Option<usize>,
}

#[derive(Clone, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TracingVerdict {
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
    /// Minimum transmission angle between the points or, if the linkage does not pass through all of them, over the
    /// whole motion, radians.
    transmission: f64,
    size_ratio: f64,
}

impl From<PathVerdict> for TracingVerdict {
    fn from(verdict: PathVerdict) -> Self {
        match verdict {
            PathVerdict::FourBar(verdict) => verdict.into(),
            PathVerdict::SliderCrank {
                order: of,
                turns,
                transmission,
                size_ratio,
            } => Self {
                grashof: None,
                passage: "continuous",
                order: order(of),
                turns,
                transmission,
                size_ratio,
            },
        }
    }
}

impl From<assur::synthesis::four_bar::Verdict> for TracingVerdict {
    fn from(verdict: assur::synthesis::four_bar::Verdict) -> Self {
        Self {
            grashof: Some(verdict.grashof.code()),
            passage: passage(verdict.passage),
            order: order(verdict.order),
            turns: verdict.turns,
            transmission: verdict.transmission_between.unwrap_or(verdict.transmission),
            size_ratio: verdict.size_ratio,
        }
    }
}

impl<'a> PathSummary<'a> {
    pub(super) fn new(path: &'a Path) -> Self {
        let task = PathTaskSummary::new(path);
        if let Some(shown) = &path.shown {
            return Self::Traced(Box::new(TracedSummary {
                motion: MotionSummary::new(&shown.moving),
                task,
            }));
        }
        Self::Alone(Box::new(LonePathSummary {
            still: StillSummary::new(&path.sheet, &path.held),
            task,
        }))
    }
}

impl<'a> PathTaskSummary<'a> {
    fn new(path: &'a Path) -> Self {
        let shown = path.shown.as_ref();
        let tracing = shown.and(path.task.shown.as_ref());
        let traced = shown.map(|shown| &shown.traced);
        let geared = match tracing {
            Some(Tracing::FourBar(linkage)) => {
                let five_bars = linkage.geared().into_iter().flatten();
                let document = |one: GearedFiveBar| path.task.tracing(&one.spec());
                five_bars.map(document).map(Document::Linkage).collect()
            }
            _ => Vec::new(),
        };
        Self {
            met: traced.map_or(&[], |traced| &traced.inputs),
            distances: traced.map_or(&[], |traced| &traced.distances),
            size: path.task.target.size(),
            special: path.task.target.special().map(|special| match special {
                Special::Line { .. } => "line",
                Special::Circle { .. } => "circle",
            }),
            traced: tracing.zip(traced).map(|(tracing, traced)| FoundTracing {
                linkage: tracing.into(),
                greatest: traced.deviation.greatest,
                root_mean_square: Some(traced.deviation.root_mean_square),
                verdict: traced.verdict.map(TracingVerdict::from),
                curve: None,
            }),
            cognates: tracing.map_or_else(Vec::new, cognates),
            geared,
            linkage: shown.map(|shown| &shown.linkage),
        }
    }
}

/// The cognates of a linkage that a document may hold: two of a four-bar, one of a slider-crank.
fn cognates(tracing: &Tracing) -> Vec<Option<TracingDocument>> {
    let cognates = match tracing {
        Tracing::FourBar(linkage) => {
            let cognates = linkage.cognates().into_iter();
            cognates.map(|one| one.ok().map(Tracing::FourBar)).collect()
        }
        Tracing::SliderCrank(linkage) => {
            vec![linkage.cognate().ok().map(Tracing::SliderCrank)]
        }
    };
    let document = |one: Option<Tracing>| {
        let document = TracingDocument::from(&one?);
        document.is_near().then_some(document)
    };
    cognates.into_iter().map(document).collect()
}
