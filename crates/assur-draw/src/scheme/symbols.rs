//! Standard symbols of pairs (ISO 3952, GOST 2.770), oriented along the axes of the pairs.

use assur::mobility::{Pair, PairKind, Point3, Vector3};
use assur::{Point, perpendicular};

use super::opening::Displacement;
use crate::list::{List, Look, Role};
use crate::parts;
use crate::projection::Projection;

/// Sine of the angle to the line of sight below which an axis is drawn as seen end on.
const END_ON: f64 = 0.35;

/// A pen in space, which draws at the position of a pair, along the directions of the pair.
pub(super) struct Pen<'a> {
    pub(super) list: &'a mut List,
    pub(super) projection: &'a Projection,
    /// Length of one symbol unit, in the coordinates of the scheme.
    pub(super) unit: f64,
    pub(super) role: Role,
    at: Point3,
    /// Direction of the axis, and two directions at right angles to it.
    frame: [Vector3; 3],
}

impl<'a> Pen<'a> {
    /// Makes a pen at a pair that was displaced by `moved`.
    pub(super) fn new(
        list: &'a mut List,
        projection: &'a Projection,
        unit: f64,
        role: Role,
        pair: &Pair,
        place: Point3,
        moved: &Displacement,
    ) -> Self {
        let axis = pair.axis.unwrap_or_else(Vector3::z);
        // A pair without a second direction gets one that is parallel to the xy plane.
        let across = pair.second.unwrap_or_else(|| {
            let level = Vector3::z().cross(&axis);
            level.try_normalize(1e-6).unwrap_or_else(Vector3::x)
        });
        let frame = [axis, across, axis.cross(&across)].map(|one| moved.rotation * one);
        Self {
            list,
            projection,
            unit,
            role,
            at: moved * place,
            frame,
        }
    }

    /// Projects a point given in symbol units along the axis and the two other directions.
    fn point(&self, along: f64, across: f64, third: f64) -> Point {
        let [a, b, c] = self.frame;
        let off = (a * along + b * across + c * third) * self.unit;
        self.projection.place(self.at + off)
    }

    /// Returns a point on the sheet, given in symbol units along the projected axis and at right angles to it.
    fn flat(&self, along: f64, across: f64) -> Point {
        let axis = self.projection.direction(self.frame[0]);
        let along_it = axis.try_normalize(1e-9).unwrap_or_else(assur::Vector::x);
        let left = perpendicular(along_it);
        self.projection.place(self.at) + (along_it * along + left * across) * self.unit
    }

    fn end_on(&self) -> bool {
        self.projection.direction(self.frame[0]).norm() < END_ON
    }

    fn line(&mut self, look: Look, ends: [[f64; 2]; 2]) {
        let ends = ends.map(|[along, across]| self.flat(along, across));
        self.list.polyline(self.role, look, &ends);
    }

