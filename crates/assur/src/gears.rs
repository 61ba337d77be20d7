//! Meshing wheels: a pair whose driver turns through a given angle, a [`GearSet`] of several wheels around one driver,
//! and epicyclic [trains](train).

mod set;
pub mod train;

use std::f64::consts::PI;

use crate::tolerance::LENGTH;
use crate::{Dimension, Fault, Invalid, Jet, Vector};
pub use set::{GearSet, Mate};

/// Minimum and maximum number of teeth: a wheel has at least 3, and a screen does not resolve more than 1000.
pub const TEETH: (f64, f64) = (3.0, 1000.0);

/// Height of a tooth above the pitch circle, in modules.
const ADDENDUM: f64 = 1.0;

/// Type of mesh of two wheels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mesh {
    /// External teeth on both wheels: they turn in opposite senses.
    External,
    /// The larger wheel is a ring with internal teeth: both wheels turn in the same sense.
    Internal,
    /// External teeth on both wheels, but with equation (26) of the mixer paper, ψ₅ = +u φ₃. A real pair of such wheels
    /// turns in opposite senses. The printed sign needs an idler between the wheels, so one is drawn.
    AsPrinted,
}

/// A gear pair with the ratio u = z₄/z₅, from whole numbers of teeth z₄ of the driver and z₅ of the driven wheel.
///
/// ```
/// use assur::gears::{GearPair, Mesh};
/// let pair = GearPair::new([36.0, 18.0], Mesh::External, 0.01, 0.0).unwrap();
/// assert_eq!(pair.ratio(), -2.0);
/// assert!((pair.pitch_radius(36) - 0.18).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearPair {
    driver: u32,
    driven: u32,
    mesh: Mesh,
    module: f64,
    centre_line: f64,
}

/// A mounted wheel: teeth, centre relative to the driver's centre, and angle as a function of the driver's angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// Number of teeth.
    pub teeth: u32,
    /// True for internal teeth (a ring), false for external teeth.
    pub ring: bool,
    /// Centre of the wheel relative to the centre of the driver.
    pub centre: Vector,
    /// Transmission ratio: the angle of the wheel is `ratio` times the driver's angle, plus `mounting`.
    pub ratio: f64,
    /// Angle of the wheel at the driver angle 0, such that teeth meet gaps. A tooth of every wheel (an inward tooth of
    /// a ring) is centred on the zero direction of the wheel.
    pub mounting: f64,
}

impl GearPair {
    /// Makes a pair from numbers entered by a person.
    ///
    /// `teeth` are the numbers of teeth of the driver (z₄) and of the driven wheel (z₅). `module` is in the unit of the
    /// lengths. `centre_line` is the direction from the driver's centre to the driven wheel's, in radians.
    ///
    /// # Errors
    /// All faults are returned together: numbers of teeth that are not positive integers within [`TEETH`]; a module
    /// that is not positive or out of range; values that are not finite; equal numbers of teeth in internal mesh.
    /// In a [`Dimension`] with an index, the driven wheel has the index 0.
    pub fn new(
        teeth: [f64; 2],
        mesh: Mesh,
        module: f64,
        centre_line: f64,
    ) -> Result<Self, Vec<Invalid>> {
        let mut reasons = Vec::new();
        let driver = count(Dimension::DriverTeeth, teeth[0]).map_err(|e| reasons.push(e));
        let driven = count(Dimension::DrivenTeeth(0), teeth[1]).map_err(|e| reasons.push(e));
        if let Err(e) = Invalid::check_positive(Dimension::Module, module, LENGTH) {
            reasons.push(e);
        }
        if !centre_line.is_finite() {
            reasons.push(Invalid {
                dimension: Dimension::CentreLine(0),
                fault: Fault::NotFinite,
            });
        }
        match (driver, driven) {
            (Ok(driver), Ok(driven)) if driver == driven && mesh == Mesh::Internal => {
                reasons.push(Invalid {
                    dimension: Dimension::DrivenTeeth(0),
                    fault: Fault::Concentric,
                });
                Err(reasons)
            }
            (Ok(driver), Ok(driven)) if reasons.is_empty() => Ok(Self {
                driver,
                driven,
                mesh,
                module,
                centre_line,
            }),
            _ => Err(reasons),
        }
    }

