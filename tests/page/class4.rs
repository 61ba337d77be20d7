//! The Class IV mechanism on the page: its dwell, its cyclogram, its lesson.

mod figures;
mod linkage;

use crate::assemblies::{follow, followed};
use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::{agrees, document, open};
use assur::{CombinedMethod, Point};
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
    // An angle swings, a length has a stroke.
    let title = "return document.querySelector('#out-course-stroke').closest('tr').querySelector('th').textContent";
    assert_eq!(page.ask(title).await, "swing");
    let bars = page.attribute("cyclogram", "aria-label").await.unwrap();
    assert!(bars.contains("rise") && bars.contains("dwell") && bars.contains("return"));
    let shaded = page.picture("charts").await.places(SHADE).count();
    assert!(shaded > 5000, "{shaded}");

    // Shade and inset are on the exported plots, too.
    open_dialog(&page).await;
    let svg = save_text(&page, "export-plots-svg", "assur-class4-dwell-plots.svg").await;
    assert!(svg.contains("↕ 0.1°"));
    // One inset for the angle and for each derivative, as in fig. 2.
    assert_eq!(svg.matches('↕').count(), 3);
    page.click("export-close").await;

    // As a person types: the page answers every key, also the 0 that is no band.
    let field = page.element("field-band").await;
    field.click().await.unwrap();
    field.send_keys(Key::Control + "a").await.unwrap();
    for typed in ["0", "0.", "0.0", "0.01"] {
        field.send_keys(&typed[typed.len() - 1..]).await.unwrap();
        page.settle().await;
        assert_eq!(field.value().await.unwrap().unwrap(), typed);
    }
    page.press("field-band", Key::Enter).await;
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
        page.text("problem").await.contains("tolerance")
    })
    .await;
    assert!(dwell(&page).await.starts_with("65.63"));
    page.close().await;
}