    fn box_of(&mut self, look: Look, along: f64, across: f64) {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[x, y]| self.flat(x * along, y * across));
        self.list.polygons(self.role, look, &[corners.to_vec()]);
    }

    fn circle(&mut self, look: Look, along: f64, radius: f64) {
        let centre = self.flat(along, 0.0);
        self.list
            .circle(self.role, look, centre, radius * self.unit);
    }

    /// Draws a plane at right angles to the axis.
    fn plate(&mut self, along: f64) {
        let corners = [[-2.6, -2.0], [2.6, -2.0], [2.6, 2.0], [-2.6, 2.0]];
        let corners = corners.map(|[x, y]| self.point(along, x, y));
        self.list
            .polygons(self.role, Look::Pale, &[corners.to_vec()]);
    }

    /// Draws an open half shell around a ball.
    fn cup(&mut self) {
        let centre = self.projection.place(self.at);
        let arc = (0..=20).map(|k| {
            let angle = (-30.0 - 12.0 * f64::from(k)).to_radians();
            centre + assur::Vector::new(angle.cos(), angle.sin()) * (2.1 * self.unit)
        });
        let arc: Vec<Point> = arc.collect();
        self.list.polyline(self.role, Look::Line, &arc);
    }

    pub(super) fn draw(&mut self, kind: PairKind) {
        match kind {
            PairKind::Revolute if self.end_on() => self.circle(Look::Hollow, 0.0, 1.2),
            PairKind::Revolute => {
                self.line(Look::Line, [[-3.6, 0.0], [3.6, 0.0]]);
                for end in [-3.0, 3.0] {
                    self.line(Look::Line, [[end, -1.1], [end, 1.1]]);
                }
                self.box_of(Look::Hollow, 2.2, 1.1);
            }
            PairKind::Cylindrical if self.end_on() => {
                self.circle(Look::Hollow, 0.0, 1.5);
                self.circle(Look::Solid, 0.0, 0.5);
            }
            PairKind::Cylindrical => {
                self.line(Look::Line, [[-4.4, 0.0], [4.4, 0.0]]);
                self.box_of(Look::Hollow, 2.2, 1.1);
            }
            PairKind::Prismatic if self.end_on() => self.box_of(Look::Hollow, 1.3, 1.3),
            PairKind::Prismatic => {
                for side in [-0.45, 0.45] {
                    self.line(Look::Thin, [[-5.0, side], [5.0, side]]);
                }
                self.box_of(Look::Hollow, 2.3, 1.3);
            }
            PairKind::Screw { .. } if self.end_on() => {
                self.circle(Look::Hollow, 0.0, 1.5);
                self.circle(Look::Hollow, 0.0, 0.7);
            }
            PairKind::Screw { .. } => {
                self.line(Look::Line, [[-4.4, 0.0], [4.4, 0.0]]);
                self.box_of(Look::Hollow, 2.4, 1.2);
                let thread = (0..=6).map(|k| {
                    let side = if k % 2 == 0 { -1.2 } else { 1.2 };
                    self.flat(-2.4 + 0.8 * f64::from(k), side)
                });
                let thread: Vec<Point> = thread.collect();
                self.list.polyline(self.role, Look::Thin, &thread);
            }
            PairKind::Universal => {
                let [a, b] = [[2.4, 0.0], [0.0, 2.4]].map(|[along, across]| {
                    [-1.0, 1.0].map(|sign| self.point(sign * along, sign * across, 0.0))
                });
                for bar in [a, b] {
                    self.list.polyline(self.role, Look::Line, &bar);
                    for end in bar {
                        self.list
                            .circle(self.role, Look::Solid, end, 0.5 * self.unit);
                    }
                }
            }
            PairKind::Spherical => {
                self.cup();
                self.circle(Look::Hollow, 0.0, 1.3);
            }
            PairKind::Planar => {
                self.plate(-0.7);
                self.plate(0.7);
            }
            PairKind::SphereInCylinder => {
                if self.end_on() {
                    self.circle(Look::Hollow, 0.0, 2.0);
                } else {
                    for side in [-1.7, 1.7] {
                        self.line(Look::Line, [[-3.4, side], [3.4, side]]);
                    }
                }
                self.circle(Look::Hollow, 0.0, 1.3);
            }
            PairKind::CylinderOnPlane => {
                self.line(Look::Line, [[0.0, -3.0], [0.0, 3.0]]);
                self.box_of(Look::Solid, 0.35, 1.2);
            }
            PairKind::SphereOnPlane => {
                self.line(Look::Line, [[0.0, -3.0], [0.0, 3.0]]);
                self.circle(Look::Hollow, 1.1, 1.1);
            }
            PairKind::Class(_) => {
                let at = self.projection.place(self.at);
                let corners = parts::round(1.7 * self.unit, 4);
                let corners = corners.iter().map(|corner| at + corner.coords);
                self.list
                    .polygons(self.role, Look::Hollow, &[corners.collect()]);
            }
        }
    }

    /// Draws the end of a link at a pair from which the link was taken off.
    pub(super) fn stump(&mut self) {
        self.circle(Look::Hollow, 0.0, 0.8);
    }
}
