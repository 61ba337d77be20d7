//! Mouse, keys and focus.

use super::*;

impl Page {
    /// Hands on the page, where the client has no words for them: a sequence of actions for each.
    pub(crate) async fn act(&self, hands: Value) {
        let hands = Command::PerformActions(hands.into());
        self.driver.cmd(hands).await.unwrap();
        self.settle().await;
    }

    /// The element with the focus.
    pub(crate) async fn focused(&self) -> Option<String> {
        let element = self.driver.active_element().await.unwrap();
        element.id().await.unwrap()
    }

    /// Gives a file to the page as if it had been chosen.
    pub(crate) async fn choose_file(&self, id: &str, path: &Path) {
        let path = path.to_str().unwrap();
        self.element(id).await.send_keys(path).await.unwrap();
        self.settle().await;
    }

    /// A chain of actions by mouse and keys.
    pub(crate) fn hand(&self) -> ActionChain {
        let none = Some(Duration::ZERO);
        self.driver.action_chain_with_delay(none, Some(MOVE))
    }

    /// Types where the focus is.
    pub(crate) async fn keys(&self, keys: impl Into<TypingData>) {
        let typing = self.hand().send_keys(keys);
        typing.perform().await.unwrap();
        self.settle().await;
    }

    /// Presses a key while others are held.
    pub(crate) async fn chord(&self, held: &[Key], key: impl Into<char>) {
        let mut chain = self.hand();
        for held in held {
            chain = chain.key_down(held.value());
        }
        chain = chain.send_keys(key.into().to_string());
        for held in held.iter().rev() {
            chain = chain.key_up(held.value());
        }
        chain.perform().await.unwrap();
        self.settle().await;
    }

    /// Gives an element the focus.
    pub(crate) async fn focus(&self, id: &str) {
        self.unfold(id, ".menu").await;
        self.element(id).await.focus().await.unwrap();
    }
}
