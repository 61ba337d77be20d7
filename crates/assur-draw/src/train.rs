//! A differential as a drawing: sun 1, satellites 2, carrier 3 and ring 4, with teeth or magnet
//! plates, and the working members 7 and 8 that it drives.

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

/// What a differential drives. Each is drawn as it is seen along its shaft.
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
    /// All of them, as in the source paper's table of uses.
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

/// What is shown of a differential.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TrainView {
    /// Teeth or magnets.
    pub coupling: Coupling,
    /// Of magnets: which poles the wheels show.
    pub poles: Poles,
    /// The working members: 7 on each satellite's shaft, 8 on the carrier.
    pub members: [Option<WorkingMember>; 2],
    /// Whether the velocities of the first satellite are drawn, with its instantaneous centre.
    /// Of bevel wheels they are not.
    pub velocities: bool,
}

impl TrainView {
    /// How many plates make a period of the field; of gears each tooth is one.
    fn plates(&self) -> u32 {
        match (self.coupling, self.poles) {
            (Coupling::Magnetic, Poles::Alternating) => 2,
            _ => 1,
        }
    }
}

/// A differential in motion, as its observer sees it: his own angle and speed are taken off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainPose {
    /// The angles of the bodies in the order of [`Body::ALL`], radians, counted from where no mesh
    /// is loaded and the first satellite is to the right. A bevel one is then on top, and its
    /// angle is not read: it turns as the sun has it.
    pub angles: [f64; 4],
    /// Their speeds, rad/s.
    pub speeds: [f64; 4],
    /// The torques of the field on sun and ring relative to the greatest it can have there, −1 to 1;
    /// none where they are not shown.
    pub torques: Option<[f64; 2]>,
    /// The angle of the frame, radians: 0 for who stands on the ground.
    pub ground: f64,
}

/// A differential as a drawing: along its main axis, of bevel wheels from the side.
#[derive(Clone, Debug)]
pub struct TrainFigure {
    wheels: Wheels,
    names: Vec<String>,
    rigid: List,
}

/// The wheels, as their axes stand.
#[derive(Clone, Debug)]
enum Wheels {
    Planar(Box<Planar>),
    Bevel(Box<Bevel>),
}

/// What a label of the drawing says.
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
    /// The instantaneous centre of a satellite.
    Pole,
}

impl Name {
    /// What they say, in their order.
    const TEXTS: [&'static str; 10] = ["1", "2", "2′", "3", "4", "7", "8", "N", "S", "P"];
}

/// The colour of a body.
const fn role(body: Body) -> Role {
    match body {
        Body::Sun => Role::Crank,
        Body::Satellite => Role::Coupler,
        Body::Carrier => Role::Rocker,
        Body::Ring => Role::Accent2,
    }
}

impl TrainFigure {
    /// The drawing of a differential, whether its conditions are met or not.
    pub fn new(layout: &Layout, view: TrainView) -> Self {
        let (wheels, rigid) = match layout.train().kind() {
            Kind::Planar | Kind::Stepped => {
                let planar = Planar::new(layout, view);
                let rigid = planar.rigid();
                (Wheels::Planar(Box::new(planar)), rigid)
            }
            // From the side wheels look another way in each pose.
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

    /// The colours of the bodies in the order of [`Body::ALL`].
    pub fn roles() -> [Role; 4] {
        Body::ALL.map(role)
    }

    /// What the labels' numbers stand for.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The display list of everything that turns as a body.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// The rectangle that holds the drawing at all times: left, bottom, right, top.
    pub fn bounds(&self) -> [f64; 4] {
        match &self.wheels {
            Wheels::Planar(planar) => planar.bounds(),
            Wheels::Bevel(bevel) => bevel.bounds(),
        }
    }

    /// The drawing at a time: `n, x, y, θ, …` of the `n` bodies, then a display list.
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
        // An angle of many turns has no digits left for what is seen of it.
        let folded = poses
            .iter()
            .flat_map(|[x, y, angle]| [*x, *y, angle.rem_euclid(TAU)].map(|number| number as f32));
        frame.extend(folded);
        frame.extend(list.numbers());
        frame
    }
}
