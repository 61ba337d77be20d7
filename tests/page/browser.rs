//! A browser of our own with the page open, and a person's hands.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use thirtyfour::action_chain::ActionChain;
use thirtyfour::common::command::Command;
use thirtyfour::error::WebDriverErrorInner;
use thirtyfour::prelude::*;

use crate::host::home;
use crate::picture::Picture;
use line::Line;
use pool::{Profile, Window};
pub(crate) use setting::{in_firefox, setting};
pub(crate) use text::plain;
use text::spaced;

#[path = "browser/chromium.rs"]
mod chromium;
#[path = "browser/firefox.rs"]
pub(crate) mod firefox;
#[path = "browser/hand.rs"]
mod hand;
#[path = "browser/line.rs"]
mod line;
#[path = "browser/pool.rs"]
mod pool;
#[path = "browser/setting.rs"]
pub(crate) mod setting;
#[path = "browser/text.rs"]
mod text;

/// How long a person would wait for something to happen.
const PATIENCE: Duration = Duration::from_secs(20);

/// Time between two looks at what is waited for.
const LOOK: Duration = Duration::from_millis(20);

/// Time that the pointer takes from one place to the next: a frame.
const MOVE: Duration = Duration::from_millis(16);

/// The page, open and ready, in a window of its own.
pub(crate) struct Page {
    pub(crate) driver: WebDriver,
    window: Window,
}

impl Page {
    /// The served page in English, at rest.
    pub(crate) async fn open() -> Self {
        Self::open_at(home(), "en-US").await
    }

    /// The served page in English, of a reader who has not asked for less motion: it opens playing.
    pub(crate) async fn playing() -> Self {
        Self::playing_at(home(), "en-US").await
    }

    /// A page at an address, at rest, in a browser that speaks a language, of someone who has been there.
    pub(crate) async fn open_at(url: &str, lang: &'static str) -> Self {
        Self::returning(url, Profile { lang, calm: true }).await
    }

    /// The same of a reader who has not asked for less motion.
    pub(crate) async fn playing_at(url: &str, lang: &'static str) -> Self {
        Self::returning(url, Profile { lang, calm: false }).await
    }

    async fn returning(url: &str, profile: Profile) -> Self {
        let page = Self::window(profile).await;
        page.before("try { localStorage.setItem('assur.welcome', 'closed') } catch {}")
            .await;
        page.driver.goto(url).await.unwrap();
        page.ready().await;
        page
    }

    /// A page at an address for the first time, of a reader who has not asked for less motion.
    pub(crate) async fn visit(url: &str, lang: &'static str) -> Self {
        let page = Self::elsewhere(url, lang).await;
        page.ready().await;
        page
    }

    /// A page of others, which tells nobody when it is ready.
    pub(crate) async fn elsewhere(url: &str, lang: &'static str) -> Self {
        let page = Self::window(Profile { lang, calm: false }).await;
        page.driver.goto(url).await.unwrap();
        page
    }

    async fn window(profile: Profile) -> Self {
        let window = Window::open(profile).await;
        Self {
            driver: window.browser().driver.clone(),
            window,
        }
    }

    pub(crate) fn line(&self) -> &Line {
        &self.window.browser().line
    }

    /// Has a script run before those of any page that is opened from now on.
    pub(crate) async fn before(&self, script: &str) {
        self.line().before(script).await;
    }

    /// Waits until the page has been drawn.
    async fn ready(&self) {
        self.until("the page to be ready", async || {
            // Between two pages there is neither of them.
            let asked = "return document.documentElement?.dataset.ready === 'true'";
            let answer = self.driver.execute(asked, Vec::new()).await;
            answer.is_ok_and(|answer| *answer.json() == json!(true))
        })
        .await;
    }

    /// Goes to an address in the same window. Where only what follows `#` is
    /// another, the page stays.
    pub(crate) async fn goto(&self, url: &str) {
        self.driver.goto(url).await.unwrap();
        self.ready().await;
        self.settle().await;
    }

    /// Leaves the page and opens an address anew.
    pub(crate) async fn anew(&self, url: &str) {
        self.driver.goto("about:blank").await.unwrap();
        self.goto(url).await;
    }

    /// Goes back, to the address before.
    pub(crate) async fn back(&self) {
        self.driver.back().await.unwrap();
        self.settle().await;
    }

    pub(crate) async fn reload(&self) {
        if in_firefox() {
            // Its driver would pass over what is kept for days without a network.
            self.ask("document.documentElement.dataset.ready = 'left'; location.reload()")
                .await;
        } else {
            self.driver.refresh().await.unwrap();
        }
        self.ready().await;
        self.settle().await;
    }

