//! Several wheels around one driver, each in mesh with it.

use std::f64::consts::TAU;

use super::{ADDENDUM, GearPair, Mesh};
use crate::{Dimension, Fault, Invalid, Vector};

/// A driven wheel as entered by a person, not yet checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mate {
    /// Number of teeth.
    pub teeth: f64,
    /// Direction from the centre of the driver to the centre of the wheel, radians.
    pub centre_line: f64,
}

/// A driver and 1 to [`GearSet::MAX_WHEELS`] driven wheels. Each wheel forms a pair with the driver; all pairs have the
/// same module and the same kind of mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct GearSet {
    pairs: Vec<GearPair>,
    module: f64,
}

impl GearSet {
    /// Maximum number of driven wheels.
    pub const MAX_WHEELS: usize = 6;

    /// Makes a set from numbers entered by a person: teeth of the driver (z₄), driven wheels, kind of mesh, and module.
    ///
    /// Wheels may overlap: see [`GearSet::overlaps`].
    ///
    /// # Errors
    /// Every reason at once: the reasons of [`GearPair::new`] for each wheel; a number of wheels out of range; internal
    /// mesh with some wheels smaller than the driver and others larger.
    pub fn new(driver: f64, mates: &[Mate], mesh: Mesh, module: f64) -> Result<Self, Vec<Invalid>> {
        let mut reasons = Vec::new();
        if !(1..=Self::MAX_WHEELS).contains(&mates.len()) {
            reasons.push(Invalid {
                dimension: Dimension::Wheels,
                fault: Fault::OutOfRange {
                    value: mates.len() as f64,
                    min: 1.0,
                    max: Self::MAX_WHEELS as f64,
                },
            });
        }
        let mut pairs: Vec<GearPair> = Vec::new();
        for (wheel, mate) in mates.iter().enumerate().take(Self::MAX_WHEELS) {
            match GearPair::new([driver, mate.teeth], mesh, module, mate.centre_line) {
                Ok(pair) => {
                    let first = pairs.first().unwrap_or(&pair);
                    if mesh == Mesh::Internal && pair.is_within() != first.is_within() {
                        reasons.push(Invalid {
                            dimension: Dimension::DrivenTeeth(wheel),
                            fault: Fault::BothSides,
                        });
                    }
                    pairs.push(pair);
                }
                Err(found) => {
                    for reason in found.into_iter().map(|reason| of_wheel(reason, wheel)) {
                        // A fault of the driver or of the module is found in every pair, but listed once.
                        if !reasons.contains(&reason) {
                            reasons.push(reason);
                        }
                    }
                }
            }
        }
        if reasons.is_empty() {
            Ok(Self { pairs, module })
        } else {
            Err(reasons)
        }
    }

    /// Pairs of the driver with each of its wheels, in the order given.
    pub fn pairs(&self) -> &[GearPair] {
        &self.pairs
    }

    /// The module of all wheels, in the unit of the lengths.
    pub fn module(&self) -> f64 {
        self.module
    }

    /// Pairs of driven wheels (counted from 0, the smaller index first) that would collide in one plane: the tip
    /// circles of the wheels, or of their idlers, overlap. Two rings around one driver always overlap.
    pub fn overlaps(&self) -> Vec<[usize; 2]> {
        let discs: Vec<Vec<Disc>> = self.pairs.iter().map(GearPair::discs).collect();
        let mut found = Vec::new();
        for first in 0..discs.len() {
            for second in first + 1..discs.len() {
                let fouls = |a: &Disc| discs[second].iter().any(|b| a.overlaps(b));
                if discs[first].iter().any(fouls) {
                    found.push([first, second]);
                }
            }
        }
        found
    }

    /// Direction, in [−π, π], of the middle of the widest free angle around the driver: the place for another wheel.
    pub fn free_direction(&self) -> f64 {
        let taken: Vec<[f64; 2]> = self.pairs.iter().map(GearPair::shadow).collect();
        // Free angle from the end of one wheel's covered angle to the start of the next wheel's.
        let gap = |(wheel, [from, to]): (usize, &[f64; 2])| {
            let others = taken
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != wheel);
            let ahead = others.map(|(_, [other, _])| (other - from).rem_euclid(TAU));
            [*to, from + ahead.fold(TAU, f64::min)]
        };
        let widest = taken.iter().enumerate().map(gap).reduce(|best, gap| {
            if gap[1] - gap[0] > best[1] - best[0] {
                gap
            } else {
                best
            }
        });
        let middle = widest.map_or(0.0, |[from, to]| 0.5 * (from + to));
        crate::angle::nearest_to(middle, 0.0)
    }
}

/// Converts a defect of a pair to a defect of the set; `wheel` is the index of the pair's driven wheel.
fn of_wheel(reason: Invalid, wheel: usize) -> Invalid {
    let dimension = match reason.dimension {
        Dimension::DrivenTeeth(_) => Dimension::DrivenTeeth(wheel),
        Dimension::CentreLine(_) => Dimension::CentreLine(wheel),
        other => other,
    };
    Invalid {
        dimension,
        ..reason
    }
}

/// Tip circle of a wheel.
struct Disc {
    centre: Vector,
    radius: f64,
}

impl Disc {
    fn overlaps(&self, other: &Self) -> bool {
        (self.centre - other.centre).norm() < self.radius + other.radius
    }
}

impl GearPair {
    /// True if the driver is a ring around the driven wheel.
    fn is_within(&self) -> bool {
        self.driver_wheel().ring
    }

    /// Tip circles of the pair's wheels, without the driver's.
    fn discs(&self) -> Vec<Disc> {
        let mates = self.train().into_iter().skip(1);
        mates
            .map(|wheel| Disc {
                centre: wheel.centre,
                radius: self.pitch_radius(wheel.teeth) + ADDENDUM * self.module,
            })
            .collect()
    }

