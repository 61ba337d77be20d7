//! Conditions that a layout must meet, with their numbers.

use super::{Differential, Kind, Layout, Member};

/// Kinds of coupling between wheels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coupling {
    /// Gears in contact, with standard teeth.
    Contact,
    /// Magnets with a gap between them.
    Magnetic,
}

/// Kinds of conditions. z is a number of teeth or plates, d a pitch diameter, d_a a tip diameter, a_w the axis
/// distance, and k the number of satellites. The index is 1 for the sun, 2 for the satellite and 4 for the ring; z₂′
/// and d₂′ are those of the satellite's wheel in mesh with the ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionKind {
    /// Sun and ring have a common axis, z₄ = z₁ + z₂ + z₂′ (gears in contact).
    Coaxiality,
    /// There is room for gaps, z₄ > z₁ + z₂ + z₂′ (magnets).
    Room,
    /// The sun does not touch the satellites, a_w > (d₁ + d₂)/2 (magnets); (1) of the source paper.
    SunGap,
    /// The ring does not touch the satellites, a_w < (d₄ − d₂′)/2 (magnets); (2) of the source paper, sign corrected.
    RingGap,
    /// All satellites can be mounted at equal angles: (z₁ + z₄)/k is whole, or (z₁ + z₄)/(2k) if poles alternate.
    Assembly,
    /// Neighbouring satellites, if there are two or more, do not touch: sin(π/k) > d_a2/(2 a_w), or d₂ instead of d_a2
    /// for magnets.
    Neighbours,
}

impl ConditionKind {
    /// Identifier of the condition in machine-readable output.
    pub fn code(self) -> &'static str {
        match self {
            Self::Coaxiality => "coaxiality",
            Self::Room => "room",
            Self::SunGap => "sun_gap",
            Self::RingGap => "ring_gap",
            Self::Assembly => "assembly",
            Self::Neighbours => "neighbours",
        }
    }
}

/// Required relation between the two sides of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Both sides are equal.
    Equal,
    /// The left side is greater.
    Greater,
    /// The left side is less.
    Less,
    /// The left side is a whole multiple of the right side.
    Multiple,
}

/// A condition with its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Kind of the condition.
    pub kind: ConditionKind,
    /// The left side.
    pub left: f64,
    /// Required relation between the sides.
    pub relation: Relation,
    /// The right side.
    pub right: f64,
}

/// Maximum difference of z₄ from z₁ + z₂ + z₂′ in gears with profile shift. One tooth changes the axis distance by half
/// a module, and the profile shifts of a mesh usually add up to one module at most.
const SHIFTED_TEETH: f64 = 2.0;

impl Condition {
    /// True for an unmet condition of coaxiality that profile shift may satisfy, because its sides differ by at most
    /// two teeth.
    pub fn within_profile_shift(&self) -> bool {
        let off = (self.left - self.right).abs();
        self.kind == ConditionKind::Coaxiality && !self.met() && off <= SHIFTED_TEETH
    }

    /// True if the condition is met.
    pub fn met(&self) -> bool {
        match self.relation {
            Relation::Equal => self.left == self.right,
            Relation::Greater => self.left > self.right,
            Relation::Less => self.left < self.right,
            Relation::Multiple => self.left % self.right == 0.0,
        }
    }
}

impl Differential {
    /// The condition that this number of satellites can be mounted at equal angles. For stepped satellites, all of them
    /// identical, (z₁z₂′ + z₂z₄)/gcd(z₂, z₂′) replaces z₁ + z₄.
    pub fn assembly(&self, satellites: u32) -> Condition {
        Condition {
            kind: ConditionKind::Assembly,
            left: f64::from(self.pitches()),
            relation: Relation::Multiple,
            right: f64::from(satellites),
        }
    }
}

impl Layout {
    /// The conditions for a coupling, met or not. For a bevel train there is no condition on coaxiality or gaps: its
    /// sun and ring are always coaxial, and axial displacement of the wheels sets the gaps.
    pub fn conditions(&self, coupling: Coupling) -> Vec<Condition> {
        let mut conditions = match (self.train().kind(), coupling) {
            (Kind::Bevel, _) => vec![],
            (_, Coupling::Contact) => vec![self.coaxiality()],
            (_, Coupling::Magnetic) => self.gap_conditions().to_vec(),
        };
        let satellites = self.counts().satellites;
        let assembly = self.train().differential().assembly(satellites);
        conditions.push(Condition {
            // The sum z₁ + z₄ is counted in periods of the field, not in teeth.
            left: assembly.left / f64::from(self.plates_to_period(coupling)),
            ..assembly
        });
        if satellites > 1 {
            conditions.push(Condition {
                kind: ConditionKind::Neighbours,
                left: (std::f64::consts::PI / f64::from(satellites)).sin(),
                relation: Relation::Greater,
                right: self.half_width(coupling),
            });
        }
        conditions
    }