    /// What stands in the address bar.
    pub(crate) async fn address(&self) -> String {
        self.driver.current_url().await.unwrap().to_string()
    }

    /// How many elements a selector finds.
    pub(crate) async fn count(&self, selector: &str) -> usize {
        self.driver.find_all(By::Css(selector)).await.unwrap().len()
    }

    /// What a script of the test returns, with plain spaces.
    pub(crate) async fn ask(&self, script: &str) -> Value {
        let answer = self.driver.execute(script, Vec::new()).await.unwrap();
        spaced(answer.json().clone())
    }

    /// Has the browser's own tools do something.
    pub(crate) async fn tool(&self, command: &str, with: Value) -> Value {
        let tools = self.driver.cdp();
        tools.send_raw(command, with).await.unwrap()
    }

    /// What a script of the test gives to its last argument, a function, in its time.
    pub(crate) async fn ask_later(&self, script: &str, arguments: Vec<Value>) -> Value {
        let answer = self.driver.execute_async(script, arguments).await.unwrap();
        answer.json().clone()
    }

    /// The same without arguments.
    pub(crate) async fn wait_for(&self, script: &str) -> Value {
        self.ask_later(script, Vec::new()).await
    }

    /// The same where it is numbers.
    pub(crate) async fn numbers(&self, script: &str) -> Vec<f64> {
        serde_json::from_value(self.wait_for(script).await).unwrap()
    }

    /// A folder of this page's own, where the browser puts what it saves.
    pub(crate) fn downloads(&self) -> &Path {
        &self.window.downloads
    }

    /// The bytes of a file that the page saves, and takes it away.
    pub(crate) async fn saved(&self, name: &str) -> Vec<u8> {
        let path = self.window.downloads.join(name);
        // Firefox keeps the place by an empty file until the other one, beside it, is whole.
        self.until(name, async || {
            fs::metadata(&path).is_ok_and(|file| file.len() > 0)
        })
        .await;
        let bytes = fs::read(&path).unwrap();
        fs::remove_file(path).unwrap();
        bytes
    }

    /// Shows a picture by itself, as the element `shown`, over the page.
    pub(crate) async fn show_picture(&self, svg: &str) {
        let script = "const picture = new Image();
            picture.id = 'shown';
            picture.style = 'position: fixed; inset: 0; z-index: 9';
            document.body.append(picture);
            picture.onload = () => arguments[1](true);
            picture.src = URL.createObjectURL(new Blob([arguments[0]], { type: 'image/svg+xml' }));";
        self.ask_later(script, vec![svg.into()]).await;
    }

    /// Ends the visit: nothing may have been said on the console.
    pub(crate) async fn close(self) {
        let said = self.said().await;
        assert!(said.is_empty(), "on the console: {said:#?}");
    }

    /// What has been said on the console since this was asked last.
    pub(crate) async fn said(&self) -> Vec<String> {
        let mut said = self.line().said();
        if !in_firefox() {
            // Also what the network and the policy say, which the line does not bring.
            let log = self.driver.browser_log().await.unwrap();
            said.extend(log.iter().map(|entry| format!("{entry:?}")));
        }
        said
    }

    /// Waits until something holds.
    pub(crate) async fn until(&self, what: &str, holds: impl AsyncFn() -> bool) {
        self.seen(what, async || holds().await.then_some(())).await;
    }

    /// An element, which is awaited: parts of the page are built when they are first shown. The folds of the settings
    /// around it are opened.
    pub(crate) async fn element(&self, id: &str) -> WebElement {
        let element = self.found(id).await;
        self.unfold(id, ".fold").await;
        element
    }

    /// An element as it is, perhaps in a closed fold.
    async fn found(&self, id: &str) -> WebElement {
        let found = async || self.driver.find(By::Id(id)).await.ok();
        self.seen(id, found).await
    }

    /// Presses the summaries of closed folds around an element, from the outermost.
    async fn unfold(&self, id: &str, folds: &str) {
        let script = format!(
            "const around = [];
            for (let at = document.getElementById('{id}')?.parentElement; at; at = at.parentElement)
                if (at.matches('details:is({folds}):not([open])')) around.unshift(at);
            for (const one of around) one.querySelector('summary').click();"
        );
        self.ask(&script).await;
    }

