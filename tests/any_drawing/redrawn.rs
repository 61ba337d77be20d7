//! Other drawings of the same linkage: in another pose, moved, turned, mirrored, scaled, or with the parts renamed and
//! in another order.

use std::f64::consts::TAU;

use assur::mechanism::{DriverSpec, LinkageSpec};
use assur::{Point, Vector};

use super::shown::Shown;
use crate::properties::random::Random;

/// A drawing of `size` is moved by no more than so many sizes.
const FARTHEST: f64 = 6.0;
/// Coordinates beyond this are no drawing, by the engine's own rule.
const BOUND: f64 = 1e9;

/// How a linkage is drawn otherwise, beside another pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Change {
    Pose,
    Moved,
    Turned,
    Mirrored,
    Scaled,
    Renamed,
    All,
}

pub(crate) const CHANGES: [Change; 7] = [
    Change::Pose,
    Change::Moved,
    Change::Turned,
    Change::Mirrored,
    Change::Scaled,
    Change::Renamed,
    Change::All,
];

/// A similarity of the plane, and new names.
#[derive(Clone, Debug)]
pub(crate) struct Redrawn {
    pub(crate) draft: LinkageSpec,
    angle: f64,
    mirrored: bool,
    pub(crate) scale: f64,
    by: Vector,
    crank: bool,
    /// Of each point and link of the original its number here.
    pub(crate) points: Vec<usize>,
    pub(crate) links: Vec<usize>,
}

impl Redrawn {
    /// Drawn in a pose of its own motion. None where that would be no drawing: too large.
    pub(crate) fn new(
        draft: &LinkageSpec,
        size: f64,
        pose: &Shown,
        change: Change,
        random: &mut Random,
    ) -> Option<Self> {
        let is = |one: Change| change == one || change == Change::All;
        let scale = if is(Change::Scaled) {
            10.0_f64.powf(random.within(-9.0, 9.0))
        } else {
            1.0
        };
        let far = random.within(0.0, FARTHEST).min(8.5 - scale.log10());
        let direction = random.within(0.0, TAU);
        let by = if is(Change::Moved) {
            Vector::new(direction.cos(), direction.sin()) * (10.0_f64.powf(far) * size * scale)
        } else {
            Vector::zeros()
        };
        let angle = if is(Change::Turned) {
            random.within(0.0, TAU)
        } else {
            0.0
        };
        let orders = |count: usize, random: &mut Random| {
            let mut order: Vec<usize> = (0..count).collect();
            if is(Change::Renamed) {
                for k in (1..count).rev() {
                    order.swap(k, random.below(k + 1));
                }
            }
            order
        };
        let mut redrawn = Self {
            angle,
            mirrored: is(Change::Mirrored),
            scale,
            by,
            crank: matches!(draft.drivers[0], DriverSpec::Crank { .. }),
            points: orders(draft.points.len(), random),
            links: orders(draft.links.len(), random),
            draft: draft.clone(),
        };
        redrawn.draw(draft, pose);
        if is(Change::Renamed) {
            redrawn.rename(random);
        }
        let mut points = redrawn.draft.points.iter();
        let bounded = points.all(|point| point.at.coords.amax() <= BOUND);
        bounded.then_some(redrawn)
    }

