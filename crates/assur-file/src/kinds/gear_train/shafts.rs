//! Conversion of shafts and couplings between the file and the engine.

use super::*;

impl From<ShaftDocument> for Shaft {
    fn from(shaft: ShaftDocument) -> Self {
        match shaft {
            ShaftDocument::Sun => Self::Sun,
            ShaftDocument::Carrier => Self::Carrier,
            ShaftDocument::Ring => Self::Ring,
        }
    }
}

impl From<Shaft> for ShaftDocument {
    fn from(shaft: Shaft) -> Self {
        match shaft {
            Shaft::Sun => Self::Sun,
            Shaft::Carrier => Self::Carrier,
            Shaft::Ring => Self::Ring,
        }
    }
}

impl From<CouplingDocument> for Coupling {
    fn from(coupling: CouplingDocument) -> Self {
        match coupling {
            CouplingDocument::Magnetic => Self::Magnetic,
            CouplingDocument::Contact => Self::Contact,
        }
    }
}

impl ObserverDocument {
    /// The shaft with which the observer rotates; none for an observer on the ground.
    pub fn shaft(self) -> Option<Shaft> {
        match self {
            Self::Ground => None,
            Self::Sun => Some(Shaft::Sun),
            Self::Carrier => Some(Shaft::Carrier),
            Self::Ring => Some(Shaft::Ring),
        }
    }
}
