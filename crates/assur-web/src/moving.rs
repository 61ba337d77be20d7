//! A moving linkage with its drawing, read-outs and plots.

use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;

use assur::Point;
use assur::mechanism::{Following, LinkId, Mechanism, PointId, Pose, Quantity, Unsolved};
use assur::motion::{InputRate, Motion};
use assur_draw::chart::{Against, Chart, Settings};
use assur_draw::{Annotations, Figure, Lines, Overlays, PolygonSheet, Role, View as Drawing};
use assur_file::{Axes, LinkDocument, LinkageDocument, Moved, Problem, View, is_of_forces};

use crate::column::Column;
use crate::driven::Driven;
use crate::equations::sides;
use crate::force_quantity::ForceQuantity;
use crate::forces::Forces;
use crate::handle::{Handle, HandlePlace};
use crate::measures::measures;
use crate::pair::Pair;

mod arrows;
mod plotted;
mod reading;

/// Turns the reason why an input has no pose, or no derivatives, into a problem.
pub(crate) type Explain = Box<dyn Fn(&Mechanism, &Unsolved) -> Problem>;

/// A linkage in motion with its drawing.
pub(crate) struct Moving {
    document: LinkageDocument,
    motion: Motion,
    /// All assemblies, followed from input to input. An edit makes a new `Moving`, so this is only made on first use.
    following: OnceCell<RefCell<Following>>,
    /// Transmission and pressure angles of dyads, which are read out without derivatives.
    transmitting: Vec<Quantity>,
    /// Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂.
    numbers: BTreeMap<String, String>,
    quantities: Vec<Quantity>,
    /// Quantities that are listed whatever is plotted.
    listed: Vec<Quantity>,
    measures: Vec<Quantity>,
    plotted: Vec<Quantity>,
    /// Forces that are plotted in place of quantities of the motion; empty if there are none.
    plotted_forces: Vec<ForceQuantity>,
    /// Colour roles of the curves.
    plotted_roles: Vec<Role>,
    /// Two quantities plotted against each other, in place of the plots over the input.
    pair: Option<Pair<Column>>,
    driven: Option<Driven>,
    /// Handles that can be dragged.
    handles: Vec<Handle>,
    /// Whether points of the links can be traced.
    traceable: bool,
    /// Whether the other assemblies are drawn beside the linkage.
    others: bool,
    /// Whether arrows of forces are drawn.
    arrows: bool,
    /// Whether circles of curvature are drawn; they need a further derivative.
    curvature: bool,
    figure: Figure,
    settings: Settings,
    /// The plots, computed when first drawn: during a drag, not every linkage is plotted.
    chart: OnceCell<Chart>,
    /// The plot of one quantity against another, computed when first drawn.
    against: OnceCell<Against>,
    /// Sheets of the velocity and acceleration polygons, computed when first drawn.
    polygon_sheets: OnceCell<[PolygonSheet; 2]>,
    /// The linkage under load. If nothing acts on the linkage, this is made when forces are first requested.
    forces: OnceCell<Forces>,
    /// Speed and acceleration of the input for forces: ω₁ and ε₁ of the view, whatever the axes.
    rates: [f64; 2],
    explain: Explain,
}

