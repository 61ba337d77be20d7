//! Plots of quantities and their first two derivatives, stacked over one input axis, drawn on any plotters backend.
//!
//! plotters draws lines and dots only. Tick labels, titles and the labels of zeros and extrema are left to the caller,
//! at the positions given by each [`Panel`]. (To measure text, plotters would insert elements into the page; and the
//! decimal sign depends on the user's language.)

mod against;
mod compared;
mod curves;
mod panel;
mod ticks;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use assur::Cycle;
use assur::motion::{Features, InputRate};

use crate::list::{ROLES, Role};
pub use against::{Against, Axis, Field, Passed};
pub use curves::{At, Mark, MarkKind, Sample};
use curves::{Plot, Range};
pub(crate) use curves::{sampled, sampling};
pub use ticks::Tick;

/// Units of the backend's integer coordinates per screen pixel; a curve in whole pixels would look stepped.
pub const FINE: i32 = 16;

/// Room around the plots for tick labels and titles, pixels.
const MARGIN: Margin = Margin {
    left: 44,
    top: 26,
    right: 10,
    bottom: 22,
};

/// Maximum length of a shortened axis, as a share of the full axis. An axis that would be longer is not shortened.
const MOST_OF_A_TURN: f64 = 0.8;
/// Minimum length of a shortened axis, as a share of the full axis: the range of a motion can be almost zero.
const LEAST_OF_A_TURN: f64 = 0.001;
/// Margin at both ends of a shortened axis, as a share of the motion's span.
const BESIDE: f64 = 0.04;

struct Margin {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Margin {
    fn scaled(&self, scale: f64) -> Self {
        let [left, top, right, bottom] = [self.left, self.top, self.right, self.bottom]
            .map(|pixels| (f64::from(pixels) * scale).round() as i32);
        Self {
            left,
            top,
            right,
            bottom,
        }
    }
}

/// A colour for every role, in the order of [`ROLES`].
pub type Palette = [RGBColor; ROLES.len()];

/// Kind of the quantities of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Angles, in radians; the axis of values is labelled in degrees.
    Angle,
    /// Lengths.
    Length,
    /// Forces, which have no derivatives.
    Force,
    /// Torques, which have no derivatives.
    Torque,
}

impl Kind {
    /// Whether derivatives are plotted, too.
    pub fn has_derivatives(self) -> bool {
        matches!(self, Self::Angle | Self::Length)
    }
}

/// A plotted quantity.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name of the quantity.
    pub name: String,
    /// Role whose colour the curves have.
    pub role: Role,
    /// Zeros and extrema of the quantity and of its first two derivatives; none if they were not searched for.
    pub features: Option<[Features; 3]>,
}

/// Settings of a plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Speed and acceleration of the input, which turn analogues into derivatives with respect to time.
    pub input: InputRate,
    /// Whether derivatives are with respect to time, at the rate `input`; otherwise they are with respect to the input.
    pub physical: bool,
    /// Whether difference quotients of the first derivative are plotted on top of the second derivative.
    pub differenced: bool,
}

impl Settings {
    /// Settings for a motion given over time.
    pub const BY_TIME: Self = Self {
        input: InputRate::ANALOGUES,
        physical: true,
        differenced: false,
    };
}

/// A plot: its rectangle, in screen pixels, and the ranges of its axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Order of the derivative: 0 for the quantity itself.
    pub order: usize,
    /// Left edge of the plot rectangle.
    pub left: f64,
    /// Upper edge of the plot rectangle.
    pub top: f64,
    /// Width of the plot rectangle.
    pub width: f64,
    /// Height of the plot rectangle.
    pub height: f64,
    /// Inputs at the left and the right edge; angles are in radians.
    pub x: [f64; 2],
    /// Values at the lower and the upper edge.
    pub y: [f64; 2],
    /// Ticks of the x axis; angles are in degrees.
    pub x_ticks: Vec<Tick>,
    /// Ticks of the y axis; angles are in degrees.
    pub y_ticks: Vec<Tick>,
    /// Marks of each curve, in the order of the series.
    pub marks: Vec<Vec<Mark>>,
    /// Values of constant curves, in the order of the series; none for other curves.
    pub levels: Vec<Option<f64>>,
    /// Points a few pixels apart along the curves, which labels must not cover: x, y, x, y, …, screen pixels.
    pub points: Vec<f64>,
}

