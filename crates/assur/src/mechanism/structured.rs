//! The structure of a draft's bodies, and what is wrong with it by their names.

use super::body::Bodies;
use super::draft::Defect;
use super::resolved::Resolved;
use crate::index::{BodyId, Id};
use crate::structure::{Fault, Structure, decompose};

/// Driver and Assur groups of the bodies.
///
/// # Errors
/// All that is wrong with the count of pairs.
pub(super) fn structured(draft: &Resolved<'_>, bodies: &Bodies) -> Result<Structure, Vec<Defect>> {
    let graph = bodies.graph(draft.places.ids());
    let drivers = draft.drivers.iter();
    let drivers = drivers.map(|driver| bodies.driver(draft, driver, &graph));
    let drivers: Option<Vec<_>> = drivers.collect();
    let drivers = drivers.ok_or_else(|| vec![Defect::NoDriver])?;
    let mobility = graph.mobility();
    let name = |link: &usize| draft.body_name(BodyId::at(*link)).to_owned();
    let named = |links: Vec<usize>| links.iter().map(name).collect();
    decompose(&graph, &drivers).map_err(|faults| {
        let defect = |fault: Fault| match fault {
            Fault::Apart { links } => Defect::Loose(named(links)),
            Fault::Undriven { links, .. } => Defect::Underdriven {
                mobility,
                links: named(links),
            },
            Fault::Overconstrained { links, .. } | Fault::Sliding { links } => Defect::Locked {
                mobility,
                links: named(links),
            },
            Fault::SelfJoined { link, .. } => Defect::WithItself(name(&link)),
            _ => Defect::NoDriver,
        };
        faults.into_iter().map(defect).collect()
    })
}
