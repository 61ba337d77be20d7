//! Summary of a whole motion for the page, and its parts that the page asks for separately.

mod outputs;

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use assur::mechanism::{
    Counts, FRAME, LinkOrFrame, Mechanism, PointId, Quantity, RrpDyad, RrrDyad,
};
use assur::motion::{DeadPoint, Motion, OutputProfile, TooManyTurns};
use assur::structure::roman;
use assur::{Cycle, Swing};
use assur_draw::Figure;
use serde::Serialize;

use crate::capabilities::Moves;
use crate::handle::Handle;
use crate::kinds::becomes;
use crate::moving::Moving;

/// Summary of the drawing and the structure of a linkage.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct StructureSummary<'a> {
    bounds: [f64; 4],
    counts: CountsSummary,
    /// Passive wheels, whose meshes repeat constraints of other meshes.
    passive: Vec<&'a str>,
    /// The pairs with a redundant constraint; empty if there are passive wheels.
    redundant: Vec<String>,
    class: String,
    order: usize,
    formula: String,
    groups: Vec<GroupSummary>,
    roles: BTreeMap<&'a str, &'static str>,
}

/// Summary of any motion.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CourseSummary<'a> {
    /// Kind of input: `angle`, `length` or `time`.
    #[cfg_attr(test, ts(type = "\"angle\" | \"length\" | \"time\""))]
    pub(crate) moves: &'static str,
    /// The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time.
    pub(crate) input: &'a str,
    pub(crate) cycle: CycleSummary,
    pub(crate) home: f64,
    pub(crate) dead_points: Vec<DeadPointSummary<'a>>,
    pub(crate) change_points: &'a [f64],
    /// The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name.
    pub(crate) unsearched: Option<UnsearchedSummary>,
    /// Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂.
    pub(crate) numbers: &'a BTreeMap<String, String>,
    pub(crate) listed: Vec<ListedSummary<'a>>,
    /// Choices of the page that plot a group of quantities together, such as `angles`.
    pub(crate) overviews: &'static [&'static str],
    pub(crate) plotted: Vec<String>,
    /// Quantities of the drawn curves: the plotted ones, or the two plotted against each other.
    pub(crate) curves: Vec<String>,
    pub(crate) handles: Vec<HandleSummary<'a>>,
    /// Whether points of the links can be traced.
    pub(crate) traceable: bool,
    /// Other kinds of document into which this document can be converted.
    #[cfg_attr(test, ts(type = "readonly (\"scheme\" | \"point-path\")[]"))]
    pub(crate) becomes: &'static [&'static str],
}

/// Summary of a linkage in motion; each kind adds its own fields.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MotionSummary<'a> {
    #[serde(flatten)]
    course: CourseSummary<'a>,
    #[serde(flatten)]
    structure: StructureSummary<'a>,
    four_bars: Vec<FourBarSummary<'a>>,
    points: Vec<&'a str>,
}

/// Numbers of moving links, lower pairs, higher pairs; mobility by rank and by count. A hinge of k links counts as
/// k − 1 pairs.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CountsSummary {
    links: usize,
    lower: usize,
    higher: usize,
    mobility: isize,
    by_count: isize,
}

/// Converts the counts of a drawing. The rank of its constraints is not known, so both mobilities are by count.
impl From<Counts> for CountsSummary {
    fn from(counts: Counts) -> Self {
        Self {
            links: counts.links,
            lower: counts.lower_pairs,
            higher: counts.higher_pairs,
            mobility: counts.mobility,
            by_count: counts.mobility,
        }
    }
}

/// Range of the input, and its arcs. `full` states whether a crank turns fully or, for a gear train, time has no end.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CycleSummary {
    pub(crate) start: f64,
    pub(crate) end: f64,
    pub(crate) full: bool,
    pub(crate) arcs: Vec<[f64; 2]>,
}

/// Number of turns after which the motion repeats, and the greatest such number for which extrema are searched.
#[derive(Clone, Copy, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct UnsearchedSummary {
    turns: usize,
    most: usize,
}

/// A term of the structural formula, and the colour role of its links.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GroupSummary {
    term: String,
    role: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DeadPointSummary<'a> {
    input: f64,
    kind: &'static str,
    links: Vec<&'a str>,
}

