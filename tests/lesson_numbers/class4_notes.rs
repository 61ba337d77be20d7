//! The numbers in the notes for teachers on the Class IV mechanism with dwell, all computed by the engine.

use std::f64::consts::TAU;

use assur::mechanism::{Method, Pose, Quantity};
use assur::motion::{Extremum, Features, InputRate, Motion, OutputProfile, Phase, PhaseKind};
use assur::{CombinedMethod, Relation};
use nalgebra::SMatrix;
use serde_json::{Value, json};

use super::{
    LANGUAGES, LESSON, document, drawn_fk, dwell, length_deg, lengthened, numbers, stroke,
};

fn drawn() -> Motion {
    document().motion().unwrap()
}

fn output(motion: &Motion) -> Quantity {
    Quantity::named(motion.mechanism(), "CD.angle").unwrap()
}

/// FK of this length.
fn with_fk(length: f64) -> Motion {
    lengthened(length - drawn_fk())
}

fn relations(motion: &Motion, crank_deg: f64) -> Vec<Relation> {
    let mechanism = motion.mechanism();
    let pose: Pose<3> = motion.pose(crank_deg.to_radians()).unwrap();
    let method = CombinedMethod::of(mechanism).unwrap();
    method.relations(mechanism, &pose)
}

fn relation<'a>(all: &'a [Relation], item: &str, name: &str) -> &'a Relation {
    let mut found = all.iter();
    let found = found.find(|one| one.item == format!("003.{item}") && one.name == name);
    found.unwrap_or_else(|| panic!("{item} {name}"))
}

/// A square is never negative, d₁₅ as printed is.
#[test]
fn a_square_as_printed_is_negative() {
    let all = relations(&drawn(), 290.0);
    let printed = relation(&all, "d15", "d_15").printed.unwrap();
    assert!(printed < 0.0);
    for lang in LANGUAGES {
        LESSON.tells(lang, "squares.text", &[290.0, -printed, 180.0]);
    }
}

/// As the notes write a number.
fn written(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}").replace('-', "−")
}

/// The links, the letters of the triangles, and the class by the driver.
fn structure() -> Vec<String> {
    let motion = drawn();
    let mechanism = motion.mechanism();
    let [group] = mechanism.structure().groups().collect::<Vec<_>>()[..] else {
        panic!("one group");
    };
    let (links, pairs) = (
        mechanism.links().len(),
        group.inner.len() + group.outer.len(),
    );
    let steps = LESSON.file("lesson.js").matches("\n    id: \"").count();
    let mut said = vec![
        format!("has {steps} steps"),
        format!(
            "W = 3·{links} − 2·{} = {}",
            pairs + 1,
            3 * links - 2 * (pairs + 1)
        ),
        format!(
            "3·{0} − 2·{pairs} = {1}",
            links - 1,
            3 * (links - 1) - 2 * pairs
        ),
        format!("one Assur group, {}.", mechanism.formula()),
        format!("{} outer pairs", group.order()),
    ];

    let all = relations(&motion, 0.0);
    let number = |item: &str, name: &str| relation(&all, item, name).value;
    for [triangle, one, first, other, second, corner, item, ratio] in [
        ["HGL", "g", "HG", "t", "HL", "η_H", "(3)", "f_L"],
        ["EGF", "e", "GE", "f", "GF", "η_G", "(4)", "f_F"],
        ["CLK", "r", "CL", "p", "CK", "η_C", "(5)", "f_K"],
    ] {
        let part = |axis: &str| written(number(item, &format!("{ratio}{axis}")), 3);
        said.push(format!(
            "| {triangle} | {one} = {first} = {:.3} | {other} = {second} = {:.3} | {corner} = {}° | {ratio} = ({}, {}) |",
            number("letters", one),
            number("letters", other),
            written(number("letters", corner).to_degrees(), 3),
            part("x"),
            part("y"),
        ));
    }
    said.push(format!("c = CD = {:.3}", number("letters", "c")));
    let crank = number("B", "y′_B").hypot(number("B", "x′_B"));
    said.push(format!("the crank, of length {crank:.0}"));

    assert_eq!(mechanism.drivable(), ["AB", "HGL", "CD"]);
    for (link, place) in [("HGL", "HGL can turn by"), ("CD", "CD by")] {
        let mut document = document();
        document.drivers = serde_json::from_value(json!([{ "crank": link }])).unwrap();
        let motion = document.motion().unwrap();
        let mechanism = motion.mechanism();
        assert_eq!(mechanism.structure().class(), 2);
        assert_eq!(motion.dead_points().len(), 2);
        let [[from, to]] = motion.cycle().arcs()[..] else {
            panic!("one arc");
        };
        said.push(format!("{link}: {}.", mechanism.formula()));
        said.push(format!("{place} {:.3}°", (to - from).to_degrees()));
    }
    said
}

