//! The front door: what a first visitor sees; lessons and mechanisms as pictures, found and
//! opened by mouse, keys and touch, in every language.

use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::access::{AXE, check};
use crate::browser::Page;
use crate::device::languages;
use crate::host::home;
use crate::layout::{SIZES, defects};

/// The page as a first visitor has it.
async fn first() -> Page {
    Page::visit(home(), "en-US").await
}

async fn open(page: &Page) {
    page.click("gallery").await;
    opened(page).await;
}

async fn opened(page: &Page) {
    page.until("lessons and mechanisms", async || {
        page.count("#gallery-dialog[open]").await == 1
    })
    .await;
    page.settle().await;
}

async fn closed(page: &Page) {
    page.until("the dialog to close", async || {
        page.count("#gallery-dialog").await == 0
    })
    .await;
}

/// The cards that are shown, by what follows `gallery-` in their ids.
async fn shown(page: &Page) -> Vec<String> {
    let cards = page
        .ask(
            "return [...document.querySelectorAll('.tile')].filter((tile) => tile.checkVisibility())
                .map(({ id }) => id.replace('gallery-', ''))",
        )
        .await;
    serde_json::from_value(cards).unwrap()
}

async fn search(page: &Page, query: &str) -> Vec<String> {
    let field = page.element("gallery-search").await;
    field.clear().await.unwrap();
    field.send_keys(query).await.unwrap();
    page.settle().await;
    shown(page).await
}

async fn visible(page: &Page, id: &str) -> bool {
    page.element(id).await.is_displayed().await.unwrap()
}

#[tokio::test]
async fn a_first_visitor_is_told_what_this_is() {
    let page = first().await;
    for size in [(1280, 800), (360, 740)] {
        page.screen(size, 1.0).await;
        assert!(page.text("welcome").await.contains("First lesson"));
        // All of the drawing is on the screen, and under nothing.
        let free = page
            .ask(
                "const { left, right, top, bottom } = document.getElementById('mechanism').getBoundingClientRect();
                const middle = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
                return [top >= 0 && bottom <= innerHeight && right <= innerWidth, middle.id]",
            )
            .await;
        assert_eq!(free, json!([true, "mechanism"]), "{size:?}");
    }
    page.click("welcome-close").await;
    assert!(!visible(&page, "welcome").await);
    assert_eq!(page.focused().await.as_deref(), Some("gallery"));
    page.anew(home()).await;
    assert!(!visible(&page, "welcome").await);
    page.close().await;

    // Who follows a link was sent to what it shows.
    let page = first().await;
    page.stop_at("33").await;
    page.until("the address", async || page.address().await.contains('#'))
        .await;
    let link = page.address().await;
    page.anew(&link).await;
    assert!(!visible(&page, "welcome").await);
    page.close().await;
}

#[tokio::test]
async fn a_first_visitor_begins_a_lesson() {
    let page = first().await;
    page.click("welcome-lesson").await;
    page.until("the lesson", async || {
        page.count("#lesson-check").await == 1
    })
    .await;
    page.settle().await;
    assert!(!visible(&page, "welcome").await);
    assert_eq!(page.text("mechanism-name").await, "Mixer, case a");
    assert_eq!(page.focused().await.as_deref(), Some("lesson-title"));
    page.close().await;
}

/// Pixels of each picture that are drawn on, by the ids of the cards.
async fn drawn(page: &Page) -> Vec<(String, f64)> {
    page.until("the pictures", async || {
        page.count("#gallery-dialog canvas:not([data-drawn])").await == 0
    })
    .await;
    let counts = page
        .ask(
            "return [...document.querySelectorAll('.tile')].map((tile) => {
                const canvas = tile.querySelector('canvas');
                const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
                copy.drawImage(canvas, 0, 0);
                const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
                let count = 0;
                for (let i = 3; i < data.length; i += 4) if (data[i] > 0) count += 1;
                return [tile.id, count / (canvas.width * canvas.height)];
            })",
        )
        .await;
    serde_json::from_value(counts).unwrap()
}

