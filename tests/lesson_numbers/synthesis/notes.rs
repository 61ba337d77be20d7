//! The numbers in the notes for teachers on synthesis, computed by the engine.

use assur::synthesis::four_bar::theorems::{
    Alternative, Angles, System, Truth, Unknown, alternative, conditions, functional, opening,
    theorems, truth,
};
use assur::synthesis::four_bar::{
    ChangeKind, Family, Frame, Passage, Position, Proportions, Solution, Task, TwoPositions,
};
use assur::{Assembly, Grashof};

use super::{LESSON, angles, document, family, synthesis};

/// Asserts that the English notes, in one line, say this.
fn says(said: &str) {
    let text = LESSON.file("notes.en.md");
    let notes = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(notes.contains(said), "{said}");
}

fn holds(angles: &Angles, number: u8) -> bool {
    let mut all = conditions(angles).into_iter();
    all.any(|one| one.number == number && one.holds)
}

/// Lengths as the notes have them, relative to the frame's.
fn relative([coupler, output, input]: [f64; 3], frame: f64) -> Proportions {
    Proportions {
        coupler: coupler / frame,
        output: output / frame,
        input: input / frame,
    }
}

/// How far a contour is open, in the unit of the lengths.
fn open(angles: &Angles, lengths: [f64; 3], frame: f64) -> f64 {
    frame * functional(angles, lengths.map(|length| length / frame)).sqrt()
}

/// Where a length, z₂ or z₃ by 0 or 1, is positive below some l₁.
fn below(angles: &Angles, k: usize, frame: f64) -> f64 {
    let by = angles.subsystem(Unknown::Coupler).unwrap();
    match alternative(by.constant[k], by.slope[k]) {
        Alternative::First { below } => below * frame,
        other => panic!("{other:?}"),
    }
}

/// The stretch of l₂ of a family within which Grashof's condition is met.
fn grashof(family: &Family) -> [f64; 2] {
    let frame = family.task().frame().length;
    let all = family.changes().into_iter();
    let all = all.filter(|one| one.kind == ChangeKind::Grashof);
    let mut ends: Vec<f64> = all.map(|one| one.proportions.output * frame).collect();
    assert_eq!(ends.len(), 2, "{ends:?}");
    ends.sort_by(f64::total_cmp);
    [ends[0], ends[1]]
}

/// At directions evenly over the turn, none of them parallel.
#[test]
fn how_often_theorems_hold() {
    let (mut sets, mut solvable, mut missed) = (0, 0, 0);
    let [mut third, mut fifth] = [[0, 0]; 2];
    let turns = |from: f64| (0..36).map(move |k| from + 10.0 * f64::from(k));
    for coupler in turns(0.4) {
        for output in turns(3.7) {
            for input in turns(7.1) {
                let [coupler, output, input] = [coupler, output, input].map(f64::to_radians);
                let angles = Angles {
                    frame: 0.0,
                    coupler,
                    output,
                    input,
                };
                let told = theorems(&angles).unwrap();
                let holds = truth(&angles).unwrap().holds();
                let inside = opening(&angles).is_some_and(|one| one < 180_f64.to_radians());
                assert_eq!(inside, holds, "{angles:?}");
                sets += 1;
                solvable += usize::from(holds);
                missed += usize::from(holds && !told[2].conditions);
                for (counts, one) in [(&mut third, told[2]), (&mut fifth, told[4])] {
                    counts[0] += usize::from(one.conditions);
                    counts[1] += usize::from(one.conditions && !holds);
                }
            }
        }
    }
    let of_twelve = |count: usize| {
        let count = 12.0 * count as f64 / f64::from(sets);
        assert!((count - count.round()).abs() < 0.1, "{count}");
        count.round()
    };
    let all = of_twelve(solvable);
    let ([asked, wrong], [fifth, also]) = (third.map(of_twelve), fifth.map(of_twelve));
    says(&format!(
        "Of 12 sets of random directions, on average {all} have positive lengths. Theorem 3 applies to {asked} of the 12, and \
         {wrong} of these has none; it misses {} of the {all}. Theorem 5 applies to {fifth}: to all {}, and to the same {also}.",
        of_twelve(missed),
        fifth - also,
    ));
}

