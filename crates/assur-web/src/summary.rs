//! What the page shows of a whole motion, under the names it knows.

use std::f64::consts::TAU;

use assur::catalog::mixer::Mixer;
use assur::gears::GearPair;
use assur::{Cycle, Grashof, Swing};
use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Summary {
    counts: CountsSummary,
    grashof: &'static str,
    cycle: CycleSummary,
    home: f64,
    swing: Vec<Option<Between>>,
    wheels: Vec<WheelSummary>,
    overlaps: Vec<[usize; 2]>,
    free_direction: f64,
    limits: Vec<LimitSummary>,
    time_ratio: Option<f64>,
    transmission: Transmission,
    dead_points: Vec<f64>,
    change_points: Vec<f64>,
    bounds: [f64; 4],
}

/// Moving links, lower and higher pairs, degrees of freedom.
#[derive(Serialize)]
struct CountsSummary {
    links: usize,
    lower: usize,
    higher: usize,
    mobility: isize,
}

#[derive(Serialize)]
pub(crate) struct CycleSummary {
    start: f64,
    end: f64,
    full: bool,
    arcs: Vec<[f64; 2]>,
}

/// A peripheral wheel; swings as the rocker's: one for every arc of the cycle,
/// none where it turns fully. Turns there and back, per cycle.
#[derive(Serialize)]
struct WheelSummary {
    ratio: f64,
    swing: Vec<Option<Between>>,
    turns: Vec<f64>,
}

#[derive(Serialize)]
struct Between {
    min: f64,
    max: f64,
    stroke: f64,
}

#[derive(Serialize)]
struct LimitSummary {
    phi: f64,
    rocker: f64,
}

#[derive(Serialize)]
struct Transmission {
    min: f64,
    phi: f64,
}

impl Summary {
    pub(crate) fn new(mixer: &Mixer, bounds: [f64; 4]) -> Self {
        let graph = mixer.graph();
        let (linkage, assembly) = (&mixer.linkage, mixer.assembly);
        let cycle = linkage.cycle();
        let swings = linkage.swings(assembly);
        let travels = linkage.travels(assembly);
        let wheel = |pair: &GearPair| {
            let ratio = pair.ratio();
            let swing = swings.iter().map(|swing| between(swing.scaled(ratio)));
            let turns = travels.iter().map(|travel| travel * ratio.abs() / TAU);
            WheelSummary {
                ratio,
                swing: swing.collect(),
                turns: turns.collect(),
            }
        };
        let pairs = mixer.gears.pairs();
        let (min, phi) = linkage.worst_transmission();
        let limit = |limit: assur::Limit| LimitSummary {
            phi: limit.crank,
            rocker: limit.rocker,
        };
        Self {
            counts: CountsSummary {
                links: graph.links - 1,
                lower: graph.lower_pairs(),
                higher: graph.higher_pairs(),
                mobility: graph.mobility(),
            },
            grashof: grashof(linkage.grashof()),
            home: cycle.home(),
            swing: swings.iter().map(|swing| between(*swing)).collect(),
            wheels: pairs.iter().map(wheel).collect(),
            overlaps: mixer.gears.overlaps(),
            free_direction: mixer.gears.free_direction(),
            limits: linkage.limits(assembly).into_iter().map(limit).collect(),
            time_ratio: linkage.time_ratio(assembly),
            transmission: Transmission { min, phi },
            dead_points: linkage.dead_points(),
            change_points: linkage.change_points().iter().map(|p| p.crank).collect(),
            bounds,
            cycle: CycleSummary::new(&cycle),
        }
    }
}

impl CycleSummary {
    pub(crate) fn new(cycle: &Cycle) -> Self {
        let [start, end] = cycle.axis();
        Self {
            start,
            end,
            full: cycle.is_full(),
            arcs: cycle.arcs().to_vec(),
        }
    }
}

fn between(swing: Swing) -> Option<Between> {
    match swing {
        Swing::Turns => None,
        Swing::Between { min, max } => Some(Between {
            min,
            max,
            stroke: swing.stroke()?,
        }),
    }
}

fn grashof(class: Grashof) -> &'static str {
    match class {
        Grashof::CrankRocker => "crank_rocker",
        Grashof::RockerCrank => "rocker_crank",
        Grashof::DoubleCrank => "double_crank",
        Grashof::DoubleRocker => "double_rocker",
        Grashof::TripleRocker => "triple_rocker",
        Grashof::ChangePoint => "change_point",
    }
}
