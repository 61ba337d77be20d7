//! An atlas of coupler curves: a map over two ratios of lengths, for one or more points of the coupler (after J. A.
//! Hrones and G. L. Nelson, *Analysis of the Four-Bar Linkage*, 1951, who printed 7,300 such curves).

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::approximation::Approximation;
use super::compare::{Candidate, PARTS, Part, Pattern};
use super::curve::{Curve, Kind};
use super::distance::Deviation;
use super::fitted::Fitted;
use super::target::{Course, Target};
use crate::{Assembly, FourBar, Grashof, Link, Offset, Point};

/// Number of crank angles from which parts of a closed curve are compared with an open path.
const STARTS: usize = 24;

/// A length relative to the crank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ratio {
    /// l₂/l₁.
    Coupler,
    /// l₃/l₁.
    Rocker,
    /// l₄/l₁.
    Frame,
}

/// Values of a ratio at equal steps of its logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The ratio.
    pub ratio: Ratio,
    /// First and last value.
    pub range: [f64; 2],
    /// Number of values.
    pub count: usize,
}

/// Reasons why there is no atlas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AtlasError {
    /// Both axes have the same ratio.
    SameRatio,
    /// A value of this ratio is not between 0.01 and 100.
    Value(Ratio),
    /// There is no cell, or there are more than [`Atlas::MOST_CELLS`].
    Count(usize),
    /// A coordinate of this coupler point is not within ±100.
    Point(usize),
}

/// A map of coupler curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Atlas {
    axes: [Axis; 2],
    third: f64,
    points: Vec<[f64; 2]>,
}

/// A cell of the atlas.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Lengths l₁ … l₄; the crank is 1.
    pub lengths: [f64; 4],
    /// Index of the coupler point.
    pub point: usize,
    /// The Grashof type; None if the lengths form no linkage.
    pub grashof: Option<Grashof>,
    /// The minimum transmission angle of the motion, 0 … π/2; None if the lengths form no linkage.
    pub transmission: Option<f64>,
    /// The curve of one circuit, with the pivot of the crank at the origin and that of the rocker at (l₄, 0). The last
    /// point equals the first. Empty if the lengths form no linkage.
    pub curve: Vec<Point>,
    /// Difference from a wanted path, 0 for similar curves and at most 1: the root-mean-square distance of 24 places
    /// after the nearest similarity or mirror image, relative to that of the path from its centre. An open path is
    /// compared with parts of the curve. None if there is no path, or if crank angles are given.
    pub unlikeness: Option<f64>,
}

impl Atlas {
    /// Maximum number of cells.
    pub const MOST_CELLS: usize = 40_000;

    /// The atlas over two ratios, with a given value of the third, for points of the coupler. The coordinates of a
    /// point are along the coupler and to its left, in units of the coupler's length.
    ///
    /// # Errors
    /// The first fault found.
    pub fn new(axes: [Axis; 2], third: f64, points: &[[f64; 2]]) -> Result<Self, AtlasError> {
        let sound = |value: f64| (0.01..=100.0).contains(&value);
        let [across, up] = axes;
        if across.ratio == up.ratio {
            return Err(AtlasError::SameRatio);
        }
        for axis in axes {
            if !sound(axis.range[0]) || !sound(axis.range[1]) {
                return Err(AtlasError::Value(axis.ratio));
            }
        }
        if !sound(third) {
            return Err(AtlasError::Value(left(axes)));
        }
        let count = (across.count.saturating_mul(up.count)).saturating_mul(points.len());
        if count == 0 || count > Self::MOST_CELLS {
            return Err(AtlasError::Count(count));
        }
        let near = |point: &[f64; 2]| point.iter().all(|x| x.abs() <= 100.0);
        if let Some(k) = points.iter().position(|point| !near(point)) {
            return Err(AtlasError::Point(k));
        }
        Ok(Self {
            axes,
            third,
            points: points.to_vec(),
        })
    }

    /// Number of cells.
    pub fn count(&self) -> usize {
        self.plane() * self.points.len()
    }

    /// Cells of a range of indices, so that the atlas can be computed in parts. The index runs along the first axis,
    /// then along the second, then over the points. `places` is the number of places of each curve.
    pub fn cells(
        &self,
        range: std::ops::Range<usize>,
        places: usize,
        target: Option<&Target>,
    ) -> Vec<Cell> {
        let pattern = target.map(Pattern::new);
        let range = range.start..range.end.min(self.count());
        range
            .map(|index| self.cell(index, places, pattern.as_ref()))
            .collect()
    }

