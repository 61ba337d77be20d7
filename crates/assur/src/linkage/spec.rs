//! A specification of a linkage, valid or not. [`crate::mechanism::Mechanism::new`] refuses an invalid one.

use super::TracerSpec;
use crate::gears::Mesh;
use crate::mechanism::Singularity;
use crate::{Point, Vector};

/// The name of the frame, a link that every linkage has.
pub const FRAME: &str = "frame";

/// A linkage, valid or not. Points and links are referred to by name; lengths are in any one unit.
///
/// ```
/// use assur::linkage::LinkageSpec;
/// // A slider-crank, drawn as a triangle 3-4-5 with the crank upright.
/// let slider_crank = LinkageSpec::default()
///     .point("A", 0.0, 0.0).point("B", 0.0, 3.0).point("C", 4.0, 0.0).point("E", 9.0, 0.0)
///     .fixed(&["A", "E"]).bar("crank", &["A", "B"]).bar("rod", &["B", "C"]).bar("slider", &["C"])
///     .slide("slider", "C", "frame", ["A", "E"]).crank("crank");
/// assert!(slider_crank.defects().is_empty());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkageSpec {
    /// Every point, with its place in the drawing.
    pub points: Vec<PointSpec>,
    /// Names of the points of the frame, which stay where they are drawn.
    pub frame: Vec<String>,
    /// The moving links. Links that list the same point are hinged to each other at this point.
    pub links: Vec<LinkSpec>,
    /// Prismatic pairs.
    pub slides: Vec<SlideSpec>,
    /// Gear couplings.
    pub gears: Vec<GearSpec>,
    /// Drivers, one for each degree of freedom. The input is the coordinate of the first driver. The coordinate of each
    /// further driver changes from its drawn value in proportion to the change of the input from the drawn input.
    pub drivers: Vec<DriverSpec>,
    /// Traced points: points of links that join nothing.
    pub tracers: Vec<TracerSpec>,
}

/// A point with its place in the drawing. The drawing shows one pose. This pose selects the assembly, and gives the
/// dimensions of links without a shape of their own.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSpec {
    /// Unique name of the point.
    pub name: String,
    /// Place of the point in the drawing.
    pub at: Point,
}

/// A moving link: a rigid body that holds points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkSpec {
    /// Unique name of the link.
    pub name: String,
    /// Names of the link's points: joints, which other links list too, and other points, such as a centre of mass. The
    /// angle of the link is the direction from its first to its second point.
    pub points: Vec<String>,
    /// Coordinates of the points on the link, in the order of `points`; None if the drawing gives the dimensions.
    pub shape: Option<Vec<Point>>,
    /// The link, or the frame, to which this link is fixed, as a wheel to its shaft: both turn as one.
    pub fixed_to: Option<String>,
    /// Name of the centre of mass, one of the points of the link. None for a uniform bar between the first two points,
    /// or for a link of one point.
    pub centre_of_mass: Option<String>,
    /// Mass of the link; none counts as zero.
    pub mass: Option<f64>,
    /// Moment of inertia of the link about its centre of mass, in units of mass and of length. None stands for the
    /// ml²/12 of a uniform bar or, if the centre of mass is given, for zero.
    pub inertia: Option<f64>,
}

/// A prismatic pair: `link` slides along a straight line of the link `on`.
#[derive(Clone, Debug, PartialEq)]
pub struct SlideSpec {
    /// The link that slides.
    pub link: String,
    /// Point of the sliding link that stays at its drawn distance from the line.
    pub point: String,
    /// The link with the line, or the frame.
    pub on: String,
    /// Two points of `on` that give the line.
    pub line: [String; 2],
}

/// A gear coupling of two links hinged to the same carrier: `z₁(θ₁ − θ₀) ± z₂(θ₂ − θ₀) = const` (R. Willis,
/// *Principles of Mechanism*, 1841). The links have z₁ and z₂ teeth and the angles θ₁ and θ₂; the carrier has the angle
/// θ₀. The drawing gives the constant. A wheel with no point but its hinge is mounted so that the angles of both wheels
/// relative to the carrier are zero together.
#[derive(Clone, Debug, PartialEq)]
pub struct GearSpec {
    /// The two links in mesh.
    pub links: [String; 2],
    /// The link, or the frame, to which both links are hinged.
    pub carrier: String,
    /// Numbers of teeth of the two links.
    pub teeth: [f64; 2],
    /// Kind of mesh.
    pub mesh: Mesh,
}

