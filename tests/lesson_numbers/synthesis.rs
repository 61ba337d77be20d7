//! The lesson on synthesis from positions: its numbers, and what it claims of linkages.

use assur::motion::Motion;
use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, System, Truth, Unknown, alternative, theorems, truth,
};
use assur::synthesis::four_bar::{
    ChangeKind, Family, Options, Order, Passage, Position, Proportions, Solution, Task,
    TwoPositions,
};
use assur::{FourBar, Grashof};
use assur_file::{LinkageDocument, Synthesis, SynthesisDocument};
use serde_json::Value;

use super::{LANGUAGES, Lesson, numbers};

const LESSON: Lesson = Lesson("synthesis");

/// The document of a preset of the lesson.
fn preset(name: &str) -> Value {
    let presets: Value = serde_json::from_str(&LESSON.file("presets.json")).unwrap();
    presets[name]["document"].clone()
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

    let least = System::new(&angles("printed")).unwrap().positive_minimum();
    let least = least.z.map(|z| z * document.frame);
    let [coupler, output, input] = trial;
    let expected = [
        &[coupler, output, input, document.frame][..],
        &[least[0], least[1], least[2]],
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

/// The counterexample is that of the text and of the preset: the conditions of theorem 3 hold, z₂ is
/// positive below one z₁, z₃ above another, greater one.
#[test]
fn counterexample_to_a_theorem() {
    let angles = angles("theorem")[0];
    let degrees = [angles.coupler, angles.output, angles.input].map(f64::to_degrees);
    let third = theorems(&angles).unwrap()[2];
    assert!(third.conditions && !third.truth);
    assert_eq!(truth(&angles), Some(Truth::None));
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    let [z2, z3] = [0, 1].map(|k| alternative(by.constant[k], by.slope[k]));
    match (z2, z3) {
        (Alternative::First { below }, Alternative::Second { above }) => assert!(below < above),
        other => panic!("{other:?}"),
    }
    let [coupler, output, input] = degrees;
    let number = f64::from(third.number);
    for lang in LANGUAGES {
        // z₂ > 0 and z₃ > 0.
        let expected = [number, coupler, output, input, 0.0, 0.0];
        LESSON.tells(lang, "theorem.text", &expected);
    }
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