    /// The linkage of a cell, placed so that its curve or, for an open path, a part of its curve is nearest to a path.
    /// None if the lengths form no linkage that can be placed, or if crank angles are given.
    pub fn nearest(&self, index: usize, target: &Target) -> Option<Approximation> {
        let pattern = Pattern::new(target);
        if index >= self.count() || pattern.timed() {
            return None;
        }
        let lengths = self.lengths(index);
        let [along, across] = self.points[index / self.plane()];
        let [_, x, y, z] = lengths.map(f64::ln);
        let curve = Curve::new(Kind::FourBar, [x, y, z], Complex::new(along, across))?;
        let parts: Vec<Part> = if target.course() == Course::Closed {
            vec![Part::Whole]
        } else {
            let starts = (0..STARTS).map(|k| TAU * k as f64 / STARTS as f64);
            let parts = starts.flat_map(|start| PARTS.map(|span| Part::Arc([start, TAU * span])));
            parts.collect()
        };
        let candidates = parts.into_iter().flat_map(|part| {
            [false, true].map(|mirrored| Candidate {
                curve,
                mirrored,
                part,
            })
        });
        let compared = candidates.map(|candidate| (pattern.compare(&candidate), candidate));
        let best = compared.min_by(|(a, _), (b, _)| a.defect.total_cmp(&b.defect));
        let (found, candidate) = best.filter(|(found, _)| found.defect.is_finite())?;
        let fitted = Fitted::new(&candidate, &found, target)?;
        Approximation::new(&fitted, Deviation::of(&fitted, target), target)
    }

    /// Number of cells for one coupler point.
    fn plane(&self) -> usize {
        self.axes[0].count * self.axes[1].count
    }

    /// Lengths l₁ … l₄ of a cell.
    fn lengths(&self, index: usize) -> [f64; 4] {
        let [across, up] = self.axes;
        let values = [
            (across.ratio, across.value(index % across.count)),
            (up.ratio, up.value(index / across.count % up.count)),
            (left(self.axes), self.third),
        ];
        let mut lengths = [1.0; 4];
        for (ratio, value) in values {
            lengths[1 + ratio as usize] = value;
        }
        lengths
    }

    fn cell(&self, index: usize, places: usize, pattern: Option<&Pattern>) -> Cell {
        let (lengths, point) = (self.lengths(index), index / self.plane());
        let linkage = FourBar::new(lengths).ok();
        let [along, across] = self.points[point];
        let offset = Offset { along, across };
        let curve = linkage.map_or_else(Vec::new, |linkage| curve(&linkage, offset, places));
        Cell {
            lengths,
            point,
            grashof: linkage.map(|linkage| linkage.grashof()),
            transmission: linkage.map(|linkage| linkage.worst_transmission().0),
            unlikeness: pattern.and_then(|pattern| {
                let line: Vec<_> = curve.iter().map(|p| Complex::new(p.x, p.y)).collect();
                pattern.unlikeness(&line)
            }),
            curve,
        }
    }
}

impl Axis {
    fn value(&self, k: usize) -> f64 {
        let [from, to] = self.range;
        let share = k as f64 / (self.count.max(2) - 1) as f64;
        from * (to / from).powf(share)
    }
}

/// The ratio that is on neither axis.
fn left([across, up]: [Axis; 2]) -> Ratio {
    let all = [Ratio::Coupler, Ratio::Rocker, Ratio::Frame];
    let other = |ratio: &Ratio| *ratio != across.ratio && *ratio != up.ratio;
    all.into_iter().find(other).unwrap_or(Ratio::Frame)
}

