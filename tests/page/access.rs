//! For who does not see the page, or not well: what axe finds, what is said of
//! drawing and plots at rest, projector mode, reduced motion.

use assur::mixer::Case;
use assur::{Assembly, FourBar};
use serde_json::json;

use crate::browser::Page;
use crate::device::languages;
use crate::gallery::open;
use crate::host::home;
use crate::layout::defects;

pub(crate) const AXE: &str = include_str!("vendor/axe.min.js");

/// Opens all folds: axe looks only at what is seen.
const UNFOLD: &str = "for (const fold of document.querySelectorAll('details')) fold.open = true";

/// What axe takes for violations.
pub(crate) async fn violations(page: &Page) -> serde_json::Value {
    let run = "const done = arguments[0];
        axe.run(document, { resultTypes: ['violations'] }).then(
            ({ violations }) => done(violations.map(({ id, nodes }) =>
                `${id}: ${nodes.map((node) => `${node.html} ${node.failureSummary}`).join(' | ')}`)),
            (error) => done([String(error)]));";
    page.wait_for(run).await
}

pub(crate) async fn check(page: &Page, what: &str) {
    assert_eq!(violations(page).await, json!([]), "{what}");
}

/// In every language, on a laptop and on a phone, axe finds nothing, nothing is wider than the page, and a wide page does not scroll.
pub(crate) async fn named_and_fits(page: &Page) {
    page.ask(AXE).await;
    page.ask(UNFOLD).await;
    for screen in [(1280, 800), (360, 740)] {
        page.screen(screen, 1.0).await;
        for lang in languages(1) {
            page.speak(lang).await;
            check(page, lang).await;
            let over = "const { scrollWidth, clientWidth, scrollHeight, clientHeight } = document.documentElement;
                return [scrollWidth - clientWidth, clientWidth < 960 ? 0 : scrollHeight - clientHeight]";
            assert_eq!(page.ask(over).await, json!([0, 0]), "{lang} {screen:?}");
        }
    }
}

/// As [`named_and_fits`]; and by touch on a phone, what is of a kind has every word, and targets of 44 pixels. Words of the
/// kind begin with this prefix.
pub(crate) async fn kind_is_named_and_fits(page: &Page, kind: &str, prefix: &str) {
    named_and_fits(page).await;
    page.touched().await;
    page.screen((360, 640), 1.0).await;
    for lang in languages(1) {
        page.speak(lang).await;
        assert_eq!(defects(page, 44).await, json!([]), "{lang}");
        let script = format!(
            "return [...document.querySelectorAll('[data-of={kind}]')].map((one) => one.innerText).join(' ')"
        );
        let text = page.ask(&script).await.as_str().unwrap().to_owned();
        // A word without a translation shows its key; a sentence may end with the same letters.
        let shows_key = text.split(prefix).skip(1);
        let shows_key = shows_key.filter(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase()));
        assert!(text.len() > 200 && shows_key.count() == 0, "{lang}: {text}");
    }
}

#[tokio::test]
async fn axe_finds_nothing() {
    let page = Page::open().await;
    page.stop_at("75").await;
    // Not as a part of the page: its rules for scripts do not bind what a browser's tools run.
    page.ask(AXE).await;
    // It finds what there is to find.
    page.ask(
        "const image = document.createElement('img');
        image.id = 'nameless';
        document.getElementById('rail').append(image)",
    )
    .await;
    assert!(
        violations(&page).await[0]
            .as_str()
            .unwrap()
            .starts_with("image-alt")
    );
    page.ask("document.getElementById('nameless').remove()")
        .await;
    for lang in languages(2) {
        page.speak(lang).await;
        for scheme in ["light", "dark"] {
            page.prefer("prefers-color-scheme", scheme).await;
            check(&page, &format!("{lang} {scheme}")).await;
            page.click("projector").await;
            check(&page, &format!("{lang} {scheme} projector")).await;
            page.click("settings").await;
            check(&page, &format!("{lang} {scheme} projector, settings")).await;
            page.click("settings").await;
            page.click("projector").await;
        }
        page.prefer("prefers-color-scheme", "light").await;
        page.screen((360, 640), 1.0).await;
        check(&page, &format!("{lang} narrow")).await;
        page.screen((1280, 800), 1.0).await;
        page.click("tab-lesson").await;
        page.until("the lesson", async || {
            page.count("#lesson-check:not(:empty)").await == 1
        })
        .await;
        check(&page, &format!("{lang} lesson")).await;
        page.click("tab-settings").await;
        page.click("menu").await;
        check(&page, &format!("{lang} menu")).await;
        page.click("help-open").await;
        page.until("help", async || page.count("#help[open]").await == 1)
            .await;
        check(&page, &format!("{lang} help")).await;
        page.click("help-close").await;
        page.write("field-l1", "oops").await;
        page.write("field-l2", "-1").await;
        assert_ne!(page.text("problem").await, "");
        check(&page, &format!("{lang} problems")).await;
        page.click("preset-a").await;
        let address = format!("{}#9&broken", home());
        page.goto(&address).await;
        assert_ne!(page.text("notice").await, "");
        check(&page, &format!("{lang} notice")).await;
        page.click("notice-close").await;
    }
    page.close().await;
}

