//! All assemblies of groups of every class, found by two methods.

use std::f64::consts::TAU;

use assur::mechanism::{Assemblies, LinkageSpec, Mechanism, Method};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::scaled;

use super::groups::{KINDS, Kind, drawn};

const GROUPS: u64 = 12;
const SPECIAL: u64 = 4;
const FOLLOWED: u64 = 4;
/// Angles of assemblies agree, radians.
const SAME: f64 = 2e-11;

/// The angles of all links in each assembly, in [0, 2π), ascending by the first that differs.
fn angles(mechanism: &Mechanism, found: &Assemblies) -> Vec<Vec<f64>> {
    let angles = found.poses.iter().map(|pose| {
        let links = mechanism.link_ids();
        let angle = |link| mechanism.angle(pose, link).value().rem_euclid(TAU);
        links.map(angle).collect::<Vec<f64>>()
    });
    angles.collect()
}

fn alike(one: &[f64], other: &[f64]) -> bool {
    let off = |(a, b): (&f64, &f64)| {
        let turned = (a - b).rem_euclid(TAU);
        turned.min(TAU - turned)
    };
    one.iter().zip(other).map(off).all(|off| off < SAME)
}

/// The same by the determinant of the loops as by paths, real and complex; an even number; none twice; the drawn one among
/// them; at the drawn input and a third of a turn on.
#[test]
fn two_methods_find_the_same_assemblies() {
    for (kind, _) in KINDS {
        for seed in 0..scaled(GROUPS) {
            let mechanism = Mechanism::new(&drawn(kind, seed)).unwrap();
            for input in [mechanism.drawn_input(), mechanism.drawn_input() + TAU / 3.0] {
                let at = format!("{kind:?} {seed} at {input}");
                let methods = [Method::Usual, Method::Paths];
                let [usual, paths] = methods.map(|method| mechanism.assemblies_at(input, method));
                assert_eq!(usual.complex, paths.complex, "{at}");
                let [one, other] = [&usual, &paths].map(|found| angles(&mechanism, found));
                assert_eq!(one.len(), other.len(), "{at}");
                assert_eq!(one.len() % 2, 0, "{at}");
                for (k, assembly) in one.iter().enumerate() {
                    let same = other.iter().filter(|other| alike(assembly, other)).count();
                    assert_eq!(same, 1, "{at}");
                    assert!(!one[..k].iter().any(|other| alike(assembly, other)), "{at}");
                }
                if input == mechanism.drawn_input() {
                    // A drawing may stand at a dead point.
                    let motion = Motion::new(mechanism.clone());
                    let Ok(pose) = motion.pose::<1>(input) else {
                        continue;
                    };
                    let links = mechanism.link_ids();
                    let drawn: Vec<f64> = links
                        .map(|link| mechanism.angle(&pose, link).value())
                        .collect();
                    assert!(one.iter().any(|one| alike(one, &drawn)), "{at}");
                }
            }
        }
    }
}

/// Dimensions that people choose.
#[derive(Clone, Copy, Debug)]
enum Choice {
    /// All points on a grid, so that many lengths are alike or whole, and links parallel.
    Grid,
    /// Links of three points with these in a line.
    InLine,
    /// Bars of whole lengths, many of them alike.
    Whole,
}

/// A group of such dimensions; none where it cannot be joined so.
fn chosen(kind: Kind, choice: Choice, seed: u64) -> Option<Mechanism> {
    let mut draft = drawn(kind, seed);
    let at = |draft: &LinkageSpec, name: &str| {
        let mut points = draft.points.iter();
        points.find(|point| point.name == name).unwrap().at
    };
    match choice {
        Choice::Grid => {
            for point in &mut draft.points {
                point.at = point.at.map(f64::round);
            }
        }
        Choice::InLine => {
            for link in draft.links.clone() {
                let [first, second, third] = &link.points[..] else {
                    continue;
                };
                let [a, b] = [first, second].map(|name| at(&draft, name));
                let third = draft.points.iter_mut().find(|point| point.name == *third);
                third.unwrap().at = a + 2.0 * (b - a);
            }
        }
        Choice::Whole => {
            for link in &mut draft.links {
                if let [a, b] = &link.points[..] {
                    let [a, b] =
                        [a, b].map(|name| draft.points.iter().find(|one| one.name == *name));
                    let length = (a.unwrap().at - b.unwrap().at).norm().round().max(1.0);
                    let ends = [Point::origin(), Point::origin() + length * Vector::x()];
                    link.shape = Some(ends.to_vec());
                }
            }
        }
    }
    Mechanism::new(&draft).ok()
}

