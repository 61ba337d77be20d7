//! The folder for a host, served as one does: under its policy, in a folder of the host's, without the
//! network after the first visit, and a version after another.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery;
use crate::host::{Host, folder};
use crate::picture_behind;

const BELOW: &str = "/courses/machines/";

/// Everything that the policy forbade in any page of this visit from now on.
const LISTEN: &str = "addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sourceFile, lineNumber }) => {
    const said = JSON.parse(sessionStorage.getItem('forbidden') ?? '[]');
    sessionStorage.setItem('forbidden', JSON.stringify([...said, [violatedDirective, blockedURI, sourceFile, lineNumber]]));
});";

async fn forbidden(page: &Page) -> serde_json::Value {
    page.ask("return JSON.parse(sessionStorage.getItem('forbidden') ?? '[]')")
        .await
}

/// Waits until the page is kept.
async fn kept(page: &Page) {
    page.wait_for("navigator.serviceWorker.ready.then(({ active }) => {
        const done = arguments[0];
        if (active.state === 'activated') done(true);
        else active.addEventListener('statechange', () => active.state === 'activated' && done(true));
    })")
    .await;
}

async fn moves(page: &Page) {
    let start = page.value("out-input").await;
    page.until("the crank to turn", async || {
        (page.value("out-input").await - start).rem_euclid(360.0) > 10.0
    })
    .await;
}

async fn there(page: &Page, selector: &str) {
    page.until(selector, async || page.count(selector).await > 0)
        .await;
}

#[tokio::test]
async fn everything_works_under_the_policy_and_then_without_the_network() {
    let host = Host::start(&folder(), BELOW);
    let page = Page::playing_at(&host.url(), "en-US").await;
    page.before(LISTEN).await;
    page.reload().await;
    moves(&page).await;
    kept(&page).await;

    gallery::open(&page, "jansen").await;
    page.stop_at("75").await;
    page.click("all_assemblies").await;
    there(&page, "#assembly-pictures button").await;
    there(&page, "#assembly-map:not([hidden]):not(.faded)").await;
    open_dialog(&page).await;
    let svg = save_text(&page, "export-drawing-svg", "assur-jansen-drawing.svg").await;
    assert!(roxmltree::Document::parse(&svg).is_ok());
    page.click("export-close").await;
    page.click("help-open").await;
    there(&page, "dialog[open]").await;
    page.keys(thirtyfour::Key::Escape + "").await;
    // A picture behind the drawing is data that the page has already.
    page.click("draw").await;
    there(&page, "#draw-tools:not([hidden])").await;
    page.click("draw-more").await;
    page.click("draw-picture").await;
    let scan = picture_behind::file("hosted.svg", picture_behind::SCAN);
    page.choose_file("draw-picture-file", &scan).await;
    picture_behind::taken(&page).await;
    page.reload().await;
    there(&page, "#draw-tools:not([hidden])").await;
    page.click("draw-more").await;
    page.click("draw-picture").await;
    picture_behind::taken(&page).await;
    // Of every kind there are links.
    let links = include_str!("../links.txt").lines();
    for link in links.filter_map(|line| line.split_once('\t').filter(|_| line.starts_with('#'))) {
        page.goto(&format!("{}{}", host.url(), link.0)).await;
        page.until("nothing on its way", async || {
            page.count("#app[aria-busy]").await == 0
        })
        .await;
    }
    page.anew(&format!("{}#mixer-a", host.url())).await;
    page.click("tab-lesson").await;
    there(&page, "#lesson-title").await;
    // What is inline is known by its hash; anything else does not run.
    page.ask("const script = document.createElement('script'); script.textContent = 'window.ran = true'; document.body.append(script)")
        .await;
    assert_eq!(page.ask("return window.ran ?? false").await, json!(false));
    // By the header, and by the page itself.
    let said = forbidden(&page).await;
    assert_eq!(said.as_array().unwrap().len(), 2, "{said:#}");
    for one in said.as_array().unwrap() {
        assert_eq!(
            (&one[0], &one[1]),
            (&json!("script-src-elem"), &json!("inline"))
        );
    }
    // The browser says so in its own time.
    page.until("a word of the policy", async || {
        page.said().await.iter().any(|entry| is_of_policy(entry))
    })
    .await;

    host.down(true);
    page.reload().await;
    if page.attribute("play", "data-playing").await.as_deref() != Some("true") {
        page.click("play").await;
    }
    moves(&page).await;
    // What had not been asked for while there was a network.
    page.choose("lang", "kk").await;
    page.until("Kazakh", async || {
        page.lang().await.as_deref() == Some("kk")
    })
    .await;
    page.goto(&format!("{}index.html?of=nothing#crank-rocker", host.url()))
        .await;
    assert!(page.value("out-input").await.is_finite());
    page.driver
        .goto(format!("{}docs/mixer.en.html", host.url()))
        .await
        .unwrap();
    there(&page, "h1").await;
    assert_eq!(forbidden(&page).await, said);
    // A note has no icon, which the browser looks for at the root. Firefox names no address where it gave up asking
    // because the page was left.
    let said = page.said().await;
    assert!(
        said.iter().all(|entry| entry.contains("/favicon.ico")
            || entry.contains("Failed to load ‘’")
            || is_of_policy(entry)),
        "{said:#?}"
    );
}

