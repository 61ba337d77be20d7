//! Changing a linkage: its assembly is kept by following it from the pose at hand to
//! the new value, step by step; the input gives way where it must.

use super::features::turning_points;
use super::{Motion, TooManyTurns};
use crate::Point;
use crate::index::{LinkId, PointId};
use crate::mechanism::{
    Assembled, Cause, Defect, Dimension, DriverSpec, FRAME, LinkageSpec, LoopOpen, Mechanism,
    NoNeighbour, Pose, Setting, SlideSpec,
};

/// A linkage after a change.
#[derive(Clone, Debug)]
pub struct Changed {
    /// Of the mechanism drawn in the pose in which it is.
    pub motion: Motion,
    /// Its input there: the one that it was changed at, where that could be kept.
    pub input: f64,
    /// Whether the input gave way, if only for a part of the change.
    pub gave_way: bool,
}

/// Why a dimension cannot be set.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// There is no such dimension.
    Absent,
    /// The value is not finite.
    NotFinite,
    /// A length that is not greater than zero.
    NotPositive,
    /// There is no pose to begin with.
    Unposed,
    /// Links come apart on the way.
    LoopOpen {
        /// The last value that works, cut to the digits that tell it.
        last: f64,
        /// How far beyond it the value lies.
        by: f64,
        /// The links that cannot be joined beyond it.
        links: Vec<LinkId>,
        /// What is in their way.
        cause: Cause,
    },
    /// With this value it is no mechanism, however it is joined.
    Defects(Vec<Defect>),
}

/// A change begins with a step of this part of the range of the dimension …
const FIRST_STEP: f64 = 0.25;
/// … the input gives way where one this small fails …
const LEAST_STEP: f64 = 1.0 / 1024.0;
/// … and the last value that works is found to this part, and told as exactly.
const RESOLUTION: f64 = 2e-4;
/// Sides of a straight triangle add up to this part.
const ROUNDED: f64 = 1e-14;
/// No more steps are tried; of which the input gives way in few.
const MOST_TRIES: usize = 200;
/// So often a last value is tried.
const TRIED: usize = 3;
/// Two inputs this near, relative to the span, are the same.
const TOLD: f64 = 1e-9;
/// So often it goes on giving way.
const FURTHER: usize = 8;
/// By these parts of its span the input gives way. The least is how near it comes to
/// where links come apart.
const WAYS: [f64; 4] = [1.0 / 1024.0, 1.0 / 256.0, 1.0 / 64.0, 1.0 / 34.0];

