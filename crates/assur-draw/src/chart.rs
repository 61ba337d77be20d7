//! Plots of quantities and of their first two derivatives, stacked on one
//! crank-angle axis, drawn by plotters on any backend.
//!
//! plotters draws lines and dots only. Tick labels, titles and the labels of
//! zeros and extrema are the caller's: each [`Panel`] says where they stand
//! (plotters' own text measuring inserts elements into the page, and the decimal
//! sign is the reader's).

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

/// Units of a backend's whole-numbered coordinates to a pixel of the reader:
/// whole pixels would make steps of a curve.
pub const FINE: i32 = 16;

/// Room around the plots for tick labels and titles, pixels.
const MARGIN: Margin = Margin {
    left: 44,
    top: 26,
    right: 10,
    bottom: 22,
};

/// An axis is not cut to the arcs of a motion where these are a greater share of it: a turn is recognised at once.
const MOST_OF_A_TURN: f64 = 0.8;
/// Nor where they are a lesser one: of some motions only an instant is left.
const LEAST_OF_A_TURN: f64 = 0.001;
/// Room beside the arcs, as a share of what they span.
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

/// What the quantities of a chart are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Angles, in radians; the values' axis is labelled in degrees.
    Angle,
    /// Lengths.
    Length,
}

/// A quantity that is plotted.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// Whose colour its curves have.
    pub role: Role,
    /// Zeros and extrema of it and of its first two derivatives; none where they were not looked for.
    pub features: Option<[Features; 3]>,
}

/// How a motion is plotted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// How the crank turns: what the derivatives are by.
    pub input: InputRate,
    /// Whether the input is that of a machine, so that derivatives are by time.
    pub physical: bool,
    /// The second derivative is also shown as differences of the first one's
    /// samples.
    pub differenced: bool,
}

impl Settings {
    /// Of a motion by time alone.
    pub const BY_TIME: Self = Self {
        input: InputRate::ANALOGUES,
        physical: true,
        differenced: false,
    };
}

/// One plot: where it stands, in pixels of the reader, and what its axes span.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// 0: the quantity, 1 and 2: its derivatives.
    pub order: usize,
    /// Left edge of the plot rectangle.
    pub left: f64,
    /// Its upper edge.
    pub top: f64,
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// Crank angles at the left and the right edge, radians.
    pub x: [f64; 2],
    /// Values at the lower and the upper edge.
    pub y: [f64; 2],
    /// Places for labels along x, values of angles in degrees.
    pub x_ticks: Vec<Tick>,
    /// Places for labels along y, values of angles in degrees.
    pub y_ticks: Vec<Tick>,
    /// What is to be labelled on each curve, in the order of the series.
    pub marks: Vec<Vec<Mark>>,
    /// The value that a curve has throughout, where it does not change, in the order of the series.
    pub levels: Vec<Option<f64>>,
    /// Points of the curves a few pixels apart, in pixels of the reader: x and y
    /// of each, one after the other. Labels keep off them.
    pub points: Vec<f64>,
}

/// A chart ready to be drawn: the curves, sampled once for every drawing.
#[derive(Clone, Debug)]
pub struct Chart {
    axis: [f64; 2],
    /// Whether the input is an angle; else it is a length.
    turns: bool,
    kind: Kind,
    settings: Settings,
    series: Vec<Series>,
    /// For each order.
    plots: [Plot; 3],
}

impl Chart {
    /// The chart of quantities of one kind over a cycle, from unbroken runs of samples that have them in the order of
    /// `series`.
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

    /// The chart of quantities of one kind by time, from samples over a span of it with derivatives
    /// by time.
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

    /// Whether the input is an angle, labelled in degrees; else it is a length.
    pub fn turns(&self) -> bool {
        self.turns
    }

    /// What the quantities are.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// How they are plotted.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// The quantities.
    pub fn series(&self) -> &[Series] {
        &self.series
    }

    /// Draws the chart on an area [`FINE`] times as many units wide and high as
    /// it has pixels, and says where the text belongs. Margins, lines and dots are
    /// `scale` times as large as usual. `only`: the order of the plot that has all of it.
    ///
    /// # Errors
    /// What the backend could not draw. An area too small for a plot is left
    /// empty, with no panels.
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

    /// The panels of an area, none where they would have no room.
    fn panels(&self, (width, height): (u32, u32), scale: f64, only: Option<usize>) -> Vec<Panel> {
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

    /// Whether the values of an order are labelled in degrees.
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
        // y grows upwards: its pixels run from the bottom to the top.
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
        // Extrema are full dots, zeros open ones, differences small ones.
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

/// Draws lines, and dots over them.
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

/// What is drawn with a colour: its points and its width, its place and its radius.
type Line = (Vec<(f64, f64)>, Role, i32);
type Dot = ((f64, f64), Role, i32);

#[cfg(test)]
mod tests;
