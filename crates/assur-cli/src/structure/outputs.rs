//! Swing, travel and time ratio of outputs; Grashof classes of four-bars; transmission angles of dyads.

use assur::Swing;
use assur::mechanism::{FRAME, LinkOrFrame, Mechanism, Quantity};
use assur::motion::{Motion, OutputProfile, TooManyTurns};
use serde_json::{Map, Value, json};

use super::{at, placed, rounded};
use crate::source::Moved;
use crate::words::{class, short};

/// Returns outputs, four-bars and transmission angles of a mechanism as JSON.
pub(super) fn described(moved: &Moved) -> Map<String, Value> {
    let motion = &moved.motion;
    let mechanism = motion.mechanism();
    let outputs = moved.outputs().into_iter();
    let outputs = outputs.map(|quantity| output(motion, quantity));
    // A quantity at rest is an output only if the document plots it.
    let named = !moved.document.plots.is_empty();
    let outputs = outputs.filter_map(|(told, moves)| (named || moves).then_some(told));
    let four_bars = mechanism.four_bars().into_iter().map(|one| {
        let links = [
            Some(one.crank),
            Some(one.coupler),
            Some(one.rocker),
            one.base,
        ];
        json!({"links": links.map(|link| name(mechanism, link)), "class": class(one.grashof())})
    });
    let transmissions = motion.transmissions().into_iter().map(|dyad| {
        let mut told = json!({
            "joint": dyad.quantity.subject(mechanism),
            "what": dyad.quantity.kind_name(),
            "links": dyad.links.map(|link| mechanism.link_name(link)),
            "worst_deg": dyad.worst.map(|worst| worst.angle.to_degrees()),
        });
        if let Some(worst) = dyad.worst {
            let (key, input) = placed(mechanism, worst.input);
            told[key] = json!(input);
        }
        told
    });
    [
        ("outputs", outputs.collect()),
        ("four_bars", four_bars.collect()),
        ("transmissions", transmissions.collect()),
    ]
    .map(|(key, all)| (key.to_owned(), Value::Array(all)))
    .into_iter()
    .collect()
}

fn name(mechanism: &Mechanism, link: LinkOrFrame) -> &str {
    link.map_or(FRAME, |link| mechanism.link_name(link))
}

/// Returns the description of an output, with angles in degrees, and true if the output moves. The description has the
/// least and greatest value on each arc of the motion (null where a link keeps rotating), the travel in both
/// directions, limit positions, and the time ratio if the output moves there and back once per turn. If the motion has
/// too many turns to be searched, the description has only the name, the number of turns and its limit.
fn output(motion: &Motion, quantity: Quantity) -> (Value, bool) {
    let mechanism = motion.mechanism();
    let profile = match OutputProfile::new(motion, quantity) {
        Ok(profile) => profile,
        Err(TooManyTurns { turns, most }) => {
            let unsearched = json!({"turns": turns, "most": most});
            let told = json!({"name": quantity.name(mechanism, 0), "unsearched": unsearched});
            return (told, true);
        }
    };
    let (suffix, unit) = if quantity.is_angle() {
        ("_deg", 1_f64.to_degrees())
    } else {
        ("", 1.0)
    };
    let swings = profile.swings();
    let moves = swings.iter().any(|swing| swing.stroke() != Some(0.0));
    let swings = swings.into_iter().map(|swing| match swing {
        Swing::Turns => Value::Null,
        Swing::Between { min, max } => {
            json!({"min": min * unit, "max": max * unit, "stroke": (max - min) * unit})
        }
    });
    let travels = profile.travels().into_iter().map(|travel| travel * unit);
    let limits = profile.limits().into_iter().map(|limit| {
        let (key, input) = placed(mechanism, limit.input);
        json!({key: input, format!("value{suffix}"): limit.value * unit})
    });
    let told = json!({
        "name": quantity.name(mechanism, 0),
        format!("swing{suffix}"): swings.collect::<Value>(),
        format!("travel{suffix}"): travels.collect::<Value>(),
        "limits": limits.collect::<Value>(),
        "time_ratio": profile.time_ratio(),
    });
    (told, moves)
}

/// Returns the lines of the text report, each a key and a text. Lengths are rounded relative to the mechanism's size.
pub(super) fn lines(described: &Value, size: f64) -> Vec<(&'static str, String)> {
    let list = |key: &str| described[key].as_array().into_iter().flatten();
    let outputs = list("outputs").map(|one| ("output", output_line(one, size)));
    let four_bars = list("four_bars").map(|one| {
        let class = one["class"].as_str().unwrap_or_default();
        ("four-bar", format!("{}: {class}", names(&one["links"])))
    });
    let transmissions = list("transmissions").map(|one| {
        let what = match one["what"].as_str() {
            Some("pressure") => "maximum pressure angle",
            _ => "minimum transmission angle",
        };
        let joint = one["joint"].as_str().unwrap_or_default();
        let (worst, links) = (degrees(&one["worst_deg"]), names(&one["links"]));
        let said = if one["worst_deg"].is_null() {
            format!("{joint} ({links}): {what} not looked for")
        } else {
            format!("{joint} ({links}): {what} {worst} at {}", at(one))
        };
        ("transmission", said)
    });
    outputs.chain(four_bars).chain(transmissions).collect()
}

/// Formats swing and travel of an output on each arc, then its time ratio.
fn output_line(output: &Value, size: f64) -> String {
    let is_angle = output.get("swing_deg").is_some();
    let value = |value: &Value| {
        if is_angle {
            degrees(value)
        } else {
            length(value, size)
        }
    };
    let (swing, travel, stroke) = if is_angle {
        ("swing_deg", "travel_deg", "swing")
    } else {
        ("swing", "travel", "stroke")
    };
    let name = output["name"].as_str().unwrap_or_default();
    if let Some(unsearched) = output.get("unsearched") {
        let [turns, most] = ["turns", "most"].map(|key| &unsearched[key]);
        return format!(
            "{name}: extrema are not looked for, the motion repeats after {turns} turns and at most {most} are searched"
        );
    }
    let list = |key: &str| output[key].as_array().into_iter().flatten();
    let arcs = list(swing).zip(list(travel)).map(|(swing, travel)| {
        let travel = value(travel);
        if swing.is_null() {
            return format!("turns fully, travel {travel}");
        }
        let [min, max, by] = ["min", "max", "stroke"].map(|key| value(&swing[key]));
        format!("{stroke} {by} from {min} to {max}, travel {travel}")
    });
    let mut said: Vec<String> = arcs.collect();
    if let Some(ratio) = output["time_ratio"].as_f64() {
        said.push(format!("time ratio {}", short(ratio)));
    }
    format!("{name}: {}", said.join("; "))
}

fn names(links: &Value) -> String {
    let links = links.as_array().into_iter().flatten();
    links
        .filter_map(Value::as_str)
        .collect::<Vec<_>>()
        .join(", ")
}

fn degrees(value: &Value) -> String {
    value.as_f64().map_or_else(String::new, rounded)
}

/// Formats a length, rounded to about a millionth of the size of the mechanism.
fn length(value: &Value, size: f64) -> String {
    let unit = 10_f64.powi(size.log10().floor() as i32 - 6);
    value.as_f64().map_or_else(String::new, |value| {
        let steps = (value / unit).round();
        // A unit such as 0.01 is not exact in binary, but its inverse is, so the number is divided by the inverse.
        let rounded = if unit < 1.0 {
            steps / unit.recip().round()
        } else {
            steps * unit
        };
        format!("{}", rounded + 0.0)
    })
}
