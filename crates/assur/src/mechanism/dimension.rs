//! Dimensions of a linkage: numbers to be read, or to be set with a slider, by dragging in the drawing or by a search.

use crate::index::{BodyId, LinkId, PointId, SlideId};
use crate::linkage::spec::{DriverSpec, LinkSpec, LinkageSpec, SlideSpec};
use crate::mechanism::{DoubledLink, Mechanism, Part, Setting};
use crate::{Point, Vector};
use nalgebra::Rotation2;

/// A dimension of a linkage. It is valid only with the mechanism from which the id of its link, slide or point comes.
///
/// ```
/// # use assur::{linkage::LinkageSpec, mechanism::{Dimension, Mechanism}};
/// # let slider_crank = LinkageSpec::default()
/// #     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
/// #     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
/// #     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// let mechanism = Mechanism::new(&slider_crank).unwrap();
/// let crank = mechanism.link("crank").unwrap();
/// assert_eq!(mechanism.value(Dimension::Length(crank)), Some(3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Distance between the first two points of a link; for a link with two points, its length. If it is set, other
    /// points keep their positions on the link.
    Length(LinkId),
    /// Distance from the first (0) or second (1) point of a link to a later point, given by its index from 2. If it is
    /// set, the first two points stay. Setting a distance from the first point keeps the angle there; setting one from
    /// the second point keeps the distance from the first.
    Side(LinkId, [usize; 2]),
    /// Angle at the first point of a link, from the second point to a later point, given by its index from 2; radians
    /// in (−π, π]. If it is set, the adjacent sides keep their lengths.
    Corner(LinkId, usize),
    /// Distance of the point of a slide from the line of the slide, positive to the left. The line is directed from its
    /// first point to its second point.
    Offset(SlideId),
    /// Abscissa of a hinge of the frame, or of a point that defines a guide of the frame. If it is set, links hinged
    /// there or sliding on the guide keep their dimensions.
    X(PointId),
    /// Ordinate of a hinge of the frame, or of a point that defines a guide of the frame.
    Y(PointId),
}

/// Limits of a length, relative to its current value.
const LENGTHS: [f64; 2] = [0.05, 2.0];
/// Maximum change of a corner, radians.
const OPENED: f64 = 0.5;
/// Maximum change of an offset or of the coordinate of a hinge, relative to the size of the linkage.
const MAX_SHIFT: f64 = 0.1;

impl Mechanism {
    /// All dimensions, in the order of the specification: first the length, sides and corners of each link, then
    /// offsets of slides, then coordinates of hinges and guide points of the frame. A point of the frame is left out if
    /// it defines the line of a driven slide, or if a link at this point is fixed to another link, carries a fixed link
    /// or doubles the frame.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let spec = self.spec();
        let links = self.link_ids().zip(&spec.links);
        let shapes = links.flat_map(|(link, own)| {
            let others = (2..own.points.len()).flat_map(move |point| {
                let [first, second] = [0, 1].map(|end| Dimension::Side(link, [end, point]));
                [first, second, Dimension::Corner(link, point)]
            });
            [Dimension::Length(link)].into_iter().chain(others)
        });
        let offsets = self.layout.bodies.slides.ids().map(Dimension::Offset);
        let points = self.point_ids().take(spec.points.len());
        let hinges = points.flat_map(|point| [Dimension::X(point), Dimension::Y(point)]);
        let all = shapes.chain(offsets).chain(hinges);
        all.filter(|dimension| self.has(*dimension)).collect()
    }

    /// True if a dimension exists. Two links of one body, or a link and the frame, may share a point. A link has no
    /// dimension at a point that it shares with the frame, or with a link that must keep its shape.
    fn has(&self, dimension: Dimension) -> bool {
        let spec = self.spec();
        let can_place = |link: LinkId, point: usize| {
            let Part { body, points, .. } = &self.layout.links[link];
            let moved = points.get(point);
            let holds = |part: &Part| {
                part.body == *body && part.points.iter().any(|own| Some(own) == moved)
            };
            let mut doubling = self.layout.links.iter().zip(&spec.links);
            let is_of_frame =
                |point: &PointId| spec.frame.contains(&spec.points[point.index()].name);
            !(*body == BodyId::FRAME && moved.is_some_and(is_of_frame))
                && doubling
                    .all(|(part, own)| own.fixed_to.is_some() || !holds(part) || spec.is_free(own))
        };
        spec.has(dimension)
            && match dimension {
                Dimension::Length(link) => can_place(link, 1),
                Dimension::Side(link, [_, point]) | Dimension::Corner(link, point) => {
                    can_place(link, point)
                }
                Dimension::Offset(_) => true,
                Dimension::X(point) | Dimension::Y(point) => {
                    let of_frame =
                        |one: &DoubledLink| self.body_of(Some(one.link)) == BodyId::FRAME;
                    !self
                        .doubled()
                        .iter()
                        .any(|one| of_frame(one) && one.shared.contains(&point))
                }
            }
    }

    /// Value of a dimension; None if the dimension is not among [`Self::dimensions`].
    pub fn value(&self, dimension: Dimension) -> Option<f64> {
        let spec = self.spec();
        self.has(dimension).then(|| {
            let at = |point: PointId| spec.points[point.index()].at;
            match dimension {
                Dimension::Length(link) => spec.side(link, [0, 1]),
                Dimension::Side(link, ends) => spec.side(link, ends),
                Dimension::Corner(link, point) => spec.corner(link, point),
                Dimension::Offset(slide) => self.layout.bodies.slides[slide].offset(),
                Dimension::X(point) => at(point).x,
                Dimension::Y(point) => at(point).y,
            }
        })
    }

    /// The equivalent of a given value that is nearest to the current value: a corner changes by at most half a turn.
    pub fn nearest(&self, dimension: Dimension, value: f64) -> f64 {
        match (dimension, self.value(dimension)) {
            (Dimension::Corner(..), Some(from)) => crate::angle::nearest_to(value, from),
            _ => value,
        }
    }

    /// Range of values to try for a dimension; some may give no mechanism. None if there is no such dimension.
    pub fn range(&self, dimension: Dimension) -> Option<[f64; 2]> {
        let value = self.value(dimension)?;
        let around = |aside: f64| [value - aside, value + aside];
        Some(match dimension {
            Dimension::Side(link, [1, point]) => {
                let [a, b] = self.beside_corner(link, point);
                LENGTHS.map(|times| (times * value).clamp((a - b).abs(), a + b))
            }
            Dimension::Length(_) | Dimension::Side(..) => LENGTHS.map(|times| times * value),
            Dimension::Corner(..) => around(OPENED),
            Dimension::Offset(_) | Dimension::X(_) | Dimension::Y(_) => {
                around(MAX_SHIFT * self.size())
            }
        })
    }

    /// Lengths of the sides from the first point of a link to the second point and to a later point.
    pub(crate) fn beside_corner(&self, link: LinkId, point: usize) -> [f64; 2] {
        [1, point].map(|end| self.spec().side(link, [0, end]))
    }
}

