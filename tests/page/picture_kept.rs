//! A picture behind the drawing is part of the state: kept, saved, undone; damaged ones, and large ones.

use std::fs;

use serde_json::{Value, json};
use thirtyfour::Key;

use crate::browser::Page;
use crate::draw::Sheet;
use crate::host::home;
use crate::picture_behind::{FROM, SCAN, TO, file, taken};

/// Where the two spots of the scan are seen.
async fn spots(page: &Page) -> Vec<(f64, f64)> {
    let seen = page.picture("mechanism").await;
    [FROM, TO]
        .map(|spot| seen.cloud(spot))
        .into_iter()
        .filter(|cloud| cloud.count > 20)
        .map(|cloud| (cloud.x, cloud.y))
        .collect()
}

/// They are where they were.
async fn back(page: &Page, before: &[(f64, f64)]) {
    page.until("the spots", async || {
        let now = spots(page).await;
        let near =
            |((x, y), (left, top)): (&(f64, f64), &(f64, f64))| (x - left).hypot(y - top) < 2.0;
        now.len() == before.len() && now.iter().zip(before).all(near)
    })
    .await;
}

/// Both are there again.
async fn seen(page: &Page) {
    page.until("the spots", async || spots(page).await.len() == 2)
        .await;
}

/// What a file of the page holds.
async fn saved(page: &Page) -> Value {
    page.click("menu").await;
    page.click("save").await;
    serde_json::from_slice(&page.saved("draft.assur.json").await).unwrap()
}

/// A sheet with a point, and the scan behind it.
async fn with_scan(page: &Page) -> Sheet<'_> {
    let mut sheet = Sheet::new(page).await;
    sheet.press(1.0, 1.0).await;
    sheet.end().await;
    sheet.tool("picture").await;
    let scan = file("kept.svg", SCAN);
    page.choose_file("draw-picture-file", &scan).await;
    taken(page).await;
    page.press("draw-picture-opacity", Key::End).await;
    sheet
}

#[tokio::test]
async fn a_picture_is_kept_saved_and_undone_but_in_no_link() {
    let page = Page::open().await;
    let mut sheet = with_scan(&page).await;
    for (x, y) in spots(&page).await {
        page.drag_along("mechanism", &[(x, y)]).await;
    }
    page.write("draw-picture-angle", "30").await;
    page.write("draw-picture-length", "2").await;
    let laid = spots(&page).await;
    assert_eq!(laid.len(), 2);

    // One step of undo for each number, and for the picture itself.
    page.click("undo").await;
    page.settle().await;
    let before = spots(&page).await;
    assert!((before[1].0 - laid[1].0).abs() > 5.0, "{before:?} {laid:?}");
    for _ in 0..3 {
        page.click("undo").await;
    }
    page.until("no picture", async || spots(&page).await.is_empty())
        .await;
    for _ in 0..4 {
        page.click("redo").await;
    }
    back(&page, &laid).await;

    // The link has none, and says so.
    page.click("menu").await;
    assert_eq!(
        page.text("copy-without").await,
        "without the picture behind the drawing"
    );
    page.click("menu").await;
    page.until("the address", async || {
        page.address().await.contains("d.points=")
    })
    .await;
    assert!(!page.address().await.contains("picture"));

    // The browser keeps it, the image by itself. (The paper is fitted anew.)
    let file_of = saved(&page).await;
    page.reload().await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    seen(&page).await;
    assert_eq!(saved(&page).await, file_of);
    let kept = page.ask("dispatchEvent(new Event('pagehide')); return localStorage.getItem('assur.state').length").await;
    assert!(kept.as_u64().unwrap() < 3000, "{kept}");

    let picture = &file_of["picture"];
    let image = picture["image"].as_str().unwrap();
    assert!(image.starts_with("data:image/svg+xml;base64,"), "{image}");
    let [turn, opacity] = ["turn_deg", "opacity"].map(|part| picture[part].as_f64().unwrap());
    assert_eq!(opacity, 1.0);
    // The spots of the scan are 180 to the right and 120 up of each other.
    let slope = f64::atan2(120.0, 180.0).to_degrees();
    assert!((turn - (30.0 - slope)).abs() < 1.0, "{turn}");
    let wide = picture["width"].as_f64().unwrap();
    assert!(
        (wide / (2.0 * 600.0 / 180_f64.hypot(120.0)) - 1.0).abs() < 0.02,
        "{wide}"
    );

    // Another mechanism has none; the file brings it back, elsewhere as well.
    page.anew(&format!("{}#jansen", home())).await;
    page.ask("localStorage.clear()").await;
    page.click("draw").await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    assert!(spots(&page).await.is_empty());
    let path = page.downloads().join("scan.assur.json");
    fs::write(&path, file_of.to_string()).unwrap();
    page.choose_file("file", &path).await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    seen(&page).await;
    assert_eq!(saved(&page).await, file_of);
    assert_eq!(
        page.ask("return [window.hacked ?? null, document.images.length]")
            .await,
        json!([null, 0])
    );
    sheet.tool("picture").await;
    page.click("draw-picture-remove").await;
    page.until("no picture", async || spots(&page).await.is_empty())
        .await;
    assert_eq!(saved(&page).await.get("picture"), None);
    page.close().await;
}

