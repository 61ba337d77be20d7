//! The dimensions of a linkage, as the page lists them.

use assur::mechanism::{Dimension, LinkId, PointId, SlideId};
use assur_draw::Role;
use assur_file::{Field, dimension_field, in_field};
use serde::Serialize;

use crate::moving::Moving;

/// A dimension: its field in the document, its points, its value and its range. `index` is the index of the link, slide
/// or point, from 0; `name` is the name of the link or point. A corner is in degrees, and its vertex is the second
/// point. The points of an offset are the sliding point and two points of its line.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DimensionSummary<'a> {
    #[cfg_attr(test, ts(type = "string"))]
    field: Field,
    #[cfg_attr(
        test,
        ts(type = "\"length\" | \"side\" | \"corner\" | \"offset\" | \"x\" | \"y\"")
    )]
    kind: &'static str,
    index: usize,
    name: &'a str,
    points: Vec<&'a str>,
    role: &'static str,
    value: f64,
    min: f64,
    max: f64,
    step: f64,
}

/// Minimum number of steps in the range of a slider on the page; a step is a power of ten.
const STEPS: f64 = 200.0;

/// Rounds both ends of a range to whole steps of the page's slider. Returns the range and the step.
fn stepped(range: [f64; 2]) -> ([f64; 2], f64) {
    let digits = ((range[1] - range[0]) / STEPS).log10().floor() as i32;
    // Dividing by a whole power of ten, which is exact, gives the number nearest to a decimal such as 0.1.
    let (times, parts) = (10_f64.powi(digits.max(0)), 10_f64.powi(-digits.min(0)));
    let whole = |steps: f64| steps * times / parts;
    let ends = range.map(|end| whole((end / times * parts).round()));
    (ends, whole(1.0))
}

impl<'a> DimensionSummary<'a> {
    pub(crate) fn all(moving: &'a Moving) -> Vec<Self> {
        let mechanism = moving.mechanism();
        let links = &mechanism.spec().links;
        let of_link = |kind, link: LinkId, ends: &[usize]| {
            let points = ends.iter().map(|end| &*links[link.index()].points[*end]);
            let name = mechanism.link_name(link);
            let role = moving.figure().role(link).name();
            (kind, link.index(), name, points.collect(), role)
        };
        let of_point = |kind, point: PointId| {
            let name = mechanism.point_name(point);
            (
                kind,
                point.index(),
                name,
                vec![name],
                Role::Secondary.name(),
            )
        };
        let of_slide = |slide: SlideId| {
            let index = slide.index();
            let slide = &mechanism.spec().slides[index];
            let role = mechanism
                .link(&slide.link)
                .map_or(Role::Secondary, |link| moving.figure().role(link));
            let points = [&slide.point].into_iter().chain(&slide.line);
            let points = points.map(String::as_str).collect();
            ("offset", index, &*slide.link, points, role.name())
        };
        let summed = |dimension: Dimension| {
            let (kind, index, name, points, role) = match dimension {
                Dimension::Length(link) => {
                    let is_plate = links[link.index()].points.len() > 2;
                    of_link(if is_plate { "side" } else { "length" }, link, &[0, 1])
                }
                Dimension::Side(link, ends) => of_link("side", link, &ends),
                Dimension::Corner(link, point) => of_link("corner", link, &[1, 0, point]),
                Dimension::Offset(slide) => of_slide(slide),
                Dimension::X(point) => of_point("x", point),
                Dimension::Y(point) => of_point("y", point),
            };
            let in_field = |value| in_field(dimension, value);
            let ([min, max], step) = stepped(mechanism.range(dimension)?.map(in_field));
            Some(Self {
                field: dimension_field(dimension),
                kind,
                index,
                name,
                points,
                role,
                value: in_field(mechanism.value(dimension)?),
                min,
                max,
                step,
            })
        };
        mechanism
            .dimensions()
            .into_iter()
            .filter_map(summed)
            .collect()
    }
}
