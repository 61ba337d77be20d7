//! One plot alone, numbers at the cursor beside labels, and how well dyads transmit, plotted.

use assur_tests::assert_near;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::gallery::open;
use crate::host::home;
use crate::plots::texts;

/// Which derivatives of the rocker's angle have a plot.
async fn orders(page: &Page) -> Vec<usize> {
    let seen = texts(page).await;
    let titles = ["φ₃", "φ₃′", "φ₃″"].into_iter().enumerate();
    let shown = titles.filter(|(_, title)| seen.iter().any(|text| text == title));
    shown.map(|(order, _)| order).collect()
}

/// A double click shows the plot under it alone, another one all again; keys choose it, links keep it.
#[tokio::test]
async fn one_plot_is_shown_alone() {
    let page = Page::open().await;
    page.stop_at("62").await;
    assert_eq!(orders(&page).await, [0, 1, 2]);
    let area = page.element("charts").await.rect().await.unwrap();
    let at = |order: f64| (0.6 * area.width, (0.2 + 0.3 * order) * area.height);
    for (order, name) in ["value", "first", "second"].into_iter().enumerate() {
        page.double_click("charts", at(order as f64)).await;
        assert_eq!(orders(&page).await, [order], "{name}");
        assert_eq!(page.written("only").await, name);
        page.double_click("charts", at(1.0)).await;
        assert_eq!(orders(&page).await, [0, 1, 2], "{name}");
    }
    page.press("only", Key::Down).await;
    assert_eq!(orders(&page).await, [0]);
    page.press("only", Key::End).await;
    assert_eq!(orders(&page).await, [2]);
    page.until("the address", async || {
        page.address().await.contains("v.only=second")
    })
    .await;
    page.reload().await;
    assert_eq!(page.written("only").await, "second");
    assert_eq!(orders(&page).await, [2]);
    // It takes the room of all three.
    page.choose("plot", "rocker.angle").await;
    page.choose("only", "first").await;
    let rows = async || {
        let picture = page.picture("charts").await;
        let curve = picture.places(ROCKER).filter(|(_, y)| *y > 30);
        let rows: Vec<usize> = curve.map(|(_, y)| y).collect();
        rows.iter().max().unwrap() - rows.iter().min().unwrap()
    };
    let (alone, height) = (rows().await, area.height as usize);
    assert!(alone > height / 2, "{alone} of {height}");
    page.close().await;
}

/// A press on the title of a plot makes it large, another one shows all again, a double click is one of the two. None of them
/// drives the mechanism.
#[tokio::test]
async fn a_press_on_a_title_makes_a_plot_large() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let find = "const canvas = document.getElementById('charts'), { left, top } = canvas.getBoundingClientRect(), found = [];
        for (let y = 0; y < canvas.clientHeight; y += 4) {
            canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: left + 60, clientY: top + y }));
            if (canvas.dataset.titled === 'true' && !(y - found.at(-1) < 40)) found.push(y);
        }
        arguments[0](found)";
    let titles = page.numbers(find).await;
    assert_eq!(titles.len(), 3, "{titles:?}");
    for (order, y) in titles.iter().enumerate() {
        page.drag_along("charts", &[(50.0, y + 6.0)]).await;
        assert_eq!(orders(&page).await, [order]);
        page.drag_along("charts", &[(80.0, titles[0] + 6.0)]).await;
        assert_eq!(orders(&page).await, [0, 1, 2]);
    }
    page.fingers("charts", &[vec![(110.0, titles[1] + 6.0)]])
        .await;
    assert_eq!(orders(&page).await, [1]);
    page.choose("only", "all").await;
    page.double_click("charts", (60.0, titles[2] + 6.0)).await;
    assert_eq!(orders(&page).await, [2]);
    assert!(page.written("angle").await.starts_with("62"));
    page.close().await;
}

/// The column of plots is dragged wider and narrower, by keys, too; a press or a far drag folds it away. Its width is kept.
#[tokio::test]
async fn the_column_of_plots_has_the_width_one_gives_it() {
    let page = Page::open().await;
    let widths = async || {
        let found = page
            .numbers("arguments[0](['plot-column', 'mechanism'].map((id) => document.getElementById(id).offsetWidth))")
            .await;
        [found[0], found[1]]
    };
    let by = async |pixels: f64| {
        page.drag_along("plots-edge", &[(7.0, 90.0), (7.0 - pixels, 90.0)])
            .await;
    };
    let [usual, stage] = widths().await;
    by(100.0).await;
    let [wide, narrow] = widths().await;
    assert!((wide - usual - 100.0).abs() <= 2.0, "{usual} {wide}");
    assert!((stage - narrow - 100.0).abs() <= 2.0, "{stage} {narrow}");
    page.reload().await;
    assert!((widths().await[0] - wide).abs() <= 1.0);
    page.focus("plots-edge").await;
    page.keys(Key::Right + "").await;
    assert!(widths().await[0] < wide - 20.0);
    page.keys(Key::End + "").await;
    assert!(widths().await[1] >= 220.0);
    page.keys(Key::Home + "").await;
    assert_eq!(widths().await[0], 300.0);
    for fold in ["key", "press", "drag"] {
        let before = widths().await;
        match fold {
            "key" => page.keys(Key::Enter + "").await,
            "press" => by(0.0).await,
            _ => by(-250.0).await,
        }
        let [none, all] = widths().await;
        assert_eq!(none, 0.0, "{fold}");
        assert!(all >= before[0] + before[1], "{fold}: {all}");
        page.keys(Key::Enter + "").await;
        assert_eq!(widths().await, before, "{fold}");
    }
    page.close().await;
}

