//! The centre-point and circle-point curves of four poses as polylines, and the nearest point of a curve.

use std::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Vector2};

use super::cubic::{Cubic, Parallels};
use super::dyad::Dyad;
use super::locus::nearly_common;
use super::task::{Place, Task, Triple};
use crate::Point;

/// Number of steps into which a range of the parameter is divided first.
const FIRST_POINTS: usize = 48;
/// Maximum number of halvings of a step of the parameter. A piece that is in the window over only 10⁻¹² of the
/// parameter is still found.
const MAX_HALVINGS: usize = 40;
/// Greatest distance of a chord from the curve, relative to the window's diagonal: a quarter of a pixel if the diagonal
/// has 1000 pixels.
const FLATNESS: f64 = 2.5e-4;
/// Greatest length of a chord, relative to the window's diagonal.
const LONGEST: f64 = 1.0 / 24.0;
/// Number of steps of the search for the nearest point. Each reduces the bracket to 0.618 of its length.
const GOLDEN_STEPS: usize = 60;

/// Kind of curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Centre points, in the frame.
    Centre,
    /// Circle points of the body, in the first pose.
    Circle,
}

/// A point of a curve with the point that corresponds to it on the other curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Place on the curve.
    pub at: Point,
    /// The circle point of a centre point, or the centre point of a circle point.
    pub partner: Place,
    /// Index of the piece of the curve, for [`Curve::at`].
    pub piece: usize,
    /// Parameter on this piece.
    pub parameter: f64,
}

/// A curve of four poses, drawn in a window.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    task: Task,
    conditions: [Matrix3<f64>; 3],
    parallels: Parallels,
    pieces: Vec<Piece>,
    lines: Vec<Vec<CurvePoint>>,
}

/// A piece of a curve with the parameter τ: a loop, X = middle − half·cos τ, on which the root has the sign of sin τ;
/// or a parallel at X, Y = middle + half·τ.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece {
    Loop { middle: f64, half: f64 },
    Parallel { x: f64, middle: f64, half: f64 },
}

/// A rectangle in the unit of the task.
struct Window {
    middle: Vector2<f64>,
    half: Vector2<f64>,
    diagonal: f64,
}

/// A point of a piece: its parameter and its place, which is not finite for a point at infinity.
type Sample = (f64, Vector2<f64>);

impl CurvePoint {
    /// The dyad of this point, which is on a curve of a given kind, and its partner.
    pub fn dyad(&self, kind: Kind) -> Option<Dyad> {
        let at = Place::Finite(self.at);
        match kind {
            Kind::Centre => Dyad::of(self.partner, at),
            Kind::Circle => Dyad::of(at, self.partner),
        }
    }
}

impl Curve {
    /// Draws a curve of a task with four distinct poses, in the rectangle between two corners. A polyline ends where
    /// the curve leaves the rectangle. A closed branch ends at its first point.
    ///
    /// None if there are not four distinct poses, if the curve is the whole plane (the poses are special: see
    /// [`Task::special`]), or if the rectangle is empty or not finite.
    pub fn new(task: &Task, kind: Kind, corners: [Point; 2]) -> Option<Self> {
        let [a, b, c] = task.displacements() else {
            return None;
        };
        let conditions = [a, b, c].map(|one| match kind {
            Kind::Centre => *one.matrix(),
            Kind::Circle => one.matrix().transpose(),
        });
        let cubic = Cubic::determinant(conditions.each_ref());
        let parallels = Parallels::new(&cubic)?;
        let [from, to] = corners.map(|corner| task.triple(Place::Finite(corner)));
        let [from, to] = [from, to].map(|one| one.xy() / one.z);
        let window = Window {
            middle: 0.5 * (from + to),
            half: 0.5 * (to - from).abs(),
            diagonal: (to - from).norm(),
        };
        let sound = window.diagonal > 0.0 && window.diagonal.is_finite();
        let mut curve = Self {
            task: task.clone(),
            conditions,
            parallels,
            pieces: Vec::new(),
            lines: Vec::new(),
        };
        sound.then(|| curve.draw(&window))?;
        Some(curve)
    }

