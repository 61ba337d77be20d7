//! The lesson's steps: opened, walked through and answered by mouse, by keys and by
//! touch; what is right is what the engine, run natively, says of the mechanism.

use assur::mixer::{Case, Mixer};
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
    let swing = c.linkage.swings(c.assembly)[0].scaled(c.gears.pairs()[0].ratio());
    let slow = a.linkage.time_ratio(a.assembly).unwrap();
    let numbers = [
        ((a.graph().links - 1) as f64, 0.0),
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

#[tokio::test]
async fn by_keys_alone() {
    let page = Page::open().await;
    let focused = async || {
        let id = page.ask("return document.activeElement.id").await;
        id.as_str().unwrap().to_owned()
    };
    page.keys("l").await;
    loaded(&page).await;
    assert_eq!(focused().await, "lesson-title");
    let told = page.attribute("tab-lesson", "aria-keyshortcuts").await;
    assert_eq!(told.as_deref(), Some("L"));
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-show");
    page.keys(Key::Enter + "").await;
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-paper-name");
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-answer");
    // The field has its letters.
    page.keys("l").await;
    assert_eq!(page.written("lesson-answer").await, "l");
    assert!(visible(&page, "lesson").await);
    page.keys(Key::Backspace + "4").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(verdict(&page).await, "right");
    assert_eq!(
        page.attribute("lesson-said", "role").await.as_deref(),
        Some("status")
    );

    // Over the check to the button that goes on; at the end its twin has the focus.
    page.keys(Key::Tab + "").await;
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-on");
    for _ in 1..=STEPS {
        page.keys(" ").await;
    }
    assert!(
        page.text("lesson-progress")
            .await
            .contains("End of the lesson")
    );
    assert_eq!(focused().await, "lesson-back");
    for _ in 6..=STEPS {
        page.keys(" ").await;
    }
    assert!(page.text("lesson-progress").await.contains("Step 6"));
    // Opened anew it begins with its title. Tab: the two cases, the choices by arrows, the check.
    page.keys("l").await;
    page.keys("l").await;
    assert_eq!(focused().await, "lesson-title");
    for _ in 0..3 {
        page.keys(Key::Tab + "").await;
    }
    page.keys(" ").await;
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "lesson-on_frame");
    page.keys(Key::Enter + "").await;
    assert_eq!(verdict(&page).await, "right");
    page.keys("l").await;
    assert!(!visible(&page, "lesson").await);
    assert_eq!(focused().await, "tab-lesson");
    page.close().await;
}

#[tokio::test]
async fn by_touch() {
    let page = Page::open().await;
    let tap = async |id: &str| {
        page.ask(&format!(
            "document.getElementById('{id}').scrollIntoView({{ block: 'center' }})"
        ))
        .await;
        page.fingers(id, &[vec![(12.0, 12.0)]]).await;
    };
    tap("tab-lesson").await;
    loaded(&page).await;
    tap("lesson-on").await;
    assert!(page.text("lesson-progress").await.contains("Step 2"));
    tap("lesson-show").await;
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("false")
    );
    tap("lesson-answer").await;
    page.keys("-2").await;
    tap("lesson-check").await;
    assert_eq!(verdict(&page).await, "right");
    tap("tab-settings").await;
    assert!(visible(&page, "rail").await);
    page.close().await;
}

