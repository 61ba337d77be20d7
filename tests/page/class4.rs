//! The Class IV mechanism on the page: its dwell, its cyclogram, its lesson.

use crate::assemblies::{follow, followed};
use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::{agrees, document, open};
use assur::{CombinedMethod, Point};
use thirtyfour::prelude::*;

/// The colour of the shade over a dwell on paper: the coupler's, thinned.
const SHADE: [u8; 3] = [0xFA, 0xE8, 0xDC];

async fn dwell(page: &Page) -> String {
    page.text("out-course-arc").await
}

/// Dwell and stroke of theory.md's table, of the band that is typed, and with the
/// regulator lengthened; the plots are shaded; what was typed is undone.
#[tokio::test]
async fn its_dwell_is_measured_and_regulated() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("0").await;
    assert_eq!(dwell(&page).await, "184.289°");
    assert_eq!(page.text("out-course-stroke").await, "43.2908°");
    // An angle swings, a length has a stroke.
    let title = "return document.querySelector('#out-course-stroke').closest('tr').querySelector('th').textContent";
    assert_eq!(page.ask(title).await, "swing");
    let bars = page.attribute("cyclogram", "aria-label").await.unwrap();
    assert!(bars.contains("rise") && bars.contains("dwell") && bars.contains("return"));
    let shaded = page.picture("charts").await.places(SHADE).count();
    assert!(shaded > 5000, "{shaded}");

    // Shade and inset are on the exported plots, too.
    open_dialog(&page).await;
    let svg = save_text(&page, "export-plots-svg", "assur-class4-dwell-plots.svg").await;
    assert!(svg.contains("↕ 0.1°"));
    // One inset for the angle and for each derivative, as in fig. 2.
    assert_eq!(svg.matches('↕').count(), 3);
    page.click("export-close").await;

    // As a person types: the page answers every key, also the 0 that is no band.
    let field = page.element("field-band").await;
    field.click().await.unwrap();
    field.send_keys(Key::Control + "a").await.unwrap();
    for typed in ["0", "0.", "0.0", "0.01"] {
        field.send_keys(&typed[typed.len() - 1..]).await.unwrap();
        page.settle().await;
        assert_eq!(field.value().await.unwrap().unwrap(), typed);
    }
    page.press("field-band", Key::Enter).await;
    page.until("a narrower band", async || {
        dwell(&page).await.starts_with("170.19")
    })
    .await;
    page.click("undo").await;
    page.until("the band before", async || dwell(&page).await == "184.289°")
        .await;

    page.write("field-length-5", "4.312").await;
    page.until("a short dwell", async || {
        dwell(&page).await.starts_with("65.63")
    })
    .await;
    assert!(page.text("out-course-stroke").await.starts_with("45.45"));
    let less = page.picture("charts").await.places(SHADE).count();
    assert!(2 * less < shaded, "{less} of {shaded}");

    // Nothing dwells in no band: the last good one stays, and a sentence says why.
    page.write("field-band", "-1").await;
    page.until("a sentence", async || {
        page.text("problem").await.contains("tolerance")
    })
    .await;
    assert!(dwell(&page).await.starts_with("65.63"));
    page.close().await;
}

/// The steps, each answered wrong and right, by mouse and by keys.
#[tokio::test]
async fn its_lesson_is_answered() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    let steps: [(bool, &str, &str); 16] = [
        (false, "9", "10"),
        (true, "iii", "iv"),
        (true, "iv", "ii"),
        (false, "170", "184.3"),
        (false, "175.7", "170.1"),
        (false, "184.3", "121.9"),
        (false, "12", "13"),
        (true, "turn", "both"),
        (false, "44.15", "43.29"),
        (true, "small", "middle"),
        (true, "square", "in_line"),
        (true, "along", "across"),
        (true, "cd", "fk"),
        (true, "largest", "nothing"),
        (true, "d", "bc"),
        (true, "x_eb", "ratio"),
    ];
    for (number, (choices, wrong, right)) in steps.iter().enumerate() {
        if number > 0 {
            page.click("lesson-on").await;
        }
        // The last step has two buttons of other names, and opens the first by itself.
        if number < 15 {
            page.click("lesson-show").await;
            page.settle().await;
        }
        for (answer, verdict) in [(wrong, "not_yet"), (right, "right")] {
            if *choices {
                page.click(&format!("lesson-{answer}")).await;
            } else {
                page.write("lesson-answer", answer).await;
            }
            page.press("lesson-check", Key::Enter).await;
            page.until(&format!("step {} to be judged", number + 1), async || {
                page.attribute("lesson-said", "data-verdict")
                    .await
                    .as_deref()
                    == Some(verdict)
            })
            .await;
        }
    }
    // The driver of step 3 made it a mechanism of Class II, and step 4 brought it back.
    assert!(page.text("out-formula").await.contains("IV₃"));
    // A number in a formula has the decimal sign of the reader's language.
    for _ in 0..10 {
        page.click("lesson-back").await;
    }
    for (lang, expected) in [
        ("en", "FK = 4.112"),
        ("ru", "FK = 4,112"),
        ("kk", "FK = 4,112"),
    ] {
        page.speak(lang).await;
        page.until(&format!("the formula in {lang}"), async || {
            let formula = page.driver.find(By::Css("#lesson .formula")).await.unwrap();
            formula.text().await.unwrap() == expected
        })
        .await;
    }
    page.close().await;
}

