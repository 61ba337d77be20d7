//! Lessons that lecturers write: written, given away by a link, answered, checked; bad ones.

use std::fs;

use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

pub(crate) async fn at_jansen() -> Page {
    let url = format!("{}#jansen&v.playing=false&v.phi_deg=30", home());
    Page::open_at(&url, "en-US").await
}

pub(crate) async fn begin(page: &Page) {
    page.click("menu").await;
    page.click("write-lesson").await;
    there(page, "write-title").await;
}

pub(crate) async fn there(page: &Page, id: &str) {
    let selector = format!("#{id}");
    page.until(id, async || page.count(&selector).await == 1)
        .await;
    page.settle().await;
}

/// Types into a field of the form, which Enter would leave as it is in a text of several lines.
pub(crate) async fn fill(page: &Page, id: &str, text: &str) {
    let field = page.element(id).await;
    field.scroll_into_view().await.unwrap();
    field.click().await.unwrap();
    field.send_keys(Key::Control + "a").await.unwrap();
    field.send_keys(Key::Backspace + text).await.unwrap();
    page.settle().await;
}

pub(crate) async fn press(page: &Page, id: &str) {
    page.element(id).await.scroll_into_view().await.unwrap();
    page.click(id).await;
}

/// The address, once it holds what the page shows.
async fn link(page: &Page, part: &str) -> String {
    page.until("the address", async || page.address().await.contains(part))
        .await;
    page.address().await
}

async fn verdict(page: &Page) -> String {
    page.attribute("lesson-said", "data-verdict").await.unwrap()
}

pub(crate) async fn answer(page: &Page, text: &str) -> String {
    page.write("lesson-answer", text).await;
    verdict(page).await
}