    /// Type of mesh.
    pub fn mesh(&self) -> Mesh {
        self.mesh
    }

    /// The module, in the unit of the lengths.
    pub fn module(&self) -> f64 {
        self.module
    }

    /// Direction from the centre of the driver to the centre of the driven wheel, radians.
    pub fn centre_line(&self) -> f64 {
        self.centre_line
    }

    /// The signed transmission ratio dψ₅/dφ₃: −u in external mesh, +u in internal mesh and as printed.
    pub fn ratio(&self) -> f64 {
        let u = f64::from(self.driver) / f64::from(self.driven);
        match self.mesh {
            Mesh::External => -u,
            Mesh::Internal | Mesh::AsPrinted => u,
        }
    }

    /// Angle of the driven wheel with derivatives, from the angle of the driver: mixer paper (26), with the sign of the
    /// mesh. The wheels of a linkage turn by Willis's equation instead.
    pub fn driven<const N: usize>(&self, driver: Jet<N>) -> Jet<N> {
        driver * self.ratio()
    }

    /// Pitch radius of a wheel with this number of teeth and the module of the pair.
    pub fn pitch_radius(&self, teeth: u32) -> f64 {
        0.5 * self.module * f64::from(teeth)
    }

    /// The driving wheel, mounted with a tooth along its zero direction.
    pub fn driver_wheel(&self) -> Wheel {
        Wheel {
            teeth: self.driver,
            ring: self.mesh == Mesh::Internal && self.driver > self.driven,
            centre: Vector::zeros(),
            ratio: 1.0,
            mounting: 0.0,
        }
    }

    /// The driven wheel (z₅), mounted in mesh with the driver, or with the idler if there is one.
    pub fn driven_wheel(&self) -> Wheel {
        match self.idler() {
            Some(idler) => self.outer(&idler, self.driven),
            None if self.mesh == Mesh::Internal => self.inner(),
            None => self.outer(&self.driver_wheel(), self.driven),
        }
    }

    /// The idler that gives the printed sign of the ratio; None unless the mesh is [`Mesh::AsPrinted`].
    pub fn idler(&self) -> Option<Wheel> {
        // The ratio does not depend on the teeth of the idler; a small idler keeps the drawing compact.
        let teeth = (self.driver.min(self.driven) / 2).max(12);
        (self.mesh == Mesh::AsPrinted).then(|| self.outer(&self.driver_wheel(), teeth))
    }

    /// The wheels in the order in which they mesh: driver, idler if any, driven.
    pub fn train(&self) -> Vec<Wheel> {
        let (driver, driven) = (Some(self.driver_wheel()), Some(self.driven_wheel()));
        [driver, self.idler(), driven]
            .into_iter()
            .flatten()
            .collect()
    }

    /// A wheel with `teeth` external teeth, beyond `previous` on the centre line.
    fn outer(&self, previous: &Wheel, teeth: u32) -> Wheel {
        let step = f64::from(previous.teeth) / f64::from(teeth);
        let distance = self.pitch_radius(previous.teeth) + self.pitch_radius(teeth);
        // A tooth of one wheel meets a gap of the other at the pitch point.
        let mounting =
            self.centre_line * (1.0 + step) + PI - PI / f64::from(teeth) - step * previous.mounting;
        Wheel {
            teeth,
            ring: false,
            centre: previous.centre + self.along(distance),
            ratio: -step * previous.ratio,
            mounting,
        }
    }

    /// The driven wheel in internal mesh; the larger of the two is the ring.
    fn inner(&self) -> Wheel {
        let step = f64::from(self.driver) / f64::from(self.driven);
        let ring = self.driven > self.driver;
        let contact = self.centre_line + if ring { PI } else { 0.0 };
        let distance = (self.pitch_radius(self.driver) - self.pitch_radius(self.driven)).abs();
        Wheel {
            teeth: self.driven,
            ring,
            centre: self.along(distance),
            ratio: step,
            mounting: contact * (1.0 - step) + PI / f64::from(self.driven),
        }
    }

    fn along(&self, distance: f64) -> Vector {
        let (sin, cos) = self.centre_line.sin_cos();
        Vector::new(distance * cos, distance * sin)
    }
}