impl Motion {
    /// The linkage with a dimension set to a value, from the pose at an input.
    ///
    /// # Errors
    /// Why it cannot be, with the last value that works.
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
        let at = |way: f64| from + way * width * sense;
        let whole = (value - from).abs() / width;
        let setting = |way: f64| {
            let here = if way < whole { at(way) } else { value };
            dimension.setting(&frame, here)
        };
        let way = Way::follow(start.clone(), setting, whole);
        let Some(mut stopped) = way.stopped else {
            return self.taken(&way);
        };
        // Cut towards where it came from, and tried: the way there may be another one.
        let unit = 10_f64.powf((RESOLUTION * width).log10().ceil());
        let mut last = at(way.gone);
        for _ in 0..TRIED {
            last = unit * (sense * last / unit).floor() * sense;
            let whole = (last - from) * sense / width;
            let tried = Way::follow(start.clone(), setting, whole.max(0.0));
            match tried.stopped {
                Some(other) => (stopped, last) = (other, at(tried.gone)),
                None => break,
            }
        }
        let apart = match stopped {
            NoNeighbour::LoopOpen(apart) => apart,
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
            links: apart.links,
            cause: apart.cause,
        })
    }

    /// The linkage with a side of a link set to a value by the corner that it is opposite to: the law of cosines.
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
                if changed.is_err() || by <= ROUNDED * (a + b) {
                    return changed;
                }
                // The sides beside it are too short for it, or differ by more.
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

    /// The linkage with a hinge of the frame moved to a place, from the pose at an
    /// input: both of its coordinates set at once. Where it cannot come there, as far
    /// as it goes.
    ///
    /// # Errors
    /// Why it cannot be moved at all.
    pub fn hinge_moved(&self, point: PointId, to: Point, input: f64) -> Result<Changed, Refusal> {
        if !to.coords.iter().all(|x| x.is_finite()) {
            return Err(Refusal::NotFinite);
        }
        let start = self.at_hand(input)?;
        let from = start.spec().points[point.index()].at;
        let range = self.mechanism.range(Dimension::X(point));
        let [least, most] = range.ok_or(Refusal::Absent)?;
        let whole = (to - from).norm() / (most - least);
        let setting = |way: f64| {
            let here = if way < whole {
                from + way / whole * (to - from)
            } else {
                to
            };
            Setting::Hinge(point, here)
        };
        self.taken(&Way::follow(start, setting, whole))
    }

    /// The driver that a link of [`Mechanism::drivable`] is: the one that it is already, a crank, or a slide over the
    /// way that it goes now; none of a link that is no driver, or that does not move.
    ///
    /// # Errors
    /// Of a slide in a motion of too many turns the way is not looked for.
    pub fn driver(&self, link: &str) -> Result<Option<DriverSpec>, TooManyTurns> {
        let mechanism = &self.mechanism;
        let spec = mechanism.spec();
        let mut drivers = spec.drivers.iter();
        if let Some(driver) = drivers.find(|driver| spec.driven(driver) == Some(link)) {
            let mut driver = driver.clone();
            *driver.rate_mut() = 1.0;
            return Ok(Some(driver));
        }
        if mechanism
            .cranks()
            .any(|crank| mechanism.link_name(crank) == link)
        {
            return Ok(Some(DriverSpec::Crank {
                link: link.to_owned(),
                base: FRAME.to_owned(),
                rate: 1.0,
            }));
        }
        let mut slides = spec.slides.iter();
        let slide = slides.position(|slide| slide.link == link && slide.on == FRAME);
        let Some(slide) = slide else {
            return Ok(None);
        };
        let range = self.way(&spec.slides[slide])?;
        let rate = 1.0;
        Ok(range.map(|range| DriverSpec::Slide { slide, range, rate }))
    }

    /// The least and the greatest way of a slide along a line of the frame, found at its limit positions and at the ends of
    /// the motion; none of one that stays where it is.
    fn way(&self, slide: &SlideSpec) -> Result<Option<[f64; 2]>, TooManyTurns> {
        let mechanism = &self.mechanism;
        let point = mechanism.point(&slide.point);
        let [from, to] = [0, 1].map(|end| mechanism.spec().place(&slide.line[end]));
        let (Some(point), Some(from), Some(to)) = (point, from, to) else {
            debug_assert!(false, "a mechanism has the points of its slides");
            return Ok(None);
        };
        let along = (to - from).normalize();
        let way = self.telling(|pose: &Pose<3>| {
            let place = mechanism.place(pose, point);
            (place.x + -from.x) * along.x + (place.y + -from.y) * along.y
        });
        let limits = turning_points(self, &|input| way(input).ok(), mechanism.size())?;
        let limits = limits.into_iter().map(|limit| limit.value);
        // At a dead point there is a place, but no derivative.
        let ends = self.cycle.arcs().iter().flatten().copied();
        let ends = ends.chain(self.change_points.iter().copied());
        let ends = ends.chain([self.drawn_input]).filter_map(|input| {
            let pose = self.pose::<1>(input).ok()?;
            Some((mechanism.place(&pose, point).place() - from).dot(&along))
        });
        let ways = limits.chain(ends);
        let range = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], way| {
            [least.min(way), most.max(way)]
        });
        let moves = range[1] - range[0] > TOLD * mechanism.size();
        Ok(moves.then_some(range))
    }

    /// The linkage with a further driver, by its place among all, at another rate, from the pose at an input.
    ///
    /// # Errors
    /// Why it cannot go so.
    pub fn at_rate(&self, driver: usize, rate: f64, input: f64) -> Result<Changed, Vec<Defect>> {
        let pose = self
            .pose::<1>(input)
            .or_else(|_| self.pose::<1>(self.drawn_input));
        let mut spec = match pose {
            Ok(pose) => self.mechanism.shaped_in(&pose),
            Err(_) => self.mechanism.spec().clone(),
        };
        if let Some(driver) = spec.drivers.get_mut(driver) {
            *driver.rate_mut() = rate;
        }
        let motion = Self::new(Mechanism::new(&spec)?);
        Ok(Changed {
            input: motion.drawn_input,
            gave_way: false,
            motion,
        })
    }

    /// The linkage with another driver, from the pose at an input; where that pose is a
    /// dead point of the new driver, from one next to it.
    ///
    /// # Errors
    /// Why it cannot be driven so.
    pub fn driven_by(&self, driver: &DriverSpec, input: f64) -> Result<Changed, Vec<Defect>> {
        let mut found = Err(Vec::new());
        let aside = WAYS.into_iter().flat_map(|part| [part, -part]);
        for part in [0.0].into_iter().chain(aside) {
            let Ok(pose) = self.pose::<1>(input + part * self.mechanism.span()) else {
                continue;
            };
            let mut spec = self.mechanism.shaped_in(&pose);
            drive_first(&mut spec, driver);
            match Mechanism::new(&spec) {
                Ok(mechanism) => {
                    let motion = Self::new(mechanism);
                    let (input, gave_way) = (motion.drawn_input, part != 0.0);
                    let moves = motion.pose::<3>(input).is_ok();
                    let changed = Changed {
                        motion,
                        input,
                        gave_way,
                    };
                    if moves {
                        return Ok(changed);
                    }
                    found = found.or(Ok(changed));
                }
                Err(defects) => found = found.or(Err(defects)),
            }
        }
        found
    }

    /// The pose at an input, or else the drawn one.
    fn at_hand(&self, input: f64) -> Result<Assembled, Refusal> {
        let inputs = [input, self.drawn_input].into_iter();
        let mut poses = inputs.filter_map(|input| Some((input, self.pose::<1>(input).ok()?)));
        let (input, pose) = poses.next().ok_or(Refusal::Unposed)?;
        Assembled::new(&self.mechanism, &pose, input).map_err(|_| Refusal::Unposed)
    }

    /// What was followed as a motion of its own.
    fn taken(&self, way: &Way) -> Result<Changed, Refusal> {
        let mechanism = Mechanism::new(way.here.spec()).map_err(Refusal::Defects)?;
        let motion = Self::new(mechanism);
        // Where the crank goes over more than a turn, its angle alone does not tell which.
        let input = way.here.input();
        let told =
            (motion.cycle.wrap(input) - motion.drawn_input).abs() <= TOLD * motion.mechanism.span();
        let input = if told { input } else { motion.drawn_input };
        let gave_way = way.gave_way;
        Ok(Changed {
            motion,
            input,
            gave_way,
        })
    }
}

