//! Links of PMKS+ that form one body: welded parts, links held by the frame, and slides of both.

use assur::mechanism::Defect;
use assur::motion::Motion;
use assur_file::{LinkageDocument, LinkageProblem, Problem};
use assur_import::{Imported, LeftOut, read};

use super::published::keeps_its_lengths;
use assur_tests::damage::checked;

/// URL of a linkage with a third link at a joint where two parts of a link are welded together.
const WELD_THIRD: &str = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.6A,A,0,0,0.0B,B,0,Fe,0.0C,C,ku,NS,0.8D,D,_W,ku,0.\
    0E,E,1E8,_W,0.4F,F,_W,0,0.4G,G,1Tm,ku,0..YRAB,AB,Fe,Fe,0,0,c5cae9,A,B,,.YRBC,BC,Fe,Fe,0,0,c5cae9,B,C,,.\
    YRCDE,CDE,Fe,Fe,0,0,c5cae9,C,D,E,,CD,DE.YRDF,DF,Fe,Fe,0,0,c5cae9,D,F,,.NRCD,CD,Fe,Fe,0,0,c5cae9,C,D,,.\
    NRDE,DE,Fe,Fe,0,0,c5cae9,D,E,,...N_y";

/// URL of a linkage whose coupler slides through a block of a link that is welded to the ground.
const FIXED_GUIDE: &str = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.6A,A,0,0,0.0B,B,0,Fe,0.0C,C,ku,0,0.0E,E,1jO,0,0.\
    CG,G,1E8,VG,0.8M,M,1E8,0,0.1P,P,1E8,0,0,CE,C,E..YRAB,AB,Fe,Fe,0,0,c5cae9,A,B,,.YRBC,BC,Fe,Fe,0,0,c5cae9,B,C,,.\
    YRCE,CE,Fe,Fe,0,0,c5cae9,C,E,,.YRGM,GM,Fe,Fe,0,0,c5cae9,G,M,,.YPMP,MP,Fe,Fe,0,0,c5cae9,M,P,,...N_Q";

/// Flags of joints: prismatic, driven, on the ground, welded.
const PRISMATIC: u8 = 1;
const DRIVEN: u8 = 2;
const GROUND: u8 = 4;
const WELDED: u8 = 8;

/// Returns a number in base 64, as URLs of PMKS+ contain it.
fn coded(mut value: i64) -> String {
    let digits = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
    let sign = if value < 0 { "0" } else { "" };
    value = value.abs();
    let mut text = String::new();
    while text.is_empty() || value > 0 {
        text.insert(0, char::from(digits[(value % 64) as usize]));
        value /= 64;
    }
    format!("{sign}{text}")
}

/// Returns the URL of joints (flags, name, position in thousandths) and members (`YR`, `YP` or, for a part, `NR`; then
/// name, joints, parts).
fn link(joints: &[(u8, &str, [i64; 2])], members: &[(&str, &str, &str, &str)]) -> String {
    let joints = joints.iter().map(|(flags, name, [x, y])| {
        let [flags, x, y] = [i64::from(*flags), *x, *y].map(coded);
        format!("{flags}{name},{name},{x},{y},0.")
    });
    let members = members.iter().map(|(kind, name, joints, parts)| {
        let joints: Vec<String> = joints.chars().map(String::from).collect();
        format!(
            "{kind}{name},{name},Fe,Fe,0,0,c5cae9,{},,{parts}.",
            joints.join(",")
        )
    });
    let [joints, members]: [String; 2] = [joints.collect(), members.collect()];
    checked(&format!(
        "https://x/?2P.Fe.K,0.1011.{joints}.{members}..N_*"
    ))
}

/// Joints of the crank-rocker A–B–C–D with AB = 1, BC = 4, CD = 2.26, DA = 4, and of E beyond D.
fn four_bar(flags_of_d: u8) -> Vec<(u8, &'static str, [i64; 2])> {
    vec![
        (DRIVEN | GROUND, "A", [0, 0]),
        (0, "B", [0, 1000]),
        (0, "C", [3800, 2249]),
        (flags_of_d, "D", [4000, 0]),
        (0, "E", [5000, -500]),
    ]
}

fn links(document: &LinkageDocument) -> Vec<&str> {
    document
        .links
        .iter()
        .map(|link| link.name.as_str())
        .collect()
}

/// Returns the motion of a linkage, which must have one degree of freedom and a crank that turns fully.
fn turns(imported: &Imported) -> Motion {
    let motion = imported.document.motion().unwrap();
    assert_eq!(motion.mechanism().counts().mobility, 1);
    assert!(motion.cycle().is_full(), "{:?}", motion.cycle());
    keeps_its_lengths("made", &imported.document, &motion);
    motion
}

#[test]
fn a_third_link_at_welded_parts_is_hinged() {
    let imported = read(WELD_THIRD).unwrap();
    assert_eq!(links(&imported.document), ["AB", "BC", "CDE", "DF"]);
    assert_eq!(imported.document.links[2].points, ["C", "D", "E"]);
    let welded = LeftOut::Welded {
        link: "CDE".to_owned(),
        parts: ["CD", "DE"].map(str::to_owned).to_vec(),
    };
    assert!(
        imported.left_out.contains(&welded),
        "{:?}",
        imported.left_out
    );
    let problems = imported.document.motion().unwrap_err();
    let freedoms = problems.iter().find_map(|problem| match problem {
        Problem::Linkage(LinkageProblem::Defect(Defect::Underdriven { mobility, .. })) => {
            Some(*mobility)
        }
        _ => None,
    });
    assert_eq!(freedoms, Some(2), "{problems:?}");
    // If both links on the frame are driven, the linkage moves and keeps its lengths.
    let imported = read(&WELD_THIRD.replace(".4F,F", ".6F,F")).unwrap();
    let motion = imported.document.motion().unwrap();
    assert_eq!(motion.mechanism().counts().mobility, 2);
    assert_eq!(keeps_its_lengths("weld", &imported.document, &motion), 6);
}