fn count(dimension: Dimension, value: f64) -> Result<u32, Invalid> {
    Fault::check_count(value, TEETH).map_err(|fault| Invalid { dimension, fault })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(z4: f64, z5: f64, mesh: Mesh, line: f64) -> GearPair {
        GearPair::new([z4, z5], mesh, 0.02, line).unwrap()
    }

    /// At the pitch point the middle of a tooth meets the middle of a gap, at every driver angle. In pitches, the sum
    /// (external mesh) or difference (internal mesh) of the phases of two wheels is a whole number plus one half.
    #[test]
    fn teeth_meet_gaps() {
        for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
            for (z4, z5) in [(36.0, 18.0), (18.0, 36.0), (31.0, 17.0), (12.0, 85.0)] {
                for line in [-2.0, 0.0, 0.6, 3.0] {
                    let gears = pair(z4, z5, mesh, line);
                    check_train(&gears);
                }
            }
        }
    }

    pub(super) fn check_train(gears: &GearPair) {
        for link in gears.train().windows(2) {
            for driver in [0.0, 0.123, -4.0] {
                check_phases(gears, &link[0], &link[1], driver);
            }
        }
    }

    fn check_phases(gears: &GearPair, a: &Wheel, b: &Wheel, driver: f64) {
        let line = gears.centre_line();
        let phase = |wheel: &Wheel, contact: f64| {
            let angle = wheel.ratio * driver + wheel.mounting;
            (contact - angle) * f64::from(wheel.teeth) / (2.0 * PI)
        };
        let (ra, rb) = (gears.pitch_radius(a.teeth), gears.pitch_radius(b.teeth));
        let distance = (b.centre - a.centre).norm();
        let sum = if a.ring || b.ring {
            assert!((distance - (ra - rb).abs()).abs() < 1e-15);
            let contact = if b.ring { line + PI } else { line };
            phase(a, contact) - phase(b, contact)
        } else {
            assert!((distance - (ra + rb)).abs() < 1e-15);
            phase(a, line) + phase(b, line + PI)
        };
        assert!(((sum - 0.5) - (sum - 0.5).round()).abs() < 1e-12, "{sum}");
    }

    #[test]
    fn senses() {
        assert_eq!(pair(36.0, 18.0, Mesh::External, 0.0).ratio(), -2.0);
        assert_eq!(pair(36.0, 18.0, Mesh::Internal, 0.0).ratio(), 2.0);
        assert_eq!(pair(18.0, 36.0, Mesh::AsPrinted, 0.0).ratio(), 0.5);
        for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
            let gears = pair(36.0, 18.0, mesh, 0.4);
            assert!((gears.driven_wheel().ratio - gears.ratio()).abs() < 1e-15);
        }
    }

    #[test]
    fn bad_teeth_are_named() {
        use Dimension::*;
        let reasons = |teeth, mesh, module, line| {
            let made: Result<GearPair, _> = GearPair::new(teeth, mesh, module, line);
            made.unwrap_err()
        };
        for (value, fault) in [
            (0.0, Fault::NotPositive { value: 0.0 }),
            (-3.0, Fault::NotPositive { value: -3.0 }),
            (1.5, Fault::NotWhole { value: 1.5 }),
            (f64::NAN, Fault::NotFinite),
            (f64::INFINITY, Fault::NotFinite),
            (
                2.0,
                Fault::OutOfRange {
                    value: 2.0,
                    min: 3.0,
                    max: 1000.0,
                },
            ),
            (
                1e9,
                Fault::OutOfRange {
                    value: 1e9,
                    min: 3.0,
                    max: 1000.0,
                },
            ),
        ] {
            let expected = vec![Invalid {
                dimension: DrivenTeeth(0),
                fault,
            }];
            assert_eq!(reasons([36.0, value], Mesh::External, 1.0, 0.0), expected);
        }
        let all = reasons([0.0, 1.5], Mesh::Internal, -1.0, f64::NAN);
        let named: Vec<Dimension> = all.iter().map(|reason| reason.dimension).collect();
        assert_eq!(named, [DriverTeeth, DrivenTeeth(0), Module, CentreLine(0)]);
        let concentric = reasons([20.0, 20.0], Mesh::Internal, 1.0, 0.0);
        assert_eq!(concentric[0].fault, Fault::Concentric);
    }
}
