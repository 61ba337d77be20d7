//! Faults that a problem names, extreme numbers, texts that need much memory.

use assur_import::LeftOut;

use super::*;

#[test]
fn what_is_wrong_is_told() {
    use ImportProblem as P;
    let link = "https://app.pmksplus.com/?2P.Fe.K,0.1011.MA,A,0,0,0.GB,B,Fe,0,0..YRAB,AB,Fe,Fe,0,0,c5cae9,A,B,,...N_";
    let checked = |text: &str| checked(&format!("{text}*"));
    assert!(read(&checked(link)).is_ok());
    let file = |inner: &str| format!("<linkage2>{inner}</linkage2>");
    let bar = r#"<Link id="0"><connector id="0"/><connector id="1"/></Link>"#;
    let ends = r#"<connector id="0" x="1" y="2"/><connector id="1" x="3" y="4"/>"#;
    assert!(read(&file(&format!("{ends}{bar}"))).is_ok());
    let part = |part: &str| P::LinkPart {
        part: part.to_owned(),
    };
    let number = |part: &str, value: &str| P::ImportNumber {
        part: part.to_owned(),
        value: value.to_owned(),
    };
    for (text, problem) in [
        (String::new(), P::NotImported),
        ("{\"format\": 2}".to_owned(), P::NotImported),
        ("https://example.org/?a=b".to_owned(), P::NotImported),
        ("<svg/>".to_owned(), P::NotImported),
        (
            format!("<linkage2>{}", " ".repeat(1 << 20)),
            P::ImportTooLarge { max: 1 << 20 },
        ),
        (format!("{link}*"), P::LinkCut),
        (link[..link.len() - 20].to_owned(), P::LinkCut),
        (
            checked(&link.replace("GB,B,Fe,0,0", "GB,B,F*,0,0")),
            part("F*"),
        ),
        (checked(&link.replace("A,B,,", "A,Z,,")), part("Z")),
        (
            checked(&link.replace("GB,B,", "GA,B,")),
            P::ImportTwice {
                part: "A".to_owned(),
            },
        ),
        (checked(&link.replace("YRAB", "NRAB")), P::NothingImported),
        (
            "https://x/?j=A,one,2,AB,R,t,0,0.1,t,&l=AB,1,1,0,0,A".to_owned(),
            number("A", "one"),
        ),
        (
            "https://x/?j=A,1e300,2,AB,R,t,0,0.1,t,&l=AB,1,1,0,0,A".to_owned(),
            number("A", "1e300"),
        ),
        (
            "https://x/?j=A,1,2&l=AB,1,1,0,0,A".to_owned(),
            part("A,1,2"),
        ),
        (
            "https://x/?j=A,1,NaN,AB,R,t,0,0.1,t,&l=AB,1,1,0,0,A".to_owned(),
            number("A", "NaN"),
        ),
        (
            "https://x/?j=A,1,-inf,AB,R,t,0,0.1,t,&l=AB,1,1,0,0,A".to_owned(),
            number("A", "-inf"),
        ),
        (
            format!("https://x/?j=A,1,2&l={}", "long".repeat(1000)),
            part("A,1,2"),
        ),
        (
            format!("https://x/?j={}&l=", "long".repeat(1000)),
            part(&format!("{}…", "long".repeat(10))),
        ),
        (
            file(&format!(
                "<Link id=\"0\">{}</Link>",
                "<connector id=\"0\"/>".repeat(1001)
            )),
            P::ImportTooMany { max: 1000 },
        ),
        (
            format!("j=A,1,2,,R,t,0,t&l=AB,1,1,0,0,{}", "A|".repeat(1000)),
            P::ImportTooMany { max: 1000 },
        ),
        (
            format!("j=A,1,2,,R,t,0,t&l=AB,1,1,0,0,A&f={}", "F\n".repeat(1000)),
            P::ImportTooMany { max: 1000 },
        ),
        ("https://x/?mech=".to_owned(), P::NothingImported),
        (
            "https://x/?mech=ground,a,R,0|".to_owned(),
            part("ground,a,R,0"),
        ),
        (
            "https://x/?mech=ground,a,R,0,0|sun%20planet%20G%205%200|".to_owned(),
            P::ImportGears {
                part: "sun planet G 5 0".to_owned(),
            },
        ),
        (
            "https://x/?mech=ground,a,b,P,0,0,45|".to_owned(),
            part("ground,a,b,P,0,0,45"),
        ),
        (
            "https://x/?mech=ground,a,R,0,0|a,R,1,infinity|".to_owned(),
            number("B", "infinity"),
        ),
        (
            "https://x/?mech=ground,a,R,0,0|a,R,1,-1e300|".to_owned(),
            number("B", "-1e300"),
        ),
        (
            "https://x/?set=squick&mech=ground,a,R,0,0|a,R,1,0|".to_owned(),
            number("set", "quick"),
        ),
        (
            format!("https://x/?mech={}", "a,R,0,0|".repeat(1001)),
            P::ImportTooMany { max: 1000 },
        ),
        (file(""), P::NothingImported),
        (file("<Link id=\"0\">"), P::MarkupBroken { line: 1 }),
        (
            file(&format!("{}{bar}", ends.replace("\"3\"", "\"east\""))),
            number("connector 1, x", "east"),
        ),
        (
            file(&format!("{}{bar}", ends.replace("\"3\"", "\"1e400\""))),
            number("connector 1, x", "1e400"),
        ),
        (
            file(&format!("{}{bar}", ends.replace("\"3\"", "\"nan\""))),
            number("connector 1, x", "nan"),
        ),
        (
            file(&format!("{}{bar}", ends.replace(" y=\"4\"", ""))),
            number("connector 1, y", ""),
        ),
        (
            file(&format!("{ends}{ends}{bar}")),
            P::ImportTwice {
                part: "connector 0".to_owned(),
            },
        ),
    ] {
        let shown: String = text.chars().take(120).collect();
        assert_eq!(read(&text).unwrap_err(), problem, "{shown}");
    }
    assert!(recognised(link) && recognised("<linkage2") && !recognised("2.5.1"));
    assert!(recognised("https://x/pmks.html?set=s50&mech=") && !recognised("https://x/?smech=a"));
    assert!(!recognised(
        r#"{"kind":"linkage","document":{"source":"x&mech=ground"}}"#
    ));
}