impl Dimension {
    /// Setting that gives this dimension a value. A side from the second point must be set through the corner instead.
    pub(crate) fn setting(self, spec: &LinkageSpec, value: f64) -> Setting {
        let at = |point: PointId| spec.points[point.index()].at;
        let placed = |link: LinkId, point: usize, angle: f64, side: f64| {
            let ray = Rotation2::new(angle) * spec.ray(link, [0, point]).normalize() * side;
            let first = spec.on_link(&spec.links[link.index()], 0);
            Setting::Place(link, point, first + ray)
        };
        match self {
            Self::Length(link) => placed(link, 1, 0.0, value),
            Self::Side(link, [_, point]) => placed(link, point, 0.0, value),
            Self::Corner(link, point) => {
                let turned = value - spec.corner(link, point);
                placed(link, point, turned, spec.side(link, [0, point]))
            }
            Self::Offset(slide) => Setting::Offset(slide, value),
            Self::X(point) => Setting::Hinge(point, Point::new(value, at(point).y)),
            Self::Y(point) => Setting::Hinge(point, Point::new(at(point).x, value)),
        }
    }
}

impl LinkageSpec {
    /// Specification with a shape for every link that can have one. Moving points of the drawing then changes no shape.
    pub(super) fn shaped(&self) -> Self {
        let mut shaped = self.clone();
        for (link, own) in shaped.links.iter_mut().zip(&self.links) {
            if own.shape.is_some() || own.fixed_to.is_some() || own.points.len() < 2 {
                continue;
            }
            let places = (0..own.points.len()).map(|point| self.on_link(own, point));
            link.shape = Some(along_axis(places.collect()));
        }
        shaped
    }

    /// True if the specification has a dimension, without regard to doubled links.
    fn has(&self, dimension: Dimension) -> bool {
        let shaped = |link: LinkId| self.links.get(link.index()).filter(|own| self.is_free(own));
        let has_corner = |link: LinkId, point: usize| {
            shaped(link).is_some_and(|own| (2..own.points.len()).contains(&point))
        };
        match dimension {
            Dimension::Length(link) => shaped(link).is_some(),
            Dimension::Side(link, [end, point]) => end < 2 && has_corner(link, point),
            Dimension::Corner(link, point) => has_corner(link, point),
            Dimension::Offset(slide) => slide.index() < self.slides.len(),
            Dimension::X(point) | Dimension::Y(point) => {
                let point = self.points.get(point.index());
                point.is_some_and(|point| self.can_move(&point.name))
            }
        }
    }

    /// True if the distances between a link's points may change. The link is then fixed to no other link and, if it has
    /// three or more points, no other link is fixed to it.
    fn is_free(&self, link: &LinkSpec) -> bool {
        let points = link.points.len();
        link.fixed_to.is_none() && (points == 2 || points > 2 && !self.is_base(&link.name))
    }

