//! What pairs there are, by the freedoms that they leave.

/// A kinematic pair by its form. Each has an *axis* (of the turn, the way, the cylinder) or a
/// *normal* (of the plane), and some a second direction at right angles to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PairKind {
    /// A hinge: turns about its axis.
    Revolute,
    /// A slide along its axis.
    Prismatic,
    /// A screw: turns about its axis and goes the pitch along it with every turn.
    Screw {
        /// The way of a whole turn, in the unit of the lengths; not zero.
        pitch: f64,
    },
    /// Turns about its axis and slides along it.
    Cylindrical,
    /// Turns about two axes that cross at right angles (also a sphere with a pin in a slot).
    Universal,
    /// A ball in its socket.
    Spherical,
    /// A plane on a plane: turns about the normal, slides in both directions of the plane.
    Planar,
    /// A ball in a cylinder: turns in every way, slides along the axis of the cylinder.
    SphereInCylinder,
    /// A cylinder on a plane, or any two surfaces that touch along a line: the second direction is that of the
    /// line. Higher pairs of planar mechanisms, cams and wheels in mesh, are of this kind; the line is then normal
    /// to the plane of motion.
    CylinderOnPlane,
    /// A ball on a plane, or any two surfaces that touch in a point.
    SphereOnPlane,
    /// A pair given only by its number of freedoms: it can be counted, and has no rank.
    Class(u8),
}

impl PairKind {
    /// The pairs that have a form, with a pitch for the screw.
    pub fn forms(pitch: f64) -> [Self; 10] {
        [
            Self::Revolute,
            Self::Prismatic,
            Self::Screw { pitch },
            Self::Cylindrical,
            Self::Universal,
            Self::Spherical,
            Self::Planar,
            Self::SphereInCylinder,
            Self::CylinderOnPlane,
            Self::SphereOnPlane,
        ]
    }

    /// i: how many freedoms it leaves in space, 1 to 5 (of [`PairKind::Class`] as told).
    pub fn freedoms(self) -> u8 {
        match self {
            Self::Revolute | Self::Prismatic | Self::Screw { .. } => 1,
            Self::Cylindrical | Self::Universal => 2,
            Self::Spherical | Self::Planar => 3,
            Self::SphereInCylinder | Self::CylinderOnPlane => 4,
            Self::SphereOnPlane => 5,
            Self::Class(freedoms) => freedoms,
        }
    }

    /// Whether it has a second direction, which tells it from the same pair turned about its axis.
    pub fn has_second(self) -> bool {
        matches!(self, Self::Universal | Self::CylinderOnPlane)
    }

    /// Whether its directions matter: a ball in its socket has none.
    pub fn has_axis(self) -> bool {
        !matches!(self, Self::Spherical | Self::Class(_))
    }

    /// Whether more than two links can meet in one: what any two of them may do, any two others may.
    pub fn joins_many(self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Cylindrical | Self::Spherical | Self::Class(1)
        )
    }

    /// Whether it is of surfaces that touch along a line or in a point: a higher pair.
    pub fn touches(self) -> bool {
        matches!(self, Self::CylinderOnPlane | Self::SphereOnPlane)
    }

    /// Whether it lets its links turn in the plane to which its axis is normal.
    pub(super) fn turns_in_plane(self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Cylindrical | Self::Universal | Self::SphereInCylinder
        )
    }
}
