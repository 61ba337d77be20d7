//! Freedoms and constraints of a pair as screws.
//!
//! A twist (ω, v) is the angular velocity of a body with the velocity of its point at the origin. A wrench (m, f), a
//! moment with a force, forbids the twists for which m·ω + f·v ≠ 0. The twists and the wrenches of a pair are
//! reciprocal (Hunt, *Kinematic Geometry of Mechanisms*, 1978, chapter 12).

use std::f64::consts::TAU;

use super::{PairKind, Vector3};
use crate::numeric::linear::remainder;
use crate::tolerance;

/// A twist or a wrench: the angular components, then the linear ones.
pub(super) type Screw = nalgebra::Vector6<f64>;

/// Length below which a screw counts as zero; screws have lengths of about 1.
pub(super) const ZERO: f64 = tolerance::COINCIDENT;

/// Indices of the planar components of a screw: ω_z, v_x, v_y.
pub(super) const IN_PLANE: [usize; 3] = [2, 3, 4];

/// A pair with its place and directions. Lengths are relative to the size of the scheme.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) kind: PairKind,
    pub(super) place: Vector3,
    /// Axis or normal, second direction, and their vector product.
    pub(super) frame: [Vector3; 3],
}

impl Form {
    /// Builds a pair from an axis and a second direction, which are perpendicular unit vectors. If no second direction
    /// is given, an arbitrary one is taken; it has no effect on kinds without a second direction.
    pub(super) fn new(
        kind: PairKind,
        place: Vector3,
        axis: Vector3,
        second: Option<Vector3>,
    ) -> Self {
        let second = second.unwrap_or_else(|| across(&axis));
        let frame = [axis, second, axis.cross(&second)];
        Self { kind, place, frame }
    }

    /// Basis of the twists that the pair allows, one twist for each freedom; empty for a [`PairKind::Class`].
    pub(super) fn freedoms(&self) -> Vec<Screw> {
        let [axis, second, third] = self.frame;
        let turn = |about: Vector3| screw(about, self.place.cross(&about));
        let slide = |along: Vector3| screw(Vector3::zeros(), along);
        match self.kind {
            PairKind::Revolute => vec![turn(axis)],
            PairKind::Prismatic => vec![slide(axis)],
            PairKind::Screw { pitch } => vec![turn(axis) + slide(axis) * (pitch / TAU)],
            PairKind::Cylindrical => vec![turn(axis), slide(axis)],
            PairKind::Universal => vec![turn(axis), turn(second)],
            PairKind::Spherical => self.frame.map(turn).to_vec(),
            PairKind::Planar => vec![turn(axis), slide(second), slide(third)],
            PairKind::SphereInCylinder => {
                vec![turn(axis), turn(second), turn(third), slide(axis)]
            }
            PairKind::CylinderOnPlane => {
                vec![turn(axis), turn(second), slide(second), slide(third)]
            }
            PairKind::SphereOnPlane => {
                let [a, b, c] = self.frame.map(turn);
                vec![a, b, c, slide(second), slide(third)]
            }
            PairKind::Class(_) => vec![],
        }
    }

    /// Basis of the wrenches of the pair, one wrench for each constraint; empty for a [`PairKind::Class`].
    pub(super) fn constraints(&self) -> Vec<Screw> {
        let [axis, second, third] = self.frame;
        let force = |along: Vector3| screw(self.place.cross(&along), along);
        let moment = |about: Vector3| screw(about, Vector3::zeros());
        let forces = self.frame.map(force);
        match self.kind {
            PairKind::Revolute => {
                let [a, b, c] = forces;
                vec![a, b, c, moment(second), moment(third)]
            }
            PairKind::Prismatic => {
                let [a, b, c] = self.frame.map(moment);
                vec![force(second), force(third), a, b, c]
            }
            PairKind::Screw { pitch } => vec![
                force(axis) - moment(axis) * (pitch / TAU),
                force(second),
                force(third),
                moment(second),
                moment(third),
            ],
            PairKind::Cylindrical => {
                let moments = [moment(second), moment(third)];
                [[force(second), force(third)], moments].concat()
            }
            PairKind::Universal => {
                let [a, b, c] = forces;
                vec![a, b, c, moment(third)]
            }
            PairKind::Spherical => forces.to_vec(),
            PairKind::Planar => vec![force(axis), moment(second), moment(third)],
            PairKind::SphereInCylinder => vec![force(second), force(third)],
            PairKind::CylinderOnPlane => vec![force(axis), moment(third)],
            PairKind::SphereOnPlane => vec![force(axis)],
            PairKind::Class(_) => vec![],
        }
    }

