//! Blocks and their guides; the ground line.

use assur::mechanism::{DriverSpec, LinkId, LinkOrFrame, Mechanism, PointId, Pose, SlideSpec};
use assur::sorting::extremes;
use assur::{Point, Vector, nearest, perpendicular};

use super::View;
use super::layout::{self, Layout};
use super::paths::Run;
use super::posed::Posed;
use crate::list::{List, Look, Role};
use crate::parts::{self, BLOCK};

/// Length by which a guide extends beyond the middle of the block at either end of its stroke, in symbol units.
const BEYOND: f64 = 5.0;
/// Half the width of the bar around a slot, in symbol units.
const AROUND_SLOT: f64 = 2.4;
/// Half the length of the arrow of a driven block, in symbol units.
const ARROW: f64 = 4.0;
/// Distance of the arrow of a driven block from the middle of the block, in symbol units.
const BESIDE: f64 = 3.4;
/// Distance from the walls of a channel up to which its inside is cleared, in symbol units.
const WALL: f64 = 0.15;
/// Number of poses from one examined pose to the next, in the search for the outer side of a guide.
const LOOKED_AT: usize = 16;

/// A prismatic pair as it is drawn.
#[derive(Clone, Debug)]
pub(super) struct Guide {
    on: LinkOrFrame,
    on_role: Role,
    way: Way,
    /// Ends of the path of the block's middle, in the coordinates of the link with the line.
    ends: [Point; 2],
    link: LinkId,
    role: Role,
    /// Sliding point; like `middle` and `direction`, in the coordinates of the sliding link.
    point: Point,
    /// Middle of the block.
    middle: Point,
    /// Direction of the line.
    direction: Vector,
    /// Whether the block has the arrow of a driver.
    driven: bool,
}

/// Kind of a guide.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// A line of the frame, hatched on this side.
    Line(Vector),
    /// Two lines of the frame, one on either side of the block, for guides that cross.
    Channel,
    /// A rod through the block.
    Rod,
    /// A slot in a link that itself slides, such as that of a Scotch yoke.
    Slot,
}

/// Returns the prismatic pairs of a mechanism, with the paths of their blocks over the motion.
pub(super) fn guides(layout: &Layout, home: Posed<'_, 1>, runs: &[Run], view: &View) -> Vec<Guide> {
    let mechanism = home.mechanism;
    let driver = match mechanism.spec().drivers.first() {
        Some(DriverSpec::Slide { slide, .. }) if view.annotations.input.is_some() => Some(*slide),
        _ => None,
    };
    let guide = |(index, slide): (usize, &SlideSpec)| -> Option<Guide> {
        let link = mechanism.link(&slide.link)?;
        let on = mechanism.link(&slide.on);
        let point = mechanism.point(&slide.point)?;
        let [from, to] = [&slide.line[0], &slide.line[1]].map(|point| mechanism.point(point));
        let [from, to] = [from?, to?];
        let [start, end] = [from, to].map(|k| home.local(on, k));
        let along = (end - start).normalize();
        let way = |pose: &Pose<1>| {
            let posed = Posed { mechanism, pose };
            (posed.local(on, point) - start).dot(&along)
        };
        let ways = runs.iter().flatten().map(|(_, pose)| way(pose));
        let [low, high] = extremes(ways);
        if low > high {
            return None;
        }
        let length = (end - start).norm();
        let (kind, [low, high]) = if on.is_none() {
            let side = outer(layout, mechanism, runs, [start, end]);
            (Way::Line(side), [low, high])
        } else if layout::slides(mechanism, &slide.on) {
            // A slot is at least as long as the line on its link.
            (Way::Slot, [low.min(0.0), high.max(length)])
        } else {
            // If the block does not reach the line on the link, the rod is extended to that line.
            (Way::Rod, [low.min(length), high.max(0.0)])
        };
        let (_, on_angle) = home.body(on);
        let (_, angle) = home.body(Some(link));
        let at = home.local(Some(link), point);
        let off = home.local(on, point) - (start + along * way(home.pose));
        Some(Guide {
            on,
            on_role: on.map_or(Role::Secondary, |on| layout.drawn_role(on)),
            way: kind,
            ends: [low, high].map(|way| start + along * way),
            link,
            role: layout.drawn_role(link),
            point: at,
            middle: at - layout::turned(off, on_angle - angle),
            direction: layout::turned(along, on_angle - angle),
            driven: driver == Some(index),
        })
    };
    let slides = mechanism.spec().slides.iter().enumerate();
    let mut guides: Vec<Guide> = slides.filter_map(guide).collect();
    let crossing = |guide: &Guide| guides.iter().any(|other| guide.crosses(other));
    let crossing: Vec<bool> = guides.iter().map(crossing).collect();
    for (guide, crossing) in guides.iter_mut().zip(crossing) {
        if crossing {
            guide.way = Way::Channel;
        }
    }
    guides
}

/// Returns the side of a frame line that faces away from the mechanism, or the lower side if both sides have points.
fn outer(layout: &Layout, mechanism: &Mechanism, runs: &[Run], [start, end]: [Point; 2]) -> Vector {
    let along = (end - start).normalize();
    let points = mechanism.point_ids();
    let points: Vec<_> = points.filter(|point| layout.is_joint(*point)).collect();
    let poses = runs.iter().flatten().step_by(LOOKED_AT);
    let offs = poses.flat_map(|(_, pose)| {
        let off = |point: &PointId| mechanism.place(pose, *point).place() - start;
        points.iter().map(off)
    });
    parts::outer(parts::lower(along), offs)
}

