//! Chromium, as its own tools are asked.

use std::path::Path;

use serde_json::json;
use thirtyfour::prelude::*;
use thirtyfour::{ChromeCapabilities, ChromiumLikeCapabilities, LoggingPrefsLogLevel};

use super::setting;

/// The variable that names the driver, what it is started with, and what it says before its port.
pub(super) const DRIVER: (&str, &[&str], &str) =
    ("CHROMEDRIVER", &["--port=0"], "successfully on port ");

/// A browser without a window that speaks a language and saves into a folder.
pub(super) fn wanted(lang: &str, downloads: &Path) -> ChromeCapabilities {
    let mut wanted = DesiredCapabilities::chrome();
    wanted.set_binary(&setting("CHROME")).unwrap();
    wanted
        .set_browser_log_level(LoggingPrefsLogLevel::All)
        .unwrap();
    for argument in [
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--hide-scrollbars",
        "--force-device-scale-factor=1",
        "--window-size=1280,940", // of which the page has 1280 by 800
        &format!("--lang={lang}"),
        &format!("--accept-lang={lang}"),
    ] {
        wanted.add_arg(argument).unwrap();
    }
    let prefs = json!({ "download.default_directory": downloads });
    wanted.add_experimental_option("prefs", prefs).unwrap();
    wanted
}