#[tokio::test]
async fn every_card_has_its_picture() {
    let page = Page::open().await;
    // All of them are in view at once.
    page.screen((1280, 4700), 2.0).await;
    open(&page).await;
    // The dialog itself is no higher than on any screen.
    page.ask("document.querySelector('.dialog.gallery').style.height = '4600px'")
        .await;
    for (id, part) in drawn(&page).await {
        assert!((0.01..0.9).contains(&part), "{id}: {part}");
    }
    let ids: Vec<String> = shown(&page).await;
    let mut expected: Vec<String> = assur_file::catalogue()
        .chain(assur_file::schemes())
        .chain(assur_file::trains())
        .chain(assur_file::tasks())
        .map(str::to_owned)
        .collect();
    let lessons = ids
        .iter()
        .take_while(|id| id.starts_with("lesson-"))
        .count();
    assert!(lessons >= 2);
    let mut mechanisms = ids[lessons..].to_vec();
    expected.sort();
    mechanisms.sort();
    assert_eq!(mechanisms, expected);
    let colours = "return document.querySelector('#gallery-watt-1 canvas').toDataURL()";
    let light = page.ask(colours).await;
    page.prefer("prefers-color-scheme", "dark").await;
    page.settle().await;
    assert_ne!(page.ask(colours).await, light);
    page.close().await;
}

#[tokio::test]
async fn mechanisms_are_found() {
    let page = Page::open().await;
    open(&page).await;
    assert_eq!(search(&page, "jans").await, ["jansen"]);
    let third = search(&page, "class III").await;
    assert!(third.contains(&"class3-platform".to_owned()), "{third:?}");
    assert!(!third.contains(&"class5".to_owned()), "{third:?}");
    assert_eq!(search(&page, "scotch").await, ["scotch-yoke"]);
    // By what they are good for, too.
    assert_eq!(search(&page, "lifts oil").await, ["pump-jack"]);
    assert_eq!(search(&page, "perpetuum").await, [""; 0]);
    assert!(page.text("gallery-none").await.contains("perpetuum"));
    page.click("gallery-close").await;
    closed(&page).await;
    // In the language of the page, in English, by the number of the class.
    page.speak("ru").await;
    open(&page).await;
    assert_eq!(search(&page, "Янсена").await, ["jansen"]);
    assert_eq!(search(&page, "jansen leg").await, ["jansen"]);
    let fifth = search(&page, "5 класс").await;
    assert_eq!(fifth, ["class5"]);
    let lessons = search(&page, "урок выстой").await;
    assert_eq!(lessons, ["lesson-class4-dwell"]);
    // Enter opens the first that is left.
    assert_eq!(search(&page, "кланна").await, ["klann"]);
    page.press("gallery-search", Key::Enter).await;
    closed(&page).await;
    page.until("the mechanism", async || {
        page.text("mechanism-name").await.contains("Кланна")
    })
    .await;
    page.close().await;
}

#[tokio::test]
async fn the_gallery_goes_by_keys() {
    let page = Page::open().await;
    page.focus("play").await;
    page.keys("g").await;
    opened(&page).await;
    let focused = async || page.focused().await.unwrap();
    let cards = shown(&page).await;
    assert_eq!(focused().await, format!("gallery-{}", cards[0]));
    page.keys(Key::Right + "").await;
    assert_eq!(focused().await, format!("gallery-{}", cards[1]));
    page.keys(Key::Home + "").await;
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "gallery-lesson-mobility");
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "gallery-lesson-mixer-forces");
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "gallery-crank-rocker");
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "gallery-antiparallelogram");
    page.keys(Key::Up + "").await;
    page.keys(Key::Up + "").await;
    page.keys(Key::Up + "").await;
    page.keys(Key::Up + "").await;
    page.keys(Key::Up + "").await;
    assert_eq!(focused().await, "gallery-search");
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, format!("gallery-{}", cards[0]));
    page.keys(Key::End + "").await;
    assert_eq!(focused().await, "gallery-mobility-4");
    page.keys(Key::Escape + "").await;
    closed(&page).await;
    assert_eq!(focused().await, "play");
    page.focus("gallery").await;
    page.keys(Key::Enter + "").await;
    opened(&page).await;
    page.keys(Key::End + "").await;
    page.keys(Key::Enter + "").await;
    closed(&page).await;
    assert_eq!(focused().await, "gallery");
    page.until("the mechanism", async || {
        page.text("mechanism-name").await == "Class IV mechanism, moving contour"
    })
    .await;
    page.close().await;
}

