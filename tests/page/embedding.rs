//! The page in a frame: what its parameters show and forbid, and in pages that are not ours, on another host.

use std::fs;

use serde_json::json;

use crate::browser::Page;
use crate::host::{Host, folder, home};

/// Which parts of the page are seen.
async fn seen(page: &Page) -> serde_json::Value {
    page.ask(
        "const parts = { top: '.bar-top', stage: '#mechanism', plots: '#charts', rail: '#rail', lesson: '#lesson', bar: '.transport' };
        return Object.keys(parts).filter((name) => document.querySelector(parts[name]).checkVisibility());",
    )
    .await
}

async fn at(parameters: &str) -> Page {
    let url = format!("{}?{parameters}", home());
    Page::playing_at(&url, "en-US").await
}

#[tokio::test]
async fn parameters_say_what_is_shown() {
    for (parameters, parts) in [
        ("embed=stage&play=no#jansen", json!(["stage", "bar"])),
        ("embed=stage&bar=no#jansen", json!(["stage"])),
        (
            "embed=plots&play=no#jansen",
            json!(["stage", "plots", "bar"]),
        ),
        (
            "embed=page&edit=no&play=no#jansen",
            json!(["top", "stage", "plots", "bar"]),
        ),
        (
            "embed=page&play=no#jansen",
            json!(["top", "stage", "plots", "rail", "bar"]),
        ),
        // Without `embed` the address has no parameters.
        (
            "play=no&wrong=1#jansen",
            json!(["top", "stage", "plots", "rail", "bar"]),
        ),
    ] {
        let page = at(parameters).await;
        assert_eq!(seen(&page).await, parts, "{parameters}");
        let playing = page.attribute("play", "data-playing").await.unwrap();
        let moves = parameters.contains("bar=no") || !parameters.contains("embed");
        assert_eq!(playing, moves.to_string(), "{parameters}");
        let noticed = "return document.getElementById('notice').hidden";
        assert_eq!(page.ask(noticed).await, json!(true), "{parameters}");
        // A frame is filled, whatever its size, without being wider.
        let wider = "const { scrollWidth, clientWidth } = document.documentElement; return scrollWidth - clientWidth";
        assert_eq!(page.ask(wider).await, json!(0), "{parameters}");
        page.close().await;
    }
}

#[tokio::test]
async fn a_lesson_opens_at_its_step() {
    let page = at("embed=lesson&lesson=mixer&step=3&play=no&lang=kk").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    let words = include_str!("../../www/lessons/mixer/words.kk.json");
    let words: serde_json::Value = serde_json::from_str(words).unwrap();
    let title = page.text("lesson-title").await;
    let step = words.as_object().unwrap().iter();
    let mut titles = step.filter(|(_, text)| **text == json!(title));
    let (key, _) = titles.next().unwrap();
    assert!(key.ends_with(".title"), "{key}");
    assert!(page.text("lesson").await.contains('3'));
    assert_eq!(
        seen(&page).await,
        json!(["stage", "plots", "lesson", "bar"])
    );
    page.close().await;
}

#[tokio::test]
async fn nothing_is_edited_and_nothing_kept_where_it_is_not_to_be() {
    let page = at("embed=stage&edit=no&play=no#mixer-a").await;
    let document = "return location.hash.includes('d.') || location.hash";
    let before = page.ask(document).await;
    // The other assembly, the gallery, undo, and a drag over the joints.
    page.keys("2").await;
    page.keys("g").await;
    let across: Vec<_> = (0..40)
        .map(|i| (200.0 + 20.0 * f64::from(i), 380.0))
        .collect();
    for down in [0.0, 60.0, 120.0] {
        let line: Vec<_> = across.iter().map(|(x, y)| (*x, y - down)).collect();
        page.drag_along("mechanism", &line).await;
    }
    assert_eq!(page.count("dialog[open]").await, 0);
    page.settle().await;
    tokio::time::sleep(std::time::Duration::from_millis(600)).await;
    assert!(
        !page.address().await.contains("d."),
        "{}",
        page.address().await
    );
    assert!(page.address().await.contains("#mixer-a"), "{before}");
    // The bar still moves it.
    page.write("angle", "120").await;
    assert!((page.value("out-input").await - 120.0).abs() < 1e-9);
    page.until("the address", async || {
        page.address().await.contains("v.phi_deg=120")
    })
    .await;
    assert_eq!(
        page.ask("return localStorage.getItem('assur.state')").await,
        json!(null)
    );
    page.close().await;

    // Nor are there tools for drawing, whatever the link says.
    for parameters in [
        "embed=stage&edit=no&play=no#crank-rocker",
        "embed=page&edit=no&play=no#crank-rocker&v.drawing=true",
    ] {
        let page = at(parameters).await;
        if parameters.contains("page") {
            page.click("menu").await;
        }
        let tools = "return ['#draw', '#trace', '#new-drawing', '#write-lesson', '[id^=become-]', '#draw-tools']
            .filter((tool) => [...document.querySelectorAll(tool)].some((one) => one.checkVisibility()))";
        assert_eq!(page.ask(tools).await, json!([]), "{parameters}");
        page.close().await;
    }

    // With editing the same key takes the other assembly, and there is a pencil.
    let page = at("embed=stage&play=no#mixer-a").await;
    page.keys("2").await;
    page.until("the other assembly", async || {
        page.address().await.contains("d.assembly=2")
    })
    .await;
    let pencil = "return document.getElementById('draw').checkVisibility()";
    assert_eq!(page.ask(pencil).await, json!(true));
    page.close().await;
}

