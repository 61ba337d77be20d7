//! Speed of the page in a real browser, printed by `cargo xtask bench` and never asserted. A result is a line `page:
//! NAME = FIGURE`. `ASSUR_MINUTES` is the time for which the page plays and is dragged while its memory is measured.
#![cfg(not(target_family = "wasm"))]
#![allow(
    dead_code,
    reason = "the browser's hands are made for the tests of the page"
)]

#[path = "page/browser.rs"]
mod browser;
#[path = "page/host.rs"]
mod host;
#[path = "page/picture.rs"]
mod picture;
#[path = "page/pointer.rs"]
mod pointer;

use std::env;
use std::time::{Duration, Instant};

use browser::Page;
use host::{Host, folder, home};
use serde_json::json;

/// Put into the page before its own scripts: each is read once, however often it
/// is used, so that the page's memory is its own.
///
/// `frames` waits for a number of animation frames. `drag` presses a slider, moves it
/// by its own steps down and up, one a frame, and releases it, as a hand does; `dragFrom` does so from a place of the
/// drawing, around it. Both hand
/// on what each step kept the main thread busy for, in milliseconds: the event, and all
/// of the frame after it, of which a message posted from within is the end. `live` plays and drags by
/// turns until `living` is no more. `memory` is the engine's.
const BENCH: &str = "globalThis.bench = {
    frames: (left) => new Promise((done) => {
        const frame = () => (left-- > 0 ? requestAnimationFrame(frame) : done([]));
        requestAnimationFrame(frame);
    }),
    drag: (steps) => {
        const slider = document.getElementById('slider-l3');
        return bench.dragged(slider, steps, [0, 0], (k) => {
            if (k % 60 < 30) slider.stepUp(); else slider.stepDown();
            slider.dispatchEvent(new Event('input', { bubbles: true }));
        });
    },
    dragFrom: (x, y, steps) => {
        const canvas = document.getElementById('mechanism');
        const { left, top } = canvas.getBoundingClientRect();
        const at = (k) => [left + x + 12 * Math.sin(k / 9), top + y + 12 * Math.sin(k / 7)];
        return bench.dragged(canvas, steps, at(0), (k) => canvas.dispatchEvent(bench.event('pointermove', at(k))));
    },
    event: (name, [clientX, clientY]) =>
        new PointerEvent(name, { clientX, clientY, pointerId: 1, isPrimary: true, button: 0, buttons: 1, bubbles: true }),
    dragged: (element, steps, at, move) => new Promise((done) => {
        const spent = [];
        const { port1, port2 } = new MessageChannel();
        let event = 0, frame = 0;
        const step = () => {
            if (spent.length === steps) {
                element.dispatchEvent(bench.event('pointerup', at));
                port1.close();
                return done(spent);
            }
            requestAnimationFrame(() => { frame = performance.now(); });
            const start = performance.now();
            move(spent.length);
            event = performance.now() - start;
            requestAnimationFrame(() => port2.postMessage(0));
        };
        port1.onmessage = () => {
            spent.push(event + performance.now() - frame);
            setTimeout(step);
        };
        element.dispatchEvent(bench.event('pointerdown', at));
        step();
    }),
    live: async () => {
        const play = document.getElementById('play');
        for (bench.living = true; bench.living;) {
            await bench.frames(300);
            play.click();
            await bench.drag(120);
            play.click();
        }
        bench.ended([]);
    },
    end: () => new Promise((ended) => {
        bench.ended = ended;
        bench.living = false;
    }),
};
for (const name of ['instantiate', 'instantiateStreaming']) {
    const make = WebAssembly[name];
    WebAssembly[name] = async (...given) => {
        const made = await make.apply(WebAssembly, given);
        bench.memory = (made.instance ?? made).exports.memory;
        return made;
    };
}";

const FRAMES: f64 = 300.0;
const STEPS: usize = 120;

/// Lets the page do something of [`BENCH`]; the numbers it hands on.
async fn have(page: &Page, what: &str) -> Vec<f64> {
    let script = format!("const done = arguments[0]; bench.{what}.then(done)");
    page.numbers(&script).await
}

