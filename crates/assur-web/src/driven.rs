//! The new input after the driver is dragged.

use std::f64::consts::{PI, TAU};

use assur::Point;
use assur::mechanism::{Mechanism, PointId, Pose};
use assur::motion::Motion;
use assur_file::LinkageDocument;

/// The handle of the driver: the point that is dragged to change the input.
#[derive(Clone, Copy)]
pub(crate) enum Driven {
    /// The end of a crank that turns about its pivot.
    Crank { pivot: PointId, end: PointId },
    /// A point that slides on a line. The line is directed from its first point to its second.
    Slide { line: [PointId; 2], end: PointId },
}

impl Driven {
    /// The point that is dragged.
    pub(crate) fn end(self) -> PointId {
        match self {
            Self::Crank { end, .. } | Self::Slide { end, .. } => end,
        }
    }

    /// The input that brings the dragged point nearest to a target position, starting from a pose.
    pub(crate) fn dragged(self, motion: &Motion, pose: &Pose<1>, input: f64, to: Point) -> f64 {
        let at = |point: PointId| motion.mechanism().place(pose, point).place();
        match self {
            Self::Crank { pivot, end } => {
                let angle = |place: Point| {
                    let along = place - at(pivot);
                    along.y.atan2(along.x)
                };
                let by = angle(to) - angle(at(end));
                input + by - TAU * ((by + PI) / TAU).floor()
            }
            Self::Slide {
                line: [from, towards],
                end,
            } => {
                let along = (at(towards) - at(from)).normalize();
                let [least, most] = motion.cycle().arcs()[0];
                (input + along.dot(&(to - at(end)))).clamp(least, most)
            }
        }
    }

    /// The handle of the only driver; none if there are several drivers, or if the driver is a crank on a moving link.
    pub(crate) fn of(document: &LinkageDocument, mechanism: &Mechanism) -> Option<Self> {
        let [driver] = &document.drivers[..] else {
            return None;
        };
        let point = |name: &String| mechanism.point(name);
        if let Some(slide) = driver.slide {
            let slide = document.slides.get(slide)?;
            let [from, towards] = &slide.line;
            return Some(Self::Slide {
                line: [point(from)?, point(towards)?],
                end: point(&slide.point)?,
            });
        }
        let name = driver.crank.as_ref().filter(|_| driver.base.is_none())?;
        let link = document.links.iter().find(|link| link.name == *name)?;
        let fixed = |name: &&String| document.frame.contains(name);
        Some(Self::Crank {
            pivot: point(link.points.iter().find(fixed)?)?,
            end: point(link.points.iter().find(|name| !fixed(name))?)?,
        })
    }
}
