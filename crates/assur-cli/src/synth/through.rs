//! The linkages whose point passes through given points: arguments, and all four-bars through nine points.

use std::io::Write;

use assur::Point;
use assur::synthesis::approximation::Course;
use assur::synthesis::path::{CURVES, NinePoints, RankedFourBar, Search, Start, StartError};
use clap::{Args, ValueEnum};
use serde_json::{Value, json};

use super::linkage::{self, SHOWN};
use super::poses::point;
use super::{approximated, words};
use crate::Failure;
use crate::words::number;

/// Start data of the search, as the page fetches them.
const START: &[u8] = include_bytes!("../../../../www/data/nine-points.bin");

/// Default number of linkages that a search compares.
const CANDIDATES: u32 = 200_000;

/// Number of points for which all four-bars are found.
const NINE: usize = 9;

/// Arguments of a task of a path.
#[derive(Args)]
pub(crate) struct OnPath {
    /// A point of a path instead of positions, in order. Nine points have a finite number of four-bars, which are all
    /// listed; otherwise a search approximates the path
    #[arg(id = "through", long = "through", value_name = "X,Y", conflicts_with_all = ["positions", "function", "pose", "l2", "coupler", "lengths", "free"], value_parser = point, allow_hyphen_values = true)]
    pub(super) points: Vec<[f64; 2]>,
    /// Crank angle at a point in degrees, once per point; only differences count
    #[arg(id = "angle", long = "angle", requires = "through", value_name = "DEG", value_parser = number, allow_hyphen_values = true)]
    pub(super) angles: Vec<f64>,
    /// What the points mean: points to be passed, or a curve
    #[arg(
        id = "course",
        long = "course",
        requires = "through",
        value_name = "COURSE",
        default_value = "points"
    )]
    pub(super) course: CourseName,
    /// Approximates with slider-cranks, too
    #[arg(long, requires = "through")]
    pub(super) slider_cranks: bool,
    /// Approximates, with so many linkages compared; without it nine points are exact
    #[arg(long, requires = "through", value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000_000))]
    candidates: Option<u32>,
}

/// Meaning of the points of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum CourseName {
    /// Points to be passed in order; the path between them is free
    Points,
    /// A curve from the first point to the last
    Open,
    /// A closed curve
    Closed,
}

impl From<CourseName> for Course {
    fn from(course: CourseName) -> Self {
        match course {
            CourseName::Points => Self::Points,
            CourseName::Open => Self::Open,
            CourseName::Closed => Self::Closed,
        }
    }
}

impl OnPath {
    /// True if `--through` gives points.
    pub(super) fn is_given(&self) -> bool {
        !self.points.is_empty()
    }

    /// Returns the number of linkages that the search compares.
    pub(super) fn candidates(&self) -> usize {
        self.candidates.unwrap_or(CANDIDATES) as usize
    }

    /// True if all four-bars through nine points are requested: no other option asks for an approximation.
    fn is_exact(&self) -> bool {
        self.points.len() == NINE
            && self.angles.is_empty()
            && self.course == CourseName::Points
            && !self.slider_cranks
            && self.candidates.is_none()
    }
}

/// Writes the linkages whose point traces the path, as a table or as JSON.
///
/// # Errors
/// An invalid task; output that cannot be written.
pub(super) fn write(out: &mut impl Write, asked: &OnPath, as_json: bool) -> Result<(), Failure> {
    if !asked.is_exact() {
        return approximated::write(out, asked, as_json);
    }
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

fn report(asked: &OnPath, search: &Search, found: &[RankedFourBar]) -> Value {
    let solutions = found.iter().map(|found| {
        let mut solution = linkage::described(&found.four_bar.spec());
        let ([a, d], [b, c]) = (found.four_bar.pivots, found.four_bar.hinges);
        solution["dyads"] = json!([linkage::hinged(a, b), linkage::hinged(d, c)]);
        solution["curve"] = json!(found.curve);
        solution["residual"] = json!(found.four_bar.residual);
        solution["error"] = json!(found.error);
        solution["verdict"] = verdict(found);
        solution
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

fn verdict(found: &RankedFourBar) -> Value {
    let verdict = found.four_bar.verdict.as_ref();
    verdict.map_or(Value::Null, linkage::verdict)
}

/// Writes a line for each four-bar, the best first.
fn table(out: &mut impl Write, search: &Search, found: &[RankedFourBar]) -> Result<(), Failure> {
    let verdicts = linkage::row(linkage::VERDICT);
    writeln!(
        out,
        "{:<8} {:<6} {:<24} {:<24} {verdicts}",
        "linkage", "curve", "A", "D"
    )?;
    for (k, found) in (1..).zip(found.iter().take(SHOWN)) {
        let [a, d] = found.four_bar.pivots.map(linkage::place);
        let cells = linkage::cells(&verdict(found));
        writeln!(out, "{k:<8} {:<6} {a:<24} {d:<24} {cells}", found.curve)?;
    }
    let complete = words::yes_or_no(search.is_complete());
    writeln!(out, "\n{:<14} {}", "count", found.len())?;
    writeln!(out, "{:<14} {} of {CURVES}", "curves", search.count())?;
    writeln!(out, "{:<14} {complete}", "complete")?;
    Ok(())
}