/// The coupler curve of a circuit. A crank that swings moves along its first arc in one assembly and back in the other.
fn curve(linkage: &FourBar, offset: Offset, places: usize) -> Vec<Point> {
    let cycle = linkage.cycle();
    let Some([from, to]) = cycle.arcs().first().copied() else {
        return Vec::new();
    };
    let full = cycle.is_full();
    let last = places.max(2) - 1;
    let place = |k: usize| {
        let share = k as f64 / last as f64;
        let (assembly, crank) = if full {
            let period = cycle.period().unwrap_or(to - from);
            (Assembly::First, from + period * share)
        } else {
            let swing = 0.5 - 0.5 * (std::f64::consts::TAU * share).cos();
            let assembly = if 2 * k <= last {
                Assembly::First
            } else {
                Assembly::Second
            };
            (assembly, from + (to - from) * swing)
        };
        let pose = linkage.pose_along::<1>(assembly, crank).ok()?;
        Some(linkage.carried(&pose, Link::Coupler, offset).place())
    };
    (0..=last).filter_map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::approximation::Tracing;

    fn axis(ratio: Ratio, range: [f64; 2], count: usize) -> Axis {
        Axis {
            ratio,
            range,
            count,
        }
    }

    fn atlas(points: &[[f64; 2]]) -> Atlas {
        let axes = [
            axis(Ratio::Coupler, [1.0, 4.0], 3),
            axis(Ratio::Rocker, [1.5, 6.0], 5),
        ];
        Atlas::new(axes, 3.0, points).unwrap()
    }

    /// The linkage of a cell is placed on its own curve, moved, rotated and doubled in size, and on a part of it.
    #[test]
    fn the_linkage_of_a_cell_is_placed_on_the_path() {
        let atlas = atlas(&[[0.5, 0.5]]);
        let curve = atlas.cells(7..8, 97, None).remove(0).curve;
        let turned = |at: &Point| {
            let (sin, cos) = 0.7_f64.sin_cos();
            Point::new(
                3.0 + 2.0 * (cos * at.x - sin * at.y),
                2.0 * (sin * at.x + cos * at.y) - 1.0,
            )
        };
        let points: Vec<Point> = curve.iter().map(turned).collect();
        let closed = Target::new(&points, Course::Closed, None).unwrap();
        let found = atlas.nearest(7, &closed).unwrap();
        assert!(found.deviation.greatest < 2e-2, "{:?}", found.deviation);
        let Tracing::FourBar(linkage) = found.linkage else {
            panic!("a four-bar");
        };
        for (length, expected) in linkage.lengths().into_iter().zip([2.0, 4.0, 6.0, 6.0]) {
            assert!((length - expected).abs() < 1e-2, "{:?}", linkage.lengths());
        }
        let open = Target::new(&points[..40], Course::Open, None).unwrap();
        let found = atlas.nearest(7, &open).unwrap();
        assert!(found.deviation.greatest < 0.2, "{:?}", found.deviation);
        assert!(atlas.nearest(15, &closed).is_none());
    }

    /// Coupler 1, 2, 4 and rocker 1.5 … 6 on a frame of 3: coupler 2 and rocker 3 are cell 1 + 3·2, a crank-rocker.
    #[test]
    fn cells_run_along_the_first_axis() {
        let atlas = atlas(&[[0.5, 0.0], [0.5, 0.5]]);
        let cells = atlas.cells(0..1000, 49, None);
        assert_eq!(cells.len(), 30);
        let cell = &cells[15 + 7];
        let off = cell.lengths.iter().zip([1.0, 2.0, 3.0, 3.0]);
        assert!(
            off.clone()
                .all(|(found, expected)| (found - expected).abs() < 1e-14),
            "{cell:?}"
        );
        assert_eq!((cell.point, cell.grashof), (1, Some(Grashof::CrankRocker)));
        assert_eq!(cell.curve.len(), 49);
        assert!((cell.curve[0] - cell.curve[48]).norm() < 1e-12);
        // Coupler 1 and rocker 6 do not close on 3 with a crank of 1.
        let cell = &cells[12];
        assert_eq!((cell.grashof, cell.curve.len()), (None, 0));
    }

    /// The curve of a cell, rotated, mirrored and enlarged, differs least from the curve of its own cell.
    #[test]
    fn the_cell_of_a_path_is_the_likest() {
        let atlas = atlas(&[[0.5, 0.0], [0.5, 0.5], [1.0, -0.7]]);
        let cells = atlas.cells(0..45, 97, None);
        let points: Vec<Point> = cells[22]
            .curve
            .iter()
            .map(|p| Point::new(7.0 + 3.0 * p.y, 3.0 * p.x))
            .collect();
        let target = Target::new(&points, Course::Closed, None).unwrap();
        let cells = atlas.cells(0..45, 97, Some(&target));
        let likest = (cells.iter().enumerate())
            .filter_map(|(k, cell)| Some((k, cell.unlikeness?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap();
        assert!(likest.0 == 22 && likest.1 < 0.05, "{likest:?}");
    }

    /// Three eighths of the curve of a cell differ little from its own curve, and no unlikeness exceeds 1.
    #[test]
    fn an_open_path_is_compared_with_parts_of_curves() {
        let atlas = atlas(&[[0.5, 0.0], [0.5, 0.5], [1.0, -0.7]]);
        let curve = &atlas.cells(22..23, 97, None)[0].curve;
        let target = Target::new(&curve[20..56], Course::Open, None).unwrap();
        let cells = atlas.cells(0..45, 97, Some(&target));
        let own = cells[22].unlikeness.unwrap();
        assert!(own < 0.05, "{own}");
        let all: Vec<f64> = cells.iter().filter_map(|cell| cell.unlikeness).collect();
        let moving = cells.iter().filter(|cell| cell.grashof.is_some()).count();
        assert_eq!(all.len(), moving);
        assert!(
            all.iter()
                .all(|unlikeness| (0.0..=1.0).contains(unlikeness)),
            "{all:?}"
        );
    }

    #[test]
    fn impossible_atlases_are_refused() {
        let coupler = axis(Ratio::Coupler, [1.0, 4.0], 3);
        let rocker = axis(Ratio::Rocker, [1.0, 4.0], 3);
        let new = |axes, third, points: &[[f64; 2]]| Atlas::new(axes, third, points).err();
        assert_eq!(
            new([coupler; 2], 1.0, &[[0.0; 2]]),
            Some(AtlasError::SameRatio)
        );
        let frame = Some(AtlasError::Value(Ratio::Frame));
        assert_eq!(new([coupler, rocker], f64::NAN, &[[0.0; 2]]), frame);
        assert_eq!(new([coupler, rocker], 1.0, &[]), Some(AtlasError::Count(0)));
        let error = new([coupler, rocker], 1.0, &[[0.0; 2], [f64::INFINITY, 0.0]]);
        assert_eq!(error, Some(AtlasError::Point(1)));
        let endless = axis(Ratio::Rocker, [1.0, 4.0], usize::MAX);
        let error = new([coupler, endless], 1.0, &[[0.0; 2]]);
        assert_eq!(error, Some(AtlasError::Count(usize::MAX)));
    }
}
