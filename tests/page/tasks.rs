//! Tasks of lecturers: read-outs that would tell the answer, and numbers of one's own of every kind of document.

use serde_json::{Value, json};

use crate::browser::Page;
use crate::host::home;
use crate::lecturers::{answer, at_jansen, begin, open_file, open_tab, press, there, varied};

async fn hidden(page: &Page, id: &str) -> bool {
    page.text(id).await.starts_with('?') && page.attribute(id, "data-value").await.is_none()
}

/// What an element says, whether it is seen or not.
async fn said(page: &Page, id: &str) -> String {
    let script = format!("return document.getElementById('{id}').textContent");
    page.ask(&script).await.as_str().unwrap().to_owned()
}

/// What is asked for stands as “?” wherever the page would write it, until it is answered or given up.
#[tokio::test]
async fn the_page_hides_what_a_lesson_asks_for() {
    let page = at_jansen().await;
    let mut state = varied(&page).await;
    state["lesson"]["steps"][0]["question"]["number"]["quantity"] = json!("F.y");
    let exact = format!("{:.3}", page.value("out-F.y").await);
    open_file(&page, "own.json", &state.to_string()).await;
    open_tab(&page).await;
    there(&page, "lesson-reader").await;
    assert!(hidden(&page, "out-F.y").await);
    // Another quantity of the same point is no secret.
    assert!(page.value("out-F.x").await.is_finite());
    page.click("lesson-show").await;
    assert!(hidden(&page, "out-F.y").await);
    // How far it is from another mechanism, and what a screen reader hears, do not tell it.
    page.ask("document.getElementById('compare-freeze').click()")
        .await;
    page.settle().await;
    assert!(page.text("difference-F.y").await.starts_with('?'));
    assert!(page.value("difference-F.x").await == 0.0);
    page.until("what is told", async || {
        let told = said(&page, "mechanism-description").await;
        told.contains("F y ?") && !told.contains(&exact)
    })
    .await;
    assert_eq!(answer(&page, &exact).await, "right");
    assert!((page.value("out-F.y").await - exact.parse::<f64>().unwrap()).abs() < 1e-3);

    // A lecturer may leave it on the page.
    page.click("menu").await;
    page.click("write-lesson").await;
    there(&page, "write-hidden").await;
    let hides = "return document.getElementById('write-hidden').checked";
    assert_eq!(page.ask(hides).await, json!(true));
    press(&page, "write-hidden").await;
    page.until("the address", async || {
        page.address().await.contains("%22shown%22%3Atrue")
    })
    .await;
    page.click("undo").await;
    assert_eq!(page.ask(hides).await, json!(true));
    page.click("redo").await;
    page.click("write-read").await;
    there(&page, "lesson-reader").await;
    assert!(page.value("out-F.y").await.is_finite());
    page.close().await;
}

/// What is told of a whole motion, by quantities, is hidden where it stands.
#[tokio::test]
async fn what_is_told_of_a_motion_is_hidden_too() {
    let url = format!("{}#crank-rocker&v.playing=false", home());
    let page = Page::open_at(&url, "en-US").await;
    begin(&page).await;
    page.choose("write-sort", "number").await;
    for (quantity, readouts) in [
        (
            "rocker.angle:swing",
            &["linkage-swing", "course-stroke"][..],
        ),
        ("rocker.angle:time_ratio", &["linkage-time-ratio"]),
        ("C.transmission:worst", &["linkage-transmission"]),
        ("rocker.angle″", &["rocker.angle″"]),
        ("W", &["linkage-w"]),
    ] {
        page.choose("write-quantity", quantity).await;
        page.click("write-read").await;
        there(&page, "lesson-reveal").await;
        for readout in readouts {
            let id = format!("out-{readout}");
            assert!(said(&page, &id).await.starts_with('?'), "{quantity}: {id}");
        }
        page.click("lesson-reveal").await;
        page.settle().await;
        for readout in readouts {
            let id = format!("out-{readout}");
            assert!(!said(&page, &id).await.starts_with('?'), "{quantity}: {id}");
        }
        page.click("lesson-write").await;
        there(&page, "write-quantity").await;
    }
    // Where the driver stands is no secret.
    page.choose("write-quantity", "input").await;
    assert_eq!(page.count("label.check[hidden] > #write-hidden").await, 1);
    page.close().await;
}