async fn open_lesson(page: &Page) {
    open(page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
}

/// "Show it" opens the whole document of the step: an assembly that the reader chose
/// in the step before is not left over, and one undo brings it back.
#[tokio::test]
async fn a_step_shows_its_own_document() {
    let page = Page::open().await;
    open_lesson(&page).await;
    for _ in 1..3 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show").await;
    page.click("tab-settings").await;
    // Of another angle other assemblies have these numbers.
    page.stop_at("0").await;
    follow(&page, 2).await;
    assert!(page.text("out-formula").await.contains("II₂"));
    page.click("tab-lesson").await;
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert!(page.text("out-formula").await.contains("IV₃"));
    page.click("tab-settings").await;
    assert_eq!(dwell(&page).await, "184.289°");
    page.click("undo").await;
    assert!(page.text("out-formula").await.contains("II₂"));
    page.stop_at("0").await;
    assert_eq!(followed(&page).await, "2");
    page.close().await;
}

/// A lesson may be open over a document of another kind: there is nothing to judge then,
/// and "Show it" opens a document of the lesson's. It stays open, and over what undo brings.
#[tokio::test]
async fn a_step_opens_a_document_of_another_kind() {
    let page = Page::open().await;
    page.stop_at("60").await;
    open_lesson(&page).await;
    page.until("the address to follow", async || {
        page.address()
            .await
            .contains("%22class4-dwell%22,%22step%22")
    })
    .await;
    let link = page.address().await;
    let other = link.replace("%22class4-dwell%22,%22step%22", "%22mixer%22,%22step%22");
    page.anew(&other).await;
    let titled = async || page.text("lesson-title").await == "The machine and its parts";
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    assert!(titled().await);
    let verdict = async || page.attribute("lesson-said", "data-verdict").await;
    let kind = async || {
        page.ask("return document.documentElement.dataset.kind")
            .await
    };
    assert_eq!(kind().await, "linkage");
    // The question is about the step's own mechanism, which comes first.
    page.write("lesson-answer", "4").await;
    assert_eq!(verdict().await.as_deref(), Some("right"));
    assert_eq!(kind().await, "mixer");
    assert!(titled().await);
    page.click("undo").await;
    assert_eq!(kind().await, "linkage");
    assert!(titled().await);
    // Once closed, the lesson about the mechanism that is there is offered.
    page.click("tab-settings").await;
    page.click("tab-lesson").await;
    page.until("the other lesson", async || !titled().await)
        .await;
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains("Step 1 of 16"), "{progress}");
    page.close().await;
}

/// What was answered is still there when the page is opened again, in whatever lesson;
/// the address does not tell it.
#[tokio::test]
async fn progress_outlives_the_page() {
    let page = Page::playing().await;
    open_lesson(&page).await;
    page.click("lesson-show").await;
    page.write("lesson-answer", "10").await;
    page.press("lesson-check", Key::Enter).await;
    page.click("lesson-on").await;
    page.click("lesson-iii").await;
    page.click("play").await;
    page.until("the address to follow", async || {
        page.address().await.contains("%22step%22%3A2")
    })
    .await;
    page.reload().await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    let progress = page.text("lesson-progress").await;
    assert!(
        progress.contains("Step 2") && progress.contains("1 right answer"),
        "{progress}"
    );
    let chosen = page.element("lesson-iii").await;
    assert!(chosen.is_selected().await.unwrap());
    assert_eq!(
        page.attribute("lesson-said", "data-verdict")
            .await
            .as_deref(),
        Some("")
    );
    page.click("lesson-back").await;
    assert_eq!(page.written("lesson-answer").await, "10");
    let address = page.address().await;
    assert!(
        !address.contains("solved") && !address.contains("given"),
        "{address}"
    );

    // What somebody else wrote there is passed over.
    page.ask("localStorage.setItem('assur.lesson.class4-dwell', '{\"given\":7,\"solved\":{}}')")
        .await;
    page.reload().await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    assert!(!page.text("lesson-progress").await.contains("answer"));
    page.close().await;
}

