//! Paths on the page: typed, drawn by the hand, searched, through nine points, cognates.

use serde_json::json;
use thirtyfour::Key;

use crate::access::kind_is_named_and_fits;
use crate::browser::Page;
use crate::host::home;
use crate::picture_behind::{FROM, SCAN, file};

/// The page with a task of the catalogue, at rest.
async fn open(name: &str) -> Page {
    let page = Page::open_at(&format!("{}#{name}&v.playing=false", home()), "en-US").await;
    page.until("the verdict on the path", async || {
        page.ask("return Boolean(document.getElementById('path-verdict')?.textContent)")
            .await
            == json!(true)
    })
    .await;
    page.settle().await;
    assert_eq!(page.text("notice-text").await, "");
    page
}

/// Number of the listed linkages.
async fn listed(page: &Page, name: &str) -> usize {
    page.count(&format!("[name={name}]")).await
}

async fn ended(page: &Page, start: &str) {
    let there = format!("return !document.getElementById('{start}').hidden");
    page.until("the end of the search", async || {
        page.ask(&there).await == json!(true)
    })
    .await;
    page.settle().await;
}

/// A typed coordinate moves the point; points are added and removed.
#[tokio::test]
async fn points_are_typed_added_and_removed() {
    let page = open("path-nine").await;
    let before = page.picture("mechanism").await;
    page.write("field-point-x-2", "1.5").await;
    assert_eq!(page.written("field-point-x-2").await, "1.5");
    assert_eq!(page.text("problem").await, "");
    assert!(page.picture("mechanism").await.difference(&before) > 100);
    page.write("field-point-y-1", "what").await;
    assert_eq!(
        page.attribute("field-point-y-1", "aria-invalid")
            .await
            .as_deref(),
        Some("true")
    );
    page.write("field-point-y-1", "0").await;
    page.click("path-add").await;
    assert_eq!(page.count("#path .card:not([hidden])").await, 10);
    for count in (3..10).rev() {
        page.click(&format!("path-remove-{}", count + 1)).await;
        assert_eq!(page.count("#path .card:not([hidden])").await, count);
    }
    assert_eq!(
        page.count("#points button[id^=path-remove]:not([hidden])")
            .await,
        0
    );
    page.close().await;
}

/// All four-bars through nine points are found, filtered, chosen, and sent to the simulator.
#[tokio::test]
async fn four_bars_through_nine_points() {
    let page = open("path-nine").await;
    page.click("nine-search").await;
    ended(&page, "nine-search").await;
    let told = page.text("nine-told").await;
    assert!(
        told.starts_with("1442 of 1442 coupler curves found and proved, 21 of them real"),
        "{told}"
    );
    assert_eq!(listed(&page, "nine-found").await, 63);
    page.choose("nine-filter", "works").await;
    let works = listed(&page, "nine-found").await;
    assert!(0 < works && works < 63, "{works}");
    page.click("nine-found-2").await;
    page.settle().await;
    let verdict = page.text("path-verdict").await;
    assert!(
        verdict.contains(": exact; all points in one motion"),
        "{verdict}"
    );
    assert_eq!(page.count("#path-go-9").await, 1);
    page.click("path-go-5").await;
    page.settle().await;
    // A moved point makes another task, and the linkages found are forgotten.
    page.write("field-point-x-2", "1.3").await;
    assert_eq!(listed(&page, "nine-found").await, 0);
    assert!(!page.text("path-verdict").await.contains("exact"));
    page.click("path-send").await;
    page.until("a linkage", async || {
        page.ask("return document.documentElement.dataset.kind === 'linkage'")
            .await
            == json!(true)
    })
    .await;
    page.close().await;
}

/// A curve drawn by the hand is a closed path with a linkage; a search makes it better, and one step takes it back.
#[tokio::test]
async fn a_curve_is_drawn_and_searched() {
    let page = open("path-nine").await;
    page.click("path-pen").await;
    let at = |k: usize| {
        let angle = k as f64 * std::f64::consts::TAU / 40.0;
        (
            300.0 + 110.0 * angle.cos(),
            240.0 + 60.0 * angle.sin() * (1.0 + 0.3 * angle.cos()),
        )
    };
    let line: Vec<(f64, f64)> = (0..=40).map(at).collect();
    page.drag_along("mechanism", &line).await;
    page.settle().await;
    let course = "return document.getElementById('path-course').value";
    assert_eq!(page.ask(course).await, json!("closed"));
    assert_eq!(
        page.attribute("path-pen", "aria-pressed").await.as_deref(),
        Some("false")
    );
    assert!(page.text("path-count").await.ends_with(" points"));
    assert_eq!(page.text("problem").await, "");
    let before = page.text("path-verdict").await;
    assert!(before.contains("greatest distance"), "{before}");
    page.click("path-search").await;
    page.until("a better linkage of the search", async || {
        page.text("path-verdict").await != before
    })
    .await;
    assert!(listed(&page, "path-found").await > 0);
    page.click("path-search-stop").await;
    page.settle().await;
    assert!(page.text("path-search-progress").await.contains("compared"));
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.text("path-verdict").await, before);
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.ask(course).await, json!("points"));
    page.close().await;
}

