//! A mechanism and its plots as SVG.

use assur::mechanism::Quantity;
use assur::motion::InputRate;
use assur_draw::chart::Settings;
use assur_draw::svg::{Drawing, Svg};
use assur_draw::{Annotations, Figure, Overlays, View};
use assur_file::LinkageProblem;

use crate::Failure;
use crate::source::{Moved, Name, refused};

/// Width of the sheet, pixels.
const WIDTH: f64 = 900.0;
/// Height of the drawing, pixels.
const DRAWING: f64 = 560.0;
/// Height of each chart, pixels.
const CHART: f64 = 480.0;

/// Draws the mechanism with its plots below it, angles before lengths.
///
/// # Errors
/// A mechanism without a pose to draw.
pub(crate) fn svg(moved: &Moved, name: &Name) -> Result<String, Failure> {
    let Moved { document, motion } = moved;
    let mechanism = motion.mechanism();
    let unsolved = |reason: assur::mechanism::Unsolved| {
        refused(name, &[LinkageProblem::unsolved(&reason, mechanism)])
    };
    let point = |name: &String| mechanism.point(name);
    let view = View {
        overlays: Overlays {
            traces: true,
            ..Overlays::default()
        },
        traced: document.traces.iter().filter_map(point).collect(),
        annotations: Annotations::of_linkage(document.ground),
        ..View::default()
    };
    let figure = Figure::new(motion, &view).map_err(unsolved)?;
    let home = motion.pose::<1>(motion.drawn_input()).map_err(unsolved)?;

    let mut sheet = Svg::new(WIDTH);
    sheet.drawing(
        DRAWING,
        &Drawing {
            bounds: figure.bounds(),
            rigid: figure.rigid(),
            frame: &figure.frame(&home),
            names: figure.names(),
            values: &|what| (what == "input").then(|| motion.drawn_input()),
        },
    );
    let (angles, lengths) = document
        .outputs(mechanism)
        .into_iter()
        .partition(|quantity: &Quantity| quantity.is_angle());
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let kinds: [Vec<Quantity>; 2] = [angles, lengths];
    let input = if mechanism.turns() { "φ" } else { "s" };
    for quantities in kinds.iter().filter(|kind| !kind.is_empty()) {
        sheet.chart(CHART, &figure.chart(quantities, settings), input);
    }
    let title = document.title.clone();
    Ok(sheet.finish(&title.unwrap_or_else(|| name.to_string())))
}