/// What the drawing is as a picture for print.
async fn drawing(page: &Page) -> String {
    open_dialog(page).await;
    let svg = save_text(page, "export-drawing-svg", "assur-class4-dwell-drawing.svg").await;
    page.click("export-close").await;
    svg
}

/// The colours of CD and FK, and of the first group, the coupler's, on paper.
const OWN: [&str; 2] = ["#77820a", "#b8508a"];
const GROUP: &str = "#d55e00";
const CD: [u8; 3] = [0x77, 0x82, 0x0A];

/// Links take the colours of their groups, in the formula as well; a link of the
/// address keeps it, undo takes it back, and the plots tell links apart as before.
#[tokio::test]
async fn groups_are_drawn_in_colours() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("60").await;
    let formula = page.text("out-formula").await;
    let swatches = "#out-formula .swatch";
    assert_eq!(page.count(swatches).await, 0);
    assert!(page.picture("mechanism").await.places(CD).count() > 200);
    let curve = page.picture("charts").await.places(CD).count();
    let plain = drawing(&page).await;
    assert!(OWN.iter().all(|own| plain.contains(own)));

    page.click("groups").await;
    assert_eq!(page.text("out-formula").await, formula);
    for (role, term) in [
        ("crank", "I(frame,AB)"),
        ("coupler", "IV₃(BE,EGF,HGL,CLK,FK,CD)"),
    ] {
        let term_of = format!("#out-formula .group:has([data-role='{role}'])");
        let shown = page.driver.find(By::Css(&term_of)).await.unwrap();
        assert_eq!(shown.text().await.unwrap(), term);
    }
    assert_eq!(page.count(swatches).await, 2);
    assert_eq!(page.picture("mechanism").await.places(CD).count(), 0);
    let still = page.picture("charts").await.places(CD).count();
    assert!(still.abs_diff(curve) < curve / 10, "{still} {curve}");
    let coloured = drawing(&page).await;
    assert!(!OWN.iter().any(|own| coloured.contains(own)));
    assert!(coloured.matches(GROUP).count() > plain.matches(GROUP).count());

    page.until("the address", async || {
        page.address().await.contains("v.groups=true")
    })
    .await;
    page.reload().await;
    page.until("the formula", async || page.count(swatches).await == 2)
        .await;
    assert!(page.element("groups").await.is_selected().await.unwrap());
    page.click("groups").await;
    assert_eq!(page.count(swatches).await, 0);
    page.click("undo").await;
    assert_eq!(page.count(swatches).await, 2);
    // The lesson's first step shows them, the fourth does not.
    page.click("groups").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-show").await > 0)
        .await;
    page.click("lesson-show").await;
    assert_eq!(page.count(swatches).await, 2);
    for _ in 1..4 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show").await;
    assert_eq!(page.count(swatches).await, 0);
    page.close().await;
}

/// Where H and D stand among the points, and the links that are hinged there.
const H: usize = 8;
const D: usize = 9;
const HGL: usize = 3;
const CD_LINK: usize = 6;

