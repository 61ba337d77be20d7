//! The drawing of a differential: sun 1, satellites 2, carrier 3 and ring 4, with teeth or magnet
//! plates, and the working members 7 and 8, such as fans and brushes.

mod arrows;
mod bevel;
mod members;
mod planar;
mod solid;
mod velocities;
mod wheel;

use std::f64::consts::TAU;

use assur::dynamics::{Body, Poles};
use assur::gears::train::{Coupling, Kind, Layout};

use crate::list::{List, Role};
use bevel::Bevel;
use planar::Planar;

/// Kinds of working members, each drawn as seen along its shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "a working member is its name")]
pub enum WorkingMember {
    Fan,
    Brush,
    Stirrer,
    Scraper,
    Blade,
    Propeller,
    RoadWheel,
}

impl WorkingMember {
    /// All kinds, in the order of the table of uses in the source paper.
    pub const ALL: [Self; 7] = [
        Self::Fan,
        Self::Brush,
        Self::Stirrer,
        Self::Scraper,
        Self::Blade,
        Self::Propeller,
        Self::RoadWheel,
    ];
}

/// View of a differential.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TrainView {
    /// Teeth or magnets.
    pub coupling: Coupling,
    /// Polarity of the magnet plates.
    pub poles: Poles,
    /// The working members: number 7 on each satellite's shaft, number 8 on the carrier.
    pub members: [Option<WorkingMember>; 2],
    /// Whether to draw the velocities and the instant centre of the first satellite. Not used for bevel wheels.
    pub velocities: bool,
}

impl TrainView {
    /// Returns the number of plates per period of the field; for gears each tooth is a period.
    fn plates(&self) -> u32 {
        match (self.coupling, self.poles) {
            (Coupling::Magnetic, Poles::Alternating) => 2,
            _ => 1,
        }
    }
}

/// A pose of a differential relative to an observer, whose own angle and speed are subtracted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainPose {
    /// Angles of the bodies in the order of [`Body::ALL`], radians. At zero angles no mesh is loaded, and the first
    /// satellite is on the right of the main axis, in a bevel train above it. The angle of a bevel satellite is not
    /// used, because it follows from the angles of sun and carrier.
    pub angles: [f64; 4],
    /// Speeds of the bodies in the order of [`Body::ALL`], rad/s.
    pub speeds: [f64; 4],
    /// Torques of the field on sun and ring, relative to their greatest values (−1 to 1); none if not shown.
    pub torques: Option<[f64; 2]>,
    /// Angle of the frame, radians; 0 for an observer on the ground.
    pub ground: f64,
}

/// The drawing of a differential, seen along its main axis, or from the side for bevel wheels.
#[derive(Clone, Debug)]
pub struct TrainFigure {
    wheels: Wheels,
    names: Vec<String>,
    rigid: List,
}

/// The wheels, by the arrangement of their axes.
#[derive(Clone, Debug)]
enum Wheels {
    Planar(Box<Planar>),
    Bevel(Box<Bevel>),
}

/// A label. Its discriminant is the index of its text in `TEXTS`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Name {
    Sun,
    Satellite,
    Step,
    Carrier,
    Ring,
    /// The working member on a satellite's shaft.
    Seventh,
    /// The working member on the carrier.
    Eighth,
    North,
    South,
    /// The instant centre of a satellite.
    Pole,
}

impl Name {
    /// Texts of the labels, in the order of this enumeration.
    const TEXTS: [&'static str; 10] = ["1", "2", "2′", "3", "4", "7", "8", "N", "S", "P"];
}

/// Returns the colour of a body.
const fn role(body: Body) -> Role {
    match body {
        Body::Sun => Role::Crank,
        Body::Satellite => Role::Coupler,
        Body::Carrier => Role::Rocker,
        Body::Ring => Role::Accent2,
    }
}

impl TrainFigure {
    /// Makes the drawing of a differential, even of one that cannot be built.
    pub fn new(layout: &Layout, view: TrainView) -> Self {
        let (wheels, rigid) = match layout.train().kind() {
            Kind::Planar | Kind::Stepped => {
                let planar = Planar::new(layout, view);
                let rigid = planar.rigid();
                (Wheels::Planar(Box::new(planar)), rigid)
            }
            // Seen from the side, wheels look different in each pose, so none is drawn in advance.
            Kind::Bevel => {
                let bevel = Bevel::new(layout, view);
                (Wheels::Bevel(Box::new(bevel)), List::default())
            }
        };
        Self {
            wheels,
            names: Name::TEXTS.map(str::to_owned).to_vec(),
            rigid,
        }
    }

    /// Returns the colours of the bodies in the order of [`Body::ALL`].
    pub fn roles() -> [Role; 4] {
        Body::ALL.map(role)
    }

    /// Returns the names to which labels refer by index.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the display list of everything that turns as a body.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// Returns the rectangle that holds the drawing at all times: left, bottom, right, top.
    pub fn bounds(&self) -> [f64; 4] {
        match &self.wheels {
            Wheels::Planar(planar) => planar.bounds(),
            Wheels::Bevel(bevel) => bevel.bounds(),
        }
    }

    /// Returns the drawing in a pose: the number of bodies, then x, y and θ of each body, then a display list.
    pub fn frame(&self, pose: &TrainPose) -> Vec<f32> {
        let mut list = List::default();
        let poses = match &self.wheels {
            Wheels::Planar(planar) => {
                planar.draw_moving(&mut list, pose);
                planar.poses(pose)
            }
            Wheels::Bevel(bevel) => {
                bevel.draw(&mut list, pose);
                vec![[0.0; 3]]
            }
        };
        let mut frame = vec![poses.len() as f32];
        // As an `f32`, an angle of many turns would lose its visible digits.
        let folded = poses
            .iter()
            .flat_map(|[x, y, angle]| [*x, *y, angle.rem_euclid(TAU)].map(|number| number as f32));
        frame.extend(folded);
        frame.extend(list.numbers());
        frame
    }
}
