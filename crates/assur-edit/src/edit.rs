//! Edits of a drawing, as requested by the page.

use assur_file::LinkageDocument;
use serde::{Deserialize, Serialize};

/// One edit of a drawing. Lengths are in the unit of the drawing; parts are given by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "edit", rename_all = "snake_case", deny_unknown_fields)]
pub enum Edit {
    /// Adds a point, with `fixed` one of the frame.
    Point {
        /// Its position.
        at: [f64; 2],
        /// Whether it belongs to the frame.
        fixed: bool,
    },
    /// Adds a link between two ends.
    Bar {
        /// Its ends.
        ends: [End; 2],
    },
    /// Adds a point to a link, which makes a bar a plate.
    Corner {
        /// The link.
        link: String,
        /// The point.
        end: End,
    },
    /// Adds a block that is hinged at a point and slides along a line.
    Block {
        /// Its hinge.
        end: End,
        /// The line along which it slides.
        along: Line,
    },
    /// Lets a link slide as a whole along a line, without a hinge between them.
    Slide {
        /// The link.
        link: String,
        /// The line along which it slides.
        along: Line,
    },
    /// Adds two links and three pairs to the existing ones: an Assur group of Class II.
    Dyad {
        /// Its outer pairs, in turn.
        outer: [Outer; 2],
        /// Its inner pair.
        inner: Inner,
    },
    /// Adds a plate on three bars: the Assur group of Class III with only hinges.
    Triad {
        /// The ends of its bars.
        ends: [End; 3],
    },
    /// Adds a wheel that turns about a point.
    Wheel {
        /// Its centre.
        end: End,
    },
    /// Puts two wheels in mesh.
    Mesh {
        /// The links.
        links: [String; 2],
        /// Their numbers of teeth.
        teeth: [f64; 2],
        /// Whether the larger wheel is a ring.
        internal: bool,
    },
    /// Drives a link, or stops driving it.
    Drive {
        /// The link.
        link: String,
    },
    /// Makes a point one of the frame, or releases it.
    Fix {
        /// The point.
        point: String,
    },
    /// Moves points so that nearly satisfied redundant constraints, as in a drawing by hand, hold exactly.
    MakeExact {},
    /// Fixes two links to each other, or releases them.
    Weld {
        /// The links: the first is fixed to the second, which may be the frame.
        links: [String; 2],
    },
    /// Joins two points in one hinge, at the second one.
    Join {
        /// The point to be removed, and the one that stays.
        points: [String; 2],
    },
    /// Separates the links hinged at a point: each gets a point of its own.
    Part {
        /// The point.
        point: String,
    },
    /// Adds a traced point to a link.
    Trace {
        /// The link.
        link: String,
        /// Its position in the drawing.
        at: [f64; 2],
    },
    /// Sets a link's centre of mass, or removes it.
    Mass {
        /// The link.
        link: String,
        /// Its position in the drawing.
        at: Option<[f64; 2]>,
    },
    /// Moves points by a displacement.
    Move {
        /// The points.
        points: Vec<String>,
        /// The displacement.
        by: [f64; 2],
    },
    /// Moves a point, or a tracer, to a place.
    Place {
        /// The point.
        point: String,
        /// The place.
        at: [f64; 2],
    },
    /// Gives a link of two points a length: its second point moves along it.
    Stretch {
        /// The link.
        link: String,
        /// The new length.
        length: f64,
    },
    /// Turns a link about its first point to an angle.
    Turn {
        /// The link.
        link: String,
        /// The direction from its first point to its second, degrees.
        angle_deg: f64,
    },
    /// Renames a part.
    Rename {
        /// The present name, of a point or a tracer, or else of a link.
        name: String,
        /// The new name.
        to: String,
    },
    /// Removes parts, and those that cannot exist without them.
    Remove {
        /// Points and tracers.
        points: Vec<String>,
        /// Links.
        links: Vec<String>,
    },
    /// Adds another drawing beside the existing one, with free names.
    Paste {
        /// The drawing to be added.
        #[cfg_attr(test, ts(type = "LinkageDocument"))]
        drawing: Box<LinkageDocument>,
        /// Its displacement.
        by: [f64; 2],
    },
    /// Reflects points in the vertical through their middle.
    Mirror {
        /// The points.
        points: Vec<String>,
    },
    /// Locks the distance of two points, or the angle at the second of three, while points are moved, or unlocks it.
    Lock {
        /// Two or three points.
        points: Vec<String>,
    },
}

/// An end of a new part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// An existing point: a hinge.
    Point(String),
    /// A new point.
    At([f64; 2]),
    /// A new point of an existing link.
    On(String, [f64; 2]),
}

/// A line along which something slides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// The line of a link.
    Link(String),
    /// A line of the frame from the block towards a place.
    Toward([f64; 2]),
}

/// An outer pair of a group: its joint with the existing linkage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Outer {
    /// A hinge.
    Hinge(End),
    /// A slide along a line of a link, near a place.
    Slide(String, [f64; 2]),
    /// A slide along a horizontal line of the frame through a place.
    Level([f64; 2]),
}

/// The inner pair of a dyad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Inner {
    /// A hinge.
    Hinge,
    /// A slide.
    Slide,
}