    /// A direction and length, as they are here.
    pub(crate) fn vector(&self, v: Vector) -> Vector {
        let v = if self.mirrored {
            Vector::new(v.x, -v.y)
        } else {
            v
        };
        let (sin, cos) = self.angle.sin_cos();
        Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y) * self.scale
    }

    /// A place, as it is here.
    pub(crate) fn place(&self, at: Vector) -> Vector {
        self.vector(at) + self.by
    }

    /// By how much the input grows here with that of the original.
    pub(crate) fn input_rate(&self) -> f64 {
        if self.crank { self.sense() } else { self.scale }
    }

    /// −1 where what turned one way turns the other.
    pub(crate) fn sense(&self) -> f64 {
        if self.mirrored { -1.0 } else { 1.0 }
    }

    /// An angle, as it is here.
    pub(crate) fn angle(&self, angle: f64) -> f64 {
        self.sense() * angle + self.angle
    }

    /// How far the drawing is from the origin, in its own sizes.
    pub(crate) fn far(&self, size: f64) -> f64 {
        let points = self.draft.points.iter();
        let far = points.fold(0.0, |far: f64, point| far.max(point.at.coords.norm()));
        far / (self.scale * size)
    }

    fn draw(&mut self, draft: &LinkageSpec, pose: &Shown) {
        let mut points = draft.points.clone();
        for (point, at) in points.iter_mut().zip(&pose.points) {
            // What the frame has stays, to the last digit.
            let fixed = draft.frame.contains(&point.name);
            let at = if fixed { point.at.coords } else { at[0] };
            point.at = self.place(at).into();
        }
        let mut links = draft.links.clone();
        for link in &mut links {
            for at in link.shape.iter_mut().flatten() {
                let mirrored = if self.mirrored { -at.y } else { at.y };
                *at = Point::new(at.x * self.scale, mirrored * self.scale);
            }
        }
        self.draft.points = reordered(points, &self.points);
        self.draft.links = reordered(links, &self.links);
        for driver in &mut self.draft.drivers {
            if let DriverSpec::Slide { range, .. } = driver {
                *range = range.map(|end| end * self.scale);
            }
        }
    }

    /// Other names, the rest in another order; what an angle or a way is counted from stays.
    fn rename(&mut self, random: &mut Random) {
        let salt = random.below(1_000);
        let name = |old: &mut String| {
            if old != assur::mechanism::FRAME {
                let turned: String = old.chars().rev().collect();
                *old = format!("{turned}-{salt}");
            }
        };
        let draft = &mut self.draft;
        draft.frame.reverse();
        draft.gears.reverse();
        draft.slides.reverse();
        let slides = draft.slides.len();
        draft
            .points
            .iter_mut()
            .for_each(|point| name(&mut point.name));
        draft.frame.iter_mut().for_each(name);
        for link in &mut draft.links {
            name(&mut link.name);
            link.points.iter_mut().for_each(name);
            link.fixed_to.iter_mut().for_each(name);
            if link.points.len() > 2 {
                link.points[2..].reverse();
                if let Some(shape) = &mut link.shape {
                    shape[2..].reverse();
                }
            }
        }
        for slide in &mut draft.slides {
            name(&mut slide.link);
            name(&mut slide.point);
            name(&mut slide.on);
            slide.line.iter_mut().for_each(name);
        }
        for gear in &mut draft.gears {
            gear.links.reverse();
            gear.teeth.reverse();
            gear.links.iter_mut().for_each(name);
            name(&mut gear.carrier);
        }
        for driver in &mut draft.drivers {
            match driver {
                DriverSpec::Crank { link, base, .. } => {
                    name(link);
                    name(base);
                }
                DriverSpec::Slide { slide, .. } => *slide = slides - 1 - *slide,
            }
        }
    }
}

/// Things in another order: of each its new number.
fn reordered<T>(things: Vec<T>, numbers: &[usize]) -> Vec<T> {
    let mut numbered: Vec<(usize, T)> = numbers.iter().copied().zip(things).collect();
    numbered.sort_by_key(|(number, _)| *number);
    numbered.into_iter().map(|(_, thing)| thing).collect()
}

/// The draft with the dimensions that it has as it is drawn written out, so that another drawing
/// tells the pose alone. What is fixed to another link lies on it as drawn.
pub(crate) fn with_shapes(draft: &LinkageSpec) -> LinkageSpec {
    let mut draft = draft.clone();
    let places = draft.points.clone();
    let place = |name: &String| places.iter().find(|point| point.name == *name).unwrap().at;
    for link in &mut draft.links {
        if link.fixed_to.is_none() && link.points.len() > 1 {
            link.shape = Some(link.points.iter().map(place).collect());
        }
    }
    draft
}