#[tokio::test]
async fn unknown_parameters_are_sentences_and_no_markup() {
    let page = at("embed=stage&play=no&%3Cimg%20src=x%3E=1&lang=%3Cb%3Exx&step=0&edit=no&lesson=mixer#jansen&v.phi_deg=30").await;
    let said = page.text("notice-text").await;
    for part in [
        "Unknown frame parameter: <img src.",
        "The frame parameter lang cannot be “<b>xx”.",
        "The frame parameter step cannot be “0”.",
        "The frame parameter edit cannot be “no”.",
        "Everything else is shown as the address specifies.",
    ] {
        assert!(said.contains(part), "{said}");
    }
    assert_eq!(page.count("#notice img, #notice b").await, 0);
    assert!((page.value("out-input").await - 30.0).abs() < 1e-9);
    page.close().await;
}

/// Goes into a frame: what is asked of the page is asked of it.
async fn enter(page: &Page, frame: &str) {
    let frame = page.driver.execute(format!("return {frame}"), Vec::new());
    let frame = frame.await.unwrap().element().unwrap();
    frame.enter_frame().await.unwrap();
    page.until("the page in the frame", async || {
        page.count("html[data-ready='true']").await == 1
    })
    .await;
}

async fn leave(page: &Page) {
    page.driver.enter_default_frame().await.unwrap();
}

