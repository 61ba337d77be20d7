//! The lesson on synthesis from positions: its numbers, and its claims about linkages.

mod notes;
mod paper;

use assur::motion::Motion;
use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, System, Truth, Unknown, alternative, conditions, functional, theorems,
    truth,
};
use assur::synthesis::four_bar::{
    ChangeKind, Family, Options, Order, Passage, Position, Proportions, Solution, Task,
    TwoPositions,
};
use assur::{FourBar, Grashof};
use assur_file::{LinkageDocument, Synthesis, SynthesisDocument};
use assur_tests::files;
use serde_json::Value;

use super::{LANGUAGES, Lesson, numbers};

const LESSON: Lesson = Lesson("synthesis");

/// The document of a preset of the lesson.
fn preset(name: &str) -> Value {
    files::preset("synthesis", name).unwrap()
}

fn document(name: &str) -> SynthesisDocument {
    serde_json::from_value(preset(name)).unwrap()
}

fn synthesis(preset: &str) -> Synthesis {
    document(preset).synthesis().unwrap()
}

fn family(preset: &str) -> Family {
    match synthesis(preset).options {
        Options::Family(family) => family,
        other => panic!("{other:?}"),
    }
}

fn exact(preset: &str) -> Solution {
    match synthesis(preset).options {
        Options::Exact(solutions) if solutions.len() == 1 => solutions[0].clone(),
        other => panic!("{other:?}"),
    }
}

/// The angles of a position as the preset has them with that of the coupler.
fn angles(preset: &str) -> Vec<Angles> {
    let document = document(preset);
    let positions = document.positions.iter();
    let angles = positions.map(|position| Angles {
        frame: document.phi0_deg.to_radians(),
        coupler: position.coupler_deg.unwrap().to_radians(),
        output: position.output_deg.to_radians(),
        input: position.input_deg.to_radians(),
    });
    angles.collect()
}

/// One position is met exactly for every l₁ below the least of two limits, and J is nothing there.
#[test]
fn one_position_is_always_met() {
    let frame = document("printed").frame;
    let angles = angles("printed")[0];
    let Some(Truth::Between { from, to: Some(to) }) = truth(&angles) else {
        panic!("no interval");
    };
    assert_eq!(from, 0.0);
    assert!((to * frame - 11.757).abs() < 5e-4, "{}", to * frame);
    assert!(System::new(&[angles]).unwrap().positive_minimum().value < 1e-20);
}

/// The positions that the text proposes have no family, though each alone is taken up.
#[test]
fn positions_without_a_family() {
    let frame = synthesis("family").task.frame();
    for lang in LANGUAGES {
        let all = numbers(&LESSON.words(lang)["family.text"], lang);
        // Before them stand 1/z₂ and 1/z₃.
        let all: Vec<f64> = all.into_iter().map(|(value, _)| value).collect();
        let degrees: [f64; 4] = all[2..].try_into().unwrap();
        let [output, input, other_output, other_input] = degrees.map(f64::to_radians);
        let positions = [[output, input], [other_output, other_input]];
        let positions = positions.map(|[output, input]| Position::new(output, input));
        let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
        assert!(
            matches!(TwoPositions::new(&task), Some(TwoPositions::None(_))),
            "{lang}: {degrees:?}"
        );
        for position in positions {
            let holds = (0..360).any(|coupler| {
                let angles = Angles {
                    frame: frame.angle,
                    coupler: f64::from(coupler).to_radians(),
                    output: position.output,
                    input: position.input,
                };
                truth(&angles).is_some_and(|truth| truth.holds())
            });
            assert!(holds, "{lang}: {position:?}");
        }
    }
}

/// Grashof's condition is met from the length on that is asked for; the coupler is the shortest
/// there, the input never turns, no member is a crank-rocker; it is met on one stretch.
#[test]
fn no_member_of_the_family_turns_its_input() {
    let family = family("family");
    let frame = family.task().frame().length;
    let all = family.changes().into_iter();
    let mut grashof: Vec<f64> = all
        .filter(|change| change.kind == ChangeKind::Grashof)
        .map(|change| change.proportions.output)
        .collect();
    grashof.sort_by(f64::total_cmp);
    let [from, to] = grashof[..] else {
        panic!("{grashof:?}");
    };
    assert!((from * frame - 9.18).abs() < 5e-3, "{}", from * frame);
    for lang in LANGUAGES {
        LESSON.tells(lang, "family.right", &[to * frame]);
    }
    for member in family.sample([0.0, 1.0], 2000) {
        let z = member.proportions;
        let verdict = member.verdict.unwrap();
        assert!(!verdict.turns, "{z:?}");
        assert_ne!(verdict.grashof, Grashof::CrankRocker);
        let within = from < z.output && z.output < to;
        assert_eq!(verdict.grashof == Grashof::DoubleRocker, within, "{z:?}");
        let others = [z.output, z.input, 1.0];
        assert!(!within || others.iter().all(|other| z.coupler < *other));
    }
}

