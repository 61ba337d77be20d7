//! Drivers: their coordinates in the drawing, and the steps that place the driven bodies.

use crate::Vector;
use crate::index::{BodyId, PointId, SlideId};
use crate::linkage::spec::Defect;
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::plan::resolved::{Driver, Resolved};
use crate::mechanism::plan::{Drawn, Placed};
use crate::position::{BodyPoint, Crank, DriveLaw, Slider, Step};

/// Driven pair between two bodies of one group; its coordinate is given when the group is solved.
pub(in crate::mechanism) struct DrivenPair {
    pub(in crate::mechanism) kind: PairKind,
    pub(in crate::mechanism) course: DriveLaw,
}

pub(in crate::mechanism) enum PairKind {
    /// Hinge, with the driven body and its base. The coordinate is the angle between the two bodies plus an offset.
    Hinge {
        bodies: [BodyId; 2],
        angle_offset: f64,
    },
    /// Slide, with its minimum and maximum coordinate.
    Slide { slide: SlideId, range: [f64; 2] },
}

impl DrivenPair {
    pub(in crate::mechanism) fn new(
        placed: &Placed<'_>,
        spec: &Resolved<'_>,
        driver: &Driver,
        course: DriveLaw,
    ) -> Self {
        let kind = match driver {
            Driver::Crank { link, base, .. } => PairKind::Hinge {
                bodies: [*link, *base].map(|link| spec.body(link)),
                angle_offset: placed.angle_offset(driver),
            },
            Driver::Slide { slide, range, .. } => PairKind::Slide {
                slide: *slide,
                range: *range,
            },
        };
        Self { kind, course }
    }

    /// True if the pair turns this body relative to another one.
    pub(in crate::mechanism) fn turns(&self, body: BodyId) -> bool {
        match &self.kind {
            PairKind::Hinge { bodies, .. } => bodies.contains(&body),
            PairKind::Slide { .. } => false,
        }
    }
}

impl Bodies {
    /// Hinge between two bodies: its point, its position on the base, and its position on the other body. None if the
    /// bodies share no point.
    pub(in crate::mechanism) fn hinge(
        &self,
        [base, body]: [BodyId; 2],
    ) -> Option<(PointId, BodyPoint, Vector)> {
        self.of(body).iter().find_map(|(point, hinge)| {
            let local = self.local(base, *point)?;
            Some((*point, BodyPoint { body: base, local }, *hinge))
        })
    }
}

pub(in crate::mechanism) fn drawn_beyond_range(
    spec: &Resolved<'_>,
    bodies: &Bodies,
) -> Vec<Defect> {
    let beyond = spec.drivers.iter().filter_map(|driver| {
        let Driver::Slide { slide, range, .. } = driver else {
            return None;
        };
        let at = bodies.slides[*slide].drawn_way();
        let [from, to] = *range;
        (!(from..=to).contains(&at)).then(|| Defect::DrawnBeyondRange {
            link: spec.link_name(spec.driven(driver)).to_owned(),
            at,
            from,
            to,
        })
    });
    beyond.collect()
}

impl Placed<'_> {
    /// Angle between a driven link and its base, less the angle between their bodies.
    fn angle_offset(&self, driver: &Driver) -> f64 {
        match driver {
            Driver::Crank { link, base, .. } => {
                let [link, base] = [link, base]
                    .map(|link| link.map_or(0.0, |link| self.placements[link].angle_offset));
                link - base
            }
            Driver::Slide { .. } => 0.0,
        }
    }

    /// Drawn coordinate of a driver; the coordinate of a slide is limited to its range.
    pub(in crate::mechanism) fn drawn(&self, spec: &Resolved<'_>, driver: &Driver) -> f64 {
        match driver {
            Driver::Crank { link, base, .. } => {
                let angle = |link| self.orientations[spec.body(link)].angle;
                angle(*link) - angle(*base) + self.angle_offset(driver)
            }
            Driver::Slide { slide, range, .. } => {
                let way = self.bodies.slides[*slide].drawn_way();
                way.clamp(range[0], range[1])
            }
        }
    }

    /// Drawn input. The angle of a crank relative to a moving link is reduced to at most half a turn. If the pose is
    /// known, the input and the driven link's angle get the number of whole turns that they have in this pose.
    pub(in crate::mechanism) fn drawn_input(
        &mut self,
        spec: &Resolved<'_>,
        first: &Driver,
        known: Option<Drawn<'_>>,
    ) -> f64 {
        let drawn = self.drawn(spec, first);
        let Driver::Crank { link, base, .. } = first else {
            return drawn;
        };
        let [link, base] = [*link, *base].map(|link| spec.body(link));
        let near = match known {
            Some(Drawn { input, .. }) => input,
            None if base == BodyId::FRAME => drawn,
            None => 0.0,
        };
        let turned = crate::angle::whole_turns(near - drawn);
        if link == BodyId::FRAME {
            self.orientations[base].angle -= turned;
        } else {
            self.orientations[link].angle += turned;
        }
        drawn + turned
    }

    /// Step of a driver that places `body` after `base` is placed. Either of the two may be the driven body.
    pub(in crate::mechanism) fn driven(
        &self,
        spec: &Resolved<'_>,
        driver: &Driver,
        [base, body]: [BodyId; 2],
        course: DriveLaw,
    ) -> Option<Step> {
        match driver {
            Driver::Crank { link, .. } => {
                let (joint, at, hinge) = self.bodies.hinge([base, body])?;
                let angle_offset = self.angle_offset(driver);
                let (angle_offset, course) = if spec.body(*link) == body {
                    (angle_offset, course)
                } else {
                    (-angle_offset, course.reversed())
                };
                let crank = Crank {
                    body,
                    at,
                    hinge,
                    joint,
                    angle_offset,
                    law: course,
                };
                Some(crank.into())
            }
            Driver::Slide { slide, range, .. } => {
                let slide = &self.bodies.slides[*slide];
                let [from, to] = *range;
                let (range, course) = if slide.bodies == [base, body] {
                    (*range, course)
                } else {
                    ([-to, -from], course.reversed())
                };
                let slider = Slider {
                    track: slide.track(body),
                    range,
                    law: course,
                };
                Some(slider.into())
            }
        }
    }
}
