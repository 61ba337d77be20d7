//! Points of a linkage dragged.

use super::*;

/// Where the fitted drawing has a place of a linkage.
async fn on_screen(page: &Page, document: &LinkageDocument, places: &[Point]) -> Vec<(f64, f64)> {
    let area = page.element("mechanism").await.rect().await.unwrap();
    let motion = document.motion().unwrap();
    let figure = Figure::new(&motion, &View::default()).unwrap();
    let [left, bottom, right, top] = figure.bounds();
    let fitted = |height: f64| {
        let scale = ((area.width - 88.0) / (right - left)).min((height - 88.0) / (top - bottom));
        move |p: &Point| {
            (
                0.5 * area.width + scale * (p.x - 0.5 * (left + right)),
                0.5 * height - scale * (p.y - 0.5 * (bottom + top)),
            )
        }
    };
    // Clear of the buttons in the corner, ten pixels from the edges.
    let corner = page.element("zoom").await.rect().await.unwrap();
    let free = area.height - corner.height - 20.0;
    let (x, y) = fitted(area.height)(&Point::new(right, bottom));
    let covered = x > area.width - corner.width - 20.0 && y > free;
    let height = if covered { free } else { area.height };
    places.iter().map(fitted(height)).collect()
}

#[tokio::test]
async fn points_of_a_linkage_are_dragged_and_undone() {
    let page = Page::open().await;
    page.stop_at("60").await;
    open(&page, "watt-1").await;
    let document = document("watt-1");
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(60f64.to_radians()).unwrap();
    let place = |name: &str| {
        let point = mechanism.point(name);
        mechanism.place(&pose, point.unwrap()).place()
    };
    page.choose("plot", "G").await;
    page.settle().await;
    agrees(&page, &document, "G.x").await;
    // The end of the crank drives it.
    let [a, b] = ["A", "B"].map(place);
    let to = a + Vector::new(-0.7, 0.7);
    let way = on_screen(&page, &document, &[b, a + Vector::new(0.0, 1.0), to]).await;
    page.drag_along("mechanism", &way).await;
    let turned = page.value("out-input").await;
    assert!((turned - 135.0).abs() < 1.0, "{turned}");
    agrees(&page, &document, "G.x").await;
    page.stop_at("60").await;
    // Any other point makes the links that list it others.
    let g = place("G");
    let to = g + Vector::new(0.6, 0.4);
    let way = on_screen(&page, &document, &[g, g + Vector::new(0.2, 0.3), to]).await;
    page.drag_along("mechanism", &way).await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert!((page.value("out-G.x").await - to.x).abs() < 0.05);
    assert!((page.value("out-G.y").await - to.y).abs() < 0.05);
    assert_eq!(page.value("out-input").await, 60.0);
    page.click("undo").await;
    page.settle().await;
    agrees(&page, &document, "G.x").await;
    // Arrows of velocity and acceleration are laid over it.
    for shown in [false, true] {
        if shown {
            page.click("vectors").await;
            page.settle().await;
        }
        for colour in [VELOCITY, ACCELERATION] {
            let count = of_colour(&page, colour).await;
            assert_eq!(count > 30.0, shown, "{colour:?}: {count}");
        }
    }
    page.close().await;
}

/// A file that holds no mechanism: the sentence names links and points, and what is
/// on the page stays.
#[tokio::test]
async fn what_is_no_mechanism_names_links_and_points() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "whitworth").await;
    let whole = document("slider-crank");
    let broken = |change: fn(&mut LinkageDocument)| {
        let mut document = whole.clone();
        change(&mut document);
        document
    };
    let guides = || {
        let mut yoke = document("scotch-yoke");
        yoke.links[2].shape = None;
        for (name, x) in [("S", 2.0), ("T", -1.0)] {
            let point = yoke.points.iter_mut().find(|point| point.name == name);
            point.unwrap().at = [x, 0.8660254037844386];
        }
        yoke
    };
    let folder = std::env::temp_dir().join(format!("assur-broken-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for (number, (document, sentence)) in [
        (
            broken(|one| {
                let mut brace = one.links[1].clone();
                (brace.name, brace.length) = ("brace".to_owned(), None);
                brace.points = ["G", "B"].map(str::to_owned).to_vec();
                one.links.push(brace);
            }),
            "There are too many pairs or drivers (W = 0); these links are locked: frame, crank, brace. Remove one of them, or a driver.",
        ),
        (
            broken(|one| one.slides.clear()),
            "There are fewer drivers than degrees of freedom (W = 3); these links stay free: rod, slider. Drive one of them, or join it to another link.",
        ),
        (
            broken(|one| {
                one.links[1].length = None;
                one.points[2].at = one.points[1].at;
            }),
            "Link rod: its points B, C coincide, so its direction is unknown.",
        ),
        (
            broken(|one| one.links[1].length = Some(0.0)),
            "links[1].length: 0 is not allowed; a length must be greater than zero.",
        ),
        (
            guides(),
            "The guides of block, yoke are parallel; they must cross.",
        ),
        (
            broken(|one| one.links[1].length = Some(0.5)),
            "As drawn, rod, slider cannot be joined: they miss each other by 0.366. Change one of their lengths, or draw the driver in \
             another position.",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let state = serde_json::json!({
            "format": 1, "lesson": "linkage", "document": document,
        });
        let path = folder.join(format!("{number}.json"));
        std::fs::write(&path, state.to_string()).unwrap();
        page.choose_file("file", &path).await;
        page.until("the sentence", async || {
            page.text("notice-text").await.contains(sentence)
        })
        .await;
        assert!(shows(&page, "whitworth").await);
    }
    std::fs::remove_dir_all(folder).unwrap();
    page.close().await;
}
