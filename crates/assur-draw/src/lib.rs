//! Drawings of mechanisms and charts of their motion. A mechanism becomes a flat display list of numbers in model
//! coordinates, which any painter can paint. A chart is drawn by plotters on any of its backends. Only SVG sheets
//! contain text; elsewhere only the positions of texts are given.
//!
//! | file | subject |
//! |---|---|
//! | `figure.rs`, `figure/` | the drawing of any motion: joints, bars, plates, slides, wheels, paths, numbers, overlaid arrows and circles |
//! | `sketch.rs`, `scheme.rs`, `train.rs`, `polygon.rs` | an unfinished drawing; links and pairs, cut open; a differential; polygons to scale |
//! | `guidance.rs` | poses of a body, with the curves of its hinges |
//! | `force_arrows.rs` | arrows of forces and torques, friction circles |
//! | `force_plan.rs`, `force_plan/` | force plans to scale, free bodies, Zhukovsky's lever |
//! | `annotations.rs`, `overlays.rs`, `parts.rs`, `gear.rs` | annotations of a document; overlays; symbols of textbooks; involute teeth |
//! | `list.rs` | the display list |
//! | `chart.rs`, `chart/`, `svg.rs`, `svg/` | plots by plotters; sheets of SVG, the only place with colours and text |

mod annotations;
pub mod chart;
mod figure;
mod force_arrows;
mod force_plan;
mod gear;
mod guidance;
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
pub use figure::{Figure, Lines, Values, View};
pub use force_arrows::{Acting, ForceArrow, ForceScale, touching};
pub use force_plan::{
    ForcePicture, FrictionCircle, Numbers, PlanRooms, equilibrium_picture, force_symbol,
    free_body_picture, lever_picture, plan_picture,
};
pub use guidance::{DrawnPose, Guidance, GuidanceSheet};
pub use list::{List, ROLES, Role};
pub use overlays::Overlays;
pub use polygon::{PolygonPicture, PolygonSheet, PolygonStep, polygon_steps};
pub use scheme::{SchemeFigure, SchemeHandle, SchemeView};
pub use sketch::{Sketch, SketchView};
pub use train::{TrainFigure, TrainPose, TrainView, WorkingMember};