#[tokio::test]
async fn a_page_of_others_shows_it_by_one_script() {
    let site = Host::start(&folder(), "/courses/");
    let place = std::env::temp_dir().join(format!("assur-lecture-{}", std::process::id()));
    fs::create_dir_all(&place).unwrap();
    let host = site.url().replace("/courses/", "");
    let lecture = include_str!("../data/embedding/lecture.html");
    let lecture = lecture
        .replace("{{host}}", &host)
        .replace("{{site}}", &site.url());
    fs::write(place.join("index.html"), lecture).unwrap();
    let theirs = Host::start(&place, "/");

    let page = Page::elsewhere(&theirs.url(), "en-US").await;
    let leg = "document.getElementById('leg').shadowRoot.querySelector('iframe')";
    let looks = page
        .ask(&format!(
            "const {{ title, sandbox, src }} = {leg}; return [title, sandbox.value, src]"
        ))
        .await;
    assert_eq!(
        looks,
        json!([
            "The leg <b>of</b> Jansen",
            "allow-scripts allow-same-origin allow-downloads",
            format!("{}?play=no&embed=stage#jansen&v.phi_deg=30", site.url())
        ])
    );
    enter(&page, leg).await;
    assert_eq!(seen(&page).await, json!(["stage", "bar"]));
    assert!((page.value("out-input").await - 30.0).abs() < 1e-9);
    leave(&page).await;

    // Another mechanism in the same page of the frame, then another language, then another size.
    page.ask("document.getElementById('leg').setAttribute('src', '#crank-rocker&v.phi_deg=75')")
        .await;
    enter(&page, leg).await;
    page.until("the other mechanism", async || {
        (page.value("out-input").await - 75.0).abs() < 1e-9
    })
    .await;
    leave(&page).await;
    page.ask("document.getElementById('leg').setAttribute('lang', 'uk')")
        .await;
    tokio::time::sleep(std::time::Duration::from_millis(300)).await;
    enter(&page, leg).await;
    page.until("Ukrainian", async || {
        page.lang().await.as_deref() == Some("uk")
    })
    .await;
    leave(&page).await;
    page.ask("document.getElementById('leg').style.width = '420px'")
        .await;
    enter(&page, leg).await;
    page.until("the other size", async || {
        page.ask("return [innerWidth, document.getElementById('mechanism').clientWidth]")
            .await
            == json!([420, 420])
    })
    .await;
    leave(&page).await;

    // A plain frame.
    enter(&page, "document.getElementById('plain')").await;
    assert_eq!(seen(&page).await, json!(["stage", "plots", "bar"]));
    assert_eq!(page.lang().await.as_deref(), Some("ru"));
    assert!(page.text("notice-text").await.contains("colour"));
    leave(&page).await;

    // No address of a page: no frame, nothing ran, and who listens is told.
    let none = page
        .ask(
            "const none = document.getElementById('none');
            let told = 0;
            none.addEventListener('error', () => { told += 1; });
            none.setAttribute('src', 'data:text/html,<script>parent.ran = true</script>');
            none.setAttribute('src', 'java\\nscript:parent.ran=true');
            return [told, none.shadowRoot.querySelector('iframe').hasAttribute('src'), window.ran ?? null];",
        )
        .await;
    assert_eq!(none, json!([2, false, null]));
    let _ = fs::remove_dir_all(place);
    // The browser warns of frames of the same host, before it knows of which host they are; their page has no icon.
    let said = page.said().await;
    let warned = |entry: &String| {
        ["allow-scripts and allow-same-origin", "/favicon.ico"]
            .iter()
            .any(|known| entry.contains(known))
    };
    assert!(said.iter().all(warned), "{said:#?}");
}

#[tokio::test]
async fn a_low_frame_shows_the_plots() {
    let page = at("embed=plots&play=no#crank-rocker").await;
    for size in [(600, 360), (800, 450)] {
        page.screen(size, 1.0).await;
        page.settle().await;
        let out = "const { top, bottom, right } = document.getElementById('charts').getBoundingClientRect();
            return top >= 0 && bottom <= document.querySelector('.transport').getBoundingClientRect().top && right <= innerWidth";
        assert_eq!(page.ask(out).await, json!(true), "{size:?}");
    }
    page.close().await;
}

#[tokio::test]
async fn the_wheel_scrolls_on_over_a_frame_until_it_is_pressed() {
    let place = std::env::temp_dir().join(format!("assur-course-{}", std::process::id()));
    fs::create_dir_all(&place).unwrap();
    let site = Host::start(&folder(), "/");
    let course = format!(
        "<!doctype html><title>Course</title><link rel=icon href=data:,>
        <iframe id=frame src='{}?embed=stage&play=no#crank-rocker' width=600 height=300></iframe><p style='height: 4000px'>",
        site.url()
    );
    fs::write(place.join("index.html"), course).unwrap();
    let theirs = Host::start(&place, "/");
    let page = Page::elsewhere(&theirs.url(), "en-US").await;
    let frame = "document.getElementById('frame')";
    let zoom = async || {
        enter(&page, frame).await;
        let zoom = page.attribute("mechanism", "data-zoom").await;
        leave(&page).await;
        zoom.map_or(1.0, |zoom| zoom.parse::<f64>().unwrap())
    };
    let scrolled = async || page.ask("return scrollY").await != json!(0);
    let zoomed = async || (zoom().await - 1.0).abs() > 1e-9;
    assert!(!zoomed().await);
    page.wheel("frame", (100.0, 60.0), 200.0).await;
    page.until("the page to scroll", async || scrolled().await)
        .await;
    assert!(!zoomed().await);

    page.ask("scrollTo(0, 0)").await;
    enter(&page, frame).await;
    page.click("zoom-fit").await;
    leave(&page).await;
    page.wheel("frame", (100.0, 60.0), -200.0).await;
    page.until("the drawing to grow", async || zoomed().await)
        .await;
    assert!(!scrolled().await);
    let _ = fs::remove_dir_all(place);
    page.close().await;
}
