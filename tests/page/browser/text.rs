//! Texts as a browser gives them, with plain spaces.

use serde_json::Value;

/// A text with plain spaces for those at which no line breaks, as drivers give the text of an element.
pub(crate) fn plain(text: &str) -> String {
    text.replace('\u{a0}', " ")
}

/// A value whose texts have plain spaces.
pub(super) fn spaced(value: Value) -> Value {
    match value {
        Value::String(text) => plain(&text).into(),
        Value::Array(all) => all.into_iter().map(spaced).collect(),
        Value::Object(all) => {
            let all = all.into_iter().map(|(name, one)| (name, spaced(one)));
            all.collect()
        }
        other => other,
    }
}
