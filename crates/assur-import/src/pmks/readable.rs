//! The first form of PMKS+ URLs, with one joint, link or force per line:
//! `?j=A,-3.74,-2.41,AB,R,t,0,0.1,t,%0A…&l=AB,1,1,…,A|B,,…&f=…&s=10,false,false,cm`. Later versions add a link's kind,
//! R or P, and omit a joint's friction.

use assur_file::LengthUnit;

use super::plan::{Member, Pin, Plan};
use crate::ImportProblem;

pub(super) fn begins(query: &str) -> bool {
    query.starts_with("j=") && query.contains("&l=")
}

pub(super) fn plan(query: &str) -> Result<Plan, ImportProblem> {
    let part = |name: &str| {
        let parts = query
            .split('&')
            .find_map(|part| part.strip_prefix(name)?.strip_prefix('='));
        parts.unwrap_or_default()
    };
    let lines = |name: &str| {
        part(name)
            .split('\n')
            .map(str::trim)
            .filter(|line| !line.is_empty())
    };
    let settings: Vec<&str> = part("s").split(',').collect();
    let rpm = match settings[0] {
        "" => 0.0,
        told => number("s", told)?,
    };
    let clockwise = settings
        .get(1)
        .is_some_and(|told| yes(told).unwrap_or(false));
    let unit = match settings.get(3) {
        Some(&"cm") => Some(LengthUnit::Cm),
        Some(&"m") => Some(LengthUnit::M),
        Some(&"mm") => Some(LengthUnit::Mm),
        Some(&"in") => Some(LengthUnit::In),
        _ => None,
    };
    let force = |line: &str| crate::quoted(line.split(',').next().unwrap_or_default());
    let mut plan = Plan {
        unit,
        rpm: if clockwise { -rpm } else { rpm },
        pins: lines("j").map(pin).collect::<Result<_, _>>()?,
        members: lines("l").map(member).collect::<Result<_, _>>()?,
        forces: lines("f").map(force).collect(),
        unknown: Vec::new(),
    };
    plan.bounded()?;
    // This form does not list traced points; points on fewer than two links are traced.
    for pin in &mut plan.pins {
        let links = plan
            .members
            .iter()
            .filter(|member| member.joints.contains(&pin.id));
        pin.traced = links.count() < 2;
    }
    Ok(plan)
}

/// Reads a joint: `id,x,y,links,kind,ground,angle,friction,input,`, in later versions
/// `id,x,y,links,kind,ground,angle,input`.
fn pin(line: &str) -> Result<Pin, ImportProblem> {
    let broken = || ImportProblem::part(line);
    let fields: Vec<&str> = line.split(',').collect();
    let [id, x, y, _, kind, ground, angle, ref rest @ ..] = fields[..] else {
        return Err(broken());
    };
    let input = match rest {
        [input] => input,
        [_, input, ..] => input,
        [] => return Err(broken()),
    };
    let prismatic = match kind {
        "R" => false,
        "P" => true,
        _ => return Err(broken()),
    };
    Ok(Pin {
        id: id.to_owned(),
        name: crate::quoted(id),
        at: [number(id, x)?, number(id, y)?],
        prismatic,
        grounded: yes(ground).ok_or_else(broken)?,
        input: yes(input).ok_or_else(broken)?,
        angle: if prismatic { number(id, angle)? } else { 0.0 },
        ..Pin::default()
    })
}

/// Reads a link: `id,mass,inertia,x,y,joints,…`, in later versions `id,kind,mass,inertia,x,y,joints,…`.
fn member(line: &str) -> Result<Member, ImportProblem> {
    let broken = || ImportProblem::part(line);
    let fields: Vec<&str> = line.split(',').collect();
    let (block, rest) = match fields[..] {
        [_, "P", ref rest @ ..] => (true, rest),
        [_, "R", ref rest @ ..] => (false, rest),
        [_, ref rest @ ..] => (false, rest),
        [] => return Err(broken()),
    };
    let joints = match rest {
        [_, _, _, _, joints, ..] => joints,
        // In some versions, the line of a block lists only its id, its kind and its joints.
        [joints, ..] if block => joints,
        _ => return Err(broken()),
    };
    Ok(Member {
        id: fields[0].to_owned(),
        name: crate::quoted(fields[0]),
        block,
        root: true,
        mass: if block {
            0.0
        } else {
            number(fields[0], rest[0])?
        },
        joints: joints.split('|').map(str::to_owned).collect(),
        parts: Vec::new(),
    })
}

fn number(part: &str, text: &str) -> Result<f64, ImportProblem> {
    let value = crate::number(text);
    value.ok_or_else(|| ImportProblem::number(part, text))
}

fn yes(text: &str) -> Option<bool> {
    match text {
        "t" | "true" => Some(true),
        "f" | "false" => Some(false),
        _ => None,
    }
}
