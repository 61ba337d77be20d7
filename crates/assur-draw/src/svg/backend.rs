//! A backend of plotters that writes SVG.

use std::convert::Infallible;
use std::fmt::Write as _;

use plotters::prelude::DrawingBackend;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingErrorKind};

use crate::chart::FINE;

/// SVG text of the plots, with the width and height in pixels.
pub(super) struct Canvas<'a> {
    pub(super) body: &'a mut String,
    pub(super) size: (u32, u32),
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
