//! Animations and several poses in one picture: files that are decoded again.

use roxmltree::{Document, Node};
use serde_json::json;

use crate::browser::Page;
use crate::export::open_dialog;
use crate::host::home;
use crate::picture::Picture;

/// A mechanism at rest at 30° with the dialog open, small and quick animations chosen.
async fn open(name: &str, moments: usize) -> Page {
    let url = format!("{}#{name}&v.playing=false&v.phi_deg=30", home());
    let page = Page::open_at(&url, "en-US").await;
    open_dialog(&page).await;
    page.choose("export-width", "320").await;
    page.choose("export-moments", &moments.to_string()).await;
    page.choose("export-seconds", "2").await;
    page
}

/// The pictures of a GIF as they are seen one after another, red, green and blue of each pixel.
struct Gif {
    width: usize,
    delays: Vec<u16>,
    pictures: Vec<Vec<[u8; 3]>>,
    repeat: gif::Repeat,
}

impl Gif {
    fn decode(bytes: &[u8]) -> Self {
        let mut decoder = gif::DecodeOptions::new();
        decoder.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = decoder.read_info(bytes).unwrap();
        let (width, height) = (decoder.width().into(), usize::from(decoder.height()));
        let mut seen = vec![[0; 3]; width * height];
        let (mut delays, mut pictures) = (Vec::new(), Vec::new());
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            let [left, top, wide] = [frame.left, frame.top, frame.width].map(usize::from);
            for (at, pixel) in frame.buffer.chunks_exact(4).enumerate() {
                if pixel[3] > 0 {
                    let place = (top + at / wide) * width + left + at % wide;
                    seen[place] = [pixel[0], pixel[1], pixel[2]];
                }
            }
            delays.push(frame.delay);
            pictures.push(seen.clone());
        }
        Self {
            width,
            delays,
            pictures,
            repeat: decoder.repeat(),
        }
    }

    /// How many pixels differ between two pictures.
    fn changed(&self, one: usize, other: usize) -> usize {
        let pairs = self.pictures[one].iter().zip(&self.pictures[other]);
        pairs.filter(|(a, b)| a != b).count()
    }
}

#[tokio::test]
async fn a_gif_is_one_turn_that_goes_on_without_a_jump() {
    let page = open("jansen", 24).await;
    page.click("export-animation-gif").await;
    let bytes = page.saved("assur-jansen-animation.gif").await;
    let gif = Gif::decode(&bytes);
    assert_eq!((gif.width, gif.pictures.len()), (320, 24));
    assert!(
        gif.delays.iter().all(|delay| [8, 9].contains(delay))
            && gif
                .delays
                .iter()
                .map(|delay| u32::from(*delay))
                .sum::<u32>()
                == 200,
        "{:?}",
        gif.delays
    );
    assert!(matches!(gif.repeat, gif::Repeat::Infinite));
    // The step from the last picture to the first one is a step like the others.
    let steps: Vec<usize> = (0..24).map(|k| gif.changed(k, (k + 1) % 24)).collect();
    let (last, others) = steps.split_last().unwrap();
    let (least, most) = (others.iter().min().unwrap(), others.iter().max().unwrap());
    assert!(*least > 500, "{steps:?}");
    assert!(*last >= least / 2 && *last <= most * 3 / 2, "{steps:?}");
    assert!(gif.changed(0, 12) > *least);
    // On paper as white as that of other pictures, in the very colours of the drawing.
    let white = gif.pictures[0]
        .iter()
        .filter(|pixel| pixel.iter().all(|part| *part > 250));
    assert!(white.count() > gif.pictures[0].len() / 3);
    let said = page.text("export-said").await;
    assert!(
        said.starts_with("assur-jansen-animation.gif saved"),
        "{said}"
    );
    page.close().await;
}

#[tokio::test]
async fn an_svg_moves_by_itself() {
    let page = open("jansen", 12).await;
    page.click("export-animation-svg").await;
    let bytes = page.saved("assur-jansen-animation.svg").await;
    let text = String::from_utf8(bytes).unwrap();
    let document = Document::parse(&text).unwrap();
    let root = document.root_element();
    assert_eq!(root.attribute("width"), Some("320"));
    let moments: Vec<Node<'_, '_>> = root
        .children()
        .filter(|node| node.has_tag_name((root.tag_name().namespace().unwrap(), "g")))
        .collect();
    assert_eq!(moments.len(), 12);
    let drawn: std::collections::BTreeSet<&str> =
        moments.iter().map(|moment| &text[moment.range()]).collect();
    assert_eq!(drawn.len(), 12);

    // In a browser just one of them is seen at any time, each in its turn, again and again.
    let script = "document.body.insertAdjacentHTML('beforeend', arguments[0]);
        const svg = document.body.lastElementChild;
        svg.pauseAnimations();
        const groups = [...svg.children].filter(({ localName }) => localName === 'g');
        const seen = [];
        for (let k = 0; k < 30; k++) {
          svg.setCurrentTime((k + 0.5) * 2 / 12);
          seen.push(groups.flatMap((group, at) => (getComputedStyle(group).display === 'none' ? [] : [at])));
        }
        arguments[1](seen);";
    let seen = page.ask_later(script, vec![json!(text)]).await;
    let wanted: Vec<[usize; 1]> = (0..30).map(|k| [k % 12]).collect();
    assert_eq!(seen, json!(wanted));
    page.close().await;
}

