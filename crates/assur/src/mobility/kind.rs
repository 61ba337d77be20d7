//! Kinds of pairs and their freedoms.

/// Kind of a kinematic pair, by its form. Most pairs have an *axis* (of rotation, sliding, or a cylinder) or a *normal*
/// (of a plane). Some also have a second direction, perpendicular to this axis or normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PairKind {
    /// A hinge: turns about its axis.
    Revolute,
    /// A slide along its axis.
    Prismatic,
    /// A screw: turns about its axis and moves along the axis by the pitch with every turn.
    Screw {
        /// Displacement per turn, in the unit of length; not zero.
        pitch: f64,
    },
    /// Turns about its axis and slides along the axis.
    Cylindrical,
    /// Turns about two axes that intersect at right angles (also a sphere with a pin in a slot).
    Universal,
    /// A ball in its socket.
    Spherical,
    /// A plane on a plane: turns about the normal, slides in both directions of the plane.
    Planar,
    /// A ball in a cylinder: turns about all axes, slides along the axis of the cylinder.
    SphereInCylinder,
    /// A cylinder on a plane, or any two surfaces in line contact; the second direction is that of the line. Cams and
    /// meshing wheels of planar mechanisms are of this kind, with the line normal to the plane of motion.
    CylinderOnPlane,
    /// A ball on a plane, or any two surfaces in point contact.
    SphereOnPlane,
    /// A pair given only by its number of freedoms. It enters the mobility by count, but not the rank.
    Class(u8),
}

impl PairKind {
    /// All kinds except [`PairKind::Class`], which has no form; the screw has the given pitch.
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

    /// Number of freedoms in space, i, from 1 to 5; for [`PairKind::Class`] as given.
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

    /// True if the pair has a second direction. Turning such a pair about its axis gives a different pair.
    pub fn has_second(self) -> bool {
        matches!(self, Self::Universal | Self::CylinderOnPlane)
    }

    /// True if the pair has an axis or a normal; a ball in its socket has none.
    pub fn has_axis(self) -> bool {
        !matches!(self, Self::Spherical | Self::Class(_))
    }

    /// True if more than two links can meet in the pair, so that any two of these links have the same kind of relative
    /// motion.
    pub fn joins_many(self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Cylindrical | Self::Spherical | Self::Class(1)
        )
    }

    /// True for a higher pair, of surfaces in line or point contact.
    pub fn touches(self) -> bool {
        matches!(self, Self::CylinderOnPlane | Self::SphereOnPlane)
    }

    /// True if the default axis of the pair in a planar scheme is the normal of the plane.
    pub(super) fn turns_in_plane(self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Cylindrical | Self::Universal | Self::SphereInCylinder
        )
    }
}
