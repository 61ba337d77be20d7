//! Lagrange's equations of a linkage of several freedoms.

use nalgebra::{SMatrix, SVector};

use super::{NoRun, Reduced};
use crate::forces::Loading;
use crate::forces::applied::{Applied, turning};
use crate::index::StepId;
use crate::mechanism::{DriverSpec, Mechanism, Pose, Unsolved};
use crate::motion::{FreeDrivers, Motion};
use crate::tolerance;

/// Greatest number of drivers that are integrated.
pub(super) const FREEDOMS: usize = 8;

/// A value for each driver; those without a driver are zero.
pub(super) type Coordinates = SVector<f64, FREEDOMS>;

/// A linkage under load whose drivers are independent of one another. The coordinates are those of the drivers, in radians
/// of a crank and in 1/2π of the range of a slide.
#[derive(Clone, Debug)]
pub(super) struct Freedoms {
    pub(super) drivers: FreeDrivers,
    pub(super) loading: Loading,
    /// Drivers that keep their rates.
    pub(super) held: Vec<bool>,
    /// Unit of each coordinate, a radian or a length; 1 without a driver.
    pub(super) units: Coordinates,
    /// Scalar product of gravity with the origin of the coordinates used while solving.
    height: f64,
    /// Pose with the derivatives along the motion, and with those by each coordinate.
    along: Pose<3>,
    by: Vec<Pose<3>>,
    applied: Vec<Applied>,
}

/// Lagrange's equations M q̈ = Q in a pose at rates q̇.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lagrange {
    /// Inertia matrix M: the kinetic energy is ½ q̇ᵀM q̇.
    pub(super) inertia: SMatrix<f64, FREEDOMS, FREEDOMS>,
    /// Generalized forces Q of all but the drives, with the inertia forces at constant rates.
    pub(super) forces: Coordinates,
    /// Energies, and powers of the loads, as quantities reduced to the motion at the rate 1.
    pub(super) along: Reduced,
}

impl Freedoms {
    pub(super) fn new(
        motion: &Motion,
        loading: &Loading,
        held: Vec<bool>,
        input: f64,
    ) -> Result<Self, NoRun> {
        let mechanism = motion.mechanism();
        let drivers = &mechanism.spec().drivers;
        if drivers.len() > FREEDOMS {
            return Err(NoRun::SeveralDrivers);
        }
        if loading.has_friction() {
            return Err(NoRun::Friction);
        }
        let mut units = Coordinates::repeat(1.0);
        for (unit, driver) in units.iter_mut().zip(drivers) {
            if let DriverSpec::Slide { range, .. } = driver {
                *unit = (range[1] - range[0]) / std::f64::consts::TAU;
            }
        }
        Ok(Self {
            drivers: FreeDrivers::new(motion, input).map_err(NoRun::Start)?,
            loading: loading.clone(),
            units,
            height: mechanism.middle().coords.dot(&loading.gravity),
            along: mechanism.blank(),
            by: held.iter().map(|_| mechanism.blank()).collect(),
            applied: Vec::new(),
            held,
        })
    }

    pub(super) fn mechanism(&self) -> &Mechanism {
        self.drivers.mechanism()
    }

    /// Greatest turn rate of a body by a coordinate in the pose evaluated last, and the step that places the body. It grows
    /// without bound towards a singular pose.
    pub(super) fn gain(&self) -> (f64, StepId) {
        let placed = |body| self.mechanism().placed_by(body).unwrap_or(StepId::FIRST);
        let bodies = self.mechanism().bodies();
        let gains = bodies.map(|body| {
            let by = self
                .by
                .iter()
                .map(|pose| turning(pose.state(), body)[0].abs());
            (by.fold(0.0, f64::max), placed(body))
        });
        let greatest = gains.max_by(|a, b| a.0.total_cmp(&b.0));
        greatest.unwrap_or((0.0, StepId::FIRST))
    }

    /// Number of drivers.
    pub(super) fn count(&self) -> usize {
        self.held.len()
    }

    /// Values of the drivers in their own units.
    pub(super) fn own(&self, values: &Coordinates) -> Vec<f64> {
        let own = values.component_mul(&self.units);
        own.as_slice()[..self.count()].to_vec()
    }

    /// Coordinates in the pose taken last.
    pub(super) fn coordinates(&self) -> Coordinates {
        let mut coordinates = Coordinates::zeros();
        let at = self.drivers.coordinates();
        for (index, at) in at.iter().enumerate() {
            coordinates[index] = at / self.units[index];
        }
        coordinates
    }

    /// The equations at coordinates near those of the pose taken last, at rates of the coordinates.
    ///
    /// # Errors
    /// The coordinates have no pose.
    pub(super) fn equations(
        &mut self,
        at: &Coordinates,
        rates: &Coordinates,
    ) -> Result<Lagrange, Unsolved> {
        let (coordinates, along) = (self.own(at), self.own(rates));
        self.drivers
            .place([&coordinates, &along], &mut self.along)?;
        for (index, pose) in self.by.iter_mut().enumerate() {
            let mut along = vec![0.0; coordinates.len()];
            along[index] = self.units[index];
            self.drivers.place([&coordinates, &along], pose)?;
        }
        let (loading, state) = (&self.loading, self.along.state());
        let input = coordinates.first().copied().unwrap_or(0.0);
        self.applied.clear();
        loading.apply(state, input, [1.0, 0.0], &mut self.applied);
        let mut inertia = SMatrix::<f64, FREEDOMS, FREEDOMS>::identity();
        for (column, pose) in self.by.iter().enumerate() {
            let reacting = loading.unit_acceleration(pose.state());
            inertia.set_column(column, &-generalized(&self.by, reacting));
        }
        Ok(Lagrange {
            inertia,
            forces: generalized(&self.by, self.applied.iter().copied()),
            along: loading.reduced_in(state, input, self.height),
        })
    }
}

/// Generalized forces by the coordinates: the virtual work of the forces over the velocities of their places.
fn generalized(by: &[Pose<3>], applied: impl IntoIterator<Item = Applied>) -> Coordinates {
    let mut sum = Coordinates::zeros();
    for one in applied {
        for (sum, pose) in sum.iter_mut().zip(by) {
            let body = &pose.state().bodies[one.body];
            let (from, [turn, _]) = (one.at - body.origin[0], turning(pose.state(), one.body));
            let moment = from.perp(&one.force) + one.couple;
            *sum += one.force.dot(&body.origin[1]) + turn * moment;
        }
    }
    sum
}

impl Lagrange {
    /// Accelerations under given torques of the drives that do not keep their rates. None if these drivers move nothing
    /// with a mass in some sense.
    pub(super) fn accelerations(
        &self,
        held: &[bool],
        torques: &Coordinates,
    ) -> Option<Coordinates> {
        let (mut matrix, mut right) = (self.inertia, self.forces + torques);
        for index in (0..held.len()).filter(|index| held[*index]) {
            matrix.row_mut(index).fill(0.0);
            matrix.column_mut(index).fill(0.0);
            matrix[(index, index)] = 1.0;
            right[index] = 0.0;
        }
        let factor = matrix.cholesky()?;
        let pivots = factor.l_dirty().diagonal();
        let own = matrix.diagonal();
        let mut pivots = pivots.iter().zip(own.iter());
        let has_mass = pivots.all(|(pivot, own)| pivot * pivot > tolerance::NEGLIGIBLE * own);
        has_mass.then(|| factor.solve(&right))
    }

    /// Torques of all drives at accelerations.
    pub(super) fn torques(&self, accelerations: &Coordinates) -> Coordinates {
        self.inertia * accelerations - self.forces
    }
}