/// The least and the greatest extremum.
fn ends(of: &Features) -> [Extremum; 2] {
    let by_value = |a: &&Extremum, b: &&Extremum| a.value.total_cmp(&b.value);
    let (least, most) = (
        of.extrema.iter().min_by(by_value),
        of.extrema.iter().max_by(by_value),
    );
    [*least.unwrap(), *most.unwrap()]
}

/// Swing, analogues, cyclogram and the dwell by its tolerance; the task of one turn a second.
fn the_dwell() -> Vec<String> {
    let motion = drawn();
    let output = output(&motion);
    let [psi, first, second]: [Features; 3] = {
        let mut found = motion.features(&[output], InputRate::ANALOGUES).unwrap();
        found.remove(0)
    };
    let [low, high @ ..] = &psi.extrema[..] else {
        panic!("extrema of ψ");
    };
    let [begin, end] = [high[0], high[4]];
    assert_eq!(high.len(), 5);
    assert!(high.iter().all(|one| one.value < begin.value + 1e-12));
    let least = high
        .iter()
        .map(|one| one.value)
        .fold(f64::INFINITY, f64::min);
    let between = |of: &Features| {
        let [one, other] = ends(of).map(|one| {
            format!(
                "{} (at {:.1}°)",
                written(one.value, 3),
                one.input.to_degrees()
            )
        });
        format!("between {one} and {other}")
    };
    let swing = stroke(&motion).to_degrees();
    let mut said = vec![
        format!(
            "ψ swings by {swing:.3}°, from {:.3}° at φ₁ = {:.3}° to {:.3}° at φ₁ = {:.3}°. From there to φ₁ = {:.3}°",
            low.value.to_degrees(),
            low.input.to_degrees(),
            begin.value.to_degrees(),
            begin.input.to_degrees(),
            end.input.to_degrees(),
        ),
        format!(
            "which differ by {:.4}° only",
            (begin.value - least).to_degrees()
        ),
        format!("ψ′ lies {}, ψ″ {}.", between(&first), between(&second)),
    ];

    let profile = OutputProfile::new(&motion, output).unwrap();
    let phases = profile.cyclogram(0.1_f64.to_radians());
    let size = |phase: &Phase| (phase.arc[1] - phase.arc[0]).to_degrees();
    let of = |kind: PhaseKind| {
        phases
            .iter()
            .filter(move |phase| phase.kind == kind)
            .map(size)
    };
    said.push(format!(
        "Within 0.1° the cyclogram has a rise of {:.3}°, the long dwell, a return of {:.3}° and a short dwell of {:.3}°",
        of(PhaseKind::Rise).sum::<f64>(),
        of(PhaseKind::Return).sum::<f64>(),
        of(PhaseKind::Dwell).fold(f64::INFINITY, f64::min),
    ));
    for tolerance in [0.001, 0.01, 0.1, 1.0] {
        let found = dwell(&motion, tolerance);
        let [from, to] = found.arc.map(f64::to_degrees);
        let length = found.length().to_degrees();
        said.push(format!(
            "| {tolerance}° | {length:.3}° | {from:.3}° | {to:.3}° |"
        ));
    }
    let [wide, narrow] = [0.1, 0.01].map(|tolerance| length_deg(&motion, tolerance));
    said.push(format!("takes {:.0}° off the long dwell", wide - narrow));

    let [fastest, hardest] = [&first, &second].map(|of| ends(of).map(|one| one.value.abs()));
    let [fastest, hardest] = [fastest, hardest].map(|[a, b]| a.max(b));
    let within = |one: &&Extremum| (begin.input..end.input).contains(&one.input);
    let left = first.extrema.iter().filter(within);
    let left = left.fold(0.0, |most: f64, one| most.max(one.value.abs()));
    said.extend([
        "stand within 0.1°".to_owned(),
        format!("ω₁ = 2π = {TAU:.3} rad/s"),
        format!("stands for {wide:.3}/360 = {:.3} s", wide / 360.0),
        format!("is {fastest:.4}·ω₁ = {:.3} rad/s", fastest * TAU),
        format!(
            "acceleration {hardest:.4}·ω₁² = {:.2} rad/s²",
            hardest * TAU * TAU
        ),
        format!("at most {left:.6}: {:.5} rad/s", left * TAU),
    ]);
    said
}