/// The rows of the table of results, cells with a bar between them, once all codes are judged.
async fn table(page: &Page) -> Vec<String> {
    let codes = page.written("write-codes").await.lines().count();
    page.until("all rows", async || {
        page.count("#write-table tbody tr").await == codes
    })
    .await;
    let script = "return [...document.querySelectorAll('#write-table tbody tr')]
        .map((row) => [...row.cells].map(({ textContent }) => textContent).join('|'))";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The three kinds of question, a dimension that varies, in the form; then as a student from the link alone, and back with the code.
#[tokio::test]
async fn a_lesson_is_written_answered_and_its_result_checked() {
    let page = at_jansen().await;
    begin(&page).await;
    fill(&page, "write-title", "Legs").await;
    fill(&page, "write-author", "A. Lecturer").await;
    fill(&page, "write-step_title", "The foot").await;
    fill(&page, "write-text", "Read *x* of the <b>foot</b>.").await;
    page.choose("write-sort", "number").await;
    page.choose("write-quantity", "input").await;
    fill(&page, "write-asked", "Where is the crank?").await;
    fill(&page, "write-at", "40").await;
    fill(&page, "write-within", "0,5").await;
    assert!(page.text("write-now").await.contains("40"));
    // What is no number is said, and what there was stays.
    fill(&page, "write-within", "half").await;
    assert!(page.text("write-said").await.contains("number"));
    fill(&page, "write-within", "0.5").await;
    assert_eq!(page.text("write-said").await, "");

    press(&page, "write-add").await;
    fill(&page, "write-step_title", "Class").await;
    page.choose("write-sort", "choice").await;
    fill(&page, "write-options", "II\nIII\nIV").await;
    page.choose("write-right", "1").await;
    fill(&page, "write-hint", "Count again.").await;

    press(&page, "write-add").await;
    fill(&page, "write-step_title", "Turn").await;
    page.choose("write-sort", "reach").await;
    page.choose("write-quantity", "input").await;
    fill(&page, "write-target", "90").await;
    fill(&page, "write-within", "2").await;
    assert!(page.text("write-progress").await.contains("Step 3 of 3"));
    assert!(page.text("write-shown").await.contains("Jansen"));
    // A step of undo is one of the form.
    press(&page, "write-remove").await;
    assert!(page.text("write-progress").await.contains("of 2"));
    page.click("undo").await;
    assert!(page.text("write-progress").await.contains("of 3"));
    page.click("write-back").await;
    page.click("write-back").await;
    let link = link(&page, "%22step%22%3A1%7D").await;

    // A student elsewhere.
    page.ask("localStorage.clear()").await;
    page.anew(&link).await;
    there(&page, "lesson-title").await;
    assert_eq!(page.text("lesson-name").await, "Legs");
    assert_eq!(page.text("lesson-title").await, "The foot");
    assert_eq!(page.count(".lesson-text b").await, 0);
    assert_eq!(page.count(".lesson-text em").await, 1);
    page.write("lesson-reader", "Ann Lee").await;
    assert_eq!(answer(&page, "41").await, "not_yet");
    assert_eq!(answer(&page, "forty").await, "unread");
    assert_eq!(answer(&page, "40,4").await, "right");
    page.click("lesson-on").await;
    page.click("lesson-check").await;
    assert_eq!(verdict(&page).await, "unanswered");
    page.click("lesson-0").await;
    page.click("lesson-check").await;
    page.click("lesson-check").await;
    assert_eq!(verdict(&page).await, "not_yet");
    assert!(page.text("lesson-said").await.contains("Count again."));
    page.click("lesson-on").await;
    assert_eq!(page.count("#lesson-check:not([hidden])").await, 0);
    assert_eq!(verdict(&page).await, "");
    // Another mechanism at that place is no answer.
    page.click("gallery").await;
    there(&page, "gallery-crank-rocker").await;
    page.click("gallery-crank-rocker").await;
    page.stop_at("91").await;
    assert_eq!(verdict(&page).await, "");
    page.click("undo").await;
    page.stop_at("91").await;
    page.until("it to be reached", async || verdict(&page).await == "right")
        .await;
    let code = page.written("lesson-code").await;
    // Another student gives up.
    page.write("lesson-reader", "Bo").await;
    page.click("lesson-back").await;
    page.click("lesson-reveal").await;
    assert!(page.text("lesson-said").await.contains("The answer: III."));
    page.click("lesson-1").await;
    page.click("lesson-check").await;
    assert_eq!(verdict(&page).await, "right");
    let shown = page.written("lesson-code").await;
    // The answers are in the form, which a student's copy does not offer.
    assert_eq!(page.count("#lesson-write").await, 0);

    // The lecturer checks it, beside one that is damaged and what is none.
    page.click("menu").await;
    page.click("write-lesson").await;
    there(&page, "write-class").await;
    press(&page, "write-class").await;
    let damaged = code.replacen('.', ".A", 1);
    let codes = format!("{code}\n{damaged}\nhello\n{shown}");
    fill(&page, "write-codes", &codes).await;
    let rows = table(&page).await;
    assert_eq!(rows[0], "Ann Lee|✓ 40,4 (2)|✗ II (1)|✓ (1)|2 of 3");
    assert_eq!(rows[3], "Bo|–|◇|✓ (1)|1 of 3");
    assert!(
        rows[1].contains("Line 2") && rows[2].contains("Line 3"),
        "{rows:?}"
    );
    // Of a lesson that is another now it is told.
    fill(&page, "write-title", "Other legs").await;
    let rows = table(&page).await;
    assert!(
        rows[0].contains("Ann Lee") && rows[0].contains("another lesson"),
        "{rows:?}"
    );
    page.close().await;
}

/// A lesson that shows the linkage of the address with its first dimension varied, and asks where a point is then.
pub(crate) async fn varied(page: &Page) -> Value {
    page.wait_for(
        "const done = arguments[0];
        const preset = 'jansen';
        window.eval(\"import('assur/pkg/assur_web.js')\").then(({ catalogue, Simulator }) => {
            const { kind, document } = catalogue().find(({ id }) => id === preset);
            const lesson = { title: 'Own numbers', steps: [{
                title: 'Crank', text: 'With *your* crank.',
                shows: { kind, document, view: { phi_deg: 30 }, vary: [{ field: 'links[0].length', from: 12, to: 18, step: 0.5 }] },
                question: { text: 'y of B?', number: { quantity: document.points.find(({ name }) => document.links[0].points.includes(name) && !document.frame.includes(name)).name + '.y', within: 0.001 } },
            }] };
            done({ format: 2, kind, document, lesson });
        })",
    )
    .await
}

/// Opens the lesson of a file once it has been read.
pub(crate) async fn open_tab(page: &Page) {
    page.until("a lesson", async || {
        page.count("html[data-taught='true']").await == 1
    })
    .await;
    page.click("tab-lesson").await;
}

pub(crate) async fn open_file(page: &Page, name: &str, text: &str) {
    let path = page.downloads().join(name);
    fs::write(&path, text).unwrap();
    page.choose_file("file", &path).await;
}

