//! Faults of a graph or its drivers.

use std::fmt;

/// A reason why a graph cannot be decomposed. Links, pairs and drivers are given by their indices, links in ascending
/// order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The ground is none of the links.
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
    /// A driver drives the same two links of the same pair as an earlier one.
    DrivenTwice {
        /// The driver.
        driver: usize,
        /// The earlier driver.
        earlier: usize,
    },
    /// Links that no pairs join to the ground.
    Apart {
        /// The links, all such.
        links: Vec<usize>,
    },
    /// Links still free to move while all drivers are fixed.
    Undriven {
        /// The links, all such.
        links: Vec<usize>,
        /// Number of their freedoms together, equal to that of missing drivers.
        freedoms: usize,
    },
    /// Links with no freedom to drive, if no driver is given.
    Rigid {
        /// The links, all but the ground.
        links: Vec<usize>,
    },
    /// Links with more constraints than are needed to lock them. There may be several such parts.
    Overconstrained {
        /// The links of the part.
        links: Vec<usize>,
        /// The drivers in it; without any, the pairs alone are too many.
        drivers: Vec<usize>,
        /// Number of surplus constraints.
        excess: usize,
    },
    /// Links of one group or body in which prismatic pairs alone determine an angle twice: in a ring of them, or in a
    /// row of them between links of given angle. A translation stays free instead, though the count is right. Example:
    /// a group of two links and three prismatic pairs.
    Sliding {
        /// The links.
        links: Vec<usize>,
    },
}

impl fmt::Display for Fault {
    /// Debug form, for the programmer's log; texts for the reader are in the string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Fault {}
