//! The state beyond the page: in the address, kept by the browser, in a file; and
//! what happens to addresses and files that are broken.

use std::fs;

use assur_tests::assert_near;

use crate::browser::Page;
use crate::gallery;
use crate::host::home;

/// Links that were given out, and what each must show: they open for ever.
const LINKS: &str = include_str!("../links.txt");

/// A mechanism of its own, at rest at 123.25°, in Russian.
async fn change(page: &Page) {
    page.stop_at("123.25").await;
    page.write("field-l2", "0.9").await;
    page.click("mesh-internal").await;
    page.click("assembly-2").await;
    page.click("traces").await;
    page.choose("speed", "0.5").await;
    page.choose("lang", "ru").await;
}

async fn check_changed(page: &Page, rocker: f64) {
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("false")
    );
    assert_eq!(page.value("out-input").await, 123.25);
    assert_eq!(page.value("out-rocker.angle").await, rocker);
    assert_eq!(page.value("out-ratio").await, 2.0);
    assert!(!page.element("traces").await.is_selected().await.unwrap());
    assert_eq!(page.written("speed").await, "0.5");
    assert_eq!(page.lang().await.as_deref(), Some("ru"));
    assert_eq!(page.text("notice-text").await, "");
}

/// The link that "Copy link" gives.
async fn link(page: &Page) -> String {
    page.click("menu").await;
    page.click("copy").await;
    page.until("the link to be copied", async || {
        page.attribute("notice", "hidden").await.is_none()
            || page.attribute("link", "open").await.is_some()
    })
    .await;
    if page.attribute("link", "open").await.is_some() {
        assert_eq!(page.written("link-text").await, page.address().await);
        page.click("link-close").await;
    } else {
        page.click("notice-close").await;
    }
    page.address().await
}

#[tokio::test]
async fn a_link_shows_the_same_page_elsewhere() {
    let page = Page::open().await;
    change(&page).await;
    let rocker = page.value("out-rocker.angle").await;
    page.until("the address to follow", async || {
        page.address().await.contains("v.lang=ru")
    })
    .await;
    let shown = page.address().await;
    let link = link(&page).await;
    assert_eq!(shown, link);
    page.close().await;

    let page = Page::open_at(&link, "en-US").await;
    check_changed(&page, rocker).await;
    // Another link in the same window, and back by undo.
    page.goto(&link.replace("d.l2=0.9", "d.l2=0.85")).await;
    assert_ne!(page.value("out-rocker.angle").await, rocker);
    page.click("undo").await;
    assert_eq!(page.value("out-rocker.angle").await, rocker);
    page.close().await;
}

#[tokio::test]
async fn what_was_kept_comes_back() {
    let page = Page::open().await;
    change(&page).await;
    let rocker = page.value("out-rocker.angle").await;
    page.anew(home()).await;
    check_changed(&page, rocker).await;

    // What cannot be shown is not kept: the last good mechanism is.
    page.write("field-l4", "9").await;
    page.anew(home()).await;
    check_changed(&page, rocker).await;

    page.anew(home()).await;
    page.ask("localStorage.setItem('assur.state', '{\"format\":1,\"lesson\":\"<b>\"}')")
        .await;
    page.anew(home()).await;
    let said = page.text("notice-text").await;
    assert!(said.contains("lesson"), "{said}");
    assert_eq!(page.count("#notice b").await, 0);
    let aside = page
        .ask("return localStorage.getItem('assur.state.unread')")
        .await;
    assert!(aside.as_str().unwrap().contains("<b>"));
    page.close().await;
}

/// A short link, typed or followed from elsewhere, says nothing of a language.
#[tokio::test]
async fn the_language_that_was_chosen_holds_for_short_links() {
    let page = Page::open().await;
    page.speak("ru").await;
    for name in ["klann", "jansen"] {
        let link = format!("{}#{name}", home());
        // In the same page, then in a new one.
        let before = page.text("mechanism-name").await;
        page.goto(&link).await;
        page.until("the mechanism of the link", async || {
            page.text("mechanism-name").await != before
        })
        .await;
        page.settle().await;
        assert_eq!(page.lang().await.as_deref(), Some("ru"), "{name}");
        page.anew(&link).await;
        assert_eq!(page.lang().await.as_deref(), Some("ru"), "{name}");
    }
    // A link that says one shows that, and chooses nothing.
    page.anew(&format!("{}#klann&v.lang=uk", home())).await;
    assert_eq!(page.lang().await.as_deref(), Some("uk"));
    page.anew(&format!("{}#klann", home())).await;
    assert_eq!(page.lang().await.as_deref(), Some("ru"));
    page.close().await;
}

/// A browser that loads the page anew has taken the address before the page can write the last change into it.
#[tokio::test]
async fn what_was_changed_a_moment_ago_is_there_anew() {
    let mixer = format!("{}#mixer-b", home());
    let page = Page::open_at(&mixer, "en-US").await;
    let usual = page.written("field-l2").await;
    page.write("field-l2", "0.93").await;
    page.reload().await;
    assert_eq!(page.written("field-l2").await, "0.93");
    page.until("the address", async || {
        page.address().await.contains("0.93")
    })
    .await;

    // An address that somebody goes to is what it says.
    page.anew(&mixer).await;
    page.write("field-l2", "0.94").await;
    page.anew(&mixer).await;
    assert_eq!(page.written("field-l2").await, usual);
    page.close().await;
}

