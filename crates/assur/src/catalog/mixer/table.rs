//! The table of a mixer's motion.

use super::quantity::coordinates;
use super::{Mixer, Quantity, Tracked, Turning};
use crate::motion::sweep::{Column, Swept};
use crate::{Cycle, Jet, Unsolved};

/// Value, first and second derivative.
const ORDERS: [usize; 3] = [0, 1, 2];

impl Swept for Mixer {
    type Quantity = Quantity;

    fn cycle(&self) -> Cycle {
        self.linkage.cycle()
    }

    fn jets<const N: usize>(
        &self,
        quantities: &[Quantity],
        crank: f64,
    ) -> Result<Vec<Jet<N>>, Unsolved> {
        self.jets(quantities, crank)
    }
}

impl Mixer {
    /// The columns of its table: the angle of the crank and of all that it turns,
    /// then the places of the joints A to D and of what else is tracked, each
    /// with two derivatives.
    pub fn columns(&self) -> Vec<Column<Quantity>> {
        let mut turning = vec![Turning::Crank];
        turning.extend(self.turning());
        let mut points = vec![Tracked::A, Tracked::B, Tracked::C, Tracked::D];
        for point in self.tracked() {
            if !points.contains(&point) {
                points.push(point);
            }
        }
        let mut columns = Vec::new();
        for turning in turning {
            for order in ORDERS {
                let quantity = Quantity::Angle(turning);
                columns.push(Column { quantity, order });
            }
        }
        for point in points {
            for order in ORDERS {
                for quantity in coordinates(point) {
                    columns.push(Column { quantity, order });
                }
            }
        }
        columns
    }
}

