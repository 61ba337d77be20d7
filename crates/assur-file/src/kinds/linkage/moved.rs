//! The mechanism and the motion of a document.

use super::*;

impl LinkageDocument {
    /// Sets the origin of a document of the first version. In that version only the title identifies the origin.
    pub(crate) fn recognise(&mut self) {
        let title = self.title.as_deref();
        let known = |name: &&str| catalogue::title(name).as_deref() == title;
        if self.origin.is_none() && title.is_some() {
            self.origin = catalogue::gallery().find(known).map(str::to_owned);
        }
    }

    /// Checks the fields of the document, but not whether its linkage can move.
    ///
    /// # Errors
    /// All problems, each naming the field.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let problems = check::problems(self);
        if problems.is_empty() {
            return Ok(());
        }
        Err(problems.into_iter().map(Problem::from).collect())
    }

    /// The mechanism that the document describes, in the assembly that it gives by number or else in the drawn one.
    ///
    /// # Errors
    /// All problems of single fields or, if there are none, of the mechanism. Each names the field, or the
    /// links and points, at fault. An assembly that does not exist.
    pub fn mechanism(&self) -> Result<Mechanism, Vec<Problem>> {
        self.check()?;
        let drawn = Mechanism::new(&self.spec()).map_err(Problem::all)?;
        let Some(number) = self.assembly else {
            return Ok(drawn);
        };
        let all = drawn.signed_assemblies();
        if number == all.drawn() + 1 {
            return Ok(drawn);
        }
        let other = number.checked_sub(1).and_then(|k| all.assembly(k));
        other.ok_or_else(|| {
            vec![Problem::OutOfRange {
                field: "assembly".into(),
                value: number as f64,
                min: 1.0,
                max: all.count() as f64,
            }]
        })
    }

    /// True if `motion` equals the result of [`Self::motion`]: its mechanism has the specification of this document.
    pub fn is_moved_by(&self, motion: &Motion) -> bool {
        let is_drawn = self.assembly.is_none();
        is_drawn && self.check().is_ok() && self.spec() == *motion.mechanism().spec()
    }

    /// The document with its kind: a linkage if it moves, otherwise a draft.
    pub fn as_it_moves(self) -> Document {
        if self.mechanism().is_ok() {
            Document::Linkage(self)
        } else {
            Document::Draft(DraftDocument(self))
        }
    }

    /// The mechanism determined by dimensions alone, drawn in one of its assemblies at an input; see
    /// [`Mechanism::assembled`]. None if the links cannot be joined at this input.
    ///
    /// # Errors
    /// Those of [`Self::mechanism`], except defects of the drawing.
    pub fn assembled(&self, input: Option<f64>) -> Result<Option<Mechanism>, Vec<Problem>> {
        self.check()?;
        Mechanism::assembled(&self.spec(), input).map_err(Problem::all)
    }

    /// The document with the points, links, drivers and traced points of a specification, usually the linkage in
    /// another pose. The result names no assembly.
    pub fn redrawn(&self, draft: &LinkageSpec) -> Self {
        let drawn = Self::new(draft);
        Self {
            points: drawn.points,
            links: drawn.links,
            drivers: drawn.drivers,
            tracers: drawn.tracers,
            assembly: None,
            ..self.clone()
        }
    }

    /// The motion of the mechanism.
    ///
    /// # Errors
    /// Those of [`Self::mechanism`].
    pub fn motion(&self) -> Result<Motion, Vec<Problem>> {
        self.mechanism().map(Motion::new)
    }

    /// The link by whose angle assemblies are numbered: the link of the first plotted quantity if that is
    /// an angle, otherwise the link solved last. None for a mechanism without links.
    pub fn output(&self, mechanism: &Mechanism) -> Option<LinkId> {
        let first = self.plots.first();
        match first.and_then(|name| Quantity::named(mechanism, name)) {
            Some(Quantity::Angle(link)) => Some(link),
            _ => mechanism.output(),
        }
    }

    /// The outputs, whose swing and time ratio are listed: the quantities that the document plots or, if
    /// there are none, the usual outputs of textbooks.
    pub fn outputs(&self, mechanism: &Mechanism) -> Vec<Quantity> {
        let named = self.plots.iter();
        let named = named.filter_map(|name| Quantity::named(mechanism, name));
        let named: Vec<Quantity> = named.collect();
        if named.is_empty() {
            self.usual_outputs(mechanism)
        } else {
            named
        }
    }

    /// The usual outputs of textbooks: coordinates of sliders on guides of the frame, then angles of links hinged to
    /// the frame; if there are none, the angles of all links. Driven links, and angles of links fixed to others, are
    /// excluded.
    fn usual_outputs(&self, mechanism: &Mechanism) -> Vec<Quantity> {
        let draft = self.spec();
        let driven: Vec<&str> = (draft.drivers.iter())
            .filter_map(|driver| draft.driven(driver))
            .collect();
        let free = |link: &str| !driven.contains(&link);
        let guided = self.slides.iter().filter(|slide| slide.on == FRAME);
        let guided: Vec<&SlideDocument> = guided.filter(|slide| free(&slide.link)).collect();
        let at = |name: &String| self.points.iter().find(|point| point.name == *name);
        let places = guided.iter().filter_map(|slide| {
            let [from, to] = [at(&slide.line[0])?.at, at(&slide.line[1])?.at];
            let point = mechanism.point(&slide.point)?;
            let level = (to[0] - from[0]).abs() >= (to[1] - from[1]).abs();
            Some(if level {
                Quantity::X(point)
            } else {
                Quantity::Y(point)
            })
        });
        let hinged = self.links.iter().filter(|link| {
            let slides = guided.iter().any(|slide| slide.link == link.name);
            let on_frame = link.points.iter().any(|point| self.frame.contains(point));
            free(&link.name) && on_frame && !slides && link.fixed_to.is_none()
        });
        let angle = |link: &LinkDocument| mechanism.link(&link.name).map(Quantity::Angle);
        let outputs: Vec<Quantity> = places.chain(hinged.filter_map(angle)).collect();
        if !outputs.is_empty() {
            return outputs;
        }
        let others = self.links.iter();
        let others = others.filter(|link| free(&link.name) && link.fixed_to.is_none());
        others.filter_map(angle).collect()
    }

    /// The quantities that the name `choice` selects for the plots. The name of a point selects both its coordinates.
    /// The name of a quantity, such as `LINK.angle`, selects this quantity. `angles` selects the outputs of the same
    /// kind, angle or length, as the first output, or all angles if there are no outputs. The name of a force, such as
    /// `B.reaction`, selects no quantity of the motion. None for an unknown name.
    pub fn plotted(&self, mechanism: &Mechanism, choice: &str) -> Option<Vec<Quantity>> {
        if choice == "angles" {
            let mut asked = self.outputs(mechanism);
            match asked.first().map(|one| one.is_angle()) {
                Some(kind) => asked.retain(|one| one.is_angle() == kind),
                None => asked = mechanism.link_ids().map(Quantity::Angle).collect(),
            }
            return Some(asked);
        }
        if let Some(point) = mechanism.point(choice) {
            return Some(vec![Quantity::X(point), Quantity::Y(point)]);
        }
        if is_of_forces(choice) {
            return Some(Vec::new());
        }
        Quantity::named(mechanism, choice).map(|one| vec![one])
    }
}

/// Whether a name may be that of a plotted force: of a part of a reaction or of the shaking force, or of the torque or
/// force of a driver.
pub fn is_of_forces(name: &str) -> bool {
    const FORCES: [&str; 10] = [
        "reaction",
        "reaction_x",
        "reaction_y",
        "reaction_moment",
        "shaking",
        "shaking_x",
        "shaking_y",
        "shaking_moment",
        "torque",
        "force",
    ];
    let what = name.rsplit_once('.').map(|(_, what)| what);
    what.is_some_and(|what| FORCES.contains(&what))
}