impl<'a> DeadPointSummary<'a> {
    pub(crate) fn new(motion: &'a Motion, end: &DeadPoint) -> Self {
        Self {
            input: end.input,
            kind: end.kind.code(),
            links: motion.links_at(end).collect(),
        }
    }
}

/// A four-bar in the linkage: its crank, coupler, rocker and base, and its Grashof type.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct FourBarSummary<'a> {
    links: [&'a str; 4],
    grashof: &'static str,
}

/// The least transmission angle of an RRR dyad, or the greatest pressure angle of an RRP dyad, at the dyad's inner
/// joint, radians; and the input at which it occurs. Both are null if the motion was not searched.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TransmissionSummary<'a> {
    #[cfg_attr(test, ts(type = "\"transmission\" | \"pressure\""))]
    what: &'static str,
    joint: String,
    links: [&'a str; 2],
    worst: Option<f64>,
    input: Option<f64>,
}

/// Profile of an output. `swing` and `turns` have a value for each arc of the input: `swing` is null if the output
/// keeps rotating; `turns` is the travel over a full cycle, or along the arc and back, in turns. If not `searched`,
/// only the name is set.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct OutputSummary {
    name: String,
    searched: bool,
    swing: Vec<Option<Between>>,
    turns: Vec<f64>,
    limits: Vec<LimitSummary>,
    time_ratio: Option<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Between {
    min: f64,
    max: f64,
    stroke: f64,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LimitSummary {
    input: f64,
    value: f64,
}

/// A listed read-out and its subject `of`: the link of an angle, and the links fixed to it; the point of a coordinate;
/// the joint of a transmission angle; the points or links of a measure.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ListedSummary<'a> {
    pub(crate) name: String,
    /// `angle`, `load_angle`, `x`, `y`, `transmission`, `pressure`, `distance`, `corner` or `between`.
    #[cfg_attr(
        test,
        ts(
            type = "\"angle\" | \"load_angle\" | \"x\" | \"y\" | \"transmission\" | \"pressure\" | \"distance\" | \"corner\" | \"between\""
        )
    )]
    pub(crate) what: &'static str,
    pub(crate) of: Vec<&'a str>,
    /// The subscript in the symbol of the read-out, if the read-out is an angle.
    pub(crate) number: Option<&'a str>,
    pub(crate) role: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct HandleSummary<'a> {
    pub(crate) name: &'a str,
    pub(crate) role: &'static str,
    /// Whether pressing the handle without a drag has an effect.
    pub(crate) pressed: bool,
}

impl<'a> From<&'a Handle> for HandleSummary<'a> {
    fn from(handle: &'a Handle) -> Self {
        Self {
            name: &handle.name,
            role: handle.role,
            pressed: false,
        }
    }
}

impl<'a> StructureSummary<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism, figure: &Figure) -> Self {
        let structure = mechanism.structure();
        let highest = structure.groups().max_by_key(|group| group.class);
        let groups = mechanism.terms().into_iter().zip(figure.term_roles());
        let (counts, mobility) = (mechanism.counts(), mechanism.mobility());
        Self {
            bounds: figure.bounds(),
            counts: CountsSummary {
                links: counts.links,
                lower: counts.lower_pairs,
                higher: counts.higher_pairs,
                mobility: mobility.by_rank,
                by_count: mobility.by_count,
            },
            redundant: if counts.passive == 0 {
                mobility.redundant
            } else {
                Vec::new()
            },
            passive: (mechanism.passive_wheels())
                .map(|wheel| mechanism.link_name(wheel))
                .collect(),
            class: roman(structure.class()),
            order: highest.map_or(1, |group| group.order()),
            formula: mechanism.formula(),
            groups: groups
                .map(|(term, role)| GroupSummary {
                    term,
                    role: role.name(),
                })
                .collect(),
            roles: (mechanism.link_ids())
                .map(|link| (mechanism.link_name(link), figure.role(link).name()))
                .collect(),
        }
    }
}

