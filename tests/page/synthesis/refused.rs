//! Refusals, free starts, other screens and languages.

use super::*;

/// Positions that no linkage takes up are said in a sentence in every language; the last good
/// drawing stays, and what was typed.
#[tokio::test]
async fn what_cannot_be_is_said() {
    let page = open(&preset("family")).await;
    let type_all = async |degrees: [&str; 4]| {
        let fields = ["output-1", "input-1", "output-2", "input-2"];
        for (field, text) in fields.iter().zip(degrees) {
            page.write(&format!("field-{field}"), text).await;
        }
    };
    let mut said = BTreeSet::new();
    for degrees in [["240", "45", "240", "45"], ["90", "120", "60", "100"]] {
        type_all(degrees).await;
        let faded = page.attribute("mechanism", "data-faded").await;
        assert_eq!(faded.as_deref(), Some("true"), "{degrees:?}");
        assert!(!listed(&page).await.is_empty() && !page.handles().await.is_empty());
        for lang in languages(3) {
            page.speak(lang).await;
            let text = page.text("problem").await;
            assert!(text.len() > 20 && !text.contains('{'), "{lang}: {text}");
            assert!(said.insert(text.clone()), "{lang}: {text}");
        }
        page.speak("en").await;
        assert_eq!(
            page.written("field-output-2").await,
            format!("{}°", degrees[2])
        );
    }
    type_all(["240", "45", "253", "60"]).await;
    assert_eq!(page.text("problem").await, "");
    page.write("field-frame", "0").await;
    assert!(page.text("problem").await.contains("l₀"));
    page.close().await;
}

/// Positions that ask for negative lengths are said with these.
#[tokio::test]
async fn negative_lengths_are_said() {
    let page = open(&preset("three")).await;
    page.write("field-output-3", "240").await;
    for (lang, lengths) in [("en", ["21.62", "−8.895"]), ("ru", ["21,62", "−8,895"])] {
        page.speak(lang).await;
        let said = page.text("problem").await;
        assert!(lengths.iter().all(|one| said.contains(one)), "{said}");
    }
    page.close().await;
}

/// With free starts five positions are needed: those of a linkage give it back, told with its starts.
#[tokio::test]
async fn starts_are_free() {
    let page = open(&preset("three")).await;
    page.click("free").await;
    let said = page.text("problem").await;
    assert!(said.contains('5') && said.contains('3'), "{said}");
    page.click("free").await;
    assert_eq!(page.text("problem").await, "");

    let linkage = FourBar::new([3.0, 9.0, 7.0, 10.0]).unwrap();
    let position = |input: f64| {
        let pose = linkage.pose::<1>(Assembly::First, input.to_radians());
        let rocker = pose.unwrap().rocker.value().to_degrees();
        // The start of the output is 25°.
        json!({ "output_deg": (rocker + 180.0 - 25.0).rem_euclid(360.0), "input_deg": input })
    };
    let positions = [20.0, 80.0, 150.0, 220.0, 300.0].map(position);
    let wanted = json!({ "frame": 10, "positions": positions, "free": true });
    page.anew(&link(&wanted)).await;
    there(&page).await;
    assert_eq!(page.text("problem").await, "");
    let all = listed(&page).await;
    let found = all.iter().any(|one| {
        let lengths = ["l₁ =", "l₂ =", "l₃ ="].map(|sign| after(one, sign));
        lengths == [9.0, 7.0, 3.0] && one.contains("φ₂₀ = 25°")
    });
    assert!(found, "{all:#?}");
    page.close().await;
}

/// On a phone nothing overlaps or leaves the screen; opened again, everything is as it was.
#[tokio::test]
async fn on_a_phone_and_opened_again() {
    let page = open(&preset("many")).await;
    page.write("field-weight-2", "2.5").await;
    let [_, other] = two_of_many();
    page.click(&format!("solution-{other}")).await;
    page.touched().await;
    for size in [(390, 844), (1280, 800)] {
        page.screen(size, 1.0).await;
        let found = defects(&page, 44).await;
        assert_eq!(found, json!([]), "{size:?}");
    }
    let all = listed(&page).await;
    page.until("the address to follow", async || {
        page.address()
            .await
            .contains(&format!("d.solution={other}"))
    })
    .await;
    page.reload().await;
    there(&page).await;
    assert_eq!(listed(&page).await, all);
    assert_eq!(page.written("field-weight-2").await, "2.5");
    assert!(
        page.element(&format!("solution-{other}"))
            .await
            .is_selected()
            .await
            .unwrap()
    );
    page.close().await;
}

/// All that is of this kind is said in the reader's language.
#[tokio::test]
async fn in_every_language() {
    let page = open(&preset("three")).await;
    let mut texts = BTreeSet::new();
    for lang in languages(0) {
        page.speak(lang).await;
        let text = page
            .ask("return [...document.querySelectorAll('[data-of=synthesis]')].map((one) => one.innerText).join(' ')")
            .await;
        let text = text.as_str().unwrap().to_owned();
        // A key that has no words stands there itself.
        let keys = [
            "positions.",
            "solutions.",
            "verdict.",
            "conditions.",
            "map.",
            "name.",
        ];
        assert!(keys.iter().all(|key| !text.contains(key)), "{lang}: {text}");
        assert!(text.len() > 200 && texts.insert(text), "{lang}");
    }
    page.close().await;
}

/// What axe finds where all of a synthesis is unfolded: nothing, in light and in dark.
#[tokio::test]
async fn axe_finds_nothing() {
    for name in ["family", "many", "printed"] {
        let page = open(&preset(name)).await;
        page.ask(AXE).await;
        page.ask("for (const one of document.querySelectorAll('[data-of=synthesis] details')) one.open = true")
            .await;
        for scheme in ["light", "dark"] {
            page.prefer("prefers-color-scheme", scheme).await;
            check(&page, &format!("{name} {scheme}")).await;
        }
        page.close().await;
    }
}
