//! The lesson's steps: opened, walked through and answered by mouse, by keys and by
//! touch; what is right is what the engine, run natively, says of the mechanism.

mod hands;
mod parts;

use assur::mixer::{Case, Mixer};
use assur_tests::{Rocker, scaled_swing};
use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

/// Steps of the mixer's lesson.
const STEPS: usize = 10;

fn mixer(case: Case) -> Mixer {
    Mixer::new(&case.dimensions()).unwrap()
}

async fn open(page: &Page) {
    page.click("tab-lesson").await;
    loaded(page).await;
}

async fn loaded(page: &Page) {
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    page.settle().await;
}

/// Goes on to a step by the buttons.
async fn turn_to(page: &Page, number: usize) {
    for _ in 1..number {
        page.click("lesson-on").await;
    }
    let progress = page.text("lesson-progress").await;
    assert!(
        progress.contains(&format!("Step {number} of {STEPS}")),
        "{progress}"
    );
}

/// Types an answer, has it checked, and gives the verdict.
async fn answer(page: &Page, text: &str) -> String {
    page.write("lesson-answer", text).await;
    verdict(page).await
}

async fn verdict(page: &Page) -> String {
    page.attribute("lesson-said", "data-verdict").await.unwrap()
}

async fn visible(page: &Page, id: &str) -> bool {
    page.element(id).await.is_displayed().await.unwrap()
}

#[tokio::test]
async fn six_questions_answered_by_mouse() {
    let page = Page::playing().await;
    // Who comes first sees the machine run, and the settings.
    assert!(visible(&page, "rail").await && !visible(&page, "lesson").await);
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("true")
    );
    let names = page.loaded().await;
    assert!(
        !names.iter().any(|name| name.contains("lessons")),
        "{names:?}"
    );
    open(&page).await;
    assert!(visible(&page, "lesson").await && !visible(&page, "rail").await);
    assert!(visible(&page, "mechanism").await && visible(&page, "charts").await);
    assert!(
        !page
            .element("lesson-back")
            .await
            .is_enabled()
            .await
            .unwrap()
    );

    let [a, c] = [mixer(Case::A), mixer(Case::C)];
    let limits = a.linkage.limits(a.assembly);
    let [low, high] = [limits[0], limits[1]];
    assert!(low.rocker < high.rocker);
    let swing = scaled_swing(c.linkage.swings(c.assembly)[0], c.gears.pairs()[0].ratio());
    let slow = a.linkage.time_ratio(a.assembly).unwrap();
    let numbers = [
        (4.0, 0.0),
        (a.gears.pairs()[0].ratio(), 0.005),
        (high.crank.to_degrees(), 0.5),
        (swing.stroke().unwrap().to_degrees(), 0.5),
        (360.0 * slow / (1.0 + slow), 0.5),
    ];
    for (index, (exact, within)) in numbers.into_iter().enumerate() {
        let told = page.text("lesson-question").await;
        assert!(
            within == 0.0 || told.contains(&within.to_string()),
            "{told}"
        );
        page.click("lesson-show").await;
        // Just outside the tolerance, just inside, and with a comma.
        let off = if within == 0.0 { 1.0 } else { 1.02 * within };
        for wrong in [exact + off, exact - off] {
            assert_eq!(
                answer(&page, &wrong.to_string()).await,
                "not_yet",
                "{wrong} for {exact}"
            );
            assert!(page.text("lesson-said").await.len() > 30);
        }
        assert_eq!(answer(&page, "about two").await, "unread");
        for right in [exact + 0.98 * within, exact - 0.98 * within] {
            let right = right.to_string();
            assert_eq!(answer(&page, &right).await, "right", "{right} for {exact}");
            assert_eq!(answer(&page, &right.replace('.', ",")).await, "right");
        }
        let progress = page.text("lesson-progress").await;
        assert!(
            progress.contains(&format!("{} right answer", index + 1)),
            "{progress}"
        );
        page.click("lesson-on").await;
    }

    page.click("lesson-check").await;
    assert_eq!(verdict(&page).await, "unanswered");
    page.click("lesson-show-b").await;
    let pressed = page.attribute("preset-b", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    for (choice, expected) in [
        ("in_line", "not_yet"),
        ("dead_point", "not_yet"),
        ("on_frame", "right"),
    ] {
        page.click(&format!("lesson-{choice}")).await;
        assert_eq!(verdict(&page).await, "", "a new choice is not yet judged");
        page.click("lesson-check").await;
        assert_eq!(verdict(&page).await, expected, "{choice}");
    }
    assert!(
        page.text("lesson-progress")
            .await
            .contains("6 right answers")
    );
    // After the last step comes what was learnt, and no step more.
    for _ in 6..=STEPS {
        page.click("lesson-on").await;
    }
    assert!(!visible(&page, "lesson-check").await);
    assert!(!page.element("lesson-on").await.is_enabled().await.unwrap());
    for _ in 6..=STEPS {
        page.click("lesson-back").await;
    }

    // What was answered is still there; the settings come back.
    page.click("lesson-back").await;
    assert!(!page.written("lesson-answer").await.is_empty());
    // Pressed again before it is drawn, it leads no farther than to the last step, or to the first.
    for (button, twin) in [("lesson-on", "lesson-back"), ("lesson-back", "lesson-on")] {
        page.ask(&format!(
            "for (let times = 0; times < 15; times++) document.getElementById('{button}').click();"
        ))
        .await;
        page.until("the end", async || {
            page.count(&format!("#{button}:disabled")).await == 1
        })
        .await;
        assert_eq!(page.count(&format!("#{twin}:enabled")).await, 1);
    }
    page.click("tab-settings").await;
    assert!(visible(&page, "rail").await && !visible(&page, "lesson").await);
    page.close().await;
}

