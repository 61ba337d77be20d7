//! Drawings and charts as SVG on light paper: display lists and plots, painted as they are on the page.

mod painter;

use std::fmt::Write as _;

use plotters::prelude::{IntoDrawingArea, RGBColor};
use plotters_svg::SVGBackend;

use crate::chart::{Chart, FINE, Kind, Palette, Panel};
use crate::list::{List, Role};
use painter::Painter;

/// Colours of the roles on light paper, the same as in the style sheet of the page.
pub const LIGHT: Palette = [
    RGBColor(0x1b, 0x1f, 0x24),
    RGBColor(0x5b, 0x64, 0x70),
    RGBColor(0xdd, 0xe2, 0xe7),
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0x7a, 0x4a, 0x8c),
    RGBColor(0x8f, 0x6b, 0x00),
    RGBColor(0xff, 0xff, 0xff),
    RGBColor(0xc2, 0x38, 0x7f),
    RGBColor(0x4b, 0x4f, 0xc4),
    RGBColor(0x00, 0x79, 0x8c),
    RGBColor(0xb3, 0x5c, 0x00),
    RGBColor(0xb2, 0x6a, 0x00),
    RGBColor(0x2f, 0x8a, 0xc0),
    RGBColor(0xb8, 0x50, 0x8a),
    RGBColor(0x77, 0x82, 0x0a),
    RGBColor(0x8a, 0x53, 0x40),
    RGBColor(0xa8, 0x7b, 0x00),
    RGBColor(0xb3, 0x26, 0x1e),
    RGBColor(0xc4, 0x16, 0x1c),
    RGBColor(0x1d, 0x4e, 0xd8),
    RGBColor(0x6d, 0x5f, 0x00),
    RGBColor(0x7c, 0x3a, 0xed),
    RGBColor(0x00, 0x73, 0x6b),
];

/// Margin around a drawing for its symbols and labels, pixels.
const MARGIN: f64 = 40.0;

/// A drawing in one pose, from a [`crate::Figure`].
#[derive(Clone, Copy)]
pub struct Drawing<'a> {
    /// Rectangle of the drawing: left, bottom, right, top.
    pub bounds: [f64; 4],
    /// Display list of the parts that are fixed to bodies.
    pub rigid: &'a List,
    /// Poses of the bodies, then the display list of the parts that are not fixed to bodies.
    pub frame: &'a [f32],
    /// Names, to which labels refer by index.
    pub names: &'a [String],
    /// Returns the value of a read-out by its name, in radians, for the labels; None if there is no value.
    pub values: &'a dyn Fn(&str) -> Option<f64>,
}

/// A sheet that is filled from top to bottom.
#[derive(Clone, Debug)]
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// Makes an empty sheet with this width, pixels.
    pub fn new(width: f64) -> Self {
        Self {
            width,
            height: 0.0,
            body: String::new(),
        }
    }

    /// Adds a drawing with this height, pixels.
    pub fn drawing(&mut self, height: f64, drawing: &Drawing<'_>) {
        let [left, bottom, right, top] = drawing.bounds;
        let room = |pixels: f64| (pixels - 2.0 * MARGIN).max(1.0);
        let scale = (room(self.width) / (right - left)).min(room(height) / (top - bottom));
        let middle = [
            0.5 * self.width - 0.5 * scale * (left + right),
            self.height + 0.5 * height + 0.5 * scale * (bottom + top),
        ];
        let bodies = drawing.frame.first().map_or(0, |count| *count as usize);
        let numbers = drawing.frame.get(1..).unwrap_or_default();
        let (poses, moving) = numbers.split_at(3 * bodies);
        let mut painter = Painter {
            shapes: &mut self.body,
            labels: String::new(),
            drawing,
            poses,
            middle,
            scale,
            body: 0,
        };
        painter.paint(drawing.rigid.numbers());
        painter.body = 0;
        painter.paint(moving);
        let labels = painter.labels;
        self.body += &labels;
        self.height += height;
    }

    /// Adds a chart with this height, pixels: three plots with titles and numbered axes. `input` is the input's name.
    pub fn chart(&mut self, height: f64, chart: &Chart, input: &str) {
        let size = [self.width, height].map(|pixels| pixels as u32 * FINE.unsigned_abs());
        let _ = writeln!(
            self.body,
            "<g transform=\"translate(0 {})\"><g transform=\"scale({})\">",
            self.height,
            1.0 / f64::from(FINE)
        );
        let canvas = SVGBackend::with_string(&mut self.body, size.into());
        // Writing into memory cannot fail.
        let panels = chart.draw(&canvas.into_drawing_area(), &LIGHT, 1.0, None);
        self.body += "</g>\n";
        for panel in panels.iter().flatten() {
            self.axes(panel, chart, input);
        }
        self.body += "</g>\n";
        self.height += height;
    }

    fn axes(&mut self, panel: &Panel, chart: &Chart, input: &str) {
        let angle = panel.order == 0 && chart.kind() == Kind::Angle;
        let strokes = ["", "′", "″"].get(panel.order).copied().unwrap_or_default();
        let mut right = panel.left;
        for (series, level) in chart.series().iter().zip(&panel.levels) {
            let mut name = format!("{}{strokes}", series.name);
            if let Some(level) = level {
                let (level, unit) = if angle {
                    (level.to_degrees(), "°")
                } else {
                    (*level, "")
                };
                name += &format!(" = {}{unit}", short(level));
            }
            self.text(&name, [right, panel.top - 9.0], "start", series.role, 13.0);
            right += 8.0 * name.chars().count() as f64 + 14.0;
        }
        for tick in &panel.y_ticks {
            let at = [panel.left - 5.0, panel.top + tick.at + 4.0];
            let unit = if angle { "°" } else { "" };
            self.text(
                &format!("{}{unit}", short(tick.value)),
                at,
                "end",
                Role::Secondary,
                11.0,
            );
        }
        if panel.order == 2 {
            let down = panel.top + panel.height + 16.0;
            for tick in &panel.x_ticks {
                let unit = if chart.turns() { "°" } else { "" };
                let text = format!("{}{unit}", short(tick.value));
                // The last number must not extend beyond the sheet.
                let anchor = if tick.at + 14.0 > panel.width {
                    "end"
                } else {
                    "middle"
                };
                let at = [panel.left + tick.at, down];
                self.text(&text, at, anchor, Role::Secondary, 11.0);
            }
            let at = [panel.left + panel.width, panel.top - 9.0];
            self.text(input, at, "end", Role::Secondary, 11.0);
        }
    }

    fn text(&mut self, text: &str, [x, y]: [f64; 2], anchor: &str, role: Role, size: f64) {
        let (colour, text) = (css(role as usize), escaped(text));
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{colour}\">{text}</text>"
        );
    }

    /// Returns the sheet as the text of a file; `title` is for readers who cannot see the sheet.
    pub fn finish(self, title: &str) -> String {
        let Self {
            width,
            height,
            body,
        } = self;
        let (paper, title) = (css(Role::Paper as usize), escaped(title));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"system-ui, sans-serif\" \
             stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"{paper}\"/>\n{body}</svg>\n"
        )
    }
}

