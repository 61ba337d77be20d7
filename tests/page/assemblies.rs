//! All assemblies: a picture of each, the map of their branches, which can be reached, and the others
//! dashed.

use serde_json::json;

use crate::browser::Page;
use crate::gallery::open;

/// Shows the pictures, if they are not shown.
async fn shown(page: &Page) {
    let there = "return !!document.querySelector('#assembly-pictures button:not([hidden])') && !document.getElementById('assemblies-shown').hidden";
    if page.ask(there).await != json!(true) {
        page.click("all_assemblies").await;
    }
    page.until("the pictures", async || {
        page.ask(there).await == json!(true)
    })
    .await;
}

/// Follows the assembly of a number at the input where it is.
pub(crate) async fn follow(page: &Page, number: usize) {
    shown(page).await;
    page.click(&format!("assembly-{number}-picture")).await;
    page.settle().await;
}

/// The number of the one that moves.
pub(crate) async fn followed(page: &Page) -> String {
    shown(page).await;
    let pressed = "return document.querySelector('#assembly-pictures button[aria-pressed=\"true\"]:not([hidden])')?.textContent ?? ''";
    page.ask(pressed).await.as_str().unwrap().to_owned()
}

async fn mapped(page: &Page) {
    page.until("the map", async || {
        page.ask("const map = document.getElementById('assembly-map'); return !!map && !map.hasAttribute('hidden') && !map.classList.contains('faded')")
            .await
            == json!(true)
    })
    .await;
}

async fn reach(page: &Page) -> Vec<String> {
    let items = page
        .ask("return [...document.querySelectorAll('#assembly-reach li')].map((one) => one.textContent)")
        .await;
    serde_json::from_value(items).unwrap()
}

/// Ten of fourteen where the Class IV mechanism has ten; the map has its twelve branches and eight
/// folds; a click follows another, at the same angle, and undo comes back.
#[tokio::test]
async fn ten_of_fourteen() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("275").await;
    shown(&page).await;
    let pictures = "#assembly-pictures button:not([hidden])";
    page.until("ten pictures", async || page.count(pictures).await == 10)
        .await;
    let count = page.text("assembly-count").await;
    assert!(count.contains("10") && count.contains("14"), "{count}");
    // The map has its place before it comes.
    let height = "return document.getElementById('assembly-map').getBoundingClientRect().height";
    let before = page.ask(height).await;
    assert!(before.as_f64().unwrap() > 100.0, "{before}");
    mapped(&page).await;
    assert_eq!(page.ask(height).await, before);
    assert_eq!(page.count("#assembly-map path").await, 12);
    assert_eq!(page.count("#assembly-map circle.fold").await, 8);
    assert_eq!(page.count("#assembly-map .map-other").await, 9);
    let painted = "const canvas = document.querySelector('#assembly-10-picture canvas');
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        return data.some((byte) => byte > 0)";
    assert_eq!(page.ask(painted).await, json!(true));
    let before = followed(&page).await;
    page.until("where it belongs", async || !reach(&page).await.is_empty())
        .await;
    // The drawn one turns fully, and none of the others is of its circuit.
    let lines = reach(&page).await;
    assert_eq!(lines.len(), 1, "{lines:?}");
    assert!(lines[0].contains("taking the linkage apart"), "{lines:?}");

    follow(&page, 1).await;
    assert_eq!(followed(&page).await, "1");
    assert_eq!(page.written("angle").await, "275.000°");
    page.until("the others of its circuit", async || {
        reach(&page)
            .await
            .iter()
            .any(|line| line.contains("dead points"))
    })
    .await;
    page.click("undo").await;
    page.settle().await;
    assert_eq!(followed(&page).await, before);
    page.close().await;
}

/// The two of a crank-rocker are of two circuits; the parallelogram's cross in its change points.
#[tokio::test]
async fn circuits_are_told_apart() {
    let page = Page::open().await;
    for (name, line) in [
        ("crank-rocker", "taking the linkage apart"),
        ("parallelogram", "change points"),
    ] {
        open(&page, name).await;
        page.stop_at("70").await;
        shown(&page).await;
        mapped(&page).await;
        page.until(name, async || {
            let lines = reach(&page).await;
            lines.len() == 1 && lines[0].contains(line)
        })
        .await;
    }
    page.close().await;
}

/// The other assemblies are dashed in the drawing on request, and in the address.
#[tokio::test]
async fn others_are_dashed() {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    page.stop_at("70").await;
    let ink = "const canvas = document.getElementById('mechanism');
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
        copy.drawImage(canvas, 0, 0);
        const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
        let sum = 0; for (let at = 0; at < data.length; at += 4) sum += data[at];
        return sum";
    let sum = async || page.ask(ink).await.as_f64().unwrap();
    let without = sum().await;
    page.click("others").await;
    page.settle().await;
    let dashes = (sum().await - without).abs();
    assert!(dashes > 1e4, "{dashes}");
    page.until("the address", async || {
        page.address().await.contains("v.others=true")
    })
    .await;
    page.click("others").await;
    page.settle().await;
    // Labels may stand elsewhere than before.
    let left = (sum().await - without).abs();
    assert!(left < 0.1 * dashes, "{left} of {dashes}");
    page.close().await;
}

/// A click on the map goes to that input, and there to the assembly that is nearest.
/// An engine beside the page that breaks is put away: the next linkage has another, and its map.
#[tokio::test]
async fn another_engine_is_taken_for_one_that_broke() {
    let page = Page::open().await;
    page.before(
        "window.Worker = class extends Worker {
          static begun = 0;
          #broken = ++this.constructor.begun === 1;
          postMessage(asked, ...more) {
            if (this.#broken) setTimeout(() => this.dispatchEvent(new MessageEvent('message', { data: { revision: asked.revision, lost: true, broken: true } })));
            else super.postMessage(asked, ...more);
          }
          terminate() {
            window.ended = (window.ended ?? 0) + 1;
            super.terminate();
          }
        };",
    )
    .await;
    page.reload().await;
    open(&page, "crank-rocker").await;
    page.stop_at("70").await;
    shown(&page).await;
    page.until("that there is no map", async || {
        page.text("assembly-mapped").await == "The map could not be drawn."
    })
    .await;
    assert_eq!(page.ask("return window.ended").await, json!(1));
    open(&page, "slider-crank").await;
    page.stop_at("70").await;
    shown(&page).await;
    mapped(&page).await;
    assert_eq!(page.ask("return window.ended").await, json!(1));
    page.close().await;
}

#[tokio::test]
async fn the_map_is_a_way_to_go() {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    page.stop_at("70").await;
    shown(&page).await;
    mapped(&page).await;
    let before = followed(&page).await;
    page.until("another motion", async || {
        // The dots move while the page takes its place.
        let other = page
            .ask(
                "const dot = document.querySelector('#assembly-map .map-other');
                dot.scrollIntoView({ block: 'center' });
                const { x, y, width, height } = dot.getBoundingClientRect();
                return [x + width / 2, y + height / 2]",
            )
            .await;
        let [x, y] = [0, 1].map(|k| other[k].as_f64().unwrap());
        let chain = page.hand();
        let chain = chain.move_to(x.round() as i64, y.round() as i64).click();
        chain.perform().await.unwrap();
        page.settle().await;
        followed(&page).await != before
    })
    .await;
    let angle = page.value("out-input").await;
    assert!((angle - 70.0).abs() < 2.0, "{angle}");
    page.close().await;
}
