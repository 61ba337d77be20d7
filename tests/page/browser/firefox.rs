//! Firefox: what is asked of it by the bidirectional protocol, and by scripts that have its own rights, where there is no
//! other way.

use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use futures_util::StreamExt;
use http::Method;
use serde_json::{Value, json};
use thirtyfour::bidi::BiDi;
use thirtyfour::bidi::events::LogEntryAdded;
use thirtyfour::bidi::modules::log::LogLevel;
use thirtyfour::common::capabilities::firefox::FirefoxPreferences;
use thirtyfour::common::command::FormatRequestData;
use thirtyfour::prelude::*;
use thirtyfour::{FirefoxCapabilities, RequestData, SessionId};

use super::setting;

/// The variable that names the driver, what it is started with, and what it says before its port.
pub(super) const DRIVER: (&str, &[&str], &str) = (
    "GECKODRIVER",
    &["--port=0", "--websocket-port=0", "--allow-system-access"],
    "Listening on 127.0.0.1:",
);

/// Larger than any screen that is asked for: what is outside of it cannot be pressed.
pub(super) const ROOM: [(&str, &str); 2] = [
    ("MOZ_HEADLESS_WIDTH", "2100"),
    ("MOZ_HEADLESS_HEIGHT", "4400"),
];

/// A browser without a window that speaks a language and saves into a folder.
pub(super) fn wanted(lang: &str, downloads: &Path) -> FirefoxCapabilities {
    let mut wanted = DesiredCapabilities::firefox();
    wanted.set_firefox_binary(&setting("FIREFOX")).unwrap();
    wanted.set_headless().unwrap();
    wanted.enable_bidi().unwrap();
    let mut prefs = FirefoxPreferences::new();
    for (name, value) in [
        ("intl.accept_languages", json!(lang)),
        ("browser.download.folderList", json!(2)),
        ("browser.download.dir", json!(downloads)),
        ("browser.download.useDownloadDir", json!(true)),
        ("browser.download.alwaysOpenPanel", json!(false)),
        ("ui.prefersReducedMotion", json!(0)),
        ("ui.systemUsesDarkTheme", json!(0)),
        // Scroll bars take no room, as those of Chromium without a window.
        ("widget.gtk.overlay-scrollbars.enabled", json!(true)),
    ] {
        prefs.set(name, value).unwrap();
    }
    wanted.set_preferences(prefs).unwrap();
    wanted
}

/// A command that the client does not know.
#[derive(Debug)]
struct Plain {
    endpoint: &'static str,
    body: Value,
}

impl FormatRequestData for Plain {
    fn format_request(&self, session: &SessionId) -> RequestData {
        let uri = format!("session/{session}/{}", self.endpoint);
        RequestData::new(Method::POST, uri).add_body(self.body.clone())
    }
}

/// The second line to the browser.
pub(crate) struct Firefox {
    bidi: BiDi,
    window: Value,
    said: Arc<Mutex<Vec<String>>>,
}

impl Firefox {
    pub(super) async fn of(driver: &WebDriver) -> Self {
        let bidi = driver.bidi().await.unwrap();
        let window = bidi.browsing_context().top_level().await.unwrap();
        let mut entries = bidi.subscribe::<LogEntryAdded>().await.unwrap();
        let said: Arc<Mutex<Vec<String>>> = Arc::default();
        let heard = Arc::clone(&said);
        tokio::spawn(async move {
            while let Some(entry) = entries.next().await {
                if matches!(entry.level, LogLevel::Warn | LogLevel::Error) {
                    let mut said = heard.lock().unwrap_or_else(PoisonError::into_inner);
                    said.push(format!("{entry:?}"));
                }
            }
        });
        let firefox = Self {
            bidi,
            window: json!(window),
            said,
        };
        firefox.screen((1280, 800), 1.0).await;
        firefox
    }

    /// What has been said on the console since this was asked last.
    pub(super) fn said(&self) -> Vec<String> {
        let mut said = self.said.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *said)
    }

    async fn send(&self, method: &str, with: Value) {
        self.bidi.send_raw(method, with).await.unwrap();
    }

    /// Has a script run before those of any page.
    pub(super) async fn before(&self, script: &str) {
        let script = json!({ "functionDeclaration": format!("() => {{ {script} }}") });
        self.send("script.addPreloadScript", script).await;
    }

    pub(crate) async fn screen(&self, (width, height): (u32, u32), ratio: f64) {
        let size = json!({ "width": width, "height": height });
        let screen = json!({ "context": self.window, "viewport": size, "devicePixelRatio": ratio });
        self.send("browsingContext.setViewport", screen).await;
    }
}

/// Puts hands on the page: sequences of actions, one for each hand.
pub(super) async fn act(driver: &WebDriver, hands: Value) {
    let body = json!({ "actions": hands });
    let endpoint = "actions";
    driver.cmd(Plain { endpoint, body }).await.unwrap();
}

/// Runs a script with the browser's own rights, for what no protocol can ask for.
pub(crate) async fn within(driver: &WebDriver, script: &str) {
    for (context, script) in [("chrome", Some(script)), ("content", None)] {
        let endpoint = "moz/context";
        let body = json!({ "context": context });
        driver.cmd(Plain { endpoint, body }).await.unwrap();
        if let Some(script) = script {
            driver.execute(script, Vec::new()).await.unwrap();
        }
    }
}
