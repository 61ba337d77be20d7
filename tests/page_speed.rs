//! How fast the page is in a real browser: printed by `cargo xtask bench`, never
//! asserted. Every line reads `page: NAME = FIGURE`.
#![cfg(not(target_family = "wasm"))]
#![allow(
    dead_code,
    reason = "the browser's hands are made for the tests of the page"
)]

#[path = "page/browser.rs"]
mod browser;
#[path = "page/picture.rs"]
mod picture;

use browser::Page;

/// Waits for a number of animation frames.
const FRAMES: f64 = 300.0;
const WAIT: &str = "const done = arguments[0]; let left = 300;
    const frame = () => (left-- > 0 ? requestAnimationFrame(frame) : done(0));
    requestAnimationFrame(frame);";

/// Moves a slider step by step, one step a frame, as a hand does.
const STEPS: f64 = 120.0;
const DRAG: &str = "const done = arguments[0]; let left = 120;
    const slider = document.getElementById('slider-l3');
    const [low, high] = [0.5, 0.9];
    const frame = () => {
        if (left-- <= 0) return done(0);
        slider.value = String(low + (high - low) * left / 120);
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);";

#[tokio::test]
async fn page_speed() {
    let page = Page::open().await;
    let ready = "arguments[0](performance.getEntriesByName('ready')[0].startTime)";
    println!(
        "page: first drawn frame after navigation, ms = {:.0}",
        page.number(ready).await
    );

    let before = page.metric("TaskDuration").await;
    page.number(WAIT).await;
    let spent = page.metric("TaskDuration").await - before;
    println!(
        "page: main thread per animation frame, ms = {:.2}",
        spent / FRAMES * 1e3
    );

    page.click("play").await;
    let before = page.metric("TaskDuration").await;
    page.number(DRAG).await;
    let spent = page.metric("TaskDuration").await - before;
    println!(
        "page: main thread per step of a dragged slider, ms = {:.2}",
        spent / STEPS * 1e3
    );

    page.click("play").await;
    let heap = page.metric("JSHeapUsedSize").await;
    for _ in 0..5 {
        page.number(DRAG).await;
        page.number(WAIT).await;
    }
    let grown = page.metric("JSHeapUsedSize").await - heap;
    println!(
        "page: JavaScript heap grown over 5 × (drag and 300 frames), kB = {:.0}",
        grown / 1e3
    );
    page.close().await;
}