/// The table of FK, the dwell to order, and how exact the lengths must be.
fn the_regulator() -> Vec<String> {
    let row = |motion: &Motion| {
        let [wide, narrow] = [0.1, 0.01].map(|tolerance| length_deg(motion, tolerance));
        [wide, narrow, stroke(motion).to_degrees()]
    };
    let rows = |name: String, motion: &Motion| {
        let [wide, narrow, swing] = row(motion);
        format!("| {name} | {wide:.3}° | {narrow:.3}° | {swing:.3}° |")
    };
    let lengths = [4.002, 4.062, 4.112, 4.212, 4.312];
    let table = lengths.map(|length| rows(length.to_string(), &with_fk(length)));
    let mut said = Vec::from(table);
    said.push("| FK | dwell within 0.1° | dwell within 0.01° | swing |".to_owned());
    said.push(rows(format!("{:.3} (as drawn)", drawn_fk()), &drawn()));

    let wanted = 120.0;
    let of = |length: f64| length_deg(&with_fk(length), 0.1);
    assert!(of(4.115_75) > wanted && of(4.115_85) < wanted);
    let [_, narrow, swing] = row(&with_fk(4.116));
    said.extend([
        format!("third of the turn, {wanted}°, within 0.1°. Which FK does it? How long is that dwell within 0.01°?"),
        format!(
            "FK = 4.115 gives {:.3}° and 4.116 gives {:.3}°; exactly it is 4.1158. With 4.116 the dwell within 0.01° is {narrow:.3}°, and the swing is {swing:.3}°",
            of(4.115),
            of(4.116),
        ),
    ]);

    let [wide, narrow, _] = row(&drawn());
    let [less_wide, less_narrow, _] = row(&lengthened(0.001));
    said.push(format!(
        "FK longer by 0.001 takes {:.2}° off the dwell within 0.1°, and {:.2}° off that within 0.01°",
        wide - less_wide,
        narrow - less_narrow,
    ));
    assert!(with_fk(4.002).cycle().is_full());
    let short = with_fk(3.992);
    assert!(!short.cycle().is_full() && !short.dead_points().is_empty());
    said.push("with FK = 3.992 the crank no longer turns fully".to_owned());

    let motion = drawn();
    let cranks = [0.0_f64, 90.0, 275.0];
    let [a, b, c] = cranks.map(|crank| {
        let found = motion
            .mechanism()
            .assemblies_at(crank.to_radians(), Method::Usual);
        assert!(found.whole && found.complex == [14]);
        found.poses.len()
    });
    said.push(format!(
        "at φ₁ = 0°, 90° and 275° there are {a}, {b} and {c} (14 in complex numbers)"
    ));
    said
}

/// The determinant of the six equations for E, G and C.
fn determinant(all: &[Relation]) -> f64 {
    const ROWS: [&str; 6] = ["EB", "EG", "GH", "FK", "LC", "CD"];
    const COLUMNS: [&str; 6] = ["x_E", "y_E", "x_G", "y_G", "x_C", "y_C"];
    let at = |row: usize, column: usize| relation(all, ROWS[row], COLUMNS[column]).value;
    SMatrix::<f64, 6, 6>::from_fn(at).determinant()
}