/// The hinges of the frame are moved by number and by slider, and the links keep
/// their dimensions; undone, kept in the address, refused in a sentence.
#[tokio::test]
async fn the_frame_is_regulated() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("60").await;
    let mut moved = document("class4-dwell");
    let drawn = moved.clone();
    let shape = moved.links[HGL].points.iter().map(|name| {
        let point = drawn.points.iter().find(|point| point.name == *name);
        point.unwrap().at
    });
    moved.links[HGL].shape = Some(shape.collect());
    moved.points[H].at[0] = 4.2;
    page.write(&format!("field-point-{H}-x"), "4.2").await;
    agrees(&page, &moved, "CD.angle").await;
    let shorter = dwell(&page).await;
    assert_ne!(shorter, "184.289°");
    page.click("undo").await;
    assert_eq!(dwell(&page).await, "184.289°");
    page.click("redo").await;
    assert_eq!(dwell(&page).await, shorter);

    // One step of the slider.
    page.press(&format!("slider-point-{D}-y"), Key::Right).await;
    let field = format!("field-point-{D}-y");
    page.focus(&field).await;
    page.settle().await;
    let at: f64 = page
        .written(&field)
        .await
        .replace('−', "-")
        .parse()
        .unwrap();
    assert!((at + 4.78).abs() < 0.1 && at > -4.78, "{at}");
    let [c, d] = ["C", "D"].map(|name| {
        let point = drawn.points.iter().find(|point| point.name == name);
        point.unwrap().at
    });
    moved.links[CD_LINK].length = Some((c[0] - d[0]).hypot(c[1] - d[1]));
    moved.points[D].at[1] = at;
    agrees(&page, &moved, "CD.angle").await;
    page.until("the address", async || {
        page.address().await.contains(&format!("{at}"))
    })
    .await;
    page.reload().await;
    page.until("the mechanism", async || {
        page.count(&format!("#field-point-{H}-x")).await == 1
    })
    .await;
    agrees(&page, &moved, "CD.angle").await;

    for (text, sentence) in [
        ("far", "x of fixed pivot H"),
        ("40", "can no longer be joined"),
    ] {
        page.write(&format!("field-point-{H}-x"), text).await;
        page.until("a sentence", async || {
            page.text("problem").await.contains(sentence)
        })
        .await;
        // The 4 of 40 works: it is what was there last.
        if text == "40" {
            moved.points[H].at[0] = 4.0;
        }
        agrees(&page, &moved, "CD.angle").await;
    }
    // The points of a guide have fields, too.
    open(&page, "slider-crank").await;
    let frame = page.element("linkage-frame").await;
    assert!(frame.is_displayed().await.unwrap());
    page.close().await;
}

/// Velocity and acceleration at every joint that moves, E, G, F, K, L, C among them:
/// the arrows of the drawing have the directions of the derivatives.
#[tokio::test]
async fn every_joint_has_its_vectors() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    for _ in 1..9 {
        page.click("lesson-on").await;
    }
    let text = page.driver.find(By::Css(".lesson-text")).await.unwrap();
    assert!(text.text().await.unwrap().contains("E, G, F, K, L and C"));
    page.click("lesson-show").await;
    page.settle().await;
    assert!((page.value("out-input").await - 60.0).abs() < 1e-9);
    let svg = drawing(&page).await;
    let svg = roxmltree::Document::parse(&svg).unwrap();
    let motion = document("class4-dwell").motion().unwrap();
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(60_f64.to_radians()).unwrap();
    for (order, colour) in [(1, "#c2387f"), (2, "#4b4fc4")] {
        // Shafts, in the coordinates of the mechanism.
        let shafts = svg.descendants().filter(|node| {
            node.attribute("stroke") == Some(colour) && node.attribute("fill") == Some("none")
        });
        let ends = shafts.map(|shaft| {
            let ends = shaft.attribute("d").unwrap().split(['M', 'L', ' ']);
            let ends = ends.filter_map(|number| number.parse().ok());
            let ends: Vec<f64> = ends.collect();
            let [x, y, to_x, to_y] = ends[..] else {
                panic!("{ends:?}");
            };
            [Point::new(x, y), Point::new(to_x, to_y)]
        });
        let ends: Vec<[Point; 2]> = ends.collect();
        assert_eq!(ends.len(), 7);
        for index in mechanism.point_ids() {
            let name = mechanism.point_name(index);
            if "AHD".contains(name) {
                continue;
            }
            let joint = mechanism.place(&pose, index);
            let vector = joint.derivative(order).normalize();
            let mut here = ends.iter();
            let [from, to] = here
                .find(|[from, _]| (from - joint.place()).norm() < 1e-5)
                .unwrap();
            let along = (to - from).normalize();
            assert!((along - vector).norm() < 1e-3, "{name} {order}: {along}");
        }
    }
    page.close().await;
}

/// Goes to a step of the lesson from its first.
async fn go_to(page: &Page, step: usize) {
    for _ in 1..step {
        page.click("lesson-on").await;
    }
    page.settle().await;
}

/// Every coefficient has the engine's number, and the printed one where that is another; both follow the crank.
#[tokio::test]
async fn coefficients_have_their_numbers() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 11).await;
    let motion = document("class4-dwell").motion().unwrap();
    let mechanism = motion.mechanism();
    let method = CombinedMethod::of(mechanism).unwrap();
    page.ask("document.querySelector('#lesson-paper > summary').click()")
        .await;
    for degrees in [60.0_f64, 200.0] {
        page.stop_at(&degrees.to_string()).await;
        page.settle().await;
        let pose = motion.pose::<3>(degrees.to_radians()).unwrap();
        let relations = method.relations(mechanism, &pose);
        for (item, misprinted) in [("c3", true), ("c7", true), ("c14", false), ("vF", false)] {
            let item = format!("003.{item}");
            let numbers = format!(
                "return document.querySelector('#lesson-paper [data-item=\"{item}\"] .paper-numbers').textContent"
            );
            let shown = page.ask(&numbers).await.as_str().unwrap().to_owned();
            for one in relations.iter().filter(|one| one.item == item) {
                let value = format!("{:.4}", one.value).replace('-', "−");
                assert!(shown.contains(&value), "{item} {degrees}: {shown}");
                assert_eq!(shown.contains("as printed"), misprinted, "{item}: {shown}");
            }
        }
    }
    page.close().await;
}

