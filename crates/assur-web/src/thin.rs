//! Lines with fewer points. Most samples half a pixel apart add nothing, and each takes time to draw on a canvas.

/// Maximum number of consecutive points that are omitted.
const ROW: usize = 60;

/// Omits points of a polyline whose distance from the polyline through the remaining points is at most `unseen`.
pub(crate) fn thinned(points: &[(f64, f64)], unseen: f64) -> Vec<(f64, f64)> {
    let straight = |row: &[(f64, f64)]| {
        let [from, between @ .., to] = row else {
            return true;
        };
        let along = [to.0 - from.0, to.1 - from.1];
        let square = along[0] * along[0] + along[1] * along[1];
        between.iter().all(|point| {
            let place = [point.0 - from.0, point.1 - from.1];
            let onwards = along[0] * place[0] + along[1] * place[1];
            let aside = along[0] * place[1] - along[1] * place[0];
            (0.0..square).contains(&onwards) && aside.abs() <= unseen * square.sqrt()
        })
    };
    let mut kept = Vec::new();
    let mut rest = points;
    while let [first, ..] = rest {
        kept.push(*first);
        let rows = 2..rest.len().min(ROW + 2);
        let skipped = rows.take_while(|last| straight(&rest[..=*last])).last();
        rest = &rest[skipped.unwrap_or(1).min(rest.len())..];
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_stays_where_it_is() {
        let unseen = 1.0 / 32.0;
        let points: Vec<(f64, f64)> = (0..=720)
            .map(|i| f64::from(i) / 2.0)
            .map(|x| (x, 60.0 * (x / 40.0).sin()))
            .collect();
        let kept = thinned(&points, unseen);
        assert!(kept.len() < 140, "{}", kept.len());
        assert_eq!((kept[0], kept.last()), (points[0], points.last()));
        for (x, y) in points {
            let after = kept.partition_point(|point| point.0 < x).max(1);
            let [(x0, y0), (x1, y1)] = [kept[after - 1], kept[after]];
            let off = (y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y).abs();
            // The slope is at most 1.5, so the vertical error is up to √(1 + 1.5²) times the distance from the line.
            assert!(off <= 1.81 * unseen, "{x}: {off}");
        }
    }

    #[test]
    fn corners_and_short_lines_stay() {
        let corner: Vec<(f64, f64)> = (0..=20)
            .map(|i| (f64::from(i), f64::from(i.min(20 - i))))
            .collect();
        let expected = [(0.0, 0.0), (10.0, 10.0), (20.0, 0.0)];
        assert_eq!(thinned(&corner, 0.1), expected);
        assert_eq!(thinned(&corner[..2], 0.1), corner[..2]);
        assert_eq!(thinned(&[], 0.1), []);
        // A path that turns back differs from the line between its ends.
        for end in [0.0, 1.0] {
            let back = [(0.0, 0.0), (5.0, 0.0), (end, 0.0)];
            assert_eq!(thinned(&back, 0.1), back);
        }
    }
}
