//! Chromium: its options, and windows with a storage of their own through its developer tools.

use std::fs;
use std::net::TcpStream;
use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};

use serde_json::{Value, json};
use thirtyfour::prelude::*;
use thirtyfour::{ChromeCapabilities, ChromiumLikeCapabilities, LoggingPrefsLogLevel};
use tungstenite::{Message, WebSocket};

use super::pool::Profile;
use super::{PATIENCE, setting, switch};

/// The variable that names the driver, what it is started with, and what it says before its port.
pub(super) const DRIVER: (&str, &[&str], &str) =
    ("CHROMEDRIVER", &["--port=0"], "successfully on port ");

/// The size of a page.
const PAGE: (u32, u32) = (1280, 800);

/// A browser without a window.
pub(super) fn wanted(profile: Profile) -> ChromeCapabilities {
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

/// The address of the developer tools for commands that a window may not give.
pub(super) struct Chromium {
    address: String,
    path: String,
    /// The height that a window has beside its page; it differs between builds of Chromium.
    frame: AtomicU32,
}

impl Chromium {
    /// Reads the address that the browser has written into its profile.
    pub(super) fn of(driver: &WebDriver) -> Self {
        let chrome = driver.handle().capabilities().get("chrome").unwrap();
        let place = Path::new(chrome["userDataDir"].as_str().unwrap()).join("DevToolsActivePort");
        let written = fs::read_to_string(place).unwrap();
        let (port, path) = written.split_once('\n').unwrap();
        Self {
            address: format!("127.0.0.1:{port}"),
            path: path.trim().to_owned(),
            frame: AtomicU32::new(0),
        }
    }

    /// Opens a window with a storage of its own, and returns its name.
    pub(super) async fn window(
        &self,
        driver: &WebDriver,
        downloads: &Path,
    ) -> Result<String, String> {
        let mut tools = self.tools()?;
        let kept = json!({ "disposeOnDetach": false });
        let context = tools.command("Target.createBrowserContext", &kept)?;
        let context = context["browserContextId"].clone();
        let (width, height) = PAGE;
        let outer = height + self.frame.load(Ordering::Relaxed);
        let window = json!({ "url": "about:blank", "browserContextId": context, "width": width, "height": outer });
        let window = tools.command("Target.createTarget", &window)?;
        switch(driver, &window["targetId"]).await?;
        let inner = driver.execute("return innerHeight", Vec::new()).await;
        let inner: u32 = inner
            .and_then(|inner| inner.convert())
            .map_err(|error| error.to_string())?;
        if inner != height {
            self.frame.store(outer - inner, Ordering::Relaxed);
            let grown = driver.set_window_rect(0, 0, width, height + outer - inner);
            grown.await.map_err(|error| error.to_string())?;
        }
        // Through the driver: set through the developer tools it would end with that connection.
        let place =
            json!({ "behavior": "allow", "browserContextId": context, "downloadPath": downloads });
        let tools = driver.cdp();
        let set = tools.send_raw("Browser.setDownloadBehavior", place).await;
        set.map_err(|error| error.to_string())?;
        // Messages of the window before do not belong to this one.
        let said = driver.browser_log().await;
        said.map_err(|error| error.to_string())?;
        Ok(context.as_str().unwrap_or_default().to_owned())
    }

    fn tools(&self) -> Result<Tools, String> {
        let stream = TcpStream::connect(&self.address).map_err(|error| error.to_string())?;
        let patience = stream.set_read_timeout(Some(PATIENCE));
        patience.map_err(|error| error.to_string())?;
        let url = format!("ws://{}{}", self.address, self.path);
        let line = tungstenite::client(url, stream).map_err(|error| error.to_string())?;
        Ok(Tools(line.0))
    }

    /// Closes the windows of a storage and forgets it.
    pub(super) fn close(&self, context: &str) -> Result<(), String> {
        let mut tools = self.tools()?;
        let context = json!({ "browserContextId": context });
        tools.command("Target.disposeBrowserContext", &context)?;
        Ok(())
    }
}

/// A line to the browser itself.
struct Tools(WebSocket<TcpStream>);

impl Tools {
    /// The answer to a command.
    fn command(&mut self, method: &str, with: &Value) -> Result<Value, String> {
        let command = json!({ "id": 1, "method": method, "params": with });
        let sent = self.0.send(Message::text(command.to_string()));
        sent.map_err(|error| error.to_string())?;
        loop {
            let message = self.0.read().map_err(|error| error.to_string())?;
            let text = message.to_text().map_err(|error| error.to_string())?;
            let mut answer: Value = serde_json::from_str(text).unwrap_or_default();
            if answer["id"] != json!(1) {
                continue;
            }
            if answer["error"].is_object() {
                return Err(format!("{method}: {}", answer["error"]));
            }
            return Ok(answer["result"].take());
        }
    }
}
