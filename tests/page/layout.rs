//! The layout from a phone to a large screen, in every language and at every pixel ratio.

use assur_tests::files::source;
use roxmltree::Document;
use serde_json::{Value, json};

use crate::browser::Page;
use crate::device::{LANGUAGES, languages};
use crate::export::{open_dialog, save_text};
use crate::gallery::open;

pub(crate) const SIZES: [(u32, u32); 9] = [
    (360, 640),
    (740, 360),
    (600, 400),
    (390, 844),
    (768, 1024),
    (1024, 768),
    (1280, 800),
    (1440, 900),
    (1920, 1080),
];

/// Defects of the layout, in words; `least` is the side that every target must have.
const DEFECTS: &str = r#"
    const found = [];
    scrollTo(0, 0);
    const root = document.scrollingElement;
    if (root.scrollWidth > root.clientWidth) found.push(`scrolls sideways by ${root.scrollWidth - root.clientWidth}`);
    const name = (element) => element.id || element.textContent.trim() || element.className;
    // A dialog lies over the page.
    const shown = document.querySelector("dialog[open]") ?? document;
    const visible = (element) => element.checkVisibility() && !element.closest(".unseen") && element.id !== "scrubber-bar";
    // A choice is its whole label.
    const controls = [...new Set([...shown.querySelectorAll("button, select, input, summary, a[href]")]
        .filter(visible).map((control) => control.matches("[type=radio], [type=checkbox]") ? control.closest("label") : control))];

    // Boxes as far as the elements around them show them.
    const box = (element) => {
        let { left, right, top, bottom } = element.getBoundingClientRect();
        for (let around = element.parentElement; around; around = around.parentElement) {
            if (getComputedStyle(around).overflowY === "visible" || around === document.body) continue;
            const clip = around.getBoundingClientRect();
            [left, right] = [Math.max(left, clip.left), Math.min(right, clip.right)];
            [top, bottom] = [Math.max(top, clip.top), Math.min(bottom, clip.bottom)];
        }
        return { left, right, top, bottom, width: right - left, height: bottom - top };
    };

    // What a finger slides sideways by itself may go on beyond its window.
    const slid = (element) => element && (/auto|scroll/.test(getComputedStyle(element).overflowX) || slid(element.parentElement));

    for (const element of [...controls, ...shown.querySelectorAll("h1, h2, legend, th, td, dt, dd, .lesson, .name")]) {
        if (!visible(element)) continue;
        const { left, right } = element.getBoundingClientRect();
        if (slid(element)) continue;
        if (left < -0.5 || right > innerWidth + 0.5) found.push(`${name(element)} leaves the page`);
        if (element.matches("select")) {
            // A select cuts its text off without a word: an unhampered twin tells how wide it would be.
            const twin = element.cloneNode(false);
            twin.append(element.selectedOptions[0].cloneNode(true));
            twin.style.cssText = "position: absolute; visibility: hidden; width: max-content; flex: none; min-width: 0";
            element.after(twin);
            if (twin.offsetWidth > element.offsetWidth + 0.5) found.push(`${name(element)} cuts its entries: ${twin.offsetWidth} in ${element.offsetWidth}`);
            twin.remove();
        } else if (element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).display !== "inline") {
            found.push(`${name(element)} overflows: ${element.scrollWidth} in ${element.clientWidth}`);
        }
    }

    controls.forEach((one, index) => {
        const a = box(one);
        const whole = one.getBoundingClientRect();
        if (least > 0 && (whole.width < least - 0.5 || whole.height < least - 0.5)) {
            found.push(`${name(one)} is ${whole.width} by ${whole.height}`);
        }
        for (const other of controls.slice(index + 1)) {
            const b = box(other);
            const [across, down] = [Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)];
            // An open menu lies over the page.
            const menu = one.closest(".entries") !== other.closest(".entries");
            if (!menu && across > 0.5 && down > 0.5 && !one.contains(other) && !other.contains(one)) found.push(`${name(one)} covers ${name(other)}`);
        }
    });

    const stage = document.getElementById("mechanism").getBoundingClientRect();
    const plots = document.getElementById("charts").getBoundingClientRect();
    if (stage.width < 280 || stage.height < 200) found.push(`the drawing has ${stage.width} by ${stage.height}`);
    const still = document.documentElement.dataset.still === "true";
    if (still && plots.width > 0) found.push("plots of what does not move");
    // While one draws, they come if they are wanted.
    const folded = document.documentElement.dataset.drawing === "true" && innerWidth >= 960;
    if (!still && !folded && (plots.width < 300 || plots.height < 330)) found.push(`the plots have ${plots.width} by ${plots.height}`);
    return found;
