//! The sheet for the velocity or acceleration polygons of a motion. The pole is fixed; the scale is reduced only for
//! polygons that would not fit.

use assur::motion::{InputRate, Motion, Sampling, Shown, Spacing};
use assur::polygons::{Order, Polygon};
use assur::sorting::sort_by;

/// Sampling of the poses, without the ends of arcs, which may be dead points.
const POSES: Sampling = Sampling {
    turn: 120,
    coarsest: 30,
    most: 32 * 120,
    spacing: Spacing::Middles,
    shown: Shown::Spread,
};
/// Limit of a polygon's size, relative to the median size, in a motion without dead points. Larger polygons are left
/// out when the size of the sheet is chosen.
const MAX_SIZE: f64 = 10.0;
/// The same limit in a motion with dead points, near which vectors grow without bound.
const MOST_OF_DEAD: f64 = 3.0;
/// Least distance of the pole from the sheet's edges, as a share of the size of the rectangle around the polygons that
/// are not left out.
const EDGE: f64 = 0.1;
/// Size of a polygon, relative to the sheet, up to which its scale is not reduced. Between sampled poses some polygons
/// slightly exceed the sheet.
const BEYOND: f64 = 1.05;
/// Sizes of sheets, to be multiplied by a power of ten.
const SIZES: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 5.0, 7.0];
/// Factors by which a scale is reduced, to be multiplied by a power of ten.
const SMALLER: [f64; 3] = [1.0, 2.0, 5.0];

/// A rectangle about the pole: left, bottom, right, top.
type Rectangle = [f64; 4];

/// The square sheet of a motion's velocity polygons or of its acceleration polygons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonSheet(Rectangle);

impl PolygonSheet {
    /// Makes the sheet of a motion with this input rate.
    pub fn over(motion: &Motion, order: Order, input: InputRate) -> Self {
        let mechanism = motion.mechanism();
        let mut pose = mechanism.blank::<3>();
        let mut found = Vec::new();
        for at in motion.samples(POSES).into_iter().flatten() {
            if motion.place(at, &mut pose).is_ok() {
                found.push(around(&mechanism.polygon(&pose, order, input)));
            }
        }
        let mut ends = motion.dead_points().iter();
        let dead = ends.any(|end| end.kind.is_dead_point());
        Self::of(found, if dead { MOST_OF_DEAD } else { MAX_SIZE })
    }

    /// Makes the sheet from the rectangles around polygons; those larger than `most` times the median are left out.
    fn of(mut found: Vec<Rectangle>, most: f64) -> Self {
        sort_by(&mut found, |a, b| reach(*a).total_cmp(&reach(*b)));
        let median = found.get(found.len() / 2).map_or(0.0, |a| reach(*a));
        let usual = found.iter();
        let usual = usual.filter(|a| reach(**a) <= most * median || median == 0.0);
        let all = usual.fold([0.0; 4], |all, one| joined(all, *one));
        let [left, bottom, right, top] = all;
        let size = (right - left).max(top - bottom);
        if size <= 0.0 {
            return Self([-1.0, -1.0, 1.0, 1.0]);
        }
        let edge = EDGE * size;
        let [left, bottom, right, top] = joined(all, [-edge, -edge, edge, edge]);
        let half = 0.5 * no_less((right - left).max(top - bottom), &SIZES);
        let [x, y] = [0.5 * (left + right), 0.5 * (bottom + top)];
        Self([x - half, y - half, x + half, y + half])
    }

    /// Returns the sheet for a polygon, and the factor by which its scale is reduced, 1 if the polygon fits.
    pub(super) fn holding(&self, polygon: &Polygon) -> (Rectangle, f64) {
        let sides = around(polygon).into_iter().zip(self.0);
        let over = sides.map(|(side, of)| side / of).fold(0.0, f64::max);
        let smaller = if over > BEYOND {
            no_less(over, &SMALLER)
        } else {
            1.0
        };
        (self.0.map(|side| side * smaller), smaller)
    }
}

/// Returns the rectangle around a polygon and its pole.
fn around(polygon: &Polygon) -> Rectangle {
    let stages = polygon.stages.iter();
    let places = stages.flat_map(|stage| {
        let legs = stage.routes.iter().flat_map(|route| &route.legs);
        let ends = legs.flat_map(|leg| leg.ends);
        ends.chain(stage.nodes.iter().map(|(_, at)| *at))
    });
    places.fold([0.0; 4], |all, at| joined(all, [at.x, at.y, at.x, at.y]))
}

/// Returns the rectangle around two others.
fn joined(a: Rectangle, b: Rectangle) -> Rectangle {
    [
        a[0].min(b[0]),
        a[1].min(b[1]),
        a[2].max(b[2]),
        a[3].max(b[3]),
    ]
}

