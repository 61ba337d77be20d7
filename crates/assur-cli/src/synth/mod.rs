//! The four-bar for given positions: the possible linkages and their verdicts.

mod approximated;
mod described;
mod function;
mod linkage;
mod poses;
mod through;
mod words;

use std::io::Write;

use assur::synthesis::four_bar::{
    Frame, Options, Position, Proportions, Search, Solution, StartsError, Task, ThreePositions,
    TwoPositions, five_positions,
};
use assur_file::Wanted;
use clap::Args;
use serde_json::{Value, json};

use crate::Failure;
use crate::words::number;
use described::Report;
use function::OnFunction;
use poses::OnPoses;
use through::OnPath;

/// Maximum number of linkages shown from a family, and of minima shown from a search.
const SHOWN: usize = 5;

/// Arguments of `assur synth`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Corresponding angles of output link and driver, degrees from the x-axis; a weight may follow. The direction of
    /// the output link is from its hinge with the coupler to its fixed pivot.
    #[arg(long = "position", value_name = "PHI2,PHI3[,WEIGHT]", required_unless_present_any = ["function", "pose", "through"], conflicts_with = "function", value_parser = degrees, allow_hyphen_values = true)]
    positions: Vec<Degrees>,
    #[command(flatten)]
    function: OnFunction,
    #[command(flatten)]
    on_poses: OnPoses,
    #[command(flatten)]
    on_path: OnPath,
    /// Length of the frame; sets the unit of all lengths.
    #[arg(
        value_parser = number,
        long,
        value_name = "L0",
        default_value_t = 1.0,
        allow_hyphen_values = true
    )]
    frame: f64,
    /// Direction of the frame, from the driver's fixed pivot to the output link's, degrees from the x-axis.
    #[arg(
        value_parser = number,
        long,
        value_name = "PHI0",
        default_value_t = 0.0,
        allow_hyphen_values = true
    )]
    frame_angle: f64,
    /// Length of the output link, which selects one linkage of the family of two positions.
    #[arg(long, value_parser = number, value_name = "LENGTH", allow_hyphen_values = true)]
    l2: Option<f64>,
    /// Coupler angles, one per position, degrees from the x-axis. Shows if the source paper's conditions and theorems
    /// hold at these angles, if their conclusions are true, and the possible lengths of the coupler.
    #[arg(long, value_name = "PHI1,...", value_delimiter = ',', value_parser = number, allow_hyphen_values = true)]
    coupler: Vec<f64>,
    /// Trial lengths of coupler, output link and driver. Shows the gap in the loop at each position, not a solution.
    #[arg(long, value_name = "L1,L2,L3", value_parser = lengths, allow_hyphen_values = true)]
    lengths: Option<[f64; 3]>,
    /// Leaves the starting angles of output link and driver free; five positions can then be met exactly
    #[arg(long)]
    free: bool,
    /// Prints JSON.
    #[arg(long)]
    json: bool,
}

/// A position, given on the command line or by a function.
#[derive(Clone, Copy)]
pub(crate) struct Degrees {
    output: f64,
    input: f64,
    weight: f64,
}

fn degrees(text: &str) -> Result<Degrees, String> {
    let parts: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    let (output, input, weight) = match parts.as_deref() {
        Ok([output, input]) => (*output, *input, 1.0),
        Ok([output, input, weight]) => (*output, *input, *weight),
        _ => return Err("a position is two angles in degrees, as 240,45".to_owned()),
    };
    Ok(Degrees {
        output,
        input,
        weight,
    })
}

fn lengths(text: &str) -> Result<[f64; 3], String> {
    let parts: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match parts.as_deref() {
        Ok([l1, l2, l3])
            if [l1, l2, l3]
                .iter()
                .all(|one| **one > 0.0 && one.is_finite()) =>
        {
            Ok([*l1, *l2, *l3])
        }
        _ => Err("trial lengths are three numbers above zero, as 10,5,4".to_owned()),
    }
}

impl Asked {
    /// Returns the trial lengths divided by the length of the frame, if given.
    fn trial(&self) -> Option<Proportions> {
        let [coupler, output, input] = self.lengths?.map(|length| length / self.frame);
        Some(Proportions {
            coupler,
            output,
            input,
        })
    }
}

impl Degrees {
    fn radians(&self) -> Position {
        Position {
            output: self.output.to_radians(),
            input: self.input.to_radians(),
            weight: self.weight,
        }
    }

    fn json(&self) -> Value {
        json!({"phi2_deg": self.output, "phi3_deg": self.input, "weight": self.weight})
    }
}