#[tokio::test]
async fn a_file_is_saved_and_opened() {
    let page = Page::open().await;
    change(&page).await;
    let rocker = page.value("out-rocker.angle").await;
    page.click("menu").await;
    page.click("save").await;
    let saved = page.downloads().join("mixer.assur.json");
    page.until("the file", async || saved.exists()).await;
    let text = fs::read_to_string(&saved).unwrap();
    assert!(text.contains("\n    \"l2\": 0.9,\n"), "{text}");

    page.choose("lang", "en").await;
    page.click("preset-b").await;
    page.choose_file("file", &saved).await;
    page.until("the file to be open", async || {
        page.lang().await.as_deref() == Some("ru")
    })
    .await;
    check_changed(&page, rocker).await;
    page.click("undo").await;
    assert_eq!(
        page.attribute("preset-b", "aria-pressed").await.as_deref(),
        Some("true")
    );
    page.click("redo").await;

    for (broken, part) in [
        (text.replace("0.9,", "\"<img src=x>\","), "document.l2"),
        (String::new(), "Assur"),
    ] {
        let path = page.downloads().join("<i>broken.assur.json");
        fs::write(&path, broken).unwrap();
        page.choose_file("file", &path).await;
        page.until("a sentence", async || {
            page.text("notice-text").await.contains(part)
        })
        .await;
        assert!(page.text("notice-text").await.contains("<i>broken"));
        page.click("notice-close").await;
        check_changed(&page, rocker).await;
    }
    page.close().await;
}

#[tokio::test]
async fn old_links_open() {
    let page = Page::open().await;
    // All of them are opened by www/app/opening.test.js; here the first and the newest.
    let mut links = LINKS.lines().filter(|line| !line.starts_with("# "));
    let [first, newest] = [links.next(), links.next_back()];
    for line in first.into_iter().chain(newest) {
        let (hash, shown) = line.split_once('\t').unwrap();
        page.anew(&format!("{}{hash}", home())).await;
        assert_eq!(page.text("notice-text").await, "", "{hash}");
        for pair in shown.split_whitespace() {
            let (id, value) = pair.split_once('=').unwrap();
            let value: f64 = value.parse().unwrap();
            assert_near(page.value(id).await, value, 1e-9, hash);
        }
    }
    page.close().await;
}

/// A mechanism of the gallery in which nothing was changed has its name for an address, also in motion; Back returns to
/// the one before.
#[tokio::test]
async fn mechanisms_of_the_gallery_have_short_addresses() {
    let page = Page::open().await;
    page.stop_at("40").await;
    page.write("field-l2", "0.9").await;
    gallery::open(&page, "jansen").await;
    page.stop_at("33").await;
    let ends = async |end: &str| page.address().await.ends_with(end);
    page.until("where it stands", async || {
        ends("#jansen&v.phi_deg=33&v.playing=false").await
    })
    .await;
    let link = page.address().await;
    // Files are called by it, too.
    page.click("menu").await;
    page.click("save").await;
    assert!(!page.saved("jansen.assur.json").await.is_empty());
    page.click("play").await;
    page.until("the name alone", async || ends("#jansen").await)
        .await;
    gallery::open(&page, "whitworth").await;
    page.until("another name", async || ends("#whitworth").await)
        .await;
    page.back().await;
    page.until("the mechanism before", async || {
        gallery::shows(&page, "jansen").await
    })
    .await;
    page.back().await;
    page.until("the first, as it was changed", async || {
        page.count("#field-l2").await == 1 && page.written("field-l2").await == "0.9"
    })
    .await;
    page.close().await;

    let page = Page::open_at(&link, "en-US").await;
    assert!(gallery::shows(&page, "jansen").await);
    assert_eq!(page.value("out-input").await, 33.0);
    page.goto(&link.replace("jansen", "janssen")).await;
    assert_ne!(page.text("notice-text").await, "");
    assert!(gallery::shows(&page, "jansen").await);
    page.close().await;
}

/// A driver that has to turn back does so by itself: the reader's direction stays, here and in the next mechanism.
#[tokio::test]
async fn turning_back_is_not_the_readers_direction() {
    let page = Page::open().await;
    page.stop_at("40").await;
    gallery::open(&page, "chebyshev").await;
    page.choose("speed", "4").await;
    page.click("play").await;
    let last = std::cell::Cell::new(f64::NEG_INFINITY);
    page.until("the way back", async || {
        let now = page.value("out-input").await;
        let back = now < last.get();
        last.set(now);
        back
    })
    .await;
    let reversed = async || page.attribute("reverse", "aria-pressed").await;
    assert_eq!(reversed().await.as_deref(), Some("false"));
    gallery::open(&page, "jansen").await;
    assert_eq!(reversed().await.as_deref(), Some("false"));
    page.close().await;
}