impl Column<Quantity> {
    /// The name in tables: `rocker.angle`, `rocker.dangle`, `C2.ddx`.
    pub fn name(self) -> String {
        let mut name = self.quantity.name();
        let what = name.find('.').map_or(0, |dot| dot + 1);
        name.insert_str(what, &"d".repeat(self.order));
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::mixer::{Carrier, Case, Tracer};
    use crate::gears::Mate;
    use crate::motion::sweep::{Row, sweep};

    fn rows(lengths: [f64; 4], steps: u32) -> (Vec<String>, Vec<Row>) {
        let mut dimensions = Case::A.dimensions();
        dimensions.lengths = lengths;
        let mixer = Mixer::new(&dimensions).unwrap();
        let columns = mixer.columns();
        let names = columns.iter().map(|column| column.name()).collect();
        (names, sweep(&mixer, &columns, steps))
    }

    #[test]
    fn columns_have_the_names_of_tables() {
        let (names, _) = rows([0.37, 0.85, 0.55, 0.85], 1);
        let links = ["crank", "coupler", "rocker", "wheel5"];
        let links = links.map(|link| ["angle", "dangle", "ddangle"].map(|what| (link, what)));
        let points = ["A", "B", "C", "D", "C1", "C2", "C3"];
        let points =
            points.map(|point| ["x", "y", "dx", "dy", "ddx", "ddy"].map(|what| (point, what)));
        let expected = links.as_flattened().iter().chain(points.as_flattened());
        let expected: Vec<String> = expected.map(|(of, what)| format!("{of}.{what}")).collect();
        assert_eq!(names, expected);
    }

    /// Each wheel and each traced point has its columns.
    #[test]
    fn wheels_and_traced_points_are_in_the_table() {
        let mut dimensions = Case::A.dimensions();
        dimensions.wheels.push(Mate {
            teeth: 24.0,
            centre_line: 2.0,
        });
        dimensions.tracers.push(Tracer {
            carrier: Carrier::Coupler,
            x: 0.425,
            y: 0.0,
        });
        let mixer = Mixer::new(&dimensions).unwrap();
        let columns = mixer.columns();
        let row = &sweep(&mixer, &columns, 36)[7];
        let value = |name: &str| {
            let column = columns.iter().position(|column| column.name() == name);
            row.values[column.unwrap()].unwrap()
        };
        // u = −36 / 24, and P₁ is the middle of the coupler.
        let off = value("wheel6.ddangle") + 1.5 * value("rocker.ddangle");
        assert!(off.abs() < 1e-14, "{off:e}");
        for what in ["x", "y", "dx", "dy", "ddx", "ddy"] {
            let [traced, middle] = ["P1", "C2"].map(|point| value(&format!("{point}.{what}")));
            assert!((traced - middle).abs() < 1e-14, "{what}");
        }
        assert_eq!(columns.len(), 3 * (5 + 2 * 8));
    }

    #[test]
    fn a_full_turn_has_every_value() {
        for (lengths, turns) in [([0.37, 0.85, 0.55, 0.85], 1), ([1.0, 3.0, 2.0, 4.0], 2)] {
            let (names, rows) = rows(lengths, 720);
            assert_eq!(rows.len(), 720 * turns + 1);
            for (step, row) in rows.iter().enumerate() {
                assert_eq!(row.step as usize, step);
                let degrees = row.crank.to_degrees();
                assert!((degrees - 0.5 * step as f64).abs() < 1e-12 * (1.0 + degrees));
                assert_eq!(row.values.len(), names.len());
                assert!(row.values.iter().all(Option::is_some), "{row:?}");
                assert_eq!(row.reason, None);
                assert_eq!(row.values[0], Some(row.crank));
            }
            // The end is the beginning, whole turns of the angles aside.
            let [first, .., last] = &rows[..] else {
                panic!("rows")
            };
            let pairs = names.iter().zip(first.values.iter().zip(&last.values));
            for (name, (first, last)) in pairs {
                let (first, last) = (first.unwrap(), last.unwrap());
                let apart = if name.ends_with(".angle") {
                    let turns = (last - first) / std::f64::consts::TAU;
                    turns - turns.round()
                } else {
                    last - first
                };
                assert!(apart.abs() < 1e-9, "{name}: {first} {last}");
            }
        }
    }

    /// l₂ + l₃ just spans BD where φ₁ is a right angle.
    #[test]
    fn a_dead_point_has_places_without_derivatives() {
        let (names, rows) = rows([3.0, 2.0, 3.0, 4.0], 360);
        assert_eq!(rows.len(), 361);
        for (step, row) in rows.iter().enumerate() {
            let has = |order: usize| {
                let of = names.iter().zip(&row.values);
                let mut of = of.filter(|(name, _)| {
                    let what = name.split_once('.').unwrap().1;
                    what.chars().filter(|c| *c == 'd').count() == order
                });
                let some = of.clone().all(|(_, value)| value.is_some());
                assert!(some || of.all(|(_, value)| value.is_none()), "{row:?}");
                some
            };
            let expected = match step {
                90 | 270 => [true, false, false],
                91..270 => [false; 3],
                _ => [true; 3],
            };
            assert_eq!([0, 1, 2].map(has), expected, "{row:?}");
            match (step, row.reason) {
                (90 | 270, Some(Unsolved::DeadPoint { .. })) => {}
                (91..270, Some(Unsolved::Apart { by, .. })) => assert!(by > 0.0),
                (_, None) if expected[2] => {}
                _ => panic!("{row:?}"),
            }
        }
        // C lies between B = (0, 3) and D = (4, 0), two from B.
        let column = |name: &str| names.iter().position(|other| other == name).unwrap();
        let [x, y] = ["C.x", "C.y"].map(|name| rows[90].values[column(name)].unwrap());
        assert!((x - 1.6).abs() < 1e-7 && (y - 1.8).abs() < 1e-7, "{x} {y}");
    }

    #[test]
    fn there_is_a_step_at_least() {
        let (_, rows) = rows([0.37, 0.85, 0.55, 0.85], 0);
        assert_eq!(rows.len(), 2);
    }
}