/// Returns the colour of a role.
fn css(role: usize) -> String {
    let RGBColor(r, g, b) = LIGHT.get(role).copied().unwrap_or(LIGHT[0]);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Formats a number on an axis with at most six decimals, which hide rounding errors.
fn short(value: f64) -> String {
    let rounded = format!("{value:.6}");
    let rounded = rounded.trim_end_matches('0').trim_end_matches('.');
    if matches!(rounded, "-0" | "") {
        "0".to_owned()
    } else {
        rounded.replace('-', "−")
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::list::ROLES;

    #[test]
    fn colours_are_those_of_the_style_sheet() {
        let sheet = include_str!("../../../www/styles/page.css");
        for (role, name) in ROLES.iter().enumerate() {
            let line = format!("--role-{name}: {};", css(role));
            // The first definition of a colour in the style sheet is that of the light theme.
            let first = sheet.find(&format!("--role-{name}:"));
            assert!(
                first.is_some_and(|at| sheet[at..].starts_with(&line)),
                "{line}"
            );
        }
    }

    fn drawing<'a>(rigid: &'a List, names: &'a [String]) -> Drawing<'a> {
        Drawing {
            bounds: [-1.0, -1.0, 1.0, 1.0],
            rigid,
            frame: &[1.0, 0.0, 0.0, 0.0],
            names,
            values: &|what| (what == "input").then_some(-1.0),
        }
    }

    #[test]
    fn labels_are_written_with_their_values() {
        let mut list = List::default();
        for name in 0..2 {
            list.name(Role::Ink, name, assur::Point::origin(), [0.0, 0.0]);
        }
        let names = ["φ₁\tinput", "μ\tC.transmission"].map(str::to_owned);
        let mut svg = Svg::new(100.0);
        svg.drawing(50.0, &drawing(&list, &names));
        let text = svg.finish("");
        assert!(text.contains(">φ₁ = −57.3°</text>"), "{text}");
        assert!(text.contains(">μ</text>"), "{text}");
    }

    #[test]
    fn names_are_no_markup() {
        let mut svg = Svg::new(100.0);
        let mut list = List::default();
        list.name(Role::Ink, 0, assur::Point::origin(), [0.0, 0.0]);
        svg.drawing(50.0, &drawing(&list, &["<b>&\"".to_owned()]));
        let text = svg.finish("a < b");
        assert!(text.contains(">&lt;b&gt;&amp;&quot;</text>"), "{text}");
        assert!(text.contains("<title>a &lt; b</title>"));
    }

    #[test]
    fn numbers_of_axes_are_short() {
        let texts = [0.1 + 0.2, -0.0, 360.0, -1.5, 1e-9].map(short);
        assert_eq!(texts, ["0.3", "0", "360", "−1.5", "0"]);
    }
}
