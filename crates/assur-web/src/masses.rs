//! Masses of the links of a linkage, as the page lists them.

use assur::forces::LinkMass;
use serde::Serialize;

use crate::moving::Moving;

/// Mass of a link: as given, or that of a uniform bar.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MassHere {
    link: String,
    mass: f64,
    /// Moment of inertia about the centre of mass, in units of mass and of length.
    inertia: f64,
    /// Centre of mass, from the first point of the link: towards the second, and to the left; in the unit of lengths.
    centre: [f64; 2],
    /// Whether the centre of mass or the moment of inertia is given; otherwise the link is a uniform bar, or a mass at
    /// its point.
    given: bool,
    /// Whether the link has two points, so that it can be a uniform bar.
    bar: bool,
}

impl Moving {
    /// Masses of the moving links, in the order of the document.
    pub(crate) fn masses(&self) -> Vec<MassHere> {
        let mechanism = self.mechanism();
        let links = mechanism.link_ids().zip(&self.document().links);
        let masses = links.map(|(link, document)| {
            let LinkMass {
                mass,
                centre,
                inertia,
            } = LinkMass::of(mechanism, link);
            MassHere {
                link: document.name.clone(),
                mass,
                inertia,
                centre: centre.into(),
                given: document.centre_of_mass.is_some() || document.inertia.is_some(),
                bar: document.points.len() > 1,
            }
        });
        masses.collect()
    }
}
