//! The linkages that approximate a path.

use std::io::Write;

use assur::Point;
use assur::synthesis::approximation::{
    Approximation, PathVerdict, Search, Special, Target, Tracing, Wanted,
};
use assur::synthesis::four_bar::Passage;
use serde_json::{Value, json};

use super::linkage;
use super::through::OnPath;
use super::words;
use crate::Failure;

/// Writes the best linkages of a search, as a table or as JSON.
///
/// # Errors
/// Points that are no path; output that cannot be written.
pub(super) fn write(out: &mut impl Write, asked: &OnPath, as_json: bool) -> Result<(), Failure> {
    let points: Vec<Point> = asked.points.iter().map(|at| Point::from(*at)).collect();
    let angles: Vec<f64> = asked.angles.iter().map(|one| one.to_radians()).collect();
    let angles = (!angles.is_empty()).then_some(&angles[..]);
    let target = Target::new(&points, asked.course.into(), angles);
    let target = target.map_err(|error| Failure::Input(words::target_error(&error)))?;
    let wanted = Wanted {
        slider_cranks: asked.slider_cranks,
        ..Wanted::default()
    };
    let mut search = Search::new(target, wanted);
    search.step(asked.candidates());
    let found = search.found();
    if found.is_empty() {
        return Err(Failure::Input(words::NO_TRACING.to_owned()));
    }
    if as_json {
        writeln!(out, "{:#}", report(asked, &search, &found))?;
    } else {
        table(out, &search, &found)?;
    }
    Ok(())
}

fn report(asked: &OnPath, search: &Search, found: &[Approximation]) -> Value {
    let solutions = found.iter().map(|found| {
        let mut solution = linkage::described(&found.linkage.spec());
        solution["mechanism"] = json!(mechanism(&found.linkage));
        solution["dyads"] = json!(dyads(&found.linkage));
        solution["greatest"] = json!(found.deviation.greatest);
        solution["root_mean_square"] = json!(found.deviation.root_mean_square);
        solution["verdict"] = verdict(found.verdict.as_ref());
        solution
    });
    let progress = search.progress();
    json!({
        "kind": "approximation",
        "through": asked.points,
        "angles_deg": asked.angles,
        "special": search.target().special().map(special),
        "solutions": solutions.collect::<Value>(),
        "candidates": progress.candidates,
        "exact": progress.exact,
        "count": found.len(),
        "complete": false,
    })
}

fn mechanism(linkage: &Tracing) -> &'static str {
    match linkage {
        Tracing::FourBar(_) => "four_bar",
        Tracing::SliderCrank(_) => "slider_crank",
    }
}

fn special(special: Special) -> &'static str {
    match special {
        Special::Line { .. } => "line",
        Special::Circle { .. } => "circle",
    }
}

fn dyads(linkage: &Tracing) -> [Value; 2] {
    match linkage {
        Tracing::FourBar(linkage) => {
            let ([a, d], [b, c]) = (linkage.pivots(), linkage.joints());
            [linkage::hinged(a, b), linkage::hinged(d, c)]
        }
        Tracing::SliderCrank(linkage) => {
            let ([b, c], along) = (linkage.joints(), linkage.guide());
            let slider = json!({"type": "PR", "point": [c.x, c.y], "along": [along.x, along.y]});
            [linkage::hinged(linkage.pivot(), b), slider]
        }
    }
}

/// Describes the verdict, or null if there is none. The crank of a slider-crank turns fully, so circuit and branch are
/// true.
fn verdict(verdict: Option<&PathVerdict>) -> Value {
    match verdict {
        None => Value::Null,
        Some(PathVerdict::FourBar(verdict)) => linkage::verdict(verdict),
        Some(PathVerdict::SliderCrank {
            order,
            turns,
            transmission,
            size_ratio,
        }) => json!({
            "passage": words::passage(Passage::Continuous),
            "order": words::order(*order),
            "circuit": true,
            "branch": true,
            "grashof": null,
            "turns_fully": turns,
            "transmission": transmission,
            "transmission_deg": transmission.to_degrees(),
            "size_ratio": size_ratio,
        }),
    }
}

/// Writes a line for each linkage, the nearest to the path first.
fn table(out: &mut impl Write, search: &Search, found: &[Approximation]) -> Result<(), Failure> {
    if let Some(special) = search.target().special() {
        writeln!(out, "{}", words::special_path(&special))?;
    }
    let verdicts = linkage::row(linkage::VERDICT);
    writeln!(
        out,
        "{:<8} {:<13} {:<10} {:<24} {:<24} {verdicts}",
        "linkage", "mechanism", "greatest", "A", "D or guide"
    )?;
    for (k, found) in (1..).zip(found) {
        let [first, second] = match &found.linkage {
            Tracing::FourBar(four_bar) => four_bar.pivots().map(linkage::place),
            Tracing::SliderCrank(crank) => {
                [crank.pivot(), Point::from(crank.guide())].map(linkage::place)
            }
        };
        let greatest = crate::words::short(found.deviation.greatest);
        let cells = linkage::cells(&verdict(found.verdict.as_ref()));
        let mechanism = mechanism(&found.linkage);
        writeln!(
            out,
            "{k:<8} {mechanism:<13} {greatest:<10} {first:<24} {second:<24} {cells}"
        )?;
    }
    let progress = search.progress();
    writeln!(out, "\n{:<14} {}", "count", found.len())?;
    writeln!(out, "{:<14} {}", "candidates", progress.candidates)?;
    let exact = words::yes_or_no(progress.exact);
    writeln!(out, "{:<14} {exact}", "exact")?;
    Ok(())
}
