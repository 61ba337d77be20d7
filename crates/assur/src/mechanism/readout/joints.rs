//! The pairs between the rigid bodies of a mechanism, and the motion of the bodies in a pose.

use crate::index::{BodyId, PointId};
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::{LinkOrFrame, Mechanism, Pose};
use crate::position::{BodyPoint, Complex, conjugate, product};
use crate::{Jet, JetPoint, Point, Vector};

/// Pair between bodies, with the bodies that it joins.
#[derive(Clone, Debug, PartialEq)]
pub enum Joint {
    /// A hinge of two bodies or more.
    Hinge {
        /// Point of the hinge.
        point: PointId,
        /// Bodies hinged at the point, in ascending order.
        bodies: Vec<BodyId>,
    },
    /// A slide.
    Slide {
        /// Body with the line, and body that slides.
        bodies: [BodyId; 2],
        /// Point of the sliding body that keeps its distance from the line.
        point: PointId,
        /// Two points of the body with the line, through which the line runs.
        line: [PointId; 2],
    },
    /// Wheels in mesh: `z₁(ω₁ − ω₀) + z₂(ω₂ − ω₀) = 0` with the angular velocities ω₁ and ω₂ of the wheels and ω₀ of
    /// the carrier.
    Mesh {
        /// The wheels.
        bodies: [BodyId; 2],
        /// Body to which both wheels are hinged.
        carrier: BodyId,
        /// Numbers of teeth z₁ and z₂. z₂ is negative if, seen from the carrier, both wheels turn in the same sense.
        teeth: [f64; 2],
    },
}

impl Joint {
    /// Bodies that the pair joins.
    pub fn bodies(&self) -> &[BodyId] {
        match self {
            Self::Hinge { bodies, .. } => bodies,
            Self::Slide { bodies, .. } | Self::Mesh { bodies, .. } => bodies,
        }
    }
}

impl Mechanism {
    /// Body of a link: the link's own, or the body to which it is fixed.
    pub fn body_of(&self, link: LinkOrFrame) -> BodyId {
        self.layout.body_of(link)
    }

    /// Points of a body that are listed by its links, in the order of these lists.
    pub fn points_on(&self, body: BodyId) -> impl Iterator<Item = PointId> {
        self.layout.bodies.of(body).iter().map(|(point, _)| *point)
    }

    /// Pairs between the bodies: hinges in the order of the points, then slides, then wheels in mesh.
    pub fn joints(&self) -> Vec<Joint> {
        let points = self.point_ids().take(self.layout.listed);
        let hinges = points.filter_map(|point| {
            let bodies = self.bodies();
            let bodies = bodies.filter(|body| self.points_on(*body).any(|other| other == point));
            let bodies: Vec<BodyId> = bodies.collect();
            (bodies.len() > 1).then_some(Joint::Hinge { point, bodies })
        });
        let Bodies { slides, gears, .. } = &self.layout.bodies;
        let slides = slides.iter().map(|slide| Joint::Slide {
            bodies: slide.bodies,
            point: slide.by_link.point,
            line: slide.by_link.line,
        });
        let meshes = gears.iter().map(|gear| Joint::Mesh {
            bodies: gear.bodies,
            carrier: gear.carrier,
            teeth: gear.signed_teeth(),
        });
        hinges.chain(slides).chain(meshes).collect()
    }

    /// Angle of a body in a pose, radians, with its derivatives with respect to the input.
    pub fn body_angle<const N: usize>(&self, pose: &Pose<N>, body: BodyId) -> Jet<N> {
        pose.state.angle(body)
    }

    /// Motion of the point of a body that is at a given place in a pose. The point need not be in the specification.
    /// The value is the given place; the derivatives follow from the motion of the body.
    pub fn fixed_to<const N: usize>(
        &self,
        pose: &Pose<N>,
        body: BodyId,
        place: Point,
    ) -> JetPoint<N> {
        let of = &pose.state.bodies[body];
        let (origin, turn) = (&of.origin, &of.turn);
        let way = place.coords - self.layout.origin - origin.value();
        let local = product(way, conjugate(turn.value()));
        let place = pose.state.place(BodyPoint { body, local });
        (place + Complex::constant(self.layout.origin)).into()
    }

    /// Unit vector from one point of a body to another in a pose, accurate to all digits even if the points are close.
    /// None if they coincide, or if the body lacks one of them.
    pub(crate) fn heading<const N: usize>(
        &self,
        pose: &Pose<N>,
        body: BodyId,
        [from, to]: [PointId; 2],
    ) -> Option<Vector> {
        let local = |point: PointId| self.layout.bodies.local(body, point);
        let heading = self
            .turned(pose, body, local(to)? - local(from)?)
            .normalize();
        Some(heading).filter(|heading| heading.norm_squared().is_finite())
    }

    /// Converts a direction on a body to the coordinates of the frame, in a pose.
    pub(crate) fn turned<const N: usize>(
        &self,
        pose: &Pose<N>,
        body: BodyId,
        local: Vector,
    ) -> Vector {
        product(local, pose.state.bodies[body].turn.value())
    }

    /// The first point that two bodies share.
    pub(crate) fn shared_by(&self, [one, other]: [BodyId; 2]) -> Option<PointId> {
        let bodies = &self.layout.bodies;
        let mut points = self.points_on(one);
        points.find(|point| bodies.local(other, *point).is_some())
    }

    /// The traced points that a body carries.
    pub(crate) fn tracers_on(&self, body: BodyId) -> impl Iterator<Item = PointId> {
        let tracers = self.layout.tracers();
        tracers.filter(move |tracer| self.layout.points[*tracer].body == body)
    }

    /// Point of the drawing in the coordinates used while solving, divided by the size of the linkage.
    pub(crate) fn scaled(&self, place: Point) -> Vector {
        (place.coords - self.layout.origin) / self.scale_of_places()
    }

    /// Inverse of [`Self::scaled`].
    pub(crate) fn unscaled(&self, place: Vector) -> Point {
        (place * self.scale_of_places() + self.layout.origin).into()
    }

    /// Twist of a body: a velocity and an angular velocity, both with respect to the input. The velocity belongs to the
    /// point of the body at the origin of [`Self::scaled`], and is in the unit of these coordinates.
    pub(crate) fn twist<const N: usize>(&self, pose: &Pose<N>, body: BodyId) -> (Vector, f64) {
        let origin: JetPoint<N> = pose.state.bodies[body].origin.into();
        let spin = pose.state.angle(body).derivative(1);
        let at = origin.place().coords;
        let velocity = origin.derivative(1) - spin * crate::perpendicular(at);
        (velocity / self.scale_of_places(), spin)
    }

    /// Origin of the coordinates used while solving. It is near the drawing.
    pub(crate) fn middle(&self) -> Point {
        self.layout.origin.into()
    }

    /// Unit of [`Self::scaled`]: the size of the linkage, or 1 if this size is zero.
    pub(crate) fn scale_of_places(&self) -> f64 {
        let size = self.size();
        if size > 0.0 { size } else { 1.0 }
    }
}
