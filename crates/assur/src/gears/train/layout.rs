//! Dimensions of the wheels of a train.

use super::{Counts, Coupling, Kind, Member, Train, TrainError};
use crate::Fault;
use crate::gears::ADDENDUM;
use crate::tolerance::LENGTH;

/// A train with its dimensions, and with satellites at equal angles. Its numbers are always valid.
///
/// The [conditions](Layout::conditions) decide whether the train can be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    train: Train,
    counts: Counts,
    module: f64,
    axis_distance: Option<f64>,
    /// True if north and south poles of magnets alternate around each wheel.
    alternating: bool,
}

impl Layout {
    /// Makes a layout from numbers entered by a person: the number of satellites, the module m, and the axis distance
    /// a_w. A wheel with z teeth has the diameter d = m z. The distance a_w, from the central axis to a satellite's
    /// axis, is used for magnets only; without it the gaps at sun and ring are equal.
    ///
    /// # Errors
    /// Every reason at once: a number of satellites outside 1 to
    /// [`GearSet::MAX_WHEELS`](crate::gears::GearSet::MAX_WHEELS); lengths that are not positive or not in range.
    pub fn new(
        train: Train,
        satellites: f64,
        module: f64,
        axis_distance: Option<f64>,
    ) -> Result<Self, Vec<TrainError>> {
        let mut reasons = Vec::new();
        let counts = Counts::new(satellites).map_err(|error| reasons.push(error));
        if let Err(fault) = Fault::check_positive(module, LENGTH) {
            reasons.push(TrainError::Module { fault });
        }
        // The upper limit is the diameter of a wheel of 1000 teeth with the greatest module.
        let range = (LENGTH.0, 1e3 * LENGTH.1);
        if let Some(Err(fault)) = axis_distance.map(|given| Fault::check_positive(given, range)) {
            reasons.push(TrainError::AxisDistance { fault });
        }
        match counts {
            Ok(counts) if reasons.is_empty() => Ok(Self {
                train,
                counts,
                module,
                axis_distance,
                alternating: false,
            }),
            _ => Err(reasons),
        }
    }

    /// The layout with poles that alternate around each wheel. A period of the field then spans two plates.
    pub fn alternating(self) -> Self {
        Self {
            alternating: true,
            ..self
        }
    }

    /// Wheels with an odd number of plates, around which poles cannot alternate. Empty if the poles are alike.
    pub fn odd_wheels(&self) -> impl Iterator<Item = Member> {
        let members: &[Member] = match self.train.kind() {
            _ if !self.alternating => &[],
            Kind::Planar | Kind::Bevel => &[Member::Sun, Member::Satellite, Member::Ring],
            Kind::Stepped => &[Member::Sun, Member::Satellite, Member::Step, Member::Ring],
        };
        let members = members.iter().copied();
        members.filter(|member| self.train.teeth(*member) % 2 == 1)
    }

    /// The wheels of the layout.
    pub fn train(&self) -> &Train {
        &self.train
    }

    pub(super) fn with(&self, train: Train) -> Self {
        Self { train, ..*self }
    }

    /// Number of plates per period of the field; 1 for gears in contact.
    pub(super) fn plates_to_period(&self, coupling: Coupling) -> u32 {
        match coupling {
            Coupling::Magnetic if self.alternating => 2,
            Coupling::Magnetic | Coupling::Contact => 1,
        }
    }

    /// Numbers of links and pairs of the train.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// The module.
    pub fn module(&self) -> f64 {
        self.module
    }

    /// Pitch diameter of a wheel, d = m z.
    pub fn diameter(&self, member: Member) -> f64 {
        self.module * f64::from(self.train.teeth(member))
    }

    /// Axis distance a_w, from the central axis to the centre of a satellite. For gears in contact it follows from sun
    /// and satellite. For magnets it is the given distance, or by default the distance with equal gaps. For bevel
    /// wheels it is the mean of the pitch radii of sun and ring.
    pub fn axis_distance(&self, coupling: Coupling) -> f64 {
        let [sun, satellite, step, ring] =
            [Member::Sun, Member::Satellite, Member::Step, Member::Ring]
                .map(|member| f64::from(self.train.teeth(member)));
        match (self.train.kind(), coupling, self.axis_distance) {
            // With pitch radii r₁, r₂ and r₄ of sun, satellite and ring, pitch angles δ₁ and δ₂, and Σ = δ₁ + δ₂, the
            // centre of the satellite's pitch circle is r₂ cot δ₂ sin Σ = (r₁ + r₄)/2 away from the central axis.
            (Kind::Bevel, ..) => 0.25 * self.module * (sun + ring),
            (_, Coupling::Contact, _) => 0.5 * self.module * (sun + satellite),
            (_, Coupling::Magnetic, Some(given)) => given,
            (_, Coupling::Magnetic, None) => 0.25 * self.module * (sun + satellite + (ring - step)),
        }
    }

