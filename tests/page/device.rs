//! Screens, hands and eyes of other readers: what the browser can be told to be.

use assur_tests::exhaustive;
use serde_json::{Value, json};

use crate::browser::{Page, firefox, in_firefox};

impl Page {
    /// What a person has asked of the system: `prefers-color-scheme`, `dark`.
    pub(crate) async fn prefer(&self, feature: &str, value: &str) {
        self.show_on("", &[(feature, value)]).await;
        self.settle().await;
    }

    /// The medium that the page is shown on, the screen where nothing is said, and what a person has asked of the system.
    pub(crate) async fn show_on(&self, medium: &str, asked: &[(&str, &str)]) {
        if !in_firefox() {
            let features = asked
                .iter()
                .map(|(name, value)| json!({ "name": name, "value": value }));
            let features: Vec<Value> = features.collect();
            let media = json!({ "media": medium, "features": features });
            self.tool("Emulation.setEmulatedMedia", media).await;
            return;
        }
        let mut script = format!(
            "const shown = gBrowser.selectedBrowser.browsingContext; shown.mediumOverride = '{medium}';"
        );
        for (feature, value) in asked {
            script += &match *feature {
                "prefers-color-scheme" => format!("shown.prefersColorSchemeOverride = '{value}';"),
                "prefers-reduced-motion" => {
                    let reduced = u8::from(*value == "reduce");
                    format!("Services.prefs.setIntPref('ui.prefersReducedMotion', {reduced});")
                }
                other => panic!("nobody has asked Firefox for {other} yet"),
            };
        }
        firefox::within(&self.driver, &script).await.unwrap();
    }

    /// A screen of a size in pixels of the reader, with so many device pixels to each.
    pub(crate) async fn screen(&self, size: (u32, u32), ratio: f64) {
        self.line().screen(size, ratio).await.unwrap();
        self.settle().await;
        self.settle().await;
    }

    /// A screen that is touched instead of a mouse.
    pub(crate) async fn touched(&self) {
        if in_firefox() {
            let coarse = "for (const which of ['primary', 'all']) Services.prefs.setIntPref(`ui.${which}PointerCapabilities`, 1);
                gBrowser.selectedBrowser.browsingContext.touchEventsOverride = 'enabled';";
            firefox::within(&self.driver, coarse).await.unwrap();
        } else {
            let touch = json!({ "enabled": true, "maxTouchPoints": 5 });
            self.tool("Emulation.setTouchEmulationEnabled", touch).await;
        }
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

/// The languages that a test looks at: all with `--all`, else one, which differs from test to test.
pub(crate) fn languages(turn: usize) -> impl Iterator<Item = &'static str> {
    let all = LANGUAGES.iter().enumerate();
    all.filter(move |(at, _)| exhaustive() || *at == turn)
        .map(|(_, lang)| *lang)
}