/// What the chain divides by, and the task that follows it by hand.
fn the_chain() -> Vec<String> {
    let motion = drawn();
    let divisors = ["x_EB", "x_CD", "Δ", "Λ", "1 − |f_L|²"];
    let mut least = [f64::INFINITY; 5];
    for crank in 0..720 {
        let all = relations(&motion, 0.5 * f64::from(crank));
        for name in ["ψ′", "ψ″"] {
            let one = relation(&all, "chain", name);
            let off = (one.value - one.printed.unwrap()).abs();
            assert!(off < 1e-12 * (1.0 + one.value.abs()), "{one:?}");
        }
        let now = divisors.map(|name| relation(&all, "chain", name).value);
        for (least, now) in least.iter_mut().zip(now) {
            *least = least.min(now.abs());
        }
        let [eb, cd, delta, lambda, apart] = now;
        let of_g = relation(&all, "det1", "det(x′_G, y′_G)").value;
        let product = (eb * delta * cd * lambda * of_g / apart).abs();
        assert!((determinant(&all).abs() / product - 1.0).abs() < 1e-9);
    }
    let all = relations(&motion, 60.0);
    let number = |item: &str, name: &str, decimals: usize| {
        written(relation(&all, item, name).value, decimals)
    };
    let items: Vec<Value> = serde_json::from_str(&LESSON.file("paper.json")).unwrap();
    let misprinted = items.iter().filter(|item| item["verdict"] == "misprint");
    // VI in place of IV is no formula.
    let formulas = misprinted
        .filter(|item| item["item"] != "003.classVI")
        .count();
    let [eb, cd, delta, lambda, _] = least;
    let mut said = vec![
        format!("{formulas} of its formulas are misprinted"),
        "to 10⁻¹²".to_owned(),
        "then b₂ = b₃ = 0, and Cramer's rule is 0/0 in every position".to_owned(),
        format!(
            "|x_EB| = {eb:.2}, |x_CD| = {cd:.2}, |Δ| = {delta:.2} and |Λ| = {lambda:.2}, and 1 − |f_L|² = {}",
            number("chain", "1 − |f_L|²", 3)
        ),
    ];
    // CD stands upright in a drawing that is turned so.
    let upright = 130.0_f64;
    let phases = OutputProfile::new(&motion, output(&motion)).unwrap();
    let [[_, one], [_, other]] = phases.strokes()[0];
    assert!((one..other).contains(&upright.to_radians()));
    said.push(format!(
        "by {}° clockwise, and x_CD = 0 where ψ was {upright}°",
        upright - 90.0
    ));

    let b = |name: &str| number(&format!("b{name}"), &format!("b_{name}"), 3);
    let [b1, b2, b3, b4, b5] = ["1", "2", "3", "4", "5"].map(b);
    let det = |name: &str| number("det1", name, 3);
    let [both, x, y] = ["det(x′_G, y′_G)", "det(x′_G)", "det(y′_G)"].map(det);
    let printed = |name: &str| written(relation(&all, "cramer1", name).printed.unwrap(), 3);
    said.extend([
        "Set φ₁ = 60°".to_owned(),
        format!("b₁ = {b1}, b₂ = {b2}, b₃ = {b3}, b₄ = {b4}, b₅ = {b5}."),
        format!(
            "x′_G = b₂b₅/(b₁b₂ − b₃b₄) = {x}/{both} = {}",
            number("cramer1", "x′_G", 3)
        ),
        format!(
            "y′_G = −b₃b₅/(b₁b₂ − b₃b₄) = {y}/{both} = {}",
            number("cramer1", "y′_G", 3)
        ),
        format!(
            "c₁₉ = {}, c₂₀ = {}, c₂₁ = {} one has y′_C = {} and x′_C = {}. So ψ′ = {}",
            number("c19", "c_19", 3),
            number("c20", "c_20", 3),
            number("c21", "c_21", 3),
            number("vC", "y′_C", 3),
            number("vC", "x′_C", 3),
            number("psi1", "ψ′", 3),
        ),
        format!(
            "the quotients are {} and {}.",
            printed("x′_G"),
            printed("y′_G")
        ),
    ]);
    said
}

/// The English notes say all of this, and no number besides: only the paper's equations and fig. 1, the tasks and the formulas
/// have numbers of their own.
#[test]
fn the_notes_for_teachers_have_the_numbers_of_the_engine() {
    let notes = LESSON.file("notes.en.md");
    let told = notes.lines().filter(|line| !line.starts_with('>'));
    let told = told.flat_map(str::split_whitespace).collect::<Vec<_>>();
    let notes = told.join(" ");
    let mut said = [structure(), the_dwell(), the_regulator(), the_chain()].concat();
    let missing: Vec<&String> = said.iter().filter(|one| !notes.contains(*one)).collect();
    assert!(missing.is_empty(), "{missing:#?}");

    said.extend((1..=6).map(|equation| format!("({equation})")));
    said.extend((1..=4).map(|task| format!("**{task}. ")));
    said.extend(["fig. 1", "1 − |f_L|²", "Φ(q, φ₁) = 0"].map(str::to_owned));
    let mut open: Vec<bool> = vec![true; notes.len()];
    for one in &said {
        for (at, _) in notes.match_indices(one) {
            open[at..at + one.len()].fill(false);
        }
    }
    let rest = notes.char_indices();
    let rest: String = rest.map(|(at, c)| if open[at] { c } else { ' ' }).collect();
    assert_eq!(numbers(&rest, "en"), [], "{rest}");
}
