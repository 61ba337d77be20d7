//! The structure of the bodies of a specification, and the defects of this structure with the names of links.

use crate::index::{BodyId, Id};
use crate::linkage::spec::Defect;
use crate::mechanism::counts::counts;
use crate::mechanism::plan::body::{Bodies, Gear};
use crate::mechanism::plan::resolved::Resolved;
use crate::numeric::graph::Partition;
use crate::structure::{self, Fault, Graph, Pair, Structure, decompose, decompose_redundant};

/// Data of a structure with surplus constraints. The geometry decides whether these constraints are redundant.
pub(in crate::mechanism) struct Redundancy {
    pub(in crate::mechanism) graph: Graph,
    pub(in crate::mechanism) drivers: Vec<structure::Driver>,
    /// Defects that apply if the constraints are not redundant.
    pub(in crate::mechanism) defects: Vec<Defect>,
}

/// Drivers and Assur groups of the bodies, and the data of surplus constraints if there are any.
///
/// # Errors
/// The defects found by counting pairs.
pub(in crate::mechanism) fn structured(
    spec: &Resolved<'_>,
    bodies: &Bodies,
) -> Result<(Structure, Option<Redundancy>), Vec<Defect>> {
    let graph = bodies.graph(spec.places.ids());
    let drivers = spec.drivers.iter();
    let drivers = drivers.map(|driver| bodies.driver(spec, driver, &graph));
    let drivers: Result<Vec<_>, Defect> = drivers.collect();
    let drivers = drivers.map_err(|defect| vec![defect])?;
    let name = |link: &usize| spec.body_name(BodyId::at(*link)).to_owned();
    let named = |links: Vec<usize>| links.iter().map(name).collect();
    let faults = match decompose(&graph, &drivers) {
        Ok(structure) => return Ok((structure, None)),
        Err(faults) => faults,
    };
    let redundant = decompose_redundant(&graph, &drivers);
    let defects = || {
        // Passive meshes remove no freedom.
        let counts = counts(bodies, &spec.doubled, spec.places.ids());
        let mobility = counts.mobility + counts.passive as isize;
        if let Some(gear) = contradicting(bodies, &graph, &drivers) {
            let links = gear
                .by_link
                .links
                .map(|link| spec.link_name(link).to_owned());
            return vec![Defect::MeshContradicts { links }];
        }
        let defect = |fault: Fault| match fault {
            Fault::Apart { links } => Defect::Loose {
                links: named(links),
            },
            Fault::Undriven { links, .. } => Defect::Underdriven {
                mobility,
                links: named(links),
            },
            Fault::Overconstrained { links, .. }
            | Fault::Sliding { links }
            | Fault::Rigid { links } => Defect::Locked {
                mobility,
                links: named(links),
            },
            Fault::DrivenTwice { driver, .. } => Defect::Locked {
                mobility,
                links: named(drivers[driver].links.to_vec()),
            },
            Fault::SelfJoined { link, .. } => Defect::WithItself { link: name(&link) },
            _ => Defect::NoDriver,
        };
        // Without a driver every link is undriven; only the missing driver is reported.
        let told = |fault: &Fault| !drivers.is_empty() || !matches!(fault, Fault::Undriven { .. });
        faults.into_iter().filter(told).map(defect).collect()
    };
    let Ok(structure) = redundant else {
        return Err(defects());
    };
    let defects = defects();
    let redundancy = Redundancy {
        graph,
        drivers,
        defects,
    };
    Ok((structure, Some(redundancy)))
}

/// The last active gear coupling that closes a ring of wheels, and without which the structure has no fault.
fn contradicting<'a>(
    bodies: &'a Bodies,
    graph: &Graph,
    drivers: &[structure::Driver],
) -> Option<&'a Gear> {
    bodies.active_gears().rev().find(|gear| {
        let joined = Pair::Gear(gear.bodies.map(BodyId::index));
        let mut without = graph.clone();
        let mesh = without.pairs.iter().rposition(|pair| *pair == joined);
        mesh.map(|mesh| without.pairs.remove(mesh));
        closes_ring(graph.links, bodies, gear) && decompose(&without, drivers).is_ok()
    })
}

/// True if the two wheels of a gear coupling are also joined through other couplings.
fn closes_ring(count: usize, bodies: &Bodies, closing: &Gear) -> bool {
    let mut parts = Partition::new(count);
    let gears = bodies.active_gears();
    for gear in gears.filter(|gear| !std::ptr::eq(*gear, closing)) {
        parts.join(gear.bodies.map(BodyId::index));
    }
    let [a, b] = closing.bodies.map(BodyId::index);
    parts.joins(a, b)
}
