//! A canvas as a drawing backend of plotters.
//!
//! plotters-canvas draws in whole pixels of the backing store, which gives a curve visible steps at a pixel ratio of 1.
//! This backend draws in sixteenths of a CSS pixel ([`FINE`]); the canvas's own transform applies the ratio.

use std::convert::Infallible;

use assur_draw::chart::FINE;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind,
};
use web_sys::CanvasRenderingContext2d;

use crate::thin::thinned;

/// Maximum distance of an omitted point from the drawn line, in screen pixels.
const UNSEEN: f64 = 1.0 / 32.0;

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// A canvas with its size in CSS pixels.
pub(crate) struct Canvas<'a> {
    context: &'a CanvasRenderingContext2d,
    size: (u32, u32),
    ratio: f64,
    whole: bool,
}

impl<'a> Canvas<'a> {
    /// Draws on `context`, whose transform scales CSS pixels to the backing store by `ratio`. If `whole`, a curve
    /// passes through all its points; otherwise points that make no visible difference are omitted.
    pub(crate) fn new(
        context: &'a CanvasRenderingContext2d,
        size: (u32, u32),
        ratio: f64,
        whole: bool,
    ) -> Self {
        Self {
            context,
            size,
            ratio,
            whole,
        }
    }

    fn trace(&self, path: impl IntoIterator<Item = (f64, f64)>) {
        self.context.begin_path();
        for (index, (x, y)) in path.into_iter().enumerate() {
            if index == 0 {
                self.context.move_to(x, y);
            } else {
                self.context.line_to(x, y);
            }
        }
    }

    fn stroke(&self, style: &impl BackendStyle, width: f64) {
        self.context.set_stroke_style_str(&css(style.color()));
        self.context.set_line_width(width);
        self.context.stroke();
    }

    fn fill(&self, color: BackendColor) {
        self.context.set_fill_style_str(&css(color));
        self.context.fill();
    }
}

impl DrawingBackend for Canvas<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let fine = FINE.unsigned_abs();
        (self.size.0 * fine, self.size.1 * fine)
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.context.set_fill_style_str(&css(color));
        let side = pixels(1);
        self.context
            .fill_rect(pixels(point.0), pixels(point.1), side, side);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let mut path: Vec<_> = path.into_iter().map(place).collect();
        let width = sharpened(&mut path, width(style), self.ratio);
        if !self.whole {
            path = thinned(&path, UNSEEN / self.ratio);
        }
        self.trace(path);
        self.stroke(style, width);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        self.trace(path.into_iter().map(place));
        self.fill(style.color());
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let radius = f64::from(radius) / f64::from(FINE);
        self.context.begin_path();
        let (x, y) = (pixels(center.0), pixels(center.1));
        let full = std::f64::consts::TAU;
        // The canvas refuses only negative radii; this radius is not negative.
        if self.context.arc(x, y, radius, 0.0, full).is_err() {
            return Ok(());
        }
        if fill {
            self.fill(style.color());
        } else {
            self.stroke(style, width(style));
        }
        Ok(())
    }
}

fn place((x, y): BackendCoord) -> (f64, f64) {
    (pixels(x), pixels(y))
}

fn width(style: &impl BackendStyle) -> f64 {
    f64::from(style.stroke_width()) / f64::from(FINE)
}

/// Moves a horizontal or vertical line so that its edges lie between screen pixels; elsewhere a thin line would be pale
/// and twice as wide. Returns the width rounded to whole screen pixels, at least one. Other paths and their widths do
/// not change. `ratio`: screen pixels per CSS pixel.
fn sharpened(path: &mut [(f64, f64)], width: f64, ratio: f64) -> f64 {
    let [from, to] = path else {
        return width;
    };
    let whole = (width * ratio).round().max(1.0) / ratio;
    let half = 0.5 * whole;
    let sharp = |at: f64| ((at - half) * ratio).round() / ratio + half;
    if from.0 == to.0 {
        from.0 = sharp(from.0);
        to.0 = from.0;
    } else if from.1 == to.1 {
        from.1 = sharp(from.1);
        to.1 = from.1;
    } else {
        return width;
    }
    whole
}

fn pixels(fine: i32) -> f64 {
    f64::from(fine) / f64::from(FINE)
}

fn css(color: BackendColor) -> String {
    let (r, g, b) = color.rgb;
    format!("rgba({r},{g},{b},{})", color.alpha)
}
