//! Assembly of a linkage from its dimensions alone, whatever its drawing shows.

use crate::Vector;
use crate::linkage::spec::{Defect, LinkSpec, LinkageSpec, extent};
use crate::mechanism::plan::resolved::Resolved;
use crate::mechanism::plan::structured;
use crate::mechanism::{Layout, Mechanism, check};
use crate::tolerance::COINCIDENT;

impl Mechanism {
    /// Makes the mechanism of a specification, redrawn in one of its assemblies at an input: an angle in radians or the
    /// coordinate of a driven slide; None means the drawn input. From the drawing it takes only the dimensions that the
    /// specification lacks and the coordinates of further drivers. Returns None if the links cannot be joined at the
    /// input.
    ///
    /// # Errors
    /// Defects of the specification, apart from those of its drawing.
    pub fn assembled(spec: &LinkageSpec, input: Option<f64>) -> Result<Option<Self>, Vec<Defect>> {
        let spec = spec.spread();
        let defects = check::defects(&spec);
        if !defects.is_empty() {
            return Err(defects);
        }
        let (resolved, rigid) = Resolved::new(&spec).map_err(|defect| vec![defect])?;
        let (bodies, placements) = rigid.joined(&resolved).map_err(|defect| vec![defect])?;
        let (structure, redundancy) = structured::structured(&resolved, &bodies)?;
        if let Some(redundancy) = redundancy {
            return Err(redundancy.defects);
        }
        let (layout, drawn) = Layout::new(&resolved, bodies, &placements, structure, &[], None)?;
        let found = layout.found_at::<1>(&drawn, input.unwrap_or(drawn.input));
        let mut poses = found.ways.iter();
        Ok(poses.find_map(|(pose, _)| {
            let mut drawn = spec.clone();
            layout.draw(&mut drawn, &pose.state);
            Self::new(&drawn).ok()
        }))
    }
}

impl LinkageSpec {
    /// Specification with coincident points of a link drawn apart. Points whose drawn positions give dimensions stay.
    fn spread(&self) -> Self {
        let shapes = self.links.iter().filter_map(|link| link.shape.as_ref());
        let lengths = shapes.map(|shape| extent(shape.iter().map(|at| at.coords)));
        let size = lengths.fold(self.size(), f64::max);
        let mut spread = self.clone();
        for (index, point) in self.points.iter().enumerate() {
            let has = |link: &&LinkSpec| link.points.contains(&point.name);
            let guides = self.slides.iter().flat_map(|slide| {
                let own = [&slide.point];
                own.into_iter().chain(&slide.line)
            });
            let is_free = self.links.iter().filter(has).all(|link| {
                let own = link.shape.is_some() && link.fixed_to.is_none();
                own && !self.is_base(&link.name)
            });
            let counts = self.frame.contains(&point.name) || !is_free;
            if counts || guides.into_iter().any(|name| *name == point.name) {
                continue;
            }
            let mut neighbours = self.links.iter().filter(has).flat_map(|link| &link.points);
            let near = |name: &String| {
                let other = self.place(name).filter(|_| *name != point.name);
                other.is_some_and(|other| (other - point.at).norm() <= COINCIDENT * size)
            };
            if neighbours.any(near) {
                let (y, x) = (index as f64).sin_cos();
                spread.points[index].at = point.at + Vector::new(x, y) * size;
            }
        }
        spread
    }

    /// True if another link is fixed to this link.
    pub(super) fn is_base(&self, link: &str) -> bool {
        let mut fixed = self
            .links
            .iter()
            .filter_map(|other| other.fixed_to.as_ref());
        fixed.any(|base| base == link)
    }
}
