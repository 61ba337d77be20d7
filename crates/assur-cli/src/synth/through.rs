//! The four-bars whose coupler point passes through given points.

use std::io::Write;

use assur::Point;
use assur::synthesis::four_bar::{Passage, Verdict};
use assur::synthesis::path::{
    CURVES, NinePoints, PathFourBar, RankedFourBar, Search, Start, StartError,
};
use clap::Args;
use serde_json::{Map, Value, json};

use super::words;
use crate::Failure;
use crate::words::class;

/// Start data of the search, as the page fetches them.
const START: &[u8] = include_bytes!("../../../../www/data/nine-points.bin");

/// Maximum number of linkages in the table; JSON has them all.
const SHOWN: usize = 20;

/// Arguments of a task of a path.
#[derive(Args)]
pub(crate) struct OnPath {
    /// A point of a path instead of positions. Nine points in their order
    #[arg(id = "through", long = "through", value_name = "X,Y", conflicts_with_all = ["positions", "function", "l2", "coupler", "lengths", "free"], value_parser = point, allow_hyphen_values = true)]
    points: Vec<[f64; 2]>,
}

fn point(text: &str) -> Result<[f64; 2], String> {
    let parts: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match parts.as_deref() {
        Ok(&[x, y]) if x.is_finite() && y.is_finite() => Ok([x, y]),
        _ => Err("a point is two numbers, as 2,1.5".to_owned()),
    }
}

impl OnPath {
    /// True if points are given.
    pub(super) fn is_given(&self) -> bool {
        !self.points.is_empty()
    }
}

/// Writes the real four-bars through the points, as a table or as JSON.
///
/// # Errors
/// An invalid task; output that cannot be written.
pub(super) fn write(out: &mut impl Write, asked: &OnPath, as_json: bool) -> Result<(), Failure> {
    let points: Vec<Point> = asked.points.iter().map(|at| Point::from(*at)).collect();
    let points = NinePoints::new(&points);
    let points = points.map_err(|error| Failure::Input(words::path_error(&error)))?;
    let start = Start::read(START);
    let start = start.map_err(|error: StartError| Failure::Io(words::start_error(error)))?;
    let mut search = Search::new(points);
    search.run(&start, |_| true);
    let found = search.ranked();
    if as_json {
        writeln!(out, "{:#}", report(asked, &search, &found))?;
    } else {
        table(out, &search, &found)?;
    }
    Ok(())
}

fn is_on_one_circuit(verdict: &Verdict) -> bool {
    !matches!(
        verdict.passage,
        Passage::OtherCircuit | Passage::Unreached(_)
    )
}

fn is_on_one_branch(verdict: &Verdict) -> bool {
    verdict.passage == Passage::Continuous
}

fn report(asked: &OnPath, search: &Search, found: &[RankedFourBar]) -> Value {
    let solutions = found.iter().map(|found| {
        let spec = found.four_bar.spec();
        let mut points = Map::new();
        for point in &spec.points {
            points.insert(point.name.clone(), json!([point.at.x, point.at.y]));
        }
        let mut links = Map::new();
        links.insert("frame".to_owned(), json!(spec.frame));
        for link in &spec.links {
            links.insert(link.name.clone(), json!(link.points));
        }
        let ([a, d], [b, c]) = (found.four_bar.pivots, found.four_bar.hinges);
        let dyad = |pivot: Point, point: Point| {
            json!({"type": "RR", "pivot": [pivot.x, pivot.y], "point": [point.x, point.y]})
        };
        json!({
            "points": points,
            "links": links,
            "dyads": [dyad(a, b), dyad(d, c)],
            "curve": found.curve,
            "residual": found.four_bar.residual,
            "error": found.error,
            "verdict": verdict(&found.four_bar),
        })
    });
    json!({
        "kind": "path",
        "through": asked.points,
        "solutions": solutions.collect::<Value>(),
        "curves": search.count(),
        "unproved": search.unproved(),
        "count": found.len(),
        "complete": search.is_complete(),
    })
}

fn verdict(four_bar: &PathFourBar) -> Value {
    let Ok(verdict) = &four_bar.verdict else {
        return Value::Null;
    };
    let transmission = verdict.transmission_between;
    json!({
        "passage": words::passage(verdict.passage),
        "order": words::order(verdict.order),
        "circuit": is_on_one_circuit(verdict),
        "branch": is_on_one_branch(verdict),
        "grashof": class(verdict.grashof),
        "turns_fully": verdict.turns,
        "transmission": transmission,
        "transmission_deg": transmission.map(f64::to_degrees),
        "size_ratio": verdict.size_ratio,
    })
}

/// Writes a line for each four-bar, best first.
fn table(out: &mut impl Write, search: &Search, found: &[RankedFourBar]) -> Result<(), Failure> {
    let number = |value: f64| words::value(&json!(value));
    let place = |point: Point| format!("{}, {}", number(point.x), number(point.y));
    writeln!(
        out,
        "{:<8} {:<6} {:<24} {:<24} {:<8} {:<8} {:<7} {:<14} {:<13}",
        "linkage", "curve", "A", "D", "order", "circuit", "branch", "grashof", "transmission"
    )?;
    for (k, found) in (1..).zip(found.iter().take(SHOWN)) {
        let told = verdict(&found.four_bar);
        let of = |key: &str| words::value(&told[key]);
        let [a, d] = found.four_bar.pivots.map(place);
        let transmission = told["transmission_deg"].as_f64();
        let transmission = transmission.map_or("-".to_owned(), |angle| format!("{angle:.1}°"));
        writeln!(
            out,
            "{k:<8} {:<6} {a:<24} {d:<24} {:<8} {:<8} {:<7} {:<14} {transmission:<13}",
            found.curve,
            of("order"),
            of("circuit"),
            of("branch"),
            of("grashof"),
        )?;
    }
    let complete = if search.is_complete() { "yes" } else { "no" };
    writeln!(out, "\n{:<14} {}", "count", found.len())?;
    writeln!(out, "{:<14} {} of {CURVES}", "curves", search.count())?;
    writeln!(out, "{:<14} {complete}", "complete")?;
    Ok(())
}
