//! Chromium: its options.

use std::path::Path;

use serde_json::json;
use thirtyfour::prelude::*;
use thirtyfour::{ChromeCapabilities, ChromiumLikeCapabilities, LoggingPrefsLogLevel};

use super::pool::Profile;
use super::setting;

/// The variable that names the driver, what it is started with, and what it says before its port.
pub(super) const DRIVER: (&str, &[&str], &str) =
    ("CHROMEDRIVER", &["--port=0"], "successfully on port ");

/// A browser without a window.
pub(super) fn wanted(profile: Profile) -> ChromeCapabilities {
    let mut wanted = DesiredCapabilities::chrome();
    wanted.set_binary(&setting("CHROME")).unwrap();
    wanted
        .set_browser_log_level(LoggingPrefsLogLevel::All)
        .unwrap();
    wanted.enable_bidi().unwrap();
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
        &format!("--lang={}", profile.lang),
        &format!("--accept-lang={}", profile.lang),
    ] {
        wanted.add_arg(argument).unwrap();
    }
    if profile.calm {
        wanted.add_arg("--force-prefers-reduced-motion").unwrap();
    }
    wanted
}

/// Prepares a new window: its downloads go to a folder, and messages of the window before are read away.
pub(super) async fn prepare(
    driver: &WebDriver,
    context: &str,
    downloads: &Path,
) -> WebDriverResult<()> {
    let place =
        json!({ "behavior": "allow", "browserContextId": context, "downloadPath": downloads });
    let tools = driver.cdp();
    tools.send_raw("Browser.setDownloadBehavior", place).await?;
    driver.browser_log().await?;
    Ok(())
}
