//! The structural formula, such as I(0,1) → II₂(2,3).

use super::{Group, Step, Structure};
use std::fmt::Display;

impl Structure {
    /// The structural formula in Artobolevsky's notation: [its terms](Self::terms) with arrows between them.
    pub fn formula<N: Display>(&self, name: impl Fn(usize) -> N) -> String {
        self.terms(name).join(" → ")
    }

    /// The terms of the structural formula, one for each step: the class, for a group the order as a subscript, and the
    /// links in brackets. `name` returns the name of a link. A + stands between the links of one body.
    pub fn terms<N: Display>(&self, name: impl Fn(usize) -> N) -> Vec<String> {
        let body = |links: &[usize]| {
            let names = links.iter().map(|&link| name(link).to_string());
            names.collect::<Vec<_>>().join("+")
        };
        let steps = self.steps.iter().map(|step| match step {
            Step::Driver { links: [a, b], .. } => format!("I({},{})", name(*a), name(*b)),
            Step::Group(group) => {
                let bodies: Vec<_> = group.bodies.iter().map(|links| body(links)).collect();
                format!("{}({})", group.symbol(), bodies.join(","))
            }
        });
        steps.collect()
    }
}

impl Group {
    /// Class and order of the group, such as IV₃; q₁ for a passive link, which has one redundant constraint.
    pub fn symbol(&self) -> String {
        let is_passive = self.surplus > 0 && self.class == 1;
        let (letters, number) = if is_passive {
            ("q".to_owned(), self.surplus)
        } else {
            (roman(self.class), self.order())
        };
        letters + &subscript(number)
    }
}

/// A number in subscript digits.
pub(crate) fn subscript(number: usize) -> String {
    let number = number.to_string();
    let digits = number.chars().filter_map(|digit| {
        let value = digit.to_digit(10)?;
        char::from_u32(u32::from('₀') + value)
    });
    digits.collect()
}

/// A class in Roman numerals, such as IV.
pub fn roman(mut number: usize) -> String {
    let mut roman = String::new();
    for (value, letters) in [
        (100, "C"),
        (90, "XC"),
        (50, "L"),
        (40, "XL"),
        (10, "X"),
        (9, "IX"),
        (5, "V"),
        (4, "IV"),
        (1, "I"),
    ] {
        while number >= value {
            roman += letters;
            number -= value;
        }
    }
    roman
}

#[cfg(test)]
mod tests {
    use super::roman;

    #[test]
    fn roman_numerals() {
        let numbers = [1, 2, 3, 4, 5, 6, 8, 9, 14, 39, 40, 66, 99];
        assert_eq!(
            numbers.map(roman).join(" "),
            "I II III IV V VI VIII IX XIV XXXIX XL LXVI XCIX"
        );
    }
}