    /// Basis of the planar components of the pair's wrenches, one for each constraint in the plane.
    pub(super) fn constraints_in_plane(&self) -> Vec<Screw> {
        let in_plane = |wrench: &Screw| {
            Screw::from_fn(|row, _| {
                if IN_PLANE.contains(&row) {
                    wrench[row]
                } else {
                    0.0
                }
            })
        };
        basis(self.constraints().iter().map(in_plane))
    }
}

fn screw(turning: Vector3, along: Vector3) -> Screw {
    Screw::new(turning.x, turning.y, turning.z, along.x, along.y, along.z)
}

/// A direction perpendicular to a unit vector.
pub(super) fn across(axis: &Vector3) -> Vector3 {
    let unit = Vector3::ith(axis.iamin(), 1.0);
    (unit - axis * axis.dot(&unit)).normalize()
}

/// Orthonormal basis of the span of given screws, whose lengths are about 1 or less. After orthogonalization a
/// remainder up to [`ZERO`] counts as zero.
pub(super) fn basis(screws: impl Iterator<Item = Screw>) -> Vec<Screw> {
    /// Minimum length of the remainder of a clearly independent screw.
    const CLEAR: f64 = 0.1;
    let mut basis = Vec::with_capacity(6);
    let mut doubtful = vec![];
    for screw in screws {
        if basis.len() == 6 {
            return basis;
        }
        let rest = remainder(screw, basis.iter());
        let length = rest.norm();
        if length > CLEAR {
            basis.push(rest / length);
        } else if length > ZERO {
            doubtful.push(rest);
        }
    }
    // Doubtful remainders are added longest first, so that a rounding error is not mistaken for a direction.
    loop {
        doubtful
            .iter_mut()
            .for_each(|rest| *rest = remainder(*rest, basis.iter()));
        let longest = doubtful.iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
        match longest.map(|longest| (longest, longest.norm())) {
            Some((longest, length)) if length > ZERO => basis.push(longest / length),
            _ => return basis,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reciprocal() {
        for kind in PairKind::forms(0.5) {
            let form = Form::new(kind, Vector3::new(0.3, -0.2, 0.1), Vector3::z(), None);
            let (freedoms, constraints) = (form.freedoms(), form.constraints());
            assert_eq!(freedoms.len(), usize::from(kind.freedoms()));
            assert_eq!(freedoms.len() + constraints.len(), 6);
            assert_eq!(basis(freedoms.iter().copied()).len(), freedoms.len());
            assert_eq!(basis(constraints.iter().copied()).len(), constraints.len());
            let products = freedoms
                .iter()
                .flat_map(|a| constraints.iter().map(|b| a.dot(b)));
            assert!(
                products.into_iter().all(|product| product.abs() < 1e-15),
                "{kind:?}"
            );
        }
    }

    /// A hinge at (3, 0, 0) about z: at unit speed the point of the body at the origin moves at −3 along y. A screw
    /// with the pitch 2π also moves at 1 along z.
    #[test]
    fn a_twist_has_the_velocity_of_the_point_at_the_origin() {
        let place = Vector3::new(3.0, 0.0, 0.0);
        for (kind, along) in [
            (PairKind::Revolute, 0.0),
            (PairKind::Screw { pitch: TAU }, 1.0),
            (PairKind::Screw { pitch: -TAU }, -1.0),
        ] {
            let form = Form::new(kind, place, Vector3::z(), None);
            let expected = Screw::new(0.0, 0.0, 1.0, 0.0, -3.0, along);
            assert_eq!(form.freedoms(), [expected], "{kind:?}");
        }
    }

    #[test]
    fn constraints_of_pairs_in_the_plane() {
        let (x, z) = (Vector3::x(), Vector3::z());
        for (kind, axis, second, count) in [
            (PairKind::Revolute, z, None, 2),
            (PairKind::Cylindrical, z, None, 2),
            (PairKind::Prismatic, x, None, 2),
            (PairKind::CylinderOnPlane, x, Some(z), 1),
            (PairKind::SphereOnPlane, x, None, 1),
            (PairKind::Planar, z, None, 0),
        ] {
            let form = Form::new(kind, Vector3::new(1.0, 2.0, 0.0), axis, second);
            assert_eq!(form.constraints_in_plane().len(), count, "{kind:?}");
        }
    }

    #[test]
    fn parallel_axes_in_a_plane_have_two_independent_twists() {
        let hinge = |x: f64, y: f64| {
            Form::new(
                PairKind::Revolute,
                Vector3::new(x, y, 0.0),
                Vector3::z(),
                None,
            )
            .freedoms()[0]
        };
        let flat = [hinge(0.0, 0.0), hinge(0.5, 0.0), hinge(1.0, 0.0)];
        assert_eq!(basis(flat.into_iter()).len(), 2);
        assert_eq!(basis(flat.into_iter().chain([hinge(0.5, 0.5)])).len(), 3);
    }
}
