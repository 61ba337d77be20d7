//! Drawings and charts as SVG, on light paper: the display list and the plots that
//! the page paints, painted as the page paints them.

use std::convert::Infallible;
use std::fmt::Write as _;

use plotters::prelude::{DrawingBackend, IntoDrawingArea, RGBColor};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingErrorKind};

use crate::chart::{Chart, FINE, Kind, Palette, Panel};
use crate::list::{List, Role};

/// The colours of the roles on paper; the page has the same in its style sheet.
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
];

/// For each look, as in the page's painter: opacity of the filling (negative: filled
/// with paper), width of the line in pixels and its opacity, dashes.
const LOOKS: [(f64, f64, f64, &str); 7] = [
    (1.0, 0.0, 1.0, ""),
    (0.16, 1.5, 1.0, ""),
    (0.0, 2.0, 1.0, ""),
    (0.0, 2.0, 0.6, "6 5"),
    (0.0, 1.0, 1.0, ""),
    (-1.0, 2.0, 1.0, ""),
    (0.55, 0.0, 1.0, ""),
];

/// Height of the labels, pixels.
const TEXT: f64 = 15.0;

/// A sheet that is drawn on from top to bottom.
#[derive(Clone, Debug)]
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// An empty sheet of a width in pixels.
    pub fn new(width: f64) -> Self {
        Self {
            width,
            height: 0.0,
            body: String::new(),
        }
    }

    /// Adds a drawing of a height: what holds in `bounds` (left, bottom, right, top),
    /// the display list of what is rigid, a frame with the poses, and what the
    /// labels' numbers stand for.
    pub fn drawing(
        &mut self,
        height: f64,
        [left, bottom, right, top]: [f64; 4],
        rigid: &List,
        frame: &[f32],
        names: &[String],
    ) {
        let scale = (self.width / (right - left)).min(height / (top - bottom));
        let middle = [
            0.5 * self.width - 0.5 * scale * (left + right),
            self.height + 0.5 * height + 0.5 * scale * (bottom + top),
        ];
        let bodies = frame.first().map_or(0, |count| *count as usize);
        let (poses, moving) = frame.get(1..).unwrap_or_default().split_at(3 * bodies);
        let mut painter = Painter {
            shapes: &mut self.body,
            labels: String::new(),
            names,
            poses,
            middle,
            scale,
            body: 0,
        };
        painter.paint(rigid.numbers());
        painter.body = 0;
        painter.paint(moving);
        let labels = painter.labels;
        self.body += &labels;
        self.height += height;
    }

    /// Adds a chart of a height: its three plots with the titles and the numbers
    /// along the axes. `input` names the input.
    pub fn chart(&mut self, height: f64, chart: &Chart, input: &str) {
        let size = (self.width as u32, height as u32);
        let _ = writeln!(self.body, "<g transform=\"translate(0 {})\">", self.height);
        let canvas = Canvas {
            body: &mut self.body,
            size,
        };
        // Writing into memory cannot fail.
        let panels = chart.draw(&canvas.into_drawing_area(), &LIGHT, 1.0);
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
        for series in chart.series() {
            let name = format!("{}{strokes}", series.name);
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
                // The number at the very end stays on the sheet.
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

    /// The whole as a file; `title` is for those who cannot see it.
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

/// Paints display lists; places are turned into pixels here, so that nothing
/// depends on how a viewer scales lines.
struct Painter<'a> {
    shapes: &'a mut String,
    labels: String,
    names: &'a [String],
    poses: &'a [f32],
    middle: [f64; 2],
    scale: f64,
    body: usize,
}

impl Painter<'_> {
    fn paint(&mut self, mut numbers: &[f32]) {
        while let Some(used) = self.record(numbers) {
            numbers = numbers.get(used..).unwrap_or_default();
        }
    }

    /// Paints the first record and says how long it is; none at the end.
    fn record(&mut self, numbers: &[f32]) -> Option<usize> {
        let at = |index: usize| numbers.get(index).copied();
        let whole = |index: usize| at(index).map(|number| number as usize);
        match whole(0)? {
            0 => {
                self.body = whole(1)?;
                Some(2)
            }
            1 => {
                let mut next = 4;
                let mut path = String::new();
                for _ in 0..whole(3)? {
                    let count = whole(next)?;
                    path += &self.path(numbers.get(next + 1..next + 1 + 2 * count)?);
                    path += "Z";
                    next += 1 + 2 * count;
                }
                self.shape(
                    whole(1)?,
                    whole(2)?,
                    &format!("<path d=\"{path}\" fill-rule=\"evenodd\""),
                );
                Some(next)
            }
            2 => {
                let end = 4 + 2 * whole(3)?;
                let path = self.path(numbers.get(4..end)?);
                self.shape(whole(1)?, whole(2)?, &format!("<path d=\"{path}\""));
                Some(end)
            }
            3 => {
                let [x, y] = self.place(at(3)?, at(4)?);
                let radius = f64::from(at(5)?) * self.scale;
                let circle = format!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\"");
                self.shape(whole(1)?, whole(2)?, &circle);
                Some(6)
            }
            4 => {
                let [x, y] = self.place(at(3)?, at(4)?);
                let [dx, dy] = [f64::from(at(5)?), f64::from(at(6)?)];
                let name = self.names.get(whole(2)?).map_or("", String::as_str);
                let (x, y) = (x + dx * TEXT, y - dy * TEXT + 0.35 * TEXT);
                let (colour, paper) = (css(whole(1)?), css(Role::Paper as usize));
                let _ = writeln!(
                    self.labels,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\" font-size=\"{TEXT}\" \
                     font-weight=\"600\" fill=\"{colour}\" stroke=\"{paper}\" stroke-width=\"4\" \
                     paint-order=\"stroke\">{}</text>",
                    escaped(name)
                );
                Some(7)
            }
            _ => None,
        }
    }

    fn shape(&mut self, role: usize, look: usize, element: &str) {
        let (fill, width, opacity, dashes) = LOOKS.get(look).copied().unwrap_or(LOOKS[0]);
        let (colour, paper) = (css(role), css(Role::Paper as usize));
        let filling = if fill < 0.0 {
            format!("fill=\"{paper}\"")
        } else if fill > 0.0 {
            format!("fill=\"{colour}\" fill-opacity=\"{fill}\"")
        } else {
            "fill=\"none\"".to_owned()
        };
        let mut line = String::new();
        if width > 0.0 {
            line = format!(" stroke=\"{colour}\" stroke-width=\"{width}\"");
        }
        if opacity < 1.0 {
            line += &format!(" stroke-opacity=\"{opacity}\"");
        }
        if !dashes.is_empty() {
            line += &format!(" stroke-dasharray=\"{dashes}\"");
        }
        let _ = writeln!(self.shapes, "{element} {filling}{line}/>");
    }

    fn path(&self, points: &[f32]) -> String {
        let mut path = String::new();
        for (k, pair) in points.chunks_exact(2).enumerate() {
            let [x, y] = self.place(pair[0], pair[1]);
            let _ = write!(path, "{}{x:.2} {y:.2}", if k == 0 { "M" } else { "L" });
        }
        path
    }

    /// A place of the body at hand in pixels, y down.
    fn place(&self, x: f32, y: f32) -> [f64; 2] {
        let pose = self.poses.get(3 * self.body..3 * self.body + 3);
        let [left, up, angle] = pose.map_or([0.0; 3], |pose| [0, 1, 2].map(|i| f64::from(pose[i])));
        let ((sin, cos), x, y) = (angle.sin_cos(), f64::from(x), f64::from(y));
        let at = [left + cos * x - sin * y, up + sin * x + cos * y];
        [
            self.middle[0] + self.scale * at[0],
            self.middle[1] - self.scale * at[1],
        ]
    }
}

