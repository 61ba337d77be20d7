//! Parts shared by the tasks of synthesis on the page: the moving linkage in the drawing of its task, and a task
//! without one.

use std::collections::BTreeMap;

use assur::mechanism::Quantity;
use assur_draw::{Annotations, Guidance, GuidanceSheet, Role};
use assur_file::{LinkageProblem, Moved, Problem, View};
use serde::Serialize;

use crate::handle::Handle;
use crate::moving::Moving;
use crate::summary::HandleSummary;

/// Colours of the links of a linkage that a task gives.
const ROLES: [(&str, Role); 4] = [
    ("crank", Role::Crank),
    ("coupler", Role::Coupler),
    ("rod", Role::Coupler),
    ("rocker", Role::Rocker),
];

/// Summary of the drawing of a task without a linkage.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct StillSummary<'a> {
    /// Always null: a task alone has no motion.
    #[cfg_attr(test, ts(type = "null"))]
    moves: Option<&'static str>,
    bounds: [f64; 4],
    handles: Vec<HandleSummary<'a>>,
    roles: BTreeMap<&'a str, &'static str>,
}

impl<'a> StillSummary<'a> {
    pub(super) fn new(sheet: &GuidanceSheet, held: &'a [Handle]) -> Self {
        Self {
            moves: None,
            bounds: sheet.bounds(),
            handles: held.iter().map(HandleSummary::from).collect(),
            roles: BTreeMap::new(),
        }
    }
}

/// Makes a moving linkage whose drawing also shows its task.
///
/// # Errors
/// Problems that prevent the drawing.
pub(super) fn moving(
    view: &View,
    moved: Moved,
    guidance: Guidance,
) -> Result<Moving, Vec<Problem>> {
    let annotations = Annotations {
        roles: ROLES.map(|(link, role)| (link.to_owned(), role)).to_vec(),
        guidance,
        ..Annotations::of_linkage(None)
    };
    let quantities = Quantity::all(moved.motion.mechanism());
    let explain =
        |mechanism: &_, unsolved: &_| LinkageProblem::unsolved(unsolved, mechanism).into();
    Moving::new(view, moved, annotations, quantities, Box::new(explain))
}
