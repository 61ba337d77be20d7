//! The constraint equations of a linkage on the page.

use assur::mechanism::ConstraintKind;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::gallery::{document, open};

async fn unfold(page: &Page) {
    let heading = page.driver.find(By::Css("#equations > summary")).await;
    heading.unwrap().click().await.unwrap();
    page.settle().await;
}

/// What the page shows of an equation: left side, right side, residual.
async fn shown(page: &Page, equation: usize) -> [f64; 3] {
    let cell = async |side: &str| page.value(&format!("equation-{equation}-{side}")).await;
    [
        cell("left").await,
        cell("right").await,
        cell("residual").await,
    ]
}

/// All of them are those of the engine, in the order that is chosen.
async fn agree(page: &Page, name: &str, order: usize) {
    let document = document(name);
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let phi = page.value("out-input").await;
    let pose = motion.pose::<3>(phi.to_radians()).unwrap();
    let rows = page.count("#equations tbody tr").await;
    assert_eq!(rows, mechanism.constraints().len(), "{name}");
    for (index, constraint) in mechanism.constraints().iter().enumerate() {
        let sides = mechanism.sides(&pose, constraint, order);
        let [left, right, residual] = shown(page, index).await;
        for (shown, expected) in [(left, sides.left), (right, sides.right)] {
            assert!(
                (shown - expected).abs() <= 1e-9 * expected.abs().max(1.0),
                "{name} {index} {order}: {shown} {expected}"
            );
        }
        assert_eq!(residual, left - right, "{name} {index}");
        assert!(residual.abs() < 1e-9, "{name} {index} {order}: {residual}");
    }
}

/// Of the Class IV mechanism thirteen, with both derivatives, at the angle there is;
/// numbers are the reader's, a residual is rounding and is seen.
#[tokio::test]
async fn equations_stand_in_numbers() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("60").await;
    unfold(&page).await;
    assert_eq!(
        page.text("equation-6").await,
        "(xH − xL)² + (yH − yL)² = l²HL"
    );
    agree(&page, "class4-dwell", 0).await;
    // From H(4.07, 1.73) to L(1.41, −2.63).
    assert_eq!(page.text("equation-6-right").await, "26.0852");
    let mut residuals = 0.0;
    for index in 0..13 {
        residuals += shown(&page, index).await[2].abs();
    }
    assert!(residuals > 0.0);
    let before = shown(&page, 1).await;
    page.stop_at("61").await;
    assert_ne!(shown(&page, 1).await, before);
    for (order, equation) in [
        (1, "xHL x′HL + yHL y′HL = 0"),
        (2, "xHL x″HL + yHL y″HL = −x′²HL − y′²HL"),
    ] {
        page.choose("equations-order", &order.to_string()).await;
        assert_eq!(page.text("equation-6").await, equation);
        agree(&page, "class4-dwell", order).await;
    }
    let accelerated = page.text("equation-10-left").await;
    page.choose("lang", "ru").await;
    page.until("the words", async || {
        page.text("equation-10-left").await == accelerated.replace('.', ",")
    })
    .await;
    // While it moves the numbers go on, and what the engine refuses leaves them.
    let before = shown(&page, 10).await;
    page.click("play").await;
    page.until("other numbers", async || shown(&page, 10).await != before)
        .await;
    page.stop_at("75").await;
    page.settle().await;
    assert_eq!(page.value("out-input").await, 75.0);
    let last = shown(&page, 10).await;
    // No part of it is taken either, which a frame between two keys might show.
    page.write("field-length-0", "-40").await;
    page.until("a sentence", async || {
        !page.text("problem").await.is_empty()
    })
    .await;
    assert_eq!(shown(&page, 10).await, last);
    page.close().await;
}

/// Slides have two equations each, wheels one; a dead point has no derivatives.
#[tokio::test]
async fn equations_of_slides_and_wheels() {
    let page = Page::open().await;
    page.stop_at("40").await;
    unfold_of(&page, "whitworth").await;
    agree(&page, "whitworth", 0).await;
    let kinds = document("whitworth").motion().unwrap();
    let slides = kinds.mechanism().constraints().into_iter();
    let slides = slides.filter(|one| matches!(one.kind, ConstraintKind::Offset { .. }));
    let texts = page.text("equations").await;
    assert_eq!(texts.matches("= h·l").count(), slides.count());
    open(&page, "geared-five-bar").await;
    agree(&page, "geared-five-bar", 0).await;
    let texts = page.text("equations").await;
    assert!(texts.contains("40(θcrank − θframe) + 20(θfollower − θframe) = α"));
    page.choose("equations-order", "1").await;
    agree(&page, "geared-five-bar", 1).await;

    // Watt's chain driven by its rocker has a dead point at 90°; nothing joins at 180°.
    open(&page, "watt-1").await;
    page.choose("driver", "rocker").await;
    page.settle().await;
    page.stop_at("180").await;
    assert_eq!(page.text("equation-1-left").await, "—");
    page.stop_at("90").await;
    assert_eq!(page.text("equation-1-left").await, "—");
    page.choose("equations-order", "0").await;
    let [left, right, residual] = shown(&page, 1).await;
    assert!(residual == left - right && residual.abs() < 1e-9);
    page.close().await;
}

async fn unfold_of(page: &Page, name: &str) {
    open(page, name).await;
    unfold(page).await;
}
