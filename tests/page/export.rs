//! Files the page saves: the table of a sweep, pictures of drawing and plots.

mod elements;
mod hands;

use std::collections::HashMap;

use roxmltree::Document;
use thirtyfour::prelude::*;

use crate::browser::{Page, plain, setting};
use crate::picture::{COUPLER, CRANK, Picture, ROCKER, WHEEL5, apart};
use elements::{check_head, elements, painted, size, texts};

/// Pixels of an exported PNG per pixel of the page.
const SHARPNESS: usize = 3;

/// The page at rest at 75° with the dialog open, by mouse.
async fn open() -> Page {
    let page = Page::open().await;
    page.stop_at("75").await;
    open_dialog(&page).await;
    page
}

pub(crate) async fn open_dialog(page: &Page) {
    page.click("menu").await;
    page.click("export").await;
    wait_for_dialog(page).await;
}

async fn wait_for_dialog(page: &Page) {
    page.until("the dialog", async || {
        page.count("#export-dialog[open]").await == 1
    })
    .await;
}

async fn save(page: &Page, button: &str, name: &str) -> Vec<u8> {
    page.click(button).await;
    page.saved(name).await
}

pub(crate) async fn save_text(page: &Page, button: &str, name: &str) -> String {
    String::from_utf8(save(page, button, name).await).unwrap()
}

/// A saved table, its cells as they are written, by row and column.
pub(crate) struct Csv {
    columns: HashMap<String, usize>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Csv {
    pub(crate) async fn save(page: &Page, name: &str) -> Self {
        Self::parse(&save_text(page, "export-table-csv", name).await)
    }

    /// With a comma as decimal sign cells are apart by semicolons. Comments come first.
    fn parse(text: &str) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().skip_while(|line| line.starts_with("# "));
        let header = lines.next().unwrap();
        let comma = header.contains(';');
        let separator = if comma { ';' } else { ',' };
        let cells = |line: &str| -> Vec<String> {
            let cells = line.split(separator);
            cells.map(|cell| cell.replace(',', ".")).collect()
        };
        let header = cells(header);
        let rows: Vec<Vec<String>> = lines.map(cells).collect();
        assert!(
            ["phi_deg", "s_m", "t_s"].contains(&&*header[0]),
            "{header:?}"
        );
        assert_eq!(header.last().unwrap(), "reason");
        for row in &rows {
            assert_eq!(row.len(), header.len(), "{row:?}");
            // The shortest text of a number.
            for cell in row[..row.len() - 1].iter().filter(|cell| !cell.is_empty()) {
                let value: f64 = cell.parse().unwrap();
                assert!(
                    value.is_finite() && cell.len() <= format!("{value}").len(),
                    "{cell}"
                );
            }
        }
        // By their names without units, but for degrees of the crank.
        let columns = header.into_iter().enumerate().map(|(index, name)| {
            let units = ["_rad", "_deg", "_m", "_s"];
            let ends = units.iter().filter_map(|unit| name.find(unit));
            let end = ends.min().filter(|_| name != "phi_deg");
            (name[..end.unwrap_or(name.len())].to_owned(), index)
        });
        Self {
            columns: columns.collect(),
            rows,
        }
    }

    fn cell(&self, row: usize, column: &str) -> &str {
        &self.rows[row][self.columns[column]]
    }

    pub(crate) fn value(&self, row: usize, column: &str) -> f64 {
        self.cell(row, column).parse().unwrap()
    }
}

