//! The structural formula, such as I(0,1) → II₂(2,3).

use super::{Group, Step, Structure};
use std::fmt::Display;

impl Structure {
    /// The structural formula in Artobolevsky's notation: [its terms](Self::terms) with arrows between them.
    pub fn formula<N: Display>(&self, name: impl Fn(usize) -> N) -> String {
        self.terms(name).join(" → ")
    }

    /// The terms of the structural formula, one for each step: the class, for a group with its order as a subscript,
    /// and the links in brackets. `name` returns the name of a link. A + stands between the links of one body.
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
    use super::*;
    use crate::structure::{Driver, Graph, Pair, decompose};

    #[test]
    fn roman_numerals() {
        let numbers = [1, 2, 3, 4, 5, 6, 8, 9, 14, 39, 40, 66, 99];
        assert_eq!(
            numbers.map(roman).join(" "),
            "I II III IV V VI VIII IX XIV XXXIX XL LXVI XCIX"
        );
    }

    #[test]
    fn subscripts_have_all_digits() {
        assert_eq!([0, 7, 120, 3456].map(subscript).join(" "), "₀ ₇ ₁₂₀ ₃₄₅₆");
    }

    /// Structure of six links with these hinges; 0 is the frame, and the first hinge is driven.
    fn hinged(hinges: [[usize; 2]; 7]) -> Structure {
        let graph = Graph {
            links: 6,
            ground: 0,
            pairs: hinges.map(|links| Pair::Revolute(links.to_vec())).to_vec(),
        };
        let driver = Driver {
            pair: 0,
            links: [0, 1],
        };
        decompose(&graph, &[driver]).unwrap()
    }

    /// A four-bar 0-1-2-3 with a second dyad 4-5 on its rocker.
    #[test]
    fn a_formula_has_a_term_for_each_group() {
        let hinges = [[0, 1], [1, 2], [2, 3], [3, 0], [3, 4], [4, 5], [5, 0]];
        let structure = hinged(hinges);
        assert_eq!(
            structure.formula(|link| link),
            "I(0,1) → II₂(2,3) → II₂(4,5)"
        );
        let letters = |link: usize| ["frame", "a", "b", "c", "d", "e"][link];
        assert_eq!(
            structure.terms(letters),
            ["I(frame,a)", "II₂(b,c)", "II₂(d,e)"]
        );
    }

    /// A plate 3 on three bars: 2 from the crank 1, and 4 and 5 from the frame.
    #[test]
    fn a_plate_on_three_bars_is_of_class_iii_and_order_3() {
        let hinges = [[0, 1], [1, 2], [2, 3], [3, 4], [3, 5], [4, 0], [5, 0]];
        let structure = hinged(hinges);
        assert_eq!(structure.formula(|link| link), "I(0,1) → III₃(2,3,4,5)");
    }

    #[test]
    fn a_passive_link_is_written_with_its_redundant_constraint() {
        let passive = Group {
            bodies: vec![vec![4]],
            inner: vec![],
            outer: vec![],
            class: 1,
            dyad: None,
            surplus: 1,
        };
        assert_eq!(passive.symbol(), "q₁");
    }
}
