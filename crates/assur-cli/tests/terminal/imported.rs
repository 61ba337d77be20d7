//! URLs of PMKS+ and files of Linkage as NAME: the linkages imported from them, and notes on what was left out.

use std::path::PathBuf;

use super::run::{Scratch, assur, refused};

const LINK: &str = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.MA,A,0,0,0.GB,B,0,Im,0.GC,C,0,0r8,0.LP,P,0,0r8,OZ..\
    YRAB,Crank,VG,o,0,9O,c5cae9,A,B,,.YRBC,Connecting rod,ku,6G,0,0HC,303e9f,B,C,,.YPCP,CP,1Tm,0,0,0,,C,P,,..\
    2F1,BC,F1,0,0r8,0,0bW,1Xg0..N_J";

fn published(name: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../assur-import/tests/published");
    folder.join(name).to_str().unwrap().to_owned()
}

/// Runs the program, expects success, and returns standard output and standard error.
fn both(arguments: &[&str]) -> [String; 2] {
    let output = assur(arguments);
    assert!(output.status.success(), "{output:?}");
    [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap())
}

#[test]
fn a_link_is_a_name() {
    let [table, told] = both(&["sweep", LINK, "--step", "90"]);
    assert!(
        table.lines().any(|line| line.contains("Crank.angle")),
        "{table}"
    );
    assert_eq!(
        table.lines().filter(|line| !line.starts_with('#')).count(),
        1 + 5,
        "{table}"
    );
    let place = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.…: ";
    assert!(told.lines().all(|line| line.starts_with(place)), "{told}");
    assert_eq!(told.lines().count(), 3, "{told}");
    assert!(told.contains("Forces are left out: F1."), "{told}");
    let cut = &LINK[..LINK.len() - 9];
    let (status, said) = refused(&["sweep", cut]);
    assert_eq!(status, 2);
    assert!(
        said.contains("its check character does not match"),
        "{said}"
    );
    assert!(said.starts_with(&format!("assur: {place}")), "{said}");
    let (status, said) = refused(&["sweep", "https://example.org/?a=b"]);
    let neither =
        "assur: https://example.org/?a=b: This is neither a PMKS+ link nor a Linkage file.\n";
    assert_eq!((status, said.as_str()), (2, neither));
}

/// Messages about a URL, and a sheet without another title, show only the beginning of the URL.
#[test]
fn a_link_is_never_said_whole() {
    // Without its driver this linkage does not move; several commands say so.
    let still = LINK.replace("MA,A,0,0", "KA,A,0,0");
    let asked = [
        vec!["structure", &still],
        vec!["sweep", &still],
        vec!["assemblies", &still],
        vec!["circuits", &still],
        vec!["sweep", LINK, "--assembly", "77"],
        vec!["plot", LINK, "--svg", "-", "--assembly", "77"],
    ];
    for arguments in asked {
        let (_, said) = refused(&arguments);
        assert!(
            said.contains("assur") && !said.contains("CP,1Tm"),
            "{arguments:?}: {said}"
        );
    }
    // The linkage is counted all the same, and standard error lists what was left out.
    let [_, said] = both(&["mobility", &still]);
    assert!(!said.contains("CP,1Tm"), "{said}");
    let [sheet, _] = both(&["plot", LINK, "--svg", "-"]);
    let title = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.…</title>";
    assert!(
        sheet.contains(title) && !sheet.contains("CP,1Tm"),
        "{sheet}"
    );
}

#[test]
fn a_file_of_linkage_is_a_name() {
    let [structure, told] = both(&["structure", &published("linkage2/issue-12.linkage2")]);
    assert!(structure.contains("III"), "{structure}");
    assert_eq!(told.lines().count(), 1, "{told}");
    // A name in another code page does not make the file invalid.
    let mut bytes = b"<linkage2>\n<connector id=\"0\" name=\"\xc9\" x=\"0\" y=\"0\"/>".to_vec();
    let file = Scratch::with("latin.linkage2", "");
    std::fs::write(&file.0, &bytes).unwrap();
    let (status, said) = refused(&["structure", file.path()]);
    assert!(
        status == 2 && said.contains("Line 2: a tag does not end"),
        "{said}"
    );
    bytes.extend(b"<connector id=\"1\" x=\"1\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"1\"/>");
    bytes.extend(b"<Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link></linkage2>");
    std::fs::write(&file.0, &bytes).unwrap();
    let [structure, _] = both(&["structure", file.path()]);
    assert!(structure.contains("I("), "{structure}");
}
