//! The formulas of the paper, evaluated as corrected and as printed (Sinchev and Mukhanova, (3) to (38)).

use super::{Angles, Subsystem, System, Unknown, functional, opening, sine, third_pair};
use crate::relation::Relation;

/// Evaluates the relations of the paper at each position, in the paper's order, with the number of the position in the
/// names. Equation (1), J with its derivatives, and the gap are evaluated for the trial lengths `z`: z₁, z₂, z₃.
/// Formulas for lengths that close the loop are evaluated for z₁ and for the z₂ and z₃ that follow from it; they are
/// left out if condition (13) fails. All other formulas depend on the angles alone. `length` is l₀. For each position,
/// `best` lists the coupler's angle with the least residual, and this residual in lengths of the frame. Positions with
/// an angle that is not finite have no relations.
pub fn relations(
    positions: &[Angles],
    z: [f64; 3],
    length: f64,
    best: &[[f64; 2]],
) -> Vec<Relation> {
    let mut all = Vec::new();
    for (name, z) in ["z₁", "z₂", "z₃"].into_iter().zip(z) {
        all.push(Relation::of("000.z", name, z, z));
    }
    if let Some(system) = System::new(positions) {
        let sum = |z| positions.iter().map(|angles| functional(angles, z)).sum();
        let least = system.positive_minimum();
        all.push(Relation::of(
            "000.lemma",
            "min ΣJ",
            least.value,
            sum(least.z),
        ));
        all.push(Relation::of("000.lemma", "ΣJ", system.value(z), sum(z)));
    }
    for (k, (angles, [coupler, gap])) in positions.iter().zip(best).enumerate() {
        if !angles.is_finite() {
            continue;
        }
        let mut collected = Collected::new(k, angles);
        collected.contour(z, length);
        collected.functional(z);
        collected.system();
        if let Some(by) = angles.subsystem(Unknown::Coupler) {
            collected.closed(&by, z[0]);
            collected.ranges(&by, z[0]);
        }
        collected.cases();
        let open = functional(angles, z).sqrt() * length;
        collected.angle("000.ex.phi1", "φ₁", angles.coupler);
        collected.same("000.ex.lengths", "l₀√J", open);
        collected.angle("000.ex.deviation", "φ₁", *coupler);
        collected.same("000.ex.deviation", "l₀√J", gap.abs() * length);
        all.extend(collected.all);
    }
    all
}

/// Relations of a position.
struct Collected<'a> {
    number: usize,
    angles: &'a Angles,
    all: Vec<Relation>,
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

impl<'a> Collected<'a> {
    fn new(index: usize, angles: &'a Angles) -> Self {
        Self {
            number: index + 1,
            angles,
            all: Vec::new(),
        }
    }

    /// Name of a quantity with the position's number, such as `[z₂ + e₂e₃z₃]⁽¹⁾`.
    fn name(&self, name: &str) -> String {
        let number = self.number.to_string();
        let digits = number.chars().filter_map(|digit| digit.to_digit(10));
        let raised: String = digits.map(|digit| RAISED[digit as usize]).collect();
        if name.contains([' ', '(', '|']) {
            format!("[{name}]⁽{raised}⁾")
        } else {
            format!("{name}⁽{raised}⁾")
        }
    }

    fn of(&mut self, item: &'static str, name: &str, value: f64, printed: f64) {
        self.all
            .push(Relation::of(item, self.name(name), value, printed));
    }

    /// Adds a value whose formula is correct as printed, or a quantity that has no formula.
    fn same(&mut self, item: &'static str, name: &str, value: f64) {
        self.of(item, name, value, value);
    }

    fn angle(&mut self, item: &'static str, name: &str, value: f64) {
        self.all
            .push(Relation::angle(item, self.name(name), value, value));
    }

    /// Scalar product eᵢ·eⱼ of the directions of two links: 0 the frame, 1 the coupler, 2 the output, 3 the input.
    fn dot(&self, i: usize, j: usize) -> f64 {
        (self.turn(i) - self.turn(j)).cos()
    }

