//! Change of the driver of a linkage or of its rate, starting from a given pose.

use super::{Changed, INPUT_STEPS};
use crate::mechanism::{Defect, DriverSpec, FRAME, LinkageSpec, Mechanism, Pose, SlideSpec};
use crate::motion::features::turning_points;
use crate::motion::{Motion, TooManyTurns};
use crate::sorting::extremes;
use crate::tolerance;

impl Motion {
    /// Specification of a driver for a link of [`Mechanism::drivable`]: the driver that the link already has, a crank,
    /// or a slide over its present range, each at the rate 1. None if the link cannot drive or does not move.
    ///
    /// # Errors
    /// The motion has too many turns to be searched for the range of a slide.
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
        let range = self.slide_range(&spec.slides[slide])?;
        let rate = 1.0;
        Ok(range.map(|range| DriverSpec::Slide { slide, range, rate }))
    }

    /// Minimum and maximum coordinate of a slide along a line of the frame, from its limit positions and the ends of
    /// the motion; None if the slide does not move.
    fn slide_range(&self, slide: &SlideSpec) -> Result<Option<[f64; 2]>, TooManyTurns> {
        let mechanism = &self.mechanism;
        let point = mechanism.point(&slide.point);
        let [from, to] = [0, 1].map(|end| mechanism.spec().place(&slide.line[end]));
        let (Some(point), Some(from), Some(to)) = (point, from, to) else {
            debug_assert!(false, "a mechanism has the points of its slides");
            return Ok(None);
        };
        let along = (to - from).normalize();
        let coordinate = self.telling(|pose: &Pose<3>| {
            let place = mechanism.place(pose, point);
            (place.x + -from.x) * along.x + (place.y + -from.y) * along.y
        });
        let limits = turning_points(self, &|input| coordinate(input).ok(), mechanism.size())?;
        let limits = limits.into_iter().map(|limit| limit.value);
        // Dead points and change points have positions, but may have no derivatives: their positions are added to the
        // limits.
        let ends = self.cycle.arcs().iter().flatten().copied();
        let ends = ends.chain(self.change_points.iter().copied());
        let ends = ends.chain([self.drawn_input]).filter_map(|input| {
            let pose = self.pose::<1>(input).ok()?;
            Some((mechanism.place(&pose, point).place() - from).dot(&along))
        });
        let coordinates = limits.chain(ends);
        let range = extremes(coordinates);
        let moves = range[1] - range[0] > tolerance::COINCIDENT * mechanism.size();
        Ok(moves.then_some(range))
    }

    /// Returns the linkage with a new rate of a driver other than the first, given by its index. The linkage starts
    /// from the pose at an input or, if there is none, from the drawn pose.
    ///
    /// # Errors
    /// The defects of the linkage at the new rate.
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

    /// Returns the linkage with another driver, starting from the pose at an input. If this pose is a dead point of the
    /// new driver, the linkage starts from a pose next to it.
    ///
    /// # Errors
    /// The defects of the linkage with the new driver; empty if there is no pose at the input or next to it.
    pub fn driven_by(&self, driver: &DriverSpec, input: f64) -> Result<Changed, Vec<Defect>> {
        let mut found = Err(Vec::new());
        let offsets = INPUT_STEPS.into_iter().flat_map(|step| [step, -step]);
        for offset in [0.0].into_iter().chain(offsets) {
            let Ok(pose) = self.pose::<1>(input + offset * self.mechanism.span()) else {
                continue;
            };
            let mut spec = self.mechanism.shaped_in(&pose);
            drive_first(&mut spec, driver);
            match Mechanism::new(&spec) {
                Ok(mechanism) => {
                    let motion = Self::new(mechanism);
                    let (input, gave_way) = (motion.drawn_input, offset != 0.0);
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
}

/// Makes a given driver the first one. A driver that the linkage already has changes places with the first one, and the
/// rates of the further drivers are divided by its old rate. Any other driver replaces the first one.
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
