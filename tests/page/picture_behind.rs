//! A picture behind the drawing: laid by two of its places, and what is none.

use std::fs;
use std::path::PathBuf;

use thirtyfour::Key;

use crate::access;
use crate::browser::Page;
use crate::draw::Sheet;

/// Colours that nothing else on the page has.
pub(crate) const FROM: [u8; 3] = [0xFF, 0x00, 0xFF];
pub(crate) const TO: [u8; 3] = [0x00, 0xFF, 0xFF];

/// A scan as a file: two coloured spots on white, and a script that must not run.
pub(crate) const SCAN: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400" onload="parent.hacked = true">
<script>parent.hacked = true</script><rect width="600" height="400" fill="#fff"/>
<rect x="190" y="240" width="20" height="20" fill="#f0f"/><rect x="370" y="120" width="20" height="20" fill="#0ff"/></svg>"##;

/// A file with a content.
pub(crate) fn file(name: &str, content: impl AsRef<[u8]>) -> PathBuf {
    let path = std::env::temp_dir().join(format!("{}-{name}", std::process::id()));
    fs::write(&path, content).unwrap();
    path
}

/// Once there is one behind the drawing.
pub(crate) async fn taken(page: &Page) {
    page.until("the picture", async || {
        let remove = page.element("draw-picture-remove").await;
        remove.is_displayed().await.unwrap()
    })
    .await;
}

#[tokio::test]
async fn a_picture_is_laid_by_two_of_its_places() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.tool("picture").await;
    assert_eq!(page.count("#draw-picture-options:not([hidden])").await, 1);
    let scan = file("scan.svg", SCAN);
    page.choose_file("draw-picture-file", &scan).await;
    taken(&page).await;
    page.press("draw-picture-opacity", Key::End).await;
    // Its two spots are pressed where they are seen.
    let before = page.picture("mechanism").await;
    for spot in [FROM, TO] {
        let seen = before.cloud(spot);
        assert!(seen.count > 100, "{seen:?}");
        page.drag_along("mechanism", &[(seen.x, seen.y)]).await;
    }
    for (part, value) in [
        ("length", "2.5"),
        ("angle", "-30"),
        ("x", "-1"),
        ("y", "1,5"),
    ] {
        page.write(&format!("draw-picture-{part}"), value).await;
    }
    let (sine, cosine) = (-30.0_f64).to_radians().sin_cos();
    let after = page.picture("mechanism").await;
    for (spot, place) in [
        (FROM, [-1.0, 1.5]),
        (TO, [-1.0 + 2.5 * cosine, 1.5 + 2.5 * sine]),
    ] {
        let seen = after.cloud(spot);
        let (x, y) = sheet.at(place);
        let off = (seen.x - x).hypot(seen.y - y);
        assert!(off < 3.0, "{off} pixels at {place:?}");
    }
    assert_eq!(
        page.ask("return window.hacked ?? null").await,
        serde_json::Value::Null
    );
    page.ask(access::AXE).await;
    access::check(&page, "a picture behind the drawing").await;

    // No length, and what is no picture: a sentence each, and the picture stays.
    page.write("draw-picture-length", "-2").await;
    assert_eq!(
        page.text("problem").await,
        "The distance must be greater than zero."
    );
    let none = file("none.png", "<img src=x onerror='parent.hacked = true'>");
    page.choose_file("draw-picture-file", &none).await;
    page.until("the sentence", async || {
        page.text("problem").await == "This is no picture that the browser can show."
    })
    .await;
    assert_eq!(
        page.ask("return window.hacked ?? null").await,
        serde_json::Value::Null
    );
    let still = page.picture("mechanism").await;
    assert!(still.cloud(FROM).count > 20);

    // Links are drawn over it; it is in no link.
    sheet.tool("bars").await;
    sheet.line(&[[-1.0, 1.5], [1.0, 0.0]]).await;
    sheet.end().await;
    assert_eq!(page.text("problem").await, "");
    assert!(page.count("#draw-points input").await == 4);
    sheet.tool("picture").await;
    page.click("draw-picture-remove").await;
    assert_eq!(page.picture("mechanism").await.places(FROM).count(), 0);
    page.close().await;
}
