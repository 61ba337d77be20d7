//! Poses of a body on the page, with a linkage that guides the body through them.

mod drawn;
mod hinges;
pub(crate) mod summary;

use assur::{Point, Vector};
use assur_draw::{GuidanceSheet, Role};
use assur_file::{Document, Guidance, Moved, PoseDocument, PosesDocument, Problem, State};
use serde_json::json;
use wasm_bindgen::prelude::JsValue;

use crate::capabilities::{Capabilities, Edited, Rigid, unknown};
use crate::change::Change;
use crate::convert::to_js;
use crate::handle::{Handle, HandlePlace};
use crate::here::Here;
use crate::kinds::task;
use crate::moving::Moving;
use drawn::Scene;
use hinges::Hinges;
use summary::PosesSummary;

/// Step of a dragged direction, degrees. A hand cannot set an angle more precisely.
const STEP_DEG: f64 = 0.1;

/// Number of steps of a dragged place over the size of the body.
const STEPS: f64 = 100.0;

/// Name by which the page presses a place on a curve of four poses.
const CURVE: &str = "curve";

pub(crate) struct Poses {
    document: PosesDocument,
    found: Guidance,
    scene: Scene,
    hinges: Hinges,
    /// The shown linkage, or the reasons why there is none.
    shown: Result<Shown, Vec<Problem>>,
    /// The poses alone.
    sheet: GuidanceSheet,
    /// Handles of the poses alone.
    held: Vec<Handle>,
}

/// The linkage that is shown.
struct Shown {
    /// As a document for the simulator.
    linkage: Document,
    moving: Moving,
    /// Inputs at which the linkage meets the poses.
    met: Vec<Option<f64>>,
}

/// A handle of a pose or of the shown linkage, by its number from 0.
#[derive(Clone, Copy)]
enum Held {
    Pose(usize),
    Turn(usize),
    /// Hinge of a dyad on the frame.
    Frame(usize),
    /// Hinge of a dyad on the body, in the last pose.
    Body(usize),
}

impl Held {
    fn name(self) -> String {
        match self {
            Self::Pose(k) => format!("pose{}", k + 1),
            Self::Turn(k) => format!("turn{}", k + 1),
            Self::Frame(k) => format!("frame{}", k + 1),
            Self::Body(k) => format!("body{}", k + 1),
        }
    }
}

impl Poses {
    #[inline(never)]
    pub(crate) fn new(state: &State, document: &PosesDocument) -> Result<Self, Vec<Problem>> {
        state.check()?;
        let found = document.guidance()?;
        let hinges = Hinges::new(document, &found);
        let mut scene = Scene::new(&found, &hinges);
        let shown = Shown::new(state, document, &found, (&mut scene, &hinges));
        // A choice of the view that this linkage lacks is an error of the whole document: the page then corrects the
        // view.
        if let Err(problems) = &shown
            && let [Problem::UnknownChoice { .. }] = problems[..]
        {
            return Err(problems.clone());
        }
        Ok(Self {
            sheet: GuidanceSheet::new(&scene.guidance, state.view.symbol),
            held: held(&scene, &hinges).collect(),
            document: document.clone(),
            found,
            scene,
            hinges,
            shown,
        })
    }

    fn handles(&self) -> impl Iterator<Item = (Held, Role, Point)> + '_ {
        handles(&self.scene, &self.hinges)
    }
}

/// The handles of poses, then those of hinges that may be chosen.
fn handles<'a>(
    scene: &'a Scene,
    hinges: &'a Hinges,
) -> impl Iterator<Item = (Held, Role, Point)> + 'a {
    let poses = scene.guidance.poses.iter().enumerate();
    let poses = poses.flat_map(|(k, pose)| {
        [
            (Held::Pose(k), pose.role, pose.origin),
            (Held::Turn(k), pose.role, pose.tip),
        ]
    });
    let hinges = hinges.places().map(|(is_on_frame, k, at)| {
        let held = if is_on_frame {
            Held::Frame(k)
        } else {
            Held::Body(k)
        };
        (held, hinges::ROLES[k], at)
    });
    poses.chain(hinges)
}