#[tokio::test]
async fn axe_finds_nothing_of_a_linkage() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("75").await;
    page.ask(AXE).await;
    page.click("groups").await;
    page.ask(UNFOLD).await;
    for scheme in ["light", "dark"] {
        page.prefer("prefers-color-scheme", scheme).await;
        check(&page, scheme).await;
    }
    page.screen((360, 640), 1.0).await;
    check(&page, "narrow").await;
    page.screen((1280, 800), 1.0).await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || {
        page.count("#lesson-check:not(:empty)").await == 1
    })
    .await;
    for step in 2..=17 {
        page.click("lesson-on").await;
        check(&page, &format!("step {step}")).await;
    }
    page.close().await;
}

/// What an element says to who does not see it.
async fn said(page: &Page, id: &str) -> String {
    let script = format!("return document.getElementById('{id}').textContent");
    page.ask(&script).await.as_str().unwrap().to_owned()
}

/// The links of any linkage go by their own names, whatever the mixer calls one of that name.
#[tokio::test]
async fn links_go_by_their_names() {
    let page = Page::open().await;
    page.until("the mixer's description", async || {
        said(&page, "charts-description").await.contains("wheel 4")
    })
    .await;
    let mixer = said(&page, "charts-description").await;
    crate::gallery::open(&page, "watt-1").await;
    page.stop_at("80").await;
    page.choose("plot", "rocker.angle").await;
    page.until("a description", async || {
        let told = said(&page, "charts-description").await;
        told != mixer && told.contains("rocker")
    })
    .await;
    for id in ["charts-description", "mechanism-description"] {
        let told = said(&page, id).await;
        assert!(!told.contains("wheel"), "{told}");
    }
    page.close().await;
}

