//! What a person draws. An [`Edit`] makes another linkage of one, whether either moves yet or
//! not: [`edited`]. [`Advice`] gives the reasons why a drawing does not move, with the edits that mend them.
//!
//! Links keep the dimensions that they are given; of one that is drawn otherwise the drawing
//! tells them from then on.
//!
//! | file | subject |
//! |---|---|
//! | `edit.rs` | every edit as data |
//! | `draw.rs`, `drive.rs`, `dyads.rs` | what is added; drivers, meshes, what is fixed; dyads |
//! | `reshape.rs`, `remove.rs`, `selection.rs`, `names.rs` | moved, turned, mirrored; removed; copied and pasted; free names |
//! | `locks.rs` | lengths and angles that stay while points are moved |
//! | `advice.rs` | why a drawing does not move, and the edits that let it |

mod advice;
mod draw;
mod drive;
mod dyads;
mod edit;
mod locks;
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

/// A drawing after an edit, and what the edit has made.
#[derive(Clone, Debug, PartialEq)]
pub struct Edited {
    /// The drawing.
    pub document: LinkageDocument,
    /// The point that it added last, or that took the place of another.
    pub point: Option<String>,
    /// The link that it added last.
    pub link: Option<String>,
    /// Whether what is locked kept something from going where it was wanted: it is as near as it may.
    pub is_held: bool,
}

/// A drawing after one edit.
///
/// # Errors
/// Why it cannot be done; the drawing would be none that is taken.
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

/// Whether a document can be drawn, which need not move.
///
/// # Errors
/// What is wrong with single fields; a point that is too far to be drawn.
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