/// Returns the greatest distance of a rectangle's sides from the pole.
fn reach(rectangle: Rectangle) -> f64 {
    rectangle.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// Returns the least number not below `length` that is one of `digits`, in ascending order, times a power of ten.
fn no_less(length: f64, digits: &[f64]) -> f64 {
    let power = 10.0_f64.powf(length.log10().floor());
    let mut whole = digits.iter().map(|digit| digit * power);
    whole.find(|round| *round >= length).unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::mechanism::{LinkageSpec, Mechanism};

    /// Makes a four-bar with these lengths of crank, coupler and rocker, and a frame of length 4.
    fn four_bar([crank, c, d]: [f64; 3]) -> Motion {
        // The crank is drawn at right angles to the frame.
        let diagonal = crank.hypot(4.0);
        let along = (c * c + diagonal * diagonal - d * d) / (2.0 * diagonal);
        let across = (c * c - along * along).sqrt();
        let (x, y) = (4.0 / diagonal, -crank / diagonal);
        let draft = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, crank)
            .point("C", along * x - across * y, crank + along * y + across * x)
            .point("D", 4.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["C", "D"])
            .crank("crank");
        Motion::new(Mechanism::new(&draft).expect("a four-bar"))
    }

    fn polygons(motion: &Motion, order: Order) -> Vec<Polygon> {
        let [from, to] = motion.cycle().arcs()[0];
        let inputs = (1..1000).map(|k| from + (to - from) * f64::from(k) / 1000.0);
        let poses = inputs.filter_map(|input| motion.pose::<3>(input).ok());
        let polygon = |pose| {
            motion
                .mechanism()
                .polygon(&pose, order, InputRate::ANALOGUES)
        };
        poses.map(polygon).collect()
    }

    #[test]
    fn a_turning_crank_has_one_scale() {
        let motion = four_bar([1.0, 3.0, 3.0]);
        for order in [Order::Velocity, Order::Acceleration] {
            let sheet = PolygonSheet::over(&motion, order, InputRate::ANALOGUES);
            let polygons = polygons(&motion, order);
            assert!(polygons.len() > 990);
            for polygon in &polygons {
                assert_eq!(sheet.holding(polygon), (sheet.0, 1.0));
            }
            let [left, bottom, right, top] = sheet.0;
            assert!(left < 0.0 && bottom < 0.0 && right > 0.0 && top > 0.0);
            let largest = polygons.iter().map(|polygon| polygon.largest);
            let largest = largest.fold(0.0, f64::max);
            assert!(largest > 0.25 * (right - left), "{largest} {:?}", sheet.0);
        }
    }

    /// If the crank has dead points, most of the motion has one scale, at which the median polygon takes much of the
    /// sheet. Near the ends the scale is reduced in round steps about the same pole, so that every polygon fits.
    #[test]
    fn a_dead_point_has_smaller_scales() {
        let motion = four_bar([3.0, 2.0, 3.5]);
        let sheet = PolygonSheet::over(&motion, Order::Acceleration, InputRate::ANALOGUES);
        let polygons = polygons(&motion, Order::Acceleration);
        let held = polygons
            .iter()
            .map(|polygon| (polygon, sheet.holding(polygon)));
        let mut clipped = 0;
        for (polygon, (bounds, smaller)) in held {
            clipped += usize::from(smaller > 1.0);
            assert_eq!(bounds, sheet.0.map(|side| side * smaller));
            let sides = around(polygon).into_iter().zip(bounds);
            let over = sides.map(|(side, of)| side / of).fold(0.0, f64::max);
            assert!(over <= BEYOND, "{over} at {smaller}");
            let digits = smaller / 10.0_f64.powf(smaller.log10().floor());
            assert!(SMALLER.iter().any(|digit| (digit - digits).abs() < 1e-9));
        }
        assert!(clipped > 0 && clipped * 4 < polygons.len(), "{clipped}");
        let mut sizes: Vec<f64> = polygons.iter().map(|one| reach(around(one))).collect();
        sizes.sort_by(f64::total_cmp);
        let [left, _, right, _] = sheet.0;
        assert!(sizes[sizes.len() / 2] > 0.1 * (right - left));
    }

    /// A motion without polygons, or with polygons of size zero, also has a sheet.
    #[test]
    fn nothing_has_a_sheet() {
        for found in [Vec::new(), vec![[0.0; 4]]] {
            assert_eq!(
                PolygonSheet::of(found, MAX_SIZE),
                PolygonSheet([-1.0, -1.0, 1.0, 1.0])
            );
        }
    }

    #[test]
    fn sizes_are_round() {
        for (length, expected) in [(1.0, 1.0), (1.2, 1.5), (0.8, 1.0), (230.0, 300.0)] {
            assert!((no_less(length, &SIZES) - expected).abs() < 1e-12 * expected);
        }
    }
}