/// Of dimensions that people choose both methods find the same real ways, an even number, none twice.
#[test]
fn special_dimensions() {
    let mut bad = Vec::new();
    for (kind, _) in KINDS {
        for choice in [Choice::Grid, Choice::InLine, Choice::Whole] {
            let mut compared = 0;
            for seed in 0..scaled(SPECIAL) {
                let Some(mechanism) = chosen(kind, choice, seed) else {
                    continue;
                };
                for input in [
                    mechanism.drawn_input() + 0.37,
                    mechanism.drawn_input() + 2.3,
                ] {
                    let methods = [Method::Usual, Method::Paths];
                    let found = methods.map(|method| mechanism.assemblies_at(input, method));
                    let [one, other] = found.each_ref().map(|found| angles(&mechanism, found));
                    let missed = |one: &[Vec<f64>], other: &[Vec<f64>]| {
                        let known = |assembly: &&Vec<f64>| {
                            !other.iter().any(|other| alike(assembly, other))
                        };
                        one.iter().filter(known).count()
                    };
                    let twice = one
                        .iter()
                        .enumerate()
                        .any(|(k, assembly)| one[..k].iter().any(|other| alike(assembly, other)));
                    if missed(&one, &other) + missed(&other, &one) > 0 || twice || one.len() % 2 > 0
                    {
                        bad.push(format!(
                            "{kind:?} {choice:?} {seed} at {input}: {} and {} of {:?} and {:?}",
                            one.len(),
                            other.len(),
                            found[0].complex,
                            found[1].complex
                        ));
                    }
                    compared += 1;
                }
            }
            assert!(
                compared > scaled(SPECIAL) / 4,
                "{kind:?} {choice:?}: {compared}"
            );
        }
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// Followed from one input to the next, and found anew, they are the same: in steps of every width, forth and back, past folds,
/// and in chains of groups, each of which hangs in every way of those before it.
#[test]
fn followed_ones_are_all() {
    let chains = ["jansen", "watt-1", "class4-order2"];
    let groups = KINDS.iter().flat_map(|(kind, _)| {
        (0..scaled(FOLLOWED)).map(move |seed| (format!("{kind:?} {seed}"), drawn(*kind, seed)))
    });
    let chains = chains.map(|name| {
        let document = assur_file::from_catalogue(name).unwrap().unwrap();
        (
            name.to_owned(),
            document.mechanism().unwrap().spec().clone(),
        )
    });
    let mut bad = Vec::new();
    for (name, draft) in groups.chain(chains) {
        let mechanism = Mechanism::new(&draft).unwrap();
        let mut following = mechanism.following();
        let mut input = mechanism.drawn_input();
        for step in 0..60 {
            let width = 10_f64.powf(-0.3 * f64::from(step % 7)) * 3.0_f64.to_radians();
            input += if step % 10 < 8 { width } else { -width };
            let near = following.at(input);
            let anew = mechanism.assemblies_at(input, Method::Usual);
            let [one, other] = [&near, &anew].map(|found| angles(&mechanism, found));
            let known =
                |one: &Vec<f64>| other.iter().filter(|other| alike(one, other)).count() == 1;
            if one.len() != other.len() || !one.iter().all(known) || near.complex != anew.complex {
                bad.push(format!(
                    "{name} at {input}: {} of {}",
                    one.len(),
                    other.len()
                ));
            }
        }
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// A pose that was found is room for another one.
#[test]
fn poses_are_filled_again() {
    let document = assur_file::from_catalogue("class4-dwell").unwrap().unwrap();
    let mechanism = document.mechanism().unwrap();
    let motion = Motion::new(mechanism.clone());
    let expected = motion.pose::<1>(0.3).unwrap();
    let found = mechanism.assemblies_at(1.0, Method::Usual);
    for mut pose in found.poses.into_iter().chain([expected.clone()]) {
        motion.place(0.3, &mut pose).unwrap();
        for link in mechanism.link_ids() {
            let [one, other] = [&pose, &expected].map(|pose| mechanism.angle(pose, link).value());
            assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
    }
}