/// The steps, each answered wrong and right, by mouse and by keys.
#[tokio::test]
async fn its_lesson_is_answered() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    let steps: [(bool, &str, &str); 16] = [
        (false, "9", "10"),
        (true, "iii", "iv"),
        (true, "iv", "ii"),
        (false, "170", "184.3"),
        (false, "175.7", "170.1"),
        (false, "184.3", "121.9"),
        (false, "12", "13"),
        (true, "turn", "both"),
        (false, "44.15", "43.29"),
        (true, "small", "middle"),
        (true, "square", "in_line"),
        (true, "along", "across"),
        (true, "cd", "fk"),
        (true, "largest", "nothing"),
        (true, "d", "bc"),
        (true, "x_eb", "ratio"),
    ];
    for (number, (choices, wrong, right)) in steps.iter().enumerate() {
        if number > 0 {
            page.click("lesson-on").await;
        }
        // The last step has two buttons of other names, and opens the first by itself.
        if number < 15 {
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
    // A number in a formula has the decimal sign of the reader's language.
    for _ in 0..10 {
        page.click("lesson-back").await;
    }
    for (lang, expected) in [
        ("en", "FK = 4.112"),
        ("ru", "FK = 4,112"),
        ("kk", "FK = 4,112"),
    ] {
        page.speak(lang).await;
        page.until(&format!("the formula in {lang}"), async || {
            let formula = page.driver.find(By::Css("#lesson .formula")).await.unwrap();
            formula.text().await.unwrap() == expected
        })
        .await;
    }
    page.close().await;
}

async fn open_lesson(page: &Page) {
    open(page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
}

/// "Show it" opens the whole document of the step: an assembly that the reader chose
/// in the step before is not left over, and one undo brings it back.
#[tokio::test]
async fn a_step_shows_its_own_document() {
    let page = Page::open().await;
    open_lesson(&page).await;
    for _ in 1..3 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show").await;
    page.click("tab-settings").await;
    // Of another angle other assemblies have these numbers.
    page.stop_at("0").await;
    follow(&page, 2).await;
    assert!(page.text("out-formula").await.contains("II₂"));
    page.click("tab-lesson").await;
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert!(page.text("out-formula").await.contains("IV₃"));
    page.click("tab-settings").await;
    assert_eq!(dwell(&page).await, "184.289°");
    page.click("undo").await;
    assert!(page.text("out-formula").await.contains("II₂"));
    page.stop_at("0").await;
    assert_eq!(followed(&page).await, "2");
    page.close().await;
}

/// A lesson may be open over a document of another kind: there is nothing to judge then,
/// and "Show it" opens a document of the lesson's. It stays open, and over what undo brings.
#[tokio::test]
async fn a_step_opens_a_document_of_another_kind() {
    let page = Page::open().await;
    page.stop_at("60").await;
    open_lesson(&page).await;
    page.until("the address to follow", async || {
        page.address()
            .await
            .contains("%22class4-dwell%22,%22step%22")
    })
    .await;
    let link = page.address().await;
    let other = link.replace("%22class4-dwell%22,%22step%22", "%22mixer%22,%22step%22");
    page.anew(&other).await;
    let titled = async || page.text("lesson-title").await == "The machine and its parts";
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    assert!(titled().await);
    let verdict = async || page.attribute("lesson-said", "data-verdict").await;
    let kind = async || {
        page.ask("return document.documentElement.dataset.kind")
            .await
    };
    assert_eq!(kind().await, "linkage");
    // The question is about the step's own mechanism, which comes first.
    page.write("lesson-answer", "4").await;
    assert_eq!(verdict().await.as_deref(), Some("right"));
    assert_eq!(kind().await, "mixer");
    assert!(titled().await);
    page.click("undo").await;
    assert_eq!(kind().await, "linkage");
    assert!(titled().await);
    // Once closed, the lesson about the mechanism that is there is offered.
    page.click("tab-settings").await;
    page.click("tab-lesson").await;
    page.until("the other lesson", async || !titled().await)
        .await;
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains("Step 1 of 16"), "{progress}");
    page.close().await;
}

/// What was answered is still there when the page is opened again, in whatever lesson;
/// the address does not tell it.
#[tokio::test]
async fn progress_outlives_the_page() {
    let page = Page::playing().await;
    open_lesson(&page).await;
    page.click("lesson-show").await;
    page.write("lesson-answer", "10").await;
    page.press("lesson-check", Key::Enter).await;
    page.click("lesson-on").await;
    page.click("lesson-iii").await;
    page.click("play").await;
    page.until("the address to follow", async || {
        page.address().await.contains("%22step%22%3A2")
    })
    .await;
    page.reload().await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    let progress = page.text("lesson-progress").await;
    assert!(
        progress.contains("Step 2") && progress.contains("1 right answer"),
        "{progress}"
    );
    let chosen = page.element("lesson-iii").await;
    assert!(chosen.is_selected().await.unwrap());
    assert_eq!(
        page.attribute("lesson-said", "data-verdict")
            .await
            .as_deref(),
        Some("")
    );
    page.click("lesson-back").await;
    assert_eq!(page.written("lesson-answer").await, "10");
    let address = page.address().await;
    assert!(
        !address.contains("solved") && !address.contains("given"),
        "{address}"
    );

    // What somebody else wrote there is passed over.
    page.ask("localStorage.setItem('assur.lesson.class4-dwell', '{\"given\":7,\"solved\":{}}')")
        .await;
    page.reload().await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    assert!(!page.text("lesson-progress").await.contains("answer"));
    page.close().await;
}

/// Goes to a step of the lesson from its first.
async fn go_to(page: &Page, step: usize) {
    for _ in 1..step {
        page.click("lesson-on").await;
    }
    page.settle().await;
}

/// Every coefficient has the engine's number, and the printed one where that is another; both follow the crank.
#[tokio::test]
async fn coefficients_have_their_numbers() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 11).await;
    let motion = document("class4-dwell").motion().unwrap();
    let mechanism = motion.mechanism();
    let method = CombinedMethod::of(mechanism).unwrap();
    page.ask("document.querySelector('#lesson-paper > summary').click()")
        .await;
    for degrees in [60.0_f64, 200.0] {
        page.stop_at(&degrees.to_string()).await;
        page.settle().await;
        let pose = motion.pose::<3>(degrees.to_radians()).unwrap();
        let relations = method.relations(mechanism, &pose);
        for (item, misprinted) in [("c3", true), ("c7", true), ("c14", false), ("vF", false)] {
            let item = format!("003.{item}");
            let numbers = format!(
                "return document.querySelector('#lesson-paper [data-item=\"{item}\"] .paper-numbers').textContent"
            );
            let shown = page.ask(&numbers).await.as_str().unwrap().to_owned();
            for one in relations.iter().filter(|one| one.item == item) {
                let value = format!("{:.4}", one.value).replace('-', "−");
                assert!(shown.contains(&value), "{item} {degrees}: {shown}");
                assert_eq!(shown.contains("as printed"), misprinted, "{item}: {shown}");
            }
        }
    }
    page.close().await;
}

/// The chain of the paper divides by zero where HL is as long as HG, and says so.
#[tokio::test]
async fn the_chain_divides_by_zero() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 16).await;
    let numbers = "return document.querySelector('.lesson-body > .printed [data-item=\"003.chain\"]').textContent";
    let drawn = page.ask(numbers).await.as_str().unwrap().to_owned();
    assert!(
        drawn.contains("ψ″") && !drawn.contains("divides by zero"),
        "{drawn}"
    );
    page.click("lesson-show-equal").await;
    page.until("no number by the chain", async || {
        page.ask(numbers)
            .await
            .as_str()
            .unwrap()
            .matches("divides by zero")
            .count()
            == 2
    })
    .await;
    page.close().await;
}
