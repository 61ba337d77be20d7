//! The linkages that guide a body through given poses.

use std::io::Write;

use assur::Point;
use assur::synthesis::four_bar::{Criterion, Requirements};
use assur::synthesis::poses::{
    Dyad, Linkage, Mechanism, Place, Pose, Solutions, Special, Task, Wanted,
};
use clap::Args;
use serde_json::{Value, json};

use super::linkage::{self, SHOWN};
use super::words;
use crate::Failure;
use crate::words::class;

/// Arguments of a task of poses.
#[derive(Args)]
pub(crate) struct OnPoses {
    /// A pose of the body instead of positions: place of its origin and its angle in degrees. Two to five poses.
    #[arg(id = "pose", long = "pose", value_name = "X,Y,DEG", conflicts_with_all = ["positions", "function", "l2", "coupler", "lengths", "free"], value_parser = pose, allow_hyphen_values = true)]
    poses: Vec<[f64; 3]>,
    /// A wanted hinge on the frame. With two or three poses each gives a dyad; with four, the nearest centre point
    /// does; with five, only dyads with a hinge there are listed
    #[arg(id = "pivot", long = "pivot", requires = "pose", value_name = "X,Y", value_parser = point, allow_hyphen_values = true)]
    pivots: Vec<[f64; 2]>,
    /// A wanted hinge on the body, by its place in the first pose, used in the same way
    #[arg(id = "point", long = "point", requires = "pose", value_name = "X,Y", value_parser = point, allow_hyphen_values = true)]
    points: Vec<[f64; 2]>,
    /// Opposite corners of a rectangle that must contain the hinges on the frame
    #[arg(long, requires = "pose", value_name = "X,Y,X,Y", value_parser = region, allow_hyphen_values = true)]
    pivot_region: Option<[f64; 4]>,
}

fn numbers<const N: usize>(text: &str, wanted: &str) -> Result<[f64; N], String> {
    let parts: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    let numbers: Option<[f64; N]> = parts.ok().and_then(|parts| parts.try_into().ok());
    let finite = numbers.filter(|all| all.iter().all(|one| one.is_finite()));
    finite.ok_or_else(|| wanted.to_owned())
}

fn pose(text: &str) -> Result<[f64; 3], String> {
    numbers(text, words::POSE)
}

/// Parses a point: two numbers separated by a comma.
///
/// # Errors
/// The text is not a point.
pub(super) fn point(text: &str) -> Result<[f64; 2], String> {
    numbers(text, words::POINT)
}

fn region(text: &str) -> Result<[f64; 4], String> {
    numbers(text, words::REGION)
}

impl OnPoses {
    /// True if `--pose` gives poses.
    pub(super) fn is_given(&self) -> bool {
        !self.poses.is_empty()
    }

    fn wanted(&self) -> Wanted {
        let points = |all: &[[f64; 2]]| all.iter().map(|one| Point::from(*one)).collect();
        let region = self.pivot_region;
        Wanted {
            pivots: points(&self.pivots),
            points: points(&self.points),
            pivot_region: region.map(|[a, b, c, d]| [Point::new(a, b), Point::new(c, d)]),
            point_region: None,
        }
    }
}

/// Writes dyads and linkages, as a table or as JSON.
///
/// # Errors
/// An invalid task; output that cannot be written.
pub(super) fn write(out: &mut impl Write, asked: &OnPoses, as_json: bool) -> Result<(), Failure> {
    let poses = asked.poses.iter().map(|&[x, y, degrees]| Pose {
        x,
        y,
        angle: degrees.to_radians(),
    });
    let poses: Vec<Pose> = poses.collect();
    let task = Task::new(&poses).map_err(|errors| {
        let all: Vec<String> = errors.iter().map(words::pose_error).collect();
        Failure::Input(all.join("\n"))
    })?;
    let mut found = Solutions::new(&task, &asked.wanted());
    let requirements = Requirements {
        continuous: true,
        in_order: true,
        ..Requirements::default()
    };
    found.rank(&task, &requirements, Criterion::Transmission);
    if as_json {
        writeln!(out, "{:#}", report(&task, asked, &found))?;
    } else {
        table(out, &task, &found)?;
    }
    Ok(())
}

