//! Links, points, bodies and steps of a mechanism, by id and by name.

use super::*;

impl Mechanism {
    /// Specification of the linkage as drawn.
    pub fn spec(&self) -> &LinkageSpec {
        &self.spec
    }

    /// Names of the moving links, in the order of the specification.
    pub fn links(&self) -> impl ExactSizeIterator<Item = &str> {
        self.spec.links.iter().map(|link| link.name.as_str())
    }

    /// Names of the points in the order of the specification, then names of its traced points.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &str> {
        self.point_ids().map(|point| self.point_name(point))
    }

    /// The moving links in the order of the specification.
    pub fn link_ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = LinkId> + ExactSizeIterator + Clone + use<> {
        self.layout.links.ids()
    }

    /// The points in the order of the specification, then its traced points.
    pub fn point_ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = PointId> + ExactSizeIterator + Clone + use<> {
        self.layout.points.ids()
    }

    /// Moving link with a given name.
    pub fn link(&self, name: &str) -> Option<LinkId> {
        self.links().position(|link| link == name).map(LinkId::at)
    }

    /// Point with a given name.
    pub fn point(&self, name: &str) -> Option<PointId> {
        let found = self.points().position(|point| point == name);
        found.map(PointId::at)
    }

    /// The name of a link.
    pub fn link_name(&self, link: LinkId) -> &str {
        &self.spec.links[link.index()].name
    }

    /// The name of a point.
    pub fn point_name(&self, point: PointId) -> &str {
        match self.tracer(point) {
            Some(tracer) => &tracer.name,
            None => &self.spec.points[point.index()].name,
        }
    }

    /// The points of a link.
    pub fn points_of(&self, link: LinkId) -> &[PointId] {
        &self.layout.links[link].points
    }

    /// Link for which the body of a link is made: the link itself, the link to which it is fixed, or the link that it
    /// doubles. None if the link is one body with the frame.
    pub fn root_of(&self, link: LinkId) -> LinkOrFrame {
        self.link_of(self.layout.links[link].body)
    }

    /// Links that can be driven: cranks, links that slide along a line of the frame, and links driven at present.
    pub fn drivable(&self) -> Vec<&str> {
        self.spec.drivable()
    }

    /// Links that can be driven as cranks: hinged to the frame and not fixed to another link.
    pub fn cranks(&self) -> impl Iterator<Item = LinkId> + '_ {
        let links = &self.spec.links;
        self.link_ids()
            .filter(|link| self.spec.is_crank(&links[link.index()]))
    }

    /// Structure of the mechanism: drivers and Assur groups, then passive links. Links are given as indices of bodies.
    pub fn structure(&self) -> &Structure {
        let layout = &self.layout;
        let shown = layout.passive.as_ref();
        shown.map_or(&layout.structure, |passive| &passive.structure)
    }

    /// Bodies: the frame, then those of the links that are neither fixed to another link nor doubled.
    pub fn bodies(&self) -> impl ExactSizeIterator<Item = BodyId> + Clone + use<> {
        self.layout.bodies.ids()
    }

    /// Link for which a body is made; None for the frame.
    pub(crate) fn link_of(&self, body: BodyId) -> LinkOrFrame {
        self.layout.made_for[body]
    }

    /// Name of a body: the name of the link for which it is made.
    pub fn body_name(&self, body: BodyId) -> &str {
        self.spec.name_of(self.link_of(body))
    }

    /// Names of the bodies, in the order of the structure's links.
    pub fn body_names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.bodies().map(|body| self.body_name(body))
    }

    /// The doubled links, in the order of the specification.
    pub fn doubled(&self) -> &[DoubledLink] {
        &self.layout.doubled
    }

    /// Structural formula: [its terms](Self::terms) in sequence.
    pub fn formula(&self) -> String {
        self.terms().join(" → ")
    }

    /// Terms of the structural formula, with the names of links. The terms of the structure are followed by the terms
    /// of the doubled links.
    pub fn terms(&self) -> Vec<String> {
        let body_name = |link| self.body_name(BodyId::at(link));
        let doubled = self.doubled().iter();
        let doubled = doubled.map(|one| format!("{}({})", one.symbol(), self.link_name(one.link)));
        self.structure()
            .terms(body_name)
            .into_iter()
            .chain(doubled)
            .collect()
    }

    /// Names of the links that a step of the plan places.
    pub fn links_of(&self, step: StepId) -> impl Iterator<Item = &str> {
        let bodies = self.steps()[step].bodies().into_iter();
        bodies.map(|body| self.body_name(body))
    }

    /// The kind of singular pose that a step reaches at its dead point.
    pub fn singularity(&self, step: StepId) -> Singularity {
        self.steps()[step].singularity()
    }

    /// Length of the diagonal of the drawing.
    pub fn size(&self) -> f64 {
        self.layout.size
    }

    /// The drawn input.
    pub fn drawn_input(&self) -> f64 {
        self.drawn.input
    }

    /// True if the first driver is a crank, false if it is a slide.
    pub fn turns(&self) -> bool {
        self.layout.range.is_none()
    }
}

impl LinkageSpec {
    pub(crate) fn name_of(&self, link: LinkOrFrame) -> &str {
        link.map_or(FRAME, |link| &self.links[link.index()].name)
    }
}