"#;

pub(crate) async fn defects(page: &Page, least: u32) -> Value {
    page.ask(&format!("const least = {least};{DEFECTS}")).await
}

#[tokio::test]
async fn layout_is_right_on_every_screen() {
    let page = Page::open().await;
    page.stop_at("217.15").await;
    // Long numbers, and all there is to show.
    page.write("field-l2", "0.8512345").await;
    let mut found = Vec::new();
    for lang in languages(0) {
        page.speak(lang).await;
        for size in SIZES {
            page.screen(size, 1.0).await;
            found.push((format!("{lang} {size:?}"), defects(&page, 0).await));
            page.click("projector").await;
            found.push((
                format!("{lang} {size:?} projector"),
                defects(&page, 0).await,
            ));
            page.click("projector").await;
            page.click("tab-lesson").await;
            page.until("the lesson", async || {
                page.count("#lesson-check").await == 1
            })
            .await;
            found.push((format!("{lang} {size:?} lesson"), defects(&page, 0).await));
            page.click("tab-settings").await;
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// A linkage with all that can be shown of it: its equations, groups in colours, the
/// misprints.
#[tokio::test]
async fn layout_of_a_linkage() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("217.15").await;
    page.click("groups").await;
    page.ask("document.getElementById('equations').open = true")
        .await;
    let mut found = Vec::new();
    for lang in languages(0) {
        page.speak(lang).await;
        for size in SIZES {
            page.screen(size, 1.0).await;
            found.push((format!("{lang} {size:?}"), defects(&page, 0).await));
        }
        page.choose("equations-order", "2").await;
        page.screen((360, 640), 1.0).await;
        found.push((format!("{lang} derivatives"), defects(&page, 0).await));
        page.choose("equations-order", "0").await;
        page.click("tab-lesson").await;
        page.until("the lesson", async || {
            page.count("#lesson-check").await == 1
        })
        .await;
        // It opens again where it was left.
        for _ in if lang == LANGUAGES[0] { 1..9 } else { 9..9 } {
            page.click("lesson-on").await;
        }
        found.push((format!("{lang} lesson"), defects(&page, 0).await));
        page.screen((1280, 800), 1.0).await;
        page.click("tab-settings").await;
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// The longest words that the mixer has, those of a linkage without a full turn, and every step of the lessons on it and on
/// the Class IV mechanism, on the narrowest screen. The other lessons have such a test of their own.
#[tokio::test]
async fn the_longest_words_have_room() {
    let page = Page::open().await;
    page.stop_at("75").await;
    for (field, length) in [("l1", "0.6"), ("l2", "0.7"), ("l3", "0.8"), ("l4", "1")] {
        page.write(&format!("field-{field}"), length).await;
    }
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in languages(1) {
        page.speak(lang).await;
        let table = source(&format!("lang/{lang}.json"));
        let words: Value = serde_json::from_str(&table).unwrap();
        let longest = words["grashof.triple_rocker"].as_str().unwrap();
        assert!(page.text("status").await.contains(longest), "{lang}");
        found.push((lang.to_owned(), defects(&page, 0).await));
    }
    for lesson in ["mixer", "class4-dwell"] {
        let script = source(&format!("www/lessons/{lesson}/lesson.js"));
        let steps = script.matches("    id: \"").count();
        page.click("gallery").await;
        let button = format!("gallery-lesson-{lesson}");
        page.until("the gallery", async || {
            page.count(&format!("#{button}")).await == 1
        })
        .await;
        page.click(&button).await;
        page.until("the lesson", async || {
            page.count("#lesson-check").await == 1
        })
        .await;
        for lang in languages(2) {
            page.speak(lang).await;
            for step in 1..=steps {
                let at = format!("{lang} {lesson} {step}");
                found.push((at, defects(&page, 0).await));
                if step < steps {
                    page.click("lesson-on").await;
                }
            }
            for _ in 1..steps {
                page.click("lesson-back").await;
            }
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

#[tokio::test]
async fn fingers_find_large_targets() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.touched().await;
    let mut found = Vec::new();
    for lang in languages(3) {
        page.speak(lang).await;
        for size in SIZES {
            page.screen(size, 1.0).await;
            let coarse = page.ask("return matchMedia('(pointer: coarse)').matches");
            assert_eq!(coarse.await, json!(true));
            found.push((format!("{lang} {size:?}"), defects(&page, 44).await));
        }
        page.click("menu").await;
        found.push((format!("{lang} menu"), defects(&page, 44).await));
        page.click("menu").await;
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// The settings of a low window go on below its edge: what is cut off is told by a fade,
/// and the last of them can be scrolled to.
#[tokio::test]
async fn settings_scroll_to_the_last() {
    let page = Page::open().await;
    page.screen((1280, 600), 1.0).await;
    let faded = "const rail = document.getElementById('rail');
        return rail.scrollHeight > rail.clientHeight
            && getComputedStyle(rail, '::after').backgroundImage.includes('gradient')";
    assert_eq!(page.ask(faded).await, json!(true));
    page.click("transmission").await; // scrolls there, as a person would
    assert!(
        page.element("transmission")
            .await
            .is_selected()
            .await
            .unwrap()
    );
    page.close().await;
}

/// A small drawing has smaller labels, and leaves out those that have no room. Its
/// picture says the same.
#[tokio::test]
async fn a_small_drawing_is_saved_as_it_is_shown() {
    let page = Page::open().await;
    page.screen((360, 640), 1.0).await;
    page.stop_at("75").await;
    page.ask(
        "const kind = CanvasRenderingContext2D.prototype;
        const { fillText } = kind;
        window.shown = [];
        kind.fillText = function (text, ...place) {
            if (this.canvas.id === 'mechanism' && this.font.startsWith('600 ')) window.shown.push([text, Number.parseFloat(this.font.slice(4))]);
            fillText.call(this, text, ...place);
        };",
    )
    .await;
    page.click("zoom-fit").await;
    let shown: Vec<(String, f64)> =
        serde_json::from_value(page.ask("return window.shown").await).unwrap();
    open_dialog(&page).await;
    let svg = save_text(&page, "export-drawing-svg", "assur-mixer-a-drawing.svg").await;
    let svg = Document::parse(&svg).unwrap();
    let saved = svg.descendants().filter(|element| {
        let halo = element.attribute("aria-hidden").is_some();
        element.attribute("font-weight") == Some("600") && !halo
    });
    let saved: Vec<(String, f64)> = saved
        .map(|label| {
            let size = label.attribute("font-size").unwrap().parse().unwrap();
            (label.text().unwrap().to_owned(), size)
        })
        .collect();
    assert!(saved.iter().any(|(text, _)| text == "A"), "{saved:?}");
    // What was drawn once; it may have been drawn anew since.
    assert_eq!(saved, shown[..saved.len()]);
    assert_eq!(shown.len() % saved.len(), 0, "{shown:?} {saved:?}");
    page.close().await;
}

#[tokio::test]
async fn fields_are_in_line_and_buttons_of_a_lesson_whole() {
    let page = Page::open().await;
    page.element("field-z4").await;
    let right = "arguments[0](['field-z4', 'field-z5', 'field-beta5'].map((id) => document.getElementById(id).getBoundingClientRect().right))";
    let edges = page.numbers(right).await;
    assert!(
        edges.iter().all(|edge| (edge - edges[0]).abs() < 0.5),
        "{edges:?}"
    );
    page.click("menu").await;
    page.click("write-lesson").await;
    page.element("write-read").await;
    let tall = "arguments[0](['write-read', 'write-add'].map((id) => document.getElementById(id).getBoundingClientRect().height))";
    let tall = page.numbers(tall).await;
    assert!(tall[0] >= tall[1], "{tall:?}");
    page.close().await;
}
