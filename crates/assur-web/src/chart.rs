//! The page's request for a chart, and the layout for the chart's text.

use std::collections::BTreeMap;

use assur_draw::ROLES;
use assur_draw::chart::{
    Against, Axis, Chart, Field, Kind, Mark, MarkKind, Palette, Panel, Passed, Tick,
};
use assur_file::{Only, Problem};
use plotters::prelude::IntoDrawingArea;
use plotters::style::RGBColor;
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

use crate::canvas::Canvas;
use crate::capabilities::Moves;
use crate::convert::{read_directly, to_js};
use crate::simulator::bad;

/// The page's request for a chart. Sizes are in CSS pixels.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ChartRequest {
    width: u32,
    height: u32,
    #[cfg_attr(test, ts(type = "Array<[number, number, number]>"))]
    palette: [[u8; 3]; ROLES.len()],
    /// Scale of text and lines; 1 for the usual size.
    #[serde(default = "usual")]
    scale: f64,
    /// Screen pixels per CSS pixel.
    #[serde(default = "usual")]
    ratio: f64,
    /// Whether curves pass through all their points, for a picture that may be enlarged.
    #[serde(default)]
    whole: bool,
    /// The plot that takes all the room, if any.
    #[serde(default)]
    #[cfg_attr(test, ts(type = "Only"))]
    only: Only,
    /// The time around which the endless motion of a gear train without load is plotted.
    #[serde(default)]
    around: f64,
}

fn usual() -> f64 {
    1.0
}

impl ChartRequest {
    fn palette(&self) -> Palette {
        self.palette.map(|[r, g, b]| RGBColor(r, g, b))
    }
}

/// Draws the plots of a motion and, thin and dashed, the curves of another motion for the quantities that both plot.
/// Returns the layout of the plots' text.
///
/// # Errors
/// A malformed request.
pub(crate) fn draw(
    moves: &dyn Moves,
    with: Option<&dyn Moves>,
    context: &CanvasRenderingContext2d,
    request: &JsValue,
) -> Result<JsValue, Problem> {
    // JSON would refuse an infinite `around`, which stands for the end of the time axis.
    let request: ChartRequest = read_directly(request, "chart")?;
    let size = (request.width, request.height);
    let canvas = Canvas::new(context, size, request.ratio, request.whole);
    let (area, palette) = (canvas.into_drawing_area(), request.palette());
    if let Some(mut plot) = moves.against(request.around) {
        if let Some(other) = with.and_then(|with| with.against(request.around)) {
            plot.to_mut().compare(&other);
        }
        let field = plot.draw(&area, &palette, request.scale);
        let field = field.map_err(|error| bad("chart", &error.to_string()))?;
        return Ok(to_js(&ChartLayout::of_one(&plot, field, moves.numbers())));
    }
    let mut chart = moves.chart(request.around);
    if let Some(with) = with {
        chart.to_mut().compare(&with.chart(request.around));
    }
    let panels = chart.draw(&area, &palette, request.scale, request.only.order());
    let panels = panels.map_err(|error| bad("chart", &error.to_string()))?;
    Ok(to_js(&ChartLayout::new(&chart, panels, moves.numbers())))
}

/// Layout of a chart; the page uses it to place the text.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ChartLayout<'a> {
    panels: Vec<PanelLayout<'a>>,
    /// The plot of one quantity against another that replaces the panels, if it is wanted and has enough room.
    against: Option<AgainstLayout<'a>>,
}

/// Layout of the plot of one quantity against another.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AgainstLayout<'a> {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x: AxisLayout<'a>,
    y: AxisLayout<'a>,
    physical: bool,
    role: &'static str,
    /// Visible pieces of the curve. A point is three numbers: x and y in CSS pixels, then the input.
    curve: Vec<Vec<f64>>,
}

