//! Firefox: what is asked of it by the bidirectional protocol, and by scripts that have its own rights, where there is no
//! other way.

use std::path::Path;
use std::sync::{Arc, Mutex};

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

use super::pool::{Profile, locked};
use super::{setting, switch};

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

/// A browser without a window.
pub(super) fn wanted(profile: Profile) -> FirefoxCapabilities {
    let mut wanted = DesiredCapabilities::firefox();
    wanted.set_firefox_binary(&setting("FIREFOX")).unwrap();
    wanted.set_headless().unwrap();
    wanted.enable_bidi().unwrap();
    let mut prefs = FirefoxPreferences::new();
    for (name, value) in [
        ("intl.accept_languages", json!(profile.lang)),
        ("browser.download.folderList", json!(2)),
        ("browser.download.useDownloadDir", json!(true)),
        ("browser.download.alwaysOpenPanel", json!(false)),
        ("privacy.userContext.enabled", json!(true)),
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
    calm: bool,
    window: Mutex<Value>,
    said: Arc<Mutex<Vec<String>>>,
}

impl Firefox {
    pub(super) async fn of(driver: &WebDriver, calm: bool) -> Self {
        let bidi = driver.bidi().await.unwrap();
        let mut entries = bidi.subscribe::<LogEntryAdded>().await.unwrap();
        let said: Arc<Mutex<Vec<String>>> = Arc::default();
        let heard = Arc::clone(&said);
        tokio::spawn(async move {
            while let Some(entry) = entries.next().await {
                if matches!(entry.level, LogLevel::Warn | LogLevel::Error) {
                    locked(&heard).push(format!("{entry:?}"));
                }
            }
        });
        Self {
            bidi,
            calm,
            window: Mutex::default(),
            said,
        }
    }

    /// Opens a window with a storage of its own, and returns its name. What the whole browser has is as at its
    /// start.
    pub(super) async fn window(
        &self,
        driver: &WebDriver,
        downloads: &Path,
    ) -> Result<String, String> {
        let context = self.ask("browser.createUserContext", json!({})).await?;
        let context = context["userContext"].clone();
        let tab = json!({ "type": "tab", "userContext": context });
        let window = self.ask("browsingContext.create", tab).await?["context"].clone();
        locked(&self.window).clone_from(&window);
        let calm = u8::from(self.calm);
        let script = format!(
            "Services.prefs.setStringPref('browser.download.dir', {});
            Services.prefs.setIntPref('ui.prefersReducedMotion', {calm});
            for (const which of ['primary', 'all']) Services.prefs.clearUserPref(`ui.${{which}}PointerCapabilities`);",
            json!(downloads)
        );
        switch(driver, &window).await?;
        within(driver, &script).await;
        self.screen((1280, 800), 1.0).await;
        locked(&self.said).clear();
        Ok(context.as_str().unwrap_or_default().to_owned())
    }

    /// Closes the windows of a storage and forgets it.
    pub(super) async fn close(&self, context: &str) -> Result<(), String> {
        let context = json!({ "userContext": context });
        self.ask("browser.removeUserContext", context).await?;
        Ok(())
    }

    async fn ask(&self, method: &str, with: Value) -> Result<Value, String> {
        let answer = self.bidi.send_raw(method, with).await;
        answer.map_err(|error| error.to_string())
    }

    /// What has been said on the console since this was asked last.
    pub(super) fn said(&self) -> Vec<String> {
        std::mem::take(&mut *locked(&self.said))
    }

    /// Has a script run before those of any page of the window.
    pub(super) async fn before(&self, script: &str) {
        let window = locked(&self.window).clone();
        let script =
            json!({ "functionDeclaration": format!("() => {{ {script} }}"), "contexts": [window] });
        self.ask("script.addPreloadScript", script).await.unwrap();
    }

    pub(crate) async fn screen(&self, (width, height): (u32, u32), ratio: f64) {
        let window = locked(&self.window).clone();
        let size = json!({ "width": width, "height": height });
        let screen = json!({ "context": window, "viewport": size, "devicePixelRatio": ratio });
        self.ask("browsingContext.setViewport", screen)
            .await
            .unwrap();
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
