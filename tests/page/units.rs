//! The unit of lengths: chosen for a document, kept with it, written beside every length.

use crate::browser::Page;
use crate::gallery::open;

async fn status(page: &Page) -> String {
    page.text("status").await
}

#[tokio::test]
async fn lengths_have_the_unit_of_their_document() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.write("angle", "30").await;
    assert_eq!(page.written("unit").await, "none");
    assert!(status(&page).await.contains("67.91 (F.x)"));

    page.choose("unit", "mm").await;
    assert!(status(&page).await.contains("67.91 mm (F.x)"));
    let texts = crate::plots::texts(&page).await;
    assert!(
        texts.iter().any(|text| text.contains("coordinates, mm")),
        "{texts:?}"
    );
    // By time and by the angle alike.
    page.choose("axes", "physical").await;
    let texts = crate::plots::texts(&page).await;
    for unit in ["velocity, mm/s", "acceleration, mm/s²"] {
        assert!(
            texts.iter().any(|text| text.contains(unit)),
            "{unit}: {texts:?}"
        );
    }
    // What is refused says by how much.
    page.write("field-length-1", "500").await;
    let sentence = page.text("problem").await;
    assert!(sentence.contains(" mm"), "{sentence}");
    page.chord(&[thirtyfour::Key::Control], 'z').await;

    // Kept: in the address, over a reload, in another language; and taken back.
    page.until("the address", async || {
        page.address().await.contains("unit=mm")
    })
    .await;
    page.reload().await;
    assert_eq!(page.written("unit").await, "mm");
    page.choose("lang", "ru").await;
    page.until("Russian", async || status(&page).await.contains("67,91 мм"))
        .await;
    page.close().await;
}

#[tokio::test]
async fn the_mixer_is_in_metres_unless_it_says_otherwise() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let heading = "#lengths";
    let above =
        format!("return document.querySelector('{heading}').previousElementSibling.textContent");
    assert_eq!(page.ask(&above).await, "Lengths, m");
    page.choose("unit", "cm").await;
    assert_eq!(page.ask(&above).await, "Lengths, cm");
    page.write("field-l1", "3").await;
    let sentence = page.text("problem").await;
    assert!(sentence.contains("0.75 cm"), "{sentence}");
    page.write("field-l1", "0.37").await;
    page.choose("unit", "none").await;
    assert_eq!(page.ask(&above).await, "Lengths");
    page.click("undo").await;
    page.click("undo").await;
    page.close().await;
}