/// A backend of plotters.
struct Canvas<'a> {
    body: &'a mut String,
    size: (u32, u32),
}

type Written = Result<(), DrawingErrorKind<Infallible>>;

impl Canvas<'_> {
    fn element(&mut self, element: &str, style: &impl BackendStyle, fill: bool) {
        let colour = of_backend(style.color());
        let _ = if fill {
            writeln!(self.body, "{element} fill=\"{colour}\"/>")
        } else {
            let width = pixels(style.stroke_width() as i32);
            writeln!(
                self.body,
                "{element} fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>"
            )
        };
    }

    fn path(path: impl IntoIterator<Item = BackendCoord>) -> String {
        let mut text = String::new();
        for (k, (x, y)) in path.into_iter().enumerate() {
            let command = if k == 0 { "M" } else { "L" };
            let _ = write!(text, "{command}{} {}", pixels(x), pixels(y));
        }
        text
    }
}

impl DrawingBackend for Canvas<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let fine = FINE.unsigned_abs();
        (self.size.0 * fine, self.size.1 * fine)
    }

    fn ensure_prepared(&mut self) -> Written {
        Ok(())
    }

    fn present(&mut self) -> Written {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Written {
        let (x, y, side, colour) = (pixels(x), pixels(y), pixels(1), of_backend(color));
        let _ = writeln!(
            self.body,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{side}\" height=\"{side}\" fill=\"{colour}\"/>"
        );
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Written {
        self.element(&format!("<path d=\"{}\"", Self::path(path)), style, false);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Written {
        self.element(&format!("<path d=\"{}Z\"", Self::path(path)), style, true);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Written {
        let [x, y, radius] = [x, y, radius as i32].map(pixels);
        self.element(
            &format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\""),
            style,
            fill,
        );
        Ok(())
    }
}

fn pixels(fine: i32) -> f64 {
    f64::from(fine) / f64::from(FINE)
}

fn of_backend(BackendColor { rgb: (r, g, b), .. }: BackendColor) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// The colour of a role.
fn css(role: usize) -> String {
    let RGBColor(r, g, b) = LIGHT.get(role).copied().unwrap_or(LIGHT[0]);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number of an axis without the rounding of its steps.
fn short(value: f64) -> String {
    let rounded = format!("{value:.6}");
    let rounded = rounded.trim_end_matches('0').trim_end_matches('.');
    if matches!(rounded, "-0" | "") {
        "0".to_owned()
    } else {
        rounded.replace('-', "−")
    }
}

/// Text that is no markup.
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
            // The first of them is the light one.
            let first = sheet.find(&format!("--role-{name}:"));
            assert!(
                first.is_some_and(|at| sheet[at..].starts_with(&line)),
                "{line}"
            );
        }
    }

    #[test]
    fn names_are_no_markup() {
        let mut svg = Svg::new(100.0);
        let mut list = List::default();
        list.name(Role::Ink, 0, assur::Point::origin(), [0.0, 0.0]);
        let names = ["<b>&\"".to_owned()];
        svg.drawing(
            50.0,
            [-1.0, -1.0, 1.0, 1.0],
            &list,
            &[1.0, 0.0, 0.0, 0.0],
            &names,
        );
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
