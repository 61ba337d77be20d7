//! Reasons why a drawing does not move, and edits that would let it move.

use assur::mechanism::{Defect, Mechanism};
use assur_file::{LinkageDocument, Problem};
use serde::Serialize;

use crate::{Edit, checked, edited};

/// Maximum number of advised edits.
const MAX_EDITS: usize = 6;
/// Maximum number of candidate edits of a drawing. Trying one builds a mechanism.
const MAX_SOUGHT: usize = 48;
/// Number of candidate edits above which pairs of edits are not tried. Trying them would take longer than an animation
/// frame.
const MAX_TRIED: usize = 16;

/// Advice on a drawing that does not move.
#[derive(Clone, Debug)]
pub struct Advice {
    /// All reasons why the drawing does not move.
    pub problems: Vec<Problem>,
    /// Mobility W by the count of links and pairs; none if a defect of the drawing prevents counting.
    pub mobility: Option<isize>,
    /// Links whose motion the drivers do not determine, or that nothing joins to the frame.
    pub loose: Vec<String>,
    /// Links that cannot move, or that are mobile only for an instant.
    pub locked: Vec<String>,
    /// Edits, in the order tried. Any one of them lets the drawing move, or brings it within one edit of moving.
    pub mends: Vec<Mend>,
}

/// An advised edit of a drawing that does not move.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Mend {
    /// Drives a link.
    Drive(String),
    /// Stops driving a link.
    Release(String),
    /// Removes a link.
    Remove(String),
    /// Fixes a point to the frame.
    Fix(String),
    /// Moves points slightly, so that redundant constraints hold exactly.
    Exact {
        /// The point that moves farthest.
        point: String,
        /// Distance that this point moves.
        by: f64,
    },
}

impl Mend {
    /// The edit that carries out this advice.
    pub fn edit(&self) -> Edit {
        match self {
            Self::Drive(link) | Self::Release(link) => Edit::Drive { link: link.clone() },
            Self::Remove(link) => Edit::Remove {
                points: Vec::new(),
                links: vec![link.clone()],
            },
            Self::Fix(point) => Edit::Fix {
                point: point.clone(),
            },
            Self::Exact { .. } => Edit::MakeExact {},
        }
    }
}

impl Advice {
    /// The advice on a drawing; none if it moves.
    ///
    /// # Errors
    /// The problems of individual fields of the document.
    pub fn of(document: &LinkageDocument) -> Result<Option<Self>, Vec<Problem>> {
        checked(document)?;
        let draft = document.spec();
        let Err(defects) = Mechanism::new(&draft) else {
            return Ok(None);
        };
        let (mut loose, mut locked) = (Vec::new(), Vec::new());
        for defect in &defects {
            match defect {
                Defect::Loose { links } | Defect::Underdriven { links, .. } => {
                    loose.extend(links.iter().cloned());
                }
                Defect::Locked { links, .. } | Defect::Instant { links } => {
                    locked.extend(links.iter().cloned())
                }
                _ => {}
            }
        }
        Ok(Some(Self {
            mobility: draft.counts().ok().map(|counts| counts.mobility),
            loose,
            locked,
            mends: mends(document),
            problems: Problem::all(defects),
        }))
    }
}

/// The correction that makes redundant constraints hold exactly, if there is one; otherwise the candidate edits after
/// which the drawing moves or, if there are none, after which one more edit is enough.
fn mends(document: &LinkageDocument) -> Vec<Mend> {
    if let Some(exact) = document.spec().made_exact() {
        let (point, by) = (exact.point, exact.by);
        return vec![Mend::Exact { point, by }];
    }
    let all = tried(document);
    let once: Vec<Mend> = all
        .iter()
        .filter(|mend| moves(document, mend))
        .take(MAX_EDITS)
        .cloned()
        .collect();
    if !once.is_empty() || all.len() > MAX_TRIED {
        return once;
    }
    let twice = |mend: &&Mend| {
        edited(document, &mend.edit()).is_ok_and(|after| {
            tried(&after.document)
                .iter()
                .any(|next| moves(&after.document, next))
        })
    };
    // If there is no driver and the mobility is not positive, the first edit removes a link; otherwise it drives a link
    // or fixes a point.
    let mobility = document.spec().counts().map(|counts| counts.mobility);
    let rigid = document.drivers.is_empty() && mobility.is_ok_and(|mobility| mobility <= 0);
    let adding = all.iter().filter(|mend| match mend {
        Mend::Remove(_) => rigid,
        Mend::Drive(_) | Mend::Fix(_) => !rigid,
        _ => false,
    });
    // Edits that fix a point come first: a driven link needs a fixed point as its pivot.
    let (fixes, drives): (Vec<&Mend>, Vec<&Mend>) =
        adding.partition(|mend| matches!(mend, Mend::Fix(_)));
    fixes
        .into_iter()
        .chain(drives)
        .filter(twice)
        .take(MAX_EDITS)
        .cloned()
        .collect()
}

fn moves(document: &LinkageDocument, mend: &Mend) -> bool {
    let after = edited(document, &mend.edit());
    after.is_ok_and(|after| Mechanism::new(&after.document.spec()).is_ok())
}

fn tried(document: &LinkageDocument) -> Vec<Mend> {
    let draft = document.spec();
    let driven: Vec<&str> = (draft.drivers.iter())
        .filter_map(|driver| draft.driven(driver))
        .collect();
    let drivable = draft.drivable().into_iter();
    let drives = drivable
        .filter(|link| !driven.contains(link))
        .map(|link| Mend::Drive(link.to_owned()));
    let releases = driven.iter().map(|link| Mend::Release((*link).to_owned()));
    let links = |point: &String| {
        document
            .links
            .iter()
            .filter(|link| link.points.contains(point))
            .count()
    };
    let free = document
        .points
        .iter()
        .map(|point| &point.name)
        .filter(|point| !document.frame.contains(point));
    // Free ends of links come first: they are more often meant as fixed pivots than hinges are.
    let (ends, hinges): (Vec<&String>, Vec<&String>) = free.partition(|point| links(point) == 1);
    let fixes = ends
        .into_iter()
        .chain(hinges)
        .map(|point| Mend::Fix(point.clone()));
    let removes = document
        .links
        .iter()
        .map(|link| Mend::Remove(link.name.clone()));
    let all = drives.chain(releases).chain(fixes).chain(removes);
    all.take(MAX_SOUGHT).collect()
}