/// On a phone the lesson lies far below: it opens where the eye is, and so is what is
/// said of an answer, not under the drawing that stays.
#[tokio::test]
async fn on_a_phone_it_is_seen() {
    let page = Page::open().await;
    page.screen((390, 844), 2.0).await;
    let seen = async |id: &str| {
        let script = format!(
            "const {{ left, right, top, bottom }} = document.getElementById('{id}').getBoundingClientRect();
             const at = (x, y) => document.elementFromPoint(x, y)?.closest('#{id}');
             return Boolean(at((left + right) / 2, top + 4) && at((left + right) / 2, bottom - 4));"
        );
        page.settle().await;
        page.ask(&script).await == json!(true)
    };
    page.keys("l").await;
    loaded(&page).await;
    assert!(seen("lesson-title").await);
    page.write("lesson-answer", "40").await;
    page.click("lesson-check").await;
    assert!(seen("lesson-said").await);
    assert_eq!(verdict(&page).await, "not_yet");
    // Another step begins where the eye is.
    page.click("lesson-on").await;
    assert!(seen("lesson-title").await);
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

/// Words of the lesson and forms of nouns in every language, as the browser's plural
/// rules have them.
#[tokio::test]
async fn in_every_language() {
    let page = Page::open_at(home(), "ru").await;
    page.stop_at("75").await;
    open(&page).await;
    assert_eq!(answer(&page, "4").await, "right");
    for (lang, title, solved, teeth, wheel) in [
        (
            "ru",
            "Машина и её части",
            "1 верный ответ",
            ["21 зуб", "22 зуба", "25 зубьев"],
            "колесо 5: угол",
        ),
        (
            "uk",
            "Машина та її частини",
            "1 правильна відповідь",
            ["21 зубець", "22 зубці", "25 зубців"],
            "колесо 5: кут",
        ),
        (
            "kk",
            "Машина және оның бөліктері",
            "1 дұрыс жауап",
            ["21 тіс", "22 тіс", "25 тіс"],
            "5-доңғалақ бұрышы",
        ),
        (
            "en",
            "The machine and its parts",
            "1 right answer",
            ["21 teeth", "22 teeth", "25 teeth"],
            "angle of wheel 5",
        ),
    ] {
        page.choose("lang", lang).await;
        page.until("its words", async || {
            page.text("lesson-title").await == title
        })
        .await;
        assert!(
            page.text("lesson-progress").await.contains(solved),
            "{lang}"
        );
        for text in teeth {
            let count = text.split(' ').next().unwrap();
            page.click("tab-settings").await;
            page.write("field-z5", count).await;
            let said = page.attribute("slider-z5", "aria-valuetext").await;
            assert_eq!(said.as_deref(), Some(text), "{lang}");
        }
        // A number in the name of a link is said once.
        let option = "return document.querySelector('#plot [value=\"wheel5.angle\"]').textContent";
        assert_eq!(page.ask(option).await.as_str(), Some(wheel), "{lang}");
        page.click("tab-lesson").await;
        assert_eq!(answer(&page, "4").await, "right");
        let rules =
            format!("return new Intl.PluralRules('{lang}').resolvedOptions().pluralCategories");
        let rules = page.ask(&rules).await;
        let mut rules: Vec<&str> = rules
            .as_array()
            .unwrap()
            .iter()
            .map(|one| one.as_str().unwrap())
            .collect();
        rules.sort_unstable();
        let words = assur_tests::files::source(&format!("lang/{lang}.json"));
        let words: serde_json::Value = serde_json::from_str(&words).unwrap();
        let mut forms: Vec<&str> = words
            .as_object()
            .unwrap()
            .keys()
            .filter_map(|key| key.strip_prefix("wheels.teeth."))
            .collect();
        forms.sort_unstable();
        assert_eq!(forms, rules, "{lang}");
    }
    page.close().await;
}

/// What a step is about stands in the step: its controls move the mechanism, its read-outs
/// are those of the page; in the settings they are where they were.
#[tokio::test]
async fn a_step_has_what_it_asks_for() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let order = "return [...document.querySelectorAll('#rail [data-field]')].map((row) => row.dataset.field).join()";
    let before = page.ask(order).await;
    open(&page).await;
    turn_to(&page, 2).await;
    assert_eq!(page.count("#lesson [data-field='z4']").await, 1);
    assert_eq!(page.count("#rail [data-field='z4']").await, 0);
    let read = async |name: &str| {
        let script = format!("return document.querySelector('[data-out=\"{name}\"]').textContent");
        page.ask(&script).await.as_str().unwrap().to_owned()
    };
    page.write("field-z4", "54").await;
    page.click("mesh-internal").await;
    page.settle().await;
    for name in ["rocker.angle′", "wheel5.angle′"] {
        let shown = page.text(&format!("out-{name}")).await;
        assert_eq!(read(name).await, shown, "{name}");
    }
    assert_eq!(answer(&page, "3").await, "right");
    // Another step gives back what this one had.
    page.click("lesson-on").await;
    assert_eq!(page.count("#lesson [data-field='z4']").await, 0);
    page.click("lesson-back").await;
    page.click("tab-settings").await;
    assert_eq!(page.ask(order).await, before);
    // Coming back shows the step's own mechanism again; what was made of it is a step of undo away.
    assert_eq!(page.written("field-z4").await, "36");
    page.close().await;
}

/// What the page would tell is asked for: it does not, until the answer is given or asked
/// for; who does not see is told so, too.
#[tokio::test]
async fn answers_are_not_told_while_they_are_asked_for() {
    let page = Page::open().await;
    page.stop_at("75").await;
    open(&page).await;
    let hidden = async |id: &str| page.text(id).await.starts_with('?');
    assert!(!hidden("out-ratio").await);
    turn_to(&page, 2).await;
    page.settle().await;
    assert!(hidden("out-ratio").await && !hidden("out-time-ratio").await);
    assert_eq!(page.attribute("out-ratio", "data-value").await, None);
    let told = page
        .ask("return document.getElementById('out-ratio').textContent")
        .await;
    assert_eq!(told, json!("? hidden until you answer"));
    // Nor is it told of another mechanism, or in another language.
    page.click("lesson-show").await;
    page.speak("ru").await;
    page.settle().await;
    assert!(hidden("out-ratio").await);
    page.speak("en").await;
    assert_eq!(answer(&page, "-1").await, "not_yet");
    assert!(hidden("out-ratio").await);
    assert_eq!(answer(&page, "-2").await, "right");
    assert_eq!(page.text("out-ratio").await, "−2");
    assert!(!visible(&page, "lesson-reveal").await);

    page.click("lesson-on").await;
    page.click("lesson-on").await;
    page.settle().await;
    assert!(hidden("out-swing-wheel5").await);
    // The answer is given at the question, and counts as shown from then on.
    page.click("lesson-reveal").await;
    page.settle().await;
    assert!(!hidden("out-swing-wheel5").await);
    assert!(
        page.text("lesson-said")
            .await
            .contains("The answer: 43.952°")
    );
    assert_eq!(verdict(&page).await, "shown");
    let counted = "Step 4 of 10, 1 right answer, shown: 1";
    assert_eq!(page.text("lesson-progress").await, counted);
    assert_eq!(answer(&page, "43.95").await, "right");
    assert_eq!(page.text("lesson-progress").await, counted);
    page.click("lesson-on").await;
    page.settle().await;
    assert!(hidden("out-time-ratio").await);
    // Without the lesson everything is told.
    page.click("tab-settings").await;
    page.settle().await;
    assert!(!hidden("out-time-ratio").await);
    page.close().await;
}
