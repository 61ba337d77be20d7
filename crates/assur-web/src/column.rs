//! Columns of plots against each other: quantities of the motion with their derivatives, and forces.

use assur::mechanism::Mechanism;
use assur::motion::Column as Kinematic;
use assur_file::is_of_forces;

use crate::force_quantity::ForceQuantity;
use crate::forces::Forces;

/// A column: a quantity of the motion or one of its derivatives, or a force.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Column {
    Kinematic(Kinematic),
    Force(ForceQuantity),
}

impl Column {
    /// The column with a name such as `C.dx` or `B.reaction`. `forces` are asked for only if the name is that of a force.
    pub(crate) fn named<'a>(
        mechanism: &Mechanism,
        forces: impl Fn() -> &'a Forces,
        name: &str,
    ) -> Option<Self> {
        if is_of_forces(name) {
            return ForceQuantity::named(forces(), name).map(Self::Force);
        }
        Kinematic::named(mechanism, name).map(Self::Kinematic)
    }

    /// The column of the motion, unless it is a force.
    pub(crate) fn kinematic(self) -> Option<Kinematic> {
        match self {
            Self::Kinematic(column) => Some(column),
            Self::Force(_) => None,
        }
    }
}