#[test]
fn example_of_the_paper() {
    let printed = document("printed");
    let solved = synthesis("printed");
    let (frame, trial) = (printed.frame, printed.trial.unwrap());
    let [first, second] = angles("printed")[..] else {
        panic!("two positions");
    };
    let [l1, l2, l3] = trial;
    says(&format!("l₀ = {frame}, φ₀ = {}°", printed.phi0_deg));
    says(&format!("l₁ = {l1}, l₂ = {l2}, l₃ = {l3}"));
    let row = |name: &str, of: &dyn Fn(usize, &Angles) -> String| {
        says(&format!(
            "| {name} | {} | {} |",
            of(0, &first),
            of(1, &second)
        ));
    };
    row("φ₂, φ₃", &|k, _| {
        let at = &printed.positions[k];
        format!("{}°, {}°", at.output_deg, at.input_deg)
    });
    row("φ₁ as printed", &|k, _| {
        format!("{}°", printed.positions[k].coupler_deg.unwrap())
    });
    row("(14) and (25) hold for φ₁", &|k, angles| {
        let at = &printed.positions[k];
        let ends = [at.output_deg - 360.0, at.input_deg];
        for (end, within) in ends.into_iter().zip([1e-6, -1e-6]) {
            for (off, expected) in [(within, true), (-within, false)] {
                let coupler = (end + off).to_radians();
                let angles = Angles { coupler, ..*angles };
                assert_eq!(holds(&angles, 14) && holds(&angles, 25), expected, "{end}");
                assert!(truth(&angles).unwrap().holds());
            }
        }
        format!("−{}° … {}°", -ends[0], ends[1])
    });
    for (k, name) in ["l₂", "l₃"].into_iter().enumerate() {
        row(&format!("{name} > 0 at this φ₁"), &|_, angles| {
            format!("l₁ < {:.3}", below(angles, k, frame))
        });
    }
    let share = |gap: f64| format!("{gap:.3}, {:.1} % of l₀", 100.0 * gap / frame);
    row("open at this φ₁", &|_, angles| {
        share(open(angles, trial, frame))
    });
    let best = &solved.shown.closures;
    row("best φ₁", &|k, _| {
        format!("{:.3}°", best[k].coupler.to_degrees())
    });
    row("open at the best φ₁", &|k, _| {
        share(frame * best[k].residual.abs())
    });

    let least = System::new(&[first, second]).unwrap().positive_minimum();
    let [l1, l2, l3] = least.z.map(|z| z * frame);
    says(&format!(
        "ΣJ is least for l₁ = {l1:.3}, l₂ = {l2:.3}, l₃ = {l3:.3}."
    ));
    let family = family("family");
    let exact = family.with_output(5.0 / frame).unwrap();
    let z = exact.proportions;
    let [one, other] = [0, 1].map(|k| exact.closures[k].coupler.to_degrees());
    says(&format!(
        "with l₂ = 5 are l₁ = {:.3}, l₃ = {:.3}, and then φ₁ is {one:.3}° and {other:.3}°. This is a triple rocker.",
        z.coupler * frame,
        z.input * frame
    ));
    assert_eq!(exact.verdict.unwrap().grashof, Grashof::TripleRocker);
    let [from, to] = grashof(&family);
    says(&format!(
        "Grashof's condition is met for l₂ from {from:.3} to {to:.3} only"
    ));
}

#[test]
fn continuity_and_the_other_assembly() {
    let asked = document("continuity");
    let shown = synthesis("continuity").shown;
    let frame = asked.frame;
    let [l3, l1, l2, _] = shown.proportions.lengths(frame);
    let [one, other] = [0, 1].map(|k| &asked.positions[k]);
    says(&format!(
        "With l₀ = {frame} and (φ₂, φ₃) = ({}°, {}°) and ({}°, {}°), the linkage l₁ = {l1:.3}, l₂ = {l2:.3}, l₃ = {l3:.3}",
        one.output_deg, one.input_deg, other.output_deg, other.input_deg
    ));

    // Task 4: every crank-rocker of the family is in different assemblies.
    let family = family("continuity");
    let [from, to] = grashof(&family);
    says(&format!("For l₂ from {from:.3} to {to:.3}, and none does."));
    let mut seen = 0;
    for member in family.sample([0.0, 1.0], 2000) {
        let verdict = member.verdict.unwrap();
        let length = member.proportions.output * frame;
        let turns = verdict.grashof == Grashof::CrankRocker;
        assert_eq!(turns, from < length && length < to, "{length}");
        assert!(!turns || verdict.passage == Passage::OtherCircuit);
        seen += u32::from(turns);
    }
    assert!(seen > 100, "{seen}");
    let linkage = shown.proportions.four_bar(frame).unwrap();
    let mut ways = [Assembly::First, Assembly::Second].map(|assembly| {
        let pose = linkage.pose::<1>(assembly, other.input_deg.to_radians());
        (pose.unwrap().rocker.value().to_degrees() + 180.0).rem_euclid(360.0)
    });
    ways.sort_by(f64::total_cmp);
    says(&format!(
        "At φ₃ = {}° the linkage has φ₂ = {:.0}° in one assembly and {:.3}° in the other.",
        other.input_deg, ways[0], ways[1]
    ));
    assert!((ways[0] - other.output_deg).abs() < 1e-3, "{ways:?}");
    let moved = [(290.0_f64, 60.0_f64), (287.422, 85.0)]
        .map(|(output, input)| Position::new(output.to_radians(), input.to_radians()));
    let place = Frame {
        length: frame,
        angle: 0.0,
    };
    let task = Task::new(place, &moved, Task::RATIOS).unwrap();
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        panic!("no family");
    };
    let again = family.with_output(24.4357 / frame).unwrap();
    let verdict = again.verdict.unwrap();
    assert_eq!(verdict.passage, Passage::Continuous);
    assert_eq!(verdict.grashof, Grashof::CrankRocker);
    let [l3, l1, ..] = again.proportions.lengths(frame);
    says(&format!("finds it again, l₁ = {l1:.3} and l₃ = {l3:.3},"));
}

