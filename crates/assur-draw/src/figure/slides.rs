//! Blocks and the guides they slide on.

use assur::mechanism::{DraftSlide, LinkId, LinkOrFrame, Mechanism, Pose};
use assur::{Point, Vector};

use super::layout::{self, Layout};
use super::paths::Run;
use crate::list::{List, Look, Role};
use crate::parts;

/// Half length and half width of a block, in units.
const BLOCK: [f64; 2] = [2.6, 1.7];

/// A prismatic pair as it is drawn.
#[derive(Clone, Debug)]
pub(super) struct Guide {
    on: LinkOrFrame,
    on_role: Role,
    /// On the link that has the line: the ends of the way.
    ends: [Point; 2],
    link: LinkId,
    role: Role,
    /// On the link that slides: its point, the block's middle and the line's
    /// direction.
    point: Point,
    middle: Point,
    direction: Vector,
}

/// The prismatic pairs of a mechanism, with the ways that are used over the motion.
pub(super) fn guides(
    layout: &Layout,
    mechanism: &Mechanism,
    home: &Pose<1>,
    runs: &[Run],
) -> Vec<Guide> {
    let guide = |slide: &DraftSlide| -> Option<Guide> {
        let link = mechanism.link(&slide.link)?;
        let on = mechanism.link(&slide.on);
        let point = mechanism.point(&slide.point)?;
        let [from, to] = [&slide.line[0], &slide.line[1]].map(|point| mechanism.point(point));
        let [from, to] = [from?, to?];
        let [start, end] = [from, to].map(|k| layout::local(mechanism, home, on, k));
        let along = (end - start).normalize();
        let way = |pose: &Pose<1>| {
            let at = layout::local(mechanism, pose, on, point);
            (at - start).dot(&along)
        };
        let ways = runs.iter().flatten().map(|(_, pose)| way(pose));
        let [low, high] = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], way| {
            [low.min(way), high.max(way)]
        });
        if low > high {
            return None;
        }
        // Of a link the rod begins where the link is drawn.
        let [low, high] = match on {
            Some(_) => [low.min((end - start).norm()), high.max(0.0)],
            None => [low, high],
        };
        let (_, on_angle) = layout::body(mechanism, home, on);
        let (_, angle) = layout::body(mechanism, home, Some(link));
        let at = layout::local(mechanism, home, Some(link), point);
        let off = layout::local(mechanism, home, on, point) - (start + along * way(home));
        Some(Guide {
            on,
            on_role: on.map_or(Role::Secondary, |on| layout.drawn_role(on)),
            ends: [low, high].map(|way| start + along * way),
            link,
            role: layout.drawn_role(link),
            point: at,
            middle: at - layout::turned(off, on_angle - angle),
            direction: layout::turned(along, on_angle - angle),
        })
    };
    mechanism.draft().slides.iter().filter_map(guide).collect()
}

impl Guide {
    /// The ends of a way on the frame.
    pub(super) fn on_frame(&self) -> impl Iterator<Item = Point> {
        let ends = self.on.is_none().then_some(self.ends);
        ends.into_iter().flatten()
    }

    /// The line: of the frame hatched on one side, of a link a rod.
    pub(super) fn draw_line(&self, list: &mut List, u: f64) {
        let [from, to] = self.ends;
        let along = self.along();
        let [from, to] = [from - along * (4.0 * u), to + along * (4.0 * u)];
        list.body(layout::number(self.on));
        if self.on.is_some() {
            parts::bar(list, self.on_role, from, to, 0.7 * u);
        } else {
            list.polyline(Role::Secondary, Look::Line, &[from, to]);
            let below = Vector::new(along.y, -along.x);
            let count = ((to - from).norm() / (2.0 * u)).floor().min(400.0) as usize;
            for i in 0..count {
                let at = from + along * (2.0 * u * (i as f64 + 0.8));
                let hatch = [at, at + (below - along) * (0.8 * u)];
                list.polyline(Role::Secondary, Look::Thin, &hatch);
            }
        }
    }

    pub(super) fn draw_block(&self, list: &mut List, u: f64) {
        list.body(layout::number(Some(self.link)));
        if (self.point - self.middle).norm() > 0.1 * u {
            parts::bar(list, self.role, self.point, self.middle, 0.9 * u);
        }
        let along = self.direction * (BLOCK[0] * u);
        let across = Vector::new(-self.direction.y, self.direction.x) * (BLOCK[1] * u);
        let corners = [
            self.middle + along + across,
            self.middle - along + across,
            self.middle - along - across,
            self.middle + along - across,
        ];
        list.polygons(self.role, Look::Hollow, &[corners.to_vec()]);
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