/// A finger on the middle of an element.
async fn tap(page: &Page, id: &str) {
    let area = page.element(id).await.rect().await.unwrap();
    page.fingers(id, &[vec![(0.5 * area.width, 0.5 * area.height)]])
        .await;
    page.settle().await;
}

#[tokio::test]
async fn a_lesson_is_tapped_and_stands_where_the_eye_is() {
    let page = Page::open().await;
    page.touched().await;
    page.screen((360, 740), 2.0).await;
    tap(&page, "gallery").await;
    opened(&page).await;
    assert_eq!(defects(&page, 44).await, json!([]));
    tap(&page, "gallery-lesson-mixer").await;
    page.until("the lesson", async || {
        page.count("#lesson-check").await == 1
    })
    .await;
    page.until("the lesson on the screen", async || {
        let place = "const { top, bottom } = document.getElementById('lesson-title').getBoundingClientRect();
            const { bottom: above } = document.querySelector('.transport').getBoundingClientRect();
            return top >= above - 1 && bottom <= innerHeight";
        page.ask(place).await == json!(true)
    })
    .await;
    page.close().await;
}

/// The first view and the gallery, in every language on every screen; what axe finds.
#[tokio::test]
async fn the_front_door_is_well_laid_out() {
    let page = first().await;
    page.stop_at("75").await;
    page.ask(AXE).await;
    let mut found: Vec<(String, Value)> = Vec::new();
    for lang in languages(1) {
        page.speak(lang).await;
        // The menu stays open if the language was spoken already.
        page.ask("document.querySelector('details.menu[open] > summary')?.click()")
            .await;
        check(&page, &format!("{lang} first visit")).await;
        for size in SIZES {
            page.screen(size, 1.0).await;
            found.push((format!("{lang} {size:?}"), defects(&page, 0).await));
            open(&page).await;
            found.push((format!("{lang} {size:?} gallery"), defects(&page, 0).await));
            page.click("gallery-close").await;
            closed(&page).await;
        }
        open(&page).await;
        check(&page, &format!("{lang} gallery")).await;
        page.prefer("prefers-color-scheme", "dark").await;
        check(&page, &format!("{lang} dark gallery")).await;
        page.prefer("prefers-color-scheme", "light").await;
        page.click("gallery-close").await;
        closed(&page).await;
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// Opens a mechanism, of whose name a part is known.
async fn take(page: &Page, id: &str, name: &str) {
    open(page).await;
    page.click(&format!("gallery-{id}")).await;
    closed(page).await;
    page.until(name, async || {
        page.text("mechanism-name").await.contains(name)
            && page.count("#out-formula").await == 1
            && !page.text("out-formula").await.is_empty()
    })
    .await;
    page.settle().await;
}

/// The names of links are in the language of the page, wherever they stand.
#[tokio::test]
async fn links_are_called_in_the_language_of_the_page() {
    let page = Page::open().await;
    page.stop_at("40").await;
    page.speak("ru").await;
    take(&page, "slider-crank", "ползунный").await;
    let formula = page.text("out-formula").await;
    assert_eq!(formula, "I(стойка,кривошип) → II₂(шатун,ползун)");
    assert!(page.text("plot").await.contains("шатун"));
    assert!(page.text("driver").await.contains("кривошип"));
    assert!(page.text("linkage-lengths").await.contains("шатун"));
    take(&page, "klann", "Кланна").await;
    assert!(page.text("out-formula").await.contains("нижнее коромысло"));
    // The document keeps its own.
    page.until("what is kept", async || {
        let kept = page.ask("return localStorage.getItem('assur.state')").await;
        kept.as_str()
            .is_some_and(|kept| kept.contains("lower rocker"))
    })
    .await;
    page.close().await;
}
