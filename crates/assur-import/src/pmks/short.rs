//! The second form of a PMKS+ URL: `?2P.Ay.K,0.1011.MA,A,0,0,0.…`. Dots separate sections, commas separate fields.
//! Numbers are in base 64, with a leading 0 if negative; decimals are in thousandths. Booleans are the bits of a
//! number: one digit in a joint or force, up to two in the settings. The last character encodes the length of the text
//! before it, modulo 62.

use assur_file::LengthUnit;

use super::plan::{Member, Pin, Plan};
use crate::ImportProblem;

/// The digits of base 64. The first 62 are also the check characters.
const DIGITS: &[u8; 64] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
const CHECKS: usize = 62;

/// Maximum number of digits of a number: more could not be represented exactly.
const MAX_DIGITS: usize = 8;

/// Number of sections before the joints: boolean, decimal, integer and enumerated settings.
const SETTINGS: usize = 4;

pub(super) fn begins(query: &str) -> bool {
    let mut sections = query.split('.');
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| digit(byte).is_some());
    let plain = |text: &str| text.split(',').all(digits);
    let head: Vec<&str> = sections.by_ref().take(SETTINGS).collect();
    head.len() == SETTINGS
        && head[0].len() <= 2
        && head.iter().all(|text| plain(text))
        && sections.count() > 1
}

pub(super) fn plan(query: &str) -> Result<Plan, ImportProblem> {
    let whole = checked(query).ok_or(ImportProblem::LinkCut)?;
    let mut sections = whole.split('.');
    let mut next = || sections.next().unwrap_or_default();
    let [flags, _, whole_numbers, choices] = [next(), next(), next(), next()];
    let clockwise = number(flags)?.rem_euclid(2) == 1;
    let rpm = number(whole_numbers.split(',').next().unwrap_or_default())? as f64;
    let mut plan = Plan {
        unit: unit(choices),
        rpm: if clockwise { -rpm } else { rpm },
        ..Plan::default()
    };
    for section in sections.by_ref().take_while(|section| !section.is_empty()) {
        plan.pins.push(pin(section)?);
    }
    for section in sections.by_ref().take_while(|section| !section.is_empty()) {
        plan.members.push(member(section)?);
    }
    for section in sections.by_ref().take_while(|section| !section.is_empty()) {
        plan.forces.push(force(section)?);
    }
    // The first remaining section is the selection; later versions of the format added the others.
    let rest = sections.skip(1).filter(|section| !section.is_empty());
    plan.unknown = rest.map(crate::quoted).collect();
    Ok(plan)
}

/// Returns the text without its check character; none if that character is missing or does not match the length of the
/// text before it.
fn checked(query: &str) -> Option<&str> {
    let last = query.chars().next_back()?;
    let text = &query[..query.len() - last.len_utf8()];
    // PMKS+ counts UTF-16 units, as JavaScript does.
    let length = text.encode_utf16().count();
    (char::from(DIGITS[length % CHECKS]) == last).then_some(text)
}

fn digit(byte: u8) -> Option<i64> {
    let found = DIGITS.iter().position(|digit| *digit == byte);
    found.map(|value| value as i64)
}

/// Parses a whole number in base 64.
fn number(text: &str) -> Result<i64, ImportProblem> {
    let broken = || ImportProblem::part(text);
    let (sign, digits) = match text.strip_prefix('0') {
        Some(rest) => (-1, rest),
        None => (1, text),
    };
    if text.is_empty() || digits.len() > MAX_DIGITS {
        return Err(broken());
    }
    let mut values = digits.bytes().map(digit);
    let value = values.try_fold(0, |sum: i64, value| Some(sum * 64 + value?));
    value.map(|value| sign * value).ok_or_else(broken)
}

fn thousandths(text: &str) -> Result<f64, ImportProblem> {
    Ok(number(text)? as f64 / 1000.0)
}

