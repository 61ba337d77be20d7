//! What the page shows of a whole motion, under the names it knows.

use assur::catalog::mixer::Mixer;
use assur::{Grashof, Swing};
use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Summary {
    grashof: &'static str,
    cycle: CycleSummary,
    home: f64,
    swing: Swings,
    limits: Vec<LimitSummary>,
    time_ratio: Option<f64>,
    transmission: Transmission,
    ratio: f64,
    dead_points: Vec<f64>,
    change_points: Vec<f64>,
    bounds: [f64; 4],
}

#[derive(Serialize)]
struct CycleSummary {
    start: f64,
    end: f64,
    full: bool,
    arcs: Vec<[f64; 2]>,
}

/// One for every arc of the cycle, none where the wheel turns fully.
#[derive(Serialize)]
struct Swings {
    rocker: Vec<Option<Between>>,
    wheel5: Vec<Option<Between>>,
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
        let (linkage, assembly) = (&mixer.linkage, mixer.assembly);
        let cycle = linkage.cycle();
        let [start, end] = cycle.axis();
        let swings = linkage.swings(assembly);
        let ratio = mixer.gears.ratio();
        let (min, phi) = linkage.worst_transmission();
        let limit = |limit: assur::Limit| LimitSummary {
            phi: limit.crank,
            rocker: limit.rocker,
        };
        Self {
            grashof: grashof(linkage.grashof()),
            home: cycle.home(),
            swing: Swings {
                rocker: swings.iter().map(|swing| between(*swing)).collect(),
                wheel5: swings
                    .iter()
                    .map(|swing| between(swing.scaled(ratio)))
                    .collect(),
            },
            limits: linkage.limits(assembly).into_iter().map(limit).collect(),
            time_ratio: linkage.time_ratio(assembly),
            transmission: Transmission { min, phi },
            ratio,
            dead_points: linkage.dead_points(),
            change_points: linkage.change_points().iter().map(|p| p.crank).collect(),
            bounds,
            cycle: CycleSummary {
                start,
                end,
                full: cycle.is_full(),
                arcs: cycle.arcs().to_vec(),
            },
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
