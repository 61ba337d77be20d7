//! The search for a four-bar that traces a path, beside differential evolution with the same time: twenty curves of
//! linkages of the gallery, and ten drawn by hand. `cargo xtask paths` runs it.
//!
//! `cargo run --release -p assur-file --example evolution -- [CURVE …]`: all thirty curves, or those with these names.

#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a program for developers may stop with a panic"
)]

mod curves;
mod evolve;

use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::synthesis::approximation::{Search, Target, Traced, Tracing, Wanted};

use curves::Drawn;
use evolve::Evolution;

/// Times after which the greatest distances are compared.
const SECONDS: [u64; 3] = [1, 3, 10];
const SEEDS: usize = 5;
/// Both methods run in turns of this time, so that other work on the machine slows both alike.
const TURN: Duration = Duration::from_millis(50);

/// Runs the comparison and prints medians of the greatest distance over five seeds, relative to the size of the path.
fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let mut curves = curves::all();
    let known: Vec<String> = curves.iter().map(|curve| curve.name.clone()).collect();
    if let Some(name) = names.iter().find(|name| !known.contains(name)) {
        eprintln!("no curve {name}; there are: {}", known.join(", "));
        return ExitCode::from(2);
    }
    curves.retain(|curve| names.is_empty() || names.contains(&curve.name));
    println!(
        "{:30} {:>24} {:>24} {:>24}",
        "curve; search, evolution after", "1 s", "3 s", "10 s"
    );
    let ratios = Mutex::new(Vec::new());
    let next = Mutex::new(curves.iter());
    let work = || {
        while let Some(curve) = { next.lock().unwrap().next() } {
            let medians = beside(curve);
            let shown = medians.map(|[search, evolution]| {
                let mark = if search > evolution { "!" } else { " " };
                format!("{search:11.5} {evolution:11.5}{mark}")
            });
            println!("{:30} {}", curve.name, shown.join(" "));
            ratios
                .lock()
                .unwrap()
                .push(medians.map(|[search, evolution]| evolution / search));
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(work);
        }
    });
    let ratios = ratios.into_inner().unwrap();
    for (k, seconds) in SECONDS.iter().enumerate() {
        let of: Vec<f64> = ratios.iter().map(|ratios| ratios[k]).collect();
        let mean = (of.iter().map(|ratio| ratio.ln()).sum::<f64>() / of.len() as f64).exp();
        let worse = of.iter().filter(|ratio| **ratio < 1.0).count();
        println!(
            "after {seconds} s: evolution / search {mean:.3} (geometric mean); search worse {worse} times"
        );
    }
    ExitCode::SUCCESS
}

/// Medians of the greatest distances of search and evolution after each time.
fn beside(curve: &Drawn) -> [[f64; 2]; 3] {
    let target = Target::new(&curve.points, curve.course, None).expect("a path");
    let mut found = [const { [const { Vec::new() }; 2] }; 3];
    for seed in 0..SEEDS {
        let wanted = Wanted {
            seed: seed as u64,
            ..Wanted::default()
        };
        let mut search = Search::new(target.clone(), wanted);
        let mut evolution = Evolution::new(&target, seed as u64);
        let (mut spent, mut best) = ([Duration::ZERO; 2], f64::INFINITY);
        for (k, seconds) in SECONDS.iter().enumerate() {
            let until = Duration::from_secs(*seconds);
            while spent.iter().any(|spent| *spent < until) {
                turn(&mut spent[0], until, || _ = search.step(256));
                turn(&mut spent[1], until, || evolution.generation());
            }
            let linkage = search.best().map(|best| best.linkage);
            found[k][0].push(greatest(linkage, &target));
            // A population that has converged starts anew: the best of all of them counts.
            best = greatest(evolution.best().map(Tracing::FourBar), &target).min(best);
            found[k][1].push(best);
        }
    }
    found.map(|pair| {
        pair.map(|mut values| {
            values.sort_by(f64::total_cmp);
            values[SEEDS / 2] / target.size()
        })
    })
}

/// Runs a method for its turn, at most up to a time in all.
fn turn(spent: &mut Duration, until: Duration, mut step: impl FnMut()) {
    let end = until.min(*spent + TURN);
    while *spent < end {
        let start = Instant::now();
        step();
        *spent += start.elapsed();
    }
}

/// The greatest distance between the path and the curve that a linkage traces as it moves.
fn greatest(linkage: Option<Tracing>, target: &Target) -> f64 {
    let judged = linkage.and_then(|linkage| {
        let motion = Motion::new(Mechanism::new(&linkage.spec()).ok()?);
        Some(Traced::new(&linkage, &motion, target)?.deviation.greatest)
    });
    judged.unwrap_or(f64::INFINITY)
}
