//! Outlines of gears in mesh: standard involute teeth (pressure angle 20°), shortened where they would interfere with
//! the mate.

use std::f64::consts::PI;

use assur::Point;

const PRESSURE_ANGLE: f64 = 20.0 * PI / 180.0;
/// Height of a tooth above the pitch circle, in modules.
const ADDENDUM: f64 = 1.0;
/// Depth of a gap below the pitch circle, in modules.
const DEDENDUM: f64 = 1.25;
/// Amount by which a tooth is narrower than half the pitch, in modules, to make the gaps visible.
const BACKLASH: f64 = 0.06;
/// Number of points along a flank.
const FLANK: usize = 7;

/// Teeth of a wheel, with lengths in modules.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Teeth {
    count: f64,
    ring: bool,
    /// Radius of the tips: outside the pitch circle, or inside it for a ring.
    tip: f64,
}

impl Teeth {
    /// Makes the teeth of a wheel that meshes with all `mates`: the number of teeth of each, and whether it is a ring.
    pub(crate) fn new(count: u32, ring: bool, mates: &[(u32, bool)]) -> Self {
        let z = f64::from(count);
        let pitch = 0.5 * z;
        let standard = if ring {
            pitch - ADDENDUM
        } else {
            pitch + ADDENDUM
        };
        let tip = mates.iter().fold(standard, |tip, &(mate, mate_ring)| {
            let mate = f64::from(mate);
            let distance = if ring || mate_ring {
                0.5 * (z - mate).abs()
            } else {
                0.5 * (z + mate)
            };
            let base = pitch * PRESSURE_ANGLE.cos();
            // Beyond this radius the tip would touch the mate inside the mate's base circle, where involutes end.
            let limit = base.hypot(distance * PRESSURE_ANGLE.sin());
            match (ring, mate_ring) {
                (false, false) => tip.min(limit),
                (true, _) => tip.max(limit),
                // If the numbers of teeth differ little, tips interfere away from the contact.
                (false, true) => tip.min(pitch + ADDENDUM * ((mate - z) / 12.0).min(1.0)),
            }
        });
        Self {
            count: z,
            ring,
            tip,
        }
    }

    /// Returns the pitch radius, in modules.
    pub(crate) fn pitch_radius(self) -> f64 {
        0.5 * self.count
    }

    /// Returns the radius of the bottom of the gaps, in modules.
    pub(crate) fn root_radius(self) -> f64 {
        let depth = if self.ring { DEDENDUM } else { -DEDENDUM };
        self.pitch_radius() + depth
    }

    /// Returns the closed outline of the teeth for a module, counter-clockwise. A tooth is centred on the x axis.
    pub(crate) fn outline(self, module: f64) -> Vec<Point> {
        let pitch_angle = 2.0 * PI / self.count;
        let flank = self.flank();
        let one = |index: usize| {
            let centre = index as f64 * pitch_angle;
            let rising = flank.iter().map(move |&(r, half)| (r, centre - half));
            let falling = flank.iter().rev().map(move |&(r, half)| (r, centre + half));
            rising.chain(falling)
        };
        (0..self.count as usize)
            .flat_map(one)
            .map(|(r, angle)| Point::new(module * r * angle.cos(), module * r * angle.sin()))
            .collect()
    }

