//! Poses of a body, with the curves and points on which the hinges of a linkage may lie; points of a path.

use assur::{Point, Vector};

use crate::figure::bounds;
use crate::list::{List, Look, Role};

/// Poses of a body, or a path, with the curves and points that help to choose a linkage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Guidance {
    /// The poses.
    pub poses: Vec<DrawnPose>,
    /// Curves and lines, dashed or not. They need not be within the drawing.
    pub curves: Vec<(Vec<Point>, Role, bool)>,
    /// Points with their names, and whether they are chosen.
    pub points: Vec<(String, Point, Role, bool)>,
    /// A wanted curve.
    pub path: Vec<Point>,
    /// Points of a path with their numbers, and whether they are met.
    pub marks: Vec<(String, Point, bool)>,
}

/// A pose of the body.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPose {
    /// Number of the pose, and whatever is written with it.
    pub number: String,
    /// Outline of the body.
    pub outline: Vec<Point>,
    /// The body's origin, a handle that moves the pose.
    pub origin: Point,
    /// End of the body's x-axis, a handle that turns the pose.
    pub tip: Point,
    /// Colour.
    pub role: Role,
}

/// Role of a wanted path.
const PATH: Role = Role::Accent2;

/// Margin around poses that are drawn alone, as a part of the drawing's size.
const ROOM: f64 = 0.12;

/// Distance of the number from the end of the body's x-axis, in text heights.
const BEYOND: f64 = 1.3;

impl Guidance {
    /// Returns the points that must be within the drawing: those of poses and of the path, but not the curves of
    /// hinges, which have no end.
    pub(crate) fn reach(&self) -> impl Iterator<Item = Point> + '_ {
        let poses = self.poses.iter();
        let poses =
            poses.flat_map(|pose| pose.outline.iter().copied().chain([pose.origin, pose.tip]));
        let marks = self.marks.iter().map(|(_, at, _)| *at);
        poses.chain(self.path.iter().copied()).chain(marks)
    }

    /// Returns the texts of the labels, in the order in which they are drawn.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &String> {
        let numbers = self.poses.iter().map(|pose| &pose.number);
        let points = self.points.iter().map(|(name, ..)| name);
        let marks = self.marks.iter().map(|(name, ..)| name);
        numbers.chain(points).chain(marks)
    }

    /// Draws everything; `names` are the indices of the labels.
    pub(crate) fn draw(&self, list: &mut List, names: &[usize], unit: f64) {
        for (points, role, dashed) in &self.curves {
            let look = if *dashed { Look::Dashed } else { Look::Line };
            list.polyline(*role, look, points);
        }
        if !self.path.is_empty() {
            list.polyline(PATH, Look::Dashed, &self.path);
        }
        let (numbers, letters) = names.split_at(self.poses.len().min(names.len()));
        let (letters, marks) = letters.split_at(self.points.len().min(letters.len()));
        for (pose, name) in self.poses.iter().zip(numbers) {
            let outline = std::slice::from_ref(&pose.outline);
            list.polygons(pose.role, Look::Pale, outline);
            list.polyline(pose.role, Look::Line, &[pose.origin, pose.tip]);
            list.circle(pose.role, Look::Solid, pose.origin, 0.9 * unit);
            list.circle(pose.role, Look::Hollow, pose.tip, 1.4 * unit);
            let along: Vector = pose.tip - pose.origin;
            let length = along.norm();
            if length > 0.0 {
                let off = along * (BEYOND / length);
                list.name(pose.role, *name, pose.tip, [off.x, off.y]);
            }
        }
        for ((_, at, role, is_chosen), name) in self.points.iter().zip(letters) {
            let look = if *is_chosen {
                Look::Solid
            } else {
                Look::Hollow
            };
            list.circle(*role, look, *at, unit);
            list.name(*role, *name, *at, [1.0, 1.0]);
        }
        for ((_, at, is_met), name) in self.marks.iter().zip(marks) {
            let look = if *is_met { Look::Solid } else { Look::Hollow };
            list.circle(PATH, look, *at, unit);
            list.name(PATH, *name, *at, [1.0, 1.0]);
        }
    }
}

/// The drawing of poses or a path without a linkage.
#[derive(Clone, Debug)]
pub struct GuidanceSheet {
    names: Vec<String>,
    bounds: [f64; 4],
    list: List,
}

impl GuidanceSheet {
    /// Makes the drawing; `symbol` is the symbol unit, by default a hundredth of the drawing's size.
    pub fn new(guidance: &Guidance, symbol: Option<f64>) -> Self {
        let around = bounds::around(guidance.reach());
        let size = bounds::size(around);
        let room = ROOM * size;
        let [left, bottom, right, top] = around;
        let names: Vec<String> = guidance.labels().cloned().collect();
        let indices: Vec<usize> = (0..names.len()).collect();
        let mut list = List::default();
        list.body(0);
        guidance.draw(&mut list, &indices, symbol.unwrap_or(size / 100.0));
        Self {
            names,
            bounds: [left - room, bottom - room, right + room, top + room],
            list,
        }
    }

    /// Returns the names to which labels refer by index.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the rectangle around the drawing: left, bottom, right, top.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Returns the pose of the frame and the display list, as [`crate::Figure::frame`] does.
    pub fn frame(&self) -> Vec<f32> {
        let mut numbers = vec![1.0, 0.0, 0.0, 0.0];
        numbers.extend(self.list.numbers());
        numbers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One pose: an outline, a line, two circles and a label; its reach is 2 by 1.
    #[test]
    fn a_pose_alone() {
        let at = |x: f64, y: f64| Point::new(x, y);
        let pose = DrawnPose {
            number: "1".to_owned(),
            outline: vec![at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)],
            origin: at(0.0, 0.0),
            tip: at(2.0, 0.0),
            role: Role::Accent3,
        };
        let guidance = Guidance {
            poses: vec![pose],
            ..Guidance::default()
        };
        let sheet = GuidanceSheet::new(&guidance, None);
        let room = ROOM * 5.0_f64.sqrt();
        assert_eq!(sheet.bounds(), [-room, -room, 2.0 + room, 1.0 + room]);
        assert_eq!(sheet.names(), ["1"]);
        // Frame, body, polygon of 3 corners, line of 2 points, two circles, label.
        assert_eq!(sheet.frame().len(), 4 + 2 + (5 + 6) + (4 + 4) + 6 + 6 + 7);
    }
}
