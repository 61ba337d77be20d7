//! Firefox: its options, and scripts with its own rights, where no protocol has words.

use std::path::Path;

use http::Method;
use serde_json::json;
use thirtyfour::common::capabilities::firefox::FirefoxPreferences;
use thirtyfour::common::command::FormatRequestData;
use thirtyfour::prelude::*;
use thirtyfour::{FirefoxCapabilities, RequestData, SessionId};

use super::pool::Profile;
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

/// Prepares a new window: its downloads go to a folder, and the settings of the whole browser are as at its start.
pub(super) async fn prepare(
    driver: &WebDriver,
    calm: bool,
    downloads: &Path,
) -> WebDriverResult<()> {
    let calm = u8::from(calm);
    let script = format!(
        "Services.prefs.setStringPref('browser.download.dir', {});
        Services.prefs.setIntPref('ui.prefersReducedMotion', {calm});
        for (const which of ['primary', 'all']) Services.prefs.clearUserPref(`ui.${{which}}PointerCapabilities`);",
        json!(downloads)
    );
    within(driver, &script).await
}

/// The command by which scripts are run with other rights, which the client does not know.
#[derive(Debug)]
struct Context(&'static str);

impl FormatRequestData for Context {
    fn format_request(&self, session: &SessionId) -> RequestData {
        let uri = format!("session/{session}/moz/context");
        RequestData::new(Method::POST, uri).add_body(json!({ "context": self.0 }))
    }
}

/// Runs a script with the browser's own rights, for what no protocol can ask for.
pub(crate) async fn within(driver: &WebDriver, script: &str) -> WebDriverResult<()> {
    driver.cmd(Context("chrome")).await?;
    driver.execute(script, Vec::new()).await?;
    driver.cmd(Context("content")).await?;
    Ok(())
}
