//! Drawn from nothing by events alone: with a mouse and keys, as a lecturer would. What is drawn moves
//! as the mechanism of the catalogue does, and the presses are counted.

use std::time::Instant;

use assur::Point;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_file::{Document, LinkageDocument, State, document};
use thirtyfour::Key;

use crate::browser::Page;

/// What the sheet shows at least, and the room around it, pixels: as the page fits it.
const SHEET: [f64; 4] = [-6.0, -4.0, 6.0, 4.0];
const MARGIN: f64 = 44.0;

/// An empty sheet, on which every press is counted.
pub(crate) struct Sheet<'a> {
    pub(crate) page: &'a Page,
    pub(crate) presses: usize,
    begun: Instant,
    scale: f64,
    middle: (f64, f64),
}

impl<'a> Sheet<'a> {
    /// A new drawing.
    pub(crate) async fn new(page: &'a Page) -> Self {
        page.click("new-drawing").await;
        page.until("the tools", async || {
            page.count("#draw-tools:not([hidden])").await == 1
        })
        .await;
        page.settle().await;
        let area = page.element("mechanism").await.rect().await.unwrap();
        // The tools stand on its top, the buttons in its corner.
        let tools = "const tools = document.getElementById('draw-tools'); return tools.offsetTop + tools.offsetHeight";
        let corner = "return document.getElementById('zoom-in').offsetHeight + 10";
        let inset = page.ask(tools).await.as_f64().unwrap();
        let below = page.ask(corner).await.as_f64().unwrap();
        let [left, bottom, right, top] = SHEET;
        let scale = ((area.width - 2.0 * MARGIN) / (right - left))
            .min((area.height - inset - below - 2.0 * MARGIN) / (top - bottom));
        Self {
            page,
            presses: 2,
            begun: Instant::now(),
            scale,
            middle: (
                area.width / 2.0,
                inset + (area.height - inset - below) / 2.0,
            ),
        }
    }

    /// Where a place of the sheet is on the canvas.
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        (
            self.middle.0 + self.scale * x,
            self.middle.1 - self.scale * y,
        )
    }

    /// Presses a place.
    pub(crate) async fn press(&mut self, x: f64, y: f64) {
        self.presses += 1;
        self.page.drag_along("mechanism", &[self.at([x, y])]).await;
    }

    /// Presses places, one after the other.
    pub(crate) async fn line(&mut self, places: &[[f64; 2]]) {
        for [x, y] in places {
            self.press(*x, *y).await;
        }
    }

    /// Takes up a tool, which may be in the menu.
    pub(crate) async fn tool(&mut self, name: &str) {
        let id = format!("draw-{name}");
        if self
            .page
            .count(&format!("#draw-menu[hidden] > #{id}"))
            .await
            == 1
        {
            self.presses += 1;
            self.page.click("draw-more").await;
        }
        self.presses += 1;
        self.page.click(&id).await;
    }

    /// Ends what is being drawn.
    pub(crate) async fn end(&self) {
        self.page.keys(Key::Escape).await;
        self.page.settle().await;
    }

    /// Presses the first way to mend it.
    pub(crate) async fn mend(&mut self) {
        self.presses += 1;
        let reasons = self.page.text("draw-reasons").await;
        let script = "const [first] = document.querySelectorAll('#draw-mends button'); first?.click(); return Boolean(first)";
        assert_eq!(
            self.page.ask(script).await,
            true,
            "nothing mends it: {reasons}"
        );
        self.page.settle().await;
    }

    /// Types the places of all points, from field to field.
    pub(crate) async fn type_places(&mut self, places: &[(&str, [f64; 2])]) {
        for (name, at) in places {
            for (axis, value) in ["x", "y"].iter().zip(at) {
                self.page
                    .write(&format!("draw-{axis}-{name}"), &value.to_string())
                    .await;
            }
        }
    }

    /// How many presses it took, and how long with each press drawn before the next.
    pub(crate) fn tell(&self, name: &str) {
        let seconds = self.begun.elapsed().as_secs_f64();
        println!("{name}: {} presses, {seconds:.1} s", self.presses);
    }

    /// What is drawn, as it is saved.
    pub(crate) async fn saved(&self) -> State {
        let kept =
            "dispatchEvent(new Event('pagehide')); return localStorage.getItem('assur.state')";
        let text = self.page.ask(kept).await;
        State::parse(text.as_str().unwrap()).unwrap()
    }

    /// What is drawn moves as a mechanism of the catalogue, with other names of the points.
    pub(crate) async fn moves_like(&self, name: &str, points: &[(&str, &str)]) {
        assert_eq!(self.page.said().await, [""; 0]);
        let Document::Linkage(drawn) = self.saved().await.document else {
            panic!("it does not move: {}", self.page.text("draw-reasons").await);
        };
        let Some(Document::Linkage(known)) = document(name).transpose().unwrap() else {
            panic!("there is no {name}");
        };
        let motion = |document: &LinkageDocument| Motion::new(document.mechanism().unwrap());
        let [drawn, known] = [motion(&drawn), motion(&known)];
        let [a, b] = [drawn.mechanism(), known.mechanism()];
        assert_eq!(a.structure().class(), b.structure().class());
        let size = 2.0
            * points
                .iter()
                .map(|(_, one)| place(&known, known.drawn_input(), one).coords.norm())
                .fold(0.0, f64::max);
        for k in 0..72 {
            let by = f64::from(k) * 5_f64.to_radians();
            for (one, other) in points {
                let [at, wanted] = [
                    place(&drawn, drawn.drawn_input() + by, one),
                    place(&known, known.drawn_input() + by, other),
                ];
                let off = (at - wanted).norm();
                assert!(
                    off <= 1e-9 * size,
                    "{name}: {one} at {k}·5° is off by {off:e}"
                );
            }
        }
    }
}

