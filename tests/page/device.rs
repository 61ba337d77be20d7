//! Screens, hands and eyes of other readers: what the browser can be told to be.

use serde_json::json;

use crate::browser::Page;

impl Page {
    /// A screen of a size in pixels of the reader, with so many device pixels to each.
    pub(crate) async fn screen(&self, (width, height): (u32, u32), ratio: f64) {
        let screen = json!({ "width": width, "height": height, "deviceScaleFactor": ratio,
            "mobile": false });
        self.tool("Emulation.setDeviceMetricsOverride", screen)
            .await;
        self.settle().await;
        self.settle().await;
    }

    /// A screen that is touched instead of a mouse.
    pub(crate) async fn touched(&self) {
        let touch = json!({ "enabled": true, "maxTouchPoints": 5 });
        self.tool("Emulation.setTouchEmulationEnabled", touch).await;
        self.settle().await;
    }

    /// The page in a language.
    pub(crate) async fn speak(&self, lang: &str) {
        self.choose("lang", lang).await;
        self.until("its words", async || {
            self.lang().await.as_deref() == Some(lang)
        })
        .await;
        self.settle().await;
    }
}

/// The languages of the page.
pub(crate) const LANGUAGES: [&str; 4] = ["en", "ru", "uk", "kk"];
