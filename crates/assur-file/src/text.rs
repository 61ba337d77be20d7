//! Reading of JSON. Duplicate keys are refused, since the value of one of them would be ignored without notice.

use std::fmt;

use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor,
};
use serde_json::{Map, Value};

use crate::Problem;
use crate::reader::from_json;

/// The character that some editors put before a text to show its encoding.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Reads any JSON, with or without a byte-order mark.
///
/// # Errors
/// [`Problem::NotJson`]; [`Problem::KeyTwice`] with the path of the key.
pub(crate) fn json(text: &str) -> Result<Value, Problem> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let mut reader = serde_json::Deserializer::from_str(text);
    let mut path = String::new();
    let value = Part { path: &mut path }.deserialize(&mut reader);
    let whole = value.and_then(|value| reader.end().map(|()| value));
    whole.map_err(|error| {
        // Only duplicate keys cause an error of this category.
        if error.is_data() {
            Problem::KeyTwice { path }
        } else {
            let detail = error.to_string();
            Problem::NotJson { detail }
        }
    })
}

/// Checks that a JSON text, which is read elsewhere, has no duplicate keys. A text that is not JSON passes.
///
/// # Errors
/// [`Problem::KeyTwice`] with the path of the key.
pub fn keys_once(text: &str) -> Result<(), Problem> {
    match json(text) {
        Err(twice @ Problem::KeyTwice { .. }) => Err(twice),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Reader of a part of a text, with the path of the part. After an error, the path is that of the fault.
struct Part<'a> {
    path: &'a mut String,
}

impl<'de> DeserializeSeed<'de> for Part<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<Value, D::Error> {
        reader.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Part<'_> {
    type Value = Value;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("any JSON")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_str<E>(self, value: &str) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut parts: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        let whole = self.path.len();
        loop {
            *self.path += &format!("[{}]", list.len());
            let Some(part) = parts.next_element_seed(Part { path: self.path })? else {
                self.path.truncate(whole);
                return Ok(list.into());
            };
            list.push(part);
            self.path.truncate(whole);
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut parts: A) -> Result<Value, A::Error> {
        let mut object = Map::new();
        let whole = self.path.len();
        while let Some(key) = parts.next_key::<String>()? {
            if whole > 0 {
                self.path.push('.');
            }
            self.path.push_str(&key);
            if object.contains_key(&key) {
                return Err(A::Error::custom("a key stands twice"));
            }
            let part = parts.next_value_seed(Part { path: self.path })?;
            self.path.truncate(whole);
            object.insert(key, part);
        }
        Ok(object.into())
    }
}

/// Converts a field of a JSON object to a value of a type, if the field exists.
pub(crate) fn within<T: DeserializeOwned>(value: &Value, name: &str) -> Result<Option<T>, Problem> {
    let read = value.get(name).map(from_json).transpose();
    read.map_err(|problem| under(name, problem))
}

/// Puts the name of a field before the path of a problem within that field.
pub(crate) fn under(name: &str, problem: Problem) -> Problem {
    match problem {
        Problem::BadState { path, detail } => Problem::BadState {
            path: match path.as_str() {
                "." => name.to_owned(),
                inner => format!("{name}.{inner}"),
            },
            detail,
        },
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(text: &str) -> String {
        match json(text) {
            Err(Problem::KeyTwice { path }) => path,
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn keys_that_stand_twice_have_a_path() {
        assert_eq!(path(r#"{"a": 1, "b": 2, "a": 1}"#), "a");
        assert_eq!(path(r#"{"a": 1, "\u0061": 2}"#), "a");
        assert_eq!(
            path(
                r#"{"x": {"y": 0}, "links": [{"name": "k"}, {"name": "l", "at": [[1], 2], "name": "m"}]}"#
            ),
            "links[1].name"
        );
        assert_eq!(path(r#"[[], [[{"": 1, "": 2}]]]"#), "[1][0][0].");
        // Duplicate keys are reported first, whatever else is wrong after them.
        assert_eq!(path(r#"{"a": 1, "a": ]"#), "a");
    }

    #[test]
    fn everything_else_is_read_as_it_is_written() {
        for text in [
            r#"{"a": {"b": 1}, "c": {"b": [true, null, -1, 18446744073709551615, 0.1, "\u00e9"]}}"#,
            "[]",
            "7",
        ] {
            let value: Value = serde_json::from_str(text).unwrap();
            assert_eq!(json(text), Ok(value.clone()), "{text}");
            assert_eq!(json(&format!("\u{feff}{text}")), Ok(value), "{text}");
            assert_eq!(keys_once(text), Ok(()));
        }
        for text in [
            "",
            "\u{feff}",
            "\u{feff}\u{feff}1",
            "{",
            "[1,]",
            "1 2",
            "1e999",
            &"[".repeat(1000),
        ] {
            assert!(matches!(json(text), Err(Problem::NotJson { .. })), "{text}");
            assert_eq!(keys_once(text), Ok(()));
        }
    }
}
