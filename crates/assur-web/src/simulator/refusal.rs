//! Invalid arguments as problems.

use super::*;

/// Makes a point of the drawing, whose coordinates must be finite.
pub(super) fn place(x: f64, y: f64) -> Result<Point, JsValue> {
    let place = Point::new(x, y);
    let finite = place.coords.iter().all(|x| x.is_finite());
    finite.then_some(place).ok_or_else(|| one(unknown("place")))
}

/// Converts one problem to the exception that the page expects.
pub(crate) fn one(problem: Problem) -> JsValue {
    thrown([problem])
}

/// The problem of an invalid value, with its path.
pub(crate) fn bad(path: &str, detail: &str) -> Problem {
    Problem::BadState {
        path: path.to_owned(),
        detail: detail.to_owned(),
    }
}
