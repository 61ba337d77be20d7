//! A linkage with its verdict, as JSON and as cells of a table. Tasks of poses and of paths share it.

use assur::Point;
use assur::linkage::LinkageSpec;
use assur::synthesis::four_bar::Verdict;
use serde_json::{Map, Value, json};

use super::words;
use crate::words::class;

/// Maximum number of linkages in a table; JSON has them all.
pub(super) const SHOWN: usize = 20;

/// Column headings of a verdict.
pub(super) const VERDICT: [&str; 5] = ["order", "circuit", "branch", "grashof", "transmission"];

/// Describes a linkage: its points by name, the points of the frame and those of each link.
pub(super) fn described(spec: &LinkageSpec) -> Value {
    let points = spec.points.iter();
    let points = points.map(|point| (point.name.clone(), json!([point.at.x, point.at.y])));
    let mut links = Map::new();
    links.insert("frame".to_owned(), json!(spec.frame));
    for link in &spec.links {
        links.insert(link.name.clone(), json!(link.points));
    }
    json!({"points": Value::Object(points.collect()), "links": links})
}

/// Describes a link with a hinge on the frame and a hinge on the coupler.
pub(super) fn hinged(pivot: Point, point: Point) -> Value {
    json!({"type": "RR", "pivot": [pivot.x, pivot.y], "point": [point.x, point.y]})
}

/// Describes the verdict on a four-bar.
pub(super) fn verdict(verdict: &Verdict) -> Value {
    let transmission = verdict.transmission_between;
    json!({
        "passage": words::passage(verdict.passage),
        "order": words::order(verdict.order),
        "circuit": verdict.passage.is_on_one_circuit(),
        "branch": verdict.passage.is_on_one_branch(),
        "grashof": class(verdict.grashof),
        "turns_fully": verdict.turns,
        "transmission": transmission,
        "transmission_deg": transmission.map(f64::to_degrees),
        "size_ratio": verdict.size_ratio,
    })
}

/// Formats the cells of a verdict, padded to the widths of their columns.
pub(super) fn cells(verdict: &Value) -> String {
    let of = |key: &str| words::value(&verdict[key]);
    let transmission = verdict["transmission_deg"].as_f64();
    let transmission = transmission.map_or("-".to_owned(), |angle| format!("{angle:.1}°"));
    let [order, circuit, branch, grashof, _] = VERDICT.map(of);
    row([&order, &circuit, &branch, &grashof, &transmission])
}

/// Pads the cells of a verdict to the widths of their columns.
pub(super) fn row([order, circuit, branch, grashof, transmission]: [&str; 5]) -> String {
    format!("{order:<8} {circuit:<8} {branch:<7} {grashof:<14} {transmission:<13}")
}

/// Formats a point for a table.
pub(super) fn place(point: Point) -> String {
    let [x, y] = [point.x, point.y].map(|value| words::value(&json!(value)));
    format!("{x}, {y}")
}
