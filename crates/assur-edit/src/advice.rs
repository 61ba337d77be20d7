//! What keeps a drawing from moving, and which edits would let it.

use assur::mechanism::{Defect, FRAME, Mechanism};
use assur_file::{LinkageDocument, LinkageProblem, Problem};
use serde::Serialize;

use crate::{Edit, edited};

/// No more edits than these are advised.
const MOST: usize = 6;

/// What is said of a drawing that does not move.
#[derive(Clone, Debug)]
pub struct Advice {
    /// Every reason.
    pub problems: Vec<Problem>,
    /// W by the count of links and pairs; none where what is named is not there.
    pub mobility: Option<isize>,
    /// Links that move by themselves, or that nothing joins to the frame.
    pub loose: Vec<String>,
    /// Links that cannot move.
    pub locked: Vec<String>,
    /// Edits after each of which it moves, as they were tried.
    pub mends: Vec<Mend>,
}

/// An edit that lets a drawing move.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Mend {
    /// A link is driven.
    Drive(String),
    /// A link is driven no more.
    Release(String),
    /// A link goes.
    Remove(String),
    /// A point becomes one of the frame.
    Fix(String),
}

impl Mend {
    /// The edit that does it.
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
        }
    }
}

impl Advice {
    /// What is to be said of a drawing; nothing where it moves.
    ///
    /// # Errors
    /// What is wrong with single fields.
    pub fn of(document: &LinkageDocument) -> Result<Option<Self>, Vec<Problem>> {
        document.check()?;
        let draft = document.draft();
        let Err(defects) = Mechanism::new(&draft) else {
            return Ok(None);
        };
        let (mut loose, mut locked) = (Vec::new(), Vec::new());
        for defect in &defects {
            match defect {
                Defect::Loose(links) | Defect::Underdriven { links, .. } => {
                    loose.extend(links.iter().cloned());
                }
                Defect::Locked { links, .. } => locked.extend(links.iter().cloned()),
                _ => {}
            }
        }
        Ok(Some(Self {
            mobility: draft.counts().ok().map(|counts| counts.mobility),
            loose,
            locked,
            mends: mends(document),
            problems: LinkageProblem::all(defects),
        }))
    }
}

/// The edits after which it moves, of those that a person would try.
fn mends(document: &LinkageDocument) -> Vec<Mend> {
    let driven: Vec<&String> = (document.drivers.iter().filter_map(|one| one.crank.as_ref()))
        .chain((document.drivers.iter()).filter_map(|one| Some(&document.slides.get(one.slide?)?.link)))
        .collect();
    let on_frame = |points: &[String]| points.iter().any(|point| document.frame.contains(point));
    let slides = |link: &String| document.slides.iter().any(|one| one.link == *link && one.on == FRAME);
    let drivable = document.links.iter().filter(|link| on_frame(&link.points) || slides(&link.name));
    let drives = drivable.filter(|link| !driven.contains(&&link.name)).map(|link| Mend::Drive(link.name.clone()));
    let releases = driven.iter().map(|link| Mend::Release((*link).clone()));
    let ends = document.points.iter().filter(|point| !document.frame.contains(&point.name));
    let fixes = ends.map(|point| Mend::Fix(point.name.clone()));
    let removes = document.links.iter().map(|link| Mend::Remove(link.name.clone()));
    let moves = |mend: &Mend| {
        let after = edited(document, &mend.edit());
        after.is_ok_and(|after| Mechanism::new(&after.document.draft()).is_ok())
    };
    let tried = drives.chain(releases).chain(fixes).chain(removes);
    tried.filter(moves).take(MOST).collect()
}
