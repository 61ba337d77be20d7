//! Inputs of the rows of a table: a grid over the range of a motion, with both its ends.

use super::Motion;
use crate::tolerance;

/// The input of a row, in two units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct At {
    /// Input in the unit of the table, such as degrees.
    pub counted: f64,
    /// Input in the engine's unit: radians of a crank, or the unit of lengths.
    pub input: f64,
}

/// Inputs at whole steps from an origin.
///
/// ```
/// use assur::mixer::{Case, Mixer};
/// use assur::motion::Grid;
/// let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
/// let degrees = Grid { unit: 1f64.to_radians(), origin: 0.0, step: 30.0 };
/// assert_eq!(motion.rows(degrees).count(), 13); // 0° to 360°
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// Unit of the table, expressed in the engine's unit: π/180 for degrees.
    pub unit: f64,
    /// Origin of the steps, in the unit of the table.
    pub origin: f64,
    /// Step, positive, in the unit of the table.
    pub step: f64,
}

impl At {
    /// An input given in the unit of the table.
    pub fn counted(counted: f64, unit: f64) -> Self {
        let input = counted * unit;
        Self { counted, input }
    }

    /// An input given in the engine's unit.
    pub fn of(input: f64, unit: f64) -> Self {
        let counted = decimal(input / unit);
        Self { counted, input }
    }
}

impl Motion {
    /// The arcs of the motion, ascending, in the given unit.
    pub fn arcs_in(&self, unit: f64) -> Vec<[At; 2]> {
        let arcs = self.cycle.arcs().iter();
        arcs.map(|arc| arc.map(|end| At::of(end, unit))).collect()
    }

    /// The inputs at which the motion turns back, ascending, in the given unit.
    pub fn ends_in(&self, unit: f64) -> Vec<At> {
        let turns_back = !self.cycle.is_full();
        let arcs = self.arcs_in(unit).into_iter().filter(|_| turns_back);
        arcs.flatten().collect()
    }

    /// Inputs of a grid over the whole motion, including the inputs at which the motion turns back.
    pub fn rows(&self, grid: Grid) -> impl Iterator<Item = At> + use<> {
        let ends = self.ends_in(grid.unit);
        let arcs = self.arcs_in(grid.unit).into_iter();
        arcs.flat_map(move |arc| grid.rows(arc, &ends))
    }
}

impl Grid {
    /// Inputs of the grid within an arc, and the ends within the arc, ascending. If a grid point and an end coincide,
    /// only the end is kept.
    pub fn rows(self, [first, last]: [At; 2], ends: &[At]) -> impl Iterator<Item = At> + use<> {
        let Self { unit, origin, step } = self;
        let within = |end: &&At| (first.input..=last.input).contains(&end.input);
        let ends: Vec<At> = ends.iter().filter(within).copied().collect();
        let index = |at: At| (at.counted - origin) / step;
        let [low, high] = [
            (index(first) - tolerance::COINCIDENT).ceil(),
            (index(last) + tolerance::COINCIDENT).floor(),
        ];
        let count = (high - low + 1.0).max(0.0) as u64;
        let ends_at: Vec<f64> = ends.iter().map(|end| index(*end)).collect();
        let coincide = |end: f64, k: f64| (end - k).abs() <= tolerance::COINCIDENT;
        let rows = (0..count).map(move |k| low + k as f64);
        let rows = rows.filter(move |k| !ends_at.iter().any(|end| coincide(*end, *k)));
        let rows = rows.map(move |k| {
            let At { counted, input } = At::counted(decimal(origin + decimal(k * step)), unit);
            At {
                counted: counted.max(first.counted).min(last.counted),
                input: input.max(first.input).min(last.input),
            }
        });
        merged(rows, ends)
    }
}

fn merged(rows: impl Iterator<Item = At>, ends: Vec<At>) -> impl Iterator<Item = At> {
    let mut rows = rows.peekable();
    let mut ends = ends.into_iter().peekable();
    std::iter::from_fn(move || match (rows.peek(), ends.peek()) {
        (Some(row), Some(end)) if row.input < end.input => rows.next(),
        (_, Some(_)) => ends.next(),
        (_, None) => rows.next(),
    })
}

/// Removes the rounding error from a multiple of a decimal step: 3 × 0.1 gives 0.3.
fn decimal(value: f64) -> f64 {
    let rounded = (value * 1e9).round() / 1e9;
    if (rounded - value).abs() <= tolerance::CONVERGED * value.abs() {
        rounded
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_of_decimal_steps_have_no_rounding() {
        assert_eq!(decimal(3.0 * 0.1), 0.3);
        assert_eq!(decimal(89.99999999999999), 90.0);
        assert_eq!(decimal(89.999999999), 89.999999999);
    }

    #[test]
    fn a_grid_with_its_ends() {
        let grid = |origin, step| Grid {
            unit: 1.0,
            origin,
            step,
        };
        let rows = |grid: Grid, from, to, ends: &[f64]| -> Vec<f64> {
            let at = |input: &f64| At::of(*input, 1.0);
            let ends: Vec<At> = ends.iter().map(at).collect();
            let rows = grid.rows([at(&from), at(&to)], &ends);
            rows.map(|at| at.input).collect()
        };
        let none: &[f64] = &[];
        assert_eq!(rows(grid(0.0, 7.0), 0.0, 20.0, none), [0.0, 7.0, 14.0]);
        assert_eq!(
            rows(grid(0.0, 10.0), -12.5, 15.0, &[-12.5, 15.0]),
            [-12.5, -10.0, 0.0, 10.0, 15.0]
        );
        // An end on the grid gives one row, with the exact input of the end.
        let near = 20.0 - 1e-12;
        assert_eq!(
            rows(grid(0.0, 10.0), 0.0, near, &[0.0, near]),
            [0.0, 10.0, near]
        );
        // Ends outside the arc are dropped; ends inside it are rows.
        assert_eq!(
            rows(grid(1.5, 1.0), 1.5, 4.0, &[-3.0, 2.25, 5.0]),
            [1.5, 2.25, 2.5, 3.5]
        );
        assert_eq!(rows(grid(0.0, 10.0), 11.0, 19.0, none), none);
    }
}