impl Moving {
    /// Makes a linkage in motion with its drawing, from the view of a state, annotations and the
    /// quantities to be read out. `explain` gives the reason if there is no pose.
    ///
    /// # Errors
    /// An unknown name in the view; the reason why there is no pose to draw.
    pub(crate) fn new(
        view: &View,
        moved: Moved,
        annotations: Annotations,
        quantities: Vec<Quantity>,
        explain: Explain,
    ) -> Result<Self, Vec<Problem>> {
        let Moved {
            document,
            motion,
            plotted,
        } = moved;
        let mechanism = motion.mechanism();
        for (field, link) in [("about", &view.about), ("relative_to", &view.relative_to)] {
            if !link.is_empty() && mechanism.link(link).is_none() {
                let field = field.into();
                return Err(vec![Problem::UnknownChoice { field }]);
            }
        }
        let rates = [view.omega, view.epsilon];
        let forces = OnceCell::new();
        if document.is_loaded() {
            let loaded = Forces::new(&document, mechanism, rates)?;
            forces.get_or_init(|| loaded);
        }
        let of_masses = || Forces::of_masses(&document, mechanism, rates);
        let made = || forces.get_or_init(of_masses);
        let pair = Pair::of(view, |name| Column::named(mechanism, made, name))?;
        let plotted_forces = if plotted.is_empty() && is_of_forces(&view.plot) {
            let field = "plot".into();
            ForceQuantity::plotted(made(), &view.plot)
                .ok_or_else(|| vec![Problem::UnknownChoice { field }])?
        } else {
            Vec::new()
        };
        let measures = measures(view, mechanism)?;
        let point = |name: &String| mechanism.point(name);
        // The path of a point whose x is plotted is also drawn.
        let of_pair = pair
            .iter()
            .flat_map(|pair| pair.quantities(|one| Some(one.kinematic()?.quantity)));
        let of_plot = plotted.iter().copied().chain(of_pair);
        let of_plot = of_plot.filter_map(|one| match one {
            Quantity::X(point) => Some(point),
            _ => None,
        });
        let numbers = annotations.numbers.iter().cloned().collect();
        let force_names = if view.forces {
            Self::names_of_forces(made(), &numbers)
        } else {
            Vec::new()
        };
        let drawing = Drawing {
            overlays: overlays(view),
            lines: lines(view, mechanism),
            measures: measures.clone(),
            traced: document
                .traces
                .iter()
                .filter_map(point)
                .chain(of_plot)
                .collect(),
            annotations,
            forces: force_names,
            symbol: view.symbol,
        };
        let figure = Figure::new(&motion, &drawing);
        let figure = figure.map_err(|unsolved| vec![explain(mechanism, &unsolved)])?;
        Ok(Self {
            transmitting: mechanism.transmitting(),
            numbers,
            quantities: [quantities, measures.clone()].concat(),
            listed: measures.clone(),
            measures,
            driven: Driven::of(&document, mechanism),
            handles: Handle::of_points(mechanism, &figure),
            traceable: true,
            others: view.others,
            arrows: view.forces,
            curvature: view.curvature,
            settings: settings(view),
            chart: OnceCell::new(),
            against: OnceCell::new(),
            polygon_sheets: OnceCell::new(),
            forces,
            rates,
            plotted_roles: figure.plotted_roles(&plotted),
            pair,
            plotted,
            plotted_forces,
            figure,
            motion,
            following: OnceCell::new(),
            document,
            explain,
        })
    }

    /// Lists all transmission and pressure angles and the angles of these links, whatever is plotted.
    pub(crate) fn listing(mut self, links: impl Iterator<Item = LinkId>) -> Self {
        let transmitting = self.transmitting.iter().copied();
        let measures = self.measures.iter().copied();
        let angles = links.map(Quantity::Angle);
        self.listed = angles.chain(transmitting).chain(measures).collect();
        self
    }

    /// Replaces all handles of points, except the driver's, by these. Points can then no longer be traced.
    pub(crate) fn held_by(mut self, handles: impl Iterator<Item = Handle>) -> Self {
        let driven = (self.driven).map(|driven| HandlePlace::Point(driven.end()));
        self.handles.retain(|handle| Some(handle.at) == driven);
        self.handles.extend(handles);
        self.traceable = false;
        self
    }

    pub(crate) fn document(&self) -> &LinkageDocument {
        &self.document
    }

    pub(crate) fn following(&self) -> &RefCell<Following> {
        let following = || RefCell::new(self.mechanism().following());
        self.following.get_or_init(following)
    }

    pub(crate) fn motion(&self) -> &Motion {
        &self.motion
    }

    pub(crate) fn mechanism(&self) -> &Mechanism {
        self.motion.mechanism()
    }

    pub(crate) fn figure(&self) -> &Figure {
        &self.figure
    }

    pub(crate) fn polygon_sheets(&self) -> &OnceCell<[PolygonSheet; 2]> {
        &self.polygon_sheets
    }

    /// Returns the loading of the linkage with the order in which its reactions are found.
    pub(crate) fn forces(&self) -> &Forces {
        let of_masses = || Forces::of_masses(&self.document, self.mechanism(), self.rates);
        self.forces.get_or_init(of_masses)
    }

    /// Speed and acceleration of the input for plots, polygons and read-outs: those of the view if its axes are
    /// physical, unit speed if they show analogues.
    pub(crate) fn input(&self) -> InputRate {
        self.settings.input
    }

    pub(crate) fn link_numbers(&self) -> &BTreeMap<String, String> {
        &self.numbers
    }

    pub(crate) fn traceable(&self) -> bool {
        self.traceable
    }

    /// The subscript in the symbol of the input.
    pub(crate) fn input_number(&self) -> &str {
        let driver = self.document.drivers.first();
        let link = driver.and_then(|driver| driver.crank.as_ref());
        let number = link.and_then(|link| self.numbers.get(link));
        number.map_or("1", String::as_str)
    }

    pub(crate) fn plotted(&self) -> &[Quantity] {
        &self.plotted
    }