/// Decimal sign, degrees, names in words, dimensions: as the reader chooses.
#[tokio::test]
async fn the_table_is_written_as_chosen() {
    let page = open().await;
    let plain = save_text(&page, "export-table-csv", "assur-mixer-a.csv").await;
    assert!(
        plain.starts_with("# length of A-B = 0.37 m\n"),
        "{plain:.200}"
    );
    let header = plain.lines().find(|line| !line.starts_with("# ")).unwrap();
    for name in [
        "phi_deg,crank.angle_deg,crank.dangle_rad_per_rad,crank.ddangle_rad_per_rad2,",
        ",C1.x_m,C1.y_m,C1.dx_m_per_rad,",
        ",C1.ddy_m_per_rad2,",
    ] {
        assert!(header.contains(name), "{name} in {header}");
    }
    let degrees = Csv::parse(&plain);

    page.choose("export-decimal", "comma").await;
    page.choose("export-angles", "rad").await;
    page.choose("export-dimensions", "none").await;
    let chosen = save_text(&page, "export-table-csv", "assur-mixer-a.csv").await;
    let header = chosen.lines().next().unwrap();
    let begins = "phi_deg;crank.angle_rad;crank.dangle_rad_per_rad;crank.ddangle_rad_per_rad2;";
    assert!(header.starts_with(begins), "{header}");
    let radians = Csv::parse(&chosen);
    let off = degrees.value(75, "rocker.angle").to_radians() / radians.value(75, "rocker.angle");
    assert!((off - 1.0).abs() < 1e-14, "{off:e}");
    for column in ["rocker.dangle", "rocker.ddangle", "C2.y", "C2.dy", "C2.ddy"] {
        let [one, other] = [&degrees, &radians].map(|csv| csv.value(75, column));
        assert_eq!(one, other, "{column}");
    }
    // The analogue is the number of the page's own table.
    let shown = page.value("out-rocker.angle′").await;
    assert!((degrees.value(75, "rocker.dangle") - shown).abs() < 1e-9);

    page.choose("export-angles", "deg").await;
    page.choose("export-names", "words").await;
    let worded = save_text(&page, "export-table-csv", "assur-mixer-a.csv").await;
    let header: Vec<&str> = worded.lines().next().unwrap().split(';').collect();
    for name in [
        "angle of rocker, deg",
        "angular acceleration analogue of rocker, rad/rad²",
        "velocity analogue of C2 along x, m/rad",
    ] {
        let called = |cell: &&str| cell.trim_start_matches('\u{feff}') == name;
        assert!(header.iter().any(called), "{name} in {header:?}");
    }
    page.close().await;
}

/// The height of the line of text under a drawing, pixels.
const CAPTION: f64 = 40.0;

#[tokio::test]
async fn the_drawing_is_saved_as_svg() {
    let page = open().await;
    let area = page.element("mechanism").await.rect().await.unwrap();
    let svg = save_text(&page, "export-drawing-svg", "assur-mixer-a-drawing.svg").await;
    let svg = Document::parse(&svg).unwrap();
    let drawn = elements(&svg);
    // The mechanism with its room, not the screen, over a line of text.
    let (width, height) = size(&drawn);
    check_head(&drawn, width, height);
    let fits = 0.95 * area.width < width && width <= area.width + 1.0;
    assert!(
        fits && height < 0.75 * area.height,
        "{width} {height} {area:?}"
    );
    assert_eq!(
        drawn[1].text().map(plain),
        page.attribute("mechanism", "aria-label").await
    );
    let below = drawn[2].attribute("height").unwrap();
    assert_eq!(below.parse::<f64>().unwrap(), height - CAPTION);
    let labels = texts(&drawn);
    assert_eq!(labels.last().unwrap(), "Mixer, case a, φ₁ = 75.0°");
    for label in ["A", "B", "C", "D", "4", "5", "φ₁ = 75.0°", "0.2 m"] {
        let count = labels.iter().filter(|text| *text == label).count();
        assert_eq!(count, 1, "{label} in {labels:?}");
    }
    // A bar; the crank's has the path of B and the arc of φ₁ with its head beside it.
    assert_eq!(painted(&drawn, "fill", "#d55e00"), 1);
    assert_eq!(painted(&drawn, "stroke", "#d55e00"), 0);
    assert_eq!(painted(&drawn, "fill", "#0072b2"), 2);
    assert_eq!(painted(&drawn, "stroke", "#0072b2"), 2);
    // The teeth of wheel 5: one outline, filled and drawn.
    assert_eq!(painted(&drawn, "stroke", "#7a4a8c"), 1);

    // The same, seen: as on the screen, only moved.
    page.click("export-close").await;
    let shown = page.picture("mechanism").await;
    page.show_picture(svg.input_text()).await;
    let painted = page.picture("shown").await;
    let mut moved = Vec::new();
    for colour in [CRANK, COUPLER, WHEEL5] {
        let (here, there) = (shown.cloud(colour), painted.cloud(colour));
        let share = there.count as f64 / here.count as f64;
        assert!((0.9..1.1).contains(&share), "{here:?} {there:?}");
        let (here, there) = (shown.centre(colour), painted.centre(colour));
        moved.push((here.0 - there.0, here.1 - there.1));
    }
    for by in &moved {
        let off = (by.0 - moved[0].0).hypot(by.1 - moved[0].1);
        assert!(off < 1.0, "{moved:?}");
    }
    page.close().await;
}

