//! A wheel of a differential seen along its axis: its disc with teeth or magnet plates.

use std::f64::consts::TAU;

use assur::Point;
use assur::dynamics::Poles;

use crate::gear::Teeth;
use crate::list::{List, Look, Role};
use crate::parts;

/// The colours of north and south poles.
pub(super) const POLES: [Role; 2] = [Role::Accent5, Role::X];

/// Width of a ring's rim behind its teeth or plates, in modules; then the minimum width relative to the radius.
const RIM: (f64, f64) = (2.75, 0.045);
/// Height of a plate, in modules; then the maximum height relative to the wheel's radius.
const PLATE: (f64, f64) = (1.1, 0.4);
/// The share of the pitch that a plate takes up.
pub(super) const SHARE: f64 = 0.66;
/// Greatest angle between neighbouring points of a drawn arc, radians.
const STEP: f64 = 0.09;
/// Number of points on a drawn circle.
const CIRCLE: usize = 180;

/// Rim of a wheel, which couples it to others.
#[derive(Clone, Debug)]
pub(super) enum Rim {
    /// Teeth, with the wheels in mesh: the number of teeth of each, and whether it is a ring.
    Teeth(Vec<(u32, bool)>),
    /// Magnet plates.
    Plates(Poles),
    /// Teeth or plates too fine to be visible.
    Fine,
}

/// A wheel about the origin. Its first tooth or plate is centred on the x-axis.
#[derive(Clone, Debug)]
pub(super) struct Wheel {
    pub(super) role: Role,
    pub(super) teeth: u32,
    pub(super) module: f64,
    /// Whether the teeth or plates are on the inside.
    pub(super) ring: bool,
    pub(super) rim: Rim,
}

impl Wheel {
    /// The radius of the pitch circle, on which the faces of the plates lie.
    pub(super) fn radius(&self) -> f64 {
        0.5 * self.module * f64::from(self.teeth)
    }

    /// The outer radius.
    pub(super) fn reach(&self) -> f64 {
        let radius = self.radius();
        match self.rim {
            _ if self.ring => self.back() + (RIM.0 * self.module).max(RIM.1 * radius),
            Rim::Teeth(_) => radius + self.module,
            Rim::Plates(_) | Rim::Fine => radius,
        }
    }

    /// The radius of the backs of the plates. For a wheel with teeth it is close to that of the roots.
    pub(super) fn back(&self) -> f64 {
        let radius = self.radius();
        let height = (PLATE.0 * self.module).min(PLATE.1 * radius);
        if self.ring {
            radius + height
        } else {
            radius - height
        }
    }

    /// The angle of the marked plate or tooth, which is the one nearest to 90°.
    pub(super) fn marked(&self) -> f64 {
        let pitch = TAU / f64::from(self.teeth);
        (0.25 * TAU / pitch).round() * pitch
    }

    /// Draws the wheel about the origin of the current body.
    pub(super) fn draw(&self, list: &mut List) {
        match &self.rim {
            Rim::Teeth(mates) => {
                let teeth = Teeth::new(self.teeth, self.ring, mates);
                self.draw_disc(list, teeth.outline(self.module));
            }
            Rim::Plates(poles) => {
                self.draw_disc(list, parts::round(self.back(), CIRCLE));
                self.draw_plates(list, *poles);
            }
            Rim::Fine => {
                self.draw_disc(list, parts::round(self.back(), CIRCLE));
                let band = [self.back(), self.radius()].map(|radius| parts::round(radius, CIRCLE));
                list.polygons(self.role, Look::Soft, &band);
            }
        }
    }

    /// Draws the disc inside an outline; for a ring, the area from the outline out to the edge of the rim.
    fn draw_disc(&self, list: &mut List, line: Vec<Point>) {
        let rim = self.ring.then(|| parts::round(self.reach(), CIRCLE));
        let loops: Vec<_> = [Some(line), rim].into_iter().flatten().collect();
        list.polygons(self.role, Look::Pale, &loops);
    }

    /// Draws plates, magnetised from face to back. The face of the first plate is its north pole.
    fn draw_plates(&self, list: &mut List, poles: Poles) {
        let (face, back) = (self.radius(), self.back());
        let middle = 0.5 * (face + back);
        let mut loops = [Vec::new(), Vec::new()];
        for index in 0..self.teeth {
            let at = TAU * f64::from(index) / f64::from(self.teeth);
            let shown = match poles {
                Poles::Alike => 0,
                Poles::Alternating => index as usize % 2,
            };
            loops[shown].push(self.sector(at, [middle, face]));
            loops[1 - shown].push(self.sector(at, [back, middle]));
        }
        for (role, loops) in POLES.into_iter().zip(loops) {
            list.polygons(role, Look::Solid, &loops);
        }
    }

    /// The piece, between two radii, of the plate at the angle `at`.
    fn sector(&self, at: f64, radii: [f64; 2]) -> Vec<Point> {
        let half = 0.5 * SHARE * TAU / f64::from(self.teeth);
        let steps = (2.0 * half / STEP).ceil();
        let arc = |radius: f64, sense: f64| {
            (0..=steps as usize).map(move |k| {
                let off = sense * half * (2.0 * k as f64 / steps - 1.0);
                polar(radius, at + off)
            })
        };
        arc(radii[0], 1.0).chain(arc(radii[1], -1.0)).collect()
    }
}

pub(super) fn polar(radius: f64, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    Point::new(radius * cos, radius * sin)
}