/// A photograph is painted behind the path, stays while a curve is drawn over it, and is removed.
#[tokio::test]
async fn a_photograph_is_put_behind_the_path() {
    let page = open("path-nine").await;
    assert_eq!(page.picture("mechanism").await.cloud(FROM).count, 0);
    // A spot so large that no link covers it.
    let large = SCAN.replacen(r#"width="20" height="20""#, r#"width="90" height="90""#, 1);
    let scan = file("path.svg", large);
    page.choose_file("path-photograph-file", &scan).await;
    page.until("the photograph", async || {
        let remove = page.element("path-photograph-remove").await;
        remove.is_displayed().await.unwrap()
    })
    .await;
    page.press("path-photograph-opacity", Key::End).await;
    assert!(page.picture("mechanism").await.cloud(FROM).count > 50);
    page.write("field-point-x-2", "1.3").await;
    assert!(page.picture("mechanism").await.cloud(FROM).count > 50);
    page.click("path-photograph-remove").await;
    page.settle().await;
    assert_eq!(page.picture("mechanism").await.cloud(FROM).count, 0);
    page.choose_file("path-photograph-file", &file("path.txt", "none"))
        .await;
    page.until("the reason", async || {
        !page.text("problem").await.is_empty()
    })
    .await;
    page.close().await;
}

/// The atlas is opened; by keys and by a press a linkage is placed on the path; another frame, and other lengths on the
/// axes, give other curves. The axes have names and ranges.
#[tokio::test]
async fn a_curve_of_the_atlas_is_placed() {
    let page = open("path-drawn").await;
    page.ask("document.getElementById('path-atlas-fold').open = true")
        .await;
    page.until("the atlas", async || {
        !page.text("path-atlas-told").await.is_empty()
    })
    .await;
    let before = page.text("path-verdict").await;
    let drawn = page.picture("path-atlas").await;
    page.press("path-atlas-third", Key::End).await;
    assert!(page.picture("path-atlas").await.difference(&drawn) > 300);
    page.press("path-atlas-third", Key::Home).await;
    let names = async || {
        page.ask("return [...document.querySelectorAll('.atlas-axis')].map((p) => p.innerText)")
            .await
    };
    let named = |up: &str, across: &str| {
        json!([
            format!("↑ {up} / crank, 0.6 to 6"),
            format!("→ {across} / crank, 0.6 to 6")
        ])
    };
    assert_eq!(names().await, named("rocker", "coupler"));
    page.press("path-atlas-axes", Key::Down).await;
    assert_eq!(names().await, named("frame", "coupler"));
    page.press("path-atlas-axes", Key::Up).await;
    let cell = async || page.attribute("path-atlas", "data-cell").await;
    for _ in 0..5 {
        page.press("path-atlas", Key::Up).await;
        page.press("path-atlas", Key::Right).await;
    }
    assert_eq!(cell().await.as_deref(), Some("65"));
    page.press("path-atlas", Key::Enter).await;
    page.settle().await;
    let told = page.text("path-atlas-told").await;
    assert!(told.contains("Placed: greatest distance"), "{told}");
    assert_ne!(page.text("path-verdict").await, before);
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.text("path-verdict").await, before);
    page.close().await;
}

/// A cognate has the same distances; a geared five-bar opens in the simulator.
#[tokio::test]
async fn cognates_trace_the_same_curve() {
    let page = open("path-drawn").await;
    let distance = |verdict: String| {
        verdict
            .split("; ")
            .next()
            .unwrap()
            .rsplit(' ')
            .next()
            .unwrap()
            .to_owned()
    };
    let before = distance(page.text("path-verdict").await);
    let picture = page.picture("mechanism").await;
    page.click("path-cognate-1").await;
    page.settle().await;
    assert_eq!(distance(page.text("path-verdict").await), before);
    assert!(page.picture("mechanism").await.difference(&picture) > 500);
    page.click("path-geared-1").await;
    page.until("the five-bar", async || {
        page.ask("return document.documentElement.dataset.kind === 'linkage'")
            .await
            == json!(true)
    })
    .await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// Every word is there in every language, on a laptop and on a phone; targets of a finger are 44 pixels high.
#[tokio::test]
async fn paths_are_named_and_fit() {
    let page = open("path-nine").await;
    kind_is_named_and_fits(&page, "point-path", "path.").await;
    page.close().await;
}