/// Tasks 1 and 2: lengths for a coupler angle that was chosen, on the page and in the terminal.
#[test]
fn coupler_angle_chosen_and_lengths_tried() {
    let task = synthesis("printed").task;
    let frame = task.frame().length;
    let chosen = |angles: Angles| Angles {
        coupler: 20_f64.to_radians(),
        ..angles
    };
    let [first, second] = [0, 1].map(|k| chosen(angles("choose")[k]));
    assert!(
        [first, second]
            .iter()
            .all(|one| holds(one, 14) && holds(one, 25))
    );
    let to = [first, second].map(|angles| match truth(&angles) {
        Some(Truth::Between { from: 0.0, to }) => to.unwrap() * frame,
        other => panic!("{other:?}"),
    });
    says(&format!(
        "Both hold; l₁ < {:.3} and l₁ < {:.3}.",
        to[0], to[1]
    ));
    // P and Q by the four digits that the page's table gives.
    let by = first.subsystem(Unknown::Coupler).unwrap();
    let given = |value: f64| (1000.0 * value).round() / 1000.0;
    let l1 = 10.0;
    let [l2, l3] = [0, 1].map(|k| {
        let [p, q] = [given(by.constant[k]), given(-by.slope[k])];
        let length = frame * p - l1 * q;
        (
            given(length),
            format!("{frame}·{p} − {l1}·{q} = {length:.3}"),
        )
    });
    says(&format!("l₂ = {} and l₃ = {}.", l2.1, l3.1));
    let lengths = [l1, l2.0, l3.0];
    assert!(open(&first, lengths, frame) < 5e-3);
    let best = Solution::new(&task, relative(lengths, frame));
    says(&format!(
        "position 2 stays open by {:.3}, and by {:.3} at its best φ₁, which is the gap that the page gives.",
        open(&second, lengths, frame),
        best.closures[1].residual.abs() * frame
    ));
    assert_eq!(best.worst_residual(), best.closures[1].residual.abs());

    let gaps = |lengths: [f64; 3]| [0, 1].map(|k| open(&angles("printed")[k], lengths, frame));
    let [one, other] = gaps([10.0, 5.0, 4.0]);
    says(&format!("It prints {one:.3} and {other:.3}."));
    let least = [9.827, 6.409, 5.377];
    let [one, other] = gaps(least);
    says(&format!(
        "`--lengths 9.827,6.409,5.377` leaves {one:.3} and {other:.3}"
    ));
    let tried = Solution::new(&task, relative(least, frame))
        .verdict
        .unwrap();
    assert_eq!(tried.grashof, Grashof::CrankRocker);
    let exact = family("family").with_output(5.0 / frame).unwrap();
    let [l3, l1, ..] = exact.proportions.lengths(frame);
    says(&format!(
        "the exact linkage with l₁ = {l1:.3} and l₃ = {l3:.3}, a triple rocker"
    ));
    assert!(!exact.verdict.unwrap().turns);
}

/// Task 3: with e₁ nearest to e₀ theorem 5 is wrong, with e₁ between the others it claims nothing.
#[test]
fn counterexample_of_ones_own() {
    let of = |degrees: [f64; 3]| {
        let [coupler, output, input] = degrees.map(f64::to_radians);
        let angles = Angles {
            frame: 0.0,
            coupler,
            output,
            input,
        };
        let by = angles.subsystem(Unknown::Coupler).unwrap();
        let each = [0, 1].map(|k| alternative(by.constant[k], by.slope[k]));
        assert_eq!(truth(&angles), Some(Truth::None));
        (each, theorems(&angles).unwrap()[4].conditions)
    };
    let ([Alternative::First { below }, Alternative::Second { above }], true) =
        of([20.0, 40.0, 60.0])
    else {
        panic!("20, 40, 60");
    };
    says(&format!(
        "20°, 40°, 60°: z₂ > 0 needs z₁ < {below:.3}, and z₃ > 0 needs z₁ > {above:.3}."
    ));
    let (each, asked) = of([40.0, 20.0, 60.0]);
    assert_eq!((each[1], asked), (Alternative::Never, false));
    says("With 40°, 20°, 60° no z₁ makes z₃ positive");
}
