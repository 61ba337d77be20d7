//! Change of a dimension within one assembly, in steps from the given pose to the new value. If a loop would otherwise
//! open, the input is changed, too: this is called *giving way*.

mod driver;
mod path;

use super::Motion;
use crate::index::{LinkId, PointId};
use crate::mechanism::{Assembled, Cause, Defect, Dimension, Mechanism, NoNeighbour, Setting};
use crate::{Point, tolerance};
use path::Path;

/// A linkage after a change.
#[derive(Clone, Debug)]
pub struct Changed {
    /// Motion of the mechanism, drawn in its new pose.
    pub motion: Motion,
    /// Input of the new pose: the previous input if possible.
    pub input: f64,
    /// True if the input gave way during the change, or if a new driver starts from a pose next to the given one.
    pub gave_way: bool,
}

/// Reason why a dimension cannot be set.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The dimension does not exist.
    Absent,
    /// The value is not finite.
    NotFinite,
    /// A length is not positive.
    NotPositive,
    /// There is no pose to start from.
    Unposed,
    /// The loop opens before the value is reached.
    LoopOpen {
        /// Last possible value, rounded to the accuracy to which it is found.
        last: f64,
        /// Difference between the wanted and the last possible value.
        by: f64,
        /// Links that cannot be joined beyond the last possible value.
        links: Vec<LinkId>,
        /// Cause of the open loop.
        cause: Cause,
    },
    /// The linkage with this value is not a mechanism in any assembly.
    Defects(Vec<Defect>),
}

/// Resolution to which the last possible value is found, as a fraction of the dimension's range. The value is rounded
/// to a multiple of the smallest power of ten that is not below this resolution.
const RESOLUTION: f64 = 2e-4;
/// Steps by which the input gives way, relative to the span of the input. At the end of a change the input is moved
/// back, until a step back fails that is at most as long as the first of these steps.
const INPUT_STEPS: [f64; 4] = [1.0 / 1024.0, 1.0 / 256.0, 1.0 / 64.0, 1.0 / 34.0];

impl Motion {
    /// Returns the linkage with a dimension set to a value, starting from the pose at an input.
    ///
    /// # Errors
    /// The reason why the value cannot be set, with the last possible value.
    pub fn changed(
        &self,
        dimension: Dimension,
        value: f64,
        input: f64,
    ) -> Result<Changed, Refusal> {
        let range = self.mechanism.range(dimension).ok_or(Refusal::Absent)?;
        let from = self.mechanism.value(dimension).ok_or(Refusal::Absent)?;
        if !value.is_finite() {
            return Err(Refusal::NotFinite);
        }
        if matches!(dimension, Dimension::Length(_) | Dimension::Side(..)) && value <= 0.0 {
            return Err(Refusal::NotPositive);
        }
        if let Dimension::Side(link, [1, point]) = dimension {
            return self.side_changed((link, point), value, input);
        }
        let start = self.at_hand(input)?;
        let frame = start.spec().clone();
        let value = self.mechanism.nearest(dimension, value);
        let width = range[1] - range[0];
        let sense = (value - from).signum();
        let at = |length: f64| from + length * width * sense;
        let whole = (value - from).abs() / width;
        let setting = |length: f64| {
            let value = if length < whole { at(length) } else { value };
            dimension.setting(&frame, value)
        };
        let path = Path::follow(start.clone(), setting, whole);
        let Some(mut obstacle) = path.obstacle else {
            return self.arrived(&path);
        };
        // The last value is rounded towards the start. The path to the rounded value may meet another obstacle, which
        // gives a new last value; this is done up to three times.
        let unit = 10_f64.powf((RESOLUTION * width).log10().ceil());
        let mut last = at(path.length);
        for _ in 0..3 {
            last = unit * (sense * last / unit).floor() * sense;
            let whole = (last - from) * sense / width;
            let tried = Path::follow(start.clone(), setting, whole.max(0.0));
            match tried.obstacle {
                Some(other) => (obstacle, last) = (other, at(tried.length)),
                None => break,
            }
        }
        let open = match obstacle {
            NoNeighbour::LoopOpen(open) => open,
            NoNeighbour::Defects(defects) => return Err(Refusal::Defects(defects)),
        };
        let last = if (last - from) * sense > 0.0 {
            last
        } else {
            from
        };
        Err(Refusal::LoopOpen {
            last,
            by: (value - last).abs(),
            links: open.links,
            cause: open.cause,
        })
    }

