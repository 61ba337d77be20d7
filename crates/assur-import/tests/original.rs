//! URLs of the first PMKS, and the pairs made from their joints.

use std::f64::consts::TAU;

use assur::motion::Motion;
use assur_file::{DriverDocument, LinkageDocument};
use assur_import::{Imported, LeftOut, read};

use super::published::keeps_its_lengths;

fn opened(joints: &str) -> Imported {
    read(&format!(
        "https://designengrlab.github.io/PMKS/pmks.html?{joints}"
    ))
    .unwrap()
}

fn moving(document: &LinkageDocument) -> Motion {
    let motion = document.motion().unwrap();
    assert_eq!(motion.mechanism().counts().mobility, 1);
    keeps_its_lengths("made", document, &motion);
    motion
}

/// Returns the x coordinate of a point at twelve inputs over a turn.
fn run(motion: &Motion, point: &str) -> Vec<f64> {
    let mechanism = motion.mechanism();
    let point = mechanism.point(point).unwrap();
    let inputs = (0..12).map(|k| f64::from(k) * TAU / 12.0);
    inputs
        .map(|input| {
            mechanism
                .place(&motion.pose::<1>(input).unwrap(), point)
                .x
                .value()
        })
        .collect()
}

/// A crank of 10 and a coupler of 20, whose end slides on the line y = 2: x = r cos φ + √(l² − (r sin φ − e)²). The
/// order of the links of the slide does not matter.
#[test]
fn a_sliding_block_is_the_same_from_both_sides() {
    let rest = "mech=ground,a,R,0,0,0,fffT|a,b,R,10,0,0,ffff|b,c,R,29.8997487421324,2,0,ffff|";
    for pair in [
        "ground,c,P,15,7,0,tfff|",
        "c grnd p 15 7 180 +---|",
        "c,0,P,15,7|",
    ] {
        let imported = opened(&format!("{rest}{pair}"));
        let motion = moving(&imported.document);
        assert!(motion.cycle().is_full());
        let x = run(&motion, "C");
        for (k, x) in x.into_iter().enumerate() {
            let (sin, cos) = (k as f64 * TAU / 12.0).sin_cos();
            let expected = 10.0 * cos + (400.0 - (10.0 * sin - 2.0).powi(2)).sqrt();
            assert!(
                (x - expected).abs() < 1e-12 * 40.0,
                "{pair}: {x}, not {expected}"
            );
        }
    }
}

/// The first link of a pin in a slot has the slot, the second has the pin. Either may be the ground.
#[test]
fn a_pin_slides_in_the_slot_of_the_first_link() {
    // A lever on the pivot (0, −2). The crank's pin, drawn at (0, 1), slides in its slot.
    let lever = "mech=ground,crank,R,0,0,ffft|ground,lever,R,0,-2|lever,crank,RP,0,1,90|";
    let imported = opened(lever);
    let motion = moving(&imported.document);
    assert!(motion.cycle().is_full());
    let [slide] = &imported.document.slides[..] else {
        panic!("{:?}", imported.document.slides);
    };
    assert_eq!((slide.on.as_str(), slide.point.as_str()), ("lever", "C"));
    // A coupler that slides over a pin of the ground: its line always passes through (5, 0).
    let swinging = "mech=ground,crank,R,0,0,ffft|crank,coupler,R,2,0|coupler,ground,RP,5,0,0|";
    let imported = opened(swinging);
    let motion = moving(&imported.document);
    assert!(motion.cycle().is_full());
    let mechanism = motion.mechanism();
    let coupler = mechanism.link("coupler").unwrap();
    for k in 0..12 {
        let input = f64::from(k) * TAU / 12.0;
        let pose = motion.pose::<1>(input).unwrap();
        let (sin, cos) = input.sin_cos();
        let expected = (-2.0 * sin).atan2(5.0 - 2.0 * cos);
        let turned = mechanism.angle(&pose, coupler).value()
            - mechanism
                .angle(&motion.pose::<1>(0.0).unwrap(), coupler)
                .value();
        assert!(
            (turned - expected).sin().abs() < 1e-12,
            "{input}: {turned}, not {expected}"
        );
    }
}

#[test]
fn the_driver_is_what_is_told_or_the_first_pair() {
    let four_bar = |letters: [&str; 4]| {
        let [a, b, c, d] = letters;
        format!(
            "mech=tip,R,3,3,tfff|ground,a,R,0,0,{a}|a,tip,R,0,1,{b}|tip,d,R,3.8,2.249,{c}|d,GROUND2,R,4,0,{d}|"
        )
    };
    let crank = |crank: &str, base: Option<&str>| DriverDocument {
        crank: Some(crank.to_owned()),
        base: base.map(str::to_owned),
        ..DriverDocument::default()
    };
    for (letters, driver) in [
        (["ffff", "ffff", "ffff", "ffff"], crank("a", None)),
        (
            ["tttt", "ffff", "ffff", "False,false,FALSE,true"],
            crank("d", None),
        ),
        (["----", "---+", "----", "----"], crank("tip", Some("a"))),
    ] {
        let imported = opened(&four_bar(letters));
        assert_eq!(imported.document.drivers, [driver]);
        assert_eq!(imported.document.frame, ["B", "E"]);
        moving(&imported.document);
    }
    // A driven slide on the ground has no range in the URL.
    let slider = |letters: &str| {
        format!("set=s-50|e0.1&mech=ground,a,R,0,0|a,b,R,1,0|b,c,R,4,0|c,ground,P,4,0,0,{letters}|")
    };
    let imported = opened(&slider("ffft"));
    let [driver] = &imported.document.drivers[..] else {
        panic!("{:?}", imported.document.drivers);
    };
    assert_eq!(driver.slide, Some(0));
    // The pin is at the middle of its line, whose length is 0.3 of the drawing's size 4. The range extends by this size
    // on both sides.
    let [min, max] = driver.range.unwrap();
    assert!((min + 3.4).abs() < 1e-12 && (max - 4.6).abs() < 1e-12);
    let point = "D".to_owned();
    assert_eq!(imported.left_out, [LeftOut::Range { point, min, max }]);
    let imported = opened("mech=ground,a,R,0,0|ground,b,R,5,0|b,a,RP,2,1,0,ffft|");
    let none = LeftOut::Driver {
        point: "C".to_owned(),
    };
    assert_eq!(imported.left_out, [none]);
    assert_eq!(imported.document.drivers, []);
}
