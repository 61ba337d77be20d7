//! Faults of a graph or its drivers.

use std::fmt;

/// A reason why a graph cannot be decomposed, with the indices of links (ascending), pairs and drivers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The ground is not one of the links.
    NoGround,
    /// There is no driver.
    NoDriver,
    /// A pair names a link that does not exist.
    NoSuchLink {
        /// The pair.
        pair: usize,
        /// The link it names.
        link: usize,
    },
    /// A pair joins a link to itself.
    SelfJoined {
        /// The pair.
        pair: usize,
        /// The link.
        link: usize,
    },
    /// A pair joins fewer than two links.
    Unjoined {
        /// The pair.
        pair: usize,
    },
    /// A driver is on a pair that does not exist.
    NoSuchPair {
        /// The driver.
        driver: usize,
    },
    /// A driver does not name two different links of its pair.
    NotInPair {
        /// The driver.
        driver: usize,
    },
    /// A driver is on a higher pair, which has two freedoms.
    HigherPair {
        /// The driver.
        driver: usize,
    },
    /// A driver drives the same two links of the same pair as an earlier driver.
    DrivenTwice {
        /// The driver.
        driver: usize,
        /// The earlier driver.
        earlier: usize,
    },
    /// Links that no chain of pairs connects to the ground.
    Apart {
        /// All these links.
        links: Vec<usize>,
    },
    /// Links that can still move when all drivers are fixed.
    Undriven {
        /// All these links.
        links: Vec<usize>,
        /// Degrees of freedom of all these links together: the number of missing drivers.
        freedoms: usize,
    },
    /// Links that cannot move, in a graph without a driver.
    Rigid {
        /// All links except the ground.
        links: Vec<usize>,
    },
    /// A part of the linkage with more constraints than are needed to lock it. Each such part is a fault of its own.
    Overconstrained {
        /// The links of the part.
        links: Vec<usize>,
        /// The drivers within the part; if there is none, its pairs alone impose too many constraints.
        drivers: Vec<usize>,
        /// Number of surplus constraints in the part.
        excess: usize,
    },
    /// Links of one group or body in which prismatic pairs alone determine an angle twice. These pairs form a ring, or
    /// a chain between links whose angles are given. A translation then stays free, although the count of freedoms is
    /// right. An example is a group of two links and three prismatic pairs.
    Sliding {
        /// The links.
        links: Vec<usize>,
    },
}

impl fmt::Display for Fault {
    /// Writes the debug form, for a programmer's log. Messages for the user are in the string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Fault {}