#[tokio::test]
async fn a_damaged_picture_is_told_by_its_field() {
    let page = Page::open().await;
    with_scan(&page).await;
    // An opened file is shown whole.
    page.click("zoom-fit").await;
    let seen = spots(&page).await;
    let good = saved(&page).await;
    let image = good["picture"]["image"].as_str().unwrap();
    let long = format!("data:image/png;base64,{}", "A".repeat(2_000_000));
    for (part, value, said) in [
        (
            "image",
            json!("https://example.org/scan.png"),
            "Picture behind the drawing: must be a PNG",
        ),
        (
            "image",
            json!("data:text/html;base64,PGI+"),
            "Picture behind the drawing: must be a PNG",
        ),
        (
            "image",
            json!("<img src=x onerror='parent.hacked = true'>"),
            "Picture behind the drawing: must be a PNG",
        ),
        (
            "image",
            json!(image[..image.len() - 1]),
            "Picture behind the drawing: part of it is missing",
        ),
        (
            "image",
            json!(long),
            "Picture behind the drawing: no more than",
        ),
        ("image", json!(7), "picture.image"),
        ("width", json!(0), "Width of the picture"),
        ("opacity", json!(2), "Opacity of the picture"),
        ("at", json!([0]), "picture.at"),
        ("onload", json!("parent.hacked = true"), "picture.onload"),
    ] {
        let mut bad = good.clone();
        bad["picture"][part] = value;
        let path = page.downloads().join("bad.assur.json");
        fs::write(&path, bad.to_string()).unwrap();
        page.choose_file("file", &path).await;
        page.until(said, async || page.text("notice-text").await.contains(said))
            .await;
        page.click("notice-close").await;
    }
    // The limit of all else is what it was.
    let mut bad = good.clone();
    bad["document"]["title"] = json!("x".repeat(400_000));
    let path = page.downloads().join("bad.assur.json");
    fs::write(&path, bad.to_string()).unwrap();
    page.choose_file("file", &path).await;
    page.until("the sentence", async || {
        page.count("#notice:not([hidden])").await == 1
    })
    .await;
    back(&page, &seen).await;

    // What is written well and is no picture all the same is told when it is shown.
    let mut bad = good.clone();
    bad["picture"]["image"] = json!("data:image/png;base64,AAAA");
    fs::write(&path, bad.to_string()).unwrap();
    page.choose_file("file", &path).await;
    page.until("the sentence", async || {
        page.text("problem").await == "The browser cannot show this file as a picture."
    })
    .await;
    assert_eq!(
        page.ask("return [window.hacked ?? null, document.images.length]")
            .await,
        json!([null, 0])
    );
    page.click("undo").await;
    page.click("zoom-fit").await;
    back(&page, &seen).await;
    page.close().await;
}

/// A photograph without compression, as a camera would not write it: so it is made here.
fn photograph(width: u32, height: u32) -> Vec<u8> {
    let size = width * height * 3;
    let mut file = b"BM".to_vec();
    for number in [
        54 + size,
        0,
        54,
        40,
        width,
        height,
        1 | (24 << 16),
        0,
        size,
        0,
        0,
        0,
        0,
    ] {
        file.extend(number.to_le_bytes());
    }
    let pixels = (0..width * height).flat_map(|at| {
        let (x, y) = (at % width, at / width);
        [
            (x / 8) as u8,
            (y / 8) as u8,
            ((x / 40 + y / 40) % 2 * 200) as u8,
        ]
    });
    file.extend(pixels);
    file
}

#[tokio::test]
async fn a_large_photograph_is_made_smaller_and_what_does_not_fit_is_said() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.tool("picture").await;
    let large = file("large.bmp", photograph(3000, 1200));
    page.choose_file("draw-picture-file", &large).await;
    taken(&page).await;
    let image = saved(&page).await["picture"]["image"].clone();
    let seen = page
        .ask_later(
            "const image = new Image();
            image.src = arguments[0];
            image.decode().then(() => arguments[1]([image.naturalWidth, image.naturalHeight]));",
            vec![image.clone()],
        )
        .await;
    assert_eq!(seen, json!([2000, 800]));
    let image = image.as_str().unwrap();
    assert!(image.starts_with("data:image/jpeg;base64,"));
    assert!(image.len() < 2_000_000, "{}", image.len());
    assert_eq!(page.text("notice-text").await, "");

    // A browser that has no room for it says so; what is drawn is kept all the same.
    page.click("draw-picture-remove").await;
    page.until("no image kept", async || {
        page.ask("return localStorage.getItem('assur.image')").await == Value::Null
    })
    .await;
    page.ask("localStorage.setItem('spare', 'x'.repeat(16384))")
        .await;
    page.ask("for (let length = 2 ** 22; length >= 1; length /= 2) for (let times = 0; times < 2; times++) try { localStorage.setItem(`full.${length}.${times}`, 'x'.repeat(length)); } catch {}")
        .await;
    page.ask("localStorage.removeItem('spare')").await;
    sheet.tool("picture").await;
    page.choose_file("draw-picture-file", &large).await;
    taken(&page).await;
    page.until("the sentence", async || {
        page.text("notice-text")
            .await
            .contains("no room left for the picture")
    })
    .await;
    page.reload().await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    sheet.tool("picture").await;
    assert_eq!(
        page.count("#draw-picture-options .draw-base[hidden] > #draw-picture-remove")
            .await,
        1
    );
    page.close().await;
}
