//! Positions of the satellites, and mounting angles of the wheels in mesh.

use std::f64::consts::{PI, TAU};

use super::{Coupling, Kind, Layout, Member, Shafts, Train};
use crate::Point;

/// Position of a satellite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Centre of the satellite, relative to the central axis.
    pub centre: Point,
    /// Angle of the satellite's zero direction, on which a tooth (a plate) of each of its wheels is centred.
    pub angle: f64,
}

/// Mounting angles of wheels with parallel axes: the angles of their zero directions if the angles of sun and carrier
/// are 0. A tooth (or a plate) of each wheel is centred on its zero direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// Mounting angle of the ring.
    pub ring: f64,
    /// Mounting angle of each satellite.
    pub satellites: Vec<f64>,
}

impl Train {
    /// Mounting angle of the ring for which teeth meet gaps at all satellites that can be
    /// [mounted](super::Differential::assembly). A tooth (or a plate) of the sun, and an inward tooth of the ring, are
    /// centred on the zero directions of these wheels. For plates with like poles outward, the result is the angle of
    /// the ring without load.
    pub fn ring_mounting(&self) -> f64 {
        self.ring_mounting_of(1)
    }

    /// The ring's mounting angle for this number of plates per period of the field.
    fn ring_mounting_of(&self, plates: u32) -> f64 {
        let [_, satellite, step, ring] = self.periods(plates);
        (PI + step * (PI - PI / satellite)) / ring
    }

    /// Numbers of periods around the wheels z₁, z₂, z₂′ and z₄; `plates` is the number of teeth (or plates) per period.
    fn periods(&self, plates: u32) -> [f64; 4] {
        let members = [Member::Sun, Member::Satellite, Member::Step, Member::Ring];
        members.map(|member| f64::from(self.teeth(member)) / f64::from(plates))
    }
}

impl Layout {
    /// Mounting angles of satellites and ring. `plates` is the number of plates per period: 1 for teeth and like poles,
    /// which face gaps, and 2 for alternating poles, where north faces south. The phases of wheels in mesh differ by
    /// half a period. For satellites that cannot be [mounted](super::Differential::assembly), this holds only at the
    /// sun.
    pub fn mounting(&self, plates: u32) -> Mounting {
        let [sun, satellite, step, ring] = self.train().periods(plates);
        let mounted = self.train().ring_mounting_of(plates);
        let count = self.counts().satellites;
        let one = |k: u32| {
            let line = TAU * f64::from(k) / f64::from(count);
            let at_sun = line + PI + (line * sun - PI) / satellite;
            // Mounting the satellite one period further at the sun changes the phase of z₂′ at the ring.
            let off = |period: u32| {
                let angle = at_sun + TAU * f64::from(period) / satellite;
                let phase = ring * (line - mounted) - step * (line - angle);
                let turns = phase / TAU - 0.5;
                ((turns - turns.round()).abs(), angle)
            };
            let others = if step == satellite {
                1
            } else {
                satellite as u32
            };
            let first = off(0);
            let best = (1..others).map(off).fold(first, |best, other| {
                // Differences due to rounding are ignored.
                if other.0 < best.0 - 1e-6 { other } else { best }
            });
            best.1
        };
        Mounting {
            ring: mounted,
            satellites: (0..count).map(one).collect(),
        }
    }

    /// Positions of all satellites, with their teeth in the gaps of the sun; none for bevel wheels. `angles` are the
    /// rotations of the shafts since the first satellite was to the right of the central axis.
    pub fn places(&self, coupling: Coupling, angles: &Shafts) -> Option<Vec<Place>> {
        if self.train().kind() == Kind::Bevel {
            return None;
        }
        let distance = self.axis_distance(coupling);
        let turned = self.train().spin(angles).along;
        let mounted = self.mounting(1).satellites;
        let count = mounted.len() as f64;
        let place = |(k, mounted): (usize, f64)| {
            let carrier = angles.carrier + TAU * k as f64 / count;
            Place {
                centre: Point::new(distance * carrier.cos(), distance * carrier.sin()),
                angle: mounted + turned,
            }
        };
        Some(mounted.into_iter().enumerate().map(place).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::f64::consts::FRAC_PI_2;

    fn layout(satellites: f64) -> Layout {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        Layout::new(train, satellites, 1.0, None).unwrap()
    }

    /// Four satellites on a circle of radius 20. The carrier at 90° moves each to the place of the next.
    #[test]
    fn satellites_stand_at_equal_angles_and_move_with_the_carrier() {
        for (carrier, first) in [(0.0, 0), (FRAC_PI_2, 1)] {
            let angles = Shafts {
                carrier,
                ..Shafts::default()
            };
            let places = layout(4.0).places(Coupling::Contact, &angles).unwrap();
            let corners = [[20.0, 0.0], [0.0, 20.0], [-20.0, 0.0], [0.0, -20.0]];
            for (k, place) in places.iter().enumerate() {
                let expected = Point::from(corners[(k + first) % 4]);
                assert!((place.centre - expected).norm() < 1e-13, "{places:?}");
            }
        }
    }

    /// With the carrier held, satellites of 20 teeth turn back as far as a sun of 20 turns.
    #[test]
    fn satellites_roll_on_the_sun() {
        let angles = Shafts {
            sun: 0.3,
            carrier: 0.0,
            ring: -0.1,
        };
        let [rest, turned] = [Shafts::default(), angles].map(|angles| {
            let places = layout(4.0).places(Coupling::Contact, &angles);
            places
                .unwrap()
                .iter()
                .map(|place| place.angle)
                .collect::<Vec<f64>>()
        });
        for (rest, turned) in rest.iter().zip(&turned) {
            assert!((turned - rest + 0.3).abs() < 1e-14);
        }
    }

    /// The sun has a tooth at 0°, so the satellite has a gap at 180°. Its tooth at 171° is half of its pitch of 18°
    /// away. At 0° the satellite has a gap again, 9.5 pitches from this tooth, so the ring has a tooth at 0°, and at
    /// every multiple of its pitch of 6°.
    #[test]
    fn a_tooth_of_the_sun_meets_a_gap_of_the_first_satellite() {
        let mounting = layout(4.0).mounting(1);
        let first = mounting.satellites[0].to_degrees();
        assert!((first - 171.0).abs() < 1e-12, "{first}");
        let ring = mounting.ring.to_degrees();
        let off = ring.rem_euclid(6.0);
        assert!(off.min(6.0 - off) < 1e-12, "{ring}");
    }
}