    /// The branches of the curve within the rectangle, as polylines.
    pub fn lines(&self) -> &[Vec<CurvePoint>] {
        &self.lines
    }

    /// The point of a piece at a parameter; None at infinity, or if there is no such piece.
    pub fn at(&self, piece: usize, parameter: f64) -> Option<CurvePoint> {
        let triple = self.triple(self.pieces.get(piece)?, parameter).normalize();
        let (Place::Finite(at), partner) = (self.task.place(triple), self.partner(triple)?) else {
            return None;
        };
        Some(CurvePoint {
            at,
            partner,
            piece,
            parameter,
        })
    }

    /// The point of the drawn curve that is nearest to a place; None if nothing is drawn.
    pub fn nearest(&self, place: Point) -> Option<CurvePoint> {
        let mut best: Option<(f64, usize, [f64; 2])> = None;
        for line in &self.lines {
            for (k, pair) in line.windows(2).enumerate() {
                let foot = crate::nearest(place, pair[0].at, pair[1].at);
                let distance = (foot - place).norm();
                if best.is_none_or(|(least, ..)| distance < least) {
                    let ends = [k.saturating_sub(1), (k + 2).min(line.len() - 1)];
                    best = Some((distance, pair[0].piece, ends.map(|k| line[k].parameter)));
                }
            }
        }
        let (_, piece, [mut from, mut to]) = best?;
        let distance = |parameter: f64| {
            let point = self.at(piece, parameter);
            point.map_or(f64::INFINITY, |point| (point.at - place).norm())
        };
        let golden = 0.5 * (5_f64.sqrt() - 1.0);
        for _ in 0..GOLDEN_STEPS {
            let step = golden * (to - from);
            if distance(to - step) < distance(from + step) {
                to = from + step;
            } else {
                from = to - step;
            }
        }
        self.at(piece, 0.5 * (from + to))
    }

    /// The point at infinity of the curve, as a direction, with its partner: a slide on the frame for the centre-point
    /// curve, a slide on the body for the circle-point curve. None if the curve contains all points at infinity.
    pub(super) fn infinite(task: &Task, kind: Kind) -> Option<[Triple; 2]> {
        let [a, b, c] = task.displacements() else {
            return None;
        };
        let conditions = [a, b, c].map(|one| match kind {
            Kind::Centre => *one.matrix(),
            Kind::Circle => one.matrix().transpose(),
        });
        let cubic = Cubic::determinant(conditions.each_ref());
        let leading = cubic.leading();
        if leading.norm() <= crate::tolerance::NEGLIGIBLE * cubic.size() {
            return None;
        }
        let at = crate::perpendicular(leading).normalize().push(0.0);
        let partner = nearly_common(&conditions.map(|one| one * at))?;
        Some([at, partner])
    }

    /// Points at about equal distances along the drawn curve.
    pub(super) fn spread(&self, count: usize) -> Vec<CurvePoint> {
        let pairs = || self.lines.iter().flat_map(|line| line.windows(2));
        let length = |pair: &[CurvePoint]| (pair[1].at - pair[0].at).norm();
        let step = pairs().map(length).sum::<f64>() / count as f64;
        let (mut found, mut passed) = (Vec::new(), 0.5 * step);
        for pair in pairs() {
            passed += length(pair);
            if passed >= step {
                passed -= step;
                found.push(pair[1]);
            }
        }
        found
    }

    fn partner(&self, triple: Triple) -> Option<Place> {
        let partner = nearly_common(&self.conditions.map(|one| one * triple))?;
        Some(self.task.place(partner))
    }

