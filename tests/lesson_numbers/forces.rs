//! The lesson on forces in the mixer: its masses, and the forces, torques and powers in its texts.

use std::f64::consts::{FRAC_PI_3, TAU};

use assur::forces::{Kinetostatics, Reactions, Source};
use assur::motion::Motion;
use assur_file::LinkageDocument;
use assur_tests::assert_near;
use assur_tests::files::preset;

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("mixer-forces");

/// Angular velocity of the crank in the lesson, rad/s.
const OMEGA: f64 = 6.0;

/// Steps of a turn over which greatest and mean values are taken.
const STEPS: usize = 1440;

fn document(name: &str) -> LinkageDocument {
    serde_json::from_value(preset("mixer-forces", name).unwrap()).unwrap()
}

struct Loaded {
    motion: Motion,
    statics: Kinetostatics,
    loading: assur::forces::Loading,
}

impl Loaded {
    fn new(name: &str) -> Self {
        Self::of(&document(name))
    }

    fn of(document: &LinkageDocument) -> Self {
        let motion = document.motion().unwrap();
        let mechanism = motion.mechanism();
        Self {
            statics: Kinetostatics::new(mechanism),
            loading: document.loading(mechanism).unwrap(),
            motion,
        }
    }

    fn at(&self, input: f64, omega: f64) -> Reactions {
        let pose = self.motion.pose(input).unwrap();
        let found = self
            .statics
            .reactions(&self.loading, &pose, input, [omega, 0.0]);
        found.unwrap()
    }

    fn torque(&self, input: f64, omega: f64) -> f64 {
        self.at(input, omega).first_drive().unwrap()
    }

    /// Magnitude of the reaction in a hinge at 60°.
    fn reaction(&self, hinge: &str) -> f64 {
        let mechanism = self.motion.mechanism();
        let mut pairs = self.statics.pairs();
        let (id, _) = pairs
            .find(|(_, pair)| pair.name(mechanism) == hinge)
            .unwrap();
        self.at(FRAC_PI_3, OMEGA).of(id).vector().unwrap().norm()
    }

    /// Greatest magnitude of the torque on the crank over a turn, and mean power of the motor.
    fn turn(&self) -> [f64; 2] {
        let inputs = (0..STEPS).map(|step| TAU * step as f64 / STEPS as f64);
        let torques: Vec<f64> = inputs.map(|input| self.torque(input, OMEGA)).collect();
        let greatest = torques
            .iter()
            .map(|torque| torque.abs())
            .fold(0.0, f64::max);
        [greatest, torques.iter().sum::<f64>() / STEPS as f64 * OMEGA]
    }
}

#[test]
fn masses_are_as_the_text_says() {
    let loaded = document("loaded");
    let mass = |name: &str| {
        loaded
            .links
            .iter()
            .find(|link| link.name == name)
            .unwrap()
            .mass_kg
    };
    let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(|name| mass(name).unwrap());
    for lang in LANGUAGES {
        LESSON.tells(lang, "inertia.text", &[crank, coupler, rocker, OMEGA, 60.0]);
        LESSON.tells(lang, "inertia.hint", &[coupler]);
        LESSON.tells(lang, "tangential.hint", &[0.85]);
        LESSON.tells(lang, "drag.text", &[5.0, 0.5]);
    }
    // Uniform bars, the same in all three cases.
    for (name, rocker_length) in [
        ("inertia", 0.55),
        ("loaded", 0.55),
        ("loaded_b", 1.0),
        ("loaded_c", 0.55),
    ] {
        let document = document(name);
        for (link, length) in [
            ("crank", 0.37),
            ("coupler", 0.85),
            ("rocker", rocker_length),
        ] {
            let of = document.links.iter().find(|one| one.name == link).unwrap();
            let inertia = of.mass_kg.unwrap() * length * length / 12.0;
            assert_near(of.inertia.unwrap(), inertia, 1e-8, "a uniform bar");
            assert_eq!(of.mass_kg, Some(mass(link).unwrap()));
        }
        let drawn = document.motion().unwrap().drawn_input();
        assert_near(drawn, FRAC_PI_3, 1e-9, "drawn at 60°");
    }
}

/// An independent program solved the equilibrium of crank, coupler and rocker.
#[test]
fn forces_at_sixty_degrees() {
    let inertia = Loaded::new("inertia").at(FRAC_PI_3, OMEGA);
    let largest = inertia
        .applied()
        .iter()
        .filter(|one| matches!(one.source, Source::Inertia));
    let sizes: Vec<f64> = largest.map(|one| one.force.norm()).collect();
    assert!(
        sizes.iter().any(|size| (size - 54.8733).abs() < 1e-4),
        "{sizes:?}"
    );
    let weights = Loaded::new("weights");
    assert_near(weights.reaction("B"), 61.9533, 1e-4, "R₁₂");
    assert_near(weights.reaction("D"), 50.897, 1e-3, "R₀₃");
    assert_near(weights.torque(FRAC_PI_3, OMEGA), 20.795_209_3, 1e-6, "T");
}

#[test]
fn drag_grows_with_the_square_of_the_speed() {
    let drag = Loaded::new("drag");
    let [slow, fast] = [1.0, 2.0].map(|times| drag.torque(FRAC_PI_3, times * OMEGA));
    assert_near(fast / slow, 4.0, 1e-12, "doubled speed");
    let [a, b, c] = ["A", "B", "C"].map(|hinge| drag.reaction(hinge));
    assert_near(a, b, 1e-9, "A and B");
    assert_near(b, c, 1e-9, "B and C");
}

#[test]
fn three_cases() {
    let [a, b, c] = ["loaded", "loaded_b", "loaded_c"].map(|name| Loaded::new(name).turn());
    let [_, drag] = Loaded::new("drag").turn();
    // Masses and gravity do no work over a turn.
    assert_near(a[1], drag, 1e-9 * drag, "mean power");
    for lang in LANGUAGES {
        LESSON.tells(lang, "cases.text", &[1.0, OMEGA, a[1], b[1], c[1]]);
        LESSON.tells(lang, "cases.right", &[a[0], b[0], c[0]]);
    }
    // In case c nearly all of it is due to the masses.
    let mut still = document("loaded_c");
    still.loads.clear();
    let [weights, _] = Loaded::of(&still).turn();
    assert!(weights > 0.9 * c[0], "{weights} of {}", c[0]);
}
