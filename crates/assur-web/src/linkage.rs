//! Any linkage on the page.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use assur::mechanism::{Mechanism, PointId, Pose, Quantity, Unsolved};
use assur::motion::{Column, Motion};
use assur::structure::{Step, roman};
use assur::{Cycle, Jet, Point};
use assur_draw::chart::Chart;
use assur_draw::{Figure, List};
use assur_file::{LinkageDocument, LinkageProblem, Problem, State, from_catalogue};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::convert::{Change, Redrawn, to_js};
use crate::equations::{EquationSummary, sides};
use crate::profile::ProfileSummary;
use crate::shown::{Shown, rates, settings, strokes, unknown};
use crate::summary::CycleSummary;
use crate::table::{SweepRow, SweepTable};

/// A linkage with all that is drawn of it.
pub(crate) struct Linkage {
    motion: Motion,
    quantities: Vec<Quantity>,
    plotted: Vec<Quantity>,
    crank: Option<Handle>,
    /// The points that can be dragged.
    handles: Vec<PointId>,
    assembly: usize,
    /// The width of the band of a dwell, degrees or in the unit of the lengths.
    band: Option<f64>,
    figure: Figure,
    chart: Chart,
}

/// The end of the crank, by which it is driven.
struct Handle {
    pivot: PointId,
    end: PointId,
}

#[derive(Serialize)]
struct LinkageSummary<'a> {
    cycle: CycleSummary,
    home: f64,
    bounds: [f64; 4],
    counts: Counts,
    mobility: usize,
    class: String,
    order: usize,
    formula: String,
    groups: Vec<GroupSummary>,
    equations: Vec<EquationSummary<'a>>,
    assembly: usize,
    assemblies: usize,
    dead_points: Vec<DeadPointSummary<'a>>,
    change_points: &'a [f64],
    roles: BTreeMap<&'a str, &'static str>,
    points: Vec<&'a str>,
    plotted: Vec<String>,
    handles: Vec<HandleSummary<'a>>,
    course: Option<ProfileSummary>,
}

/// Moving links; hinges and slides, a hinge of k links counting k − 1 times.
#[derive(Serialize)]
struct Counts {
    links: usize,
    pairs: usize,
}

/// A term of the structural formula, and the colour its links have by it.
#[derive(Serialize)]
struct GroupSummary {
    term: String,
    role: &'static str,
}

#[derive(Serialize)]
struct DeadPointSummary<'a> {
    phi: f64,
    kind: &'static str,
    links: Vec<&'a str>,
}

#[derive(Serialize)]
struct HandleSummary<'a> {
    name: &'a str,
    role: &'static str,
}

impl Linkage {
    pub(crate) fn new(state: &State, document: &LinkageDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let motion = document.motion()?;
        let mechanism = motion.mechanism();
        // The page's input is an angle, in all that it writes.
        if !mechanism.turns() {
            return Err(vec![Problem::UnknownChoice {
                field: "drivers".into(),
            }]);
        }
        let Some(plotted) = document.plotted(mechanism, &state.view.plot) else {
            return Err(vec![Problem::UnknownChoice {
                field: "plot".into(),
            }]);
        };
        let point = |name: &String| mechanism.point(name);
        // The path of a point that is plotted is one of those to be seen.
        let of_plot = plotted.iter().filter_map(|one| match one {
            Quantity::X(point) => Some(*point),
            _ => None,
        });
        let mut traces: Vec<PointId> = document.traces.iter().filter_map(point).collect();
        traces.extend(of_plot);
        traces.retain(|_| state.view.traces);
        let figure = if state.view.groups {
            Figure::in_groups(&motion, &traces)
        } else {
            Figure::new(&motion, &traces)
        };
        let mut figure = figure.map_err(|unsolved| vec![problem(&unsolved, mechanism)])?;
        if state.view.vectors {
            figure = figure.with_vectors();
        }
        let points = mechanism.point_ids();
        Ok(Self {
            quantities: Quantity::all(mechanism),
            crank: Handle::of(document, mechanism),
            handles: points.filter(|point| figure.is_drawn(*point)).collect(),
            assembly: document.assembly.unwrap_or(mechanism.drawn_assembly() + 1),
            chart: figure.chart(&plotted, settings(&state.view)),
            band: document.band,
            plotted,
            figure,
            motion,
        })
    }

