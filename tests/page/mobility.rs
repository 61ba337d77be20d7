//! Schemes of links and pairs on the page: what is cut, changed and asked there, and what is said of
//! it, by what the engine says.

use std::collections::BTreeSet;

use assur::mobility::{CutError, Scheme, SchemeSpec, Space};
use assur_file::{Document, KindDocument, SchemeDocument};
use assur_tests::files::preset;
use serde_json::json;

use crate::access::{AXE, check};
use crate::browser::Page;
use crate::device::languages;
use crate::host::home;
use crate::layout::defects;

/// A document of the lesson or of the catalogue.
pub(crate) fn document(name: &str) -> SchemeDocument {
    if let Some(own) = preset("mobility", name) {
        return serde_json::from_value(own).unwrap();
    }
    let Some(Ok(Document::Scheme(document))) = assur_file::document(name) else {
        panic!("{name} is no scheme");
    };
    document
}

pub(crate) fn scheme(name: &str) -> Scheme {
    document(name).scheme().unwrap()
}

pub(crate) fn with_cuts(name: &str, cut: &[&str]) -> SchemeDocument {
    let cut = cut.iter().map(|&name| name.to_owned()).collect();
    SchemeDocument {
        cut,
        ..document(name)
    }
}

/// The link to a document.
fn link(document: &SchemeDocument) -> String {
    let document = serde_json::to_value(document).unwrap();
    let fields = document.as_object().unwrap().iter();
    let fields = fields.map(|(name, value)| {
        let value = value.to_string().replace('%', "%25").replace('"', "%22");
        let value = value.replace('{', "%7B").replace('}', "%7D");
        let value = value.replace('[', "%5B").replace(']', "%5D");
        format!("&d.{name}={}", value.replace(' ', "%20"))
    });
    let fields: String = fields.collect();
    let view = "&v.phi_deg=50&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";
    format!("{}#2&kind=scheme{fields}{view}", home())
}

/// The page with a document, and all that is of its kind.
pub(crate) async fn open(document: &SchemeDocument) -> Page {
    let page = Page::open_at(&link(document), "en-US").await;
    there(&page).await;
    assert_eq!(page.text("notice-text").await, "");
    page
}

pub(crate) async fn there(page: &Page) {
    // In a lesson it is there without being seen.
    page.until("what is of a scheme", async || {
        page.count("#scheme-formulas p").await > 0
    })
    .await;
    page.settle().await;
}

/// The pairs that the table has as cut.
pub(crate) async fn cuts(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('input[data-cut]:checked')].map((one) => one.dataset.cut)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// Cuts a pair in the table, or joins it again.
pub(crate) async fn cut(page: &Page, name: &str) {
    let script =
        format!("return document.querySelector(`input[data-cut=\"${{'{name}'}}\"]`)?.id ?? ''");
    let id: String = serde_json::from_value(page.ask(&script).await).unwrap();
    page.click(&id).await;
}

/// What the sections lead to, as it is written.
fn written(scheme: &Scheme, names: &[&str]) -> String {
    let cuts: Vec<_> = names
        .iter()
        .map(|name| scheme.cut_named(name).unwrap())
        .collect();
    let sections = scheme.sections(&cuts).unwrap();
    let (open, removed, mobility) = (sections.open, sections.removed, sections.mobility);
    format!("W = W₀ − ΣS = {open} − {removed} = {mobility}")
}

/// A contour that is still closed is told by its pairs, a link that is cut off by its name; what opens
/// everything is counted; another choice comes to the same W. The address has it.
#[tokio::test]
async fn cuts_are_judged() {
    let scheme = scheme("mobility-4");
    let page = open(&with_cuts("mobility-4", &["Q"])).await;
    let only_q = [scheme.cut_named("Q").unwrap()];
    let Err(CutError::StillClosed { pairs }) = scheme.sections(&only_q) else {
        panic!("nothing is closed");
    };
    let said = page.text("method-said").await;
    assert!(said.contains(&pairs.join(", ")), "{said} {pairs:?}");
    let closed = page.picture("mechanism").await;
    cut(&page, "F").await;
    let said = page.text("method-said").await;
    assert!(said.contains(&written(&scheme, &["Q", "F"])), "{said}");
    page.until("the chain to fall open", async || {
        page.picture("mechanism").await.difference(&closed) > 500
    })
    .await;
    cut(&page, "F").await;
    cut(&page, "E").await;
    let said = page.text("method-said").await;
    assert!(said.contains(&written(&scheme, &["Q", "E"])), "{said}");
    page.until("the address to follow", async || {
        page.address().await.contains("%22Q%22,%22E%22")
    })
    .await;
    page.reload().await;
    there(&page).await;
    assert_eq!(cuts(&page).await, ["E", "Q"]);
    // A and B are all that link 1 has.
    page.click("cut-join").await;
    assert!(cuts(&page).await.is_empty());
    page.anew(&link(&with_cuts("mobility-2a", &["A", "B"])))
        .await;
    there(&page).await;
    let said = page.text("method-said").await;
    assert!(said.contains(": 1.") && !said.contains('='), "{said}");
    page.close().await;
}