    fn triple(&self, piece: &Piece, parameter: f64) -> Triple {
        match *piece {
            Piece::Loop { middle, half } => {
                let x = middle - half * parameter.cos();
                let sign = if parameter.rem_euclid(TAU) < PI {
                    1.0
                } else {
                    -1.0
                };
                self.parallels.triple(x, self.parallels.ordinate(x, sign))
            }
            Piece::Parallel { x, middle, half } => {
                (self.parallels).triple(x, [middle + half * parameter, 1.0])
            }
        }
    }

    fn draw(&mut self, window: &Window) {
        let reach = 0.5 * window.diagonal;
        let middle = self.parallels.abscissa(window.middle);
        for [(from, first), (to, last)] in
            (self.parallels).intervals([middle - reach, middle + reach])
        {
            let piece = Piece::Loop {
                middle: 0.5 * (from + to),
                half: 0.5 * (to - from),
            };
            let paths: &[[f64; 2]] = match (first, last) {
                (true, false) => &[[-PI, PI]],
                (false, false) => &[[0.0, PI], [PI, TAU]],
                (_, true) => &[[0.0, TAU]],
            };
            self.pieces.push(piece);
            for path in paths {
                self.follow(window, *path);
            }
        }
        if let Some(x) = self.parallels.line {
            let along = self.parallels.infinite().xy();
            self.pieces.push(Piece::Parallel {
                x,
                middle: along.dot(&window.middle),
                half: reach,
            });
            self.follow(window, [-1.0, 1.0]);
        }
    }

    /// Draws the last piece over a range of its parameter.
    fn follow(&mut self, window: &Window, [from, to]: [f64; 2]) {
        let index = self.pieces.len() - 1;
        let piece = self.pieces[index];
        let sample = |parameter: f64| -> Sample {
            let triple = self.triple(&piece, parameter);
            (parameter, triple.xy() / triple.z)
        };
        let mut lines: Vec<Vec<f64>> = Vec::new();
        let mut open = false;
        let mut last = sample(from);
        for k in 1..=FIRST_POINTS {
            let next = sample(from + (to - from) * k as f64 / FIRST_POINTS as f64);
            // Ends of steps still to be tested, the next one last, each with its number of halvings.
            let mut steps = vec![(next, 0)];
            while let Some((end, halvings)) = steps.pop() {
                let is_flat = match window.judge(last.1, end.1) {
                    Step::Outside => {
                        open = false;
                        last = end;
                        continue;
                    }
                    Step::Long => false,
                    Step::Short => {
                        let middle = sample(0.5 * (last.0 + end.0)).1;
                        let off = (middle - 0.5 * (last.1 + end.1)).norm();
                        off <= FLATNESS * window.diagonal
                    }
                };
                if !is_flat && halvings < MAX_HALVINGS {
                    steps.push((end, halvings + 1));
                    steps.push((sample(0.5 * (last.0 + end.0)), halvings + 1));
                    continue;
                }
                if is_flat {
                    match lines.last_mut() {
                        Some(line) if open => line.push(end.0),
                        _ => lines.push(vec![last.0, end.0]),
                    }
                }
                open = is_flat;
                last = end;
            }
        }
        for line in lines {
            let points = line
                .into_iter()
                .filter_map(|parameter| self.at(index, parameter));
            let points: Vec<CurvePoint> = points.collect();
            if points.len() > 1 {
                self.lines.push(points);
            }
        }
    }
}

/// Result of a comparison of a chord with the window.
enum Step {
    Outside,
    Long,
    Short,
}

impl Window {
    fn judge(&self, from: Vector2<f64>, to: Vector2<f64>) -> Step {
        let middle = 0.5 * (from + to) - self.middle;
        let reach = 0.5 * (to - from).abs() + self.half;
        // A point at infinity gives NaN. Both comparisons are then false, and the chord is not outside.
        let apart = |k: usize| middle[k].abs() > reach[k];
        if apart(0) || apart(1) {
            Step::Outside
        } else if (to - from).norm() <= LONGEST * self.diagonal {
            Step::Short
        } else {
            Step::Long
        }
    }
}

#[cfg(test)]
mod tests;
