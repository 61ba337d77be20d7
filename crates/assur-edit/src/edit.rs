//! Edits of a drawing, as requested by the page.

use assur_file::LinkageDocument;
use serde::{Deserialize, Serialize};

/// One edit of a drawing. Lengths are in the unit of the drawing; parts are given by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "edit", rename_all = "snake_case", deny_unknown_fields)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Edit {
    /// A point by itself; with `fixed` one of the frame.
    Point { at: [f64; 2], fixed: bool },
    /// A link between two places.
    Bar { ends: [End; 2] },
    /// One more point of a link, which makes a plate of a bar.
    Corner { link: String, end: End },
    /// A block that is hinged at a point and slides along a line.
    Block { end: End, along: Line },
    /// A link that slides as a whole along a line, with no hinge between.
    Slide { link: String, along: Line },
    /// Two links and three pairs between what is there: an Assur group of Class II, its outer pairs in turn.
    Dyad { outer: [Outer; 2], inner: Inner },
    /// A plate on three bars with these ends: the Assur group of Class III with hinges alone.
    Triad { ends: [End; 3] },
    /// A wheel that turns about a point.
    Wheel { end: End },
    /// Two wheels come into mesh, with these numbers of teeth; if `internal` the larger one is a ring.
    Mesh {
        links: [String; 2],
        teeth: [f64; 2],
        internal: bool,
    },
    /// A link is driven, or no more if it was.
    Drive { link: String },
    /// A point becomes one of the frame, or is let go.
    Fix { point: String },
    /// Points go where redundant constraints hold that nearly did: those of a drawing by hand.
    MakeExact {},
    /// Two links turn as one from now on, or no more if they did: the first is fixed to the second, which may be the frame.
    Weld { links: [String; 2] },
    /// The first of two points goes: both become one hinge, where the second is.
    Join { points: [String; 2] },
    /// Every link gets a point of its own where they were hinged.
    Part { point: String },
    /// A point, drawn here, that a link carries and whose path is drawn.
    Trace { link: String, at: [f64; 2] },
    /// A link's centre of mass is where a point is put; without one it has none.
    Mass { link: String, at: Option<[f64; 2]> },
    /// Points move by as much.
    Move { points: Vec<String>, by: [f64; 2] },
    /// A point, or a tracer, stands at a place.
    Place { point: String, at: [f64; 2] },
    /// A link of two points has a length from now on: its second point moves along it.
    Stretch { link: String, length: f64 },
    /// A link stands at an angle, from its first point to its second: its other points turn about its first one.
    Turn { link: String, angle_deg: f64 },
    /// Another name of a point or a tracer, or else of a link.
    Rename { name: String, to: String },
    /// Points, tracers and links go, and with them what cannot be without them.
    Remove {
        points: Vec<String>,
        links: Vec<String>,
    },
    /// Another drawing is put beside what is there, moved by as much, under names that are free.
    Paste {
        #[cfg_attr(test, ts(type = "LinkageDocument"))]
        drawing: Box<LinkageDocument>,
        by: [f64; 2],
    },
    /// Points are reflected in the vertical through their middle.
    Mirror { points: Vec<String> },
    /// While points are moved the distance of two stays as it is, or the angle at the second of three, or no more if it did.
    Lock { points: Vec<String> },
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
