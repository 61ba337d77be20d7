//! A walk past all lessons, a third of the gallery, drawing, polygons and measures, on every kind of screen: no defect of the
//! layout, nothing that axe finds.
//!
//! The quick run looks at a few stops, each in one language on two screens.

use serde_json::{Value, json};

use crate::access::{AXE, violations};
use crate::browser::Page;
use crate::device::LANGUAGES;
use crate::host::home;
use crate::layout::defects;

/// The lessons, with the steps to look at, a third of the gallery, and what is laid beside it.
const STOPS: [&str; 31] = [
    "mixer-a&v.lesson=%7B%22id%22:%22mixer%22,%22step%22:1%7D",
    "mixer-a&v.lesson=%7B%22id%22:%22mixer%22,%22step%22:5%7D",
    "class4-dwell&v.lesson=%7B%22id%22:%22class4-dwell%22,%22step%22:3%7D",
    "class4-dwell&v.lesson=%7B%22id%22:%22class4-dwell%22,%22step%22:5%7D",
    "train-magnets&v.lesson=%7B%22id%22:%22differential%22,%22step%22:2%7D",
    "train-magnets&v.lesson=%7B%22id%22:%22differential%22,%22step%22:5%7D",
    "mobility-2a&v.lesson=%7B%22id%22:%22mobility%22,%22step%22:1%7D",
    "mobility-3&v.lesson=%7B%22id%22:%22mobility%22,%22step%22:4%7D",
    "class3-platform&v.lesson=%7B%22id%22:%22assemblies%22,%22step%22:2%7D",
    "triple-rocker&v.lesson=%7B%22id%22:%22assemblies%22,%22step%22:5%7D",
    "crank-rocker",
    "parallelogram",
    "peaucellier",
    "chebyshev",
    "jansen",
    "klann",
    "shaper",
    "whitworth",
    "scotch-yoke",
    "elliptic-trammel",
    "oldham",
    "slider-crank-offset",
    "pump-jack",
    "v-twin",
    "planetary",
    "class5",
    "crank-rocker&v.drawing=true",
    "shaper&v.drawing=true",
    "whitworth&v.polygons=true&v.instant_centres=true",
    "crank-rocker&v.against=%7B%22x%22:%22C.x%22,%22y%22:%22C.y%22%7D&v.measures=%5B%22A-C.distance%22,%22A-B-C.corner%22%5D",
    "crank-rocker&compared=%7B%22kind%22:%22linkage%22,%22document%22:%7B%22points%22:%5B%7B%22name%22:%22A%22,%22at%22:%5B0,0%5D%7D,%7B%22name%22:%22B%22,%22at%22:%5B1,1%5D%7D,%7B%22name%22:%22C%22,%22at%22:%5B4.5,4%5D%7D,%7B%22name%22:%22D%22,%22at%22:%5B6,0%5D%7D%5D,%22frame%22:%5B%22A%22,%22D%22%5D,%22links%22:%5B%7B%22name%22:%22crank%22,%22points%22:%5B%22A%22,%22B%22%5D%7D,%7B%22name%22:%22coupler%22,%22points%22:%5B%22B%22,%22C%22%5D%7D,%7B%22name%22:%22rocker%22,%22points%22:%5B%22D%22,%22C%22%5D%7D%5D,%22drivers%22:%5B%7B%22crank%22:%22crank%22%7D%5D%7D%7D",
];

const SCREENS: [Screen; 7] = [
    ((1920, 1080), false, false),
    ((1280, 800), false, false),
    ((1280, 800), true, false),
    ((360, 740), false, false),
    ((740, 360), true, false),
    ((600, 400), false, false),
    ((1024, 768), false, true),
];

/// All stops in one language, on all screens.
async fn whole(lang: &str) {
    let mut found = Vec::new();
    for stop in STOPS {
        found.extend(wrong(stop, lang, &SCREENS).await);
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[tokio::test]
#[ignore = "long; quick: tour::nothing_is_covered_or_cut_at_a_few_stops"]
async fn nothing_is_covered_or_cut_in_english() {
    whole("en").await;
}

#[tokio::test]
#[ignore = "long; quick: tour::nothing_is_covered_or_cut_at_a_few_stops"]
async fn nothing_is_covered_or_cut_in_russian() {
    whole("ru").await;
}

#[tokio::test]
#[ignore = "long; quick: tour::nothing_is_covered_or_cut_at_a_few_stops"]
async fn nothing_is_covered_or_cut_in_ukrainian() {
    whole("uk").await;
}

#[tokio::test]
#[ignore = "long; quick: tour::nothing_is_covered_or_cut_at_a_few_stops"]
async fn nothing_is_covered_or_cut_in_kazakh() {
    whole("kk").await;
}

#[tokio::test]
async fn nothing_is_covered_or_cut_at_a_few_stops() {
    let mut found = Vec::new();
    for (at, stop) in STOPS.iter().step_by(4).enumerate() {
        let lang = LANGUAGES[at % LANGUAGES.len()];
        let screens = [
            SCREENS[at % SCREENS.len()],
            SCREENS[(at + 3) % SCREENS.len()],
        ];
        found.extend(wrong(stop, lang, &screens).await);
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// A window, whether it is dark, whether it is the projector's.
type Screen = ((u32, u32), bool, bool);

/// The defects of a stop in a language on some screens.
async fn wrong(stop: &str, lang: &str, screens: &[Screen]) -> Vec<(String, Value)> {
    let mut found = Vec::new();
    let url = format!("{}#{stop}&v.playing=false", home());
    let page = Page::open_at(&url, "en-US").await;
    page.ask(AXE).await;
    page.speak(lang).await;
    for &(size, dark, projector) in screens {
        page.prefer("prefers-color-scheme", if dark { "dark" } else { "light" })
            .await;
        page.screen(size, 1.0).await;
        if projector {
            page.click("projector").await;
        }
        page.settle().await;
        for wrong in [defects(&page, 0).await, violations(&page).await] {
            if wrong != json!([]) {
                found.push((format!("{stop} {lang} {size:?} {dark} {projector}"), wrong));
            }
        }
        if projector {
            page.click("projector").await;
        }
    }
    page.close().await;
    found
}