/// The lengths of the paper leave the contour open in both positions; they are a crank-rocker; at
/// the coupler angles of the paper ΣJ is least elsewhere.
#[test]
fn printed_example() {
    let document = document("printed");
    let solved = synthesis("printed");
    let trial = document.trial.unwrap();
    let Proportions {
        coupler,
        output,
        input,
    } = solved.shown.proportions;
    for (z, length) in [coupler, output, input].into_iter().zip(trial) {
        assert!((z * document.frame - length).abs() < 1e-12);
    }
    let closures = solved.shown.closures.iter();
    let open: Vec<f64> = closures
        .map(|closure| closure.residual * document.frame)
        .collect();
    assert!(open.iter().all(|gap| gap.abs() > 0.05), "{open:?}");
    assert!((open[1].abs() - 0.0505).abs() < 5e-5, "{open:?}");
    assert_eq!(solved.shown.verdict.unwrap().grashof, Grashof::CrankRocker);

    let percent = |gap: f64| 100.0 * gap;
    let [z1, z2, z3] = [coupler, output, input];
    let given = angles("printed");
    let given: Vec<f64> = given
        .iter()
        .map(|angles| percent(functional(angles, [z1, z2, z3]).sqrt()))
        .collect();
    let closures = &solved.shown.closures;
    let best: Vec<f64> = closures
        .iter()
        .map(|one| one.coupler.to_degrees())
        .collect();
    let left: Vec<f64> = closures
        .iter()
        .map(|one| percent(one.residual.abs()))
        .collect();
    let least = System::new(&angles("printed")).unwrap().positive_minimum();
    let least = least.z.map(|z| z * document.frame);
    let [coupler, output, input] = trial;
    let expected = [
        &[coupler, output, input, document.frame][..],
        &given,
        &best,
        &left,
        &least,
    ]
    .concat();
    for lang in LANGUAGES {
        LESSON.tells(lang, "printed.text", &expected);
        let angle = document.positions[1].coupler_deg.unwrap();
        LESSON.tells(lang, "printed.question", &[2.0, angle]);
    }
}

/// The two lines of three positions meet in one linkage, whose shortest link is its input.
#[test]
fn three_positions_have_one_linkage() {
    let found = exact("three");
    let z = found.proportions;
    assert!(
        [z.coupler, z.output, 1.0]
            .iter()
            .all(|other| z.input < *other)
    );
    let verdict = found.verdict.unwrap();
    assert_eq!(verdict.passage, Passage::Continuous);
    assert_eq!(verdict.order, Order::Growing);
    assert_eq!(verdict.grashof, Grashof::CrankRocker);
}

/// More positions have several minima, of which none is nothing; an output and an input of no length
/// would bring ΣJ as near to nothing as one likes.
#[test]
fn many_positions_are_a_compromise() {
    let solved = synthesis("many");
    let Options::Minima { minima, .. } = &solved.options else {
        panic!("{:?}", solved.options);
    };
    assert!(minima.len() > 1, "{}", minima.len());
    assert!(minima.iter().all(|minimum| minimum.value > 1e-4));
    assert!(minima.iter().any(|minimum| minimum.held.is_empty()));
    let mut before = f64::INFINITY;
    for none in [1e-1, 1e-2, 1e-3] {
        let proportions = Proportions {
            coupler: 1.0,
            output: none,
            input: none,
        };
        let defect = Solution::new(&solved.task, proportions).defect(&solved.task);
        assert!(defect < 0.02 * before, "{defect}");
        before = defect;
    }
    assert!(before < minima[0].value);
}