/// A name gives numbers of its own, always the same ones, that make a mechanism; the answer is theirs.
#[tokio::test]
async fn a_name_has_numbers_of_its_own() {
    let page = at_jansen().await;
    let state = varied(&page).await;
    open_file(&page, "own.json", &state.to_string()).await;
    open_tab(&page).await;
    there(&page, "lesson-reader").await;
    assert_eq!(page.text("notice-text").await, "");
    let mut lengths = Vec::new();
    for name in ["Ann", "Carl", "  aNN "] {
        page.write("lesson-reader", name).await;
        page.click("lesson-show").await;
        page.settle().await;
        let length = page.written("field-length-0").await;
        let value: f64 = length.parse().unwrap();
        assert!(
            (12.0..=18.0).contains(&value) && value * 2.0 == (value * 2.0).round(),
            "{length}"
        );
        // The crank's pin is l₁ sin 30° above its pivot.
        let exact = format!("{:.3}", value * 0.5);
        assert_eq!(answer(&page, &exact).await, "right", "{name} {exact}");
        assert_eq!(
            answer(&page, &format!("{}", value * 0.5 + 0.01)).await,
            "not_yet"
        );
        lengths.push(length);
    }
    assert_ne!(lengths[0], lengths[1]);
    assert_eq!(lengths[0], lengths[2]);

    // The sheets of the class have the same numbers.
    page.click("menu").await;
    page.click("write-lesson").await;
    there(&page, "write-class").await;
    press(&page, "write-class").await;
    page.until("what prints", async || {
        page.ask("return performance.getEntriesByName('printable').length")
            .await
            == 1
    })
    .await;
    page.ask("window.print = () => { dispatchEvent(new Event('beforeprint')); window.sheet = document.getElementById('worksheet').cloneNode(true); dispatchEvent(new Event('afterprint')); }")
        .await;
    fill(&page, "write-names", "Ann\nCarl").await;
    for (button, pictures) in [("write-print_tasks", 2), ("write-print_answers", 0)] {
        press(&page, button).await;
        let seen = page
            .ask("return [sheet.querySelectorAll('.sheet').length, sheet.querySelectorAll('figure svg').length, [...sheet.querySelectorAll('.own')].map(({ textContent }) => Number(textContent.split('=')[1]))]")
            .await;
        let own: Vec<f64> = lengths[..2]
            .iter()
            .map(|one| one.parse().unwrap())
            .collect();
        assert_eq!(seen[0], json!(2));
        assert_eq!(seen[1], json!(pictures));
        let printed: Vec<f64> = serde_json::from_value(seen[2].clone()).unwrap();
        assert_eq!(printed, own);
    }
    page.close().await;
}

/// Markup in a lesson is text, and nothing of it gets into the page.
#[tokio::test]
async fn markup_in_a_lesson_is_text() {
    let page = at_jansen().await;
    let mut state = varied(&page).await;
    let evil = "<img src=x onerror='window.hurt = 1'>";
    let step = &mut state["lesson"]["steps"][0];
    for part in ["title", "text", "formula"] {
        step[part] = json!(evil);
    }
    step["question"] =
        json!({ "text": evil, "hint": evil, "choice": { "options": [evil, "b"], "answer": 1 } });
    state["lesson"]["title"] = json!(evil);
    state["lesson"]["author"] = json!(evil);
    open_file(&page, "evil.json", &state.to_string()).await;
    open_tab(&page).await;
    there(&page, "lesson-reader").await;
    for id in ["lesson-name", "lesson-title", "lesson-question"] {
        assert_eq!(page.text(id).await, evil);
    }
    page.click("lesson-0").await;
    page.click("lesson-check").await;
    assert!(page.text("lesson-said").await.contains(evil));
    page.write("lesson-reader", evil).await;
    page.click("menu").await;
    page.click("write-lesson").await;
    there(&page, "write-title").await;
    assert_eq!(page.written("write-title").await, evil);
    assert_eq!(
        page.ask("return [document.images.length, window.hurt ?? null]")
            .await,
        json!([0, null])
    );
    page.close().await;
}

/// What is no lesson says so by its place; the mechanism and the lesson that were there stay.
#[tokio::test]
async fn a_damaged_lesson_leaves_what_was_there() {
    let page = at_jansen().await;
    let good = varied(&page).await;
    open_file(&page, "good.json", &good.to_string()).await;
    open_tab(&page).await;
    there(&page, "lesson-title").await;
    for (pointer, value, said) in [
        ("/lesson/title", json!(7), "lesson.title"),
        (
            "/lesson/steps/0/shows/document/links",
            json!([]),
            "In step 1 of the lesson",
        ),
    ] {
        let mut bad = good.clone();
        *bad.pointer_mut(pointer).unwrap() = value;
        open_file(&page, "bad.json", &bad.to_string()).await;
        page.until(pointer, async || {
            page.text("notice-text").await.contains(said)
        })
        .await;
        assert!(page.text("notice-text").await.contains("bad.json"));
        assert_eq!(page.text("lesson-title").await, "Crank");
        page.click("notice-close").await;
    }
    page.close().await;
}
