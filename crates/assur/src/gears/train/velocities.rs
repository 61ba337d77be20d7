//! Velocities of a satellite.

use super::{Coupling, Kind, Layout, Member, Shafts, Train};

/// Angular velocity of a satellite or (only in a planar train) its angle of rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Angular velocity relative to the carrier, about the satellite's own axis.
    pub relative: f64,
    /// Component of the absolute angular velocity along the central axis, ω₂; the only component in a planar train.
    pub along: f64,
    /// Component of the absolute angular velocity at a right angle to the central axis, positive away from the axis on
    /// the satellite's side. Zero except for bevel wheels.
    pub across: f64,
}

impl Train {
    /// Angular velocity of a satellite from the speeds of the shafts: ω₂ − ω₃ = −(ω₁ − ω₃) z₁/z₂ about the satellite's
    /// axis. In a planar train the equation also holds for angles.
    pub fn spin(&self, speeds: &Shafts) -> Spin {
        let ratio = f64::from(self.teeth(Member::Sun)) / f64::from(self.teeth(Member::Satellite));
        let relative = (speeds.carrier - speeds.sun) * ratio;
        let cosine = self.cosine_of_inclination();
        Spin {
            relative,
            along: speeds.carrier + relative * cosine,
            across: relative * (1.0 - cosine * cosine).sqrt(),
        }
    }
}

/// A point of a satellite on the line from the central axis through the satellite's centre. The velocity of the point
/// is perpendicular to this line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointVelocity {
    /// Distance from the central axis, positive towards the satellite.
    pub radius: f64,
    /// Velocity, positive counter-clockwise about the central axis for a positive radius.
    pub velocity: f64,
}

/// Velocities of a satellite in the plane: a straight line if plotted against the radius (the velocity triangle).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Velocities {
    /// Rolling point on the sun, where satellite and sun have the same velocity.
    pub sun: PointVelocity,
    /// Centre of the satellite, which has the velocity of the carrier.
    pub centre: PointVelocity,
    /// Rolling point on the ring, where satellite and ring have the same velocity.
    pub ring: PointVelocity,
    /// Radius of the satellite's instant centre; None if the satellite does not turn and all velocities are equal.
    pub instantaneous_centre: Option<f64>,
}

impl Layout {
    /// Radii of the circles of sun and ring on which the satellite rolls: a_w z₁/(z₁ + z₂) and a_w z₄/(z₄ − z₂′), with
    /// the axis distance a_w. For gears in contact these are the pitch radii d/2. For magnets the circles are in the
    /// gaps or near them.
    pub fn rolling_radii(&self, coupling: Coupling) -> [f64; 2] {
        let teeth = |member| f64::from(self.train().teeth(member));
        let [sun, ring] = [teeth(Member::Sun), teeth(Member::Ring)];
        let distance = self.axis_distance(coupling);
        [
            distance * sun / (sun + teeth(Member::Satellite)),
            distance * ring / (ring - teeth(Member::Step)),
        ]
    }

    /// Velocities of a satellite at these speeds of the shafts; none for bevel wheels, whose motion is not planar.
    pub fn velocities(&self, coupling: Coupling, speeds: &Shafts) -> Option<Velocities> {
        let spin = self.train().spin(speeds).along;
        self.velocities_of(coupling, speeds.carrier, spin)
    }

    /// Velocities of a satellite from the speed of the carrier and the satellite's own speed ω₂. If magnets slip, ω₂
    /// does not follow from the speeds of the shafts.
    pub fn velocities_of(&self, coupling: Coupling, carrier: f64, spin: f64) -> Option<Velocities> {
        if self.train().kind() == Kind::Bevel {
            return None;
        }
        let distance = self.axis_distance(coupling);
        let at = |radius: f64| PointVelocity {
            radius,
            velocity: carrier * distance + spin * (radius - distance),
        };
        let [sun, ring] = self.rolling_radii(coupling);
        // The speed of the carrier and the relative speed may cancel and leave only a rounding error.
        let turns = spin.abs() > 4.0 * f64::EPSILON * (carrier.abs() + (spin - carrier).abs());
        Some(Velocities {
            sun: at(sun),
            centre: at(distance),
            ring: at(ring),
            instantaneous_centre: turns.then(|| distance * (1.0 - carrier / spin)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Teeth 20, 20 and 60, module 1: radii 10 and 30, axis distance 20. With the sun at 10 and the ring at 2, the
    /// carrier turns at 4 and the satellite at −2. The velocities are 10·10, 20·4 and 30·2, and zero at 20 + 40 from
    /// the axis.
    #[test]
    fn the_velocity_triangle_of_a_satellite() {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        let layout = Layout::new(train, 1.0, 1.0, None).unwrap();
        let speeds = Shafts {
            sun: 10.0,
            carrier: 4.0,
            ring: 2.0,
        };
        let found = layout.velocities(Coupling::Contact, &speeds).unwrap();
        for (point, radius, velocity) in [
            (found.sun, 10.0, 100.0),
            (found.centre, 20.0, 80.0),
            (found.ring, 30.0, 60.0),
        ] {
            assert_eq!((point.radius, point.velocity), (radius, velocity));
        }
        assert_eq!(found.instantaneous_centre, Some(60.0));
    }

    #[test]
    fn a_satellite_rolls_on_a_wheel_that_is_held() {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        let layout = Layout::new(train, 1.0, 1.0, None).unwrap();
        for (sun, carrier, ring, centre) in [(4.0, 1.0, 0.0, 30.0), (0.0, 3.0, 4.0, 10.0)] {
            let speeds = Shafts { sun, carrier, ring };
            let found = layout.velocities(Coupling::Contact, &speeds).unwrap();
            assert_eq!(found.instantaneous_centre, Some(centre));
        }
    }

    /// A satellite rolls on an equal sun as a coin on an equal coin: two turns for each turn around the sun.
    #[test]
    fn a_satellite_as_large_as_the_held_sun_turns_twice_as_fast() {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        let spin = train.spin(&Shafts {
            sun: 0.0,
            carrier: 3.0,
            ring: 4.0,
        });
        assert_eq!((spin.relative, spin.along, spin.across), (3.0, 6.0, 0.0));
    }

    /// cos Σ = (40 − 20)/40 = 1/2: half of the relative speed is along the central axis, √3/2 across.
    #[test]
    fn the_speed_of_a_bevel_satellite_has_two_components() {
        let train = Train::bevel([20.0, 20.0, 40.0]).unwrap();
        let spin = train.spin(&Shafts {
            sun: 3.0,
            carrier: 1.0,
            ring: 0.0,
        });
        assert_eq!(spin.relative, -2.0);
        assert!((spin.along - 0.0).abs() < 1e-15 && (spin.across + 3_f64.sqrt()).abs() < 1e-15);
    }
}