pub(crate) fn place(motion: &Motion, input: f64, name: &str) -> Point {
    let mechanism: &Mechanism = motion.mechanism();
    let pose = motion.pose::<1>(input).unwrap();
    mechanism
        .place(&pose, mechanism.point(name).unwrap())
        .place()
}

#[tokio::test]
async fn a_four_bar_takes_eight_presses() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet
        .line(&[
            [-3.0, -1.0],
            [-3.0, 0.0],
            [0.6, 1.8],
            [1.0, -1.0],
            [1.0, -1.0],
        ])
        .await;
    assert_eq!(page.text("out-draft-w").await, "1");
    sheet.mend().await;
    assert_eq!(sheet.presses, 8);
    sheet.tell("Four-bar");
    let state = sheet.saved().await;
    let motion = state.document.motion().unwrap();
    assert_eq!(motion.mechanism().formula(), "I(frame,AB) → II₂(BC,DC)");
    let places = state.document.linkage().unwrap().points;
    let places: Vec<[f64; 2]> = places.iter().map(|point| point.at).collect();
    assert_eq!(
        places,
        [[-3.0, -1.0], [-3.0, 0.0], [0.6, 1.8], [1.0, -1.0]],
        "snapped to the grid"
    );
    // It moves, and all of it is undone.
    let before = page.value("out-input").await;
    page.click("step-forward").await;
    assert!((page.value("out-input").await - before - 1.0).abs() < 1e-9);
    for _ in 0..6 {
        page.chord(&[Key::Control], 'z').await;
    }
    assert_eq!(page.count("#draw-points input").await, 0);
    page.close().await;
}

#[tokio::test]
async fn jansen_is_drawn() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    let at = |x: f64, y: f64| [x / 25.0 + 2.0, y / 25.0 + 1.0];
    sheet
        .line(&[
            at(0.0, 0.0),
            at(15.0, 0.0),
            at(-24.0, 31.0),
            at(-38.0, -8.0),
            at(-38.0, -8.0),
        ])
        .await;
    sheet.tool("plate").await;
    sheet.line(&[at(-31.0, 12.0), at(-75.0, 8.0)]).await;
    sheet.tool("bars").await;
    sheet
        .line(&[at(15.0, 0.0), at(-27.0, -45.0), at(-38.0, -8.0)])
        .await;
    sheet
        .line(&[at(-75.0, 8.0), at(-59.0, -28.0), at(-27.0, -45.0)])
        .await;
    sheet.tool("plate").await;
    sheet.line(&[at(-43.0, -36.5), at(-43.0, -92.0)]).await;
    sheet.mend().await;
    assert!(sheet.presses <= 60, "{} presses", sheet.presses);
    sheet.tell("Jansen's leg");
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [15.0, 0.0]),
            ("C", [-24.013535097127793, 31.272097454842683]),
            ("D", [-38.0, -7.8]),
            ("E", [-74.79436538093606, 8.143170205896137]),
            ("F", [-26.952107031572965, -45.51517017008116]),
            ("G", [-59.231514961415, -28.052930230747766]),
            ("H", [-43.160110524104724, -91.75693292612323]),
        ])
        .await;
    let points = [
        ("A", "O"),
        ("B", "M"),
        ("C", "U"),
        ("D", "B"),
        ("E", "W"),
        ("F", "V"),
        ("G", "X"),
        ("H", "F"),
    ];
    sheet.moves_like("jansen", &points).await;
    page.close().await;
}