/// "Show it" puts the mechanism where the text says, in one step of undo.
#[tokio::test]
async fn what_is_shown() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.write("field-l3", "0.7").await;
    open(&page).await;
    turn_to(&page, 3).await;
    page.click("lesson-show").await;
    let a = mixer(Case::A);
    let limit = a.linkage.limits(a.assembly)[0].crank.to_degrees();
    assert!((page.value("out-input").await - limit).abs() < 1e-9);
    assert!(page.value("out-rocker.angle′").await.abs() < 1e-9);
    assert!(
        page.element("loop_vectors")
            .await
            .is_selected()
            .await
            .unwrap()
    );
    // The other limit, a turn more or less.
    let other = a.linkage.limits(a.assembly)[1].crank.to_degrees();
    assert_eq!(answer(&page, &(other - 360.0).to_string()).await, "right");
    page.click("undo").await;
    assert!(
        !page
            .element("loop_vectors")
            .await
            .is_selected()
            .await
            .unwrap()
    );
    // Before the mechanism of step 2 is what the reader had.
    page.click("undo").await;
    assert_eq!(page.written("field-l3").await, "0.7");
    assert_eq!(verdict(&page).await, "", "that was of another mechanism");
    page.close().await;
}

/// The mechanism of the step is asked about: the one it showed last, as its own controls have changed it. Any
/// other is put aside first, and comes back by undo.
#[tokio::test]
async fn the_mechanism_of_the_step_is_asked_about() {
    let page = Page::open().await;
    page.stop_at("10").await;
    page.write("field-z5", "30").await;
    open(&page).await;
    turn_to(&page, 2).await;
    // *Next* has put it aside.
    assert_eq!(page.written("field-z5").await, "18");
    let brought = async || page.text("lesson-said").await.contains("has been put back");
    // By controls of the step.
    page.write("field-z5", "24").await;
    page.click("mesh-internal").await;
    assert_eq!(answer(&page, "-2").await, "not_yet");
    assert_eq!(answer(&page, "1.5").await, "right");
    page.click("undo").await;
    assert_eq!(verdict(&page).await, "", "judged of another mechanism");
    assert_eq!(answer(&page, "-1.5").await, "right");
    page.click("redo").await;
    assert_eq!(answer(&page, "1.5").await, "right");
    assert!(!brought().await);

    // By the settings: what is no mechanism, and what is another one.
    page.click("tab-settings").await;
    page.write("field-l4", "2").await;
    page.click("tab-lesson").await;
    assert_eq!(verdict(&page).await, "", "judged of another mechanism");
    assert_eq!(answer(&page, "1.5").await, "right");
    assert!(brought().await);
    assert_eq!(page.text("problem").await, "");
    page.click("tab-settings").await;
    page.write("field-l4", "0.84").await;
    page.click("tab-lesson").await;
    assert_eq!(answer(&page, "1.5").await, "right");
    assert!(brought().await);
    assert_eq!(page.written("field-l4").await, "0.85");
    page.click("undo").await;
    assert_eq!(page.written("field-l4").await, "0.84");

    // Another kind of mechanism.
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-jansen").await == 1
    })
    .await;
    page.click("gallery-jansen").await;
    page.settle().await;
    assert_eq!(answer(&page, "-2").await, "not_yet");
    assert!(brought().await);
    assert_eq!(page.written("field-z5").await, "24");
    page.click("undo").await;
    page.settle().await;
    assert!(page.text("mechanism-name").await.contains("Jansen"));
    page.close().await;
}

/// What the controls of a step have made of its mechanism is the step's also after a reload.
#[tokio::test]
async fn the_mechanism_of_the_step_outlives_the_page() {
    let page = Page::open().await;
    page.stop_at("10").await;
    open(&page).await;
    turn_to(&page, 2).await;
    page.write("field-z5", "24").await;
    page.until("the address to follow", async || {
        page.address().await.contains("%22z%22%3A24")
    })
    .await;
    page.reload().await;
    loaded(&page).await;
    assert_eq!(page.written("field-z5").await, "24");
    assert_eq!(answer(&page, "-1.5").await, "right");
    assert!(!page.text("lesson-said").await.contains("put back"));
    page.close().await;
}

/// How the address writes the open step.
fn written(step: usize) -> String {
    format!("%22step%22%3A{step}%7D")
}

/// The open step is in the address; one that the lesson has not gives the last. A lesson
/// that there is not is like none.
#[tokio::test]
async fn a_link_opens_the_step() {
    let page = Page::open().await;
    page.stop_at("75").await;
    open(&page).await;
    turn_to(&page, 3).await;
    page.until("the address to follow", async || {
        page.address().await.contains(&written(3))
    })
    .await;
    let link = page.address().await;
    page.anew(&link).await;
    loaded(&page).await;
    assert_eq!(page.text("lesson-title").await, "Limit positions");
    page.anew(&link.replace(&written(3), &written(200))).await;
    loaded(&page).await;
    assert!(
        page.text("lesson-progress")
            .await
            .contains("End of the lesson")
    );
    page.click("lesson-back").await;
    assert!(page.text("lesson-progress").await.contains("Step 10 of 10"));
    page.anew(&link.replace("%22mixer%22", "%22nosuch%22"))
        .await;
    assert!(visible(&page, "rail").await && !visible(&page, "lesson").await);
    assert_eq!(page.said().await, Vec::<String>::new());
    // The lesson on the mechanism is offered as ever.
    open(&page).await;
    assert!(page.text("lesson-progress").await.contains("Step 1 of 10"));
    page.close().await;
}