fn report(task: &Task, asked: &OnPoses, found: &Solutions) -> Value {
    let poses = asked.poses.iter();
    let poses = poses.map(|[x, y, degrees]| json!({"x": x, "y": y, "angle_deg": degrees}));
    let solutions = found.linkages.iter().map(|found| {
        let mut solution = linkage::described(&found.spec(task, 0));
        solution["dyads"] = found
            .dyads
            .iter()
            .map(|dyad| described(task, dyad))
            .collect();
        solution["verdict"] = verdict(found);
        solution
    });
    json!({
        "kind": "poses",
        "poses": poses.collect::<Value>(),
        "repeated": task.repeated().into_iter().map(|k| k + 1).collect::<Vec<_>>(),
        "special": special(found.special),
        "freedoms": found.freedoms,
        "dyads": found.dyads.iter().map(|dyad| described(task, dyad)).collect::<Value>(),
        "complex": found.complex,
        "solutions": solutions.collect::<Value>(),
        "count": found.linkages.len(),
        "complete": found.complete,
    })
}

fn special(special: Option<Special>) -> Value {
    let xy = |x: f64, y: f64| json!([x, y]);
    match special {
        None => Value::Null,
        Some(Special::Still) => json!({"kind": "still"}),
        Some(Special::Rotation { pole }) => json!({"kind": "rotation", "pole": xy(pole.x, pole.y)}),
        Some(Special::Line { along }) => json!({"kind": "line", "along": xy(along.x, along.y)}),
        Some(Special::Parallelogram { arm }) => {
            json!({"kind": "parallelogram", "arm": xy(arm.x, arm.y)})
        }
        Some(Special::Parallel) => json!({"kind": "parallel"}),
    }
}

fn described(task: &Task, dyad: &Dyad) -> Value {
    let mut described = json!({"type": dyad.code(), "residual": dyad.residual(task)});
    if let Place::Finite(pivot) = dyad.centre() {
        described["pivot"] = json!([pivot.x, pivot.y]);
    }
    if let Place::Finite(point) = dyad.point() {
        described["point"] = json!([point.x, point.y]);
    }
    if let Dyad::Slider { along, .. } | Dyad::Block { along, .. } = dyad {
        described["along"] = json!([along.x, along.y]);
    }
    described
}

fn verdict(found: &Linkage) -> Value {
    let Ok(verdict) = &found.verdict else {
        return Value::Null;
    };
    let grashof = match verdict.mechanism {
        Mechanism::FourBar(grashof) => Some(class(grashof)),
        _ => None,
    };
    json!({
        "mechanism": verdict.mechanism.code(),
        "passage": words::passage(verdict.passage),
        "order": words::order(verdict.order),
        "circuit": verdict.passage.is_on_one_circuit(),
        "branch": verdict.passage.is_on_one_branch(),
        "grashof": grashof,
        "turns_fully": verdict.turns,
        "transmission": verdict.transmission,
        "transmission_deg": verdict.transmission.map(f64::to_degrees),
        "size_ratio": verdict.size_ratio,
    })
}

/// Writes a line for each dyad and, best first, for each linkage.
fn table(out: &mut impl Write, task: &Task, found: &Solutions) -> Result<(), Failure> {
    for k in task.repeated() {
        writeln!(out, "{}", words::repeated(k))?;
    }
    if let Some(special) = &found.special {
        writeln!(out, "{}", words::special(special))?;
    }
    let is_family = found.freedoms > 0 && found.special != Some(Special::Parallel);
    if is_family && found.dyads.is_empty() {
        writeln!(out, "{}", words::WANTED)?;
    }
    let place = |place: Place| match place {
        Place::Finite(point) => linkage::place(point),
        Place::Infinite(_) => "-".to_owned(),
    };
    writeln!(
        out,
        "{:<6} {:<5} {:<32} {:<32}",
        "dyad", "type", "pivot", "point"
    )?;
    for (k, dyad) in (1..).zip(&found.dyads) {
        let [pivot, point] = [dyad.centre(), dyad.point()].map(place);
        writeln!(out, "{k:<6} {:<5} {pivot:<32} {point:<32}", dyad.code())?;
    }
    let verdicts = linkage::row(linkage::VERDICT);
    writeln!(
        out,
        "\n{:<8} {:<22} {:<8} {verdicts}",
        "linkage", "mechanism", "dyads"
    )?;
    let index = |dyad: &Dyad| {
        let place = found.dyads.iter().position(|other| other == dyad);
        place.map_or_else(String::new, |place| (place + 1).to_string())
    };
    for (k, found) in (1..).zip(found.linkages.iter().take(SHOWN)) {
        let dyads = found.dyads.each_ref().map(index).join("+");
        let verdict = verdict(found);
        let mechanism = words::value(&verdict["mechanism"]);
        let cells = linkage::cells(&verdict);
        writeln!(out, "{k:<8} {mechanism:<22} {dyads:<8} {cells}")?;
    }
    let complete = words::yes_or_no(found.complete);
    writeln!(out, "\n{:<14} {}", "count", found.linkages.len())?;
    writeln!(out, "{:<14} {complete}", "complete")?;
    Ok(())
}
