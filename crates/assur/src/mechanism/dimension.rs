//! The dimensions of a linkage: single numbers of it that can be read and set. One
//! notion for sliders, hands on the drawing and searches.

use std::collections::BTreeSet;

use super::draft::{Draft, DraftLink, DraftSlide};
use super::{Mechanism, Setting};
use crate::index::{LinkId, PointId};
use crate::{Point, Vector};

/// A number of a linkage; of use with the mechanism whose link or point it is of.
/// What else the linkage has stays as it is when it is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// The length of a link with two points.
    Length(LinkId),
    /// The abscissa of a hinge of the frame; links that are hinged there keep theirs.
    X(PointId),
    /// The ordinate of one.
    Y(PointId),
}

/// A length may be set so many times longer and shorter than it is …
const LENGTHS: [f64; 2] = [0.05, 2.0];
/// … and a hinge moved by this part of the size.
const ASIDE: f64 = 0.1;

impl Mechanism {
    /// All dimensions, in the order of the draft: the lengths of links with two points,
    /// then the coordinates of the hinges of the frame that stand alone: no guide goes
    /// through them, and no link lies on another there.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let draft = self.draft();
        let straight = self.link_ids().zip(&draft.links);
        let straight = straight.filter(|(_, link)| link.is_straight());
        let lengths = straight.map(|(link, _)| Dimension::Length(link));
        let bound = bound(draft);
        let points = self.point_ids().zip(&draft.points);
        let hinges = points.filter(|(_, point)| {
            let name = &point.name;
            draft.frame.contains(name)
                && !bound.contains(name.as_str())
                && draft.links.iter().any(|link| link.points.contains(name))
        });
        let hinges = hinges.flat_map(|(point, _)| [Dimension::X(point), Dimension::Y(point)]);
        lengths.chain(hinges).collect()
    }

    /// The value of a dimension; none of what is none of [`Self::dimensions`].
    pub fn value(&self, dimension: Dimension) -> Option<f64> {
        let draft = self.draft();
        self.dimensions().contains(&dimension).then(|| {
            let at = |point: PointId| draft.points[point.index()].at;
            match dimension {
                Dimension::Length(link) => draft.length(&draft.links[link.index()]),
                Dimension::X(point) => at(point).x,
                Dimension::Y(point) => at(point).y,
            }
        })
    }

    /// From where to where it makes sense to set a dimension; not every value between
    /// makes a mechanism. None of what is none of [`Self::dimensions`].
    pub fn range(&self, dimension: Dimension) -> Option<[f64; 2]> {
        let value = self.value(dimension)?;
        Some(match dimension {
            Dimension::Length(_) => LENGTHS.map(|times| times * value),
            Dimension::X(_) | Dimension::Y(_) => {
                let aside = ASIDE * self.size();
                [value - aside, value + aside]
            }
        })
    }
}

impl Dimension {
    /// What it is to set it to a value in a linkage drawn so.
    pub(crate) fn setting(self, draft: &Draft, value: f64) -> Setting {
        let at = |point: PointId| draft.points[point.index()].at;
        match self {
            Self::Length(link) => Setting::Length(link, value),
            Self::X(point) => Setting::Hinge(point, Point::new(value, at(point).y)),
            Self::Y(point) => Setting::Hinge(point, Point::new(at(point).x, value)),
        }
    }
}

impl Draft {
    /// The same with a shape for every link that could have one, so that the drawing
    /// can move without changing any.
    pub(super) fn shaped(&self) -> Self {
        let mut shaped = self.clone();
        for (link, own) in shaped.links.iter_mut().zip(&self.links) {
            if own.shape.is_some() || own.fixed_to.is_some() || own.points.len() < 2 {
                continue;
            }
            link.shape = if own.is_straight() {
                Some(straight(self.length(own)))
            } else {
                own.points.iter().map(|name| self.place(name)).collect()
            };
        }
        shaped
    }

    /// The distance of the first two points of a link.
    fn length(&self, link: &DraftLink) -> f64 {
        let places = match &link.shape {
            Some(shape) => shape.clone(),
            None => link
                .points
                .iter()
                .filter_map(|name| self.place(name))
                .collect(),
        };
        match places[..] {
            [from, to, ..] => (to - from).norm(),
            _ => 0.0,
        }
    }
}

impl DraftLink {
    /// Whether one length is all there is of it.
    fn is_straight(&self) -> bool {
        self.points.len() == 2 && self.fixed_to.is_none()
    }
}

/// The shape of a link with two points.
pub(super) fn straight(length: f64) -> Vec<Point> {
    vec![Point::origin(), Point::from(Vector::new(length, 0.0))]
}

/// The points on which more rests than hinges: guides, and links that are fixed to
/// others and lie on them as drawn.
fn bound(draft: &Draft) -> BTreeSet<&str> {
    let guides = draft.slides.iter();
    let guides = guides.flat_map(|DraftSlide { point, line, .. }| line.iter().chain([point]));
    let bases: BTreeSet<&str> = draft
        .links
        .iter()
        .filter_map(|link| link.fixed_to.as_deref())
        .collect();
    let lying = draft.links.iter();
    let lying = lying.filter(|link| link.fixed_to.is_some() || bases.contains(&*link.name));
    guides
        .chain(lying.flat_map(|link| &link.points))
        .map(String::as_str)
        .collect()
}