#[tokio::test]
async fn the_drawing_is_saved_as_png() {
    let page = open().await;
    let png = save(&page, "export-drawing-png", "assur-mixer-a-drawing.png").await;
    let saved = Picture::decode(&png);
    page.click("export-close").await;
    let shown = page.picture("mechanism").await;
    let scale = SHARPNESS as f64;
    assert!(saved.width <= SHARPNESS * (shown.width + 1) && saved.width.is_multiple_of(SHARPNESS));
    assert!(saved.height < SHARPNESS * shown.height * 3 / 4);
    let (small, large) = (shown.cloud(COUPLER), saved.cloud(COUPLER));
    assert!(large.count > 4000, "{large:?}");
    let turned = apart(small.direction, large.direction);
    assert!(turned < 0.5, "{small:?} {large:?}");
    // Seen from wheel 5 the coupler is where it is on the screen.
    let [near, far] = [&shown, &saved].map(|picture| picture.cloud(WHEEL5));
    let [x, y] = [
        (large.middle.0 - far.middle.0) / scale - (small.middle.0 - near.middle.0),
        (large.middle.1 - far.middle.1) / scale - (small.middle.1 - near.middle.1),
    ];
    assert!(x.hypot(y) < 1.0, "{small:?} {large:?}");
    // Of the crank's colour are its angle and the path of B, too.
    assert!(saved.places(CRANK).count() > 4000);
    page.close().await;
}

#[tokio::test]
async fn plots_are_saved_under_a_legend() {
    let page = open().await;
    let area = "const { clientWidth, clientHeight } = document.getElementById('charts'); arguments[0]([clientWidth, clientHeight])";
    let [width, height] = page.numbers(area).await[..] else {
        panic!("two sides")
    };
    let legend = 20.0;
    let svg = save_text(&page, "export-plots-svg", "assur-mixer-a-plots.svg").await;
    let svg = Document::parse(&svg).unwrap();
    let drawn = elements(&svg);
    check_head(&drawn, width, height + legend);
    let labels = texts(&drawn);
    for label in [
        "φ₃′",
        "ψ₅″",
        "  angular acceleration analogue, 1/rad",
        "148.2° at 217.1°",
        "2.187 at 340.1°",
        "−4.112 at 8.5°",
        "360°",
    ] {
        assert!(
            labels.iter().any(|text| text == label),
            "{label} in {labels:?}"
        );
    }
    // The spaces before a unit keep it off its symbol.
    let unit = drawn.iter().find(|e| e.text() == Some("  angle, °"));
    let space = ("http://www.w3.org/XML/1998/namespace", "space");
    assert_eq!(unit.unwrap().attribute(space), Some("preserve"));
    // In the legend and in the first title.
    for curve in ["φ₃", "ψ₅"] {
        let count = labels.iter().filter(|text| *text == curve).count();
        assert_eq!(count, 2, "{curve} in {labels:?}");
    }
    for colour in ["#009e73", "#7a4a8c"] {
        // A curve in each plot, its sample in the legend.
        assert_eq!(painted(&drawn, "stroke", colour), 4, "{colour}");
        let curves = drawn
            .iter()
            .filter(|e| e.attribute("stroke") == Some(colour));
        let points = curves.map(|e| e.attribute("d").unwrap().matches('L').count());
        assert_eq!(points.filter(|count| *count == 720).count(), 3, "{colour}");
    }

    let png = save(&page, "export-plots-png", "assur-mixer-a-plots.png").await;
    let png = Picture::decode(&png);
    let high = SHARPNESS * (height + legend) as usize;
    assert_eq!((png.width, png.height), (SHARPNESS * width as usize, high));
    for colour in [ROCKER, WHEEL5] {
        for third in 0..3 {
            let rows = third * high / 3..(third + 1) * high / 3;
            let curve = png.places(colour).filter(|(_, y)| rows.contains(y));
            assert!(curve.count() > 2000, "{colour:?} in plot {third}");
        }
    }
    page.close().await;
}