/// Where nothing is packed, and where everything is, it is the same.
#[tokio::test]
async fn packed_files_are_the_files() {
    let names = files(&folder(), "");
    let packed: Vec<_> = names.iter().filter(|name| name.ends_with(".br")).collect();
    for needed in ["index.html", "service-worker.js"] {
        for ending in ["br", "gz"] {
            assert!(
                names.contains(&format!("{needed}.{ending}")),
                "{needed}.{ending}"
            );
        }
    }
    let host = Host::start(&folder(), "/");
    let page = Page::open_at(&host.url(), "en-US").await;
    for name in packed {
        let name = name.strip_suffix(".br").unwrap();
        let script = format!(
            "const done = arguments[0];
            fetch('{name}').then(async (answer) => done([answer.headers.get('Content-Encoding'), (await answer.arrayBuffer()).byteLength]))"
        );
        let length = fs::metadata(folder().join(name)).unwrap().len();
        let [coding, bytes]: [serde_json::Value; 2] =
            serde_json::from_value(page.wait_for(&script).await).unwrap();
        assert_eq!((coding, bytes), (json!("br"), json!(length)), "{name}");
    }
    page.close().await;
}

/// Whether a message on the console is of the content security policy.
fn is_of_policy(entry: &str) -> bool {
    entry.replace('-', " ").contains("Content Security Policy")
}

/// The files of a folder, by their paths in it.
fn files(folder: &Path, prefix: &str) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{prefix}{}", path.file_name().unwrap().to_str().unwrap());
        if path.is_dir() {
            found.extend(files(&path, &format!("{name}/")));
        } else {
            found.push(name);
        }
    }
    found
}

/// Another version of the folder: its page says so, and it has one file more.
struct Version(PathBuf);

impl Version {
    fn make(name: &str) -> Self {
        let to = std::env::temp_dir().join(format!("assur-host-{}-{name}", std::process::id()));
        for file in files(&folder(), "") {
            let place = to.join(&file);
            fs::create_dir_all(place.parent().unwrap()).unwrap();
            fs::copy(folder().join(&file), place).unwrap();
        }
        let version = Self(to);
        let index = version.read("index.html");
        let (_, build) = index.split_once("name=\"build\" content=\"").unwrap();
        let build = build.split('"').next().unwrap();
        version.write(
            "index.html",
            &index
                .replace(build, name)
                .replace("<html ", &format!("<html data-version=\"{name}\" ")),
        );
        let worker = version.read("service-worker.js");
        let more = format!("files/{name}.js");
        version.write(
            "service-worker.js",
            &worker.replace(&format!("{build} ./"), &format!("{name} ./ {more}")),
        );
        version.write(&more, "1");
        version
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).unwrap();
        for ending in ["br", "gz"] {
            let _ = fs::remove_file(self.0.join(format!("{name}.{ending}")));
        }
    }
}