    /// Returns points of a flank from root to tip: the radius, and half the angle of the tooth at this radius.
    fn flank(self) -> Vec<(f64, f64)> {
        let pitch = self.pitch_radius();
        let base = pitch * PRESSURE_ANGLE.cos();
        let half_at_pitch = PI / (2.0 * self.count) - 0.5 * BACKLASH / pitch;
        let involute = |angle: f64| angle.tan() - angle;
        let half_at = |r: f64| {
            // Below the base circle there is no involute: the flank is radial.
            let turned = involute(PRESSURE_ANGLE) - involute((base / r).min(1.0).acos());
            let half = if self.ring {
                half_at_pitch - turned
            } else {
                half_at_pitch + turned
            };
            half.max(0.0)
        };
        (0..FLANK)
            .map(|i| {
                let t = i as f64 / (FLANK - 1) as f64;
                let r = self.root_radius() + (self.tip - self.root_radius()) * t;
                (r, half_at(r))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::gears::{GearSet, Mate, Mesh, Wheel};

    /// Returns the distance of `point` from the outline of the polygon, negative inside.
    fn distance(point: Point, polygon: &[Point]) -> f64 {
        let (mut inside, mut nearest) = (false, f64::INFINITY);
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let edge = b - a;
            if (a.y > point.y) != (b.y > point.y)
                && point.x < a.x + (point.y - a.y) * edge.x / edge.y
            {
                inside = !inside;
            }
            let t = ((point - a).dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
            nearest = nearest.min((point - (a + edge * t)).norm());
        }
        if inside { -nearest } else { nearest }
    }

    impl Teeth {
        fn outer(self) -> f64 {
            self.tip.max(self.root_radius())
        }
    }

    fn placed(wheel: &Wheel, teeth: Teeth, driver: f64) -> Vec<Point> {
        let (sin, cos) = (wheel.ratio * driver + wheel.mounting).sin_cos();
        let turned = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        let outline = teeth.outline(1.0).into_iter();
        outline.map(|p| turned(p) + wheel.centre).collect()
    }

    /// Checks at several angles that teeth cut into the mate by less than 1/50 of a module, and that the tip circles
    /// overlap by more than 0.8 of a module.
    fn check_pair(wheels: [&Wheel; 2], teeth: [Teeth; 2], what: &str) {
        for step in 0..12 {
            let driver = f64::from(step) * 0.0573;
            let outlines = [0, 1].map(|i| placed(wheels[i], teeth[i], driver));
            for (i, j) in [(0, 1), (1, 0)] {
                // A ring is solid outside its outline, a plain wheel inside.
                let sense = if wheels[j].ring { -1.0 } else { 1.0 };
                let depth = |p: &Point| -sense * distance(*p, &outlines[j]);
                let near = |p: &&Point| (*p - wheels[j].centre).coords.norm() < teeth[j].outer();
                let met = outlines[i].iter().filter(near);
                let deepest = met.map(depth).fold(0.0, f64::max);
                assert!(deepest < 0.02, "{what} at {driver}: {deepest}");
            }
        }
        let apart = (wheels[1].centre - wheels[0].centre).norm();
        let overlap = match (wheels[0].ring, wheels[1].ring) {
            (true, _) => teeth[1].tip + apart - teeth[0].tip,
            (_, true) => teeth[0].tip + apart - teeth[1].tip,
            _ => teeth[0].tip + teeth[1].tip - apart,
        };
        assert!(overlap > 0.8, "{what}: tips overlap by {overlap}");
    }

    fn check_set(z4: f64, teeth: &[f64], mesh: Mesh) {
        let wheel = |(index, teeth): (usize, &f64)| Mate {
            teeth: *teeth,
            centre_line: 0.5 + 1.1 * index as f64,
        };
        let mates: Vec<Mate> = teeth.iter().enumerate().map(wheel).collect();
        let set = GearSet::new(z4, &mates, mesh, 1.0).unwrap();
        let trains: Vec<Vec<Wheel>> = set.pairs().iter().map(|pair| pair.train()).collect();
        let mate = |wheel: &Wheel| (wheel.teeth, wheel.ring);
        for (index, train) in trains.iter().enumerate() {
            // Wheel 0 of every train is the same driver; it meshes with wheel 1 of each.
            let teeth = |k: usize| {
                let near = match k {
                    0 => trains
                        .iter()
                        .filter_map(|train| train.get(1))
                        .map(mate)
                        .collect(),
                    _ => [k - 1, k + 1]
                        .iter()
                        .filter_map(|k| train.get(*k))
                        .map(mate)
                        .collect(),
                };
                let near: Vec<(u32, bool)> = near;
                Teeth::new(train[k].teeth, train[k].ring, &near)
            };
            for k in 1..train.len() {
                let what = format!("{z4}:{mates:?} {mesh:?}, wheel {index}.{k}");
                check_pair([&train[k - 1], &train[k]], [teeth(k - 1), teeth(k)], &what);
            }
        }
    }

    #[test]
    fn wheels_mesh_at_every_angle() {
        for (z4, z5, mesh) in [
            (36.0, 18.0, Mesh::External),
            (18.0, 36.0, Mesh::External),
            (8.0, 60.0, Mesh::External),
            (12.0, 12.0, Mesh::External),
            (36.0, 18.0, Mesh::Internal),
            (18.0, 36.0, Mesh::Internal),
            (60.0, 54.0, Mesh::Internal),
            (20.0, 90.0, Mesh::Internal),
        ] {
            check_set(z4, &[z5], mesh);
        }
    }

    #[test]
    fn every_wheel_of_a_set_meshes_at_every_angle() {
        for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
            check_set(36.0, &[18.0, 13.0, 24.0, 16.0, 21.0, 12.0], mesh);
        }
        check_set(12.0, &[60.0, 12.0, 30.0], Mesh::External);
    }
}