/// Returns the ends of the ground line and a point at the lower edge of its hatching. None if the drawing has no ground
/// line or the line is far from the mechanism.
pub(super) fn ground(
    [left, bottom, right, top]: [f64; 4],
    size: f64,
    height: Option<f64>,
) -> Option<[Point; 3]> {
    let height = height.filter(|y| (bottom - size..=top + size).contains(y))?;
    let [u, hatch] = [size / 100.0, parts::HATCH * size / 100.0];
    Some([
        Point::new(left - BEYOND * u, height),
        Point::new(right + BEYOND * u, height),
        Point::new(right, height - hatch),
    ])
}

impl Guide {
    /// Returns the ends of a guide on the frame.
    pub(super) fn on_frame(&self) -> impl Iterator<Item = Point> {
        let ends = self.on.is_none().then_some(self.ends);
        ends.into_iter().flatten()
    }

    /// Returns the outer corners of the hatching on the frame.
    pub(super) fn reach(&self, u: f64) -> impl Iterator<Item = Point> {
        let [from, to] = self.drawn(u);
        let sides = match self.way {
            Way::Line(side) => vec![side * (parts::HATCH + BLOCK[1])],
            Way::Channel => [-1.0, 1.0]
                .map(|side| self.across() * (side * (parts::HATCH + BLOCK[1])))
                .to_vec(),
            Way::Rod | Way::Slot => Vec::new(),
        };
        sides
            .into_iter()
            .flat_map(move |side| [from + side * u, to + side * u])
    }

    /// Whether both guides are on the frame and the paths of their blocks cross.
    fn crosses(&self, other: &Self) -> bool {
        let apart = |one: &Self, [a, b]: [Point; 2]| {
            let side = |at: Point| one.along().perp(&(at - one.ends[0]));
            side(a) * side(b) < 0.0
        };
        let on_frame = self.on.is_none() && other.on.is_none();
        on_frame && apart(self, other.ends) && apart(other, self.ends)
    }

    /// Whether the guide is a slot in this link.
    pub(super) fn is_slot_of(&self, link: LinkId) -> bool {
        self.way == Way::Slot && self.on == Some(link)
    }

    /// Draws a guide other than a slot: a line or a channel of the frame with hatching on the outer side, or a rod on a
    /// link.
    pub(super) fn draw_line(&self, list: &mut List, u: f64) {
        let ends = self.drawn(u);
        list.body(layout::number(self.on));
        let mut wall = |side: Vector| {
            let [from, to] = ends.map(|end| end + side * (BLOCK[1] * u));
            parts::hatched(list, [from, to], side, u);
        };
        match self.way {
            Way::Line(side) => wall(side),
            Way::Channel => [self.across(), -self.across()].into_iter().for_each(wall),
            Way::Rod => parts::bar(list, self.on_role, ends[0], ends[1], 0.7 * u),
            Way::Slot => {}
        }
    }

    /// Erases, inside a channel, the walls of the channels that cross it.
    pub(super) fn empty(&self, list: &mut List, u: f64) {
        if self.way == Way::Channel {
            let [from, to] = self.drawn(u);
            let half = [(to - from) / 2.0, self.across() * ((BLOCK[1] - WALL) * u)];
            list.body(0);
            let corners = parts::rectangle(from + half[0], half);
            list.polygons(Role::Paper, Look::Solid, &[corners]);
        }
    }

    /// Draws a link with a slot, and arms from the slot to the other corners of the link.
    pub(super) fn draw_slot(&self, list: &mut List, corners: &[Point], arm: f64, u: f64) {
        let [from, to] = self.ends;
        for corner in corners {
            let foot = nearest(*corner, from, to);
            let off = corner - foot;
            let edge = off.normalize() * (BLOCK[1] * u + arm);
            if off.norm() > 2.0 * edge.norm() {
                parts::bar(list, self.on_role, foot + edge, *corner, arm);
            }
        }
        parts::slot(
            list,
            self.on_role,
            [from, to],
            [AROUND_SLOT * u, BLOCK[1] * u],
        );
    }

    pub(super) fn draw_block(&self, list: &mut List, u: f64) {
        list.body(layout::number(Some(self.link)));
        let ends = [self.point, self.middle];
        parts::block(list, self.role, ends, self.direction, u);
        if self.driven {
            let across = perpendicular(self.direction);
            let free = match self.way {
                Way::Line(side) => -side.dot(&self.across()).signum(),
                _ => 1.0,
            };
            let beside = self.middle - across * (free * BESIDE * u);
            let half = self.direction * (ARROW * u);
            parts::arrow(list, self.role, beside - half, beside + half, u);
        }
    }

    /// Returns the ends of the drawn guide, which supports the block over its whole stroke.
    fn drawn(&self, u: f64) -> [Point; 2] {
        let beyond = self.along() * (BEYOND * u);
        [self.ends[0] - beyond, self.ends[1] + beyond]
    }

    fn across(&self) -> Vector {
        let along = self.along();
        Vector::new(along.y, -along.x)
    }

    fn along(&self) -> Vector {
        let along = self.ends[1] - self.ends[0];
        let length = along.norm();
        if length > 0.0 {
            along / length
        } else {
            Vector::x()
        }
    }
}
