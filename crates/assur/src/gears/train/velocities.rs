//! How a satellite moves.

use super::{Coupling, Kind, Layout, Member, Shafts, Train};

/// The angular velocity of a satellite, or the angle that it has turned by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Relative to the carrier, about the satellite's own axis.
    pub relative: f64,
    /// ω₂: absolute, its part along the main axis. In a plane it has no other.
    pub along: f64,
    /// Of bevel wheels the part across the main axis, away from it on the
    /// satellite's side; else 0.
    pub across: f64,
}

impl Train {
    /// ω₂ from the speeds of the shafts: ω₂ − ω₃ = −(ω₁ − ω₃) z₁/z₂ about the
    /// satellite's axis. In a plane it holds of angles as well.
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

/// A point of a satellite on the line from the main axis through its centre. Its
/// velocity is across that line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointVelocity {
    /// Where: from the main axis, positive towards the satellite.
    pub radius: f64,
    /// How fast, positive counter-clockwise about the main axis for a positive radius.
    pub velocity: f64,
}

/// The velocities of a satellite in the plane. They lie on one straight line over
/// the radius: the velocity triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Velocities {
    /// Where it rolls on the sun: both have this velocity.
    pub sun: PointVelocity,
    /// At its centre, the carrier's velocity.
    pub centre: PointVelocity,
    /// Where it rolls in the ring: both have this velocity.
    pub ring: PointVelocity,
    /// The radius of its instantaneous centre; none where it does not turn: there
    /// the velocities are all the same.
    pub instantaneous_centre: Option<f64>,
}

impl Layout {
    /// The radii of sun and ring on which the satellite rolls, as its speed has it:
    /// a_w z₁/(z₁ + z₂) and a_w z₄/(z₄ − z₂′). In contact these are the pitch
    /// circles d/2; magnets have them in the gaps or near by.
    pub fn rolling_radii(&self, coupling: Coupling) -> [f64; 2] {
        let teeth = |member| f64::from(self.train().teeth(member));
        let [sun, ring] = [teeth(Member::Sun), teeth(Member::Ring)];
        let distance = self.axis_distance(coupling);
        [
            distance * sun / (sun + teeth(Member::Satellite)),
            distance * ring / (ring - teeth(Member::Step)),
        ]
    }

    /// How a satellite moves at these speeds of the shafts; none of bevel wheels,
    /// which do not move in a plane.
    pub fn velocities(&self, coupling: Coupling, speeds: &Shafts) -> Option<Velocities> {
        let spin = self.train().spin(speeds).along;
        self.velocities_of(coupling, speeds.carrier, spin)
    }

    /// The same of a satellite by the speeds of the carrier and its own, ω₂: of magnets
    /// that slip it is not that of the shafts.
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
        // Two parts that cancel, the carrier's and the relative one, leave their rounding.
        let turns = spin.abs() > 4.0 * f64::EPSILON * (carrier.abs() + (spin - carrier).abs());
        Some(Velocities {
            sun: at(sun),
            centre: at(distance),
            ring: at(ring),
            instantaneous_centre: turns.then(|| distance * (1.0 - carrier / spin)),
        })
    }
}
