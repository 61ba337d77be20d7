//! Canvases are painted by a worker beside the page, and alike without one.

use serde_json::json;

use crate::browser::{Page, setting};
use crate::picture::Picture;

const OVERLAYS: [&str; 4] = ["centres", "vectors", "loop_vectors", "transmission"];
const CANVASES: [&str; 2] = ["mechanism", "charts"];

/// Drawing and plots with all that can be shown.
async fn pictures(page: &Page) -> [Picture; 2] {
    page.stop_at("62").await;
    for overlay in OVERLAYS {
        // What was shown at the last visit is shown again.
        if !page.element(overlay).await.is_selected().await.unwrap() {
            page.click(overlay).await;
        }
    }
    [
        page.picture(CANVASES[0]).await,
        page.picture(CANVASES[1]).await,
    ]
}

/// Has every document run a script first, and opens the page anew.
async fn open_after(page: &Page, script: &str) {
    page.tool(
        "Page.addScriptToEvaluateOnNewDocument",
        json!({ "source": script }),
    )
    .await;
    page.anew(&setting("ASSUR_URL")).await;
}

/// Whether the page itself may still paint a canvas.
async fn own(page: &Page, id: &str) -> bool {
    let script = format!(
        "try {{ return document.getElementById('{id}').getContext('2d') !== null; }} catch {{ return false; }}"
    );
    page.ask(&script).await.as_bool().unwrap()
}

#[tokio::test]
async fn worker_and_page_paint_the_same() {
    let page = Page::open().await;
    pictures(&page).await;
    // Each is of a visit that finds all as it was.
    page.anew(&setting("ASSUR_URL")).await;
    let beside = pictures(&page).await;
    for id in CANVASES {
        assert!(!own(&page, id).await, "{id} is painted by the page");
    }
    for broken in [
        "delete globalThis.Worker;",
        // One that does not come.
        "globalThis.Worker = class extends EventTarget {
            postMessage() { setTimeout(() => this.dispatchEvent(new Event('error'))); }
        };",
    ] {
        open_after(&page, broken).await;
        let here = pictures(&page).await;
        for (id, (beside, here)) in CANVASES.iter().zip(beside.iter().zip(&here)) {
            assert!(own(&page, id).await, "{id} is painted by a worker");
            assert!(here.ink() > 1.0, "{id} is empty");
            assert_eq!(here.difference(beside), 0, "{id}");
        }
    }
    page.close().await;
}

/// What is used no more is forgotten, and every painting is answered.
#[tokio::test]
async fn the_worker_keeps_only_what_it_needs() {
    let page = Page::open().await;
    let watched = "window.known = 0;
        window.paintings = 0;
        const post = Worker.prototype.postMessage;
        Worker.prototype.postMessage = function (message, ...rest) {
            if (message.painted) {
                window.paintings += 1;
                window.known += message.made.length - message.gone.length;
            }
            post.call(this, message, ...rest);
        };";
    open_after(&page, watched).await;
    for overlay in OVERLAYS {
        page.click(overlay).await;
    }
    page.until("some paintings", async || {
        page.ask("return window.paintings > 100").await == true
    })
    .await;
    let before = page.ask("return window.known").await.as_i64().unwrap();
    assert!(before > 5, "{before}");
    page.until("more paintings", async || {
        page.ask("return window.paintings > 250").await == true
    })
    .await;
    let after = page.ask("return window.known").await.as_i64().unwrap();
    assert!((after - before).abs() < 10, "{before} {after}");
    page.close().await;
}

/// A call that the canvas refuses does not stop what is painted after it.
#[tokio::test]
async fn a_refused_call_is_answered() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let unseen = page
        .wait_for(
            "const done = arguments[0];
            import('assur/studio.js').then(async ({ Studio }) => {
                const studio = await Studio.open();
                const context = studio.context(new OffscreenCanvas(9, 9));
                const seen = [];
                for (const radius of [-1, 1]) {
                    context.arc(0, 0, radius, 0, 1);
                    await Promise.resolve();
                    seen.push(studio.unseen);
                    while (studio.unseen > 0) await new Promise(requestAnimationFrame);
                }
                done(seen);
            });",
        )
        .await;
    assert_eq!(unseen, json!([1, 1]));
    let said = page.said().await;
    assert!(
        said.iter().any(|line| line.contains("negative")),
        "{said:?}"
    );
    page.close().await;
}
