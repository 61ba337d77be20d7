//! Rectangles, given by left, bottom, right and top.

use assur::{Point, Vector};

/// Returns the smallest rectangle around points; without points, a square about the origin.
pub(crate) fn around(places: impl Iterator<Item = Point>) -> [f64; 4] {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for place in places {
        low = low.inf(&place.coords);
        high = high.sup(&place.coords);
    }
    if low.x > high.x {
        return [-1.0, -1.0, 1.0, 1.0];
    }
    [low.x, low.y, high.x, high.y]
}

/// Returns the diagonal of a rectangle.
pub(crate) fn size([left, bottom, right, top]: [f64; 4]) -> f64 {
    (right - left).hypot(top - bottom)
}

/// Extends a rectangle to include points, by at most `most` on each side.
pub(super) fn grown(base: [f64; 4], places: impl Iterator<Item = Point>, most: f64) -> [f64; 4] {
    let [left, bottom, right, top] = base;
    places.fold(base, |b, at| {
        [
            b[0].min(at.x.max(left - most)),
            b[1].min(at.y.max(bottom - most)),
            b[2].max(at.x.min(right + most)),
            b[3].max(at.y.min(top + most)),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_around_points_has_their_extremes() {
        let places = [[1.0, 2.0], [-2.0, 5.0], [0.0, 1.0]].map(Point::from);
        let found = around(places.into_iter());
        assert_eq!(found, [-2.0, 1.0, 1.0, 5.0]);
        // Sides of 3 and 4.
        assert_eq!(size(found), 5.0);
        assert_eq!(around([].into_iter()), [-1.0, -1.0, 1.0, 1.0]);
    }

    #[test]
    fn a_rectangle_grows_up_to_a_limit() {
        for (place, expected) in [
            ([1.0, 1.0], [0.0, 0.0, 2.0, 2.0]),
            ([2.5, 1.0], [0.0, 0.0, 2.5, 2.0]),
            ([9.0, -9.0], [0.0, -1.0, 3.0, 2.0]),
            ([-0.5, 9.0], [-0.5, 0.0, 2.0, 3.0]),
        ] {
            let found = grown([0.0, 0.0, 2.0, 2.0], [Point::from(place)].into_iter(), 1.0);
            assert_eq!(found, expected, "{place:?}");
        }
    }
}
