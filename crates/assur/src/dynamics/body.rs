//! Bodies of the differential and the meshes between them.

use crate::gears::train::Shaft;

/// Number of bodies.
pub(super) const N: usize = 4;

/// A body of the differential. Its angle is measured relative to the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Body {
    /// The sun, link 1.
    Sun,
    /// The satellites, link 2: all alike, and all turned through the same angle.
    Satellite,
    /// The carrier, link 3.
    Carrier,
    /// The ring, link 4.
    Ring,
}

impl Body {
    /// All bodies, in the order of their numbers.
    pub const ALL: [Self; 4] = [Self::Sun, Self::Satellite, Self::Carrier, Self::Ring];

    /// Index of the body in arrays of all bodies.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// Shafts: the bodies that can be driven from the ground.
impl Shaft {
    /// The body of the shaft.
    pub fn body(self) -> Body {
        match self {
            Self::Sun => Body::Sun,
            Self::Carrier => Body::Carrier,
            Self::Ring => Body::Ring,
        }
    }
}

/// A magnetic mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mesh {
    /// Sun and satellites, in external mesh.
    Sun,
    /// Satellites and ring, in internal mesh.
    Ring,
}

impl Mesh {
    /// Both meshes.
    pub const ALL: [Self; 2] = [Self::Sun, Self::Ring];

    /// The central wheel of the mesh.
    pub fn wheel(self) -> Body {
        match self {
            Self::Sun => Body::Sun,
            Self::Ring => Body::Ring,
        }
    }
}
