//! Friction in the motion under load of a linkage of one freedom, where the drive is given and the acceleration is not.

use super::bearing::Bearing;
use super::coulomb::{LOCKING, Law, Sliding};
use crate::forces::kinetostatics::{Kinetostatics, Unbalanced};
use crate::forces::pair::Wrench;
use crate::forces::{Loading, Reactions};
use crate::mechanism::{Mechanism, Pose};
use crate::position::State;

/// Pairs with friction, and the senses in which they slide.
///
/// Reactions depend linearly on the acceleration and on the friction. The torque of the drive is given, so it determines
/// the acceleration for any friction, and Coulomb's law determines the friction.
#[derive(Clone, Debug)]
pub(in crate::forces) struct MovingFriction {
    forces: Kinetostatics,
    /// How each pair with friction slides; the same within a step of integration, so that the forces are smooth.
    contacts: Vec<SlidingContact>,
    /// Buffers.
    found: Reactions,
}

/// How a pair slides.
#[derive(Clone, Copy, Debug, Default)]
struct SlidingContact {
    /// Sense of the relative motion while the input increases; 0 if there is none.
    sense: f64,
    /// Side on which a slide bears.
    bearing: Option<Bearing>,
}

/// Torque of the friction on the input, with its derivatives by the rate and by the torque of the drive.
#[derive(Clone, Copy, Debug)]
pub(in crate::forces) struct FrictionTorque {
    /// Distance from a change of a contact, relative to the speeds and forces of the linkage; negative beyond it.
    pub(in crate::forces) margin: f64,
    pub(in crate::forces) torque: f64,
    pub(in crate::forces) by_rate: f64,
    pub(in crate::forces) by_drive: f64,
}

impl FrictionTorque {
    pub(in crate::forces) const NONE: Self = Self {
        margin: f64::INFINITY,
        torque: 0.0,
        by_rate: 0.0,
        by_drive: 0.0,
    };
}

/// Motion of the input, and the torque of the drive.
#[derive(Clone, Copy, Debug)]
pub(in crate::forces) struct Driven {
    pub(in crate::forces) input: f64,
    pub(in crate::forces) rate: f64,
    /// Sense of the rate, also where it is zero.
    pub(in crate::forces) sense: f64,
    pub(in crate::forces) drive: f64,
}

/// Components of reactions in a pose at a given torque of the drive.
struct Components {
    sliding: Vec<Sliding>,
    /// Components without friction.
    bare: Vec<f64>,
    /// Components that a friction of size one causes, by pair.
    responses: Vec<Vec<f64>>,
    /// Components that a torque of the drive of size one causes.
    driven: Vec<f64>,
}

impl Components {
    fn law(&self, size: f64) -> Law<'_> {
        Law {
            sliding: &self.sliding,
            bare: &self.bare,
            responses: &self.responses,
            size,
        }
    }
}

impl MovingFriction {
    /// None if no pair has friction.
    pub(in crate::forces) fn new(mechanism: &Mechanism, loading: &Loading) -> Option<Self> {
        loading.has_friction().then(|| Self {
            forces: Kinetostatics::new(mechanism),
            contacts: vec![SlidingContact::default(); loading.friction.len()],
            found: Reactions::default(),
        })
    }

    /// Forgets all contacts.
    pub(in crate::forces) fn release(&mut self) {
        self.contacts.fill(SlidingContact::default());
    }

    /// Takes from a pose the senses of the pairs that move there and have none yet; true if all have one.
    pub(in crate::forces) fn take_senses(&mut self, loading: &Loading, state: &State<3>) -> bool {
        for (contact, of) in self.contacts.iter_mut().zip(&loading.friction) {
            if contact.sense == 0.0 {
                let sliding = Sliding::new(&self.forces, *of, state);
                contact.sense = sliding.map_or(0.0, |sliding| sliding.direction());
            }
        }
        self.contacts.iter().all(|contact| contact.sense != 0.0)
    }

    /// Takes the bearings of slides from the reactions in a pose; they stay unknown if the friction is not found there.
    pub(in crate::forces) fn take_bearings(
        &mut self,
        loading: &Loading,
        state: &State<3>,
        at: Driven,
    ) {
        let Ok(components) = self.components(loading, state, at) else {
            return;
        };
        let law = components.law(self.forces.size());
        let Ok((friction, _)) = law.friction() else {
            return;
        };
        for one in &components.sliding {
            let own = loading.friction.iter().position(|of| *of == one.of);
            if let Some(contact) = own.and_then(|own| self.contacts.get_mut(own)) {
                contact.bearing = law.bearing(one, &friction);
            }
        }
    }

    /// Torque of the friction on the input at a constant rate, which the drive is taken to keep; zero at rest.
    ///
    /// # Errors
    /// Those of [`Kinetostatics::reactions`].
    pub(in crate::forces) fn at_rate(
        &mut self,
        loading: &Loading,
        pose: &Pose<3>,
        [input, rate]: [f64; 2],
    ) -> Result<f64, Unbalanced> {
        let Self { forces, found, .. } = self;
        if rate == 0.0 {
            return Ok(0.0);
        }
        forces.balance(loading, pose, input, [rate, 0.0], found)?;
        Ok(-found.loss() / rate)
    }

