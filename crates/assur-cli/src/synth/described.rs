//! Results of a synthesis, as JSON and as text.

use std::io::{self, Write};

use assur::synthesis::four_bar::theorems::{
    Angles, Unknown, alternative, conditions, functional, theorems, truth,
};
use assur::synthesis::four_bar::{ChangeKind, Family, Proportions, Range, Solution, Task};
use assur_file::Wanted;
use serde_json::{Map, Value, json};

use super::words;
use crate::words::class;

pub(super) struct Report {
    /// Kind of result, such as `family`; `none` if there is no linkage.
    pub(super) kind: &'static str,
    /// Sentences that appear in the text only.
    pub(super) notes: Vec<String>,
    /// Linkages. Those found by a search are in the order in which they are to be shown, the best first.
    pub(super) solutions: Vec<Value>,
    fields: Map<String, Value>,
}

impl Report {
    pub(super) fn new() -> Self {
        Self {
            kind: "none",
            notes: Vec::new(),
            solutions: Vec::new(),
            fields: Map::new(),
        }
    }

    pub(super) fn set(&mut self, key: &str, value: Value) {
        self.fields.insert(key.to_owned(), value);
    }

    pub(super) fn json(&self) -> Value {
        let mut fields = self.fields.clone();
        fields.insert("kind".to_owned(), json!(self.kind));
        fields.insert("solutions".to_owned(), json!(self.solutions));
        Value::Object(fields)
    }

    /// Writes notes, ranges, and a block of lines for each linkage.
    ///
    /// # Errors
    /// Output that cannot be written.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "{:<14} {}", "kind", self.kind)?;
        for note in &self.notes {
            writeln!(out, "{note}")?;
        }
        if let Some(starts) = self.fields.get("starts") {
            writeln!(out, "{:<14} {starts}", "starts")?;
        }
        if let Some(family) = self.fields.get("family") {
            lines(out, family)?;
        }
        for (number, position) in (1..).zip(
            self.fields
                .get("at")
                .and_then(Value::as_array)
                .into_iter()
                .flatten(),
        ) {
            writeln!(out, "\nposition {number}")?;
            lines(out, position)?;
        }
        for (number, solution) in (1..).zip(&self.solutions) {
            writeln!(out, "\nlinkage {number}")?;
            lines(out, solution)?;
        }
        Ok(())
    }
}

/// Writes a line for each field, and for each field of a nested object.
fn lines(out: &mut impl Write, fields: &Value) -> io::Result<()> {
    for (key, value) in fields.as_object().into_iter().flatten() {
        match value {
            Value::Object(parts) if !parts.contains_key("in_fact") => lines(out, value)?,
            Value::Array(all) if all.iter().any(Value::is_object) => {
                for one in all {
                    let all: Vec<String> = (one.as_object().into_iter().flatten())
                        .map(|(key, value)| format!("{key} {}", words::value(value)))
                        .collect();
                    writeln!(out, "{key:<14} {}", all.join(", "))?;
                }
            }
            _ => writeln!(out, "{key:<14} {}", words::value(value))?,
        }
    }
    Ok(())
}

/// Describes a linkage with its verdict, and with its error against a wanted function; lengths are in the frame's unit.
pub(super) fn solution(task: &Task, solution: &Solution, wanted: Option<&Wanted>) -> Value {
    let length = task.frame().length;
    let [l3, l1, l2, _] = solution.proportions.lengths(length);
    let closures = solution.closures.iter();
    let mut described = json!({
        "l1": l1,
        "l2": l2,
        "l3": l3,
        "phi1_deg": closures.clone().map(|c| c.coupler.to_degrees()).collect::<Value>(),
        "residual": closures.map(|c| c.residual * length).collect::<Value>(),
    });
    if [solution.output_start, solution.input_start] != [0.0; 2] {
        described["phi20_deg"] = json!(solution.output_start.to_degrees());
        described["phi30_deg"] = json!(solution.input_start.to_degrees());
    }
    described["verdict"] = match &solution.verdict {
        Err(_) => Value::Null,
        Ok(verdict) => json!({
            "passage": words::passage(verdict.passage),
            "assembly": verdict.assembly.map(|assembly| assembly as usize + 1),
            "order": words::order(verdict.order),
            "class": class(verdict.grashof),
            "turns_fully": verdict.turns,
            "transmission_deg": verdict.transmission.to_degrees(),
            "transmission_between_deg": verdict.transmission_between.map(f64::to_degrees),
            "size_ratio": verdict.size_ratio,
        }),
    };
    if let Some(wanted) = wanted {
        let curve = wanted.error_curve(task, solution);
        let greatest = curve.as_ref().and_then(|curve| curve.greatest);
        described["function"] = json!({
            "greatest_error": greatest.and_then(|greatest| greatest.error()),
            "at_x": greatest.map(|greatest| greatest.x),
            "unbroken": curve.is_some_and(|curve| curve.complete),
        });
    }
    described
}