#[tokio::test]
async fn a_whitworth_shaper_is_drawn() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.line(&[[2.0, 0.0], [3.0, 1.8]]).await;
    sheet.end().await;
    sheet.line(&[[2.0, -1.0], [3.2, 2.2]]).await;
    sheet.end().await;
    sheet.tool("plate").await;
    sheet.line(&[[2.5, 0.4], [1.6, -2.0]]).await;
    sheet.tool("bars").await;
    sheet.line(&[[1.6, -2.0], [-2.2, -1.0]]).await;
    sheet.tool("slide").await;
    sheet.line(&[[3.0, 1.8], [2.3, -0.2]]).await;
    sheet.line(&[[-2.2, -1.0], [-4.0, -1.0]]).await;
    sheet.mend().await;
    sheet.tell("Whitworth's shaper");
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [1.0000000000000002, 1.7320508075688772]),
            ("C", [0.0, -1.0]),
            ("D", [1.1686608157336975, 2.1928407253993503]),
            ("E", [-0.34372376933344045, -1.9390708015880442]),
            ("F", [-4.23192978620096, -1.0]),
            ("G", [-4.23192978620096, -1.0]),
            ("H", [-6.0, -1.0]),
        ])
        .await;
    let points = [("B", "B"), ("C", "D"), ("D", "T"), ("E", "E"), ("F", "F")];
    sheet.moves_like("whitworth", &points).await;
    page.close().await;
}

#[tokio::test]
async fn a_stephenson_chain_of_the_third_kind_is_drawn() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    let at = |x: f64, y: f64| [x - 3.0, y - 2.0];
    sheet
        .line(&[
            at(0.0, 0.0),
            at(0.4, 0.8),
            at(3.8, 3.0),
            at(4.0, 0.0),
            at(4.0, 0.0),
        ])
        .await;
    sheet.tool("plate").await;
    sheet.line(&[at(2.1, 1.9), at(1.2, 3.6)]).await;
    sheet.tool("bars").await;
    sheet
        .line(&[at(1.2, 3.6), at(4.8, 0.6), at(6.4, 2.4), at(6.4, 2.4)])
        .await;
    sheet.mend().await;
    sheet.tell("Stephenson III");
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [0.5000000000000001, 0.8660254037844386]),
            ("C", [3.884615384615385, 2.9977802438692107]),
            ("D", [4.0, 0.0]),
            ("E", [1.1264302722653063, 3.624210516134516]),
            ("F", [4.245518915543307, 0.5207791836616673]),
            ("G", [6.5, 2.5]),
        ])
        .await;
    let points = [("B", "B"), ("C", "C"), ("E", "P"), ("F", "Q"), ("G", "H")];
    sheet.moves_like("stephenson-3", &points).await;
    page.close().await;
}

#[tokio::test]
async fn the_class_four_mechanism_is_drawn() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    let at = |x: f64, y: f64| [x - 1.0, y + 1.4];
    // A, B, E; the plate EGF; F, K; the plate CLK; C, D; the plate HGL.
    sheet
        .line(&[at(0.0, 0.0), at(1.0, -0.2), at(5.0, 0.0), at(2.0, 0.4)])
        .await;
    sheet.end().await;
    sheet.tool("plate").await;
    sheet.line(&[at(3.4, 0.2), at(1.0, -2.8)]).await;
    sheet.tool("bars").await;
    sheet
        .line(&[at(1.0, -2.8), at(4.6, -4.4), at(0.4, -1.8)])
        .await;
    sheet.end().await;
    sheet.tool("plate").await;
    sheet.line(&[at(3.76, -3.88), at(-2.4, 1.6)]).await;
    sheet.tool("bars").await;
    sheet
        .line(&[at(-2.4, 1.6), at(-0.2, -4.8), at(-0.2, -4.8)])
        .await;
    sheet.line(&[at(4.0, 1.8), at(2.0, 0.4)]).await;
    sheet.tool("plate").await;
    sheet.line(&[at(3.2, 1.24), at(0.4, -1.8)]).await;
    sheet.mend().await;
    sheet.tell("Class IV");
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [1.0, 0.0]),
            ("C", [4.96, 0.01]),
            ("D", [2.0, 0.5]),
            ("E", [0.95, -2.83]),
            ("F", [4.62, -4.45]),
            ("G", [1.41, -2.63]),
            ("H", [-2.35, 1.53]),
            ("I", [-0.25, -4.78]),
            ("J", [4.07, 1.73]),
        ])
        .await;
    let points = [
        ("B", "B"),
        ("C", "E"),
        ("D", "G"),
        ("E", "F"),
        ("F", "K"),
        ("G", "L"),
        ("H", "C"),
    ];
    sheet.moves_like("class4-dwell", &points).await;
    page.close().await;
}