/// A change as far as it was followed. What it has gone is told in ranges of the
/// dimension: a shorter change goes the same way as a longer one.
struct Way {
    here: Assembled,
    gone: f64,
    gave_way: bool,
    /// What stopped it, if it has not gone the whole way.
    stopped: Option<NoNeighbour>,
}

impl Way {
    /// Goes the whole way, or as far as it can.
    fn follow(start: Assembled, setting: impl Fn(f64) -> Setting, whole: f64) -> Self {
        let mut tries = 0;
        let wanted = start.input();
        let mut way = Self {
            here: start,
            gone: 0.0,
            gave_way: false,
            stopped: None,
        };
        let mut step = FIRST_STEP;
        while way.gone < whole && way.stopped.is_none() {
            let next = (way.gone + step).min(whole);
            step = next - way.gone;
            tries += 1;
            match way.here.neighbour(setting(next), way.here.input()) {
                Ok(there) => (way.here, way.gone, step) = (there, next, 2.0 * step),
                Err(none) if step <= LEAST_STEP || tries > MOST_TRIES => {
                    let beside = match &none {
                        NoNeighbour::LoopOpen(apart) => aside(&way.here, setting(next), apart),
                        NoNeighbour::Defects(_) => None,
                    };
                    match beside {
                        Some(there) => {
                            (way.here, way.gone, step) = (there, next, 2.0 * step);
                            way.gave_way = true;
                        }
                        None if step <= RESOLUTION || tries > MOST_TRIES => {
                            way.stopped = Some(none);
                        }
                        None => step *= 0.5,
                    }
                }
                Err(_) => step *= 0.5,
            }
        }
        let setting = setting(way.gone);
        way.here = returned(way.here, setting, wanted);
        way
    }
}

/// The neighbour at another input: of those there are, the one whose links that came
/// apart are farthest from it; and on the same way for as long as they get farther.
fn aside(here: &Assembled, setting: Setting, apart: &LoopOpen) -> Option<Assembled> {
    let margin = |one: &Assembled| one.margin(apart.step);
    let better = |a: &Assembled, b: &Assembled| margin(a).total_cmp(&margin(b));
    let next = |from: &Assembled, way: f64| {
        let input = from.input() + way * from.span();
        from.neighbour(setting, input).ok()
    };
    let ways = WAYS.into_iter().flat_map(|way| [way, -way]);
    let mut best = ways.filter_map(|way| next(here, way)).max_by(better)?;
    let sense = (best.input() - here.input()).signum();
    for _ in 0..FURTHER {
        let mut ways = WAYS.into_iter().rev();
        match ways.find_map(|way| next(&best, sense * way)) {
            Some(further) if better(&further, &best).is_gt() => best = further,
            _ => break,
        }
    }
    Some(best)
}

/// As near to the wanted input as it comes.
fn returned(here: Assembled, setting: Setting, wanted: f64) -> Assembled {
    let mut here = here;
    let mut step = 1.0_f64;
    while here.input() != wanted {
        let way = wanted - here.input();
        let next = if step < 1.0 {
            here.input() + step * way
        } else {
            wanted
        };
        match here.neighbour(setting, next) {
            Ok(there) => {
                here = there;
                step = (2.0 * step).min(1.0);
            }
            Err(_) if (step * way).abs() <= WAYS[0] * here.span() => break,
            Err(_) => step *= 0.5,
        }
    }
    here
}

/// Makes a driver the first. A further one that it was before gives its place, and its rate the other way round, to
/// the first that there was; else that one drives no more.
fn drive_first(spec: &mut LinkageSpec, driver: &DriverSpec) {
    let driven = spec.driven(driver);
    let mut all = spec.drivers.iter();
    let before = all.position(|one| spec.driven(one) == driven);
    let rate = before.map_or(1.0, |before| spec.drivers[before].rate());
    if let Some(before) = before {
        spec.drivers.swap(0, before);
    }
    if let Some(first) = spec.drivers.first_mut() {
        *first = driver.clone();
    }
    for further in spec.drivers.iter_mut().skip(1) {
        *further.rate_mut() /= rate;
    }
}
