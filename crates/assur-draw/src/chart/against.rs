//! A plot of one quantity or derivative against another: the path of a point, its hodograph, a phase portrait.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::compared::dashed;
use super::curves::{Range, range, told};
use super::{At, FINE, Kind, MARGIN, Palette, Place, Settings, Tick, paint, ticks};
use crate::list::Role;

/// Height of an additional line of text below the axis.
const LINE: f64 = 16.0;

/// Quantity or derivative shown on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of the quantity; none for the input.
    pub name: Option<String>,
    /// Kind of the quantity.
    pub kind: Kind,
    /// Order of the derivative, 0 for the quantity itself.
    pub order: usize,
}

impl Axis {
    fn in_degrees(&self) -> bool {
        self.kind == Kind::Angle && self.order == 0
    }
}

/// Plot of one quantity against another over a motion, sampled once, when the plot is made.
#[derive(Clone, Debug)]
pub struct Against {
    pub(super) axes: [Axis; 2],
    role: Role,
    settings: Settings,
    pub(super) ranges: [Range; 2],
    /// Points of the curve, one list for each unbroken arc of the motion.
    pub(super) runs: Vec<Vec<Passed>>,
    /// Points of the curve of the compared motion, one list for each unbroken arc.
    pub(super) compared: Vec<Vec<Passed>>,
}

/// A point of the curve, with its input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passed {
    /// Value of the input.
    pub input: f64,
    /// Abscissa and ordinate.
    pub at: [f64; 2],
}

/// Layout of a plot of one quantity against another, in screen pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Left edge of the plot rectangle.
    pub left: f64,
    /// Upper edge of the plot rectangle.
    pub top: f64,
    /// Width of the plot rectangle.
    pub width: f64,
    /// Height of the plot rectangle.
    pub height: f64,
    /// Least and greatest value on each axis.
    pub spans: [[f64; 2]; 2],
    /// Ticks of each axis; angles are in degrees.
    pub ticks: [Vec<Tick>; 2],
    /// Visible parts of the curve, in screen pixels.
    pub curve: Vec<Vec<Passed>>,
}

impl Against {
    /// Makes the plot of two sampled quantities, abscissa and ordinate. If `full`, the motion has no dead points, at
    /// which derivatives would be unbounded.
    pub fn new(
        axes: [Axis; 2],
        role: Role,
        runs: &[Vec<At>],
        full: bool,
        settings: Settings,
    ) -> Self {
        let steepest = axes.iter().map(|axis| axis.order).max().unwrap_or(0);
        let passed = |(input, sample): &At| Passed {
            input: *input,
            at: [0, 1].map(|k: usize| settings.input.rate(&sample.jets[k], axes[k].order)),
        };
        let shown = runs.iter().flatten();
        let shown = shown.filter(|at| steepest == 0 || full || at.1.clear);
        let shown: Vec<Passed> = shown.map(passed).collect();
        let runs = runs.iter();
        let runs = runs.map(|run| run[told(run, steepest, full)].iter().map(passed).collect());
        Self {
            ranges: [0, 1].map(|k| range(shown.iter().map(|one| one.at[k]))),
            runs: runs.collect(),
            compared: Vec::new(),
            axes,
            role,
            settings,
        }
    }

    /// Returns the axes of abscissa and ordinate.
    pub fn axes(&self) -> &[Axis; 2] {
        &self.axes
    }

    /// Returns the role that gives the curve its colour.
    pub fn role(&self) -> Role {
        self.role
    }