    /// Returns the linkage with a side of a link set to a value: the opposite corner changes by the law of cosines.
    fn side_changed(
        &self,
        (link, point): (LinkId, usize),
        value: f64,
        input: f64,
    ) -> Result<Changed, Refusal> {
        let dimension = Dimension::Corner(link, point);
        let drawn = self.mechanism.value(dimension).ok_or(Refusal::Absent)?;
        let [a, b] = self.mechanism.beside_corner(link, point);
        let cosine = (a * a + b * b - value * value) / (2.0 * a * b);
        let corner = cosine.clamp(-1.0, 1.0).acos().copysign(drawn);
        let (last, links, cause) = match self.changed(dimension, corner, input) {
            Err(Refusal::LoopOpen {
                last, links, cause, ..
            }) => {
                let side = (a * a + b * b - 2.0 * a * b * last.cos()).sqrt();
                (side, links, cause)
            }
            changed => {
                let last = value.clamp((a - b).abs(), a + b);
                let by = (value - last).abs();
                if changed.is_err() || by <= tolerance::CONVERGED * (a + b) {
                    return changed;
                }
                // The three sides do not satisfy the triangle inequality.
                (last, vec![link], Cause::OutOfReach { by })
            }
        };
        Err(Refusal::LoopOpen {
            last,
            by: (value - last).abs(),
            links,
            cause,
        })
    }

    /// Returns the linkage with a hinge of the frame moved to a point, or as far towards the point as possible,
    /// starting from the pose at an input.
    ///
    /// # Errors
    /// The reason why the hinge cannot be moved at all.
    pub fn hinge_moved(&self, point: PointId, to: Point, input: f64) -> Result<Changed, Refusal> {
        if !to.coords.iter().all(|x| x.is_finite()) {
            return Err(Refusal::NotFinite);
        }
        let start = self.at_hand(input)?;
        let from = start.spec().points[point.index()].at;
        let range = self.mechanism.range(Dimension::X(point));
        let [least, most] = range.ok_or(Refusal::Absent)?;
        let whole = (to - from).norm() / (most - least);
        let setting = |length: f64| {
            let at = if length < whole {
                from + length / whole * (to - from)
            } else {
                to
            };
            Setting::Hinge(point, at)
        };
        self.arrived(&Path::follow(start, setting, whole))
    }

    /// The linkage assembled in the pose at an input, or in the drawn pose if the input has no pose.
    fn at_hand(&self, input: f64) -> Result<Assembled, Refusal> {
        let inputs = [input, self.drawn_input].into_iter();
        let mut poses = inputs.filter_map(|input| Some((input, self.pose::<1>(input).ok()?)));
        let (input, pose) = poses.next().ok_or(Refusal::Unposed)?;
        Assembled::new(&self.mechanism, &pose, input).map_err(|_| Refusal::Unposed)
    }

    /// The motion of the linkage at the end of a path.
    fn arrived(&self, path: &Path) -> Result<Changed, Refusal> {
        let mechanism = Mechanism::new(path.here.spec()).map_err(Refusal::Defects)?;
        let motion = Self::new(mechanism);
        // If the motion takes more than one turn, the crank angle alone does not determine the pose.
        let input = path.here.input();
        let distance = (motion.cycle.wrap(input) - motion.drawn_input).abs();
        let is_drawn = distance <= tolerance::COINCIDENT * motion.mechanism.span();
        let input = if is_drawn { input } else { motion.drawn_input };
        let gave_way = path.gave_way;
        Ok(Changed {
            motion,
            input,
            gave_way,
        })
    }
}