/// The column of settings, too; a lesson that is opened unfolds it.
#[tokio::test]
async fn the_column_of_settings_has_the_width_one_gives_it() {
    let page = Page::open().await;
    let width = async || {
        page.numbers("arguments[0]([document.getElementById('rail').offsetWidth])")
            .await[0]
    };
    let by = async |pixels: f64| {
        page.drag_along("rail-edge", &[(7.0, 90.0), (7.0 + pixels, 90.0)])
            .await;
    };
    let usual = width().await;
    by(80.0).await;
    let wide = width().await;
    assert!((wide - usual - 80.0).abs() <= 2.0, "{usual} {wide}");
    page.reload().await;
    assert!((width().await - wide).abs() <= 1.0);
    page.focus("rail-edge").await;
    page.keys(Key::Left + "").await;
    assert!(width().await < wide - 20.0);
    page.keys(Key::Home + "").await;
    assert_eq!(width().await, 240.0);
    by(0.0).await;
    assert_eq!(width().await, 0.0);
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-mixer").await == 1
    })
    .await;
    page.click("gallery-lesson-mixer").await;
    page.until("the lesson", async || {
        page.count("#lesson-check:not(:empty)").await == 1
    })
    .await;
    assert!(
        page.numbers("arguments[0]([document.getElementById('lesson').offsetWidth])")
            .await[0]
            >= 320.0
    );
    page.close().await;
}

/// The colour of the rocker's curve.
const ROCKER: [u8; 3] = [0x00, 0x9E, 0x73];

/// The numbers at the cursor cover no label, wherever it stands.
#[tokio::test]
async fn numbers_keep_off_labels() {
    let page = Page::open().await;
    page.stop_at("62").await;
    // Labels are written on an edge of paper, the boxes of numbers are round.
    let script = "const kind = CanvasRenderingContext2D.prototype;
        const { strokeText, roundRect } = kind;
        window.labels = []; window.tags = [];
        kind.strokeText = function (text, x, y) {
            if (this.canvas.id === 'charts') window.labels.push([x, y - 5, x + this.measureText(text).width, y + 5]);
            strokeText.call(this, text, x, y);
        };
        kind.roundRect = function (x, y, w, h, r) {
            if (this.canvas.id === 'chart-cursor') window.tags.push([x, y, x + w, y + h]);
            roundRect.call(this, x, y, w, h, r);
        };";
    page.ask(script).await;
    page.ask("document.querySelector('.charts').style.flex = '0 0 560px'")
        .await;
    page.settle().await;
    let labels = page.ask("return window.labels.length").await;
    assert!(labels.as_u64().unwrap() > 10, "{labels}");
    let (mut tags, mut covered) = (0, 0);
    for degrees in (0..360).step_by(12) {
        page.ask("window.tags = []").await;
        page.write("angle", &degrees.to_string()).await;
        let found = page
            .numbers(
                "const over = ([a, b, c, d], [e, f, g, h]) => a < g && e < c && b < h && f < d;
                arguments[0]([window.tags.length, window.tags.filter((tag) => window.labels.some((label) => over(tag, label))).length])",
            )
            .await;
        tags += found[0] as usize;
        covered += found[1] as usize;
    }
    assert!(tags >= 30 * 6, "{tags}");
    assert_eq!(covered, 0, "of {tags}");
    page.close().await;
}

/// μ of the mixer, α of a slider-crank, by choice; what is said of them is the engine's.
#[tokio::test]
async fn how_well_dyads_transmit_is_plotted() {
    let page = Page::open().await;
    page.stop_at("0").await;
    page.choose("plot", "C.transmission").await;
    let seen = texts(&page).await;
    let cosine = |diagonal: f64| {
        (0.85_f64.powi(2) + 0.55_f64.powi(2) - diagonal.powi(2)) / (2.0 * 0.85 * 0.55)
    };
    let [near, far] = [0.48, 1.22].map(|diagonal| cosine(diagonal).abs().acos().to_degrees());
    for wanted in ["μ C", "μ′ C", "μ″ C"] {
        assert!(seen.iter().any(|text| text == wanted), "{wanted}: {seen:?}");
    }
    // Alone it has room for every label.
    page.choose("only", "value").await;
    let seen = texts(&page).await;
    for wanted in [
        format!("{near:.1}° at 0.0°"),
        format!("{far:.1}° at 180.0°"),
    ] {
        assert!(seen.contains(&wanted), "{wanted}: {seen:?}");
    }
    page.choose("only", "all").await;
    assert_near(page.value("out-C.transmission").await, near, 1e-9, "μ");
    page.until("the address", async || {
        page.address().await.contains("v.plot=C.transmission")
    })
    .await;
    page.reload().await;
    assert_eq!(page.written("plot").await, "C.transmission");

    open(&page, "slider-crank-offset").await;
    assert_eq!(page.text("out-linkage-pressure").await, "41.81° (C)");
    page.choose("plot", "C.pressure").await;
    page.write("angle", "90").await;
    let greatest = (2.0_f64 / 3.0).asin().to_degrees();
    assert_near(page.value("out-C.pressure").await, greatest, 1e-9, "α");
    let seen = texts(&page).await;
    for wanted in ["α C", "α″ C", "41.8° at 90.0°", "0.0° at 270.0°"] {
        assert!(seen.iter().any(|text| text == wanted), "{wanted}: {seen:?}");
    }
    // Of a dyad within a longer linkage its own.
    let url = format!("{}#watt-2&v.playing=false", home());
    page.anew(&url).await;
    let offered = page.count("#plot option[value$='.transmission']").await;
    assert_eq!(offered, 2);
    page.close().await;
}
