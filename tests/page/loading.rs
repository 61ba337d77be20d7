//! What the first view asks for, and when.

use serde_json::json;

use crate::browser::Page;
use crate::browser::setting::lacking;
use crate::host::home;

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
        "/pkg/first.wasm",
        "/lang/en.json",
    ] {
        let there = names.iter().any(|address| address.ends_with(name));
        assert!(there, "{name} is missing: {names:?}");
    }
    let rest = |address: &String| address.ends_with("/pkg/second.wasm");
    assert!(
        !names.iter().any(rest),
        "the first view waits for the rest of the engine: {names:?}"
    );
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

/// Makes the second part of the engine fail to load: `gone`, or `damaged`; null lets it load.
const LOSE: &str = "
    globalThis.lost = 'gone';
    const isLost = (url) => lost && String(url).endsWith('second.wasm');
    const { fetch } = globalThis;
    globalThis.fetch = (url, ...more) => {
        if (!isLost(url)) return fetch(url, ...more);
        return lost === 'gone' ? Promise.reject(new TypeError(lost)) : Promise.resolve(new Response(lost));
    };
    const { open } = XMLHttpRequest.prototype;
    XMLHttpRequest.prototype.open = function (method, url, ...more) {
        const other = lost === 'gone' ? 'gone.wasm' : 'style.css';
        return open.call(this, method, isLost(url) ? other : url, ...more);
    };";

/// The page works with the first part of its engine. A mechanism that needs the second is refused while that part does not
/// load, and shown once it does. A kept mechanism is not given up for it.
#[tokio::test]
async fn the_second_part_may_come_late_or_never() {
    const LOST: &str = "Part of the page did not load.";
    const CLOSE: &str = "document.getElementById('notice-close').click();";
    const CLASS4: &str = "location.hash = ''; location.hash = '#class4-dwell';";
    const KEPT: &str = "return localStorage.getItem('assur.state')";
    let page = Page::open().await;
    page.before(LOSE).await;
    page.anew(home()).await;
    let lost = async || page.text("notice-text").await.contains(LOST);
    page.until("the reason", lost).await;
    page.ask(CLOSE).await;
    let title = page.ask("return document.title").await;
    for (how, degrees, angle) in [("gone", "75", 75.0), ("damaged", "100", 100.0)] {
        page.ask(&format!("window.eval(\"lost = '{how}'\"); {CLASS4}"))
            .await;
        page.until("the reason", lost).await;
        assert_eq!(page.ask("return document.title").await, title);
        page.stop_at(degrees).await;
        assert!((page.value("out-input").await - angle).abs() < 1e-6);
        page.ask(CLOSE).await;
    }
    page.ask("window.eval('lost = null')").await;
    page.until("the Class IV mechanism", async || {
        page.ask(CLASS4).await;
        page.ask("return document.title").await != title
    })
    .await;
    page.until("the mechanism to be kept", async || {
        page.ask(KEPT).await.to_string().contains("class4-dwell")
    })
    .await;

    let kept = page.ask(KEPT).await;
    // The browser names the files that it did not get, and the engine the calls that failed.
    page.said().await;
    page.driver.refresh().await.unwrap();
    page.until("the page to say that it cannot start", async || {
        page.ask("return document.getElementById('failed').checkVisibility()")
            .await
            == json!(true)
    })
    .await;
    assert_eq!(page.ask(KEPT).await, kept);
    // What the page says reaches the test by a channel of its own, perhaps later than the page is seen.
    page.until("the reason on the console", async || {
        !page.said().await.is_empty()
    })
    .await;
    page.settle().await;
    page.said().await;
    page.close().await;
}
