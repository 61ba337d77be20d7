//! The lesson on the differential with magnetic couplings: what its steps show, ask and lend, answered by
//! what the engine says.

use std::f64::consts::TAU;

use assur::dynamics::{Body, Mesh, Recording};
use assur::gears::train::{Member, Shafts};
use assur_file::{GearTrain, GearTrainDocument};
use assur_tests::files::{preset, source};
use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::device::languages;
use crate::host::home;
use crate::layout::defects;

/// How many steps the lesson has.
const STEPS: usize = 11;

/// A document of the lesson.
fn document(name: &str) -> GearTrainDocument {
    serde_json::from_value(preset("differential", name).unwrap()).unwrap()
}

fn train(name: &str) -> GearTrain {
    document(name).train().unwrap()
}

fn speeds(name: &str) -> Shafts {
    train(name).turning.last_speeds()
}

fn ratio(name: &str) -> f64 {
    let ratios = train("driven").layout.train().differential().ratios();
    let found = ratios.iter().find(|ratio| ratio.to_string() == name);
    found.unwrap().value()
}

async fn lesson(page: &Page) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-differential").await == 1
    })
    .await;
    page.click("gallery-lesson-differential").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    page.settle().await;
}

/// What each step asks, answered wrongly and as the engine has it.
fn answers() -> [(&'static str, String); STEPS] {
    let number = |value: f64| format!("{value:.4}");
    let counts = train("one_satellite").layout.counts();
    let satellite = train("mixer").turning.at(1.0).speeds[Body::Satellite.index()] * 60.0 / TAU;
    let limit = train("overloaded").differential.unwrap();
    let mend = train("not_to_be_built");
    let mended = mend.layout.suggestions(mend.coupling, 1)[0].train;
    let [sun, ring] = [Member::Sun, Member::Ring].map(|member| mended.teeth(member));
    [
        ("0", counts.mobility().to_string()),
        ("45", number(speeds("driven").carrier)),
        ("0.4651", number(ratio("4/1(3)"))),
        ("rises", "same".to_owned()),
        ("2.15", number(ratio("1/4(3)"))),
        ("31", "13".to_owned()),
        // What cannot be built has no right answer, whatever its numbers are.
        (
            "14.1667",
            ((sun + ring) / mend.layout.counts().satellites).to_string(),
        ),
        ("48", document("wide_gap").z4.to_string()),
        ("6", number(limit.static_limit(Body::Carrier))),
        ("field", "drive".to_owned()),
        ("62.8571", number(satellite)),
    ]
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// Answers, and sees what is said of it.
async fn answer(page: &Page, answer: &str, verdict: &str) {
    let choices = "#lesson input[type=radio][name=lesson-choice]";
    if page.count(choices).await > 0 {
        page.click(&format!("lesson-{answer}")).await;
    } else {
        page.write("lesson-answer", answer).await;
    }
    page.press("lesson-check", Key::Enter).await;
    let said = page.attribute("lesson-said", "data-verdict").await;
    let text = page.text("lesson-said").await;
    assert_eq!(said.as_deref(), Some(verdict), "{answer}: {text}");
    assert!(text.len() > 10 && !text.contains(['{', '}']), "{text}");
}

/// From the gallery through all steps: each shows without a problem, and its answer is that of the engine.
#[tokio::test]
async fn its_lesson_is_answered() {
    let page = Page::open().await;
    lesson(&page).await;
    for (index, (wrong, right)) in answers().iter().enumerate() {
        let step = index + 1;
        // A step may have several things to show: the question is about the first.
        for show in shows(&page).await.iter().rev() {
            page.click(show).await;
            page.settle().await;
            assert_eq!(page.text("problem").await, "", "step {step}: {show}");
        }
        answer(&page, wrong, "not_yet").await;
        if step == 7 {
            answer(&page, right, "not_yet").await;
            page.ask("document.querySelector('#train-suggestions button').click()")
                .await;
            page.settle().await;
        }
        answer(&page, right, "right").await;
        if step < STEPS {
            page.click("lesson-on").await;
        }
    }
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains("11 right answers"), "{progress}");
    page.close().await;
}

/// What a step asks for stands in it; what the paper has wrong is listed at the end.
#[tokio::test]
async fn steps_have_their_tools_and_the_misprints() {
    let page = Page::open().await;
    lesson(&page).await;
    let tools = [
        "",
        "#train-free",
        "#train-free",
        "#field-z2",
        "#observer-carrier",
        "#train-ratios",
        "#train-conditions",
        "#field-z2",
        "#train-limit",
        "#train-energies",
        "#field-members\\.carrier",
    ];
    for (step, tool) in (1..).zip(tools) {
        page.click(&shows(&page).await[0]).await;
        page.settle().await;
        if !tool.is_empty() {
            let there = page.count(&format!("#lesson {tool}")).await;
            assert_eq!(there, 1, "{step}: {tool}");
        }
        assert_eq!(page.count("#lesson-errata").await, 0, "{step}");
        page.click("lesson-on").await;
    }
    page.click("lesson-errata-name").await;
    let wrong = "return [...document.querySelectorAll('#lesson-errata [data-item]')]
        .filter((one) => one.checkVisibility() && one.querySelector('.paper-verdict').textContent !== '').length;";
    let items = source("www/lessons/differential/paper.json");
    let items: Vec<Value> = serde_json::from_str(&items).unwrap();
    let expected = items.iter().filter(|one| {
        one["step"] != "end" && (one["verdict"] == "misprint" || one["verdict"] == "false")
    });
    assert_eq!(page.ask(wrong).await, expected.count());
    page.close().await;
}

/// The carrier's speed is not told while it is asked for, neither by the status line nor by the table of values.
#[tokio::test]
async fn the_answer_is_withheld() {
    let page = Page::open().await;
    lesson(&page).await;
    page.click("lesson-on").await;
    page.click("lesson-show-driven").await;
    page.settle().await;
    for id in ["out-train-carrier", "out-carrier.angle′"] {
        assert!(page.text(id).await.starts_with('?'), "{id}");
    }
    assert!(!page.text("train-follows").await.contains("39"));
    page.click("lesson-reveal").await;
    page.settle().await;
    let told = page.text("out-train-carrier").await;
    let carrier: f64 = told.parse().unwrap();
    assert!((carrier - speeds("driven").carrier).abs() < 5e-4, "{told}");
    page.close().await;
}

/// On the carrier Willis' inversion is seen: it stands still, and sun and ring turn as ordinary wheels do.
#[tokio::test]
async fn the_observer_on_the_carrier_sees_it_at_rest() {
    let page = Page::open().await;
    lesson(&page).await;
    for _ in 1..5 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show-carrier").await;
    // At once: in motion the table may be built anew between finding and reading a value.
    let speed = "return document.getElementById('out-carrier.angle′')?.dataset.value ?? null;";
    page.until("the carrier at rest", async || {
        let speed = page.ask(speed).await;
        speed.as_str().and_then(|speed| speed.parse().ok()) == Some(0.0)
    })
    .await;
    let [sun, ring] = [
        page.value("out-sun.angle′").await,
        page.value("out-ring.angle′").await,
    ];
    assert!((sun / ring - ratio("1/4(3)")).abs() < 1e-9, "{sun} {ring}");
    page.close().await;
}

/// The factor that is asked for stops the carrier when it is set; with equal factors all turns as one.
#[tokio::test]
async fn the_tie_that_is_found_stops_the_carrier() {
    let page = Page::open().await;
    lesson(&page).await;
    page.click("lesson-on").await;
    page.click("lesson-on").await;
    page.click("lesson-show-tied").await;
    page.settle().await;
    for (factor, carrier) in [(ratio("4/1(3)"), 0.0), (1.0, 60.0)] {
        page.write("field-factor-2", &factor.to_string()).await;
        page.until("its speed", async || {
            (page.value("out-train-carrier").await - carrier).abs() < 1e-9
        })
        .await;
    }
    page.close().await;
}

/// By how many periods the run slips is that of the engine; with a load that the magnets hold it does not.
#[tokio::test]
async fn the_load_slips_and_is_held() {
    let overloaded = document("overloaded");
    let engine = train("overloaded");
    let run = engine.run(engine.differential.as_ref().unwrap()).unwrap();
    let recording = Recording::new(run, overloaded.span_s);
    let [sun, ring] = Mesh::ALL.map(|mesh| {
        let last = recording.readings().last().unwrap();
        last.mesh(mesh).slipped
    });
    assert!(sun > 0);
    let page = Page::open().await;
    lesson(&page).await;
    for _ in 1..9 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show-brief").await;
    page.until("the slips", async || {
        page.text("out-train-slipped").await == format!("{sun}, {ring}")
    })
    .await;
    // By the slider's field, down to what is held.
    page.write("field-load", "15").await;
    page.until("no slip", async || {
        page.text("out-train-slipped").await == "0, 0"
    })
    .await;
    page.close().await;
}

/// Tables and texts of the steps have room on the narrowest screen, whatever the language.
#[tokio::test]
async fn steps_have_room() {
    let page = Page::open().await;
    lesson(&page).await;
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in languages(0) {
        page.speak(lang).await;
        for step in 1..=STEPS {
            page.click(&shows(&page).await[0]).await;
            page.settle().await;
            found.push((format!("{lang} {step}"), defects(&page, 0).await));
            if step < STEPS {
                page.click("lesson-on").await;
            }
        }
        for _ in 1..STEPS {
            page.click("lesson-back").await;
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// The one-file page has it, too: words, presets, misprints, the views of the kind.
#[tokio::test]
async fn it_opens_from_a_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    lesson(&page).await;
    page.click("lesson-show-three").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// Beside a working member stands what the paper's table has it for, in every language another text; without one nothing.
#[tokio::test]
async fn a_member_has_its_use() {
    let page = Page::open().await;
    lesson(&page).await;
    for _ in 1..STEPS {
        page.click("lesson-on").await;
    }
    let uses = "return [...document.querySelectorAll('#lesson .member-use')].filter((one) => one.checkVisibility()).map((one) => one.textContent);";
    let mut seen = std::collections::BTreeSet::new();
    let members = [
        "fan",
        "brush",
        "stirrer",
        "scraper",
        "blade",
        "propeller",
        "road_wheel",
    ];
    page.choose("field-members\\.carrier", "none").await;
    for name in members {
        page.choose("field-members\\.satellite", name).await;
        let shown: Vec<String> = serde_json::from_value(page.ask(uses).await).unwrap();
        assert_eq!(shown.len(), 1, "{shown:?}");
        seen.extend(shown);
    }
    assert_eq!(seen.len(), members.len(), "{seen:?}");
    assert!(seen.contains("By the table: ventilating rooms"), "{seen:?}");
    page.choose("field-members\\.satellite", "none").await;
    assert_eq!(page.ask(uses).await, json!([]));
    page.close().await;
}

/// Numbers that run leave the question below them where it is, on a phone too.
#[tokio::test]
async fn running_energies_keep_their_height() {
    let step = "v.lesson=%7B%22id%22%3A%22differential%22%2C%22step%22%3A9%7D";
    let page = Page::open_at(&format!("{}#train-magnets&{step}", home()), "uk").await;
    page.screen((360, 740), 2.0).await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    page.click("lesson-on").await;
    page.until("the energies", async || {
        page.count("#train-energies tr").await > 3
    })
    .await;
    page.settle().await;
    page.ask(
        "window.heights = new Set(); window.texts = new Set();
        const look = () => {
            const table = document.querySelector('#train-energies table');
            window.heights.add(table.offsetHeight);
            window.texts.add(table.textContent);
            requestAnimationFrame(look);
        };
        look();",
    )
    .await;
    page.until("a run", async || {
        page.ask("return window.texts.size > 40").await == json!(true)
    })
    .await;
    assert_eq!(page.ask("return window.heights.size").await, json!(1));
    page.close().await;
}