#[tokio::test]
async fn drawing_and_plots_are_described_at_rest() {
    let page = Page::open().await;
    let describes = async |canvas: &str, by: &str| {
        let named = page.attribute(canvas, "aria-describedby").await;
        assert_eq!(named.as_deref(), Some(by));
    };
    describes("mechanism", "mechanism-description").await;
    describes("charts", "charts-description").await;
    let role = page.attribute("announcement", "role").await;
    assert_eq!(role.as_deref(), Some("status"));

    page.stop_at("100").await;
    page.until("a description", async || {
        said(&page, "mechanism-description")
            .await
            .contains("100.0°")
    })
    .await;
    let linkage = FourBar::new(Case::A.dimensions().lengths).unwrap();
    let pose = linkage
        .pose::<1>(Assembly::First, 100.0_f64.to_radians())
        .unwrap();
    let degrees = |angle: f64| format!("{:.1}°", angle.to_degrees()).replace('-', "−");
    let drawing = said(&page, "mechanism-description").await;
    for part in [
        format!("rocker, wheel 4 {}", degrees(pose.rocker.value())),
        format!("wheel 5 {}", degrees(-2.0 * pose.rocker.value())),
        format!("coupler {}", degrees(pose.coupler.value())),
        "crank-rocker, assembly 1".to_owned(),
    ] {
        assert!(drawing.contains(&part), "{part}: {drawing}");
    }
    let plots = said(&page, "charts-description").await;
    for part in [
        "0.0° to 360.0°",
        "angle, °: rocker, wheel 4, least 60.3° at 23.1°, greatest 148.2° at 217.1°",
        "angular velocity analogue, 1: rocker, wheel 4, least −1.094 at 340.1°",
        "wheel 5, least −1.347 at 99.7°, greatest 2.187 at 340.1°",
        "angular acceleration analogue",
    ] {
        assert!(plots.contains(part), "{part}: {plots}");
    }

    // A step is spoken, once it is done, and in the reader's numbers.
    page.click("step-forward").await;
    page.until("the step to be told", async || {
        said(&page, "announcement").await.contains("101.0°")
    })
    .await;
    let now = said(&page, "announcement").await;
    let pose = linkage
        .pose::<1>(Assembly::First, 101.0_f64.to_radians())
        .unwrap();
    assert!(
        now.contains(&format!("wheel 4 {}", degrees(pose.rocker.value()))),
        "{now}"
    );
    for (lang, word) in [("ru", "коромысло"), ("uk", "коромисло"), ("kk", "күйенте")]
    {
        page.speak(lang).await;
        page.until("its words", async || {
            let drawing = said(&page, "mechanism-description").await;
            drawing.contains(word) && drawing.contains("101,0°")
        })
        .await;
        let plots = said(&page, "charts-description").await;
        assert!(plots.contains("148,2°"), "{plots}");
        for text in [said(&page, "mechanism-description").await, plots] {
            assert!(!text.contains(['{', '}']), "{text}");
        }
    }
    page.speak("en").await;

    // Special positions: a limit position; a dead point, which is a problem's sentence.
    page.write("angle", "217.15").await;
    page.until("the limit position", async || {
        said(&page, "announcement")
            .await
            .contains("Limit position at 217.1°")
    })
    .await;
    page.click("assembly-2").await;
    page.until("the other assembly", async || {
        said(&page, "mechanism-description")
            .await
            .contains("assembly 2")
    })
    .await;
    page.write("field-l1", "0.8").await;
    page.write("field-l2", "0.4").await;
    let dead = FourBar::new([0.8, 0.4, 0.55, 0.85]).unwrap();
    let [_, end] = dead.cycle().arcs()[0];
    page.write("angle", &format!("{:.3}", end.to_degrees() - 0.1))
        .await;
    page.until("the dead point", async || {
        said(&page, "mechanism-description")
            .await
            .contains("Dead point at")
    })
    .await;

    // In motion nothing is told.
    page.click("play").await;
    page.until("motion", async || {
        said(&page, "mechanism-description").await == "In motion."
    })
    .await;
    assert_eq!(said(&page, "announcement").await, "");
    page.close().await;
}

#[tokio::test]
async fn projector_mode_is_large_and_stays() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let plain = page.picture("mechanism").await;
    let font = async || {
        let script =
            "return parseFloat(getComputedStyle(document.querySelector('#speed')).fontSize)";
        page.ask(script).await.as_f64().unwrap()
    };
    let (usual, chart) = (font().await, page.picture("charts").await.ink());
    page.focus("play").await;
    page.keys("p").await;
    let pressed = page.attribute("projector", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    assert!(font().await >= 1.4 * usual);
    // The settings make room for the drawing; thicker lines leave more ink.
    assert!(!page.element("rail").await.is_displayed().await.unwrap());
    let shown = page.picture("mechanism").await;
    assert!(shown.width > plain.width + 100);
    assert!(page.picture("charts").await.ink() > 1.2 * chart);
    page.keys("s").await;
    assert!(page.element("rail").await.is_displayed().await.unwrap());
    page.click("centres").await;
    page.keys("\u{e00c}").await; // Escape
    assert!(!page.element("rail").await.is_displayed().await.unwrap());

    // It is in the address, and no step to undo.
    page.click("undo").await;
    page.until("the address to follow", async || {
        page.address().await.contains("v.projector=true")
    })
    .await;
    page.reload().await;
    assert!(!page.element("rail").await.is_displayed().await.unwrap());
    page.click("projector").await;
    assert!(page.element("rail").await.is_displayed().await.unwrap());
    page.close().await;
}

#[tokio::test]
async fn reduced_motion_is_honoured() {
    let page = Page::open().await;
    page.prefer("prefers-reduced-motion", "reduce").await;
    page.ask("localStorage.clear()").await;
    page.anew(home()).await;
    let playing = page.attribute("play", "data-playing").await;
    assert_eq!(playing.as_deref(), Some("false"));
    let still = page.picture("mechanism").await;
    // Nothing moves by itself, also where something is faded otherwise.
    page.write("field-l1", "9").await;
    let animations = page.ask("return document.getAnimations().length").await;
    assert_eq!(animations, json!(0));
    page.click("preset-a").await;
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&still) < 20);
    // It plays when asked to.
    page.click("play").await;
    let start = page.value("out-input").await;
    page.until("the crank to turn", async || {
        page.value("out-input").await != start
    })
    .await;
    page.close().await;
}
