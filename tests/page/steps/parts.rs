//! Parts of the page within a step, in every language.

use super::*;

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
