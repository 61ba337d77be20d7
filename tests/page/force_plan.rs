//! Force plans, Zhukovsky's lever and free bodies, as a student goes through them.

use serde_json::{Value, json};

use crate::access::named_and_fits;
use crate::browser::Page;

/// A slider-crank with its crank upright at rest: crank 3, rod 5 with the weight 10 N, slider with the weight 20 N and a force of
/// 100 N against it. `crates/assur/src/forces/plan/tests.rs` solves it by hand.
fn document() -> Value {
    json!({
        "points": [
            { "name": "A", "at": [0, 0] }, { "name": "B", "at": [0, 3] }, { "name": "C", "at": [4, 0] },
            { "name": "E", "at": [9, 0] },
        ],
        "frame": ["A", "E"],
        "links": [
            { "name": "crank", "points": ["A", "B"] },
            { "name": "rod", "points": ["B", "C"], "mass": 1 },
            { "name": "slider", "points": ["C"], "mass": 2 },
        ],
        "slides": [{ "link": "slider", "point": "C", "on": "frame", "line": ["A", "E"] }],
        "drivers": [{ "crank": "crank" }],
        "unit": "m",
        "gravity": [0, -10],
        "loads": [{ "link": "slider", "point": "C", "value": 100, "direction_deg": 180 }],
    })
}

async fn open(document: Value) -> Page {
    let page = Page::open().await;
    let script = format!(
        "const document = {document};
        const said = (value) => encodeURIComponent(typeof value === 'string' ? value : JSON.stringify(value));
        const pairs = Object.entries(document).map(([key, value]) => `d.${{key}}=${{said(value)}}`);
        location.hash = ['2', 'kind=linkage', ...pairs, 'v.phi_deg=90', 'v.playing=false', 'v.omega=0',
            'v.direction=1', 'v.speed=1', 'v.traces=true', 'v.force_plan=true', 'v.lang=en'].join('&');"
    );
    page.ask(&script).await;
    page.until("the panel", async || {
        page.count("#force-plan-shown:not([hidden])").await == 1
    })
    .await;
    page.settle().await;
    page
}

/// Value of what the last shown step of a force finds.
async fn found(page: &Page, symbol: &str) -> f64 {
    let script = format!(
        "return Number([...document.querySelectorAll(\"#force-plan-steps [data-force='{symbol}']\")].at(-1).dataset.value)"
    );
    page.ask(&script).await.as_f64().unwrap()
}

async fn near(page: &Page, symbol: &str, expected: f64) {
    let shown = found(page, symbol).await;
    assert!((shown - expected).abs() < 1e-9, "{symbol}: {shown}");
}

#[tokio::test]
async fn a_force_plan_is_drawn_step_by_step() {
    let page = open(document()).await;
    assert_eq!(page.text("force-plan-step").await, "Step 6 of 6");
    for (symbol, expected) in [
        ("R₁₂ᵗ", -4.0),
        ("R₁₂ⁿ", 122.0),
        ("R₀₃", 100.0),
        ("T₁", -300.0),
        ("R₀₁", 100_f64.hypot(70.0)),
    ] {
        near(&page, symbol, expected).await;
    }
    page.click("force-plan-next").await;
    page.settle().await;
    assert_eq!(page.text("force-plan-step").await, "Step 1 of 6");
    let said = page.text("force-plan-steps").await;
    assert!(said.contains("10 N·2 m + R₁₂ᵗ·5 m = 0"), "{said}");
    let mut before = page.picture("force-plan-picture").await;
    for step in 2..=6 {
        page.focus("force-plan-next").await;
        page.keys(" ").await;
        page.settle().await;
        assert_eq!(page.count("#force-plan-steps > li").await, step);
        let now = page.picture("force-plan-picture").await;
        let new = now.difference(&before);
        assert!(new > 50, "{new} at {step}");
        before = now;
    }
    page.click("force-plan-svg").await;
    let svg = String::from_utf8(page.saved("assur-linkage-force-plan.svg").await).unwrap();
    assert!(svg.contains("R₀₁"), "{svg}");

    page.until("what prints", async || {
        page.ask("return performance.getEntriesByName('printable').length")
            .await
            == 1
    })
    .await;
    page.ask("dispatchEvent(new Event('beforeprint'))").await;
    // One polygon for the group, one for the crank.
    assert_eq!(page.count("#worksheet .force-plan svg").await, 2);
    assert_eq!(page.count("#worksheet .force-plan ol > li").await, 6);
    page.ask("dispatchEvent(new Event('afterprint'))").await;
    page.close().await;
}

