//! Edits of a drawing, as requested by the page.

use assur_file::LinkageDocument;
use serde::Deserialize;

/// One edit of a drawing. Lengths are in the unit of the drawing; parts are given by name. The page writes the name of
/// the variant into the field `edit`, which the crate `assur-web` removes before it deserializes the other fields.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(tag = "edit"))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum Edit {
    /// Adds a point; if `fixed`, a point of the frame.
    Point { at: [f64; 2], fixed: bool },
    /// Adds a link between two points.
    Bar { ends: [End; 2] },
    /// Adds a point to a link; a bar becomes a plate.
    Corner { link: String, end: End },
    /// Adds a block that is hinged at a point and slides along a line.
    Block { end: End, along: Line },
    /// Lets a link slide along a line and keep its angle to the line.
    Slide { link: String, along: Line },
    /// Adds a dyad, the Assur group of Class II. The `outer` pairs join its two links to the existing linkage.
    Dyad { outer: [Outer; 2], inner: Inner },
    /// Adds a plate with three bars to these ends: the Assur group of Class III with hinges only.
    Triad { ends: [End; 3] },
    /// Adds a wheel that rotates about a point.
    Wheel { end: End },
    /// Puts two wheels in mesh, with these numbers of teeth; if `internal`, the larger wheel is a ring.
    Mesh {
        links: [String; 2],
        teeth: [f64; 2],
        internal: bool,
    },
    /// Drives a link, or stops driving it if it is driven.
    Drive { link: String },
    /// Fixes a point to the frame, or releases it if it is fixed.
    Fix { point: String },
    /// Moves the points of a hand-made drawing slightly, so that redundant constraints hold exactly.
    MakeExact {},
    /// Fixes the first link to the second, which may be the frame; releases it if it is already fixed there.
    Weld { links: [String; 2] },
    /// Joins two points in one hinge at the position of the second. The first point is removed.
    Join { points: [String; 2] },
    /// Separates the links hinged at a point: each then has a point of its own.
    Part { point: String },
    /// Adds a traced point to a link, at this place in the drawing.
    Trace { link: String, at: [f64; 2] },
    /// Puts the centre of mass of a link at a place; without a place, removes it.
    Mass { link: String, at: Option<[f64; 2]> },
    /// Puts the centre of mass of a link at these coordinates on it: from its first point towards the second, and to the
    /// left. A centre of mass that is a point of this link alone is moved; otherwise a point is added.
    Centre { link: String, on: [f64; 2] },
    /// Makes a link a uniform bar between its first two points, with the mass that a section (an area) and a density
    /// (kilograms per cubic metre) give.
    Uniform {
        link: String,
        section: f64,
        density: f64,
    },
    /// Adds the counterweights that balance a four-bar statically: links fixed to the two links that turn about fixed
    /// hinges, each with its mass opposite to the moving hinge and as far from the fixed one.
    Balance {},
    /// Moves points by a displacement.
    Move { points: Vec<String>, by: [f64; 2] },
    /// Moves a point or a traced point to a place.
    Place { point: String, at: [f64; 2] },
    /// Sets the distance between the first two points of a link: the second moves along the link.
    Stretch { link: String, length: f64 },
    /// Sets the angle of a link, from its first point to its second: the link rotates about its first point.
    Turn { link: String, angle_deg: f64 },
    /// Renames a point or traced point with this name or, if there is none, a link.
    Rename { name: String, to: String },
    /// Removes points, traced points and links, with all parts that depend on them.
    Remove {
        points: Vec<String>,
        links: Vec<String>,
    },
    /// Adds another drawing, moved by a displacement, to this one. The added parts get free names.
    Paste {
        #[cfg_attr(test, ts(type = "LinkageDocument"))]
        drawing: Box<LinkageDocument>,
        by: [f64; 2],
    },
    /// Reflects points in the vertical line midway between the leftmost and the rightmost of them.
    Mirror { points: Vec<String> },
    /// Locks the distance between two points, or the angle at the second of three; unlocks it if it is locked.
    /// Locks hold while points are moved.
    Lock { points: Vec<String> },
}

/// An end of a new part.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// An existing point: a hinge.
    Point(String),
    /// A new point.
    At([f64; 2]),
    /// A new point of the frame: a fixed pivot.
    Fixed([f64; 2]),
    /// A new point of an existing link.
    On(String, [f64; 2]),
}

/// A line along which a link slides.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// A line through two points of this link: the two whose segment is nearest to the sliding point.
    Link(String),
    /// A line of the frame from the sliding point towards a place.
    Toward([f64; 2]),
}

/// An outer pair of a group: its joint with the existing linkage.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Outer {
    /// A hinge.
    Hinge(End),
    /// A slide along a line through two points of a link: the two whose segment is nearest to a place.
    Slide(String, [f64; 2]),
    /// A slide along a horizontal line of the frame through a place.
    Level([f64; 2]),
}

/// The inner pair of a dyad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Inner {
    /// A hinge.
    Hinge,
    /// A slide.
    Slide,
}
