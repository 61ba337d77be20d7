//! A linkage as given by a person, valid or not. [`crate::mechanism::Mechanism::new`] lists all its defects.

use super::TracerSpec;
use crate::gears::Mesh;
use crate::mechanism::Singularity;
use crate::{Point, Vector};

/// The name of the frame, a link that every linkage has.
pub const FRAME: &str = "frame";

/// A linkage, valid or not. Its parts refer to each other by name; lengths are in any one unit.
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
    /// The points of the frame, by name; they stay where they are drawn.
    pub frame: Vec<String>,
    /// The moving links. Links that list the same point are hinged there.
    pub links: Vec<LinkSpec>,
    /// Prismatic pairs.
    pub slides: Vec<SlideSpec>,
    /// Gear couplings.
    pub gears: Vec<GearSpec>,
    /// Drivers, as many as there are freedoms. The input is the coordinate of the first driver; the coordinate of each
    /// further driver grows in proportion to it from its drawn value.
    pub drivers: Vec<DriverSpec>,
    /// Points that links carry and that join nothing: tracer points.
    pub tracers: Vec<TracerSpec>,
}

/// A point. The drawing shows one pose: it selects the assembly and gives the dimensions of links without a shape of
/// their own.
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
    /// Its points, by name: joints with other links that list them too, and
    /// points of its own (tracer points, centres of mass). The link's angle runs
    /// from its first to its second point.
    pub points: Vec<String>,
    /// The places of the points on the link, in the same order; None if as drawn.
    pub shape: Option<Vec<Point>>,
    /// The link to which this one is fixed, as a wheel to its shaft: both turn as one.
    pub fixed_to: Option<String>,
    /// Name of the centre of mass, one of the points of the link.
    pub centre_of_mass: Option<String>,
    /// Mass of the link, kilograms.
    pub mass: Option<f64>,
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

/// A gear coupling of two links hinged on the same carrier: relative to it, the second turns with the first in the
/// ratio of the teeth, `z₁(θ₁ − θ₀) ± z₂(θ₂ − θ₀) = const` (R. Willis, *Principles of Mechanism*, 1841). The drawing
/// gives the constant; a wheel with nothing but its hinge is mounted so that its angle relative to the carrier is zero
/// when its mate's is.
#[derive(Clone, Debug, PartialEq)]
pub struct GearSpec {
    /// The two links.
    pub links: [String; 2],
    /// Link on which both links are hinged, or the frame.
    pub carrier: String,
    /// Numbers of teeth.
    pub teeth: [f64; 2],
    /// Kind of mesh.
    pub mesh: Mesh,
}

/// A driven pair.
#[derive(Clone, Debug, PartialEq)]
pub enum DriverSpec {
    /// A link turned about a point that it shares with `base`; the coordinate is its angle relative to the base.
    Crank {
        /// The link that is turned.
        link: String,
        /// The link, or the frame, relative to which it is turned.
        base: String,
        /// Rate of its coordinate relative to the first driver's; 1 for the first.
        rate: f64,
    },
    /// A slide moved along its line; the coordinate is the position of its point along the line, from the first point
    /// of the line towards the second.
    Slide {
        /// Index of the slide.
        slide: usize,
        /// Minimum and maximum coordinate.
        range: [f64; 2],
        /// Rate of its coordinate relative to the first driver's; 1 for the first.
        rate: f64,
    },
}