/// A driven pair.
#[derive(Clone, Debug, PartialEq)]
pub enum DriverSpec {
    /// A link turned about a point that it shares with `base`; the coordinate is the link's angle relative to the base.
    Crank {
        /// The link that is turned.
        link: String,
        /// The link, or the frame, relative to which the driven link turns.
        base: String,
        /// Rate of this driver's coordinate relative to the first driver's coordinate; 1 for the first driver.
        rate: f64,
    },
    /// A slide moved along its line. The coordinate is the position of the slide's point along the line, from the first
    /// point of the line towards the second.
    Slide {
        /// Index of the slide in the specification.
        slide: usize,
        /// Minimum and maximum coordinate.
        range: [f64; 2],
        /// Rate of this driver's coordinate relative to the first driver's coordinate; 1 for the first driver.
        rate: f64,
    },
}

impl DriverSpec {
    /// Rate of this driver's coordinate relative to the first driver's coordinate.
    pub fn rate(&self) -> f64 {
        match self {
            Self::Crank { rate, .. } | Self::Slide { rate, .. } => *rate,
        }
    }

    pub(crate) fn rate_mut(&mut self) -> &mut f64 {
        match self {
            Self::Crank { rate, .. } | Self::Slide { rate, .. } => rate,
        }
    }
}

/// A defect of a specification, with the names of the points or links at fault.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "code", rename_all = "snake_case")
)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Defect {
    /// Two points, or two links, with the same name; or a link with the name of the frame.
    Twice { name: String },
    /// The name of a point or of a link that does not exist.
    UnknownName { name: String },
    /// A coordinate, a mass, a moment of inertia or an end of a range that is not finite, or is outside the allowed
    /// values.
    NotFinite { name: String },
    /// A link with a negative mass.
    NegativeMass { link: String, mass: f64 },
    /// A link with a moment of inertia that no body has: negative, or not zero without a mass.
    ImpossibleInertia { link: String, inertia: f64 },
    /// A driven slide whose range has its ends in the wrong order.
    RangeReversed { link: String, from: f64, to: f64 },
    /// A driven slide whose range has equal ends.
    RangeEmpty { link: String, at: f64 },
    /// A driven slide that is drawn so far outside its range that the linkage does not close as drawn.
    DrawnBeyondRange {
        link: String,
        at: f64,
        from: f64,
        to: f64,
    },
    /// A link without points.
    Bare { link: String },
    /// Two points of a link that coincide.
    Coincident { link: String, points: [String; 2] },
    /// A link that lists a point twice.
    Repeated { link: String, point: String },
    /// A link whose shape does not have exactly one place for each point.
    Shape { link: String },
    /// A point that should belong to a link, but does not.
    NotOnLink { link: String, point: String },
    /// A link fixed to, sliding on, geared with or driven relative to itself; or a ring of links fixed to each other.
    WithItself { link: String },
    /// Two links that should be hinged to each other, but share no point.
    NotHinged { links: [String; 2] },
    /// A number of teeth that is not whole, positive and in range.
    Teeth { link: String, value: f64 },
    /// Wheels with equal numbers of teeth in internal mesh: their centres would coincide.
    Concentric { links: [String; 2] },
    /// No driver, or a driven slide that does not exist.
    NoDriver,
    /// Links that nothing joins to the frame.
    Loose { links: Vec<String> },
    /// Fewer drivers than degrees of freedom: these links stay free. `mobility` is W by count.
    Underdriven { mobility: isize, links: Vec<String> },
    /// Links that are locked by too many pairs, or driven twice. `mobility` is W by count.
    Locked { mobility: isize, links: Vec<String> },
    /// Links that can move only for an instant: the rank of their constraints allows a motion in the drawn pose, but
    /// the constraints hold in no pose near it.
    Instant { links: Vec<String> },
    /// A driver whose rate is not finite, is not 1 for the first driver, or prevents the motion from repeating within
    /// 24 turns of the first crank.
    Rate { link: String, rate: f64 },
    /// Links whose guides are parallel, but must cross.
    ParallelGuides { links: Vec<String> },
    /// Links whose angles are not determined by their meshes: the meshes repeat a condition, or contradict each other.
    TrainUndetermined { links: Vec<String> },
    /// Two wheels whose mesh closes a ring of wheels with a contradictory ratio: the wheels cannot turn together.
    MeshContradicts { links: [String; 2] },
    /// A group of these links that cannot be solved yet.
    Unsupported { links: Vec<String> },
    /// Links of a group that cannot be joined as drawn. `by` is the length by which they fail to meet.
    Open { links: Vec<String>, by: f64 },
    /// Links of a group drawn in a singular position, at a dead point.
    Singular {
        links: Vec<String>,
        singularity: Singularity,
    },
    /// Links whose angle is undetermined as drawn: two hinges, joined to each other only by these links, coincide.
    CoincidentHinges { links: Vec<String> },
    /// A point so far from its drawn place, once its links are joined, that the drawing cannot select the assembly.
    Misdrawn { point: String, by: f64 },
}

