//! The slider-crank with a point of its rod, and its cognate.

use nalgebra::Complex;

use super::{NoCognate, check_finite, complex, turned, with_traced};
use crate::linkage::LinkageSpec;
use crate::tolerance::COINCIDENT;
use crate::{Point, Vector, perpendicular};

/// A slider-crank with a point of its rod, in one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CouplerSliderCrank {
    pivot: Point,
    joints: [Point; 2],
    guide: Vector,
    point: Point,
}

/// Reasons why places form no slider-crank with a point of its rod.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliderCrankError {
    /// A coordinate is not finite or is beyond 10⁹.
    NotFinite,
    /// The crank has no length.
    Crank,
    /// The rod has no length.
    Rod,
    /// The guide has no direction.
    Guide,
}

impl CouplerSliderCrank {
    /// The slider-crank with the pivot A₀ of the crank, the joints A and B of the rod, of which B moves along the
    /// direction of the guide, and the point P of the rod.
    ///
    /// # Errors
    /// The reason why there is no such linkage.
    pub fn new(
        pivot: Point,
        joints: [Point; 2],
        guide: Vector,
        point: Point,
    ) -> Result<Self, SliderCrankError> {
        let [a, b] = joints;
        let places = [pivot, a, b, point, Point::from(guide)];
        check_finite(&places).ok_or(SliderCrankError::NotFinite)?;
        let (crank, rod) = ((a - pivot).norm(), (b - a).norm());
        let size = crank + rod + (b - pivot).norm();
        if crank <= COINCIDENT * size {
            return Err(SliderCrankError::Crank);
        }
        if rod <= COINCIDENT * size {
            return Err(SliderCrankError::Rod);
        }
        let guide = guide.try_normalize(0.0).ok_or(SliderCrankError::Guide)?;
        Ok(Self {
            pivot,
            joints,
            guide,
            point,
        })
    }

    /// The fixed pivot of the crank.
    pub fn pivot(&self) -> Point {
        self.pivot
    }

    /// The joints of the rod with crank and slider.
    pub fn joints(&self) -> [Point; 2] {
        self.joints
    }

    /// Direction of the guide, a unit vector.
    pub fn guide(&self) -> Vector {
        self.guide
    }

    /// The point of the rod.
    pub fn point(&self) -> Point {
        self.point
    }

    /// Lengths of crank and rod, and the offset of the guide from the pivot, positive to the left of its direction.
    pub fn lengths(&self) -> [f64; 3] {
        let [a, b] = self.joints;
        let offset = (b - self.pivot).dot(&perpendicular(self.guide));
        [(a - self.pivot).norm(), (b - a).norm(), offset]
    }

    /// w, the place of the point relative to the rod: 0 at the joint with the crank, 1 at the slider.
    pub fn ratio(&self) -> Complex<f64> {
        let [a, b] = self.joints;
        complex(self.point - a) / complex(b - a)
    }

    /// The other slider-crank whose point traces the same curve: its crank turns as this rod does, its rod as this
    /// crank, and both are |w| times as long. Its guide is this one turned by arg w about the pivot.
    ///
    /// # Errors
    /// [`NoCognate::AtJoint`] if the point is the joint of crank and rod.
    pub fn cognate(&self) -> Result<Self, NoCognate> {
        let ([a, _], w) = (self.joints, self.ratio());
        if w.norm() <= COINCIDENT {
            return Err(NoCognate::AtJoint);
        }
        let joint = self.pivot + (self.point - a);
        Ok(Self {
            pivot: self.pivot,
            joints: [joint, joint + turned(w, a - self.pivot)],
            guide: turned(w / w.norm(), self.guide),
            point: self.point,
        })
    }

    /// Specification as a mechanism: links `crank` (A, B), `rod` (B, C) and `slider` (C), the guide from D to E, traced
    /// point P. The crank is driven if it turns fully, or if the rod does not turn fully relative to it; otherwise the
    /// rod, relative to the crank.
    pub fn spec(&self) -> LinkageSpec {
        let (a, [b, c]) = (self.pivot, self.joints);
        let [crank, rod, offset] = self.lengths();
        let reach = self.guide * (crank + rod);
        let foot = a + perpendicular(self.guide) * offset;
        let (d, e) = (foot - reach, foot + reach);
        let mut spec = LinkageSpec::default();
        for (name, at) in [("A", a), ("B", b), ("C", c), ("D", d), ("E", e)] {
            spec = spec.point(name, at.x, at.y);
        }
        spec = spec.fixed(&["A", "D", "E"]).bar("crank", &["A", "B"]);
        spec = with_traced(spec, "rod", self.joints, self.point)
            .bar("slider", &["C"])
            .slide("slider", "C", "frame", ["D", "E"]);
        if rod + offset.abs() < crank {
            spec.drivers.push(crate::linkage::DriverSpec::Crank {
                link: "rod".to_owned(),
                base: "crank".to_owned(),
                rate: 1.0,
            });
            return spec;
        }
        spec.crank("crank")
    }
}