    /// Start and end of the angle that the tip circles cover, seen from the driver's centre.
    fn shadow(&self) -> [f64; 2] {
        // Half the angle that a tip circle covers; a quarter turn if the circle contains the driver's centre.
        let disc = |Disc { centre, radius }: Disc| {
            let tangent = centre.norm_squared() - radius * radius;
            radius.atan2(tangent.max(0.0).sqrt())
        };
        let half = self.discs().into_iter().map(disc).fold(0.0, f64::max);
        [self.centre_line - half, self.centre_line + half]
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::check_train;
    use super::*;

    fn mates(teeth: &[f64], degrees: &[f64]) -> Vec<Mate> {
        let mate = |(teeth, degrees): (&f64, &f64)| Mate {
            teeth: *teeth,
            centre_line: degrees.to_radians(),
        };
        teeth.iter().zip(degrees).map(mate).collect()
    }

    fn set(driver: f64, teeth: &[f64], degrees: &[f64], mesh: Mesh) -> GearSet {
        GearSet::new(driver, &mates(teeth, degrees), mesh, 0.02).unwrap()
    }

    const SIXTY: [f64; 6] = [-40.0, 20.0, 80.0, 140.0, 200.0, 260.0];

    #[test]
    fn teeth_of_every_wheel_meet_gaps() {
        for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
            let gears = set(36.0, &[18.0, 17.0, 12.0, 31.0, 9.0, 24.0], &SIXTY, mesh);
            assert_eq!(gears.pairs().len(), 6);
            for pair in gears.pairs() {
                assert_eq!(pair.driver_wheel(), gears.pairs()[0].driver_wheel());
                check_train(pair);
            }
        }
    }

    #[test]
    fn reasons_name_the_wheel() {
        use Dimension::*;
        let named = |driver, mates: &[Mate], mesh, module| -> Vec<(Dimension, Fault)> {
            let reasons = GearSet::new(driver, mates, mesh, module).unwrap_err();
            reasons.iter().map(|r| (r.dimension, r.fault)).collect()
        };
        let mut bad = mates(&[18.0, 1.5, 20.0], &[0.0, 90.0, f64::NAN]);
        assert_eq!(
            named(0.0, &bad, Mesh::External, -1.0),
            [
                (DriverTeeth, Fault::NotPositive { value: 0.0 }),
                (Module, Fault::NotPositive { value: -1.0 }),
                (DrivenTeeth(1), Fault::NotWhole { value: 1.5 }),
                (CentreLine(2), Fault::NotFinite),
            ]
        );
        bad = mates(&[18.0, 36.0, 60.0], &[0.0, 90.0, 180.0]);
        assert_eq!(
            named(36.0, &bad, Mesh::Internal, 1.0),
            [
                (DrivenTeeth(1), Fault::Concentric),
                (DrivenTeeth(2), Fault::BothSides),
            ]
        );
        for count in [0, 7] {
            let fault = Fault::OutOfRange {
                value: f64::from(count),
                min: 1.0,
                max: 6.0,
            };
            let wheels = mates(&[18.0; 7][..count as usize], &[0.0; 7]);
            let found = named(36.0, &wheels, Mesh::External, 1.0);
            assert_eq!(found, [(Wheels, fault)]);
        }
    }

    #[test]
    fn overlaps_are_where_tips_pass() {
        // Six wheels of 18 teeth around a driver of 36 do not overlap. Their centres are 27 modules from the driver's.
        // Two centres at an angle β are 54 sin(β/2) modules apart, and the wheels touch at 20 modules.
        let even = set(36.0, &[18.0; 6], &SIXTY, Mesh::External);
        assert_eq!(even.overlaps(), [] as [[usize; 2]; 0]);
        let clear = 2.0 * (20.0 / 54.0_f64).asin().to_degrees();
        for (degrees, fouls) in [(clear + 1e-6, false), (clear - 1e-6, true)] {
            let near = set(36.0, &[18.0; 2], &[350.0, 350.0 + degrees], Mesh::External);
            assert_eq!(near.overlaps() == [[0, 1]], fouls, "{degrees}");
        }
        let three = set(36.0, &[18.0; 3], &[0.0, 170.0, 190.0], Mesh::External);
        assert_eq!(three.overlaps(), [[1, 2]]);
        let rings = set(36.0, &[60.0, 72.0], &[0.0, 180.0], Mesh::Internal);
        assert_eq!(rings.overlaps(), [[0, 1]]);
        // The driven wheels do not overlap. Their idlers of 12 teeth overlap at 35°, but not at 37°.
        for (degrees, fouls) in [(37.0, false), (35.0, true)] {
            let idlers = set(34.0, &[3.0; 2], &[0.0, degrees], Mesh::AsPrinted);
            assert_eq!(idlers.overlaps() == [[0, 1]], fouls, "{degrees}");
        }
    }

    #[test]
    fn the_next_wheel_stands_in_the_widest_gap() {
        let free = |teeth: &[f64], degrees: &[f64]| {
            let set = set(36.0, teeth, degrees, Mesh::External);
            set.free_direction().to_degrees()
        };
        assert!((free(&[18.0], &[-40.0]) - 140.0).abs() < 1e-9);
        assert!((free(&[18.0; 2], &[-40.0, 50.0]) + 175.0).abs() < 1e-9);
        // The large wheel covers a greater angle than the small one: the middle of the free angle is off the bisector.
        let inner = free(&[12.0, 60.0], &[0.0, 180.0]).abs();
        assert!(inner < 80.0 && inner > 40.0, "{inner}");
        let last = free(&[18.0; 5], &SIXTY[..5]);
        assert!((last + 100.0).abs() < 1e-9, "{last}");
    }
}
