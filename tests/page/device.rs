//! Screens, hands and eyes of other readers: what the browser can be told to be.

use crate::browser::Page;

impl Page {
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
