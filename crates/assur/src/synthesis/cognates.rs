//! Cognates: linkages of other dimensions whose points trace the same curve (Roberts, 1875; Chebyshev, 1878).
//!
//! With complex numbers for points, let A₀, B₀ be the fixed pivots of a four-bar, A, B the joints of its coupler and P
//! the coupler point. The ratio w = (P − A)/(B − A) is constant. Then with the third pivot C₀ = A₀ + w(B₀ − A₀)
//!
//! P = A₀ + (A − A₀) + w(B − A),  w(B − B₀) = w(B − A) + w(A − A₀) − (C₀ − A₀),
//!
//! and the terms of these sums are turning bars of constant lengths. Two other orders of the bars are two other
//! four-bars, on the pivots A₀ and C₀ and on B₀ and C₀. Two bars that turn alike are the cranks of a five-bar with
//! gears ([`GearedFiveBar`]). Hartenberg and Denavit, *Kinematic Synthesis of Linkages*, 1964, ch. 6.
//!
//! If B₀ is at infinity, B moves on a straight line, and so does its image under the similarity about A₀ with the ratio
//! w. The cognate of a slider-crank is one slider-crank, with crank and rod exchanged ([`CouplerSliderCrank`]).

mod five_bar;
mod recognised;
mod slider_crank;

use nalgebra::Complex;

use crate::linkage::{DriverSpec, LinkageSpec};
use crate::tolerance::{COINCIDENT, FARTHEST};
use crate::{FourBar, Grashof, Invalid, Point, Vector};

pub use five_bar::GearedFiveBar;
pub use slider_crank::{CouplerSliderCrank, SliderCrankError};

/// A four-bar with a point of its coupler, in one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CouplerFourBar {
    pivots: [Point; 2],
    joints: [Point; 2],
    point: Point,
}

/// Reasons why places form no four-bar with a coupler point.
#[derive(Clone, Debug, PartialEq)]
pub enum CouplerError {
    /// A coordinate is not finite or is beyond 10⁹.
    NotFinite,
    /// The lengths form no linkage.
    Lengths(Vec<Invalid>),
}

/// Reasons why a linkage has no cognate on two of the pivots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoCognate {
    /// The coupler point is a joint of the coupler, and the cognate has no size: the curve is a circle, or an arc.
    AtJoint,
    /// Coupler and output of the cognate coincide and turn about a fixed joint. This occurs for a parallelogram, whose
    /// coupler points move on circles.
    Collapsed,
}

impl CouplerFourBar {
    /// The four-bar with fixed pivots A₀ and B₀, joints A and B of the coupler, and the coupler point P.
    ///
    /// # Errors
    /// The reason why there is no such linkage.
    pub fn new(pivots: [Point; 2], joints: [Point; 2], point: Point) -> Result<Self, CouplerError> {
        let found = Self {
            pivots,
            joints,
            point,
        };
        let places = [pivots[0], pivots[1], joints[0], joints[1], point];
        check_finite(&places).ok_or(CouplerError::NotFinite)?;
        FourBar::new(found.lengths()).map_err(CouplerError::Lengths)?;
        Ok(found)
    }

    /// A pose of the other assembly, with the joints reflected in the line of the fixed pivots. If the four-bar
    /// satisfies Grashof's condition, this pose is on the other circuit. None if all joints are on that line.
    pub fn reflected(&self) -> Option<Self> {
        let ([a, d], w) = (self.pivots, self.ratio());
        let frame = d - a;
        let normal = Vector::new(-frame.y, frame.x) / frame.norm();
        let heights = self.joints.map(|at| normal.dot(&(at - a)));
        let [b, c] = [0, 1].map(|k| self.joints[k] - normal * (2.0 * heights[k]));
        let size = self.lengths().into_iter().fold(0.0, f64::max);
        let is_distinct = heights
            .iter()
            .any(|height| height.abs() > COINCIDENT * size);
        let point = b + turned(w, c - b);
        let other = Self::new(self.pivots, [b, c], point).ok();
        other.filter(|_| is_distinct)
    }

    /// The fixed pivots of crank and rocker.
    pub fn pivots(&self) -> [Point; 2] {
        self.pivots
    }

    /// The joints of the coupler with crank and rocker.
    pub fn joints(&self) -> [Point; 2] {
        self.joints
    }

    /// The coupler point.
    pub fn point(&self) -> Point {
        self.point
    }

    /// Lengths l₁ … l₄ of crank, coupler, rocker and frame.
    pub fn lengths(&self) -> [f64; 4] {
        let ([a0, b0], [a, b]) = (self.pivots, self.joints);
        [a - a0, b - a, b - b0, b0 - a0].map(|bar| bar.norm())
    }

    /// The Grashof type.
    ///
    /// # Errors
    /// Every reason why the lengths form no linkage; only a cognate may have such lengths.
    pub fn grashof(&self) -> Result<Grashof, Vec<Invalid>> {
        FourBar::new(self.lengths()).map(|linkage| linkage.grashof())
    }

    /// w, the place of the coupler point relative to the coupler: 0 at the joint with the crank, 1 at the joint with
    /// the rocker.
    pub fn ratio(&self) -> Complex<f64> {
        let [a, b] = self.joints;
        complex(self.point - a) / complex(b - a)
    }

    /// C₀ = A₀ + w(B₀ − A₀), the third pivot of the cognates. With the other two it forms a triangle similar to the
    /// coupler with its point.
    pub fn third_pivot(&self) -> Point {
        let [a0, b0] = self.pivots;
        a0 + turned(self.ratio(), b0 - a0)
    }

