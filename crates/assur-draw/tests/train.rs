//! Drawings of differentials: coordinates are valid, wheels mesh, forces and velocities agree with the pose.

mod forces;

use std::f64::consts::{PI, TAU};

use assur::dynamics::Poles;
use assur::gears::train::{Coupling, Drive, Input, Kind, Layout, Member, Shaft, Shafts, Train};
use assur_draw::{Role, TrainFigure, TrainPose, TrainView, WorkingMember};

use crate::records::records;

const ALIKE: TrainView = TrainView {
    coupling: Coupling::Magnetic,
    poles: Poles::Alike,
    members: [None, None],
    velocities: false,
};

const ALTERNATING: TrainView = TrainView {
    poles: Poles::Alternating,
    ..ALIKE
};

const CONTACT: TrainView = TrainView {
    coupling: Coupling::Contact,
    ..ALIKE
};

fn layout(train: Train, satellites: f64) -> Layout {
    Layout::new(train, satellites, 4.0, None).unwrap()
}

fn magnets() -> Layout {
    layout(Train::planar([20.0, 10.0, 43.0]).unwrap(), 3.0)
}

/// Returns the angles of all bodies for given angles of sun and carrier.
fn turned(layout: &Layout, sun: f64, carrier: f64) -> [f64; 4] {
    let given = |shaft, angle| Input {
        shaft,
        drive: Drive::Given(angle),
    };
    let inputs = [given(Shaft::Sun, sun), given(Shaft::Carrier, carrier)];
    let shafts: Shafts = layout.train().differential().solve(&inputs).unwrap();
    let satellite = layout.train().spin(&shafts).along;
    [shafts.sun, satellite, shafts.carrier, shafts.ring]
}

fn at_rest(angles: [f64; 4]) -> TrainPose {
    TrainPose {
        angles,
        speeds: [0.0; 4],
        torques: None,
        ground: 0.0,
    }
}

/// A record, with the body whose coordinates it has.
struct Drawn {
    body: usize,
    record: Vec<f64>,
}

impl Drawn {
    fn is(&self, kind: u8, role: Role) -> bool {
        self.record[0] == f64::from(kind) && self.record[1] == f64::from(role as u8)
    }

    /// Returns the positions of the record's lines, one list for each line.
    fn lines(&self) -> Vec<Vec<[f64; 2]>> {
        let pairs = |numbers: &[f64]| numbers.chunks(2).map(|two| [two[0], two[1]]).collect();
        match self.record[0] as u8 {
            1 => {
                let (mut lines, mut at) = (Vec::new(), 4);
                for _ in 0..self.record[3] as usize {
                    let end = at + 1 + 2 * self.record[at] as usize;
                    lines.push(pairs(&self.record[at + 1..end]));
                    at = end;
                }
                lines
            }
            2 => vec![pairs(&self.record[4..])],
            3 => {
                let [x, y, r] = [3, 4, 5].map(|at| self.record[at]);
                vec![vec![[x - r, y], [x + r, y], [x, y - r], [x, y + r]]]
            }
            _ => vec![vec![[self.record[3], self.record[4]]]],
        }
    }
}

/// Returns the poses of the bodies, and all records: first those fixed to bodies.
fn drawn(figure: &TrainFigure, pose: &TrainPose) -> (Vec<[f64; 3]>, Vec<Drawn>) {
    let frame = figure.frame(pose);
    let (poses, moving) = frame[1..].split_at(3 * frame[0] as usize);
    let poses: Vec<[f64; 3]> = poses
        .chunks(3)
        .map(|pose| [pose[0], pose[1], pose[2]].map(f64::from))
        .collect();
    let mut all = Vec::new();
    for list in [figure.rigid().numbers(), moving] {
        let mut body = 0;
        for record in records(list) {
            if record[0] == 0.0 {
                body = record[1] as usize;
            } else {
                let record = record.into_iter().map(f64::from).collect();
                all.push(Drawn { body, record });
            }
        }
    }
    (poses, all)
}