/// Splits a section into its flags, which are its first character, and its fields.
fn fields(section: &str) -> Result<(i64, Vec<&str>), ImportProblem> {
    let broken = || ImportProblem::part(section);
    let mut letters = section.chars();
    let flags = letters
        .next()
        .filter(char::is_ascii)
        .and_then(|letter| digit(letter as u8));
    Ok((
        flags.ok_or_else(broken)?,
        letters.as_str().split(',').collect(),
    ))
}

/// Reads a joint: `[flags]id,name,x,y,angle,carrier,from,to,speed`; the last four fields may be missing. `carrier`,
/// `from` and `to` are given only for a prismatic pair on a link. `speed` is the joint's own speed as a driver.
fn pin(section: &str) -> Result<Pin, ImportProblem> {
    let (flags, fields) = fields(section)?;
    let is = |bit: i64| flags >> bit & 1 == 1;
    let [id, name, x, y, angle, ref rest @ ..] = fields[..] else {
        return Err(ImportProblem::part(section));
    };
    let slot = match rest {
        ["", ..] | [] => None,
        [carrier, from, to, ..] => Some([*carrier, *from, *to].map(str::to_owned)),
        _ => {
            return Err(ImportProblem::part(section));
        }
    };
    let own = rest.get(3).filter(|rpm| !rpm.is_empty());
    Ok(Pin {
        id: id.to_owned(),
        name: crate::quoted(name),
        at: [thousandths(x)?, thousandths(y)?],
        prismatic: is(0),
        input: is(1),
        grounded: is(2),
        welded: is(3),
        traced: is(4),
        angle: thousandths(angle)?,
        slot,
        rpm: own
            .map(|rpm| thousandths(rpm))
            .transpose()?
            .filter(|rpm| *rpm != 0.0),
    })
}

/// Reads a link: `[root][kind]id,name,mass,inertia,x,y,colour,joint,joint,…,,part,part,…`.
fn member(section: &str) -> Result<Member, ImportProblem> {
    let broken = || ImportProblem::part(section);
    let mut letters = section.chars();
    let (root, kind) = (letters.next(), letters.next());
    let fields: Vec<&str> = letters.as_str().split(',').collect();
    let [id, name, mass, _, _, _, _, ref rest @ ..] = fields[..] else {
        return Err(broken());
    };
    let mut rest = rest.iter().map(|one| (*one).to_owned());
    let joints = rest.by_ref().take_while(|id| !id.is_empty()).collect();
    Ok(Member {
        id: id.to_owned(),
        name: crate::quoted(name),
        // The letter encodes two settings: root or not, and which of the fields of mass and inertia are chosen.
        root: match root.ok_or_else(broken)? {
            'Y' | 'A' | 'M' | 'G' => true,
            'N' | 'a' | 'm' | 'g' => false,
            _ => return Err(broken()),
        },
        block: match kind.ok_or_else(broken)? {
            'R' => false,
            'P' => true,
            _ => return Err(broken()),
        },
        mass: thousandths(mass)?,
        joints,
        parts: rest.filter(|id| !id.is_empty()).collect(),
    })
}

/// Reads the name of a force: `[flags]id,link,name,…`.
fn force(section: &str) -> Result<String, ImportProblem> {
    let (_, fields) = fields(section)?;
    let [_, _, name, ..] = fields[..] else {
        return Err(ImportProblem::part(section));
    };
    Ok(crate::quoted(name))
}

fn unit(choices: &str) -> Option<LengthUnit> {
    match choices.chars().next()? {
        '0' => Some(LengthUnit::In),
        '1' => Some(LengthUnit::Cm),
        '2' => Some(LengthUnit::M),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_to_the_base_64() {
        let known = [
            ("0", 0),
            ("Fe", 1000),
            ("0ng", -(49 * 64 + 42)),
            ("-", 63),
            ("00", 0),
        ];
        for (text, value) in known {
            assert_eq!(number(text).unwrap(), value, "{text}");
        }
        for bad in ["", "a.b", "é", "0123456789A"] {
            assert!(number(bad).is_err(), "{bad}");
        }
    }
}
