//! Drawings of mechanisms and charts of their motion, in numbers: a mechanism
//! becomes a flat display list in model coordinates that any painter can paint,
//! a chart is drawn by plotters on any of its backends. No text is drawn here,
//! only said where it stands.

mod annotations;
pub mod chart;
mod figure;
mod gear;
mod list;
mod overlays;
mod parts;
mod polygon;
mod projection;
mod scheme;
mod sketch;
pub mod svg;
mod train;

pub use annotations::{Annotations, GivenPosition, Tag};
pub use figure::{Figure, Lines, View};
pub use list::{List, ROLES, Role};
pub use overlays::Overlays;
pub use polygon::{PolygonPicture, PolygonSheet, PolygonStep, polygon_steps};
pub use scheme::{SchemeFigure, SchemeHandle, SchemeView};
pub use sketch::{Sketch, SketchView};
pub use train::{TrainFigure, TrainPose, TrainView, WorkingMember};
