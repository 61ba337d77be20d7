//! Editing of drawings. [`edited`] applies an [`Edit`] to a linkage, which need not move before or after.
//! [`Advice`] lists the reasons why a drawing does not move, and the edits that would let it move.
//!
//! A link keeps its given dimensions until its drawing is changed. From then on it takes its dimensions
//! from the drawing.
//!
//! | file | subject |
//! |---|---|
//! | `edit.rs` | every edit as data |
//! | `draw.rs`, `drive.rs`, `dyads.rs` | additions; drivers, meshes, fixed points and links; dyads |
//! | `reshape.rs`, `remove.rs`, `selection.rs`, `names.rs` | moving, turning, mirroring; removal; copying and pasting; free names |
//! | `masses.rs` | centres of mass, uniform bars |
//! | `locks.rs` | lengths and angles kept while points are moved |
//! | `advice.rs` | reasons why a drawing does not move, and the edits that would let it move |

mod advice;
mod draw;
mod drive;
mod dyads;
mod edit;
mod locks;
mod masses;
mod names;
mod remove;
mod reshape;
mod selection;
#[cfg(test)]
mod types;

pub use advice::{Advice, Mend};
pub use edit::{Edit, End, Inner, Line, Outer};
pub use selection::selected;

use assur::mechanism::{Defect, FARTHEST};
use assur_file::{LinkageDocument, Problem};

use draw::Drawing;

/// A drawing after an edit, with the names of the parts added last.
#[derive(Clone, Debug, PartialEq)]
pub struct Edited {
    /// The drawing.
    pub document: LinkageDocument,
    /// The point used or added last; after points were joined, the point that remains.
    pub point: Option<String>,
    /// The link added last.
    pub link: Option<String>,
    /// Whether locks kept a moved point from its target. The point is then as near to the target as possible.
    pub is_held: bool,
}

/// Applies an edit to a drawing.
///
/// # Errors
/// The reason why the edit is impossible, or the problems of the edited drawing if it is not accepted.
pub fn edited(document: &LinkageDocument, edit: &Edit) -> Result<Edited, Vec<Problem>> {
    let mut drawing = Drawing::new(document);
    let called = names::called_by_points(document);
    drawing
        .apply(edit)
        .map_err(|problem| vec![problem.into()])?;
    let Drawing {
        mut document,
        point,
        mut link,
        is_held,
    } = drawing;
    let position = |document: &LinkageDocument, name: &Option<String>| {
        let name = name.as_ref()?;
        document.links.iter().position(|one| one.name == *name)
    };
    let added = position(&document, &link);
    if !matches!(edit, Edit::Rename { .. }) {
        names::call_by_points(&mut document, &called);
    }
    if let Some(added) = added {
        link = document.links.get(added).map(|link| link.name.clone());
    }
    document.assembly = None;
    checked(&document)?;
    Ok(Edited {
        document,
        point,
        link,
        is_held,
    })
}

/// Checks that a document can be drawn. It need not move.
///
/// # Errors
/// The problems of single fields; a point too far away to be drawn.
fn checked(document: &LinkageDocument) -> Result<(), Vec<Problem>> {
    document.check()?;
    let far = |at: &f64| !at.is_finite() || at.abs() > FARTHEST;
    let mut points = document.points.iter();
    match points.find(|point| point.at.iter().any(far)) {
        Some(point) => {
            let name = point.name.clone();
            Err(vec![Defect::NotFinite { name }.into()])
        }
        None => Ok(()),
    }
}
