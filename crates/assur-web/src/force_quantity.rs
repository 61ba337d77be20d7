//! Quantities of the forces of a linkage that can be plotted: reactions, torques and forces of the drivers, and the
//! shaking force. They have no derivatives.

use assur::forces::{DriverId, Pair, PairId, Reactions};
use assur::mechanism::{DriverSpec, FRAME};
use assur_draw::Role;
use assur_draw::chart::{Axis, Kind};
use assur_file::{LengthUnit, LinkageDocument};

use crate::forces::Forces;

/// A quantity of the forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ForceQuantity {
    /// A part of the reaction of a pair on the link placed later.
    Reaction(PairId, Part),
    /// The torque or force of a driver on its driven link.
    Drive(DriverId),
    /// A part of the shaking force on the frame; its moment is about the origin.
    Shaking(Part),
}

/// A part of a reaction or of the shaking force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    Magnitude,
    X,
    Y,
    Moment,
}

impl Part {
    const ALL: [Self; 4] = [Self::Magnitude, Self::X, Self::Y, Self::Moment];

    /// Ending of a name, after the kind of force.
    fn ending(self) -> &'static str {
        match self {
            Self::Magnitude => "",
            Self::X => "_x",
            Self::Y => "_y",
            Self::Moment => "_moment",
        }
    }
}

impl ForceQuantity {
    /// All quantities: for each pair the magnitude of its reaction, the components and, except for a hinge, the moment;
    /// then the drivers, and the shaking force.
    pub(crate) fn all(of: &Forces) -> Vec<Self> {
        let reactions = of.statics.pairs().flat_map(|(id, pair)| {
            let is_hinge = !pair.is_slide() && !pair.is_mesh();
            let parts = Part::ALL.into_iter();
            let parts = parts.filter(move |part| !(is_hinge && *part == Part::Moment));
            parts.map(move |part| Self::Reaction(id, part))
        });
        let drivers = of.statics.drivers().map(Self::Drive);
        let shaking = Part::ALL.into_iter().map(Self::Shaking);
        reactions.chain(drivers).chain(shaking).collect()
    }

    /// The quantity with a name as given by [`Self::name`].
    pub(crate) fn named(of: &Forces, name: &str) -> Option<Self> {
        let all = Self::all(of).into_iter();
        let mut found = all.filter(|one| one.name(of) == name);
        found.next()
    }

    /// Name of the quantity: `B.reaction`, `B.reaction_x`, `crank.torque`, `slider.force`. If a point has several
    /// pairs, the link on which the reaction acts and the link from which it comes follow the point:
    /// `C-slider-rod.reaction`.
    pub(crate) fn name(self, of: &Forces) -> String {
        let mechanism = &of.mechanism;
        match self {
            Self::Reaction(id, part) => {
                let pairs: Vec<&Pair> = of.statics.pairs().map(|(_, pair)| pair).collect();
                let own = pairs[id.index()];
                let name = own.name(mechanism);
                let same = pairs.iter().filter(|pair| pair.name(mechanism) == name);
                let subject = if same.count() > 1 {
                    let [on, from] = own.bodies.map(|body| mechanism.body_name(body));
                    [&name, on, from].join("-")
                } else {
                    name
                };
                format!("{subject}.reaction{}", part.ending())
            }
            Self::Shaking(part) => format!("{FRAME}.shaking{}", part.ending()),
            Self::Drive(driver) => {
                let spec = &mechanism.spec().drivers[driver.index()];
                let link = mechanism.spec().driven(spec).unwrap_or_default();
                let kind = if self.is_torque(of) {
                    "torque"
                } else {
                    "force"
                };
                format!("{link}.{kind}")
            }
        }
    }

    /// Heading of the quantity's column in a table: the name with the unit, `B.reaction_N`, `crank.torque_N_m`. A
    /// document without a unit of lengths has no units of forces.
    pub(crate) fn heading(self, of: &Forces, document: &LinkageDocument) -> String {
        let unit = match document.unit {
            None | Some(LengthUnit::None) => "",
            Some(_) if self.is_torque(of) => "_N_m",
            Some(_) => "_N",
        };
        self.name(of) + unit
    }

    /// Whether the quantity is a torque; otherwise it is a force.
    pub(crate) fn is_torque(self, of: &Forces) -> bool {
        match self {
            Self::Reaction(_, part) | Self::Shaking(part) => part == Part::Moment,
            Self::Drive(driver) => {
                let spec = &of.mechanism.spec().drivers[driver.index()];
                matches!(spec, DriverSpec::Crank { .. })
            }
        }
    }

    /// The quantities that the name `choice` selects for the plots: the magnitude of a reaction or of the shaking force
    /// selects its components, too. None for an unknown name.
    pub(crate) fn plotted(of: &Forces, choice: &str) -> Option<Vec<Self>> {
        let one = Self::named(of, choice)?;
        let parts = [Part::Magnitude, Part::X, Part::Y];
        Some(match one {
            Self::Reaction(id, Part::Magnitude) => {
                parts.map(|part| Self::Reaction(id, part)).to_vec()
            }
            Self::Shaking(Part::Magnitude) => parts.map(Self::Shaking).to_vec(),
            _ => vec![one],
        })
    }

    /// The axis of the quantity's plot.
    pub(crate) fn axis(self, of: &Forces) -> Axis {
        Axis {
            name: Some(self.name(of)),
            kind: self.kind(of),
            order: 0,
        }
    }

    pub(crate) fn kind(self, of: &Forces) -> Kind {
        if self.is_torque(of) {
            Kind::Torque
        } else {
            Kind::Force
        }
    }

    /// Role of the quantity's curve.
    pub(crate) fn role(self, of: &Forces) -> Role {
        match self {
            Self::Reaction(_, Part::Magnitude) => Role::Reaction,
            Self::Reaction(_, Part::X) | Self::Shaking(Part::X) => Role::X,
            Self::Reaction(_, Part::Y) | Self::Shaking(Part::Y) => Role::Y,
            Self::Shaking(Part::Magnitude) => Role::Inertia,
            _ if self.is_torque(of) => Role::Torque,
            _ => Role::Force,
        }
    }

    /// Whether the quantity's greatest value over the motion is listed.
    pub(crate) fn is_greatest(self) -> bool {
        let parts = matches!(
            self,
            Self::Reaction(_, Part::Magnitude) | Self::Shaking(Part::Magnitude)
        );
        parts || matches!(self, Self::Drive(_))
    }

    /// Value of the quantity, in N or N·m; none if it is statically indeterminate.
    pub(crate) fn value(self, of: &Forces, found: &Reactions) -> Option<f64> {
        let value = match self {
            Self::Reaction(id, part) => {
                let reaction = found.of(id);
                let [x, y] = reaction.force;
                match part {
                    Part::Magnitude => reaction.vector().map(|force| force.norm()),
                    Part::X => x,
                    Part::Y => y,
                    Part::Moment => reaction.moment,
                }
            }
            Self::Drive(driver) => found.drive(driver),
            Self::Shaking(part) => {
                let (force, moment) = found.shaking(&of.mechanism);
                Some(match part {
                    Part::Magnitude => force.norm(),
                    Part::X => force.x,
                    Part::Y => force.y,
                    Part::Moment => moment,
                })
            }
        };
        value.map(|value| value * of.units.drive(self.is_torque(of)))
    }
}
