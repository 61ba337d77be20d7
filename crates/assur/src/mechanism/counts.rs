//! The numbers of the structural formula W = 3n − 2P₁ − P₂.

use crate::gears::Mesh;
use crate::index::{LinkId, PointId};
use crate::linkage::check;
use crate::linkage::spec::{Defect, LinkageSpec};
use crate::mechanism::plan::body::Bodies;
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::{DoubledLink, Layout, Mechanism, Part};

/// Numbers from which the mobility is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Number of moving links, n. Links fixed to each other count as one link; a doubled link counts separately.
    pub links: usize,
    /// Number of hinges and slides, P₁. A hinge of k links counts as k − 1.
    pub lower_pairs: usize,
    /// Number of pairs of wheels in mesh, P₂.
    pub higher_pairs: usize,
    /// Mobility W by the formula. Each passive mesh makes W too low by one.
    pub mobility: isize,
    /// Number of passive meshes, which repeat the effect of other meshes.
    pub passive: usize,
}

impl Mechanism {
    /// Numbers of links and pairs, and the mobility by Chebyshev and Grübler. Wheels in mesh "as printed" have an idler
    /// between them; the idler counts as a link with its hinge and meshes.
    pub fn counts(&self) -> Counts {
        self.layout.counts()
    }

    /// One wheel for each passive mesh: the wheel that shares points with fewer links. In an epicyclic train this is
    /// the satellite, because its hinge joins fewer links than the hinge of sun and ring.
    pub fn passive_wheels(&self) -> impl Iterator<Item = LinkId> {
        let Layout { bodies, links, .. } = &*self.layout;
        let passive = bodies.gears.iter().filter(|gear| gear.is_passive);
        passive.filter_map(|gear| {
            let wheels = gear.by_link.links.into_iter().flatten();
            let sharing = |wheel: &LinkId| {
                let own = &links[*wheel].points;
                let shares = |link: &&Part| link.points.iter().any(|point| own.contains(point));
                links.iter().filter(shares).count()
            };
            // If both wheels share points with the same number of links, the second wheel is taken.
            wheels.rev().min_by_key(sharing)
        })
    }
}

impl LinkageSpec {
    /// Numbers of links and pairs, and the mobility, of a specification that need not be movable yet.
    ///
    /// # Errors
    /// Names that refer to nothing, and all other defects that prevent counting.
    pub fn counts(&self) -> Result<Counts, Vec<Defect>> {
        let defects = check::defects(self);
        if !defects.is_empty() {
            return Err(defects);
        }
        let one = |defect| vec![defect];
        let (resolved, rigid) = Resolved::new(self).map_err(one)?;
        let (bodies, _) = rigid.joined(&resolved).map_err(one)?;
        Ok(counts(&bodies, &resolved.doubled, resolved.places.ids()))
    }
}

impl Layout {
    pub(super) fn counts(&self) -> Counts {
        counts(
            &self.bodies,
            &self.doubled,
            self.points.ids().take(self.listed),
        )
    }
}

pub(super) fn counts(
    bodies: &Bodies,
    doubled: &[DoubledLink],
    points: impl Iterator<Item = PointId>,
) -> Counts {
    let graph = bodies.graph(points);
    let gears = bodies.gears.iter();
    let idlers = gears
        .clone()
        .filter(|gear| gear.by_link.mesh == Mesh::AsPrinted);
    let (idlers, passive) = (idlers.count(), gears.filter(|gear| gear.is_passive).count());
    // A doubled link has three freedoms and a hinge at each shared point.
    let hinges = doubled.iter().map(|one| one.shared.len()).sum::<usize>();
    let doubled = doubled.len();
    Counts {
        links: graph.links - 1 + idlers + doubled,
        lower_pairs: graph.lower_pairs() + idlers + hinges,
        higher_pairs: graph.higher_pairs() + passive + idlers,
        // An idler does not change the mobility: its hinge and the mesh that it adds remove its 3 freedoms, 2 + 1.
        mobility: graph.mobility() - passive as isize + 3 * doubled as isize - 2 * hinges as isize,
        passive,
    }
}
