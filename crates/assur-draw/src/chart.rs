//! Plots of φ, φ′ and φ″ of the rocker and of wheel 5, stacked on one
//! crank-angle axis, drawn by plotters on any backend.
//!
//! plotters draws lines and dots only. Tick labels and titles are the caller's:
//! each [`Panel`] says where they stand (plotters' own text measuring inserts
//! elements into the page, and the decimal sign is the reader's).

mod curves;
mod ticks;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use assur::catalog::mixer::Mixer;
use assur::motion::Extremum;

use crate::list::{ROLES, Role};
use curves::{Curve, Range};
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

struct Margin {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

/// A colour for every role, in the order of [`ROLES`].
pub type Palette = [RGBColor; ROLES.len()];

/// One plot: where it stands, in pixels of the reader, and what its axes span.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// 0: the angle, 1 and 2: its derivatives.
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
    /// Places for labels along x, values in degrees.
    pub x_ticks: Vec<Tick>,
    /// Places for labels along y, values in degrees where `order` is 0.
    pub y_ticks: Vec<Tick>,
}

/// A chart ready to be drawn: the curves, sampled once for every drawing.
#[derive(Clone, Debug)]
pub struct Chart {
    axis: [f64; 2],
    /// For each order the range and the rocker's and wheel 5's curves.
    plots: [(Range, [Curve; 2]); 3],
}

impl Chart {
    /// The chart of a mixer over its cycle; `extrema` of the rocker's φ′ and φ″
    /// are marked by dots, as are those of φ.
    pub fn new(mixer: &Mixer, extrema: &[Vec<Extremum>; 2]) -> Self {
        Self {
            axis: mixer.linkage.cycle().axis(),
            plots: curves::plots(mixer, extrema),
        }
    }

    /// Draws the chart on an area [`FINE`] times as many units wide and high as
    /// it has pixels, and says where the text belongs.
    ///
    /// # Errors
    /// What the backend could not draw. An area too small for a plot is left
    /// empty, with no panels.
    pub fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        palette: &Palette,
    ) -> Result<Vec<Panel>, DrawingAreaErrorKind<B::ErrorType>> {
        let panels = self.panels(area.dim_in_pixel());
        for (panel, (_, curves)) in panels.iter().zip(&self.plots) {
            draw_panel(area, panel, curves, palette)?;
        }
        Ok(panels)
    }

    /// The three panels of an area, none where they would have no room.
    fn panels(&self, (width, height): (u32, u32)) -> Vec<Panel> {
        let [width, height] = [width, height].map(|fine| (fine as i32 / FINE).max(0));
        let inner = width - MARGIN.left - MARGIN.right;
        let each = (height - MARGIN.bottom) / 3 - MARGIN.top;
        if inner < 20 || each < 20 {
            return Vec::new();
        }
        let panel = |(order, (range, _)): (usize, &(Range, [Curve; 2]))| Panel {
            order,
            left: f64::from(MARGIN.left),
            top: f64::from(MARGIN.top + order as i32 * (MARGIN.top + each)),
            width: f64::from(inner),
            height: f64::from(each),
            x: self.axis,
            y: [range.min, range.max],
            x_ticks: ticks::crank(self.axis, f64::from(inner)),
            y_ticks: ticks::values(*range, order == 0, f64::from(each)),
        };
        self.plots.iter().enumerate().map(panel).collect()
    }
}

type Plot = Cartesian2d<RangedCoordf64, RangedCoordf64>;

fn draw_panel<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    panel: &Panel,
    curves: &[Curve; 2],
    palette: &Palette,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let fine = |pixels: f64| pixels as i32 * FINE;
    let (left, top) = (fine(panel.left), fine(panel.top));
    let (right, bottom) = (left + fine(panel.width), top + fine(panel.height));
    let ([x0, x1], [y0, y1]) = (panel.x, panel.y);
    // y grows upwards: its pixels run from the bottom to the top.
    let plot = area.apply_coord_spec(Plot::new(x0..x1, y0..y1, (left..right, bottom..top)));
    let line = |points: Vec<(f64, f64)>, colour: &RGBColor, width: f64| {
        let style = colour.stroke_width((width * f64::from(FINE)) as u32);
        plot.draw(&PathElement::new(points, style))
    };
    for tick in &panel.x_ticks {
        let x = tick.value.to_radians();
        line(vec![(x, y0), (x, y1)], &palette[Role::Line as usize], 1.0)?;
    }
    for tick in &panel.y_ticks {
        let y = if panel.order == 0 {
            tick.value.to_radians()
        } else {
            tick.value
        };
        line(vec![(x0, y), (x1, y)], &palette[Role::Line as usize], 1.0)?;
    }
    if y0 < 0.0 && y1 > 0.0 {
        line(
            vec![(x0, 0.0), (x1, 0.0)],
            &palette[Role::Secondary as usize],
            1.0,
        )?;
    }
    for (curve, colour) in curves
        .iter()
        .zip([Role::Rocker, Role::Wheel5].map(|role| &palette[role as usize]))
    {
        for run in curve.within(y0, y1) {
            line(run, colour, 2.0)?;
        }
        for &(x, y) in curve.extrema.iter().filter(|(_, y)| (y0..=y1).contains(y)) {
            let style = colour.filled();
            plot.draw(&Circle::new((x, y), 3 * FINE, style))?;
        }
    }
    Ok(())
}