    /// Torque of the friction on the input. Its derivatives are zero unless asked for.
    ///
    /// # Errors
    /// Those of [`Kinetostatics::reactions`]. The linkage counts as locked already where its friction begins to grow without
    /// bound: its motion there is that of a moment, and the steps would become ever shorter.
    pub(in crate::forces) fn torque(
        &mut self,
        loading: &Loading,
        state: &State<3>,
        at: Driven,
        with_slopes: bool,
    ) -> Result<FrictionTorque, Unbalanced> {
        let size = self.forces.size();
        let components = self.components(loading, state, at)?;
        let (law, sliding) = (components.law(size), &components.sliding);
        let (friction, determinant) = law.friction()?;
        if determinant < LOCKING {
            return Err(Unbalanced::Locked);
        }
        let on_input = |friction: &[f64]| {
            let all = sliding.iter().zip(friction);
            let torques = all.map(|(one, value)| {
                let unit = if one.is_hinge() { size } else { 1.0 };
                value * unit * one.by_input
            });
            torques.sum::<f64>()
        };
        let greatest = law.greatest();
        let margins = sliding.iter().flat_map(|one| {
            let turns = one.share * one.sense * at.sense;
            let bears = law.margin(one, &friction).map(|force| force / greatest);
            [Some(turns), bears]
        });
        let found = FrictionTorque {
            torque: on_input(friction.as_slice()),
            margin: margins.flatten().fold(f64::INFINITY, f64::min),
            ..FrictionTorque::NONE
        };
        if !with_slopes || sliding.is_empty() {
            return Ok(found);
        }
        // Forces have terms with the rate and its square: their central difference, of any width, is the derivative.
        let mut faster = |factor: f64| {
            let rate = factor * at.rate;
            let at = Driven { rate, ..at };
            self.components(loading, state, at).map(|found| found.bare)
        };
        let (fast, slow) = (faster(1.5)?, faster(0.5)?);
        let by_rate = fast.iter().zip(&slow);
        let by_rate: Vec<f64> = by_rate
            .map(|(fast, slow)| (fast - slow) / at.rate)
            .collect();
        let slope = |bare: &[f64]| {
            let slope = law.slope(&friction, bare);
            slope.map(|slope| on_input(slope.as_slice()))
        };
        let slopes = slope(&by_rate).zip(slope(&components.driven));
        let (by_rate, by_drive) = slopes.ok_or(Unbalanced::Unsettled)?;
        Ok(FrictionTorque {
            by_rate,
            by_drive,
            ..found
        })
    }

    fn components(
        &mut self,
        loading: &Loading,
        state: &State<3>,
        at: Driven,
    ) -> Result<Components, Unbalanced> {
        let Self {
            forces,
            contacts,
            found,
        } = self;
        found.place(forces, state);
        let mut applied = Vec::new();
        loading.apply(state, at.input, [at.rate, 0.0], &mut applied);
        let mut bare = forces.caused(state, applied, found)?;
        let pairs = loading.friction.iter().zip(contacts);
        let sliding = pairs.filter_map(|(of, contact)| {
            let mut sliding = Sliding::new(forces, *of, state)?;
            (sliding.sense, sliding.bearing) = (contact.sense * at.sense, contact.bearing);
            Some(sliding)
        });
        let sliding = sliding.filter(|one| one.sense != 0.0 && one.is_known(found));
        let sliding: Vec<Sliding> = sliding.collect();
        let mut driven = forces.caused(state, loading.unit_acceleration(state), found)?;
        let size = forces.size();
        let responses = sliding.iter();
        let responses = responses.map(|one| forces.caused(state, one.applied(1.0, size), found));
        let mut responses = responses.collect::<Result<Vec<_>, _>>()?;
        // The acceleration is what leaves the drive its torque.
        let drive = forces.pairs_held();
        let (inertia, unit) = (driven[drive], forces.drive_unit());
        for value in &mut driven {
            *value /= inertia;
        }
        let given = |components: &mut Vec<f64>, torque: f64| {
            let missing = torque - components[drive];
            for (value, by) in components.iter_mut().zip(&driven) {
                *value += missing * by;
            }
        };
        given(&mut bare, at.drive / unit);
        for response in &mut responses {
            given(response, 0.0);
        }
        for value in &mut driven {
            *value /= unit;
        }
        Ok(Components {
            sliding,
            bare,
            responses,
            driven,
        })
    }
}

impl Kinetostatics {
    /// Torque or force of the first drive whose component is one.
    fn drive_unit(&self) -> f64 {
        match self.components[self.pairs_held()].wrench {
            Wrench::Couple => self.size(),
            _ => 1.0,
        }
    }
}