#[tokio::test]
async fn page_speed() {
    let page = Page::playing().await;
    page.before(BENCH).await;
    page.anew(home()).await;
    let ready = "arguments[0]([performance.getEntriesByName('ready')[0].startTime])";
    let first = page.numbers(ready).await;
    print("first drawn frame after navigation, ms", first[0]);
    first_view(&page).await;
    page.anew(home()).await;

    for overlay in ["centres", "vectors", "loop_vectors", "transmission"] {
        page.click(overlay).await;
    }
    let frames = format!("frames({FRAMES})");
    let shown = measured(&page, Clock::Wall, &frames).await;
    print(
        "main thread per frame, all overlays, ms",
        shown.busy / FRAMES,
    );
    print("frames a second, all overlays", FRAMES / shown.seconds);
    let shown = measured(&page, Clock::Processor, &frames).await;
    print(
        "main thread per frame, all overlays, ms of processor",
        shown.busy / FRAMES,
    );

    page.click("play").await;
    let dragged = measured(&page, Clock::Processor, &format!("drag({STEPS})")).await;
    let mut steps = dragged.numbers;
    steps.sort_by(f64::total_cmp);
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    print(
        "step of a dragged slider, median, ms",
        steps[steps.len() / 2],
    );
    print("step of a dragged slider, mean, ms", mean);
    print(
        "step of a dragged slider, mean, ms of processor",
        dragged.busy / steps.len() as f64,
    );
    print(
        "steps a second of a dragged slider",
        steps.len() as f64 / dragged.seconds,
    );
    page.click("play").await;

    memory(&page).await;
    forces(&page).await;
    poses(&page).await;
    // Not closed with a look at the console: the service workers of hosts that have ended may complain there.
}

/// Processor time of a frame while a loaded linkage plays with its force plan, arrows and plots.
async fn forces(page: &Page) {
    for name in ["slider-crank", "jansen", "class4-dwell"] {
        let document = assur_file::document(name).unwrap().unwrap();
        let mut document = serde_json::to_value(document).unwrap()["document"].take();
        for link in document["links"].as_array_mut().unwrap() {
            link["mass"] = json!(1);
        }
        document["gravity"] = json!([0, -10]);
        document["unit"] = json!("m");
        let script = format!(
            "const said = (value) => encodeURIComponent(typeof value === 'string' ? value : JSON.stringify(value));
            const pairs = Object.entries({document}).map(([key, value]) => `d.${{key}}=${{said(value)}}`);
            location.hash = ['2', 'kind=linkage', ...pairs, 'v.phi_deg=30', 'v.playing=true',
                'v.omega=2', 'v.direction=1', 'v.speed=1', 'v.traces=true', 'v.forces=true', 'v.force_plan=true', 'v.lang=en'].join('&')"
        );
        page.ask(&script).await;
        page.until("the plan", async || {
            page.count("#force-plan-shown:not([hidden])").await == 1
        })
        .await;
        have(page, "frames(30)").await;
        let shown = measured(page, Clock::Processor, &format!("frames({FRAMES})")).await;
        print(
            &format!("{name} playing with plan, arrows and plots, ms of processor"),
            shown.busy / FRAMES,
        );
    }
}

/// Processor time of a step while one of four poses is dragged, with both curves of hinges, and of five.
async fn poses(page: &Page) {
    page.anew(&format!("{}#poses-five&v.playing=false", home()))
        .await;
    for count in [5, 4] {
        page.until("the poses", async || page.count("[name=pair]").await > 0)
            .await;
        let place = format!("document.getElementById('field-pose-x-{count}').value");
        let before = page.ask(&format!("return {place}")).await;
        let mut is_measured = false;
        for (x, y) in page.handles().await {
            have(page, &format!("dragFrom({x}, {y}, 5)")).await;
            if page.ask(&format!("return {place}")).await == before {
                continue;
            }
            let drag = format!("dragFrom({x}, {y}, {STEPS})");
            let dragged = measured(page, Clock::Processor, &drag).await;
            print(
                &format!("step of a dragged pose of {count}, ms of processor"),
                dragged.busy / STEPS as f64,
            );
            is_measured = true;
            break;
        }
        assert!(is_measured, "no handle moves pose {count}");
        page.click(&format!("poses-remove-{count}")).await;
    }
}

/// The clock that measures the main thread. The clock on the wall counts other programs in; the thread's own does not.
#[derive(Clone, Copy)]
enum Clock {
    Wall,
    Processor,
}

/// What [`BENCH`] hands on, the seconds it took, and the time of the main thread in milliseconds.
struct Measured {
    numbers: Vec<f64>,
    seconds: f64,
    busy: f64,
}