/// Writes the linkages, as text or as JSON.
///
/// # Errors
/// An invalid task; a task without a linkage; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let frame = Frame {
        length: asked.frame,
        angle: asked.frame_angle.to_radians(),
    };
    if asked.on_poses.is_given() {
        return poses::write(out, &asked.on_poses, asked.json);
    }
    if asked.on_path.is_given() {
        return through::write(out, &asked.on_path, asked.json);
    }
    let wanted = asked.function.wanted()?;
    let (given, wanted) = match wanted {
        Some((positions, wanted)) => (positions, Some(wanted)),
        None => (asked.positions.clone(), None),
    };
    let positions: Vec<Position> = given.iter().map(Degrees::radians).collect();
    let task = Task::new(frame, &positions, Task::RATIOS).map_err(|errors| {
        let all: Vec<String> = errors.iter().map(words::task_error).collect();
        Failure::Input(all.join("\n"))
    })?;
    let mut report = report(&task, asked, wanted.as_ref()).map_err(Failure::Input)?;
    if !asked.coupler.is_empty() {
        if asked.coupler.len() != given.len() {
            return Err(Failure::Input(words::COUPLERS.to_owned()));
        }
        let couplers: Vec<f64> = asked.coupler.iter().map(|one| one.to_radians()).collect();
        report.set("at", described::printed(&task, &couplers, asked.trial()));
    }
    if wanted.is_some() {
        report.notes.extend(words::positions(&given));
    }
    report.set("positions", given.iter().map(Degrees::json).collect());
    report.set("l0", json!(asked.frame));
    report.set("phi0_deg", json!(asked.frame_angle));
    if asked.json {
        writeln!(out, "{:#}", report.json())?;
    } else {
        report.write(out)?;
    }
    Ok(())
}

/// Builds the report, or returns a sentence that says why there is none.
fn report(task: &Task, asked: &Asked, wanted: Option<&Wanted>) -> Result<Report, String> {
    let count = task.positions().len();
    if asked.l2.is_some() && (count != 2 || asked.free) {
        return Err("--l2 picks a linkage of the family of two positions; here are not two, or starts are free".to_owned());
    }
    if let Some(trial) = asked.trial() {
        if asked.l2.is_some() || asked.free {
            return Err(words::TRIAL.to_owned());
        }
        let mut report = Report::new();
        report.kind = "trial";
        report.solutions = vec![described::solution(
            task,
            &Solution::new(task, trial),
            wanted,
        )];
        return Ok(report);
    }
    if asked.free {
        return free(task, wanted);
    }
    let mut report = Report::new();
    match count {
        1 => described::one(&mut report, task),
        2 => match TwoPositions::new(task) {
            Some(found) => two(&mut report, found, asked, wanted)?,
            None => return Err(words::NO_POSITION.to_owned()),
        },
        3 => match ThreePositions::new(task) {
            Some(ThreePositions::One(solution)) => {
                report.kind = "one";
                report.solutions = vec![described::solution(task, &solution, wanted)];
            }
            Some(ThreePositions::Same(found)) => two(&mut report, found, asked, wanted)?,
            Some(other) => return Err(words::three(&other, task)),
            None => return Err(words::NO_POSITION.to_owned()),
        },
        _ => {
            many(&mut report, task, Search::new(task), wanted);
            let turned = task.output_is_turned();
            report.set("output_turned", json!(turned));
            if turned {
                report.notes.push(words::TURNED.to_owned());
            }
        }
    }
    Ok(report)
}

fn two(
    report: &mut Report,
    found: TwoPositions,
    asked: &Asked,
    wanted: Option<&Wanted>,
) -> Result<(), String> {
    let family = match found {
        TwoPositions::Family(family) => family,
        TwoPositions::Any => {
            report.kind = "any";
            report.notes.push(words::ANY.to_owned());
            return Ok(());
        }
        TwoPositions::None(line) => return Err(words::no_family(&line)),
    };
    report.kind = "family";
    let task = family.task().clone();
    let length = task.frame().length;
    let members: Vec<Solution> = match asked.l2 {
        Some(l2) => {
            let member = family.with_output(l2 / length);
            vec![member.map_err(|error| words::member(&error, l2, length))?]
        }
        None => {
            described::family(report, &family);
            family.sample(family.stretch().unwrap_or([0.0, 1.0]), SHOWN)
        }
    };
    let members = members.iter();
    report.solutions = members
        .map(|member| described::solution(&task, member, wanted))
        .collect();
    Ok(())
}

fn many(report: &mut Report, task: &Task, search: Search, wanted: Option<&Wanted>) {
    report.kind = "least";
    let options = Options::searched(search);
    let order = options.order();
    let Options::Minima { minima, starts } = options else {
        return;
    };
    report.set("starts", json!(starts));
    let shown = order.iter().take(SHOWN).map(|number| {
        let minimum = &minima[*number];
        let mut described = described::solution(task, &minimum.solution, wanted);
        let square = task.frame().length.powi(2);
        described["output_error_deg"] = json!(minimum.output_error.map(f64::to_degrees));
        described["sum"] = json!(minimum.value * square);
        described["reached"] = json!(minimum.reached);
        let held = minimum.held.iter().map(|bound| words::bound(*bound));
        described["held"] = held.collect::<Value>();
        described
    });
    report.solutions = shown.collect();
}

fn free(task: &Task, wanted: Option<&Wanted>) -> Result<Report, String> {
    let mut report = Report::new();
    match five_positions(task) {
        Ok(found) if found.is_empty() => return Err(words::NO_FIVE.to_owned()),
        Ok(found) => {
            report.kind = "free";
            let all = found
                .iter()
                .map(|found| described::solution(task, found, wanted));
            report.solutions = all.collect();
        }
        Err(StartsError::TooMany) => many(&mut report, task, Search::free(task), wanted),
        Err(error) => return Err(words::starts(error)),
    }
    Ok(report)
}
