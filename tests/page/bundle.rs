//! The one-file page, opened from the disk: no server, no network.

use assur_tests::assert_near;

use crate::browser::{Page, setting};

#[tokio::test]
async fn opens_from_a_file_and_runs() {
    let page = Page::playing_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    let start = page.value("out-input").await;
    page.until("the crank to turn", async || {
        (page.value("out-input").await - start).rem_euclid(360.0) > 10.0
    })
    .await;
    page.click("preset-b").await;
    assert!(page.text("out-swing-rocker").await.contains("53.452°"));
    page.stop_at("0").await;
    page.click("preset-a").await;
    assert_near(
        page.value("out-rocker.angle′").await,
        -0.770_833_333_333_333_3,
        1e-12,
        "φ₃′ at 0°",
    );
    assert!(
        page.picture("mechanism")
            .await
            .cloud(crate::picture::COUPLER)
            .count
            > 500
    );
    assert!(
        page.picture("charts")
            .await
            .cloud(crate::picture::ROCKER)
            .count
            > 1000
    );
    page.choose("lang", "ru").await;
    assert!(page.text("out-swing-rocker").await.contains("87,905°"));
    page.click("tab-lesson").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    assert_eq!(page.text("lesson-title").await, "Машина и её части");
    // From the disk, too, the state is in the address and comes back with it.
    page.until("the address to follow", async || {
        page.address().await.contains("v.lang=ru")
    })
    .await;
    page.reload().await;
    assert_eq!(page.lang().await.as_deref(), Some("ru"));
    assert_eq!(page.value("out-input").await, 0.0);
    let outside: Vec<String> = page.loaded().await;
    assert!(
        outside.iter().all(|name| name.starts_with("data:")),
        "{outside:?}"
    );
    page.close().await;
}

/// The README says how large the file is.
#[test]
fn it_is_as_large_as_the_readme_says() {
    let readme = assur_tests::files::source("README.md");
    assert!(readme.contains("`dist/assur.html`, about three and a half megabytes."));
    let size = std::fs::metadata(setting("ASSUR_BUNDLE")).unwrap().len();
    assert!((3_000_000..4_000_000).contains(&size), "{size}");
}