fn placed([left, up, angle]: [f64; 3], [x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [left + cos * x - sin * y, up + sin * x + cos * y]
}

/// Checks that all coordinates are finite and within the bounds, that every body has a pose, and every label a name.
fn check_whole(figure: &TrainFigure, pose: &TrainPose, what: &str) {
    let (poses, all) = drawn(figure, pose);
    assert!(poses.iter().flatten().all(|number| number.is_finite()));
    let [left, bottom, right, top] = figure.bounds();
    let room = 1e-5 * (right - left);
    for drawn in &all {
        assert!(
            drawn.record.iter().all(|number| number.is_finite()),
            "{what}"
        );
        if drawn.record[0] == 4.0 {
            assert!((drawn.record[2] as usize) < figure.names().len());
        }
        for place in drawn.lines().concat() {
            let [x, y] = placed(poses[drawn.body], place);
            assert!(
                x > left - room && x < right + room && y > bottom - room && y < top + room,
                "{what}: {x}, {y} of {:?}, record {:?}",
                figure.bounds(),
                &drawn.record[..4]
            );
        }
    }
}

/// A linear congruential generator of numbers from 0 to below 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() * all.len() as f64) as usize]
    }

    /// Returns a number of teeth; small numbers are more probable.
    fn teeth(&mut self) -> f64 {
        (3.0 * (997.0_f64 / 3.0).powf(self.next())).floor() + 1.0
    }
}

