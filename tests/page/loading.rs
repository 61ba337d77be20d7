//! What the first view asks for, and when.

use serde_json::json;

use crate::browser::{Page, lacking};

/// The head of the page asks for all of it, so that it comes with the second round trip: no
/// script has to arrive before it says what else is needed.
#[tokio::test]
async fn the_first_view_is_asked_for_at_once() {
    let page = Page::playing().await;
    let asked = page
        .ask(
            "const ready = performance.getEntriesByName('ready')[0].startTime;
            const asked = performance.getEntriesByType('resource').filter(({ startTime }) => startTime < ready);
            const linked = [...document.querySelectorAll('head link')].map(({ href }) => href);
            return [asked.map(({ name }) => name), linked];",
        )
        .await;
    let [names, linked]: [Vec<String>; 2] = serde_json::from_value(asked).unwrap();
    for name in [
        "/style.css",
        "/app/main.js",
        "/pkg/assur_web_bg.wasm",
        "/lang/en.json",
    ] {
        let there = names.iter().any(|address| address.ends_with(name));
        assert!(there, "{name} is missing: {names:?}");
    }
    let first: std::collections::BTreeSet<_> = names.iter().collect();
    assert_eq!(first.len(), names.len(), "asked for twice: {names:?}");
    assert!(names.len() <= 20, "{names:?}");
    for name in &names {
        assert!(
            linked.contains(name),
            "{name} is not in the head: {linked:?}"
        );
    }
    page.close().await;
}

/// While a part of the page is on its way over a slow line, the page says that it is busy.
#[tokio::test]
async fn what_is_on_its_way_shows_that_it_is() {
    if lacking("a slow network") {
        return;
    }
    let page = Page::open().await;
    page.stop_at("60").await;
    page.tool("Network.enable", json!({})).await;
    let slow = json!({ "offline": false, "latency": 1500, "downloadThroughput": -1, "uploadThroughput": -1 });
    page.tool("Network.emulateNetworkConditions", slow).await;
    let busy = async || {
        let said = "return document.getElementById('app').ariaBusy";
        page.ask(said).await
    };
    assert_eq!(busy().await, json!(null));
    page.click("all_assemblies").await;
    page.until("the page to be busy", async || {
        busy().await == json!("true")
    })
    .await;
    page.until("the pictures", async || {
        page.count("#assembly-pictures button").await == 2
    })
    .await;
    assert_eq!(busy().await, json!(null));
    page.close().await;
}