/// Drawing mode hides the plots, which are saved nevertheless.
#[tokio::test]
async fn plots_are_saved_in_drawing_mode() {
    let page = Page::playing_at(
        &format!("{}#crank-rocker&v.drawing=true", crate::host::home()),
        "en-US",
    )
    .await;
    page.settle().await;
    let hidden = "return document.getElementById('charts').clientWidth === 0";
    assert_eq!(page.ask(hidden).await, serde_json::json!(true));
    open_dialog(&page).await;
    let png = save(&page, "export-plots-png", "assur-crank-rocker-plots.png").await;
    let png = Picture::decode(&png);
    assert_eq!(png.width, 480 * SHARPNESS);
    assert!(png.cloud(ROCKER).count > 4000, "{:?}", png.cloud(ROCKER));
    let svg = save_text(&page, "export-plots-svg", "assur-crank-rocker-plots.svg").await;
    let svg = Document::parse(&svg).unwrap();
    let labels = texts(&elements(&svg));
    assert!(labels.iter().any(|text| text == "360°"), "{labels:?}");
    page.close().await;
}

/// The page may be dark; what is printed is not.
#[tokio::test]
async fn pictures_are_on_light_paper() {
    let page = open().await;
    page.prefer("prefers-color-scheme", "dark").await;
    let light = page.picture("mechanism").await.cloud(COUPLER);
    assert_eq!(light.count, 0, "{light:?}");
    let png = save(&page, "export-drawing-png", "assur-mixer-a-drawing.png").await;
    let png = Picture::decode(&png);
    assert!(png.cloud(COUPLER).count > 4000);
    let white = png.places([255; 3]).count();
    assert!(2 * white > png.width * png.height, "{white}");
    let svg = save_text(&page, "export-plots-svg", "assur-mixer-a-plots.svg").await;
    assert!(svg.contains("#009e73") && !svg.contains("color-mix"));
    page.close().await;
}

#[tokio::test]
async fn a_picture_goes_to_the_clipboard() {
    let page = open().await;
    let copied = "navigator.clipboard.write = async ([item]) => { window.copied = await item.getType('image/png'); }";
    page.ask(copied).await;
    page.click("export-drawing-copy").await;
    page.until("the picture", async || {
        page.text("export-said").await == "The picture is in the clipboard."
    })
    .await;
    let png = "return copied.type === 'image/png' && copied.size > 10000";
    assert_eq!(page.ask(png).await, serde_json::json!(true));
    page.ask("navigator.clipboard.write = () => Promise.reject(new Error())")
        .await;
    page.click("export-plots-copy").await;
    page.until("the refusal", async || {
        page.text("export-said").await.ends_with("save it as PNG.")
    })
    .await;
    page.close().await;
}