/// A chart ready to be drawn. Its curves are sampled once, when the chart is made.
#[derive(Clone, Debug)]
pub struct Chart {
    axis: [f64; 2],
    /// Whether the input is an angle; otherwise it is a length or a time.
    turns: bool,
    kind: Kind,
    settings: Settings,
    series: Vec<Series>,
    /// Plots of the derivatives of orders 0, 1 and 2.
    plots: [Plot; 3],
}

impl Chart {
    /// Makes the chart of quantities of one kind over a cycle. Each of `runs` is a list of samples without a gap, with
    /// quantities in the order of `series`.
    pub fn new(
        cycle: &Cycle,
        kind: Kind,
        series: Vec<Series>,
        runs: &[Vec<At>],
        settings: Settings,
    ) -> Self {
        Self {
            axis: panel::axis(cycle),
            turns: cycle.turns(),
            kind,
            settings,
            plots: curves::plots(runs, cycle.is_full(), &series, settings),
            series,
        }
    }

    /// Makes the chart of quantities of one kind over a span of time, from samples with time derivatives.
    pub fn by_time(span: [f64; 2], kind: Kind, series: Vec<Series>, samples: Vec<At>) -> Self {
        let settings = Settings::BY_TIME;
        Self {
            axis: span,
            turns: false,
            kind,
            settings,
            plots: curves::plots(&[samples], true, &series, settings),
            series,
        }
    }

    /// Whether the input is an angle, labelled in degrees; otherwise it is a length or a time.
    pub fn turns(&self) -> bool {
        self.turns
    }

    /// Returns the kind of the quantities.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Returns the settings of the plots.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// Returns the quantities.
    pub fn series(&self) -> &[Series] {
        &self.series
    }