    /// sin(φᵢ − φⱼ) of the angles of two links, with indices as in [`Self::dot`].
    fn sin(&self, i: usize, j: usize) -> f64 {
        sine(self.turn(i) - self.turn(j))
    }

    fn turn(&self, i: usize) -> f64 {
        let Angles {
            frame,
            coupler,
            output,
            input,
        } = *self.angles;
        [frame, coupler, output, input][i]
    }

    /// Adds (1): the residual of the contour along the axes.
    fn contour(&mut self, [z1, z2, z3]: [f64; 3], length: f64) {
        let open = |of: fn(f64) -> f64| {
            let links = z1 * of(self.turn(1)) + z2 * of(self.turn(2)) + z3 * of(self.turn(3));
            length * (links - of(self.turn(0)))
        };
        let [x, y] = [open(f64::cos), open(f64::sin)];
        self.same("000.(1)", "l₁e₁ + l₂e₂ + l₃e₃ − l₀e₀, x", x);
        self.same("000.(1)", "l₁e₁ + l₂e₂ + l₃e₃ − l₀e₀, y", y);
    }

    /// Adds (3), its least value over z ≥ 0, its derivatives (4), and the products of directions (6).
    fn functional(&mut self, [z1, z2, z3]: [f64; 3]) {
        if let Some(system) = System::new(&[*self.angles]) {
            let least = system.positive_minimum();
            let there = functional(self.angles, least.z);
            self.of("000.lemma", "min J", least.value, there);
        }
        let squares = 1.0 + z1 * z1 + z2 * z2 + z3 * z3;
        let products =
            z1 * z2 * self.dot(1, 2) + z1 * z3 * self.dot(1, 3) + z2 * z3 * self.dot(2, 3);
        let along = z1 * self.dot(0, 1) + z2 * self.dot(0, 2) + z3 * self.dot(0, 3);
        let printed = squares + 2.0 * products - 2.0 * along;
        self.of(
            "000.(3)",
            "J",
            functional(self.angles, [z1, z2, z3]),
            printed,
        );
        for (name, i, j) in [
            ("e₁e₂", 1, 2),
            ("e₁e₃", 1, 3),
            ("e₂e₃", 2, 3),
            ("e₀e₁", 0, 1),
            ("e₀e₂", 0, 2),
            ("e₀e₃", 0, 3),
        ] {
            self.same("000.(6)", name, self.dot(i, j));
        }
        for (name, i) in [("∂J/∂z₁", 1), ("∂J/∂z₂", 2), ("∂J/∂z₃", 3)] {
            let row = z1 * self.dot(i, 1) + z2 * self.dot(i, 2) + z3 * self.dot(i, 3);
            self.same("000.(4)", name, 2.0 * (row - self.dot(0, i)));
        }
    }

    /// Adds the ranks of the system, and the determinants of its subsystems (7) to (9) in z₂ and z₃.
    fn system(&mut self) {
        let [e12, e13, e23] = [self.dot(1, 2), self.dot(1, 3), self.dot(2, 3)];
        if let Some(system) = System::new(&[*self.angles]) {
            for (name, rank) in [("rank A", system.rank), ("rank Ā", system.augmented_rank())] {
                let rank = isize::try_from(rank).unwrap_or_default();
                let collected = Relation::count("000.rank", self.name(name), rank, 2);
                self.all.push(collected);
            }
        }
        self.of(
            "000.subsystems",
            "det(7)",
            self.sin(3, 2).powi(2),
            1.0 - e23 * e23,
        );
        self.of(
            "000.subsystems",
            "det(8)",
            self.sin(1, 2) * self.sin(2, 3),
            e12 * e23 - e13,
        );
        self.of(
            "000.subsystems",
            "det(9)",
            self.sin(1, 3) * self.sin(3, 2),
            e23 * e13 - e12,
        );
    }

