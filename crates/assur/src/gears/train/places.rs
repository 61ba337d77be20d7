//! Where the satellites are, and how the wheels are turned so that they mesh.

use std::f64::consts::{PI, TAU};

use super::{Coupling, Kind, Layout, Member, Shafts, Train};
use crate::Point;

/// Where a satellite is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Its centre, from the main axis.
    pub centre: Point,
    /// The angle of its zero direction, along which a tooth (a plate) of each of
    /// its wheels is centred.
    pub angle: f64,
}

/// How wheels of parallel axes are mounted so that they mesh: the angles of their zero
/// directions, along which a tooth (a plate) is centred, where the sun's and the
/// carrier's are 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// Of the ring.
    pub ring: f64,
    /// Of each satellite.
    pub satellites: Vec<f64>,
}

impl Train {
    /// The angle at which the ring is mounted, where a tooth (a plate) of the sun
    /// and an inward one of the ring are centred on their zero directions: then
    /// teeth meet gaps at all satellites, as far as these can be
    /// [mounted](super::Differential::assembly) at all. Unloaded, like poles of
    /// magnets stand just so.
    pub fn ring_mounting(&self) -> f64 {
        self.ring_mounting_of(1)
    }

    /// The same for so many plates to a period of the field.
    fn ring_mounting_of(&self, plates: u32) -> f64 {
        let [_, satellite, step, ring] = self.periods(plates);
        (PI + step * (PI - PI / satellite)) / ring
    }

    /// Periods of z₁, z₂, z₂′ and z₄ teeth (plates), so many to each.
    fn periods(&self, plates: u32) -> [f64; 4] {
        let members = [Member::Sun, Member::Satellite, Member::Step, Member::Ring];
        members.map(|member| f64::from(self.teeth(member)) / f64::from(plates))
    }
}

impl Layout {
    /// How satellites and ring are mounted, with so many plates to a period: one of teeth
    /// and of like poles, which stand between one another, two where poles alternate
    /// and north faces south. Where wheels meet there is half a period between them; of
    /// satellites that cannot be [mounted](super::Differential::assembly) only at the sun.
    pub fn mounting(&self, plates: u32) -> Mounting {
        let [sun, satellite, step, ring] = self.train().periods(plates);
        let mounted = self.train().ring_mounting_of(plates);
        let count = self.counts().satellites;
        let one = |k: u32| {
            let line = TAU * f64::from(k) / f64::from(count);
            let at_sun = line + PI + (line * sun - PI) / satellite;
            // Another period at the sun is another place of z₂′ at the ring.
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
                // What only rounding sets apart is as good.
                if other.0 < best.0 - 1e-6 { other } else { best }
            });
            best.1
        };
        Mounting {
            ring: mounted,
            satellites: (0..count).map(one).collect(),
        }
    }

    /// The places of all satellites when the shafts have turned by these angles
    /// from the position in which the first one is to the right; none of bevel
    /// wheels. Each meets the sun's gaps.
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