/// Welded links without common parts become one link.
#[test]
fn links_that_are_welded_without_parts_are_one() {
    let members = [
        ("YR", "AB", "AB", ""),
        ("YR", "BC", "BC", ""),
        ("YR", "CD", "CD", ""),
        ("YR", "DE", "DE", ""),
    ];
    let imported = read(&link(&four_bar(WELDED | GROUND), &members)).unwrap();
    turns(&imported);
    assert_eq!(links(&imported.document), ["AB", "BC", "CD"]);
    assert_eq!(imported.document.links[2].points, ["D", "C", "E"]);
}

/// Parts welded at a joint on the ground turn about this joint together, as a bell crank.
#[test]
fn welded_parts_turn_about_a_joint_on_the_ground() {
    let members = [
        ("YR", "AB", "AB", ""),
        ("YR", "BC", "BC", ""),
        ("YR", "CDE", "CDE", "CD,DE"),
        ("NR", "CD", "CD", ""),
        ("NR", "DE", "DE", ""),
    ];
    let imported = read(&link(&four_bar(WELDED | GROUND), &members)).unwrap();
    turns(&imported);
    assert_eq!(links(&imported.document), ["AB", "BC", "CDE"]);
}

#[test]
fn a_link_slides_through_a_block_on_the_frame() {
    let imported = read(FIXED_GUIDE).unwrap();
    let document = &imported.document;
    assert_eq!(links(document), ["AB", "BC", "CE"]);
    let [slide] = &document.slides[..] else {
        panic!("{:?}", document.slides);
    };
    let on = [&slide.link, &slide.point, &slide.on];
    assert_eq!(on, ["frame", "M", "CE"]);
    assert_eq!(slide.line, ["C", "E"]);
    let motion = turns(&imported);
    // M is fixed. The line passes through M and keeps its direction, so C stays at y = 0.
    let mechanism = motion.mechanism();
    let place = |name: &str, input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        let at = mechanism.place(&pose, mechanism.point(name).unwrap());
        [at.x.value(), at.y.value()]
    };
    for k in 0..24 {
        let input = f64::from(k) * std::f64::consts::TAU / 24.0;
        let [[bx, by], [cx, cy]] = ["B", "C"].map(|name| place(name, input));
        assert!(cy.abs() < 1e-12, "{cy}");
        // AB = 1 and BC² = 3² + 1², as drawn.
        assert!(((cx - bx).powi(2) + (cy - by).powi(2) - 10.0).abs() < 1e-11);
        assert!(cx > bx, "{cx} {bx}");
    }
}

/// A body hinged to the frame at one point that also slides along the frame does not move.
#[test]
fn a_block_whose_pin_is_fixed_is_part_of_the_frame() {
    let mut joints = four_bar(GROUND);
    joints.push((PRISMATIC | GROUND, "P", [4000, 0]));
    let members = [
        ("YR", "AB", "AB", ""),
        ("YR", "BC", "BC", ""),
        ("YR", "CDE", "CDE", ""),
        ("YP", "DP", "DP", ""),
    ];
    let imported = read(&link(&joints, &members)).unwrap();
    turns(&imported);
    assert_eq!(links(&imported.document), ["AB", "BC", "CDE"]);
    assert_eq!(imported.document.slides, []);
}

/// A guide link between two anchors belongs to the frame with its line, even if the block on it is driven.
#[test]
fn a_block_slides_on_a_link_that_is_fixed() {
    let joints = |driven: [u8; 2]| {
        [
            (driven[0] | GROUND, "A", [0, 0]),
            (0, "B", [0, 1000]),
            (0, "C", [3000, 0]),
            (GROUND, "F", [1000, 0]),
            (GROUND, "G", [6000, 0]),
            (driven[1] | PRISMATIC, "P", [3000, 0]),
        ]
    };
    let members = [
        ("YR", "AB", "AB", ""),
        ("YR", "BC", "BC", ""),
        ("YR", "FG", "FG", ""),
        ("YP", "CP", "CP", ""),
    ];
    let slotted = |driven| {
        let link = link(&joints(driven), &members);
        checked(&link.replace("P,P,ku,0,0.", "P,P,ku,0,0,FG,F,G."))
    };
    let imported = read(&slotted([DRIVEN, 0])).unwrap();
    turns(&imported);
    assert_eq!(links(&imported.document), ["AB", "BC", "C"]);
    assert_eq!(imported.document.slides[0].on, "frame");
    assert_eq!(imported.document.slides[0].line, ["F", "G"]);
    let imported = read(&slotted([0, DRIVEN])).unwrap();
    let [driver] = &imported.document.drivers[..] else {
        panic!("{:?}", imported.document.drivers);
    };
    assert_eq!((driver.slide, driver.range), (Some(0), Some([0.0, 5.0])));
    let motion = imported.document.motion().unwrap();
    // C reaches distances from A between the difference of BC and AB and their sum: √10 − 1 and √10 + 1.
    let [[from, to]] = motion.cycle().arcs()[..] else {
        panic!("{:?}", motion.cycle());
    };
    let reach = 10_f64.sqrt();
    assert!(
        (from - (reach - 2.0)).abs() < 1e-9 && (to - reach).abs() < 1e-9,
        "{from} {to}"
    );
}
