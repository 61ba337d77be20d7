//! Poses, reactions, assemblies and circuits of linkages of the catalogue.

use std::f64::consts::TAU;
use std::hint::black_box;

use assur::circuits::Circuits;
use assur::forces::{Kinetostatics, Loading, LoadingSpec, Reactions};
use assur::mechanism::{self, LinkId, Method, PointId};
use assur::motion::Motion;

use super::{Contestant, SWEEPS};

/// Number of samples of a turn, one for each degree.
const DEGREES: usize = 360;

pub(crate) fn contestants() -> Vec<Contestant> {
    let mut contestants: Vec<Contestant> = Vec::new();
    for (name, linkage, places) in [
        ("six-bar of dyads, full state", "stephenson-3", false),
        ("Class IV, full state at 1° steps", "class4-dwell", true),
    ] {
        let motion = motion(linkage);
        let mut full = Full::new(&motion, places);
        contestants.push((
            name,
            DEGREES * SWEEPS,
            Box::new(move || {
                for _ in 0..SWEEPS {
                    for index in 0..DEGREES {
                        // The angles lie between the samples with which the motion was followed.
                        let crank = TAU * (index as f64 + 0.3) / DEGREES as f64;
                        full.store(&motion, index, black_box(crank));
                    }
                }
            }),
        ));
    }

    for (name, with_reactions, linkage) in [
        ("Jansen, poses with both derivatives", false, "jansen"),
        ("Jansen, reactions in these poses", true, "jansen"),
        (
            "Class IV, poses with both derivatives",
            false,
            "class4-dwell",
        ),
        ("Class IV, reactions in these poses", true, "class4-dwell"),
    ] {
        contestants.push((name, DEGREES * SWEEPS, reactions(linkage, with_reactions)));
    }
    let class4 = motion("class4-dwell").mechanism().clone();
    let all = class4.clone();
    let mut turned = 0.0;
    contestants.push((
        "Class IV, all assemblies at an input",
        1,
        Box::new(move || {
            turned += 1.0;
            black_box(all.assemblies_at(turned, Method::Usual));
        }),
    ));
    let mut following = class4.following();
    let mut degree = 0.0;
    contestants.push((
        "Class IV, all assemblies followed, a degree",
        DEGREES,
        Box::new(move || {
            for _ in 0..DEGREES {
                degree += 1.0;
                let input = black_box(f64::to_radians(degree));
                black_box(following.at(input));
            }
        }),
    ));
    for (name, of) in [
        ("Class IV, all motions, a degree", class4),
        (
            "four-bar, all motions, a degree",
            motion("crank-rocker").mechanism().clone(),
        ),
    ] {
        let output = of.output().unwrap();
        contestants.push((
            name,
            DEGREES,
            Box::new(move || {
                black_box(Circuits::of(&of, output));
            }),
        ));
    }
    contestants
}

/// Returns sweeps of a linkage whose links are uniform bars under gravity: poses, with or without their reactions.
fn reactions(name: &str, with_reactions: bool) -> Box<dyn FnMut()> {
    let mut spec = motion(name).mechanism().spec().clone();
    for link in &mut spec.links {
        link.mass = Some(1.0);
    }
    let motion = Motion::new(mechanism::Mechanism::new(&spec).unwrap());
    let gravity = assur::Vector::new(0.0, -9.81);
    let loading = LoadingSpec {
        gravity,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &loading).unwrap();
    let forces = Kinetostatics::new(motion.mechanism());
    let mut pose = motion.mechanism().blank::<3>();
    let mut found = Reactions::default();
    Box::new(move || {
        for index in 0..DEGREES * SWEEPS {
            let crank = black_box(TAU * ((index % DEGREES) as f64 + 0.3) / DEGREES as f64);
            motion.place(crank, &mut pose).unwrap();
            if with_reactions {
                let balanced = forces.balance(&loading, &pose, crank, [10.0, 0.0], &mut found);
                balanced.unwrap();
            }
            black_box((&pose, &found));
        }
    })
}

/// Returns the motion of a linkage of the catalogue in its drawn assembly.
fn motion(name: &str) -> Motion {
    let document = assur_file::from_catalogue(name).unwrap().unwrap();
    let mechanism = document.mechanism().unwrap();
    Motion::new(mechanism)
}

/// Columns of a linkage, with both derivatives of each. They are the angles of the links, as for the reference; or, as
/// in a table of the Class IV mechanism, the positions of the moving points and the angle of the output.
struct Full {
    pose: mechanism::Pose<3>,
    points: Vec<PointId>,
    links: Vec<LinkId>,
    columns: Vec<[f64; 3]>,
}

impl Full {
    fn new(motion: &Motion, places: bool) -> Self {
        let mechanism = motion.mechanism();
        let pose = motion.pose::<3>(motion.cycle().drawn_input()).unwrap();
        let moves = |point: &PointId| mechanism.place(&pose, *point).derivative(1).norm() > 0.0;
        let points = mechanism.point_ids().filter(|point| places && moves(point));
        let points: Vec<PointId> = points.collect();
        let last = mechanism.links().len() - 1;
        let links: Vec<LinkId> = (mechanism.link_ids())
            .filter(|link| !places || link.index() == last)
            .collect();
        Self {
            columns: vec![[0.0; 3]; (2 * points.len() + links.len()) * DEGREES],
            pose,
            points,
            links,
        }
    }

    fn store(&mut self, motion: &Motion, index: usize, crank: f64) {
        motion.place(crank, &mut self.pose).unwrap();
        let mechanism = motion.mechanism();
        let count = 2 * self.points.len() + self.links.len();
        let row = &mut self.columns[index * count..][..count];
        let (places, angles) = row.split_at_mut(2 * self.points.len());
        for (columns, point) in places.chunks_exact_mut(2).zip(&self.points) {
            let place = mechanism.place(&self.pose, *point);
            columns[0] = [0, 1, 2].map(|order| place.x.derivative(order));
            columns[1] = [0, 1, 2].map(|order| place.y.derivative(order));
        }
        for (column, link) in angles.iter_mut().zip(&self.links) {
            let angle = mechanism.angle(&self.pose, *link);
            *column = [0, 1, 2].map(|order| angle.derivative(order));
        }
    }
}
