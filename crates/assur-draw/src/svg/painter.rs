//! Painting of display lists as SVG.

use std::fmt::Write as _;

use super::{Drawing, css, escaped};
use crate::figure::names::VALUE;
use crate::list::Role;

/// Style of each look, as in the page's painter: opacity of the fill (negative: filled with the
/// colour of the paper), width of the line in pixels, opacity of the line, dash pattern.
const LOOKS: [(f64, f64, f64, &str); 7] = [
    (1.0, 0.0, 1.0, ""),
    (0.16, 1.5, 1.0, ""),
    (0.0, 2.0, 1.0, ""),
    (0.0, 2.0, 0.6, "6 5"),
    (0.0, 1.0, 1.0, ""),
    (-1.0, 2.0, 1.0, ""),
    (0.55, 0.0, 1.0, ""),
];

/// Font size of the labels, pixels.
const TEXT: f64 = 15.0;

/// Painter of display lists. Positions are converted to pixels, so that line widths do not depend on the scale.
pub(super) struct Painter<'a> {
    pub(super) shapes: &'a mut String,
    pub(super) labels: String,
    pub(super) drawing: &'a Drawing<'a>,
    pub(super) poses: &'a [f32],
    /// Position of the model's origin, pixels.
    pub(super) middle: [f64; 2],
    /// Number of pixels per unit of the model.
    pub(super) scale: f64,
    pub(super) body: usize,
}

impl Painter<'_> {
    pub(super) fn paint(&mut self, mut numbers: &[f32]) {
        while let Some(used) = self.record(numbers) {
            numbers = numbers.get(used..).unwrap_or_default();
        }
    }

    /// Paints the first record and returns the length of the record; none at the end.
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
                let name = self.drawing.names.get(whole(2)?);
                let text = name.map_or_else(String::new, |name| self.written(name));
                let (x, y) = (x + dx * TEXT, y - dy * TEXT + 0.35 * TEXT);
                let (colour, paper) = (css(whole(1)?), css(Role::Paper as usize));
                let _ = writeln!(
                    self.labels,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\" font-size=\"{TEXT}\" \
                     font-weight=\"600\" fill=\"{colour}\" stroke=\"{paper}\" stroke-width=\"4\" \
                     paint-order=\"stroke\">{}</text>",
                    escaped(&text)
                );
                Some(7)
            }
            _ => None,
        }
    }

    /// Returns the text of a label. If the label has a read-out, its value in degrees follows the symbol.
    fn written(&self, label: &str) -> String {
        let Some((symbol, what)) = label.split_once(VALUE) else {
            return label.to_owned();
        };
        let value = (self.drawing.values)(what);
        value.map_or_else(
            || symbol.to_owned(),
            |value| format!("{symbol} = {:.1}°", value.to_degrees()).replace('-', "−"),
        )
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

    /// Converts a position on the current body to pixels, with y downwards.
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