/// The handles with their names.
fn held<'a>(scene: &'a Scene, hinges: &'a Hinges) -> impl Iterator<Item = Handle> + 'a {
    handles(scene, hinges).map(|(held, role, at)| Handle {
        name: held.name(),
        role: role.name(),
        at: HandlePlace::Fixed(at),
    })
}

impl Shown {
    fn new(
        state: &State,
        document: &PosesDocument,
        found: &Guidance,
        (scene, hinges): (&mut Scene, &Hinges),
    ) -> Result<Self, Vec<Problem>> {
        let mut linkage = found.linkage()?;
        linkage.unit = document.unit;
        let moved = Moved::new(linkage.clone(), &state.view.plot)?;
        let met = match found.shown() {
            Some(pair) => pair.inputs(&found.task, &moved.motion),
            None => Vec::new(),
        };
        scene.judge(&met);
        let moving = task::moving(&state.view, moved, scene.guidance.clone())?;
        Ok(Self {
            linkage: Document::Linkage(linkage),
            moving: moving.held_by(held(scene, hinges)),
            met,
        })
    }
}

impl Capabilities for Poses {
    fn summary(&self) -> JsValue {
        to_js(&PosesSummary::new(self))
    }

    fn rigid(&self) -> Rigid<'_> {
        match &self.shown {
            Ok(shown) => shown.moving.figure().into(),
            Err(_) => Rigid {
                names: self.sheet.names(),
                list: &[],
            },
        }
    }

    fn still(&self, _opened: f64) -> Here {
        Here::still(self.sheet.frame(), self.handles().map(|(.., at)| at))
    }

    fn linkage(&self) -> Option<&Moving> {
        self.shown.as_ref().ok().map(|shown| &shown.moving)
    }

    fn edited(&self) -> Option<&dyn Edited> {
        Some(self)
    }
}

impl Edited for Poses {
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem> {
        if let Some(moving) = self.linkage()
            && let Some(driven) = moving.mechanism().point(point)
        {
            let to = moving.driven_to(driven, input, to);
            return to.unwrap_or_else(|| Err(unknown(point))).map(Change::input);
        }
        if point == CURVE {
            let within = hinges::PRESSED * self.scene.unit(&self.sheet);
            let chosen = self.hinges.pressed(&self.found, to, within);
            return Ok(chosen.map_or_else(Change::default, |hinges| {
                Change::document(&json!({ "hinges": hinges, "solution": null }))
            }));
        }
        let mut all = self.handles();
        let found = all.find(|(held, ..)| held.name() == point);
        let (held, ..) = found.ok_or_else(|| unknown(point))?;
        let mut poses = self.document.poses.clone();
        match held {
            Held::Pose(k) => [poses[k].x, poses[k].y] = self.rounded(to),
            Held::Turn(k) => poses[k].angle_deg = turned(poses[k], to),
            Held::Frame(k) | Held::Body(k) => {
                let is_on_frame = matches!(held, Held::Frame(_));
                let hinges = self.hinges.moved(&self.found, is_on_frame, k, to);
                return Ok(Change::document(
                    &json!({ "hinges": hinges, "solution": null }),
                ));
            }
        }
        Ok(Change::document(&json!({ "poses": poses })))
    }
}

impl Poses {
    /// Rounds a position to steps of at most a hundredth of the body's size, powers of ten.
    fn rounded(&self, at: Point) -> [f64; 2] {
        let steps = 10.0_f64.powf((STEPS / self.scene.size).log10().ceil());
        [at.x, at.y].map(|value| (value * steps).round() / steps)
    }
}

/// Angle of a pose whose x-axis is turned towards a place, degrees, nearest to the present angle.
fn turned(pose: PoseDocument, to: Point) -> f64 {
    let along = to - Point::new(pose.x, pose.y);
    if along == Vector::zeros() {
        return pose.angle_deg;
    }
    let angle = (along.y.atan2(along.x).to_degrees() / STEP_DEG).round() / STEP_DEG.recip();
    angle + 360.0 * ((pose.angle_deg - angle) / 360.0).round()
}
