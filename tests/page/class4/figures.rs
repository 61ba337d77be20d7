//! Figures and controls of steps.

use super::*;

/// Finite differences come near and go off again with their step, and the cyclogram stands in its step with its angles.
#[tokio::test]
async fn lessons_draw_figures_of_their_own() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 5).await;
    assert!(visible(&page, "#lesson #cyclogram").await);
    let phases = "return document.querySelector('#lesson #cyclogram-figure p').textContent";
    let phases = page.ask(phases).await.as_str().unwrap().to_owned();
    assert_eq!(phases.matches('°').count(), 8, "{phases}");
    go_to(&page, 5).await;
    assert!(visible(&page, "#lesson .lesson-matrix").await);
    assert_eq!(page.count("#lesson .lesson-matrix tr").await, 13);
    go_to(&page, 2).await;
    let set = async |exponent: i32| {
        let script = format!(
            "const step = document.getElementById('differences-step');
            step.value = '{exponent}';
            step.dispatchEvent(new Event('input'));
            return document.getElementById('differences-errors').textContent"
        );
        page.ask(&script).await.as_str().unwrap().to_owned()
    };
    let [coarse, middle, fine] = [set(10).await, set(-10).await, set(-50).await];
    assert!(
        coarse != middle && middle != fine,
        "{coarse} {middle} {fine}"
    );
    assert!(page.count("#lesson .lesson-plot circle").await > 30);
    page.close().await;
}

/// The regulator's slider stands in its step, and what it does to dwell and stroke below it.
#[tokio::test]
async fn the_regulator_is_in_its_step() {
    let page = Page::open().await;
    open_lesson(&page).await;
    for _ in 1..6 {
        page.click("lesson-on").await;
    }
    // What the engine makes of the length, in one step of undo.
    let drawn = page.written("field-length-5").await;
    page.click("lesson-show").await;
    page.settle().await;
    assert_eq!(page.written("field-length-5").await, "4.112");
    page.click("undo").await;
    assert_eq!(page.written("field-length-5").await, drawn);
    page.click("redo").await;
    assert_eq!(page.written("field-length-5").await, "4.112");
    page.click("play").await;
    let read = async |place: &str| {
        let script = format!("return document.querySelector('{place}').textContent");
        page.ask(&script).await.as_str().unwrap().to_owned()
    };
    let mut strokes = Vec::new();
    for length in ["4.05", "4.2"] {
        let field = "return document.querySelector('#lesson .lesson-controls input[type=text]').id";
        let field = page.ask(field).await.as_str().unwrap().to_owned();
        page.write(&field, length).await;
        page.settle().await;
        for name in ["course-arc", "course-stroke"] {
            let (here, there) = (
                read(&format!("[data-out=\"{name}\"]")).await,
                read(&format!("#out-{name}")).await,
            );
            // The dwell is what the step asks for.
            let known = if name == "course-arc" {
                here.starts_with('?')
            } else {
                here.ends_with('°')
            };
            assert!(known && here == there, "{here} {there}");
        }
        strokes.push(read("[data-out=\"course-stroke\"]").await);
        assert!(visible(&page, ".lesson-readouts div").await);
    }
    assert_ne!(strokes[0], strokes[1]);
    page.close().await;
}

/// Whether the first element that a selector finds is to be seen.
async fn visible(page: &Page, selector: &str) -> bool {
    let script = format!("return document.querySelector('{selector}').checkVisibility()");
    page.ask(&script).await == serde_json::json!(true)
}