/// Cut step by step it comes to the engine's own choice.
#[tokio::test]
async fn it_is_cut_step_by_step() {
    let scheme = scheme("mobility-4");
    let page = open(&with_cuts("mobility-4", &[])).await;
    let automatic = scheme.automatic();
    let names: Vec<String> = automatic.iter().map(|cut| scheme.cut_name(*cut)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    page.click("cut-step").await;
    page.until("all cuts", async || cuts(&page).await.len() == names.len())
        .await;
    let sorted: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(cuts(&page).await, Vec::from_iter(sorted));
    let said = page.text("method-said").await;
    assert!(said.contains(&written(&scheme, &names)), "{said}");
    page.close().await;
}

/// A pair of another form is counted as such at once, and undone.
#[tokio::test]
async fn a_pair_of_another_form() {
    let page = open(&document("mobility-3")).await;
    let counted = async || {
        [
            page.value("out-scheme-w").await,
            page.value("out-scheme-q").await,
        ]
    };
    let numbers = |document: &SchemeDocument| {
        let counts = document.scheme().unwrap().counts();
        let mobility = counts.mobility();
        [mobility, counts.redundant(mobility)].map(|count| count as f64)
    };
    let mut wanted = document("mobility-3");
    assert_eq!(counted().await, numbers(&wanted));
    let index = wanted
        .pairs
        .iter()
        .position(|pair| pair.name == "E")
        .unwrap();
    wanted.pairs[index].kind = KindDocument::Cylindrical;
    page.choose(&format!("pair-form-{}", index + 1), "cylindrical")
        .await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(counted().await, numbers(&wanted));
    page.click("undo").await;
    assert_eq!(counted().await, numbers(&document("mobility-3")));
    page.close().await;
}

/// The pairs that carry redundant constraints and the links that move idly are named.
#[tokio::test]
async fn the_geometry_names_them() {
    for name in ["parallelogram", "sarrus", "roller", "rssr"] {
        let scheme = scheme(name);
        let page = open(&document(name)).await;
        let space = if scheme.is_planar() {
            Space::Plane
        } else {
            Space::Whole
        };
        let verdict = scheme.rank_report(space).unwrap();
        assert_eq!(
            page.value("out-scheme-rank").await,
            verdict.mobility as f64,
            "{name}"
        );
        let said = page.text("scheme-geometry").await;
        for part in &verdict.redundancies {
            let names = part.pairs.iter().map(|&pair| &*scheme.pairs()[pair].name);
            let names: Vec<&str> = names.collect();
            assert!(said.contains(&names.join(", ")), "{name}: {said}");
        }
        for links in &verdict.idle {
            let names: Vec<&str> = links.iter().map(|&link| scheme.link_name(link)).collect();
            assert!(
                said.contains(&format!(": {} can", names.join(", "))),
                "{name}: {said}"
            );
        }
        assert!(!verdict.redundancies.is_empty() || !verdict.idle.is_empty());
        page.close().await;
    }
}

/// What is no mechanism is said with the names of pair and links, in every language; the last good drawing
/// stays.
#[tokio::test]
async fn what_cannot_be_is_said() {
    let page = open(&document("mobility-2a")).await;
    let mut texts = BTreeSet::new();
    // A joins the frame to itself; B and C alone hang together.
    for (pair, place, link, named) in [(1, 2, "0", "A"), (4, 2, "2", "2")] {
        let select = format!("pair-link-{pair}-{place}");
        page.choose(&select, link).await;
        let faded = page.attribute("mechanism", "data-faded").await;
        assert_eq!(faded.as_deref(), Some("true"), "{select}");
        for lang in languages(0) {
            page.speak(lang).await;
            let text = page.text("problem").await;
            assert!(text.contains(named) && text.len() > 20, "{lang}: {text}");
            assert!(!text.contains('{') && texts.insert(text), "{lang}");
        }
        page.speak("en").await;
    }
    page.click("undo").await;
    page.click("undo").await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// A way to do without redundant constraints is taken, and undone.
#[tokio::test]
async fn redundant_constraints_are_mended() {
    let page = open(&document("mobility-2a")).await;
    let counts = scheme("mobility-2a").counts();
    let q = counts.redundant(counts.mobility()) as f64;
    assert_eq!(page.value("out-scheme-q").await, q);
    page.click("mended-1").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.value("out-scheme-q").await, 0.0);
    assert_eq!(page.value("out-scheme-w").await, counts.mobility() as f64);
    assert_eq!(page.count("#mended-1").await, 0);
    page.click("undo").await;
    assert_eq!(page.value("out-scheme-q").await, q);
    page.close().await;
}

/// What moves in the simulator becomes a scheme of as many links and pairs; undo brings it back.
#[tokio::test]
async fn a_linkage_becomes_a_scheme() {
    let page = Page::open().await;
    page.click("gallery").await;
    page.until("the mechanism", async || {
        page.count("#gallery-class4-dwell").await == 1
    })
    .await;
    page.click("gallery-class4-dwell").await;
    page.until("the linkage", async || {
        page.count("#out-linkage-swing").await == 1
    })
    .await;
    page.click("menu").await;
    page.click("become-scheme").await;
    there(&page).await;
    assert_eq!(page.text("problem").await, "");
    let linkage = assur_file::from_catalogue("class4-dwell").unwrap().unwrap();
    let motion = linkage.motion().unwrap();
    let pose = motion.pose::<1>(0.5).unwrap();
    let draft = SchemeSpec::of(motion.mechanism(), &pose);
    let counts = Scheme::new(&draft).unwrap().counts();
    assert_eq!(page.value("out-scheme-links").await, counts.links as f64);
    for of in ["w", "rank"] {
        assert_eq!(page.value(&format!("out-scheme-{of}")).await, 1.0, "{of}");
    }
    assert_eq!(counts.mobility(), 1);
    page.click("undo").await;
    assert_eq!(page.text("problem").await, "");
    let kind = "return document.documentElement.dataset.kind";
    assert_eq!(page.ask(kind).await, json!("linkage"));
    page.close().await;
}

/// On a phone nothing overlaps or leaves the screen, whatever the language; every word is there.
#[tokio::test]
async fn in_every_language_on_a_phone() {
    let page = open(&document("mobility-3")).await;
    page.ask(
        "for (const one of document.querySelectorAll('[data-of=scheme] details')) one.open = true",
    )
    .await;
    let mut texts = BTreeSet::new();
    page.touched().await;
    page.screen((360, 640), 1.0).await;
    for lang in languages(1) {
        page.speak(lang).await;
        let found = defects(&page, 44).await;
        assert_eq!(found, json!([]), "{lang}");
        let script = "return [...document.querySelectorAll('[data-of=scheme]')].map((one) => one.innerText).join(' ')";
        let text = page.ask(script).await.as_str().unwrap().to_owned();
        // A key that has no words stands there itself.
        let keys = [
            "pairs.",
            "pair.",
            "method.",
            "formulas.",
            "geometry.",
            "look.",
            "practice.",
        ];
        assert!(keys.iter().all(|key| !text.contains(key)), "{lang}: {text}");
        assert!(text.len() > 200 && texts.insert(text), "{lang}");
    }
    page.close().await;
}

/// What axe finds where all of a scheme is unfolded: nothing, in light and in dark.
#[tokio::test]
async fn axe_finds_nothing_in_schemes() {
    for name in ["mobility-2c", "mobility-3"] {
        let page = open(&document(name)).await;
        page.ask(AXE).await;
        page.ask("for (const one of document.querySelectorAll('[data-of=scheme] details')) one.open = true")
            .await;
        for scheme in ["light", "dark"] {
            page.prefer("prefers-color-scheme", scheme).await;
            check(&page, &format!("{name} {scheme}")).await;
        }
        page.close().await;
    }
}