    /// Draws the chart on an area with [`FINE`] units per pixel, and returns its panels with the positions of texts.
    /// Margins, lines and dots are `scale` times as large as usual. The plot of the derivative of order `only`, if
    /// given, fills the area.
    ///
    /// # Errors
    /// Errors of the backend. An area too small for a plot is left empty, and no panels are returned.
    pub fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        palette: &Palette,
        scale: f64,
        only: Option<usize>,
    ) -> Result<Vec<Panel>, DrawingAreaErrorKind<B::ErrorType>> {
        let panels = self.panels(area.dim_in_pixel(), scale, only);
        for panel in &panels {
            self.draw_panel(area, panel, palette, scale)?;
        }
        Ok(panels)
    }

    /// Lays out the panels in an area. Returns none if the area is too small.
    fn panels(&self, (width, height): (u32, u32), scale: f64, only: Option<usize>) -> Vec<Panel> {
        let only = if self.kind.has_derivatives() {
            only
        } else {
            Some(0)
        };
        let plots = self.plots.iter().enumerate();
        let plots = plots.filter(|(order, _)| only.is_none_or(|only| only == *order));
        let plots: Vec<(usize, &Plot)> = plots.collect();
        let [width, height] = [width, height].map(|fine| (fine as i32 / FINE).max(0));
        let margin = MARGIN.scaled(scale);
        let inner = width - margin.left - margin.right;
        let count = plots.len().max(1) as i32;
        let each = (height - margin.bottom) / count - margin.top;
        if inner < 20 || each < 20 {
            return Vec::new();
        }
        let panel = |(at, (order, plot)): (usize, (usize, &Plot))| {
            let Range { min, max } = plot.range;
            let mut panel = Panel {
                order,
                left: f64::from(margin.left),
                top: f64::from(margin.top + at as i32 * (margin.top + each)),
                width: f64::from(inner),
                height: f64::from(each),
                x: self.axis,
                y: [min, max],
                x_ticks: if self.turns {
                    ticks::crank(self.axis, f64::from(inner), scale)
                } else {
                    ticks::way(self.axis, f64::from(inner), scale)
                },
                y_ticks: ticks::values(plot.range, self.in_degrees(order), f64::from(each), scale),
                marks: plot.curves.iter().map(|c| c.marks(min, max)).collect(),
                levels: self
                    .series
                    .iter()
                    .map(|s| {
                        s.features
                            .as_ref()
                            .and_then(|features| features[order].level)
                    })
                    .collect(),
                points: Vec::new(),
            };
            panel.points = panel.along(plot);
            panel
        };
        plots.into_iter().enumerate().map(panel).collect()
    }

    /// Whether the values of the derivative of this order are labelled in degrees.
    fn in_degrees(&self, order: usize) -> bool {
        order == 0 && self.kind == Kind::Angle
    }

    fn draw_panel<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        panel: &Panel,
        palette: &Palette,
        scale: f64,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let plot = &self.plots[panel.order];
        let fine = |pixels: f64| pixels as i32 * FINE;
        let (left, top) = (fine(panel.left), fine(panel.top));
        let (right, bottom) = (left + fine(panel.width), top + fine(panel.height));
        let ([x0, x1], [y0, y1]) = (panel.x, panel.y);
        // The y axis points upwards: values increase from the bottom pixel to the top one.
        let area = area.apply_coord_spec(Place::new(x0..x1, y0..y1, (left..right, bottom..top)));
        let mut lines: Vec<Line> = Vec::new();
        for tick in &panel.x_ticks {
            let x = if self.turns {
                tick.value.to_radians()
            } else {
                tick.value
            };
            lines.push((vec![(x, y0), (x, y1)], Role::Line, FINE));
        }
        for tick in &panel.y_ticks {
            let y = if self.in_degrees(panel.order) {
                tick.value.to_radians()
            } else {
                tick.value
            };
            lines.push((vec![(x0, y), (x1, y)], Role::Line, FINE));
        }
        if y0 < 0.0 && y1 > 0.0 {
            lines.push((vec![(x0, 0.0), (x1, 0.0)], Role::Secondary, FINE));
        }
        // Extrema are filled dots, zeros are open dots, difference quotients are small dots.
        let mut dots: Vec<Dot> = Vec::new();
        for (curve, series) in plot.curves.iter().zip(&self.series) {
            let dashes = curve.compared_within(y0, y1).into_iter();
            let dashes = dashes.flat_map(|run| compared::dashed(&run, panel.to_pixels(), scale));
            lines.extend(dashes.map(|dash| (dash, series.role, FINE)));
            let runs = curve.within(y0, y1).into_iter();
            lines.extend(runs.map(|run| (run, series.role, 2 * FINE)));
            for mark in curve.marks(y0, y1) {
                let at = (mark.crank, mark.value);
                dots.push((at, series.role, 3 * FINE));
                if mark.kind == MarkKind::Zero {
                    dots.push((at, Role::Paper, 3 * FINE / 2));
                }
            }
            let shown = curve.differences.iter();
            let shown = shown.filter(|(_, y)| (y0..=y1).contains(y));
            dots.extend(shown.map(|at| (*at, Role::Ink, 3 * FINE / 2)));
        }
        paint(&area, lines, dots, palette, scale)
    }
}

/// Draws lines, then dots over them.
fn paint<B: DrawingBackend>(
    area: &DrawingArea<B, Place>,
    lines: Vec<Line>,
    dots: Vec<Dot>,
    palette: &Palette,
    scale: f64,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let scaled = |size: i32| (f64::from(size) * scale) as i32;
    for (points, role, width) in lines {
        let style = palette[role as usize].stroke_width(scaled(width).unsigned_abs());
        area.draw(&PathElement::new(points, style))?;
    }
    for (at, role, radius) in dots {
        let style = palette[role as usize].filled();
        area.draw(&Circle::new(at, scaled(radius), style))?;
    }
    Ok(())
}

type Place = Cartesian2d<RangedCoordf64, RangedCoordf64>;

/// A line: its points, colour and width.
type Line = (Vec<(f64, f64)>, Role, i32);
/// A dot: its position, colour and radius.
type Dot = ((f64, f64), Role, i32);

#[cfg(test)]
mod tests;
