//! The drawing of Zhukovsky's lever.

use assur::forces::{Component, ForceName, Lever};
use assur::mechanism::{Mechanism, Pose};
use assur::{Point, Vector};

use super::body::length;
use super::{Drawing, ForcePicture, Numbers, around, couple, force_symbol, size, square};
use crate::list::{Look, Role};
use crate::parts;

/// Length of the longest arrow, as a share of the size of the plan.
const LONGEST: f64 = 0.4;

/// Draws the turned plan of velocities with the images of the links, and the forces at the images of their points.
pub fn lever_picture(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    lever: &Lever,
    numbers: Numbers<'_>,
) -> ForcePicture {
    let pole = Point::origin();
    let turned = |point| {
        let velocity = mechanism.place(pose, point).derivative(1);
        Point::new(velocity.y, -velocity.x)
    };
    let bodies = mechanism.bodies().skip(1);
    let images = bodies.map(|body| {
        let points = mechanism.points_on(body);
        let points = points.map(|point| (point, turned(point)));
        (body, points.collect::<Vec<_>>())
    });
    let images: Vec<_> = images.collect();
    let of_points = images.iter().flat_map(|(_, points)| points);
    let of_points = of_points.map(|(_, at)| *at);
    let of_forces = lever.terms.iter().map(|term| pole + term.image);
    let places: Vec<Point> = of_points.chain(of_forces).chain([pole]).collect();
    let extent = size(square(around(places.iter().copied())));
    let greatest = lever.terms.iter().map(|term| term.force.norm());
    let greatest = greatest.fold(0.0, f64::max);
    let tip = |image: Vector, force: Vector| {
        let along = force.try_normalize(0.0).unwrap_or_default();
        pole + image + along * length(force.norm(), greatest, LONGEST * extent)
    };
    let tips = lever.terms.iter().map(|term| tip(term.image, term.force));
    let [left, bottom, right, top] = around(places.iter().copied().chain(tips));
    let edge = 0.06 * extent;
    let bounds = square([left - edge, bottom - edge, right + edge, top + edge]);
    let mut drawing = Drawing::new(bounds);
    let unit = drawing.unit;
    let mut named = Vec::new();
    for (_, points) in &images {
        let corners = parts::hull(points.iter().map(|(_, at)| *at).collect());
        if let [first, .., _] = corners[..] {
            let ring: Vec<Point> = corners.into_iter().chain([first]).collect();
            drawing.list.polyline(Role::Ink, Look::Line, &ring);
        }
        for (point, at) in points {
            let far = (at - pole).norm() > 0.5 * unit;
            if !far || named.contains(point) {
                continue;
            }
            named.push(*point);
            drawing
                .list
                .polyline(Role::Secondary, Look::Thin, &[pole, *at]);
            drawing.list.circle(Role::Ink, Look::Solid, *at, 0.7 * unit);
            let name = mechanism.point_name(*point).to_lowercase();
            drawing.name(Role::Ink, name, *at, at - pole);
        }
    }
    for term in &lever.terms {
        let part = Component::Whole;
        let name = ForceName {
            body: term.body,
            cause: term.cause,
            part,
        };
        let is_couple = term.couple != 0.0;
        let name = force_symbol(&name, is_couple, numbers);
        if is_couple {
            let points = images.iter().find(|(body, _)| *body == term.body);
            let [left, bottom, right, top] = around(
                points
                    .into_iter()
                    .flat_map(|(_, points)| points.iter().map(|(_, at)| *at)),
            );
            let middle = Point::new(0.5 * (left + right), 0.5 * (bottom + top));
            // The sense of the couple on the lever is that in which it does power.
            let at = couple(&mut drawing, Role::Accent1, middle, term.moment);
            drawing.name(Role::Accent1, name, at, at - middle);
        } else {
            let from = pole + term.image;
            let to = tip(term.image, term.force);
            if drawing.arrow(Role::Accent1, from, to) {
                drawing.name(Role::Accent1, name, to, to - from);
            }
        }
    }
    drawing
        .list
        .circle(Role::Ink, Look::Hollow, pole, 1.4 * unit);
    drawing.name(Role::Ink, "p".to_owned(), pole, Vector::new(-1.0, -1.0));
    drawing.picture(bounds, false)
}