    /// True if a point of the frame is a hinge or defines a guide, and nothing else depends on its position: it defines
    /// no line of a driven slide, and no link at the point is fixed to another link or carries a fixed link.
    fn can_move(&self, point: &String) -> bool {
        let has = |link: &LinkSpec| link.points.contains(point);
        let guides = |slide: &SlideSpec| slide.line.contains(point);
        let counted = |driver: &DriverSpec| match driver {
            DriverSpec::Slide { slide, .. } => self.slides.get(*slide).is_some_and(guides),
            DriverSpec::Crank { .. } => false,
        };
        let lies = |link: &LinkSpec| link.fixed_to.is_some() || self.is_base(&link.name);
        self.frame.contains(point)
            && (self.links.iter().any(has) || self.slides.iter().any(guides))
            && !self.drivers.iter().any(counted)
            && !self.links.iter().any(|link| has(link) && lies(link))
    }

    /// Vector from one point of a link to another, in the coordinates of [`Self::on_link`].
    fn ray(&self, link: LinkId, [from, to]: [usize; 2]) -> Vector {
        let link = &self.links[link.index()];
        self.on_link(link, to) - self.on_link(link, from)
    }

    fn side(&self, link: LinkId, ends: [usize; 2]) -> f64 {
        self.ray(link, ends).norm()
    }

    fn corner(&self, link: LinkId, point: usize) -> f64 {
        let [from, to] = [1, point].map(|end| self.ray(link, [0, end]));
        from.perp(&to).atan2(from.dot(&to))
    }

    /// Position of a point, given by its index on a link: in the link's shape or, without a shape, in the drawing.
    pub(super) fn on_link(&self, link: &LinkSpec, point: usize) -> Point {
        let shape = link.shape.as_ref().and_then(|shape| shape.get(point));
        let drawn = || self.place(link.points.get(point)?);
        shape.copied().or_else(drawn).unwrap_or_default()
    }
}

/// Shape of a link. If it has two points, only their distance matters, so they are put on the x-axis.
pub(super) fn along_axis(shape: Vec<Point>) -> Vec<Point> {
    match shape[..] {
        [from, to] => vec![Point::origin(), Point::new((to - from).norm(), 0.0)],
        _ => shape,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A four-bar whose coupler BCP is a triangle 3-4-5 with the right angle at C.
    fn mechanism() -> Mechanism {
        let spec = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 2.0)
            .point("C", 3.0, 2.0)
            .point("P", 3.0, 6.0)
            .point("D", 5.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C", "P"])
            .bar("rocker", &["D", "C"])
            .crank("crank");
        Mechanism::new(&spec).unwrap()
    }

    #[test]
    fn sides_and_corner_of_a_right_triangle() {
        let mechanism = mechanism();
        let coupler = mechanism.link("coupler").unwrap();
        for (dimension, expected) in [
            (Dimension::Length(coupler), 3.0),
            (Dimension::Side(coupler, [0, 2]), 5.0),
            (Dimension::Side(coupler, [1, 2]), 4.0),
            (Dimension::Corner(coupler, 2), (4.0_f64 / 3.0).atan()),
            (Dimension::X(mechanism.point("D").unwrap()), 5.0),
        ] {
            let found = mechanism.value(dimension).unwrap();
            assert!((found - expected).abs() < 1e-15, "{dimension:?}: {found}");
        }
        assert_eq!(mechanism.value(Dimension::Corner(coupler, 3)), None);
    }

    /// A side CP of 4 may become 0.05 to 2 times as long, but the triangle has to close: 5 − 3 to 5 + 3.
    #[test]
    fn ranges_keep_the_triangle_closed() {
        let mechanism = mechanism();
        let coupler = mechanism.link("coupler").unwrap();
        let corner = (4.0_f64 / 3.0).atan();
        for (dimension, expected) in [
            (Dimension::Side(coupler, [1, 2]), [2.0, 8.0]),
            (Dimension::Side(coupler, [0, 2]), [0.25, 10.0]),
            (Dimension::Length(coupler), [0.15, 6.0]),
            (Dimension::Corner(coupler, 2), [corner - 0.5, corner + 0.5]),
        ] {
            let found = mechanism.range(dimension).unwrap();
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-14, "{dimension:?}: {found}");
            }
        }
    }

    #[test]
    fn whole_turns_of_a_corner_are_dropped() {
        let mechanism = mechanism();
        let coupler = mechanism.link("coupler").unwrap();
        let found = mechanism.nearest(Dimension::Corner(coupler, 2), 1.0 - std::f64::consts::TAU);
        assert!((found - 1.0).abs() < 1e-15, "{found}");
        assert_eq!(mechanism.nearest(Dimension::Length(coupler), 9.0), 9.0);
    }
}