/// The chain of the paper divides by zero where HL is as long as HG, and says so.
#[tokio::test]
async fn the_chain_divides_by_zero() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 16).await;
    let numbers = "return document.querySelector('.lesson-body > .printed [data-item=\"003.chain\"]').textContent";
    let drawn = page.ask(numbers).await.as_str().unwrap().to_owned();
    assert!(
        drawn.contains("ψ″") && !drawn.contains("divides by zero"),
        "{drawn}"
    );
    page.click("lesson-show-equal").await;
    page.until("no number by the chain", async || {
        page.ask(numbers)
            .await
            .as_str()
            .unwrap()
            .matches("divides by zero")
            .count()
            == 2
    })
    .await;
    page.close().await;
}

/// Finite differences come near and go off again with their step, and the cyclogram stands in its step with its angles.
#[tokio::test]
async fn lessons_draw_figures_of_their_own() {
    let page = Page::open().await;
    open_lesson(&page).await;
    go_to(&page, 5).await;
    assert!(visible(&page, "#lesson #cyclogram").await);
    let phases = "return document.querySelector('#lesson #cyclogram-figure p').textContent";
    let phases = page.ask(phases).await.as_str().unwrap().to_owned();
    assert_eq!(phases.matches('°').count(), 8, "{phases}");
    go_to(&page, 5).await;
    assert!(visible(&page, "#lesson .lesson-matrix").await);
    assert_eq!(page.count("#lesson .lesson-matrix tr").await, 13);
    go_to(&page, 2).await;
    let set = async |exponent: i32| {
        let script = format!(
            "const step = document.getElementById('differences-step');
            step.value = '{exponent}';
            step.dispatchEvent(new Event('input'));
            return document.getElementById('differences-errors').textContent"
        );
        page.ask(&script).await.as_str().unwrap().to_owned()
    };
    let [coarse, middle, fine] = [set(10).await, set(-10).await, set(-50).await];
    assert!(
        coarse != middle && middle != fine,
        "{coarse} {middle} {fine}"
    );
    assert!(page.count("#lesson .lesson-plot circle").await > 30);
    page.close().await;
}

/// The regulator's slider stands in its step, and what it does to dwell and stroke below it.
#[tokio::test]
async fn the_regulator_is_in_its_step() {
    let page = Page::open().await;
    open_lesson(&page).await;
    for _ in 1..6 {
        page.click("lesson-on").await;
    }
    // What the engine makes of the length, in one step of undo.
    let drawn = page.written("field-length-5").await;
    page.click("lesson-show").await;
    page.settle().await;
    assert_eq!(page.written("field-length-5").await, "4.112");
    page.click("undo").await;
    assert_eq!(page.written("field-length-5").await, drawn);
    page.click("redo").await;
    assert_eq!(page.written("field-length-5").await, "4.112");
    page.click("play").await;
    let read = async |place: &str| {
        let script = format!("return document.querySelector('{place}').textContent");
        page.ask(&script).await.as_str().unwrap().to_owned()
    };
    let mut dwells = Vec::new();
    for length in ["4.05", "4.2"] {
        let field = "return document.querySelector('#lesson .lesson-controls input[type=text]').id";
        let field = page.ask(field).await.as_str().unwrap().to_owned();
        page.write(&field, length).await;
        page.settle().await;
        for name in ["course-arc", "course-stroke"] {
            let (here, there) = (
                read(&format!("[data-out=\"{name}\"]")).await,
                read(&format!("#out-{name}")).await,
            );
            assert!(here.ends_with('°') && here == there, "{here} {there}");
        }
        dwells.push(read("[data-out=\"course-arc\"]").await);
        assert!(visible(&page, ".lesson-readouts div").await);
    }
    assert_ne!(dwells[0], dwells[1]);
    page.close().await;
}

/// Whether the first element that a selector finds is to be seen.
async fn visible(page: &Page, selector: &str) -> bool {
    let script = format!("return document.querySelector('{selector}').checkVisibility()");
    page.ask(&script).await == serde_json::json!(true)
}