/// Measures the page while it does something of [`BENCH`].
async fn measured(page: &Page, clock: Clock, what: &str) -> Measured {
    let domain = match clock {
        Clock::Wall => "timeTicks",
        Clock::Processor => "threadTicks",
    };
    page.tool("Performance.disable", json!({})).await;
    page.tool("Performance.enable", json!({ "timeDomain": domain }))
        .await;
    let before = metric(page, "TaskDuration").await;
    let start = Instant::now();
    let numbers = have(page, what).await;
    Measured {
        numbers,
        seconds: start.elapsed().as_secs_f64(),
        busy: (metric(page, "TaskDuration").await - before) * 1e3,
    }
}

/// Requests and bytes of a first visit until its first view stands, and how long it takes on this machine and over a slow line.
/// The host sends packed files.
async fn first_view(page: &Page) {
    page.tool("Network.enable", json!({})).await;
    page.tool("Network.setCacheDisabled", json!({ "cacheDisabled": true }))
        .await;
    for (line, latency, rate) in [
        ("on this machine", 0, -1),
        ("at 400 kB/s and 300 ms", 300, 400_000),
    ] {
        // A second visit to the same origin would be answered by the page's service worker.
        let host = Host::start(&folder(), "/");
        let limits = json!({ "offline": false, "latency": latency, "downloadThroughput": rate, "uploadThroughput": rate });
        page.tool("Network.emulateNetworkConditions", limits).await;
        page.anew(&host.url()).await;
        let [ready, requests, bytes] = page.numbers(FIRST_VIEW).await[..] else {
            panic!("three numbers")
        };
        print(&format!("first view {line}, ms"), ready);
        print(&format!("first view {line}, requests"), requests);
        print(&format!("first view {line}, brotli, kB"), bytes / 1e3);
    }
    let free =
        json!({ "offline": false, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1 });
    page.tool("Network.emulateNetworkConditions", free).await;
    page.tool(
        "Network.setCacheDisabled",
        json!({ "cacheDisabled": false }),
    )
    .await;
}

/// Time of the first view, and number and packed size of what was asked for before it.
const FIRST_VIEW: &str = "
    const ready = performance.getEntriesByName('ready')[0].startTime;
    const all = ['navigation', 'resource'].flatMap((type) => performance.getEntriesByType(type));
    const asked = all.filter(({ startTime }) => startTime < ready);
    arguments[0]([ready, asked.length, asked.reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0)])";

/// A figure of the browser's own bookkeeping.
async fn metric(page: &Page, name: &str) -> f64 {
    let metrics = page.driver.cdp().performance().get_metrics().await.unwrap();
    let metric = metrics.iter().find(|metric| metric.name == name);
    metric.unwrap().value
}

/// What the page holds while it is played and dragged.
async fn memory(page: &Page) {
    const LOOKS: u32 = 10;
    let minutes = env::var("ASSUR_MINUTES").ok();
    let minutes: f64 = minutes.map_or(0.5, |minutes| minutes.parse().unwrap());
    let mut held = Vec::new();
    let start = Instant::now();
    for look in 0..=LOOKS {
        let until = Duration::from_secs_f64(minutes * 60.0) * look / LOOKS;
        page.ask("bench.live()").await;
        tokio::time::sleep(until.saturating_sub(start.elapsed())).await;
        have(page, "end()").await;
        // What is still there after everything was thrown away that nobody needs.
        page.tool("HeapProfiler.collectGarbage", json!({})).await;
        let wasm = "arguments[0]([bench.memory.buffer.byteLength])";
        held.push([
            metric(page, "JSHeapUsedSize").await,
            page.numbers(wasm).await[0],
        ]);
    }
    for (what, index) in [("JavaScript heap", 0), ("wasm memory", 1)] {
        let most = held
            .iter()
            .fold(0.0, |most: f64, held| most.max(held[index]));
        for (when, bytes) in [
            ("at first", held[0][index]),
            ("half way", held[held.len() / 2][index]),
            ("most", most),
            ("at last", held[held.len() - 1][index]),
        ] {
            print(
                &format!("{what} over {minutes} min, {when}, kB"),
                bytes / 1e3,
            );
        }
    }
}

fn print(name: &str, figure: f64) {
    println!("page: {name} = {figure:.2}");
}
