//! What is plotted and by what: chosen by mouse, by keys and by touch, read
//! against the engine; the marks and the proof by differences.

use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur_tests::assert_near;
use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::picture::COUPLER;

/// Colours of the curves of a point and of the ink, as the style sheet has them.
const X: [u8; 3] = [0x00, 0x79, 0x8C];
const Y: [u8; 3] = [0xB3, 0x5C, 0x00];
const INK: [u8; 3] = [0x1B, 0x1F, 0x24];

/// A quantity of case a and its two derivatives by the crank angle.
fn jet(name: &str, degrees: f64) -> [f64; 3] {
    let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
    let quantity = Quantity::named(motion.mechanism(), name).unwrap();
    let pose = motion.pose::<3>(degrees.to_radians()).unwrap();
    let jet = quantity.of(motion.mechanism(), &pose);
    [0, 1, 2].map(|order| jet.derivative(order))
}

/// The read-outs of the point that is plotted, against the engine.
async fn check_point(page: &Page, point: &str, degrees: f64, [speed, acceleration]: [f64; 2]) {
    for axis in ["x", "y"] {
        let [value, first, second] = jet(&format!("{point}.{axis}"), degrees);
        for (id, expected) in [
            (format!("out-{point}.{axis}"), value),
            (format!("out-{point}.{axis}′"), speed * first),
            (
                format!("out-{point}.{axis}″"),
                speed * speed * second + acceleration * first,
            ),
        ] {
            assert_near(page.value(&id).await, expected, 1e-12, &id);
        }
    }
}

/// Everything that is written on the plots, and beside their cursor, when they are drawn anew.
pub(crate) async fn texts(page: &Page) -> Vec<String> {
    page.ask(
        "const kind = window.CanvasRenderingContext2D.prototype;
        if (!window.plain) {
            window.plain = kind.fillText;
            kind.fillText = function (text, ...place) {
                if (this.canvas.id.startsWith('chart')) window.seen.push(String(text));
                window.plain.call(this, text, ...place);
            };
        }
        window.seen = [];",
    )
    .await;
    // Another window is another size: all is drawn anew.
    page.ask("const { style, clientHeight } = document.querySelector('.charts'); style.flex = `0 0 ${clientHeight + 40}px`")
        .await;
    page.settle().await;
    page.ask("document.querySelector('.charts').style.flex = ''")
        .await;
    page.until("the plots", async || {
        page.ask("return window.seen.length > 0").await == json!(true)
    })
    .await;
    page.settle().await;
    let seen = page.ask("return window.seen").await;
    let seen = seen.as_array().unwrap().iter();
    seen.map(|text| text.as_str().unwrap().to_owned()).collect()
}

#[tokio::test]
async fn plots_are_chosen() {
    let page = Page::open().await;
    page.stop_at("62").await;
    assert_eq!(page.written("plot").await, "angles");
    for (plot, point) in [("C2", "C2"), ("B", "B"), ("C1", "C1"), ("C3", "C3")] {
        page.choose("plot", plot).await;
        check_point(&page, point, 62.0, [1.0, 0.0]).await;
        let picture = page.picture("charts").await;
        for colour in [X, Y] {
            assert!(picture.places(colour).count() > 600, "{plot}");
        }
        let address = format!("v.plot={plot}");
        page.until("the address", async || {
            page.address().await.contains(&address)
        })
        .await;
    }
    // A link shows the same; keys choose as well.
    page.reload().await;
    assert_eq!(page.written("plot").await, "C3");
    check_point(&page, "C3", 62.0, [1.0, 0.0]).await;
    page.focus("plot").await;
    page.press("plot", Key::Home).await;
    assert_eq!(page.written("plot").await, "angles");
    assert_eq!(page.picture("charts").await.places(X).count(), 0);
    assert_eq!(page.count("#out-C3\\.x").await, 0);
    page.press("plot", Key::Down).await;
    assert_eq!(page.written("plot").await, "coupler.angle");
    let colour = page.picture("charts").await.places(COUPLER).count();
    assert!(colour > 600, "{colour}");
    page.close().await;
}

#[tokio::test]
async fn axes_are_by_time() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let [_, first, second] = jet("rocker.angle", 62.0);
    assert_eq!(page.text("input").await, "");
    page.choose("axes", "physical").await;
    assert_near(
        page.value("out-rocker.angle′").await,
        first,
        1e-12,
        "at 1 rad/s",
    );
    page.write("omega", "−2,5").await;
    page.write("epsilon", "4").await;
    assert_near(
        page.value("out-rocker.angle′").await,
        -2.5 * first,
        1e-12,
        "ω₃",
    );
    let expected = 6.25 * second + 4.0 * first;
    assert_near(page.value("out-rocker.angle″").await, expected, 1e-12, "ε₃");
    let seen = texts(&page).await;
    for title in ["φ₃", "ω₃", "ω₅", "ε₃", "ε₅"] {
        assert!(seen.iter().any(|text| text == title), "{title}: {seen:?}");
    }
    assert!(seen.iter().any(|text| text.contains("rad/s²")), "{seen:?}");

    // The unit is how ω₁ is written, not what it is.
    page.choose("omega-unit", "per_min").await;
    let shown: f64 = page
        .written("omega")
        .await
        .replace('−', "-")
        .parse()
        .unwrap();
    assert!(
        (shown + 2.5 * 30.0 / std::f64::consts::PI).abs() < 1e-3,
        "{shown}"
    );
    assert_near(
        page.value("out-rocker.angle′").await,
        -2.5 * first,
        1e-12,
        "ω₃",
    );
    page.write("omega", "60").await;
    let speed = std::f64::consts::TAU;
    assert_near(
        page.value("out-rocker.angle′").await,
        speed * first,
        1e-12,
        "ω₃",
    );
    page.choose("plot", "C2").await;
    check_point(&page, "C2", 62.0, [speed, 4.0]).await;

    // Back to analogues: nothing is left of it.
    page.choose("axes", "analogues").await;
    check_point(&page, "C2", 62.0, [1.0, 0.0]).await;
    assert_eq!(page.value("out-rocker.angle′").await, first);
    page.close().await;
}

