//! Symbols of forces and couples, the same in plans, equations and tables.

use assur::forces::{Cause, Component, ForceName, Source};

use super::Numbers;

/// Symbol of a force or couple, such as `R₁₂ᵗ`: the tangential component of the reaction from link 1 on link 2.
///
/// | symbol | force | couple |
/// |---|---|---|
/// | weight of link 2 | G₂ | |
/// | inertia of link 2 | Φ₂ | MΦ₂ |
/// | first load | F₁ | M₁ |
/// | first spring, damper | S₁, D₁ | MS₁, MD₁ |
/// | friction, first in its list | Fᶠ₁ | Mᶠ₁ |
/// | reaction from link 1 on link 2 | R₁₂ | M₁₂ |
/// | balancing torque or force on link 1 | P₁ | T₁ |
pub fn force_symbol(name: &ForceName, is_couple: bool, numbers: Numbers<'_>) -> String {
    let body = numbers(name.body);
    let letter = |force, couple| if is_couple { couple } else { force };
    let (letter, below) = match name.cause {
        Cause::Applied(Source::Weight) => ("G", body),
        Cause::Applied(Source::Inertia) => (letter("Φ", "MΦ"), body),
        Cause::Applied(Source::Load(index)) => (letter("F", "M"), (index + 1).to_string()),
        Cause::Applied(Source::Spring(index)) => (letter("S", "MS"), (index + 1).to_string()),
        Cause::Applied(Source::Damper(index)) => (letter("D", "MD"), (index + 1).to_string()),
        Cause::Applied(Source::Friction(index)) => (letter("Fᶠ", "Mᶠ"), (index + 1).to_string()),
        Cause::Reaction { from, .. } => {
            let from = numbers(from);
            let long = from.chars().count() > 1 || body.chars().count() > 1;
            let between = if long { "‚" } else { "" };
            (letter("R", "M"), [from, body].join(between))
        }
        Cause::Drive { .. } => (letter("P", "T"), body),
    };
    let above = match name.part {
        Component::Whole => "",
        Component::X => "ˣ",
        Component::Y => "ʸ",
        Component::Tangential => "ᵗ",
        Component::Normal => "ⁿ",
        Component::Along => "∥",
        Component::Across => "⊥",
    };
    let below: String = below.chars().map(lowered).collect();
    [letter, &below, above].concat()
}

fn lowered(letter: char) -> char {
    let digit = letter.to_digit(10);
    let low = digit.and_then(|digit| char::from_u32(0x2080 + digit));
    low.unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::mechanism::BodyId;

    #[test]
    fn digits_are_subscripts() {
        let name = |cause| ForceName {
            body: BodyId::FRAME,
            cause,
            part: Component::Whole,
        };
        let symbol = |cause, couple, number: &str| {
            force_symbol(&name(cause), couple, &|_| number.to_owned())
        };
        let inertia = Cause::Applied(Source::Inertia);
        assert_eq!(symbol(inertia, true, "12"), "MΦ₁₂");
        assert_eq!(symbol(Cause::Applied(Source::Load(1)), false, "7"), "F₂");
    }
}