#[test]
fn any_train_is_drawn_within_its_bounds() {
    let mut random = Random(7);
    let mut kinds = [0; 3];
    while kinds.iter().any(|count| *count < 60) {
        let [a, b, c, d] = [0; 4].map(|_| random.teeth());
        let trains = [
            Train::planar([a, b, c]),
            Train::stepped([a, b, d, c]),
            Train::bevel([a, b, c]),
        ];
        let satellites = random.of(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let module = random.of(&[0.01, 4.0, 900.0]);
        let distance = random.of(&[None, None, Some(0.7), Some(3000.0)]);
        for (train, count) in trains.into_iter().zip(&mut kinds) {
            let Ok(train) = train else { continue };
            let Ok(layout) = Layout::new(train, satellites, module, distance) else {
                continue;
            };
            *count += 1;
            let member =
                |random: &mut Random| (random.next() < 0.7).then(|| random.of(&WorkingMember::ALL));
            let view = TrainView {
                coupling: random.of(&[Coupling::Contact, Coupling::Magnetic]),
                poles: random.of(&[Poles::Alike, Poles::Alternating]),
                members: [member(&mut random), member(&mut random)],
                velocities: random.next() < 0.7,
            };
            let figure = TrainFigure::new(&layout, view);
            for _ in 0..4 {
                let angle = |random: &mut Random| 1e4 * (random.next() - 0.5);
                let pose = TrainPose {
                    angles: [0; 4].map(|_| angle(&mut random)),
                    speeds: [0; 4].map(|_| random.of(&[0.0, 1e-9, -3.0, 40.0])),
                    torques: random.of(&[None, Some([1.0, -1.0]), Some([0.0, 0.3])]),
                    ground: angle(&mut random),
                };
                check_whole(&figure, &pose, &format!("{layout:?} {view:?} {pose:?}"));
            }
        }
    }
}

/// Returns the angle from a tooth or plate to a direction, as a share of the pitch, from 0 to 1. `own` has the
/// directions of all teeth or plates.
fn share(own: &[f64], direction: f64) -> f64 {
    let pitch = TAU / own.len() as f64;
    ((direction - own[0]) / pitch).rem_euclid(1.0)
}

/// Returns for each wheel of a body the directions of its teeth, or of the plates with north poles at their faces.
fn directions(all: &[Drawn], body: usize, view: TrainView) -> Vec<Vec<f64>> {
    let middle = |line: &[[f64; 2]]| {
        let sum = line
            .iter()
            .fold([0.0; 2], |[x, y], at| [x + at[0], y + at[1]]);
        (
            sum[1].atan2(sum[0]),
            sum[0].hypot(sum[1]) / line.len() as f64,
        )
    };
    let of_body = all.iter().filter(|drawn| drawn.body == body);
    match view.coupling {
        Coupling::Magnetic => {
            let wheels = of_body.filter(|drawn| drawn.is(1, Role::Accent5));
            let wheels = wheels.map(|drawn| {
                let plates: Vec<(f64, f64)> =
                    drawn.lines().iter().map(|line| middle(line)).collect();
                // On alternating plates the north pole is at the face of one and at the back of the next.
                let face = plates[0].1;
                let at_face = plates
                    .iter()
                    .filter(|(_, radius)| (radius / face - 1.0).abs() < 0.01);
                at_face.map(|(direction, _)| *direction).collect()
            });
            wheels.collect()
        }
        Coupling::Contact => {
            // The outline has fourteen points for each tooth; the middle two are at the tip.
            let wheels = of_body.filter(|drawn| drawn.record[0] == 1.0 && drawn.record[2] == 1.0);
            let toothed = wheels.filter_map(|drawn| {
                let line = &drawn.lines()[0];
                (line.len() % 14 == 0 && line.len() > 180).then(|| {
                    let teeth = line.chunks(14);
                    teeth.map(|tooth| middle(&tooth[6..8]).0).collect()
                })
            });
            toothed.collect()
        }
    }
}

/// At all angles that Willis's equation allows, on the centre line of two wheels teeth face gaps. Like plates stand
/// between one another; alternating plates face each other, north to south.
#[test]
fn wheels_mesh_at_all_angles() {
    let planar = |z, k| layout(Train::planar(z).unwrap(), k);
    let stepped = |z, k| layout(Train::stepped(z).unwrap(), k);
    for (layout, view) in [
        (planar([20.0, 20.0, 60.0], 4.0), CONTACT),
        (planar([18.0, 21.0, 60.0], 3.0), CONTACT),
        (stepped([24.0, 15.0, 21.0, 60.0], 1.0), CONTACT),
        (magnets(), ALIKE),
        (planar([20.0, 10.0, 44.0], 4.0), ALTERNATING),
        (planar([60.0, 12.0, 90.0], 5.0), ALTERNATING),
        (stepped([20.0, 24.0, 12.0, 58.0], 2.0), ALIKE),
        (stepped([20.0, 24.0, 12.0, 60.0], 2.0), ALTERNATING),
    ] {
        let assembly = layout
            .train()
            .differential()
            .assembly(layout.counts().satellites);
        assert!(assembly.met(), "{layout:?}");
        let figure = TrainFigure::new(&layout, view);
        for step in 0..25 {
            let sun = 1.7 * f64::from(step);
            let angles = turned(&layout, sun, 3.0 - 0.6 * f64::from(step));
            let (poses, all) = drawn(&figure, &at_rest(angles));
            let wheels = |body| directions(&all, body, view);
            let share = |body: usize, own: &[f64], to: f64| share(own, to - poses[body][2]);
            let (suns, rings) = (wheels(1), wheels(3));
            for (body, [x, y, _]) in poses.iter().enumerate().skip(4) {
                let mut own = wheels(body);
                let line = y.atan2(*x);
                // The wheel of a stepped satellite with z₂ teeth meets the sun.
                let z2 = layout.train().teeth(Member::Satellite) as usize;
                let count = match view {
                    ALTERNATING => z2 / 2,
                    _ => z2,
                };
                own.sort_by_key(|own| own.len() != count);
                let [first, last] = [&own[0], own.last().unwrap_or(&own[0])];
                let at_sun = share(1, &suns[0], line) + share(body, first, line + PI);
                let at_ring = share(3, &rings[0], line) - share(body, last, line);
                for (place, phase) in [("sun", at_sun), ("ring", at_ring)] {
                    let off = (phase - 0.5) - (phase - 0.5).round();
                    assert!(off.abs() < 2e-3, "{layout:?}, body {body}, {place}: {off}");
                }
            }
        }
    }
}

/// Each gap is drawn with the width that the layout gives.
#[test]
fn gaps_are_drawn_as_they_are() {
    let layout = magnets();
    let figure = TrainFigure::new(&layout, ALIKE);
    let (poses, all) = drawn(&figure, &at_rest([0.0; 4]));
    let reach = |body: usize, most: f64| {
        let plates = all
            .iter()
            .filter(|drawn| drawn.body == body && drawn.is(1, Role::Accent5));
        let radii = plates
            .flat_map(|drawn| drawn.lines().concat())
            .map(|[x, y]| x.hypot(y));
        radii.fold(most, if most == 0.0 { f64::max } else { f64::min })
    };
    let distance = poses[4][0];
    let [sun, satellite, ring] = [reach(1, 0.0), reach(4, 0.0), reach(3, f64::INFINITY)];
    let gaps = layout.gaps().unwrap();
    assert!((distance - sun - satellite - gaps[0]).abs() < 1e-4);
    assert!((ring - distance - satellite - gaps[1]).abs() < 1e-4);
}

/// Bodies at rest relative to the observer keep their positions.
#[test]
fn the_observer_sees_the_frame_turn() {
    let figure = TrainFigure::new(&magnets(), ALIKE);
    let pose = TrainPose {
        ground: -1.0,
        ..at_rest([0.4, 2.0, 0.0, 0.6])
    };
    let (poses, _) = drawn(&figure, &pose);
    assert!((poses[0][2] - (TAU - 1.0)).abs() < 1e-6);
    assert!((poses[2][2]).abs() < 1e-6);
    let distance = magnets().axis_distance(Coupling::Magnetic);
    assert_eq!(&poses[4][..2], &[distance, 0.0]);
}
