//! "Design your dwell" on the page: a search in a worker, each better mechanism
//! drawn, one step to undo; stopped by hand; wishes that cannot be are said.

use assur::mechanism::Dimension;
use assur::synthesis::dwell::{DesignVariable, Search, Target};
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::gallery::{agrees, document, open};

/// FK among the links, and how long it is made.
const FK: usize = 5;
const LENGTH: f64 = 4.062;
/// The wanted arc, degrees.
const ARC: f64 = 184.0;

/// The Class IV mechanism with FK lengthened, its wishes open, a dwell of `ARC`
/// wanted of it.
async fn lengthened(page: &Page) {
    open(page, "class4-dwell").await;
    page.write(&format!("field-length-{FK}"), &LENGTH.to_string())
        .await;
    page.element("design").await;
    let heading = page.driver.find(By::Css("#design > summary")).await;
    heading.unwrap().click().await.unwrap();
    page.write("field-design-arc", &ARC.to_string()).await;
}

/// The residual of the mechanism that the search begins with.
async fn at_first(stroke: f64) -> f64 {
    let mut start = document("class4-dwell");
    start.links[FK].length = Some(LENGTH);
    let target = Target {
        tolerance: 0.1_f64.to_radians(),
        arc: ARC.to_radians(),
        stroke: stroke.to_radians(),
    };
    let start = start.mechanism().unwrap();
    let variable = DesignVariable {
        dimension: Dimension::Length(start.link("FK").unwrap()),
        range: [0.95 * LENGTH, 1.05 * LENGTH],
    };
    let search = Search::new(&start, "CD.angle", target, &[variable]);
    search.unwrap().progress().evaluation.residual
}

/// Waits until a search is over.
async fn ended(page: &Page) {
    page.until("the search to end", async || {
        let start = page.element("design-start").await;
        start.is_displayed().await.unwrap()
    })
    .await;
}

/// A field's number with all its digits, as it has them with the focus.
async fn exactly(page: &Page, field: &str) -> f64 {
    page.focus(field).await;
    page.settle().await;
    page.written(field).await.replace('°', "").parse().unwrap()
}

#[tokio::test]
async fn a_dwell_is_searched_for_while_the_page_moves() {
    let page = Page::open().await;
    page.stop_at("40").await;
    lengthened(&page).await;
    // Only FK may change; as much stroke is wanted as there is.
    for index in [1, 6] {
        page.click(&format!("design-move-{index}")).await;
    }
    let stroke = exactly(&page, "field-design-stroke").await;
    let before = at_first(stroke).await;
    let dwelt = page.text("out-course-arc").await;
    assert!(dwelt.starts_with("151."), "{dwelt}");
    page.click("play").await;
    page.ask(
        "window.drawn = [];
        const count = (now) => {
            if (!window.drawn) return;
            window.drawn.push(now);
            requestAnimationFrame(count);
        };
        requestAnimationFrame(count);",
    )
    .await;
    page.click("design-start").await;
    ended(&page).await;
    let drawn = page
        .ask("const { drawn } = window; window.drawn = null; return drawn;")
        .await;
    let drawn: Vec<f64> = serde_json::from_value(drawn).unwrap();
    let told = page.text("design-progress").await;
    let seconds = 1e-3 * (drawn[drawn.len() - 1] - drawn[0]);
    println!("{} frames in {seconds:.2} s; {told}", drawn.len());
    // Had the page been blocked, it would have drawn itself before and after.
    assert!(drawn.len() > 12, "{} frames", drawn.len());
    let residual = page.value("design-progress").await;
    assert!(residual <= 0.5 * before, "{before} {told}");
    assert!(told.contains("It stays on its branch over the whole turn."));
    page.stop_at("75").await;
    // Drawing and read-outs are those of the length that was found.
    let found = exactly(&page, &format!("field-length-{FK}")).await;
    assert!((found - 4.0116).abs() < 0.02, "{found}");
    let mut better = document("class4-dwell");
    better.links[FK].length = Some(found);
    agrees(&page, &better, "CD.angle").await;
    assert_ne!(page.text("out-course-arc").await, dwelt);
    // The whole search is one step.
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.written(&format!("field-length-{FK}")).await, "4.062");
    assert_eq!(page.text("out-course-arc").await, dwelt);
    page.click("redo").await;
    page.settle().await;
    agrees(&page, &better, "CD.angle").await;
    page.close().await;
}

/// A worker of the one file is a `data:` address, and the engine it asks for too.
#[tokio::test]
async fn a_search_in_the_one_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    page.stop_at("40").await;
    lengthened(&page).await;
    page.click("design-start").await;
    page.until("a better mechanism", async || {
        page.text("design-progress")
            .await
            .contains("Mechanisms tried")
            && page.written(&format!("field-length-{FK}")).await != "4.062"
    })
    .await;
    page.click("design-stop").await;
    let told = page.text("design-progress").await;
    assert!(told.contains("Stopped"), "{told}");
    page.close().await;
}

#[tokio::test]
async fn a_search_is_stopped_and_wishes_are_refused() {
    let page = Page::open().await;
    page.stop_at("40").await;
    lengthened(&page).await;
    let whole = page.text("out-course-arc").await;
    // As soon as anything better is told.
    page.ask(
        "const told = document.getElementById('design-progress');
        const watch = new MutationObserver(() => {
            if (!told.textContent.includes('Mechanisms tried')) return;
            watch.disconnect();
            document.getElementById('design-stop').click();
        });
        watch.observe(told, { childList: true, characterData: true, subtree: true });",
    )
    .await;
    page.click("design-start").await;
    ended(&page).await;
    let told = page.text("design-progress").await;
    assert!(told.contains("Stopped"), "{told}");
    assert_eq!(
        page.focused().await.as_deref(),
        Some("design-start"),
        "{told}"
    );
    for _ in 0..20 {
        page.settle().await;
    }
    assert_eq!(page.text("design-progress").await, told);
    assert_ne!(page.text("out-course-arc").await, whole);
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.text("out-course-arc").await, whole);
    // Another mechanism ends a search.
    page.click("design-start").await;
    page.write("field-length-0", "1.01").await;
    ended(&page).await;
    // What cannot be wanted is said.
    page.write("field-design-arc", "400").await;
    page.click("design-start").await;
    ended(&page).await;
    let told = page.text("design-progress").await;
    assert_eq!(
        told,
        "Target dwell: it must be greater than zero, and an arc no more than a full turn."
    );
    page.write("field-design-arc", "184").await;
    for index in [1, FK, 6] {
        page.click(&format!("design-move-{index}")).await;
    }
    page.click("design-start").await;
    ended(&page).await;
    let told = page.text("design-progress").await;
    assert_eq!(told, "No length may change: choose at least one.");
    // A linkage that swings has nothing to search for.
    open(&page, "watt-1").await;
    page.choose("driver", "rocker").await;
    page.settle().await;
    assert!(
        !page
            .element("design-start")
            .await
            .is_enabled()
            .await
            .unwrap()
    );
    page.close().await;
}