#[tokio::test]
async fn a_film_is_recorded_where_the_browser_records() {
    let page = open("crank-rocker", 24).await;
    page.click("export-animation-webm").await;
    let bytes = page.saved("assur-crank-rocker-animation.webm").await;
    assert_eq!(bytes[..4], [0x1a, 0x45, 0xdf, 0xa3]);
    // The first picture and the last, the links of which leave as much ink.
    let script = "const video = document.createElement('video');
        const canvas = document.createElement('canvas');
        const ink = () => {
            [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
            const context = canvas.getContext('2d', { willReadFrequently: true });
            context.drawImage(video, 0, 0);
            const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
            let dark = 0;
            for (let at = 0; at < data.length; at += 4) if (data[at] + data[at + 1] + data[at + 2] < 600) dark += 1;
            return dark;
        };
        video.muted = true;
        video.onloadeddata = () => {
            // Players seek only in a film whose header tells how long it lasts.
            if (!(Math.abs(video.duration - 2) < 1)) arguments[1](`it lasts ${video.duration} s`);
            const first = ink();
            video.onended = () => arguments[1]([video.videoWidth, video.videoHeight, first, ink()]);
            video.play();
        };
        video.onerror = () => arguments[1](video.error.message);
        video.src = URL.createObjectURL(new Blob([Uint8Array.from(arguments[0])], { type: 'video/webm' }));";
    let shown = page.ask_later(script, vec![json!(bytes)]).await;
    let [width, height, first, last]: [u32; 4] =
        serde_json::from_value(shown.clone()).unwrap_or_else(|_| panic!("{shown}"));
    assert!(width == 320 && height > 100, "{shown}");
    assert!(last > 500 && 10 * first > 9 * last, "{shown}");
    page.close().await;

    // A browser that does not record says so, and offers the others.
    let page = Page::open().await;
    page.ask("delete window.MediaRecorder").await;
    open_dialog(&page).await;
    assert_eq!(page.count("#export-animation-webm").await, 0);
    assert!(
        page.text("export-no-webm")
            .await
            .contains("does not record")
    );
    assert_eq!(page.count("#export-animation-gif").await, 1);
    page.close().await;
}

#[tokio::test]
async fn what_is_given_up_leaves_nothing() {
    let page = open("jansen", 72).await;
    page.choose("export-width", "800").await;
    page.ask(
        "window.longest = 0;
        let last = performance.now();
        const frame = (now) => { window.longest = Math.max(window.longest, now - last); last = now; requestAnimationFrame(frame); };
        requestAnimationFrame(frame);",
    )
    .await;
    for format in ["gif", "webm"] {
        page.click(&format!("export-animation-{format}")).await;
        page.until("some of it", async || {
            page.ask("return document.getElementById('export-progress').value > 0.05")
                .await
                == json!(true)
        })
        .await;
        let other = page.attribute("export-several-svg", "aria-disabled").await;
        assert_eq!(other.as_deref(), Some("true"));
        page.click("export-cancel").await;
        page.until("the end of it", async || {
            page.text("export-said").await.starts_with("Cancelled")
        })
        .await;
        assert_eq!(
            page.attribute("export-several-svg", "aria-disabled").await,
            None
        );
    }
    // The page went on meanwhile.
    let longest = page.ask("return window.longest").await.as_f64().unwrap();
    assert!(longest < 500.0, "{longest} ms without a frame");
    // To close the dialog is to give up as well.
    page.click("export-animation-gif").await;
    page.click("export-close").await;
    tokio::time::sleep(std::time::Duration::from_millis(500)).await;
    let left = std::fs::read_dir(page.downloads()).unwrap().count();
    assert_eq!(left, 0);
    page.close().await;
}

#[tokio::test]
async fn poses_lie_over_each_other_in_one_picture() {
    let page = open("jansen", 12).await;
    page.choose("export-poses", "6").await;
    page.click("export-several-svg").await;
    let text = String::from_utf8(page.saved("assur-jansen-several.svg").await).unwrap();
    let document = Document::parse(&text).unwrap();
    let strengths: Vec<f64> = document
        .descendants()
        .filter(|node| node.tag_name().name() == "g")
        .map(|node| node.attribute("opacity").unwrap().parse().unwrap())
        .collect();
    assert_eq!(strengths.len(), 5);
    assert!(strengths.is_sorted() && strengths[4] < 0.6, "{strengths:?}");
    // Only the pose where it is has names.
    let named = document.descendants().filter(|node| {
        node.tag_name().name() == "text"
            && node.ancestors().any(|above| above.tag_name().name() == "g")
    });
    assert_eq!(named.count(), 0);
    page.click("export-several-png").await;
    let picture = Picture::decode(&page.saved("assur-jansen-several.png").await);
    let size = document.root_element();
    let width: f64 = size.attribute("width").unwrap().parse().unwrap();
    assert!((picture.width as f64 - 3.0 * width).abs() <= 1.0);
    page.close().await;
}