/// A lesson that shows a mechanism of the catalogue with these numbers varied, and asks for a quantity.
async fn lesson(page: &Page, id: &str, vary: Value, quantity: &str) -> Value {
    let script = format!(
        "const done = arguments[0];
        window.eval(\"import('assur/pkg/assur_web.js')\").then(({{ catalogue }}) => {{
            const {{ kind, document }} = catalogue().find(({{ id }}) => id === '{id}');
            done({{ format: 2, kind, document, lesson: {{ title: '{id}', steps: [{{
                title: 'Own', text: '', shows: {{ kind, document, view: {{ phi_deg: 30, axes: 'physical' }}, vary: {vary} }},
                question: {{ text: '?', number: {{ quantity: '{quantity}', within: 0.001 }} }},
            }}] }} }});
        }})"
    );
    page.wait_for(&script).await
}

/// The numbers in these fields after a name was typed and what the step shows was brought.
async fn own(page: &Page, name: &str, fields: &[&str]) -> Vec<f64> {
    page.write("lesson-reader", name).await;
    page.click("lesson-show").await;
    page.settle().await;
    let mut found = Vec::new();
    for field in fields {
        let text = page.written(field).await;
        let number = text.trim_end_matches('°').replace('−', "-");
        found.push(number.parse().unwrap());
    }
    found
}

async fn at(page: &Page, state: &Value) {
    open_file(page, "own.json", &state.to_string()).await;
    assert_eq!(page.text("notice-text").await, "");
    open_tab(page).await;
    there(page, "lesson-reader").await;
}

/// Numbers of teeth are whole ones, and the same for the same name.
#[tokio::test]
async fn a_mixer_has_wheels_of_ones_own() {
    let page = at_jansen().await;
    let vary = json!([
        { "field": "wheels[0].z", "from": 16, "to": 30, "step": 2 },
        { "field": "l1", "from": 0.3, "to": 0.4, "step": 0.01 },
        { "field": "wheels[0].centre_line_deg", "from": -60, "to": 60, "step": 15 },
    ]);
    let state = lesson(&page, "mixer-a", vary, "wheel5.angle:swing").await;
    at(&page, &state).await;
    let fields = ["field-z5", "field-l1", "field-beta5"];
    let mut all = Vec::new();
    for name in ["Ann", "Bo", "Cai", " ann"] {
        let numbers = own(&page, name, &fields).await;
        let [teeth, crank, line] = numbers[..] else {
            panic!("{numbers:?}")
        };
        assert!(
            (16.0..=30.0).contains(&teeth) && teeth % 2.0 == 0.0,
            "{teeth}"
        );
        assert!((0.3..=0.4).contains(&crank), "{crank}");
        assert!(line.abs() <= 60.0 && line % 15.0 == 0.0, "{line}");
        // The swing of the wheel is that of the rocker by the teeth; it is hidden from who has not answered yet.
        let answered = name == " ann";
        assert_ne!(hidden(&page, "out-swing-wheel5").await, answered, "{name}");
        let rocker: f64 = page.written("field-z4").await.parse().unwrap();
        let swing = page.value("out-swing-rocker").await * rocker / teeth;
        assert_eq!(
            answer(&page, &format!("{swing:.4}")).await,
            "right",
            "{name}"
        );
        all.push(numbers);
    }
    assert_eq!(all[0], all[3]);
    assert!(all[0] != all[1] && all[1] != all[2]);
    page.close().await;
}

/// The form offers every number that stands beside the drawing, and refuses what is none of its values.
#[tokio::test]
async fn the_form_offers_all_numbers() {
    let url = format!("{}#mixer-a&v.playing=false", home());
    let page = Page::open_at(&url, "en-US").await;
    begin(&page).await;
    let offered = "return [...document.querySelectorAll('#write-vary option')].map(({ value, text }) => [value, text])";
    let offered: Vec<(String, String)> = serde_json::from_value(page.ask(offered).await).unwrap();
    let fields: Vec<&str> = offered.iter().map(|(field, _)| &field[..]).collect();
    assert_eq!(
        fields,
        [
            "",
            "l1",
            "l2",
            "l3",
            "l4",
            "z4",
            "module",
            "wheels[0].z",
            "wheels[0].centre_line_deg"
        ]
    );
    assert_eq!(offered[7].1, "Wheel 5, number of teeth");
    page.choose("write-vary", "wheels[0].z").await;
    let shown = async |bound: &str| page.written(&format!("write-vary-0-{bound}")).await;
    assert_eq!(
        (shown("from").await, shown("to").await, shown("step").await),
        ("16".into(), "20".into(), "1".into())
    );
    page.write("write-vary-0-step", "0.5").await;
    assert!(
        page.text("write-said").await.contains("whole"),
        "{}",
        page.text("write-said").await
    );
    page.write("write-vary-0-step", "2").await;
    assert_eq!(page.text("write-said").await, "");
    page.until("the address", async || {
        page.address().await.contains("wheels%5B0%5D.z")
    })
    .await;
    page.close().await;
}
