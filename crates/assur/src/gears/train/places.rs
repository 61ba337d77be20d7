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

impl Train {
    /// The angle at which the ring is mounted, where a tooth (a plate) of the sun
    /// and an inward one of the ring are centred on their zero directions: then
    /// teeth meet gaps at all satellites, as far as these can be
    /// [mounted](super::Differential::assembly) at all. Unloaded, like poles of
    /// magnets stand just so.
    pub fn ring_mounting(&self) -> f64 {
        let satellite = f64::from(self.teeth(Member::Satellite));
        let step = f64::from(self.teeth(Member::Step));
        (PI + step * (PI - PI / satellite)) / f64::from(self.teeth(Member::Ring))
    }
}

impl Layout {
    /// The places of all satellites when the shafts have turned by these angles
    /// from the position in which the first one is to the right; none of bevel
    /// wheels. Each meets the sun's gaps.
    pub fn places(&self, coupling: Coupling, angles: &Shafts) -> Option<Vec<Place>> {
        if self.train().kind() == Kind::Bevel {
            return None;
        }
        let teeth = |member| f64::from(self.train().teeth(member));
        let satellite = teeth(Member::Satellite);
        let ratio = teeth(Member::Sun) / satellite;
        let distance = self.axis_distance(coupling);
        let count = self.counts().satellites;
        let place = |k: u32| {
            let carrier = angles.carrier + TAU * f64::from(k) / f64::from(count);
            Place {
                centre: Point::new(distance * carrier.cos(), distance * carrier.sin()),
                angle: carrier + (carrier - angles.sun) * ratio + PI - PI / satellite,
            }
        };
        Some((0..count).map(place).collect())
    }
}