    fn mechanism(&self) -> &Mechanism {
        self.motion.mechanism()
    }

    fn pose<const N: usize>(&self, phi: f64) -> Result<Pose<N>, Problem> {
        let pose = self.motion.pose(phi);
        pose.map_err(|unsolved| problem(&unsolved, self.mechanism()))
    }

    /// Quantities at a crank angle, each with its derivatives of the axes.
    fn rates(&self, quantities: &[Quantity], phi: f64) -> Result<Vec<f64>, Problem> {
        let pose = self.pose::<3>(phi)?;
        let jets = quantities.iter().map(|one| one.of(self.mechanism(), &pose));
        let jets: Vec<Jet<3>> = jets.collect();
        Ok(rates(&jets, self.chart.settings().input))
    }

    /// The role that a link with the point is drawn in; of the frame's points none is.
    fn role(&self, point: PointId) -> &'static str {
        let mut links = self.mechanism().link_ids();
        let link = links.find(|link| self.mechanism().points_of(*link).contains(&point));
        link.map_or("ink", |link| self.figure.drawn_role(link).name())
    }

    fn place(&self, pose: &Pose<1>, point: PointId) -> Point {
        self.mechanism().place(pose, point).place()
    }
}

impl Handle {
    fn of(document: &LinkageDocument, mechanism: &Mechanism) -> Option<Self> {
        let [driver] = &document.drivers[..] else {
            return None;
        };
        let name = driver.crank.as_ref().filter(|_| driver.base.is_none())?;
        let link = mechanism.link(name)?;
        let is_fixed = |point: &str| document.frame.iter().any(|name| name == point);
        let named = |point: PointId| is_fixed(mechanism.point_name(point));
        let (fixed, moving): (Vec<PointId>, Vec<PointId>) = mechanism
            .points_of(link)
            .iter()
            .partition(|point| named(**point));
        Some(Self {
            pivot: *fixed.first()?,
            end: *moving.first()?,
        })
    }
}

impl Shown for Linkage {
    fn summary(&self) -> JsValue {
        let (motion, mechanism) = (&self.motion, self.mechanism());
        let structure = mechanism.structure();
        let highest = structure.groups().max_by_key(|group| group.class);
        let drivers = structure.steps.iter();
        let ends = motion.dead_points().iter().map(|end| DeadPointSummary {
            phi: end.input,
            kind: end.kind.code(),
            links: motion.links_at(end).collect(),
        });
        let plotted = self.plotted.iter().map(|one| one.name(mechanism, 0));
        let roles = mechanism.link_ids();
        let roles = roles.map(|link| (mechanism.link_name(link), self.figure.role(link).name()));
        let terms = mechanism.terms().into_iter();
        let groups = terms.zip(self.figure.step_roles());
        let groups = groups.map(|(term, role)| GroupSummary {
            term,
            role: role.name(),
        });
        let equations = mechanism.constraints().iter();
        let equations = equations.map(|one| EquationSummary::new(mechanism, one));
        let handles = self.handles.iter().map(|point| HandleSummary {
            name: mechanism.point_name(*point),
            role: self.role(*point),
        });
        let cycle = motion.cycle();
        let links = structure.step_of.iter().flatten().count();
        // Of a mechanism there are as many drivers as freedoms.
        let mobility = drivers
            .filter(|step| matches!(step, Step::Driver { .. }))
            .count();
        to_js(&LinkageSummary {
            cycle: CycleSummary::new(cycle),
            home: motion.home(),
            bounds: self.figure.bounds(),
            counts: Counts {
                links,
                // By Chebyshev's formula, which a mechanism fulfils.
                pairs: (3 * links - mobility - mechanism.draft().gears.len()) / 2,
            },
            mobility,
            class: roman(structure.class()),
            order: highest.map_or(1, |group| group.order()),
            formula: mechanism.formula(),
            groups: groups.collect(),
            equations: equations.collect(),
            assembly: self.assembly,
            assemblies: mechanism.assemblies(),
            dead_points: ends.collect(),
            change_points: motion.change_points(),
            roles: roles.collect(),
            points: mechanism.points().collect(),
            plotted: plotted.collect(),
            handles: handles.collect(),
            course: self
                .plotted
                .first()
                .map(|output| ProfileSummary::new(motion, *output, self.band)),
        })
    }