/// An axis: its quantity and range.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AxisLayout<'a> {
    /// Name of the quantity; none for the input.
    name: Option<&'a str>,
    /// The subscript in the symbol of the quantity, such as 2 in φ₂; none if the quantity is not an angle.
    number: Option<&'a str>,
    #[cfg_attr(test, ts(type = "0 | 1 | 2"))]
    order: usize,
    #[cfg_attr(test, ts(type = "\"angle\" | \"length\" | \"force\" | \"torque\""))]
    kind: &'static str,
    from: f64,
    to: f64,
    ticks: Vec<TickLayout>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PanelLayout<'a> {
    #[cfg_attr(test, ts(type = "0 | 1 | 2"))]
    order: usize,
    #[cfg_attr(test, ts(type = "\"angle\" | \"length\" | \"force\" | \"torque\""))]
    kind: &'static str,
    physical: bool,
    differenced: bool,
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x0: f64,
    x1: f64,
    y0: f64,
    y1: f64,
    xticks: Vec<TickLayout>,
    yticks: Vec<TickLayout>,
    series: Vec<SeriesLayout<'a>>,
    marks: Vec<MarkLayout>,
    points: Vec<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct TickLayout {
    value: f64,
    at: f64,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SeriesLayout<'a> {
    name: &'a str,
    /// The subscript in the symbol of the quantity, such as 2 in φ₂; none if the quantity is not an angle.
    number: Option<&'a str>,
    role: &'static str,
    /// The value of the curve, if it is constant; radians for an angle.
    level: Option<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MarkLayout {
    role: &'static str,
    #[cfg_attr(test, ts(type = "\"max\" | \"min\" | \"zero\""))]
    kind: &'static str,
    phi: f64,
    value: f64,
}

impl<'a> ChartLayout<'a> {
    pub(crate) fn new(
        chart: &'a Chart,
        panels: Vec<Panel>,
        numbers: &'a BTreeMap<String, String>,
    ) -> Self {
        let panels = panels.into_iter();
        Self {
            panels: panels
                .map(|panel| PanelLayout::new(chart, panel, numbers))
                .collect(),
            against: None,
        }
    }

    pub(crate) fn of_one(
        plot: &'a Against,
        field: Option<Field>,
        numbers: &'a BTreeMap<String, String>,
    ) -> Self {
        Self {
            panels: Vec::new(),
            against: field.map(|field| AgainstLayout::new(plot, field, numbers)),
        }
    }
}

impl<'a> AgainstLayout<'a> {
    fn new(plot: &'a Against, field: Field, numbers: &'a BTreeMap<String, String>) -> Self {
        let [x, y] = plot.axes();
        let ([of_x, of_y], [along_x, along_y]) = (field.spans, field.ticks);
        let flat = |run: &Vec<Passed>| {
            let run = run.iter();
            run.flat_map(|one| [one.at[0], one.at[1], one.input])
                .collect()
        };
        Self {
            left: field.left,
            top: field.top,
            width: field.width,
            height: field.height,
            x: AxisLayout::new(x, of_x, along_x, numbers),
            y: AxisLayout::new(y, of_y, along_y, numbers),
            physical: plot.settings().physical,
            role: plot.role().name(),
            curve: field.curve.iter().map(flat).collect(),
        }
    }
}

impl<'a> AxisLayout<'a> {
    fn new(
        axis: &'a Axis,
        [from, to]: [f64; 2],
        ticks: Vec<Tick>,
        numbers: &'a BTreeMap<String, String>,
    ) -> Self {
        let name = axis.name.as_deref();
        Self {
            name,
            number: name.and_then(|name| number_of(numbers, name)),
            order: axis.order,
            kind: kind(axis.kind),
            from,
            to,
            ticks: ticks.into_iter().map(TickLayout::from).collect(),
        }
    }
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Angle => "angle",
        Kind::Length => "length",
        Kind::Force => "force",
        Kind::Torque => "torque",
    }
}

impl<'a> PanelLayout<'a> {
    fn new(chart: &'a Chart, panel: Panel, numbers: &'a BTreeMap<String, String>) -> Self {
        let ticks = |ticks: Vec<Tick>| ticks.into_iter().map(TickLayout::from).collect();
        let series = chart.series().iter();
        let marks = series.clone().zip(&panel.marks);
        let marks = marks.flat_map(|(series, marks)| {
            let role = series.role.name();
            marks.iter().map(move |mark| MarkLayout::new(role, mark))
        });
        Self {
            order: panel.order,
            kind: kind(chart.kind()),
            physical: chart.settings().physical,
            differenced: chart.settings().differenced && panel.order == 2,
            left: panel.left,
            top: panel.top,
            width: panel.width,
            height: panel.height,
            x0: panel.x[0],
            x1: panel.x[1],
            y0: panel.y[0],
            y1: panel.y[1],
            marks: marks.collect(),
            xticks: ticks(panel.x_ticks),
            yticks: ticks(panel.y_ticks),
            series: series
                .zip(panel.levels)
                .map(|(series, level)| SeriesLayout {
                    name: &series.name,
                    number: number_of(numbers, &series.name),
                    role: series.role.name(),
                    level,
                })
                .collect(),
            points: panel.points,
        }
    }
}

/// Finds the number of a link from the name of the link's angle or load angle.
fn number_of<'a>(numbers: &'a BTreeMap<String, String>, name: &str) -> Option<&'a str> {
    let angle = name.strip_suffix(".angle");
    let link = angle.or_else(|| name.strip_suffix(".load_angle"))?;
    numbers.get(link).map(String::as_str)
}

impl MarkLayout {
    fn new(role: &'static str, mark: &Mark) -> Self {
        Self {
            role,
            kind: match mark.kind {
                MarkKind::Max => "max",
                MarkKind::Min => "min",
                MarkKind::Zero => "zero",
            },
            phi: mark.crank,
            value: mark.value,
        }
    }
}

impl From<Tick> for TickLayout {
    fn from(Tick { value, at }: Tick) -> Self {
        Self { value, at }
    }
}