    /// Looks for something until it is there.
    async fn seen<T>(&self, what: &str, look: impl AsyncFn() -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(seen) = look().await {
                return seen;
            }
            assert!(start.elapsed() < PATIENCE, "waited in vain for {what}");
            tokio::time::sleep(LOOK).await;
        }
    }

    pub(crate) async fn click(&self, id: &str) {
        self.unfold(id, ".menu").await;
        let click = async |element: &WebElement| match element.click().await {
            // The driver scrolls no farther than to the edge of what scrolls, where half of the element is covered.
            Err(error) if matches!(*error, WebDriverErrorInner::ElementClickIntercepted(_)) => {
                element.scroll_into_view().await?;
                element.click().await
            }
            done => done,
        };
        self.read(id, click).await;
        self.settle().await;
    }

    /// Writes into a field as by hand and leaves it by Enter.
    pub(crate) async fn write(&self, id: &str, text: &str) {
        let field = self.element(id).await;
        field.click().await.unwrap();
        field.send_keys(Key::Control + "a").await.unwrap();
        field.send_keys(Key::Backspace + text).await.unwrap();
        field.send_keys(Key::Enter + "").await.unwrap();
        self.settle().await;
    }

    /// Presses a key in a control.
    pub(crate) async fn press(&self, id: &str, key: Key) {
        self.unfold(id, ".menu").await;
        self.element(id).await.send_keys(key + "").await.unwrap();
        self.settle().await;
    }

    /// Chooses an entry of a list.
    pub(crate) async fn choose(&self, id: &str, value: &str) {
        self.unfold(id, ".fold, .menu").await;
        let option = By::Css(format!("#{id} option[value='{value}']"));
        let option = self.driver.find(option).await.unwrap();
        option.click().await.unwrap();
        self.settle().await;
    }

    /// Two animation frames: what was done has been drawn.
    pub(crate) async fn settle(&self) {
        let frames = "const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(() => done(true)));";
        self.wait_for(frames).await;
    }

    /// The number behind a read-out.
    pub(crate) async fn value(&self, id: &str) -> f64 {
        // At once: between finding and reading it a table may be built anew.
        let script = format!("return document.getElementById('{id}')?.dataset.value ?? null;");
        let value = self.ask(&script).await;
        let value = value
            .as_str()
            .unwrap_or_else(|| panic!("{id} has no value"));
        value
            .parse()
            .unwrap_or_else(|_| panic!("{id} shows {value}"))
    }

    /// Reads or presses an element; once more if it has been replaced since it was found.
    async fn read<T>(&self, id: &str, of: impl AsyncFn(&WebElement) -> WebDriverResult<T>) -> T {
        loop {
            let element = self.element(id).await;
            match of(&element).await {
                Ok(read) => return read,
                Err(error) if matches!(*error, WebDriverErrorInner::StaleElementReference(_)) => {}
                Err(error) => panic!("{id}: {error}"),
            }
        }
    }

    /// An attribute of an element, with plain spaces.
    pub(crate) async fn attribute(&self, id: &str, name: &str) -> Option<String> {
        loop {
            match self.found(id).await.attr(name).await {
                Ok(found) => return found.map(|text| plain(&text)),
                Err(error) if matches!(*error, WebDriverErrorInner::StaleElementReference(_)) => {}
                Err(error) => panic!("{id}: {error}"),
            }
        }
    }

    pub(crate) async fn text(&self, id: &str) -> String {
        self.read(id, async |element| element.text().await).await
    }

    /// What a text field holds.
    pub(crate) async fn written(&self, id: &str) -> String {
        let value = self.read(id, async |element| element.prop("value").await);
        plain(&value.await.unwrap_or_default())
    }

    pub(crate) async fn lang(&self) -> Option<String> {
        let html = self.driver.find(By::Css("html")).await.unwrap();
        html.attr("lang").await.unwrap()
    }

    /// Addresses of everything that was loaded.
    pub(crate) async fn loaded(&self) -> Vec<String> {
        let script = "return performance.getEntriesByType('resource').map(entry => entry.name)";
        serde_json::from_value(self.ask(script).await).unwrap()
    }

    /// A picture of an element as it is on the screen.
    pub(crate) async fn picture(&self, id: &str) -> Picture {
        Picture::decode(&self.element(id).await.screenshot_as_png().await.unwrap())
    }

    /// Stops the motion, if any, at the angle.
    pub(crate) async fn stop_at(&self, degrees: &str) {
        if self.attribute("play", "data-playing").await.as_deref() == Some("true") {
            self.click("play").await;
        }
        self.write("angle", degrees).await;
    }
}
