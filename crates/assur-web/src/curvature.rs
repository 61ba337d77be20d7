//! Curvature at an input: circles of curvature of traced points, and the inflection circle of a link.

use assur::curvature::{CircleOfCurvature, Circles, NoCircle};
use assur::mechanism::{LinkId, PointId, Pose};
use assur_file::{LinkageProblem, Problem};
use serde::Serialize;

use crate::moving::Moving;

/// Values of all drawn circles at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CurvatureHere<'a> {
    circles: Vec<CircleHere<'a>>,
    inflection: Option<InflectionHere<'a>>,
}

/// The circle of curvature of a point's path, or the reason why there is none.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CircleHere<'a> {
    point: &'a str,
    /// Radius with its first two derivatives, with respect to the variable chosen for the axes: input or time.
    radius: Option<[f64; 3]>,
    centre: Option<[f64; 2]>,
    #[cfg_attr(test, ts(type = "Problem | null"))]
    reason: Option<Problem>,
}

/// The inflection circle of a link, or the reason why there is none.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct InflectionHere<'a> {
    link: &'a str,
    diameter: Option<f64>,
    #[cfg_attr(test, ts(type = "Problem | null"))]
    reason: Option<Problem>,
}

impl Moving {
    /// Values of the drawn circles at an input.
    ///
    /// # Errors
    /// The reason why there is no pose, or why derivatives are unbounded.
    pub(crate) fn curvature(&self, input: f64) -> Result<CurvatureHere<'_>, Problem> {
        let pose: Pose<5> = (self.motion().pose(input)).map_err(|why| self.problem(&why))?;
        let circles = self.figure().curved().into_iter();
        let inflected = self.figure().inflected();
        Ok(CurvatureHere {
            circles: circles
                .map(|point| self.circle_here(&pose, point))
                .collect(),
            inflection: inflected.map(|link| self.inflection_here(&pose, link)),
        })
    }

    /// The circle of curvature of a point's path in a pose.
    ///
    /// # Errors
    /// The reason why there is no circle.
    pub(crate) fn circle(
        &self,
        pose: &Pose<5>,
        point: PointId,
    ) -> Result<CircleOfCurvature, Problem> {
        let mechanism = self.mechanism();
        let circle = CircleOfCurvature::of(&mechanism.place(pose, point), mechanism.size());
        circle.map_err(|reason| {
            let point = mechanism.point_name(point).to_owned();
            let problem = match reason {
                NoCircle::Still => LinkageProblem::StandsStill { point },
                NoCircle::Straight => LinkageProblem::StraightPath { point },
            };
            problem.into()
        })
    }

    fn circle_here(&self, pose: &Pose<5>, point: PointId) -> CircleHere<'_> {
        let name = self.mechanism().point_name(point);
        match self.circle(pose, point) {
            Ok(circle) => CircleHere {
                point: name,
                radius: Some([0, 1, 2].map(|order| self.input().rate(&circle.radius, order))),
                centre: Some(circle.centre.into()),
                reason: None,
            },
            Err(reason) => CircleHere {
                point: name,
                radius: None,
                centre: None,
                reason: Some(reason),
            },
        }
    }

    fn inflection_here(&self, pose: &Pose<5>, link: LinkId) -> InflectionHere<'_> {
        let mechanism = self.mechanism();
        let circles = Circles::of(mechanism, pose, mechanism.body_of(Some(link)));
        let link = mechanism.link_name(link);
        let none = || {
            LinkageProblem::NotTurning {
                link: link.to_owned(),
            }
            .into()
        };
        InflectionHere {
            link,
            diameter: circles.map(|circles| circles.diameter.norm()),
            reason: circles.is_none().then(none),
        }
    }
}