    /// Adds (5), (7) to (13), (15), (16), (24), (26) to (28), (31) and (32), with P and Q: formulas for lengths that
    /// close the loop.
    fn closed(&mut self, by: &Subsystem, z1: f64) {
        let [e12, e13, e23] = [self.dot(1, 2), self.dot(1, 3), self.dot(2, 3)];
        let [e01, e02, e03] = [self.dot(0, 1), self.dot(0, 2), self.dot(0, 3)];
        let [[p2, p3], [q2, q3]] = [by.constant, by.slope];
        let [z2, z3] = [p2 + q2 * z1, p3 + q3 * z1];
        let rows = [
            z1 + e12 * z2 + e13 * z3,
            e12 * z1 + z2 + e23 * z3,
            e13 * z1 + e23 * z2 + z3,
        ];
        for (name, row, right) in [
            ("e₀e₁", rows[0], e01),
            ("e₀e₂", rows[1], e02),
            ("e₀e₃", rows[2], e03),
        ] {
            self.of("000.(5)", name, right, row);
        }
        let first = ("e₀e₁ − z₁", e01 - z1, e12 * z2 + e13 * z3);
        let second = ("e₀e₂ − e₁e₂z₁", e02 - e12 * z1, z2 + e23 * z3);
        let third = ("e₀e₃ − e₁e₃z₁", e03 - e13 * z1, e23 * z2 + z3);
        for (item, sides) in [
            ("000.(7)", [second, third]),
            ("000.(8)", [first, second]),
            ("000.(9)", [third, first]),
        ] {
            for (name, value, printed) in sides {
                self.of(item, name, value, printed);
            }
        }
        let [a, b] = [z2 + e23 * z3 - e02, e23 * z2 + z3 - e03];
        self.of("000.(10)", "−e₁e₂z₁", -e12 * z1, a);
        self.of("000.(10)", "−e₁e₃z₁", -e13 * z1, b);
        let across = 1.0 - e23 * e23;
        let eleventh = |between: f64| a * a + b * b - 2.0 * between * a * b;
        self.of("000.(11)", "z₁²(1 − (e₂e₃)²)", eleventh(e23), eleventh(1.0));
        let constant = (z1 * z1 - z2 * z2 - z3 * z3 - 1.0) / (2.0 * z2 * z3);
        if constant.is_finite() {
            self.of("000.(12)", "e₂e₃", e23, e03 * z2 + e02 * z3 - constant);
            self.same("000.(12).Z", "Z", constant);
        }
        for item in ["000.(13)", "000.(24)"] {
            self.of(item, "√(1 − (e₂e₃)²)", self.sin(3, 2).abs(), across.sqrt());
        }
        self.of("000.notation", "P₂", p2, (e02 - e03 * e23) / across);
        self.of("000.notation", "Q₂", q2, self.sin(1, 3) / self.sin(3, 2));
        self.of("000.notation", "P₃", p3, (e03 - e02 * e23) / across);
        self.of("000.notation", "Q₃", q3, self.sin(1, 2) / self.sin(2, 3));
        for (items, name, side, printed) in [
            (
                ["000.(15)", "000.(27)"],
                "(z₂ − P₂) sin(φ₃ − φ₂)",
                (z2 - p2) * self.sin(3, 2),
                -self.sin(1, 3) * z1,
            ),
            (
                ["000.(26)", "000.(28)"],
                "(z₃ − P₃) sin(φ₂ − φ₃)",
                (z3 - p3) * self.sin(2, 3),
                -self.sin(1, 2) * z1,
            ),
        ] {
            for item in items {
                self.of(item, name, side, printed);
            }
        }
        self.of("000.(16)", "z₂", z2, p2 - q2 * z1);
        let printed = [z1, p2 - q2 * z1, p3 - q3 * z1];
        self.of(
            "000.(16)",
            "|z₁e₁ + z₂e₂ + z₃e₃ − e₀|",
            functional(self.angles, [z1, z2, z3]).sqrt(),
            functional(self.angles, printed).sqrt(),
        );
        self.of("000.(26)", "z₃", z3, p3 - q3 * z1);
        for (item, name, [sin, cos], z, i) in [
            (
                "000.(31)",
                "tan φ₃",
                [self.turn(3).sin(), self.turn(3).cos()],
                z2,
                2,
            ),
            (
                "000.(32)",
                "tan φ₂",
                [self.turn(2).sin(), self.turn(2).cos()],
                z3,
                3,
            ),
        ] {
            let part = |of: fn(f64) -> f64| {
                of(self.turn(0)) - z1 * of(self.turn(1)) - z * of(self.turn(i))
            };
            self.of(item, name, sin / cos, part(f64::sin) / part(f64::cos));
        }
    }

