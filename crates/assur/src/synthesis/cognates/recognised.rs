//! A four-bar or a slider-crank found around a traced point of a mechanism.

use super::{CouplerFourBar, CouplerSliderCrank};
use crate::Point;
use crate::linkage::{FRAME, LinkSpec, SlideSpec};
use crate::mechanism::{Mechanism, Pose};

impl CouplerFourBar {
    /// The four-bar whose coupler carries a traced point of a mechanism, in a pose: the link of the point is hinged to
    /// two links that are hinged to the frame. None if there is no such four-bar.
    pub fn of(mechanism: &Mechanism, pose: &Pose<1>, point: &str) -> Option<Self> {
        let carrier = Carrier::of(mechanism, point)?;
        let [first, second] = carrier.hinged()?;
        let place = |name: &str| carrier.place(pose, name);
        let pivots = [place(first.pivot)?, place(second.pivot)?];
        let joints = [place(first.joint)?, place(second.joint)?];
        Self::new(pivots, joints, place(point)?).ok()
    }
}

impl CouplerSliderCrank {
    /// The slider-crank whose rod carries a traced point of a mechanism, in a pose. None if there is no such
    /// slider-crank.
    pub fn of(mechanism: &Mechanism, pose: &Pose<1>, point: &str) -> Option<Self> {
        let carrier = Carrier::of(mechanism, point)?;
        let place = |name: &str| carrier.place(pose, name);
        let slide = carrier.slide()?;
        let arm = carrier.arms().find(|arm| arm.joint != slide.point)?;
        let [from, to] = &slide.line;
        let guide = place(to)? - place(from)?;
        let joints = [place(arm.joint)?, place(&slide.point)?];
        Self::new(place(arm.pivot)?, joints, guide, place(point)?).ok()
    }
}

/// The link that carries a point, with the mechanism.
struct Carrier<'a> {
    mechanism: &'a Mechanism,
    link: &'a LinkSpec,
}

/// A link hinged to the carrier and to the frame.
struct Arm<'a> {
    joint: &'a str,
    pivot: &'a str,
}

impl<'a> Carrier<'a> {
    fn of(mechanism: &'a Mechanism, point: &str) -> Option<Self> {
        let spec = mechanism.spec();
        let traced = spec.tracers.iter().find(|tracer| tracer.name == point);
        let link = match traced {
            Some(tracer) => spec.links.iter().find(|link| link.name == tracer.link)?,
            None => {
                let mut having = spec.links.iter().filter(|link| has(link, point));
                let only = having.next()?;
                (having.next().is_none()).then_some(only)?
            }
        };
        let grounded = link.points.iter().any(|name| spec.frame.contains(name));
        let free = !grounded && link.fixed_to.is_none();
        free.then_some(Self { mechanism, link })
    }

    fn place(&self, pose: &Pose<1>, name: &str) -> Option<Point> {
        let point = self.mechanism.point(name)?;
        Some(self.mechanism.place(pose, point).place())
    }

    /// Links without a slide or a weld that are hinged to the carrier and to the frame.
    fn arms(&self) -> impl Iterator<Item = Arm<'a>> {
        let (spec, carrier) = (self.mechanism.spec(), self.link);
        let slides = |link: &LinkSpec| (spec.slides.iter()).any(|slide| slide.link == link.name);
        let others = spec.links.iter().filter(move |link| {
            link.name != carrier.name && link.fixed_to.is_none() && !slides(link)
        });
        others.filter_map(move |link| {
            let joint = link.points.iter().find(|name| has(carrier, name))?;
            let pivot = link.points.iter().find(|name| spec.frame.contains(name))?;
            Some(Arm { joint, pivot })
        })
    }

    fn hinged(&self) -> Option<[Arm<'a>; 2]> {
        let mut arms = self.arms();
        let first = arms.next()?;
        let second = arms.find(|arm| arm.joint != first.joint)?;
        Some([first, second])
    }

    /// The slide on the frame of the carrier itself, or of a link hinged to it at the sliding point.
    fn slide(&self) -> Option<&'a SlideSpec> {
        let slides = self.mechanism.spec().slides.iter();
        let mut on_frame = slides.filter(|slide| slide.on == FRAME);
        on_frame.find(|slide| slide.link != self.link.name && has(self.link, &slide.point))
    }
}

fn has(link: &LinkSpec, point: &str) -> bool {
    link.points.iter().any(|name| name == point)
}