/// The counterexamples are those of the text and of the preset: the conditions of theorems 3 to 5 hold in both positions, z₂ is
/// positive below one z₁, z₃ above another, greater one.
#[test]
fn counterexamples_to_theorems() {
    let both = angles("theorem");
    for angles in &both {
        let told = theorems(angles).unwrap();
        assert!(told[2..].iter().all(|one| one.conditions && !one.truth));
        assert_eq!(truth(angles), Some(Truth::None));
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let [z2, z3] = [0, 1].map(|k| alternative(by.constant[k], by.slope[k]));
        match (z2, z3) {
            (Alternative::First { below }, Alternative::Second { above }) => assert!(below < above),
            other => panic!("{other:?}"),
        }
    }
    let degrees =
        |angles: &Angles| [angles.coupler, angles.output, angles.input].map(f64::to_degrees);
    let [one, other] = [degrees(&both[0]), degrees(&both[1])];
    for lang in LANGUAGES {
        let text = &LESSON.words(lang)["theorem.text"];
        let all: Vec<f64> = numbers(text, lang)
            .into_iter()
            .map(|(value, _)| value)
            .collect();
        for degrees in [one, other] {
            let found = all.windows(3).any(|three| {
                three
                    .iter()
                    .zip(degrees)
                    .all(|(written, value)| (written - value).abs() < 1e-9)
            });
            assert!(found, "{lang}: {text}");
        }
    }
}

/// The coupler angles that are shown fail (14) and (25) in both positions; what the paper chose satisfies them.
#[test]
fn coupler_angles_to_be_chosen() {
    let holds = |angles: &Angles, number: u8| {
        let mut all = conditions(angles).into_iter();
        all.any(|one| one.number == number && one.holds)
    };
    for angles in angles("choose") {
        assert!(!holds(&angles, 14) && !holds(&angles, 25), "{angles:?}");
        // Their lengths may be positive all the same.
        assert!(truth(&angles).unwrap().holds());
    }
    for angles in angles("printed") {
        assert!(holds(&angles, 14) && holds(&angles, 25), "{angles:?}");
    }
    let shown = angles("choose")[0];
    for (coupler, expected) in [(shown.input - 1e-6, true), (shown.input + 1e-6, false)] {
        let angles = Angles { coupler, ..shown };
        assert_eq!(holds(&angles, 14) && holds(&angles, 25), expected);
    }
}

/// At the φ₁ of the text (14) fails and (34) holds; theorem 5 applies and is right.
#[test]
fn theorem_5_asks_for_less() {
    let angles = angles("direct")[0];
    let all = conditions(&angles);
    let holds = |number: u8| all.iter().any(|one| one.number == number && one.holds);
    assert!(!holds(14) && holds(34));
    let told = theorems(&angles).unwrap();
    assert!(!told[2].conditions && told[4].conditions && told[4].truth);
    for lang in LANGUAGES {
        let text = &LESSON.words(lang)["direct.text"];
        let written = numbers(text, lang);
        let degrees = angles.coupler.to_degrees();
        assert!(
            written
                .iter()
                .any(|(value, _)| (value - degrees).abs() < 1e-9),
            "{lang}"
        );
    }
}

/// An exact crank-rocker whose positions are on different circuits.
#[test]
fn positions_in_different_assemblies() {
    let solved = synthesis("continuity");
    assert!(solved.shown.worst_residual() < 1e-12);
    let verdict = solved.shown.verdict.unwrap();
    assert_eq!(verdict.grashof, Grashof::CrankRocker);
    assert_eq!(verdict.passage, Passage::OtherCircuit);
}

/// What the last step shows is a crank-rocker that passes within a degree of each of the three positions.
#[test]
fn linkage_that_is_shown_at_last() {
    let linkage: LinkageDocument = serde_json::from_value(preset("sent")).unwrap();
    let length = |name: &str| {
        let link = linkage.links.iter().find(|link| link.name == name);
        link.unwrap().length.unwrap()
    };
    let wanted = document("three");
    let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(length);
    let four_bar = FourBar::new([crank, coupler, rocker, wanted.frame]).unwrap();
    assert_eq!(four_bar.grashof(), Grashof::CrankRocker);
    let motion: Motion = linkage.motion().unwrap();
    let mechanism = motion.mechanism();
    let rocker = mechanism.link("rocker").unwrap();
    for position in &wanted.positions {
        let pose = motion.pose::<1>(position.input_deg.to_radians()).unwrap();
        let angle = mechanism.angle(&pose, rocker).value().to_degrees();
        // The rocker runs from D to C, e₂ from C to D.
        let off = (angle + 180.0 - position.output_deg + 180.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 1.0, "{position:?}: {off}");
    }
}
