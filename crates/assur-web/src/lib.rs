//! The engine in the browser. This crate only converts between the values of JavaScript and those of the engine.
//!
//! | file | subject |
//! |---|---|
//! | `simulator.rs`, `capabilities.rs`, `kinds/` | the interface of the page; capabilities of a document; a module for each kind |
//! | `moving.rs`, `summary.rs`, `profile.rs`, `here.rs` | a moving linkage; summary of its motion; strokes and dwells; numbers at an input |
//! | `driven.rs`, `dimensions.rs`, `change.rs`, `handle.rs` | dragging the driver; dimensions; changes made by hand; handles |
//! | `table.rs`, `chart.rs`, `equations.rs`, `polygons.rs`, `curvature.rs` | tables, plots, constraint equations, polygons, curvature |
//! | `forces.rs`, `reactions.rs`, `force_quantity.rs`, `masses.rs` | a linkage under load; its reactions; forces that can be plotted; masses |
//! | `force_plan.rs` | force plans, Zhukovsky's lever, free bodies |
//! | `design.rs` | the search for a dwell |
//! | `received.rs`, `offered.rs`, `imported.rs`, `convert.rs`, `canvas.rs` | checked input from outside; starting documents; files of other programs; JavaScript values; a canvas as a backend of plotters |

// Unit tests are compiled for native targets only.
#![cfg(not(all(test, target_family = "wasm")))]

mod assemblies;
mod canvas;
mod capabilities;
mod change;
mod chart;
mod column;
mod convert;
mod curvature;
mod design;
mod dimensions;
mod driven;
mod equations;
mod equilibrium;
mod force_plan;
mod force_quantity;
mod forces;
mod handle;
mod here;
mod imported;
mod kinds;
mod masses;
mod measures;
mod moving;
mod numbers;
mod offered;
mod pair;
mod polygons;
mod profile;
mod qr;
mod reactions;
mod received;
mod simulator;
mod summary;
mod table;
mod thin;
#[cfg(test)]
mod types;
mod under_load;

use wasm_bindgen::prelude::wasm_bindgen;

/// Types of the parameters and results, declared in the `types.d.ts` of the crates.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { Edit } from "assur/types/edit.js";
import type { DocumentOf, LengthUnit, LessonDocument, LinkageDocument, NumberField, PositionDocument, Preset, Problem, Shelf, View } from "assur/types/file.js";
import type { AssembliesHere, AtlasHere, AtlasPage, Belonging, Changed, ChartLayout, ChartRequest, CurvatureHere, CycleHere, Drawn, EquationSummary, EquilibriumHere, ForcePlanHere, ForcesHere, FoundTracing, FreeBodyHere, GreatestForces, Here, Imported, Kind, LeverHere, LinkHere, MassHere, MotionsMap, NinePointProgress, OutputSummary, PathWork, PolygonsHere, ProfileSummary, ReadoutId, RelationHere, RunHere, State, StepSummary, StudentSheet, Summaries, SweepTable, Traced, TracingProgress, TracingWishes, TransmissionSummary, Wishes } from "assur/types/web.js";
export interface Simulator {
    set<K extends Kind>(state: State<K>): Summaries[K];
    asKind<K extends Kind>(kind: K, input: number): DocumentOf<K>;
}
"#;

pub use assemblies::AllMotions;
pub use design::Design;
pub use imported::{is_import, read_import};
pub use kinds::point_path::atlas::{path_atlas, path_of_cell};
pub use kinds::point_path::search::{NinePointSearch, NinePointWorker, PathSearch};
pub use numbers::numbers_of;
pub use offered::{
    blank, catalogue, default_view, function_positions, mixers, role_names, shelves, task,
};
pub use qr::qr_code;
pub use received::{check_keys, read_lesson, read_state};
pub use simulator::Simulator;