/// Other programs write numbers in forms that JSON does not allow.
#[test]
fn numbers_without_a_digit_before_or_after_the_point_are_read() {
    let link = "j=A,.5,5.,AB,R,t,0,0.1,t,%0AB,+3,-.5e1,AB,R,f,0,0.1,f,%0A&l=AB,1.,+1,0,0,A%7CB,,";
    let file = "<linkage2><connector id=\"0\" x=\".5\" y=\"+48.\"/><connector id=\"1\" x=\"+96\" y=\"-.96E2\"/>\
                <Link id=\"0\"><connector id=\"0\"/><connector id=\"+1\"/></Link></linkage2>";
    let first = "mech=ground,a,R,.5,5.,0,ffft|a,R,+3,-.5e1,+.0,ffff|";
    let mm = 25.4 / 96.0;
    for (text, places) in [
        (link, [[0.5, 5.0], [3.0, -5.0]]),
        (file, [[0.5 * mm, 48.0 * mm], [25.4, -25.4]]),
        (first, [[0.5, 5.0], [3.0, -5.0]]),
    ] {
        let document = read(text).unwrap().document;
        let found: Vec<[f64; 2]> = document.points.iter().map(|point| point.at).collect();
        assert_eq!(found, places, "{text}");
    }
}

/// A driver counts as at rest if it is so slow that the rates of the others would be infinite. A length whose half
/// rounds to zero yields no slot.
#[test]
fn extreme_numbers_stay_finite() {
    let anchors = "<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"1e-320\"/>\
        <connector id=\"1\" x=\"1\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"1e8\"/>";
    let ends = "<connector id=\"2\" x=\"0\" y=\"1\"/><connector id=\"3\" x=\"1\" y=\"1\"/>\
        <connector id=\"4\" x=\"0\" y=\"0\"/><connector id=\"5\" x=\"2e-323\" y=\"0\"/>";
    let pin = "<connector id=\"6\" x=\"1\" y=\"1\" slider=\"true\" slideradius=\"1e-323\">\
        <slidelimit id=\"4\"/><slidelimit id=\"5\"/></connector>";
    let link = |id: usize, ends: &[usize]| {
        let ends: String = ends
            .iter()
            .map(|id| format!("<connector id=\"{id}\"/>"))
            .collect();
        format!("<Link id=\"{id}\">{ends}</Link>")
    };
    let links = [
        link(0, &[0, 2]),
        link(1, &[1, 3]),
        link(2, &[2, 4, 5]),
        link(3, &[3, 6]),
    ]
    .concat();
    let text = format!("<linkage2>{anchors}{ends}{pin}{links}</linkage2>");
    let imported = read(&text).unwrap();
    assert_eq!(imported.document.drivers.len(), 2);
    sound(&imported);
}