    /// The colour role of a quantity's curve, if the quantity is plotted.
    pub(crate) fn plotted_role(&self, quantity: Quantity) -> Option<&'static str> {
        let mut plotted = self.plotted.iter().zip(&self.plotted_roles);
        let found = plotted.find(|(plotted, _)| **plotted == quantity);
        found.map(|(_, role)| role.name())
    }

    pub(crate) fn measures(&self) -> &[Quantity] {
        &self.measures
    }

    /// The first plotted quantity, if it is an output; transmission angles, pressure angles and corners are not
    /// outputs.
    pub(crate) fn plotted_output(&self) -> Option<Quantity> {
        self.plotted.first().copied().filter(|one| !one.is_folded())
    }

    /// The outputs of the document, whatever is plotted; if it has none, the first plotted output.
    pub(crate) fn outputs(&self) -> Vec<Quantity> {
        let named = self.document.outputs(self.mechanism());
        if named.is_empty() {
            self.plotted_output().into_iter().collect()
        } else {
            named
        }
    }

    /// The quantities of the plotted curves.
    pub(crate) fn curves(&self) -> Vec<Quantity> {
        match &self.pair {
            Some(pair) => pair.quantities(|one| Some(one.kinematic()?.quantity)),
            None => self.plotted.clone(),
        }
    }

    /// The quantities listed beside the drawing: first those always listed, then the plotted ones.
    pub(crate) fn listed(&self) -> Vec<Quantity> {
        let mut listed = self.listed.clone();
        for one in self.curves() {
            if !listed.contains(&one) {
                listed.push(one);
            }
        }
        listed
    }

    pub(crate) fn handles(&self) -> &[Handle] {
        &self.handles
    }

    /// The document redrawn in the pose at an input. At the drawn input it is unchanged, unless the length or the shape
    /// of a link is given.
    pub(crate) fn drawn(&self, input: f64) -> Result<LinkageDocument, Problem> {
        let own = |link: &LinkDocument| link.length.is_some() || link.shape.is_some();
        let document = &self.document;
        if input == self.motion.drawn_input() && !document.links.iter().any(own) {
            return Ok(document.clone());
        }
        let pose = self.pose(input)?;
        Ok(document.redrawn(&self.mechanism().drawn_in(&pose)))
    }

    /// The pose at an input.
    ///
    /// # Errors
    /// The reason why there is no pose.
    pub(crate) fn pose(&self, input: f64) -> Result<Pose<1>, Problem> {
        let pose = self.motion.pose(input);
        pose.map_err(|unsolved| self.problem(&unsolved))
    }

    /// Turns the reason why an input has no pose, or no derivatives, into a problem of the document.
    pub(crate) fn problem(&self, unsolved: &Unsolved) -> Problem {
        (self.explain)(self.mechanism(), unsolved)
    }

    /// The input after a point is dragged towards a target position; none if the point is not the driver's handle.
    pub(crate) fn driven_to(
        &self,
        point: PointId,
        input: f64,
        to: Point,
    ) -> Option<Result<f64, Problem>> {
        let driven = self.driven.filter(|driven| driven.end() == point)?;
        let pose = self.pose(input);
        Some(pose.map(|pose| driven.dragged(&self.motion, &pose, input, to)))
    }

    /// Left side, right side and residual of every constraint equation or, for order 1 or 2, of its derivative.
    ///
    /// # Errors
    /// The reason why there is no pose, or why derivatives are unbounded.
    pub(crate) fn equations(&self, input: f64, order: usize) -> Result<Vec<f64>, Problem> {
        // Order 0 needs no derivatives, so it is also possible at a dead point.
        if order == 0 {
            return Ok(sides(self.mechanism(), &self.pose(input)?, 0));
        }
        let pose = self.motion.pose::<3>(input);
        let pose = pose.map_err(|unsolved| self.problem(&unsolved))?;
        Ok(sides(self.mechanism(), &pose, order.min(2)))
    }
}

fn overlays(view: &View) -> Overlays {
    Overlays {
        traces: view.traces,
        centres: view.centres,
        vectors: view.vectors,
        loop_vectors: view.loop_vectors,
        transmission: view.transmission,
        groups: view.groups,
        numbers: view.numbers,
    }
}

fn lines(view: &View, mechanism: &Mechanism) -> Lines {
    Lines {
        centres: view.instant_centres,
        centrodes: view.centrodes,
        curvature: view.curvature,
        link: mechanism.link(&view.about),
        against: mechanism.link(&view.relative_to),
    }
}

fn settings(view: &View) -> Settings {
    Settings {
        input: view.input(),
        physical: view.axes == Axes::Physical,
        differenced: view.differenced,
    }
}