    /// Adds (14), (17) to (23), (25), (29) and (30): signs and ranges.
    fn ranges(&mut self, by: &Subsystem, z1: f64) {
        let [[p2, p3], [q2, q3]] = [by.constant, by.slope];
        self.of("000.(17)", "z₂", p2 + q2 * z1, p2 - q2 * z1);
        self.of(
            "000.(18)",
            "|z₂|",
            (p2 + q2 * z1).abs(),
            (p2 - q2 * z1).abs(),
        );
        self.same("000.(18)", "|P₂| + |Q₂z₁|", p2.abs() + (q2 * z1).abs());
        self.of("000.(19).hyp", "Q₂", q2, -q2);
        self.same("000.(19)", "P₂", p2);
        self.same("000.(19)", "z₂", p2 + q2 * z1);
        for item in ["000.(20)", "000.(22)"] {
            self.same(item, "P₂", p2);
            self.of(item, "Q₂", q2, -q2);
        }
        for item in ["000.(14)", "000.(29)"] {
            self.same(item, "P₂Q₂", p2 * q2);
        }
        for item in ["000.(25)", "000.(30)"] {
            self.same(item, "P₃Q₃", p3 * q3);
        }
        if q2 != 0.0 {
            self.same("000.(20).cut", "z₁(z₂ = 0)", -p2 / q2);
        }
        // The range of the case that occurs, if any.
        if p2 >= 0.0 && q2 < 0.0 {
            self.of("000.(21)", "z₁(z₂ = 0)", -p2 / q2, p2 / q2);
        } else if p2 <= 0.0 && q2 > 0.0 {
            self.of("000.(23)", "z₁(z₂ = 0)", -p2 / q2, p2 / q2);
        }
    }

    /// Adds three things: relations (33) to (38); the pair of ratios that theorem 5 omits; and the angle δ₊ − δ₋
    /// ([`opening`]).
    fn cases(&mut self) {
        let [second, third] = [self.sin(3, 1), self.sin(2, 1)];
        if second != 0.0 {
            for item in ["000.(33)", "000.(34)", "000.(35)"] {
                self.same(item, "sin(φ₀ − φ₃)/sin(φ₃ − φ₁)", self.sin(0, 3) / second);
                self.same(item, "sin(φ₃ − φ₂)/sin(φ₃ − φ₁)", self.sin(3, 2) / second);
            }
        }
        if third != 0.0 {
            for item in ["000.(36)", "000.(37)", "000.(38)"] {
                self.same(item, "sin(φ₂ − φ₃)/sin(φ₂ − φ₁)", self.sin(2, 3) / third);
                self.same(item, "sin(φ₀ − φ₂)/sin(φ₂ − φ₁)", self.sin(0, 2) / third);
            }
        }
        if let Some(pair) = third_pair(self.angles) {
            self.same("000.T5", "sin(φ₁ − φ₀)/sin(φ₂ − φ₁)", pair.values[0]);
            self.same("000.T5", "sin(φ₃ − φ₁)/sin(φ₂ − φ₁)", pair.values[1]);
        }
        if let Some(opening) = opening(self.angles) {
            self.angle("000.truth", "δ₊ − δ₋", opening);
        }
    }
}