/// Returns the bytes allocated while a text is read, per byte of the text: in total, and at most at one time.
fn room(text: &str, read: impl FnOnce(&str)) -> [u64; 2] {
    let room = measure(|| read(text));
    let length = text.len() as u64;
    [room.bytes_total / length, room.bytes_max / length]
}

/// Declarations of entities are refused. Deeply nested and long texts need memory in proportion to their length.
#[test]
fn what_would_swell_is_refused() {
    let bomb = "<linkage2><!DOCTYPE a [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]></linkage2>";
    assert_eq!(read(bomb), Err(ImportProblem::MarkupBroken { line: 1 }));
    let many: String = (0..15_000)
        .map(|id| format!("<connector id=\"{id}\" x=\"0\" y=\"0\"/>"))
        .collect();
    let many = format!(
        "<linkage2>{many}<Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link></linkage2>"
    );
    assert_eq!(read(&many), Err(ImportProblem::ImportTooMany { max: 1000 }));
    for text in [
        "<linkage2>".repeat(50_000),
        format!(
            "<linkage2>{}</linkage2>",
            "<connector id=\"1\" x=\"0\" y=\"0\"/>".repeat(20_000)
        ),
        format!("<linkage2{}", " a=\"b\"".repeat(100_000)),
        format!(
            "<linkage2><Link id=\"0\">{}</Link></linkage2>",
            "<connector id=\"1\"/>".repeat(20_000)
        ),
        format!(
            "j={}&l={}",
            "a,1,1,,R,t,0,t\n".repeat(900),
            "a,1,1,0,0,b|c|d|e\n".repeat(20_000)
        ),
        format!("mech={}", "ground,a,R,0,0,0,tttt|".repeat(20_000)),
        format!("mech={}R,0,0|", "a,".repeat(200_000)),
        format!("j=&l={}", "a,1,1,0,0,|||||||\n".repeat(30_000)),
        format!("2P.Fe.K,0.1011.{}", "MA,A,0,0,0.".repeat(60_000)),
        many,
    ] {
        let [allocated, at_once] = room(&text, |text| assert!(read(text).is_err()));
        let shown = &text[..20];
        assert!(
            allocated <= 64 && at_once <= 32,
            "{shown}: {allocated} {at_once}"
        );
    }
}

/// The first anchor is moved only by hand, so the speed of the second is lost and listed. An actuator with three joints
/// becomes rigid.
#[test]
fn a_lost_speed_and_a_rigid_actuator_are_listed() {
    let anchors = "<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"15\" alwaysmanual=\"true\"/>\
        <connector id=\"1\" x=\"6\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"15\"/>";
    let free = "<connector id=\"2\" x=\"1\" y=\"2\"/><connector id=\"3\" x=\"5\" y=\"2\"/><connector id=\"4\" x=\"3\" y=\"4\"/>";
    let links = "<Link id=\"5\"><connector id=\"0\"/><connector id=\"2\"/></Link>\
        <Link id=\"6\"><connector id=\"1\"/><connector id=\"3\"/></Link>\
        <Link id=\"7\"><connector id=\"2\"/><connector id=\"4\"/></Link>";
    let actuator = "<Link id=\"8\" actuator=\"true\" throw=\"1\" cpm=\"5\"><connector id=\"3\"/><connector id=\"4\"/>\
        <connector id=\"2\"/></Link>";
    let text = format!("<linkage2>{anchors}{free}{links}{actuator}</linkage2>");
    let left_out = read(&text).unwrap().left_out;
    let by_hand = |one: &LeftOut| matches!(one, LeftOut::ByHand { .. });
    let speed = |one: &LeftOut| matches!(one, LeftOut::Speed { rpm, .. } if *rpm == 15.0);
    let actuator = |one: &LeftOut| matches!(one, LeftOut::Actuator { .. });
    for listed in [&by_hand as &dyn Fn(&LeftOut) -> bool, &speed, &actuator] {
        assert_eq!(
            left_out.iter().filter(|one| listed(one)).count(),
            1,
            "{left_out:?}"
        );
    }
}