impl Drop for Version {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

async fn shown(page: &Page) -> serde_json::Value {
    page.ask("return document.documentElement.dataset.version ?? 'first'")
        .await
}

/// Has the browser look for a version until it finds one, and says how that ended: `activated`, or `redundant` where it
/// is not whole.
async fn looked_for(page: &Page) -> serde_json::Value {
    page.wait_for(
        "const done = arguments[0];
        navigator.serviceWorker.ready.then(async (registration) => {
          let found = false;
          registration.addEventListener('updatefound', () => {
            found = true;
            const { installing } = registration;
            installing.addEventListener('statechange', () => ['activated', 'redundant'].includes(installing.state) && done(installing.state));
          });
          // A look that is under way already may be of the version before.
          while (!found) {
            await registration.update().catch(() => {});
            await new Promise((later) => setTimeout(later, 100));
          }
        });",
    )
    .await
}

/// Has the browser look for a version, and says whether the one that it has is still the only one.
async fn nothing_new(page: &Page) -> serde_json::Value {
    page.wait_for(
        "const done = arguments[0];
        navigator.serviceWorker.ready.then(async (registration) => {
          const { active } = registration;
          await registration.update();
          done(!registration.installing && !registration.waiting && registration.active === active);
        });",
    )
    .await
}

/// The page anew, once the browser has looked for a version by itself as it does for every page: what is looked for
/// next is another matter.
async fn anew(page: &Page) {
    page.reload().await;
    page.wait_for(
        "const done = arguments[0];
        navigator.serviceWorker.ready.then(async (registration) => {
          await registration.update().catch(() => {});
          const wait = () => (registration.installing ? setTimeout(wait, 50) : done(true));
          wait();
        });",
    )
    .await;
}

#[tokio::test]
async fn a_version_is_taken_whole_or_not_at_all() {
    let host = Host::start(&folder(), BELOW);
    let page = Page::playing_at(&host.url(), "en-US").await;
    kept(&page).await;
    assert_eq!(nothing_new(&page).await, json!(true));

    // A file of it is not there yet.
    let (second, third) = (Version::make("build-2"), Version::make("build-3"));
    fs::remove_file(second.0.join("files/build-2.js")).unwrap();
    host.serve(&second.0);
    assert_eq!(looked_for(&page).await, json!("redundant"));
    anew(&page).await;
    assert_eq!(shown(&page).await, json!("first"));
    // The page is still the one before.
    let index = second.read("index.html");
    second.write(
        "index.html",
        &fs::read_to_string(folder().join("index.html")).unwrap(),
    );
    second.write("files/build-2.js", "1");
    assert_eq!(looked_for(&page).await, json!("redundant"));
    anew(&page).await;
    assert_eq!(shown(&page).await, json!("first"));

    second.write("index.html", &index);
    assert_eq!(looked_for(&page).await, json!("activated"));
    // What is open goes on as what it is, also where the host has its files no longer.
    host.down(true);
    page.click("gallery").await;
    there(&page, "#gallery-jansen").await;
    page.reload().await;
    assert_eq!(shown(&page).await, json!("build-2"));
    moves(&page).await;

    host.down(false);
    host.serve(&third.0);
    assert_eq!(looked_for(&page).await, json!("activated"));
    let versions = page
        .wait_for("const done = arguments[0]; caches.keys().then((names) => done(names.map((name) => name.split(' ').at(-1))))")
        .await;
    assert_eq!(versions, json!(["build-2", "build-3"]));
    // Why a version was refused the browser says in its own time; Firefox may say that a request was not answered.
    let mut said = page.said().await;
    said.retain(|line| {
        !["404", "not of build-2", "ServiceWorker intercepted"]
            .iter()
            .any(|why| line.contains(why))
    });
    assert!(said.is_empty(), "on the console: {said:#?}");
}