impl<'a> MotionSummary<'a> {
    pub(crate) fn new(moving: &'a Moving) -> Self {
        let (motion, mechanism, figure) = (moving.motion(), moving.mechanism(), moving.figure());
        let dead_points = motion.dead_points().iter();
        let dead_points = dead_points.map(|end| DeadPointSummary::new(motion, end));
        let link = |link: LinkOrFrame| link.map_or(FRAME, |link| mechanism.link_name(link));
        let four_bars = mechanism.four_bars().into_iter();
        let four_bars = four_bars.map(|one| FourBarSummary {
            links: [
                Some(one.crank),
                Some(one.coupler),
                Some(one.rocker),
                one.base,
            ]
            .map(link),
            grashof: one.grashof().code(),
        });
        let handles = moving.handles().iter().map(HandleSummary::from);
        let unsearched = motion.searchable().err();
        let course = CourseSummary {
            moves: if mechanism.turns() { "angle" } else { "length" },
            input: moving.input_number(),
            cycle: CycleSummary::new(motion.cycle()),
            home: motion.drawn_input(),
            dead_points: dead_points.collect(),
            change_points: motion.change_points(),
            unsearched: unsearched
                .map(|TooManyTurns { turns, most }| UnsearchedSummary { turns, most }),
            numbers: moving.numbers(),
            listed: (moving.listed().into_iter())
                .map(|quantity| ListedSummary::new(moving, quantity))
                .collect(),
            overviews: &["angles"],
            plotted: (moving.plotted().iter())
                .map(|one| one.name(mechanism, 0))
                .collect(),
            curves: (moving.curves().into_iter())
                .map(|one| one.name(mechanism, 0))
                .collect(),
            handles: handles.collect(),
            traceable: moving.traceable(),
            becomes: becomes(moving),
        };
        Self {
            course,
            structure: StructureSummary::new(mechanism, figure),
            four_bars: four_bars.collect(),
            points: mechanism.points().collect(),
        }
    }
}

impl<'a> TransmissionSummary<'a> {
    /// The worst angle of each dyad over the motion.
    pub(crate) fn all(moving: &'a Moving) -> Vec<Self> {
        let mechanism = moving.mechanism();
        let dyads = moving.motion().transmissions().into_iter();
        let all = dyads.map(|dyad| Self {
            what: dyad.quantity.kind_name(),
            joint: dyad.quantity.subject(mechanism).into_owned(),
            links: dyad.links.map(|link| mechanism.link_name(link)),
            worst: dyad.worst.map(|worst| worst.angle),
            input: dyad.worst.map(|worst| worst.input),
        });
        all.collect()
    }
}

impl<'a> ListedSummary<'a> {
    fn new(moving: &'a Moving, quantity: Quantity) -> Self {
        let (mechanism, what) = (moving.mechanism(), quantity.kind_name());
        let named = |points: &[PointId]| {
            let names = points.iter().map(|point| mechanism.point_name(*point));
            names.collect()
        };
        let (of, role): (Vec<&str>, &str) = match quantity {
            Quantity::Angle(link) => {
                let fixed = mechanism.link_ids();
                let fixed =
                    fixed.filter(|one| *one != link && mechanism.root_of(*one) == Some(link));
                let links = [link].into_iter().chain(fixed);
                let of = links.map(|link| mechanism.link_name(link)).collect();
                (of, moving.figure().role(link).name())
            }
            Quantity::X(point) | Quantity::Y(point) => (named(&[point]), what),
            Quantity::Transmission(RrrDyad { inner, .. })
            | Quantity::Pressure(RrpDyad { inner, .. }) => (named(&[inner]), "secondary"),
            Quantity::Distance(points) => (named(&points), "accent3"),
            Quantity::Corner(points) => (named(&points), "accent4"),
            Quantity::Between(links) => {
                let links = links.map(|link| mechanism.link_name(link));
                (links.to_vec(), "accent4")
            }
        };
        let number = of.first().and_then(|link| moving.numbers().get(*link));
        Self {
            name: quantity.name(mechanism, 0),
            what,
            number: number.map(String::as_str).filter(|_| what == "angle"),
            of,
            role: moving.plotted_role(quantity).unwrap_or(role),
        }
    }
}