    /// True if all conditions for this coupling are met, and alternating poles, if any, fit on all wheels.
    pub fn can_be_built(&self, coupling: Coupling) -> bool {
        let poles = coupling == Coupling::Contact || self.odd_wheels().next().is_none();
        poles && self.conditions(coupling).iter().all(Condition::met)
    }

    fn coaxiality(&self) -> Condition {
        let teeth = |member| f64::from(self.train().teeth(member));
        Condition {
            kind: ConditionKind::Coaxiality,
            left: teeth(Member::Ring),
            relation: Relation::Equal,
            right: teeth(Member::Sun) + teeth(Member::Satellite) + teeth(Member::Step),
        }
    }

    fn gap_conditions(&self) -> [Condition; 3] {
        let distance = self.axis_distance(Coupling::Magnetic);
        let [least, most] = self.free_distances();
        [
            Condition {
                kind: ConditionKind::Room,
                relation: Relation::Greater,
                ..self.coaxiality()
            },
            Condition {
                kind: ConditionKind::SunGap,
                left: distance,
                relation: Relation::Greater,
                right: least,
            },
            Condition {
                kind: ConditionKind::RingGap,
                left: distance,
                relation: Relation::Less,
                right: most,
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::gears::train::Train;

    fn met(teeth: [f64; 3], satellites: f64, kind: ConditionKind) -> (f64, f64, bool) {
        let train = Train::planar(teeth).unwrap();
        let layout = Layout::new(train, satellites, 1.0, None).unwrap();
        let conditions = layout.conditions(Coupling::Contact);
        let found = conditions.iter().find(|one| one.kind == kind).unwrap();
        (found.left, found.right, found.met())
    }

    #[test]
    fn eighty_teeth_take_two_four_or_five_satellites() {
        for (k, expected) in [
            (2.0, true),
            (3.0, false),
            (4.0, true),
            (5.0, true),
            (6.0, false),
        ] {
            let found = met([20.0, 20.0, 60.0], k, ConditionKind::Assembly);
            assert_eq!(found, (80.0, k, expected));
        }
    }

    /// Satellites of 20 teeth, 22 over the tips, on an axis distance of 20: sin(180°/k) > 22/40. For k = 6 the sine is
    /// ½.
    #[test]
    fn five_satellites_have_room_and_six_have_not() {
        for (k, expected) in [(2.0, true), (5.0, true), (6.0, false)] {
            let (_, width, is_met) = met([20.0, 20.0, 60.0], k, ConditionKind::Neighbours);
            assert_eq!((width, is_met), (0.55, expected), "{k}");
        }
    }

    /// z₁ + 2 z₂ = 60; z₄ differs from this sum by 0, 1, 2 and 3 teeth.
    #[test]
    fn profile_shift_may_make_up_for_two_teeth() {
        for (ring, is_met, within) in [
            (60.0, true, false),
            (61.0, false, true),
            (58.0, false, true),
            (63.0, false, false),
        ] {
            let train = Train::planar([20.0, 20.0, ring]).unwrap();
            let layout = Layout::new(train, 1.0, 1.0, None).unwrap();
            let coaxiality = layout.conditions(Coupling::Contact)[0];
            assert_eq!((coaxiality.left, coaxiality.right), (ring, 60.0));
            assert_eq!(coaxiality.met(), is_met, "{ring}");
            assert_eq!(coaxiality.within_profile_shift(), within, "{ring}");
        }
    }

    #[test]
    fn alternating_poles_halve_the_count_of_the_assembly() {
        let train = Train::planar([20.0, 20.0, 64.0]).unwrap();
        let layout = Layout::new(train, 4.0, 1.0, None).unwrap();
        for (layout, left, is_met) in [(layout, 84.0, true), (layout.alternating(), 42.0, false)] {
            let conditions = layout.conditions(Coupling::Magnetic);
            let assembly = conditions
                .iter()
                .find(|one| one.kind == ConditionKind::Assembly);
            let assembly = assembly.unwrap();
            assert_eq!((assembly.left, assembly.met()), (left, is_met));
        }
    }
}