    /// Settings with which the plot was made.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// Draws the plot on an area with [`FINE`] units per pixel, and returns its layout, or none if
    /// the area is too small. Lines are `scale` times as thick as usual.
    ///
    /// # Errors
    /// Errors of the backend.
    pub fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        palette: &Palette,
        scale: f64,
    ) -> Result<Option<Field>, DrawingAreaErrorKind<B::ErrorType>> {
        let Some(field) = self.field(area.dim_in_pixel(), scale) else {
            return Ok(None);
        };
        let fine = |pixels: f64| pixels as i32 * FINE;
        let (left, top) = (fine(field.left), fine(field.top));
        let (right, bottom) = (left + fine(field.width), top + fine(field.height));
        let [[x0, x1], [y0, y1]] = field.spans;
        let area = area.apply_coord_spec(Place::new(x0..x1, y0..y1, (left..right, bottom..top)));
        let mut lines = Vec::new();
        for (k, ticks) in field.ticks.iter().enumerate() {
            for tick in ticks {
                let degrees = self.axes[k].in_degrees();
                let value = if degrees {
                    tick.value.to_radians()
                } else {
                    tick.value
                };
                lines.push((across(k, value, field.spans), Role::Line, FINE));
            }
        }
        for (k, [from, to]) in field.spans.into_iter().enumerate() {
            if from < 0.0 && to > 0.0 {
                lines.push((across(k, 0.0, field.spans), Role::Secondary, FINE));
            }
        }
        let seen = |runs: &[Vec<Passed>]| {
            let runs = runs.iter().flat_map(|run| within(run, field.spans));
            let places = |run: Vec<Passed>| run.iter().map(|one| (one.at[0], one.at[1])).collect();
            runs.map(places).collect::<Vec<Vec<(f64, f64)>>>()
        };
        let to_pixels = [field.width / (x1 - x0), field.height / (y1 - y0)];
        for run in seen(&self.compared) {
            let dashes = dashed(&run, to_pixels, scale).into_iter();
            lines.extend(dashes.map(|dash| (dash, self.role, FINE)));
        }
        let curve = seen(&self.runs).into_iter();
        lines.extend(curve.map(|run| (run, self.role, 2 * FINE)));
        paint(&area, lines, Vec::new(), palette, scale)?;
        Ok(Some(field))
    }

    fn field(&self, (width, height): (u32, u32), scale: f64) -> Option<Field> {
        let [width, height] = [width, height].map(|fine| (fine as i32 / FINE).max(0));
        let margin = MARGIN.scaled(scale);
        let line = (LINE * scale).round() as i32;
        let width = width - margin.left - margin.right;
        let height = height - margin.top - margin.bottom - line;
        if width < 20 || height < 20 {
            return None;
        }
        let (width, height) = (f64::from(width), f64::from(height));
        let ranges = self.fitted([width, height]);
        let [x, y] = ranges;
        let [of_x, of_y] = self.axes.each_ref().map(Axis::in_degrees);
        let mut field = Field {
            left: f64::from(margin.left),
            top: f64::from(margin.top),
            width,
            height,
            spans: ranges.map(|range| [range.min, range.max]),
            ticks: [
                ticks::abscissae(x, of_x, width, scale),
                ticks::values(y, of_y, height, scale),
            ],
            curve: Vec::new(),
        };
        let runs = self.runs.iter().flat_map(|run| within(run, field.spans));
        let runs = runs.map(|run| run.into_iter().map(|one| field.placed(one)).collect());
        field.curve = runs.collect();
        Some(field)
    }

    /// Returns the ranges of the axes. Both scales are equal if both axes show forces, or lengths, or derivatives of
    /// lengths of the same order.
    fn fitted(&self, size: [f64; 2]) -> [Range; 2] {
        let [x, y] = &self.axes;
        let vector = matches!(x.kind, Kind::Length | Kind::Force);
        let alike = x.order == y.order && x.kind == y.kind && vector;
        if !alike {
            return self.ranges;
        }
        let spans = self.ranges.map(|range| range.max - range.min);
        let to_pixel = (spans[0] / size[0]).max(spans[1] / size[1]);
        [0, 1].map(|k: usize| {
            let room = 0.5 * (to_pixel * size[k] - spans[k]);
            let Range { min, max } = self.ranges[k];
            Range {
                min: min - room,
                max: max + room,
            }
        })
    }
}

impl Field {
    /// Converts a point of the curve to screen pixels.
    fn placed(&self, Passed { input, at }: Passed) -> Passed {
        let [[x0, x1], [y0, y1]] = self.spans;
        Passed {
            input,
            at: [
                self.left + self.width * (at[0] - x0) / (x1 - x0),
                self.top + self.height * (y1 - at[1]) / (y1 - y0),
            ],
        }
    }
}

/// Returns the ends of the line across the plot at a value on an axis (0: abscissa, 1: ordinate).
fn across(axis: usize, value: f64, [[x0, x1], [y0, y1]]: [[f64; 2]; 2]) -> Vec<(f64, f64)> {
    if axis == 0 {
        vec![(value, y0), (value, y1)]
    } else {
        vec![(x0, value), (x1, value)]
    }
}

/// Returns the parts of a run of points that are within the ranges of the axes.
fn within(run: &[Passed], spans: [[f64; 2]; 2]) -> Vec<Vec<Passed>> {
    let mut seen: Vec<Vec<Passed>> = Vec::new();
    let mut part: Vec<Passed> = Vec::new();
    for pair in run.windows(2) {
        let Some([from, to]) = clipped([pair[0], pair[1]], spans) else {
            seen.push(std::mem::take(&mut part));
            continue;
        };
        // A curve that re-enters the plot begins a new part.
        if part.last() != Some(&from) {
            seen.push(std::mem::take(&mut part));
            part.push(from);
        }
        part.push(to);
    }
    seen.push(part);
    seen.retain(|part| part.len() > 1);
    seen
}

/// Clips a segment to the ranges of the axes (parametric clipping of Liang and Barsky, 1984).
fn clipped([a, b]: [Passed; 2], spans: [[f64; 2]; 2]) -> Option<[Passed; 2]> {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for (k, [min, max]) in spans.into_iter().enumerate() {
        let way = b.at[k] - a.at[k];
        if way == 0.0 {
            if !(min..=max).contains(&a.at[k]) {
                return None;
            }
            continue;
        }
        let [one, other] = [min, max].map(|bound| (bound - a.at[k]) / way);
        first = first.max(one.min(other));
        last = last.min(one.max(other));
    }
    let between = |share: f64| match share {
        0.0 => a,
        1.0 => b,
        _ => Passed {
            input: a.input + share * (b.input - a.input),
            at: [0, 1].map(|k: usize| a.at[k] + share * (b.at[k] - a.at[k])),
        },
    };
    (first <= last).then(|| [between(first), between(last)])
}

#[cfg(test)]
mod tests;