    fn labels(&self) -> Vec<String> {
        self.figure.names().to_vec()
    }

    fn scene(&self) -> &List {
        self.figure.rigid()
    }

    fn frame(&self, phi: f64) -> Result<Vec<f32>, Problem> {
        let frame = self.figure.frame(phi);
        frame.map_err(|unsolved| problem(&unsolved, self.mechanism()))
    }

    fn readout_names(&self) -> Vec<String> {
        let names = self.quantities.iter();
        let names = names.flat_map(|one| strokes(&one.name(self.mechanism(), 0)));
        ["phi1".to_owned()].into_iter().chain(names).collect()
    }

    fn readouts(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        let values = self.rates(&self.quantities, phi)?;
        Ok([phi].into_iter().chain(values).collect())
    }

    fn plotted(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        self.rates(&self.plotted, phi)
    }

    fn joints(&self, phi: f64) -> Result<Vec<f64>, Problem> {
        let pose = self.pose(phi)?;
        let places = self.handles.iter().map(|point| self.place(&pose, *point));
        Ok(places.flat_map(|at| [at.x, at.y]).collect())
    }

    fn drag(&self, joint: &str, phi: f64, to: Point) -> Result<Change, Problem> {
        let mechanism = self.mechanism();
        let point = mechanism.point(joint);
        let point = point.filter(|_| to.coords.iter().all(|x| x.is_finite()));
        let point = point.ok_or_else(|| unknown(joint))?;
        let pose = self.pose(phi)?;
        let Some(crank) = self.crank.as_ref().filter(|crank| crank.end == point) else {
            let draft = mechanism.redrawn(&pose, point, to);
            return Ok(Change::Redrawn(Redrawn::new(&draft)));
        };
        let pivot = self.place(&pose, crank.pivot);
        let angle = |at: Point| (at.y - pivot.y).atan2(at.x - pivot.x);
        let by = angle(to) - angle(self.place(&pose, crank.end));
        Ok(Change::Phi(phi + by - TAU * ((by + PI) / TAU).floor()))
    }

    fn trace(&self, _: f64, _: Point) -> Result<Change, Problem> {
        Err(unknown("P1"))
    }

    fn cycle(&self) -> &Cycle {
        self.motion.cycle()
    }

    fn chart(&self) -> &Chart {
        &self.chart
    }

    fn table(&self, steps: u32) -> SweepTable {
        table(&self.motion, steps)
    }

    /// Places need no derivatives, which a dead point has not.
    fn equations(&self, phi: f64, order: usize) -> Result<Vec<f64>, Problem> {
        match order {
            0 => Ok(sides(self.mechanism(), &self.pose::<1>(phi)?, 0)),
            _ => Ok(sides(self.mechanism(), &self.pose::<3>(phi)?, order.min(2))),
        }
    }
}

/// The linkages of the catalogue: `{id, document}` for each.
#[wasm_bindgen]
pub fn gallery() -> JsValue {
    #[derive(Serialize)]
    struct Entry {
        id: &'static str,
        document: LinkageDocument,
    }
    let entry = |id| {
        let document = from_catalogue(id)?.ok()?;
        Some(Entry { id, document })
    };
    let all: Vec<Entry> = assur_file::gallery().filter_map(entry).collect();
    to_js(&all)
}

/// Why there is no pose, with the names of the links.
fn problem(unsolved: &Unsolved, mechanism: &Mechanism) -> Problem {
    LinkageProblem::unsolved(unsolved, mechanism).into()
}

/// The table of everything of a linkage that a crank drives.
fn table(motion: &Motion, steps: u32) -> SweepTable {
    let mechanism = motion.mechanism();
    let columns = Column::all(mechanism);
    let [start, end] = motion.cycle().axis();
    let steps = steps.max(1);
    let turns = ((end - start) / TAU).round().max(1.0) as u32;
    let row = |step: u32| {
        let part = f64::from(step) / f64::from(steps);
        let row = motion.row(&columns, TAU * part);
        SweepRow {
            phi_deg: 360.0 * f64::from(step) / f64::from(steps),
            values: row.values,
            reason: row.reason.map(|unsolved| problem(&unsolved, mechanism)),
        }
    };
    SweepTable {
        rows: (0..=turns * steps).map(row).collect(),
        columns: columns
            .iter()
            .map(|column| column.name(mechanism))
            .collect(),
    }
}
