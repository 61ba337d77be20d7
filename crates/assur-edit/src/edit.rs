//! What can be done to a drawing, as the page asks for it.

use assur_file::LinkageDocument;
use serde::{Deserialize, Serialize};

/// One edit of a drawing. Lengths are those of the drawing; things are named as they are in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "edit", rename_all = "snake_case", deny_unknown_fields)]
pub enum Edit {
    /// A point by itself; with `fixed` one of the frame.
    Point {
        /// Where it is.
        at: [f64; 2],
        /// Whether the frame has it.
        fixed: bool,
    },
    /// A link between two places.
    Bar {
        /// Its ends.
        ends: [End; 2],
    },
    /// One more point of a link, which makes a plate of a bar.
    Corner {
        /// The link.
        link: String,
        /// The point.
        end: End,
    },
    /// A block that is hinged at a point and slides along a line.
    Block {
        /// Where it is hinged.
        end: End,
        /// What it slides along.
        along: Line,
    },
    /// A link that slides as a whole along a line, with no hinge between.
    Slide {
        /// The link.
        link: String,
        /// What it slides along.
        along: Line,
    },
    /// Two links and three pairs between what is there: an Assur group of Class II.
    Dyad {
        /// Its outer pairs, in turn.
        outer: [Outer; 2],
        /// Its inner pair.
        inner: Inner,
    },
    /// A plate on three bars: the Assur group of Class III with hinges alone.
    Triad {
        /// The ends of its bars.
        ends: [End; 3],
    },
    /// A wheel that turns about a point.
    Wheel {
        /// Its centre.
        end: End,
    },
    /// Two wheels come into mesh.
    Mesh {
        /// The links.
        links: [String; 2],
        /// Their numbers of teeth.
        teeth: [f64; 2],
        /// Whether the larger one is a ring.
        internal: bool,
    },
    /// A link is driven, or no more if it was.
    Drive {
        /// The link.
        link: String,
    },
    /// A point becomes one of the frame, or is let go.
    Fix {
        /// The point.
        point: String,
    },
    /// Points go where redundant constraints hold that nearly did: those of a drawing by hand.
    MakeExact {},
    /// Two links turn as one from now on, or no more if they did.
    Weld {
        /// The links: the first is fixed to the second, which may be the frame.
        links: [String; 2],
    },
    /// Two points become one hinge, where the second is.
    Join {
        /// The point that goes, and the one that stays.
        points: [String; 2],
    },
    /// Every link gets a point of its own where they were hinged.
    Part {
        /// The point.
        point: String,
    },
    /// A point that a link carries and whose path is drawn.
    Trace {
        /// The link.
        link: String,
        /// Where it is in the drawing.
        at: [f64; 2],
    },
    /// A link's centre of mass is where a point is put; without one it has none.
    Mass {
        /// The link.
        link: String,
        /// Where it is in the drawing.
        at: Option<[f64; 2]>,
    },
    /// Points move by as much.
    Move {
        /// The points.
        points: Vec<String>,
        /// By how much.
        by: [f64; 2],
    },
    /// A point, or a tracer, stands at a place.
    Place {
        /// The point.
        point: String,
        /// The place.
        at: [f64; 2],
    },
    /// A link of two points has a length from now on: its second point moves along it.
    Stretch {
        /// The link.
        link: String,
        /// Its length.
        length: f64,
    },
    /// A link stands at an angle: its other points turn about its first one.
    Turn {
        /// The link.
        link: String,
        /// The direction from its first point to its second, degrees.
        angle_deg: f64,
    },
    /// Another name.
    Rename {
        /// What is renamed: a point or a tracer, or else a link.
        name: String,
        /// Its name from now on.
        to: String,
    },
    /// What is named goes, and with it what cannot be without it.
    Remove {
        /// Points and tracers.
        points: Vec<String>,
        /// Links.
        links: Vec<String>,
    },
    /// Another drawing is put beside what is there, under names that are free.
    Paste {
        /// What is put there.
        #[cfg_attr(test, ts(type = "LinkageDocument"))]
        drawing: Box<LinkageDocument>,
        /// By how much it is moved.
        by: [f64; 2],
    },
    /// Points are reflected in the vertical through their middle.
    Mirror {
        /// The points.
        points: Vec<String>,
    },
    /// While points are moved the distance of two stays as it is, or the angle at the second of three, or no more if it did.
    Lock {
        /// Two points or three.
        points: Vec<String>,
    },
}

/// An end of what is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// A point that is there: a hinge.
    Point(String),
    /// A new point.
    At([f64; 2]),
    /// A new point of a link that is there.
    On(String, [f64; 2]),
}

/// What something slides along.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// The line of a link.
    Link(String),
    /// A line of the frame from where the block is towards a place.
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
    /// A slide along a line of the frame through a place, level.
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
