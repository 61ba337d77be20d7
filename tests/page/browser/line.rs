//! The bidirectional line to a browser, by which each test has a window with a storage of its own.

use std::sync::{Arc, Mutex};

use futures_util::StreamExt;
use serde_json::{Value, json};
use thirtyfour::bidi::BiDi;
use thirtyfour::bidi::events::LogEntryAdded;
use thirtyfour::bidi::modules::log::LogLevel;
use thirtyfour::prelude::*;

use super::pool::locked;

/// The line, and the window that is open.
pub(crate) struct Line {
    bidi: BiDi,
    window: Mutex<Value>,
    said: Arc<Mutex<Vec<String>>>,
}

impl Line {
    pub(super) async fn of(driver: &WebDriver) -> Self {
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
        let window = Mutex::default();
        Self { bidi, window, said }
    }

    /// Opens an empty window of 1280 by 800 pixels with a storage of its own, and returns the name of that.
    pub(super) async fn window(&self, driver: &WebDriver) -> WebDriverResult<String> {
        let context = self.ask("browser.createUserContext", json!({})).await?;
        let context = context["userContext"].clone();
        let tab = json!({ "type": "tab", "userContext": context });
        let window = self.ask("browsingContext.create", tab).await?["context"].clone();
        let name = window.as_str().unwrap_or_default().to_owned();
        driver.switch_to_window(name.into()).await?;
        *locked(&self.window) = window;
        self.screen((1280, 800), 1.0).await?;
        locked(&self.said).clear();
        Ok(context.as_str().unwrap_or_default().to_owned())
    }

    /// Closes the windows of a storage and forgets it.
    pub(super) async fn close(&self, context: &str) -> WebDriverResult<()> {
        let context = json!({ "userContext": context });
        self.ask("browser.removeUserContext", context).await?;
        Ok(())
    }

    /// Messages on the console since this was asked last.
    pub(super) fn said(&self) -> Vec<String> {
        std::mem::take(&mut *locked(&self.said))
    }

    /// Has a script run before those of any page of the window.
    pub(super) async fn before(&self, script: &str) {
        let window = locked(&self.window).clone();
        let script = format!("() => {{ {script} }}");
        let script = json!({ "functionDeclaration": script, "contexts": [window] });
        self.ask("script.addPreloadScript", script).await.unwrap();
    }

    /// Gives the window a screen of a size, with so many device pixels to each pixel.
    pub(crate) async fn screen(
        &self,
        (width, height): (u32, u32),
        ratio: f64,
    ) -> WebDriverResult<()> {
        let window = locked(&self.window).clone();
        let size = json!({ "width": width, "height": height });
        let screen = json!({ "context": window, "viewport": size, "devicePixelRatio": ratio });
        self.ask("browsingContext.setViewport", screen).await?;
        Ok(())
    }

    async fn ask(&self, method: &str, with: Value) -> WebDriverResult<Value> {
        Ok(self.bidi.send_raw(method, with).await?)
    }
}
