//! Traced points on the mixer's bodies, as for coupler curves.

use super::Mixer;
use crate::tolerance::FARTHEST;
use crate::{Dimension, Fault, Invalid, Jet, JetPoint, Point, Pose};

/// A moving body that can carry a traced point, with the axes of its coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// Crank: origin A, x along AB.
    Crank,
    /// Coupler: origin B, x along BC.
    Coupler,
    /// Rocker with wheel 4: origin D, x along DC.
    Rocker,
    /// Peripheral wheel, counted from 0 (wheel 5): origin at its centre, x along the tooth on its zero direction.
    Wheel(usize),
}

/// A point fixed to a body, in the coordinates of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracer {
    /// Body that carries the point.
    pub carrier: Carrier,
    /// Abscissa on the body, in the unit of length.
    pub x: f64,
    /// Ordinate on the body, in the unit of length.
    pub y: f64,
}

impl Tracer {
    /// Maximum number of traced points.
    pub const MAX_COUNT: usize = 6;
}

/// Checks the number, the bodies and the coordinates of traced points on a mixer with `wheels` peripheral wheels.
pub(super) fn check(tracers: &[Tracer], wheels: usize) -> Result<(), Vec<Invalid>> {
    let mut reasons = Vec::new();
    if tracers.len() > Tracer::MAX_COUNT {
        reasons.push(Invalid {
            dimension: Dimension::Tracers,
            fault: Fault::OutOfRange {
                value: tracers.len() as f64,
                min: 0.0,
                max: Tracer::MAX_COUNT as f64,
            },
        });
    }
    for (index, tracer) in tracers.iter().enumerate().take(Tracer::MAX_COUNT) {
        if matches!(tracer.carrier, Carrier::Wheel(wheel) if wheel >= wheels) {
            reasons.push(Invalid {
                dimension: Dimension::TracerCarrier(index),
                fault: Fault::Absent,
            });
        }
        for (dimension, value) in [
            (Dimension::TracerX(index), tracer.x),
            (Dimension::TracerY(index), tracer.y),
        ] {
            reasons.extend(Invalid::check_size(dimension, value, FARTHEST).err());
        }
    }
    if reasons.is_empty() {
        Ok(())
    } else {
        Err(reasons)
    }
}

impl Mixer {
    /// The traced points: P₁, P₂, …
    pub fn tracers(&self) -> &[Tracer] {
        &self.tracers
    }

    /// A traced point in a pose, with its derivatives with respect to the crank angle.
    pub fn traced<const N: usize>(&self, pose: &Pose<N>, tracer: &Tracer) -> JetPoint<N> {
        let (origin, angle) = self.body(pose, tracer.carrier);
        origin.offset(angle, tracer.x, tracer.y)
    }

    /// The point of a body that is at `place` in a pose.
    pub fn tracer_at(&self, pose: &Pose<1>, carrier: Carrier, place: Point) -> Tracer {
        let (origin, angle) = self.body(pose, carrier);
        let (sin, cos) = angle.value().sin_cos();
        let off = place - origin.place();
        Tracer {
            carrier,
            x: cos * off.x + sin * off.y,
            y: cos * off.y - sin * off.x,
        }
    }

