//! Synthesis from poses and from paths.

use std::hint::black_box;

use assur::Point;
use assur::synthesis::approximation::{Course, Search, Target};
use assur::synthesis::poses::{Curve, Kind, Solutions, Task, Wanted};
use assur_file::Document;

use super::Contestant;

/// Number of linkages that a search compares, as many as in about a second: whole batches with their descents.
const CANDIDATES: usize = 200_000;

/// The rectangle in which curves are drawn.
const CORNERS: [Point; 2] = [Point::new(-20.0, -20.0), Point::new(20.0, 20.0)];

pub(crate) fn contestants() -> Vec<Contestant> {
    let Some(Ok(Document::Poses(document))) = assur_file::document("poses-five") else {
        panic!("the catalogue has no five poses");
    };
    let five = document.guidance().unwrap().task;
    let four = Task::new(&five.poses()[..4]).unwrap();
    let search = Search::new(drawn(), Default::default());
    vec![
        (
            "five poses, all linkages with verdicts",
            1,
            Box::new(move || {
                black_box(Solutions::new(&five, &Wanted::default()));
            }),
        ),
        (
            "four poses, curves of centre points and circle points",
            1,
            Box::new(move || {
                for kind in [Kind::Centre, Kind::Circle] {
                    black_box(Curve::new(&four, kind, CORNERS)).unwrap();
                }
            }),
        ),
        (
            "a candidate of a path, with the descents of 200,000",
            CANDIDATES,
            Box::new(move || {
                black_box(search.clone().step(CANDIDATES));
            }),
        ),
    ]
}

/// A closed path of two harmonics, sampled at 24 points.
fn drawn() -> Target {
    let points = (0..24).map(|k| {
        let t = f64::from(k) * std::f64::consts::TAU / 24.0;
        Point::new(
            t.cos() + 0.2 * (2.0 * t).sin(),
            0.7 * t.sin() + 0.1 * (3.0 * t).cos(),
        )
    });
    Target::new(&points.collect::<Vec<_>>(), Course::Closed, None).unwrap()
}