    /// Gaps between pitch circles of magnets at sun and ring; negative if the circles overlap. None for bevel wheels.
    pub fn gaps(&self) -> Option<[f64; 2]> {
        let planar = self.train.kind() != Kind::Bevel;
        let distance = self.axis_distance(Coupling::Magnetic);
        let [least, most] = self.free_distances();
        planar.then_some([distance - least, most - distance])
    }

    /// Clearances at sun and ring between tips of magnets with teeth of the standard addendum m: [gaps](Self::gaps)
    /// less two addenda. Negative if the teeth reach into one another; wheels then cannot slip. None for bevel wheels.
    pub fn tip_clearances(&self) -> Option<[f64; 2]> {
        let teeth = 2.0 * ADDENDUM * self.module;
        self.gaps().map(|gaps| gaps.map(|gap| gap - teeth))
    }

    /// Least and greatest axis distance without overlap of pitch circles: limits in the source paper's (1) and (2).
    pub(super) fn free_distances(&self) -> [f64; 2] {
        let teeth = |member| f64::from(self.train.teeth(member));
        [
            0.5 * self.module * (teeth(Member::Sun) + teeth(Member::Satellite)),
            0.5 * self.module * (teeth(Member::Ring) - teeth(Member::Step)),
        ]
    }

    /// Sine of half the angle that a satellite subtends at the central axis. Teeth are included for gears in contact.
    pub(super) fn half_width(&self, coupling: Coupling) -> f64 {
        let teeth = |member| f64::from(self.train.teeth(member));
        let largest = teeth(Member::Satellite).max(teeth(Member::Step));
        let addendum = match coupling {
            Coupling::Contact => ADDENDUM,
            Coupling::Magnetic => 0.0,
        };
        match self.train.kind() {
            Kind::Planar | Kind::Stepped => {
                self.module * (0.5 * largest + addendum) / self.axis_distance(coupling)
            }
            Kind::Bevel => {
                // With k satellites, neighbouring tip cones of half-angle δ_a touch if sin(π/k) sin Σ = sin δ_a. Here
                // Σ is the angle between the axis of a satellite and the central axis.
                let sine = self.train.inclination().sin();
                let cone = (2.0 * largest * sine).atan2(teeth(Member::Sun) + teeth(Member::Ring));
                let tip = cone + (2.0 * addendum * cone.sin() / largest).atan();
                tip.sin() / sine
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(teeth: [f64; 3], module: f64, axis_distance: Option<f64>) -> Layout {
        Layout::new(Train::planar(teeth).unwrap(), 3.0, module, axis_distance).unwrap()
    }

    /// Module 2, teeth 20, 20, 66: pitch radii 20, 20 and 66. Gears in contact have the axis distance 40. There is room
    /// for 66 − 60 = 6 between the circles, 3 at the sun and 3 at the ring.
    #[test]
    fn axis_distance_and_gaps_follow_from_the_pitch_radii() {
        let equal = layout([20.0, 20.0, 66.0], 2.0, None);
        assert_eq!(equal.diameter(Member::Ring), 132.0);
        assert_eq!(equal.axis_distance(Coupling::Contact), 40.0);
        assert_eq!(equal.axis_distance(Coupling::Magnetic), 43.0);
        assert_eq!(equal.gaps(), Some([3.0, 3.0]));
        // Two addenda of 2 each are longer than the gap of 3.
        assert_eq!(equal.tip_clearances(), Some([-1.0, -1.0]));
        let given = layout([20.0, 20.0, 66.0], 2.0, Some(41.0));
        assert_eq!(given.gaps(), Some([1.0, 5.0]));
        assert_eq!(given.axis_distance(Coupling::Contact), 40.0);
    }

    /// The satellite of radius 10 (11 with its teeth) is 20 from the axis.
    #[test]
    fn half_the_angle_of_a_satellite_has_the_sine_of_radius_over_distance() {
        let contact = layout([20.0, 20.0, 60.0], 1.0, None);
        assert_eq!(contact.half_width(Coupling::Contact), 0.55);
        assert_eq!(contact.half_width(Coupling::Magnetic), 0.5);
    }

    /// Equal bevel wheels of 20 teeth with axes at right angles have pitch cones of 45°, and pitch radii of 10: the
    /// centre of a satellite is 10 from the axis.
    #[test]
    fn the_satellite_of_bevel_wheels_is_at_the_mean_of_the_pitch_radii() {
        let bevel = Layout::new(Train::bevel([20.0; 3]).unwrap(), 2.0, 1.0, None).unwrap();
        assert_eq!(bevel.axis_distance(Coupling::Contact), 10.0);
        assert_eq!(bevel.gaps(), None);
        let half_width = bevel.half_width(Coupling::Magnetic);
        assert!((half_width - 0.5_f64.sqrt()).abs() < 1e-15, "{half_width}");
    }

    #[test]
    fn poles_alternate_around_wheels_with_an_even_number() {
        let alternating = layout([21.0, 20.0, 63.0], 1.0, None).alternating();
        let odd: Vec<Member> = alternating.odd_wheels().collect();
        assert_eq!(odd, [Member::Sun, Member::Ring]);
        assert_eq!(
            layout([21.0, 20.0, 63.0], 1.0, None).odd_wheels().count(),
            0
        );
    }
}