#[tokio::test]
async fn the_lever_and_the_plan_give_the_same_torque() {
    let page = open(document()).await;
    page.click("force-tab-lever").await;
    page.settle().await;
    let script = "return ['lever', 'plan', 'difference'].map((way) => Number(document.querySelector(`[data-lever='${way}']`).dataset.value))";
    let [lever, plan, difference]: [f64; 3] =
        serde_json::from_value(page.ask(script).await).unwrap();
    assert!((lever + 300.0).abs() < 1e-9, "{lever}");
    assert!((plan + 300.0).abs() < 1e-9, "{plan}");
    assert!(difference.abs() < 1e-9, "{difference}");
    page.click("force-tab-body").await;
    page.settle().await;
    let crank = page.picture("free-body-picture").await;
    let chosen = "const link = document.getElementById('force-body-link'); link.selectedIndex = 2; link.dispatchEvent(new Event('change'))";
    page.ask(chosen).await;
    page.settle().await;
    let slider = page.picture("free-body-picture").await;
    assert!(slider.difference(&crank) > 200);
    let script = "return [...document.querySelectorAll('#force-body-numbers [data-force]')].map((row) => row.dataset.force)";
    let forces = page.ask(script).await;
    assert_eq!(forces, json!(["G₃", "F₁", "R₂₃", "R₀₃"]));
    // The exercise hides the numbers and shows the unknowns in the senses that are chosen.
    page.ask("document.getElementById('force-exercise').open = true")
        .await;
    page.settle().await;
    let hidden = "return document.getElementById('force-body-numbers').hidden";
    assert_eq!(page.ask(hidden).await, json!(true));
    page.click("force-exercise-check").await;
    let said = page.text("force-exercise-said").await;
    // Weight and load, the components in C, force and moment of the guide; a couple is in one sum only.
    assert_eq!(said, "Wrong: 0; not yet answered: 16.");
    let before = page.picture("free-body-picture").await;
    page.ask(
        "const sense = document.querySelector('#force-exercise tbody tr:nth-child(3) select');
        sense.value = 'reversed'; sense.dispatchEvent(new Event('change'))",
    )
    .await;
    page.settle().await;
    let reversed = page.picture("free-body-picture").await;
    assert!(reversed.difference(&before) > 50);
    // Right signs for these senses give the values; all forces meet in C, so no force has a moment about it.
    page.ask(
        "const fields = [...document.querySelectorAll('#force-exercise tbody tr')].map((row) => [...row.querySelectorAll('select')].slice(-3));
        const sense = (row) => document.querySelectorAll('#force-exercise tbody tr')[row].querySelector('select').selectedOptions[0].textContent;
        const signs = { '→': '+00', '←': '−00', '↑': '0+0', '↓': '0−0', '↺': '00+', '↻': '00−' };
        ['0−0', '−00', signs[sense(2)], signs[sense(3)], signs[sense(4)], signs[sense(5)]].forEach((row, k) => {
            [...row].forEach((sign, at) => { if (!fields[k][at].disabled) fields[k][at].value = sign; });
        });",
    )
    .await;
    page.click("force-exercise-check").await;
    let said = page.text("force-exercise-said").await;
    assert!(said.starts_with("All is right."), "{said}");
    let values = "return [...document.querySelectorAll('#force-exercise-found [data-force]')].map((one) => [one.dataset.force, Number(one.dataset.value)])";
    let values: Vec<(String, f64)> = serde_json::from_value(page.ask(values).await).unwrap();
    let size = |symbol: &str| values.iter().find(|(name, _)| name == symbol).unwrap().1;
    assert!((size("R₂₃ˣ").abs() - 100.0).abs() < 1e-9, "{values:?}");
    assert!((size("R₂₃ʸ").abs() - 80.0).abs() < 1e-9, "{values:?}");
    assert!((size("R₀₃").abs() - 100.0).abs() < 1e-9, "{values:?}");
    page.screen((360, 740), 2.0).await;
    named_and_fits(&page).await;
    page.close().await;
}

/// Without masses and loads one sentence says what to add.
#[tokio::test]
async fn without_forces_it_says_what_to_add() {
    let mut bare = document();
    bare["gravity"] = json!([0, 0]);
    bare["loads"] = json!([]);
    let page = open(bare).await;
    let said = page.text("force-plan-none").await;
    assert!(said.starts_with("No force acts on the links."), "{said}");
    assert_eq!(page.count("#force-plan-steps > li").await, 0);
    page.close().await;
}
