//! The Class IV mechanism on the page: its dwell, its cyclogram, its lesson.

use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::open;
use thirtyfour::prelude::*;

/// The colour of the shade over a dwell on paper: the coupler's, thinned.
const SHADE: [u8; 3] = [0xFA, 0xE8, 0xDC];

async fn dwell(page: &Page) -> String {
    page.text("out-course-arc").await
}

/// Dwell and stroke of theory.md's table, of the band that is typed, and with the
/// regulator lengthened; the plots are shaded; what was typed is undone.
#[tokio::test]
async fn its_dwell_is_measured_and_regulated() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("0").await;
    assert_eq!(dwell(&page).await, "184.289°");
    assert_eq!(page.text("out-course-stroke").await, "43.2908°");
    let bars = page.attribute("cyclogram", "aria-label").await.unwrap();
    assert!(bars.contains("rise") && bars.contains("dwell") && bars.contains("return"));
    let shaded = page.picture("charts").await.places(SHADE).count();
    assert!(shaded > 5000, "{shaded}");

    // Shade and inset are on the exported plots, too.
    open_dialog(&page).await;
    let svg = save_text(&page, "export-plots-svg", "assur-class4-dwell-plots.svg").await;
    assert!(svg.contains("↕ 0.1°"));
    page.click("export-close").await;

    page.write("field-band", "0.01").await;
    page.until("a narrower band", async || {
        dwell(&page).await.starts_with("170.19")
    })
    .await;
    page.click("undo").await;
    page.until("the band before", async || dwell(&page).await == "184.289°")
        .await;

    page.write("field-length-5", "4.312").await;
    page.until("a short dwell", async || {
        dwell(&page).await.starts_with("65.63")
    })
    .await;
    assert!(page.text("out-course-stroke").await.starts_with("45.45"));
    let less = page.picture("charts").await.places(SHADE).count();
    assert!(2 * less < shaded, "{less} of {shaded}");

    // Nothing dwells in no band: the last good one stays, and a sentence says why.
    page.write("field-band", "-1").await;
    page.until("a sentence", async || {
        page.text("problem").await.contains("band")
    })
    .await;
    assert!(dwell(&page).await.starts_with("65.63"));
    page.close().await;
}

/// All six steps, each answered wrong and right, by mouse and by keys.
#[tokio::test]
async fn its_lesson_is_answered() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    let steps: [(bool, &str, &str); 6] = [
        (false, "9", "10"),
        (true, "iii", "iv"),
        (true, "iv", "ii"),
        (false, "170", "184.3"),
        (false, "184.3", "121.9"),
        (false, "42", "44.15"),
    ];
    for (number, (choices, wrong, right)) in steps.iter().enumerate() {
        if number > 0 {
            page.click("lesson-on").await;
        }
        // The last question is asked of the mechanism as the step before left it.
        if number < 5 {
            page.click("lesson-show").await;
            page.settle().await;
        }
        for (answer, verdict) in [(wrong, "not_yet"), (right, "right")] {
            if *choices {
                page.click(&format!("lesson-{answer}")).await;
            } else {
                page.write("lesson-answer", answer).await;
            }
            page.press("lesson-check", Key::Enter).await;
            page.until(&format!("step {} to be judged", number + 1), async || {
                page.attribute("lesson-said", "data-verdict")
                    .await
                    .as_deref()
                    == Some(verdict)
            })
            .await;
        }
    }
    // The driver of step 3 made it a mechanism of Class II, and step 4 brought it back.
    assert!(page.text("out-formula").await.contains("IV₃"));
    page.close().await;
}