/// Adds the ranges of lengths and coupler angles of a family, and the lengths at which its verdicts change.
pub(super) fn family(report: &mut Report, family: &Family) {
    let length = family.task().frame().length;
    let range = |range: Range| json!([range.from * length, range.to.map(|to| to * length)]);
    let degrees = |[from, to]: [f64; 2]| json!([from.to_degrees(), to.to_degrees()]);
    let [first, second] = family.coupler_angles().map(degrees);
    let changes = family.changes().into_iter().map(|change| {
        let what = match change.kind {
            ChangeKind::Grashof => json!("class"),
            ChangeKind::DeadPoint(k) => json!(format!("dead-point-{}", k + 1)),
        };
        json!({"l2": change.proportions.output * length, "what": what})
    });
    let described = json!({
        "l1_range": range(family.coupler_range()),
        "l2_range": range(family.output_range()),
        "l3_range": range(family.input_range()),
        "phi1_first_deg": first,
        "phi1_second_deg": second,
        "change": changes.collect::<Value>(),
    });
    report.set("family", described);
}

/// Reports on a single position: output link and driver may have any lengths if the coupler spans the gap between them.
pub(super) fn one(report: &mut Report, task: &Task) {
    report.kind = "any";
    report.notes.push(words::ONE.to_owned());
    let position = task.positions()[0];
    let angles = Angles {
        frame: task.frame().angle,
        coupler: 0.0,
        output: position.output,
        input: position.input,
    };
    let determined = angles.subsystem(Unknown::Coupler).is_some();
    report.set("condition_13", json!(determined));
    if !determined {
        report.notes.push(words::PARALLEL.to_owned());
    }
    let equal = Proportions {
        coupler: 1.0,
        output: 1.0,
        input: 1.0,
    };
    // Coupler length that closes the loop. With a coupler of length 1 the residual is this length less 1.
    let gap = Solution::new(task, equal).closures[0].residual + 1.0;
    let closed = Proportions {
        coupler: gap,
        ..equal
    };
    if gap > 0.0 {
        report.solutions = vec![solution(task, &Solution::new(task, closed), None)];
    }
}

/// Evaluates the paper's conditions and theorems at each position: whether each holds as printed, and whether its
/// conclusion is true. Each position also lists ranges of l₁ and, if `lengths` are given, the gap of the loop.
/// `couplers` are the coupler angles φ₁, radians.
pub(super) fn printed(task: &Task, couplers: &[f64], lengths: Option<Proportions>) -> Value {
    let frame = task.frame();
    let told = task
        .positions()
        .iter()
        .zip(couplers)
        .map(|(position, coupler)| {
            let angles = Angles {
                frame: frame.angle,
                coupler: *coupler,
                output: position.output,
                input: position.input,
            };
            let range = |(from, to): (f64, Option<f64>)| {
                json!([from * frame.length, to.map(|to| to * frame.length)])
            };
            let mut told = json!({
                "phi1_deg": coupler.to_degrees(),
                "l1_range": truth(&angles).and_then(|truth| truth.range()).map(range),
            });
            if let Some(by) = angles.subsystem(Unknown::Coupler) {
                for (k, name) in ["l2", "l3"].into_iter().enumerate() {
                    let [p, q] = [by.constant[k], by.slope[k]];
                    told[format!("p_{name}")] = json!(p);
                    told[format!("q_{name}")] = json!(q);
                    told[format!("l1_range_of_{name}")] =
                        json!(alternative(p, q).range().map(range));
                }
            }
            for one in conditions(&angles) {
                told[format!("condition_{}", one.number)] = words::asked(one.holds, one.truth);
            }
            for one in theorems(&angles).into_iter().flatten() {
                told[format!("theorem_{}", one.number)] = words::asked(one.conditions, one.truth);
            }
            if let Some(proportions) = lengths {
                let open = functional(&angles, proportions.z()).sqrt();
                told["open"] = json!(open * frame.length);
            }
            told
        });
    told.collect()
}