    /// The other two four-bars whose coupler points trace the same curve: on the pivots A₀ and C₀, and on B₀ and C₀.
    /// Their cranks A₀A′ and B₀B′ turn as the coupler of this linkage does. The two cranks are also those of a geared
    /// five-bar.
    pub fn cognates(&self) -> [Result<Self, NoCognate>; 2] {
        let ([a0, b0], [a, b], p) = (self.pivots, self.joints, self.point);
        let (w, c0) = (self.ratio(), self.third_pivot());
        let first = {
            let joint = a0 + (p - a);
            let output = joint + turned(w, a - a0);
            self.cognate(w, [a0, c0], [joint, output])
        };
        let second = {
            let (joint, v) = (b0 + (p - b), Complex::from(1.0) - w);
            let output = joint + turned(v, b - b0);
            self.cognate(v, [b0, c0], [joint, output])
        };
        [first, second]
    }

    /// The cognate on given pivots, with given joints. Its size is |ratio| times that of this linkage.
    fn cognate(
        &self,
        ratio: Complex<f64>,
        pivots: [Point; 2],
        joints: [Point; 2],
    ) -> Result<Self, NoCognate> {
        if ratio.norm() <= COINCIDENT {
            return Err(NoCognate::AtJoint);
        }
        let diagonal = (joints[0] - pivots[1]).norm();
        if diagonal <= COINCIDENT * (pivots[1] - pivots[0]).norm() {
            return Err(NoCognate::Collapsed);
        }
        Ok(Self {
            pivots,
            joints,
            point: self.point,
        })
    }

    /// The five-bars with equal gears that trace the same curve, on the pivots A₀ and B₀, A₀ and C₀, B₀ and C₀. Their
    /// cranks turn as the coupler, the crank and the rocker of this linkage do. None if a crank has no length.
    pub fn geared(&self) -> [Option<GearedFiveBar>; 3] {
        let ([a0, b0], [a, b], p) = (self.pivots, self.joints, self.point);
        let (w, c0) = (self.ratio(), self.third_pivot());
        let v = Complex::from(1.0) - w;
        let five_bar = |pivots, joints| GearedFiveBar::new(pivots, joints, p);
        [
            five_bar([a0, b0], [a0 + (p - a), b0 + (p - b)]),
            five_bar([a0, c0], [a, c0 + turned(v, a - a0)]),
            five_bar([b0, c0], [b, c0 + turned(w, b - b0)]),
        ]
    }

    /// Specification of the linkage as a mechanism: links `crank`, `coupler` and `rocker`, joints A (A₀), B, C and D
    /// (B₀), traced point P. The driver is one that turns fully, if there is one: the crank, the rocker, or the coupler
    /// relative to the crank. Otherwise it is the crank.
    pub fn spec(&self) -> LinkageSpec {
        let ([a, d], [b, c]) = (self.pivots, self.joints);
        let mut spec = LinkageSpec::default();
        for (name, at) in [("A", a), ("B", b), ("C", c), ("D", d)] {
            spec = spec.point(name, at.x, at.y);
        }
        spec = spec.fixed(&["A", "D"]).bar("crank", &["A", "B"]);
        spec = with_traced(spec, "coupler", self.joints, self.point);
        spec = spec.bar("rocker", &["D", "C"]);
        match self.grashof() {
            Ok(Grashof::RockerCrank) => spec.crank("rocker"),
            Ok(Grashof::DoubleRocker) => {
                spec.drivers.push(DriverSpec::Crank {
                    link: "coupler".to_owned(),
                    base: "crank".to_owned(),
                    rate: 1.0,
                });
                spec
            }
            _ => spec.crank("crank"),
        }
    }
}

/// Minimum distance of a traced point from a joint, relative to the bar, at which it is listed as a point of the link.
const AT_JOINT: f64 = 1e-6;

/// Adds a link with the joints B and C and the traced point P: as a point of the link or, at a joint, by
/// [`LinkageSpec::tracer`].
fn with_traced(mut spec: LinkageSpec, link: &str, joints: [Point; 2], point: Point) -> LinkageSpec {
    let length = (joints[1] - joints[0]).norm();
    if joints
        .iter()
        .all(|at| (point - at).norm() > AT_JOINT * length)
    {
        spec = spec.point("P", point.x, point.y);
        return spec.bar(link, &["B", "C", "P"]);
    }
    let [along, across] = on_bar(joints, point);
    spec.bar(link, &["B", "C"]).tracer("P", link, along, across)
}

/// Coordinates of a point on a bar: along the bar from its first joint, and to the left.
fn on_bar([from, to]: [Point; 2], point: Point) -> [f64; 2] {
    let (bar, arm) = (to - from, point - from);
    let length = bar.norm();
    [arm.dot(&bar) / length, bar.perp(&arm) / length]
}

fn check_finite(places: &[Point]) -> Option<()> {
    let mut numbers = places.iter().flat_map(|place| place.coords.iter());
    numbers.all(|number| number.abs() <= FARTHEST).then_some(())
}

fn complex(vector: Vector) -> Complex<f64> {
    Complex::new(vector.x, vector.y)
}

/// Product of a complex number and a vector.
fn turned(ratio: Complex<f64>, vector: Vector) -> Vector {
    let product = ratio * complex(vector);
    Vector::new(product.re, product.im)
}

#[cfg(test)]
mod tests;
