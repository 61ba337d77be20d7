//! What the tasks of synthesis on the page share: the moving linkage in the drawing of its task.

use assur::mechanism::Quantity;
use assur_draw::{Annotations, Guidance, Role};
use assur_file::{LinkageProblem, Moved, Problem, View};

use crate::moving::Moving;

/// Colours of the links of a linkage that a task gives.
const ROLES: [(&str, Role); 4] = [
    ("crank", Role::Crank),
    ("coupler", Role::Coupler),
    ("rod", Role::Coupler),
    ("rocker", Role::Rocker),
];

/// A moving linkage with what is drawn of its task.
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
