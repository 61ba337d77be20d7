//! Damaged addresses and files on the page: each is a sentence, nothing of it becomes an element or runs, and what
//! is on the screen stays. `www/app/damage.test.js` has hundreds of them, with what each sentence says.

use serde_json::{Value, json};

use crate::browser::Page;
use crate::host::home;

/// What is on the screen. The damaged ones come of another state, so that none taken
/// for sound goes unseen.
const SHOWN: &str = "1&lesson=mixer&d.l1=0.37&d.l2=0.85&d.l3=0.55&d.l4=0.85&d.z4=36&d.z5=18&d.mesh=external&d.module=0.0165&d.centre_line_deg=-40&d.assembly=1&v.phi_deg=75&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";

/// Pixels by which two pictures of the same may differ: edges are smoothed from what
/// was drawn before.
const ALIKE: usize = 20;

/// Gives inputs to the page one after the other, as addresses or as files, and returns the outcome of each.
const GIVE: &str = include_str!("damage.js");

/// A state of other dimensions, as an address with one part of it in the place of another.
fn address(from: &str, to: &str) -> String {
    let good = SHOWN.replace("d.l3=0.55", "d.l3=1").replace("75", "100.5");
    assert!(good.contains(from), "{from}");
    good.replacen(from, to, 1)
}

fn addresses() -> Vec<String> {
    let mut all: Vec<String> = [
        (
            "d.l1=0.37",
            "d.l1=%3Cimg%20src=x%20onerror=%22window.hurt=1%22%3E",
        ),
        ("d.mesh=external", "d.mesh=<script>window.hurt=1</script>"),
        ("d.l1=0.37", "d.l1=1e300"),
        ("d.l1=0.37", "d.__proto__={\"hurt\":1}"),
        ("d.l1=0.37", "d.l1=%E0%A4%A"),
        ("d.l4=0.85", "d.l4=9"),
        ("d.z4=36", "d.z4=[[[{}]]]"),
        (
            "v.speed=1",
            "v.speed={\"constructor\":{\"prototype\":{\"hurt\":1}}}",
        ),
        ("1&", "7&"),
        ("1&", "<b>&"),
        (
            "lesson=mixer",
            "lesson=\"><img src=x onerror=window.hurt=1>",
        ),
        ("&v.lang=en", "&v.lang={}"),
    ]
    .map(|(from, to)| address(from, to))
    .into();
    all.push(address("&d.z4", "")[..90].to_owned());
    all.push(format!("{SHOWN}&d.l1={}", "9".repeat(110_000)));
    all.push(format!(
        "{SHOWN}&d.x={}{}",
        "[".repeat(20_000),
        "]".repeat(20_000)
    ));
    all.extend(["__proto__", "janssen", "jansen&d.title=Leg"].map(String::from));
    all
}

/// The same for a file, whose state is that of the page but for a length.
fn files() -> Vec<String> {
    let good = json!({
        "format": 1, "lesson": "mixer",
        "document": {
            "l1": 0.37, "l2": 0.85, "l3": 1.0, "l4": 0.85, "z4": 36, "z5": 18, "centre_line_deg": -40,
            "mesh": "external", "module": 0.0165, "assembly": 1,
        },
        "view": { "phi_deg": 75, "playing": false, "direction": 1, "speed": 1, "traces": true, "lang": "en" },
    })
    .to_string();
    let mut all: Vec<String> = [
        ("0.37", "\"<img src=x onerror='window.hurt=1'>\""),
        ("0.37", "-1"),
        ("\"l1\":0.37", "\"l1\":0.37,\"l1\":0.38"),
        ("\"l1\"", "\"__proto__\""),
        ("\"mixer\"", "{\"toString\":1,\"valueOf\":1}"),
        ("36", "{\"length\":1e9}"),
        ("\"external\"", "\"javascript:window.hurt=1\""),
        ("\"format\":1", "\"format\":9"),
    ]
    .map(|(from, to)| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, to, 1)
    })
    .into();
    all.extend([
        good[..good.len() / 2].to_owned(),
        "[".repeat(90_000),
        String::from("null"),
    ]);
    all
}

/// Every one is refused by a sentence with the name of what it is.
async fn refuses(page: &Page, kind: &str, inputs: &[String], name: &str) {
    let before = [
        page.picture("mechanism").await,
        page.picture("charts").await,
    ];
    let arguments = vec![json!(kind), json!(inputs)];
    let answers = page.ask_later(GIVE, arguments).await;
    let answers: &Vec<Value> = answers.as_array().unwrap_or_else(|| panic!("{answers}"));
    assert_eq!(answers.len(), inputs.len());
    for (input, answer) in inputs.iter().zip(answers) {
        let brief: String = input.chars().take(600).collect();
        let said = answer["said"].as_str().unwrap();
        let brief = format!("{brief}\n{said}");
        assert!(answer["hurt"].is_null(), "a script ran: {brief}");
        assert_eq!(answer["clean"], true, "a prototype was changed: {brief}");
        assert_eq!(answer["injected"], 0, "elements came in: {brief}");
        assert_eq!(answer["same"], true, "it is no state: {brief}");
        assert!(said.len() > 30 && !said.contains("{}"), "{brief}");
        assert!(said.contains(name), "{brief}");
    }
    page.settle().await;
    let now = [
        page.picture("mechanism").await,
        page.picture("charts").await,
    ];
    let off = [0, 1].map(|i| now[i].difference(&before[i]));
    assert!(off.iter().all(|off| *off < ALIKE), "{off:?}");
}

#[tokio::test]
async fn damaged_addresses_are_sentences() {
    let home = home();
    let page = Page::open_at(&format!("{home}#{SHOWN}"), "en-US").await;
    refuses(&page, "address", &addresses(), "The link").await;
    page.close().await;

    // A page that opens with one shows what it would without.
    let page = Page::open_at(&format!("{home}#{}", addresses()[0]), "en-US").await;
    let said = page.text("notice-text").await;
    assert!(
        said.starts_with("The link") && said.contains("document.l1"),
        "{said}"
    );
    assert_eq!(page.count("#notice img").await, 0);
    assert!(page.ask("return window.hurt ?? null").await.is_null());
    assert!(page.value("out-rocker.angle").await.is_finite());
    page.close().await;
}

#[tokio::test]
async fn damaged_files_are_sentences() {
    let page = Page::open_at(&format!("{}#{SHOWN}", home()), "en-US").await;
    let name = "<img src=x onerror=window.hurt=1>.json";
    refuses(&page, "file", &files(), name).await;
    page.close().await;
}