/// Methods that build a specification line by line, without checks.
impl LinkageSpec {
    /// Adds a point drawn at (x, y).
    #[must_use]
    pub fn point(mut self, name: &str, x: f64, y: f64) -> Self {
        let (name, at) = (name.to_owned(), Point::new(x, y));
        self.points.push(PointSpec { name, at });
        self
    }

    /// Adds points of the frame.
    #[must_use]
    pub fn fixed(mut self, points: &[&str]) -> Self {
        self.frame
            .extend(points.iter().map(|point| (*point).to_owned()));
        self
    }

    /// Adds a moving link with given points and the dimensions of the drawing.
    #[must_use]
    pub fn bar(mut self, name: &str, points: &[&str]) -> Self {
        self.links.push(LinkSpec {
            name: name.to_owned(),
            points: points.iter().map(|point| (*point).to_owned()).collect(),
            ..LinkSpec::default()
        });
        self
    }

    /// Gives the last link a mass and a moment of inertia about its centre of mass, one of its points.
    #[must_use]
    pub fn with_mass(mut self, mass: f64, centre: &str, inertia: f64) -> Self {
        if let Some(link) = self.links.last_mut() {
            link.mass = Some(mass);
            link.centre_of_mass = Some(centre.to_owned());
            link.inertia = Some(inertia);
        }
        self
    }

    /// Adds a slide: a point of `link` slides along the line through two points of `on`.
    #[must_use]
    pub fn slide(mut self, link: &str, point: &str, on: &str, line: [&str; 2]) -> Self {
        self.slides.push(SlideSpec {
            link: link.to_owned(),
            point: point.to_owned(),
            on: on.to_owned(),
            line: line.map(str::to_owned),
        });
        self
    }

    /// Adds a driver that turns a link relative to the frame.
    #[must_use]
    pub fn crank(mut self, link: &str) -> Self {
        let (link, base) = (link.to_owned(), FRAME.to_owned());
        let rate = 1.0;
        self.drivers.push(DriverSpec::Crank { link, base, rate });
        self
    }

    /// Sets the rate of the last driver relative to the first.
    #[must_use]
    pub fn at_rate(mut self, new: f64) -> Self {
        if let Some(driver) = self.drivers.last_mut() {
            *driver.rate_mut() = new;
        }
        self
    }

    /// The link that a driver turns or moves; None if the driven slide does not exist.
    pub fn driven<'a>(&'a self, driver: &'a DriverSpec) -> Option<&'a str> {
        match driver {
            DriverSpec::Crank { link, .. } => Some(link),
            DriverSpec::Slide { slide, .. } => {
                let slide = self.slides.get(*slide);
                slide.map(|slide| slide.link.as_str())
            }
        }
    }

    /// The links that can be driven: cranks, links that slide along a line of the frame, and links that have a driver.
    pub fn drivable(&self) -> Vec<&str> {
        let cranks = self.links.iter().filter(|link| self.is_crank(link));
        let cranks = cranks.map(|link| link.name.as_str());
        let slides = self.slides.iter().filter(|slide| slide.on == FRAME);
        let slides = slides.map(|slide| slide.link.as_str());
        let mut found: Vec<&str> = cranks.chain(slides).collect();
        for driver in &self.drivers {
            let driven = self.driven(driver);
            found.extend(driven.filter(|link| *link != FRAME && !found.contains(link)));
        }
        found
    }

    /// True if a link can be driven as a crank: it is hinged to the frame and not fixed to another link.
    pub(crate) fn is_crank(&self, link: &LinkSpec) -> bool {
        let hinged = |point: &String| self.frame.contains(point);
        link.fixed_to.is_none() && link.points.iter().any(hinged)
    }

    /// Place of a point in the drawing.
    pub(crate) fn place(&self, name: &str) -> Option<Point> {
        let point = self.points.iter().find(|point| point.name == name);
        point.map(|point| point.at)
    }

    pub(crate) fn link(&self, name: &str) -> Option<&LinkSpec> {
        self.links.iter().find(|link| link.name == name)
    }

    /// The diagonal of the drawing: the size of the mechanism.
    pub(crate) fn size(&self) -> f64 {
        extent(self.points.iter().map(|point| point.at.coords))
    }
}

/// Diagonal of the bounding box of given places.
pub(crate) fn extent(places: impl Iterator<Item = Vector>) -> f64 {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for place in places {
        low = low.inf(&place);
        high = high.sup(&place);
    }
    (high - low).norm()
}