    /// Origin of a body's coordinates, and direction of their x-axis. For a wheel that does not exist, the origin and
    /// direction of the rocker; [`Mixer::new`] refuses such wheels.
    pub fn body<const N: usize>(&self, pose: &Pose<N>, carrier: Carrier) -> (JetPoint<N>, Jet<N>) {
        let [a, b, _, d] = self.linkage.joints(pose);
        match carrier {
            Carrier::Crank => (a, pose.crank),
            Carrier::Coupler => (b, pose.coupler),
            Carrier::Rocker => (d, pose.rocker),
            Carrier::Wheel(index) => match self.gears.pairs().get(index) {
                Some(pair) => {
                    let wheel = pair.driven_wheel();
                    let centre = JetPoint::fixed(d.place() + wheel.centre);
                    (centre, pose.rocker * wheel.ratio + wheel.mounting)
                }
                None => (d, pose.rocker),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Case, Dimensions};
    use super::*;
    use crate::gears::Mate;
    use crate::{Link, Offset};

    const CARRIERS: [Carrier; 5] = [
        Carrier::Crank,
        Carrier::Coupler,
        Carrier::Rocker,
        Carrier::Wheel(0),
        Carrier::Wheel(1),
    ];

    fn dimensions(tracers: Vec<Tracer>) -> Dimensions {
        let mut dimensions = Case::A.dimensions();
        dimensions.wheels.push(Mate {
            teeth: 24.0,
            centre_line: 1.0,
        });
        Dimensions {
            tracers,
            ..dimensions
        }
    }

    #[test]
    fn a_point_keeps_its_place_on_its_body() {
        let mixer = Mixer::new(&dimensions(Vec::new())).unwrap();
        let place = Point::new(0.4, 0.7);
        for carrier in CARRIERS {
            let pose = mixer.linkage.pose::<1>(mixer.assembly, 1.1).unwrap();
            let tracer = mixer.tracer_at(&pose, carrier, place);
            let off = mixer.traced(&pose, &tracer).place() - place;
            assert!(off.norm() < 1e-15, "{carrier:?}: {off}");
            for crank in [0.0, 2.0, 4.5] {
                let pose = mixer.linkage.pose::<3>(mixer.assembly, crank).unwrap();
                let (origin, angle) = mixer.body(&pose, carrier);
                let arm = mixer.traced(&pose, &tracer).place() - origin.place();
                assert!((arm.norm() - tracer.x.hypot(tracer.y)).abs() < 1e-15);
                // If the body turns about a fixed centre, the velocity is φ′ times the arm, turned through 90°.
                if carrier != Carrier::Coupler {
                    let rate = mixer.traced(&pose, &tracer).derivative(1);
                    assert!(rate.dot(&arm).abs() < 1e-14, "{carrier:?}");
                    let turn = angle.derivative(1).abs() * arm.norm();
                    assert!((rate.norm() - turn).abs() < 1e-14, "{carrier:?}");
                }
            }
        }
    }

    #[test]
    fn the_couplers_middle_is_its_centre() {
        let mixer = Mixer::new(&dimensions(Vec::new())).unwrap();
        let tracer = Tracer {
            carrier: Carrier::Coupler,
            x: 0.425,
            y: 0.0,
        };
        for crank in [0.0, 1.0, 3.0] {
            let pose = mixer.linkage.pose::<3>(mixer.assembly, crank).unwrap();
            let centre = mixer.linkage.carried(&pose, Link::Coupler, Offset::MIDDLE);
            for order in 0..3 {
                let off = mixer.traced(&pose, &tracer).derivative(order) - centre.derivative(order);
                assert!(off.norm() < 1e-15);
            }
        }
    }

    #[test]
    fn bad_points_are_named() {
        let tracer = |carrier, x, y| Tracer { carrier, x, y };
        let bad = vec![
            tracer(Carrier::Coupler, f64::NAN, 0.0),
            tracer(Carrier::Wheel(1), 0.0, 0.0),
            tracer(Carrier::Wheel(2), 0.0, -1e10),
        ];
        let named: Vec<Dimension> = Mixer::new(&dimensions(bad))
            .unwrap_err()
            .iter()
            .map(|reason| reason.dimension)
            .collect();
        assert_eq!(
            named,
            [
                Dimension::TracerX(0),
                Dimension::TracerCarrier(2),
                Dimension::TracerY(2),
            ]
        );
        let seven = vec![tracer(Carrier::Crank, 0.1, 0.0); 7];
        let reasons = Mixer::new(&dimensions(seven)).unwrap_err();
        assert_eq!(reasons[0].dimension, Dimension::Tracers);
    }
}