#[tokio::test]
async fn bad_inputs_are_named_and_recovered_from() {
    let page = Page::open().await;
    page.stop_at("62").await;
    // By keys alone: from the choice of the plot shown alone to that of the axes, then to ω₁.
    page.focus("only").await;
    page.keys(Key::Tab + "").await;
    page.keys(Key::Down + "").await;
    page.settle().await;
    assert_eq!(page.written("axes").await, "physical");
    page.keys(Key::Tab + "").await;
    page.keys("3").await;
    page.settle().await;
    let [_, first, _] = jet("rocker.angle", 62.0);
    assert_near(
        page.value("out-rocker.angle′").await,
        3.0 * first,
        1e-12,
        "ω₃",
    );
    for (field, bad, says) in [
        ("omega", "fast", "this is not a number"),
        ("omega", "20000", "out of range"),
        ("epsilon", "1e9", "out of range"),
        ("epsilon", "", "this is not a number"),
    ] {
        page.write(field, bad).await;
        let problem = page.text("problem").await;
        assert!(
            problem.contains(says) && problem.contains("driver"),
            "{problem}"
        );
        let invalid = page.attribute(field, "aria-invalid").await;
        assert_eq!(invalid.as_deref(), Some("true"), "{field} {bad}");
        page.write(field, "2").await;
        assert_eq!(page.text("problem").await, "");
    }
    page.choose("speed", "true_time").await;
    page.write("omega", "0").await;
    assert!(page.text("problem").await.contains("stand still"));
    page.choose("speed", "1").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.value("out-rocker.angle′").await, 0.0);
    page.close().await;
}

/// Radians in a second by which the crank is turned from frame to frame. A frame that
/// is long in coming counts as a tenth of a second.
async fn speeds(page: &Page) -> Vec<f64> {
    // Names of modules are known to scripts of the page alone.
    let script = "const done = arguments[0];
        window.eval(\"import('assur/pkg/assur_web.js')\").then(({ Simulator }) => {
            const kind = Simulator.prototype;
            const { advance } = kind;
            const frames = [];
            kind.advance = function (phi, delta) {
                frames.push([document.timeline.currentTime, delta]);
                if (frames.length === 8) {
                    kind.advance = advance;
                    done(frames.slice(1).map(([now, delta], i) => 1e3 * delta / Math.min(now - frames[i][0], 100)));
                }
                return advance.call(this, phi, delta);
            };
        });";
    page.numbers(script).await
}

/// In real time the crank turns by ω₁ in a second, whatever the speed was.
#[tokio::test]
async fn true_time_is_true() {
    let page = Page::open().await;
    page.stop_at("10").await;
    page.choose("speed", "true_time").await;
    page.write("omega", "0.5").await;
    page.write("epsilon", "3").await;
    assert!(
        page.text("input-note")
            .await
            .contains("uniformly with ω₁; ε₁ is not used")
    );
    page.write("omega", "-3").await;
    page.click("play").await;
    for speed in speeds(&page).await {
        assert_near(speed, -3.0, 1e-9, "ω₁");
    }
    page.choose("speed", "4").await;
    for speed in speeds(&page).await {
        assert_near(speed, 4.0 * std::f64::consts::TAU / 6.0, 1e-9, "4 ×");
    }
    page.click("play").await;
    page.choose("speed", "1").await;
    page.choose("speed", "true_time").await;

    // It plays, and the keys of speed leave it.
    page.write("omega", "2").await;
    page.click("play").await;
    page.until("the crank to turn", async || {
        page.value("out-input").await > 40.0
    })
    .await;
    page.click("play").await;
    page.keys("-").await;
    assert_eq!(page.written("speed").await, "0.5");
    page.close().await;
}

/// Dots of differences appear over φ″ alone; by mouse, by key, by finger.
#[tokio::test]
async fn differences_lie_on_the_curve() {
    let page = Page::open().await;
    page.stop_at("0").await;
    let plain = page.picture("charts").await;
    let dark = |picture: &crate::picture::Picture| {
        // The title of the third plot stands above its third of the picture.
        let split = picture.height * 3 / 5;
        let rows = [0..split, split..picture.height];
        rows.map(|rows| {
            let places = picture.places(INK);
            places.filter(|(_, y)| rows.contains(y)).count()
        })
    };
    let before = dark(&plain);
    page.click("differenced").await;
    let shown = dark(&page.picture("charts").await);
    assert!(shown[0].abs_diff(before[0]) < 20, "{before:?} {shown:?}");
    assert!(shown[1] > before[1] + 250, "{before:?} {shown:?}");
    let seen = texts(&page).await;
    assert!(
        seen.iter().any(|text| text.contains("differences of φ′")),
        "{seen:?}"
    );
    page.press("differenced", Key::Space).await;
    assert!(page.picture("charts").await.difference(&plain) < 20);
    page.fingers("differenced", &[vec![(5.0, 5.0)]]).await;
    assert!(
        page.element("differenced")
            .await
            .is_selected()
            .await
            .unwrap()
    );
    page.until("the address", async || {
        page.address().await.contains("v.differenced=true")
    })
    .await;
    page.close().await;
}
