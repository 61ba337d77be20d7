//! Impossible and nonsensical input: a sentence that names the thing at fault,
//! the last good drawing stays, and good input recovers.

use crate::browser::Page;
use crate::picture::Picture;

/// Pixels by which two pictures of the same drawing may differ: edges are smoothed
/// from what was drawn before.
const ALIKE: usize = 20;

/// Whether the drawing is that of a picture: what was faded comes back by and by.
async fn alike(page: &Page, good: &Picture) -> bool {
    page.picture("mechanism").await.difference(good) < ALIKE
}

#[tokio::test]
async fn impossible_length_and_back() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let good = page.picture("mechanism").await;
    let swing = page.text("out-swing-rocker").await;

    page.write("field-l4", "2").await;
    let sentence = page.text("problem").await;
    assert!(
        sentence.contains("l₄") || sentence.contains("frame"),
        "{sentence}"
    );
    assert!(sentence.contains("0.23"), "by how much: {sentence}");
    assert_eq!(
        page.attribute("mechanism", "data-faded").await.as_deref(),
        Some("true")
    );
    assert_eq!(
        page.attribute("field-l4", "aria-invalid").await.as_deref(),
        Some("true")
    );
    assert_eq!(page.written("field-l4").await, "2");
    assert_eq!(page.text("out-swing-rocker").await, swing);
    // Still there, only fainter.
    let faded = page.picture("mechanism").await;
    assert!(
        faded.ink() < 0.97 * good.ink(),
        "{} {}",
        faded.ink(),
        good.ink()
    );
    assert!(faded.difference(&good) > 1000);

    page.write("field-l4", "0.85").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(
        page.attribute("mechanism", "data-faded").await.as_deref(),
        Some("false")
    );
    assert_ne!(
        page.attribute("field-l4", "aria-invalid").await.as_deref(),
        Some("true")
    );
    page.until("the drawing", async || alike(&page, &good).await)
        .await;
    page.close().await;
}

#[tokio::test]
async fn bad_numbers_are_named_and_recovered_from() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let good = page.picture("mechanism").await;
    for (field, back, bad) in [
        ("field-l1", "0.37", &["-0.37", "abc"][..]),
        ("field-z5", "18", &["1.5"]),
    ] {
        for text in bad {
            page.write(field, text).await;
            let sentence = page.text("problem").await;
            assert!(sentence.len() > 10, "{field} {text:?}: {sentence:?}");
            assert!(!sentence.contains('{'), "a place left empty: {sentence}");
            assert_eq!(
                page.attribute(field, "aria-invalid").await.as_deref(),
                Some("true"),
                "{field} {text:?}"
            );
            // A number may be written out anew, a text that is none stays as it is.
            let number = |text: &str| text.replace('−', "-").replace(',', ".").parse::<f64>().ok();
            let written = page.written(field).await;
            let same = written == *text || number(&written) == number(text);
            assert!(same, "{text:?} became {written:?}");
        }
        page.write(field, back).await;
        assert_eq!(page.text("problem").await, "", "{field}");
        page.until(field, async || alike(&page, &good).await).await;
    }
    page.close().await;
}

/// Lengths with which the crank turns only near φ₁ = 0.
async fn swings(page: &Page) {
    for (field, length) in [
        ("field-l1", "0.8"),
        ("field-l2", "0.4"),
        ("field-l3", "0.55"),
    ] {
        page.write(field, length).await;
    }
}

/// An angle at which the loop cannot be closed: a sentence, and the way back.
#[tokio::test]
async fn angle_without_a_pose() {
    let page = Page::open().await;
    page.stop_at("10").await;
    swings(&page).await;
    assert_eq!(page.text("problem").await, "");
    page.write("angle", "170").await;
    let sentence = page.text("problem").await;
    assert!(sentence.contains("170"), "{sentence}");
    assert_eq!(
        page.attribute("mechanism", "data-faded").await.as_deref(),
        Some("true")
    );
    page.write("angle", "10").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(
        page.attribute("mechanism", "data-faded").await.as_deref(),
        Some("false")
    );
    page.close().await;
}

/// Where the plots break, numbers and drawing go on, and a sentence says so; with another mechanism they are tried again.
#[tokio::test]
async fn a_view_that_breaks_stops_no_other() {
    let page = Page::open().await;
    page.stop_at("75").await;
    // Of the page: a script of the driver has prototypes of its own in Firefox.
    page.ask(
        "const script = document.createElement('script');
        script.textContent = `const { fillText } = CanvasRenderingContext2D.prototype;
            CanvasRenderingContext2D.prototype.fillText = () => { throw new Error('broken for the test'); };
            globalThis.mend = () => { CanvasRenderingContext2D.prototype.fillText = fillText; };`;
        document.head.append(script);",
    )
    .await;
    page.write("angle", "100").await;
    page.until("the sentence", async || {
        let told = page.text("notice-text").await;
        told.contains("Part of the page broke")
    })
    .await;
    assert!((page.value("out-input").await - 100.0).abs() < 1e-9);
    let rate = page.value("out-rocker.angle′").await;
    page.write("angle", "130").await;
    assert_ne!(page.value("out-rocker.angle′").await, rate);
    // Of an error on the console the line of Chromium names the kind alone.
    let said = page.said().await;
    let of_the_test = ["broken for the test", "text: Some(\"error\")"];
    let known = |line: &String| of_the_test.iter().any(|text| line.contains(text));
    assert!(!said.is_empty() && said.iter().all(known), "{said:#?}");

    page.ask("const script = document.createElement('script'); script.textContent = 'mend()'; document.head.append(script)")
        .await;
    page.click("notice-close").await;
    page.write("field-l2", "0.8").await;
    assert_eq!(page.text("notice-text").await, "");
    page.close().await;
}

/// A file of 2 GB is refused by its size, and the scripts keep none of it.
#[tokio::test]
async fn a_file_of_two_gigabytes_is_refused() {
    let page = Page::open().await;
    let path = page.downloads().join("huge.json");
    std::fs::File::create(&path)
        .unwrap()
        .set_len(2 << 30)
        .unwrap();
    let heap = "return performance.memory?.usedJSHeapSize ?? 0";
    let before = page.ask(heap).await.as_f64().unwrap();
    page.choose_file("file", &path).await;
    page.until("a refusal", async || {
        page.text("notice-text").await.contains("huge.json")
    })
    .await;
    let after = page.ask(heap).await.as_f64().unwrap();
    assert!(after - before < 64e6, "{before} {after}");
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}