impl DriverSpec {
    /// Rate of its coordinate relative to the first driver's.
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

/// A defect of a specification, with the names of the parts at fault.
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
    /// Two points, or two links, of one name; or a link named as the frame.
    Twice { name: String },
    /// A point, or a link, that is named somewhere and does not exist.
    UnknownName { name: String },
    /// A coordinate, a mass or a range that is not finite, or out of any range.
    NotFinite { name: String },
    /// A driven slide with a range given backwards.
    RangeReversed { link: String, from: f64, to: f64 },
    /// A driven slide whose range begins and ends at one place.
    RangeEmpty { link: String, at: f64 },
    /// A driven slide drawn outside its range, so far that the linkage does not close as drawn.
    DrawnBeyondRange {
        link: String,
        at: f64,
        from: f64,
        to: f64,
    },
    /// A link without points.
    Bare { link: String },
    /// Two points of a link at one place.
    Coincident { link: String, points: [String; 2] },
    /// A link that lists a point twice.
    Repeated { link: String, point: String },
    /// A link whose shape does not have one place for each point.
    Shape { link: String },
    /// A point that a link should have and does not.
    NotOnLink { link: String, point: String },
    /// A link fixed to, sliding on or geared with itself, or a ring of links
    /// fixed to each other.
    WithItself { link: String },
    /// Two links that should be hinged on each other and share no point.
    NotHinged { links: [String; 2] },
    /// A number of teeth that is not whole, positive and in range.
    Teeth { link: String, value: f64 },
    /// Equal wheels in internal mesh: one would lie on the other.
    Concentric { links: [String; 2] },
    /// No driver, or a driven slide that does not exist.
    NoDriver,
    /// Links that nothing joins to the frame.
    Loose { links: Vec<String> },
    /// Fewer drivers than freedoms, by the mobility W of the count: these links stay free.
    Underdriven { mobility: isize, links: Vec<String> },
    /// Links locked by too many pairs, or driven twice, with the mobility W by the count.
    Locked { mobility: isize, links: Vec<String> },
    /// Links whose constraints allow a motion by their rank in the drawn pose, but hold in no pose beside it.
    Instant { links: Vec<String> },
    /// A driver whose rate is not finite, or for the first not 1; or with which the motion would not repeat within 24
    /// turns of the first crank.
    Rate { link: String, rate: f64 },
    /// Parallel guides of these links that must cross.
    ParallelGuides { links: Vec<String> },
    /// Wheels in mesh whose numbers of teeth do not determine the angles of these links: their mates turn alike.
    TrainUndetermined { links: Vec<String> },
    /// Two wheels whose mesh closes a ring of wheels with another ratio than the rest of it: they can turn together
    /// with all the others only if none turns.
    MeshContradicts { links: [String; 2] },
    /// A group of these links, which cannot be solved yet.
    Unsupported { links: Vec<String> },
    /// Links of a group that cannot be joined in the drawn position, and the distance between the joints that miss each
    /// other.
    Open { links: Vec<String>, by: f64 },
    /// Links of a group drawn in a singular position, at a dead point.
    Singular {
        links: Vec<String>,
        singularity: Singularity,
    },
    /// Links that may have any angle as drawn: two hinges coincide that are joined by these links only.
    CoincidentHinges { links: Vec<String> },
    /// A point whose links put it elsewhere than drawn, too far for the drawing to select the assembly.
    Misdrawn { point: String, by: f64 },
}

/// Building a specification line by line; nothing is checked yet.
impl LinkageSpec {
    /// With a point drawn at (x, y).
    #[must_use]
    pub fn point(mut self, name: &str, x: f64, y: f64) -> Self {
        let (name, at) = (name.to_owned(), Point::new(x, y));
        self.points.push(PointSpec { name, at });
        self
    }

    /// With points of the frame.
    #[must_use]
    pub fn fixed(mut self, points: &[&str]) -> Self {
        self.frame
            .extend(points.iter().map(|point| (*point).to_owned()));
        self
    }

    /// With a moving link of these points, as drawn.
    #[must_use]
    pub fn bar(mut self, name: &str, points: &[&str]) -> Self {
        self.links.push(LinkSpec {
            name: name.to_owned(),
            points: points.iter().map(|point| (*point).to_owned()).collect(),
            ..LinkSpec::default()
        });
        self
    }

    /// With a link that slides, by a point of it, along the line of two points.
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

    /// Driven by turning a link on the frame.
    #[must_use]
    pub fn crank(mut self, link: &str) -> Self {
        let (link, base) = (link.to_owned(), FRAME.to_owned());
        let rate = 1.0;
        self.drivers.push(DriverSpec::Crank { link, base, rate });
        self
    }

    /// With this rate of the last driver relative to the first.
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

    /// The links that can be driven: cranks, links that slide along a line of the frame, and links driven now.
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

    /// True if a link can be driven as a crank: hinged on the frame, fixed to no other.
    pub(crate) fn is_crank(&self, link: &LinkSpec) -> bool {
        let hinged = |point: &String| self.frame.contains(point);
        link.fixed_to.is_none() && link.points.iter().any(hinged)
    }

    /// The drawn place of a point.
    pub(crate) fn place(&self, name: &str) -> Option<Point> {
        let point = self.points.iter().find(|point| point.name == name);
        point.map(|point| point.at)
    }

    /// The link of this name.
    pub(crate) fn link(&self, name: &str) -> Option<&LinkSpec> {
        self.links.iter().find(|link| link.name == name)
    }

    /// The diagonal of the drawing: the size of the mechanism.
    pub(crate) fn size(&self) -> f64 {
        extent(self.points.iter().map(|point| point.at.coords))
    }
}

/// The diagonal of the bounding box of places.
pub(crate) fn extent(places: impl Iterator<Item = Vector>) -> f64 {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for place in places {
        low = low.inf(&place);
        high = high.sup(&place);
    }
    (high - low).norm()
}
