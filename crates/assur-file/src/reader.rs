//! Conversion of JSON to types of Rust, with the path of the part that has the wrong form.

use serde::Deserialize;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, EnumAccess, Error as _, IntoDeserializer,
    MapAccess, SeqAccess, Unexpected, VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use serde_json::{Error, Map, Value, map};

use crate::Problem;

/// Converts JSON to a value of a type.
///
/// # Errors
/// [`Problem::BadState`] with the path of the part that has the wrong form.
pub fn from_json<T: DeserializeOwned>(value: &Value) -> Result<T, Problem> {
    let mut path = String::new();
    let read = T::deserialize(Reader {
        value,
        path: &mut path,
    });
    read.map_err(|error| Problem::BadState {
        path: if path.is_empty() {
            ".".to_owned()
        } else {
            path
        },
        detail: error.to_string(),
    })
}

/// Reader of a part of a JSON value, with the path of the part. After an error, the path is that of the fault.
struct Reader<'de, 'path> {
    value: &'de Value,
    path: &'path mut String,
}

/// Reader of the elements of an array.
struct Elements<'de, 'path> {
    all: &'de [Value],
    next: usize,
    path: &'path mut String,
}

/// Reader of the fields of an object.
struct Fields<'de, 'path> {
    rest: map::Iter<'de>,
    value: Option<&'de Value>,
    /// Length of the object's path, bytes.
    length: usize,
    path: &'path mut String,
}

/// Reader of an enum variant, written as its name alone or as an object with that name as the only key.
struct Variant<'de, 'path> {
    name: &'de str,
    content: Option<&'de Value>,
    path: &'path mut String,
}

impl<'de> Deserializer<'de> for Reader<'de, '_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let Self { value, path } = self;
        match value {
            Value::Null => visitor.visit_unit(),
            Value::Bool(value) => visitor.visit_bool(*value),
            Value::Number(number) => number.deserialize_any(visitor),
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Array(all) => {
                let mut elements = Elements { all, next: 0, path };
                let read = visitor.visit_seq(&mut elements)?;
                if elements.next < all.len() {
                    return Err(Error::invalid_length(all.len(), &"fewer elements in array"));
                }
                Ok(read)
            }
            Value::Object(fields) => visitor.visit_map(Fields::new(fields, path)),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let Self { value, path } = self;
        let (name, content) = match value {
            Value::String(name) => (name, None),
            Value::Object(fields) if fields.len() == 1 => {
                let field = fields.iter().next();
                let (name, content) = field.ok_or_else(|| Error::custom("an empty object"))?;
                (name, Some(content))
            }
            Value::Object(_) => {
                let expected = &"map with a single key";
                return Err(Error::invalid_value(Unexpected::Map, expected));
            }
            other => {
                let unexpected = unexpected(other);
                return Err(Error::invalid_type(unexpected, &"string or map"));
            }
        };
        visitor.visit_enum(Variant {
            name,
            content,
            path,
        })
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct seq tuple tuple_struct map struct identifier
    }
}

fn unexpected(value: &Value) -> Unexpected<'_> {
    match value {
        Value::Null => Unexpected::Unit,
        Value::Bool(value) => Unexpected::Bool(*value),
        Value::Number(number) => match (number.as_u64(), number.as_i64()) {
            (Some(number), _) => Unexpected::Unsigned(number),
            (None, Some(number)) => Unexpected::Signed(number),
            (None, None) => Unexpected::Float(number.as_f64().unwrap_or(f64::NAN)),
        },
        Value::String(text) => Unexpected::Str(text),
        Value::Array(_) => Unexpected::Seq,
        Value::Object(_) => Unexpected::Map,
    }
}

impl<'de> SeqAccess<'de> for &mut Elements<'de, '_> {
    type Error = Error;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        let Some(value) = self.all.get(self.next) else {
            return Ok(None);
        };
        let length = self.path.len();
        *self.path += &format!("[{}]", self.next);
        let path = &mut *self.path;
        let read = seed.deserialize(Reader { value, path })?;
        self.path.truncate(length);
        self.next += 1;
        Ok(Some(read))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.all.len() - self.next)
    }
}

impl<'de, 'path> Fields<'de, 'path> {
    fn new(fields: &'de Map<String, Value>, path: &'path mut String) -> Self {
        Self {
            rest: fields.iter(),
            value: None,
            length: path.len(),
            path,
        }
    }
}

impl<'de> MapAccess<'de> for Fields<'de, '_> {
    type Error = Error;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        let Some((key, value)) = self.rest.next() else {
            return Ok(None);
        };
        if self.length > 0 {
            self.path.push('.');
        }
        self.path.push_str(key);
        self.value = Some(value);
        seed.deserialize(key.as_str().into_deserializer()).map(Some)
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Error> {
        let value = self.value.take();
        let value = value.ok_or_else(|| Error::custom("value is missing"))?;
        let path = &mut *self.path;
        let read = seed.deserialize(Reader { value, path })?;
        self.path.truncate(self.length);
        Ok(read)
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.rest.len())
    }
}

impl<'de, 'path> EnumAccess<'de> for Variant<'de, 'path> {
    type Error = Error;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self), Error> {
        let variant = seed.deserialize(self.name.into_deserializer())?;
        Ok((variant, self))
    }
}

impl<'de, 'path> Variant<'de, 'path> {
    /// Reader of the content of the variant.
    fn content(self, expected: &'static str) -> Result<Reader<'de, 'path>, Error> {
        let Self {
            name,
            content,
            path,
        } = self;
        let missing = || Error::invalid_type(Unexpected::UnitVariant, &expected);
        let value = content.ok_or_else(missing)?;
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(name);
        Ok(Reader { value, path })
    }
}

impl<'de> VariantAccess<'de> for Variant<'de, '_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        match self.content {
            None => Ok(()),
            Some(_) => <()>::deserialize(self.content("unit variant")?),
        }
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Error> {
        seed.deserialize(self.content("newtype variant")?)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _len: usize, visitor: V) -> Result<V::Value, Error> {
        self.content("tuple variant")?.deserialize_any(visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.content("struct variant")?.deserialize_any(visitor)
    }
}

#[cfg(test)]
mod tests {
    use assur_tests::damage::{Dice, with_other_value};
    use assur_tests::scaled;
    use serde::Deserialize;
    use serde_json::{Value, json};

    use super::from_json;
    use crate::{
        GearTrainDocument, LinkageDocument, PathDocument, PosesDocument, Problem, SchemeDocument,
        SynthesisDocument, View, catalogue, document, schemes, tasks, trains,
    };

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(rename_all = "snake_case", deny_unknown_fields)]
    enum Motion {
        Rest,
        Turn(f64),
        Slide { by: [f64; 2] },
    }

    #[derive(Debug, Deserialize, PartialEq)]
    #[serde(deny_unknown_fields)]
    struct Test {
        motions: Vec<Motion>,
        #[serde(default)]
        note: Option<String>,
    }

    fn fault(value: &Value) -> (String, String) {
        match from_json::<Test>(value) {
            Err(Problem::BadState { path, detail }) => (path, detail),
            other => panic!("{value}: {other:?}"),
        }
    }

    #[test]
    fn a_fault_has_its_path() {
        let read =
            from_json(&json!({"motions": ["rest", {"turn": 2}, {"slide": {"by": [1, 2.5]}}]}));
        let motions = vec![
            Motion::Rest,
            Motion::Turn(2.0),
            Motion::Slide { by: [1.0, 2.5] },
        ];
        assert_eq!(
            read,
            Ok(Test {
                motions,
                note: None
            })
        );
        for (value, path) in [
            (json!(7), "."),
            (json!({}), "."),
            (json!({"motions": 1}), "motions"),
            (json!({"motions": [], "notes": ""}), "notes"),
            (json!({"motions": [], "note": 1}), "note"),
            (json!({"motions": ["rest", "run"]}), "motions[1]"),
            (json!({"motions": [{"turn": "2"}]}), "motions[0].turn"),
            (
                json!({"motions": [{"slide": {"by": [1, null]}}]}),
                "motions[0].slide.by[1]",
            ),
            (
                json!({"motions": [{"slide": {"by": [1, 2, 3]}}]}),
                "motions[0].slide.by",
            ),
            (json!({"motions": ["turn"]}), "motions[0]"),
            (json!({"motions": [{"rest": 1}]}), "motions[0].rest"),
        ] {
            assert_eq!(fault(&value).0, path, "{value}");
        }
    }

    /// Checks that [`from_json`] gives the same result as the crate `serde_path_to_error`, which compiles to more code.
    fn agrees<T: serde::de::DeserializeOwned + serde::Serialize>(value: &Value) {
        let expected = serde_path_to_error::deserialize::<_, T>(value)
            .map(|read| serde_json::to_value(read).unwrap())
            .map_err(|error| (error.path().to_string(), error.inner().to_string()));
        let read = from_json::<T>(value).map(|read| serde_json::to_value(read).unwrap());
        let read = read.map_err(|problem| match problem {
            Problem::BadState { path, detail } => (path, detail),
            other => panic!("{other:?}"),
        });
        assert_eq!(read, expected, "{value}");
    }

    #[test]
    fn damaged_documents_have_the_same_faults() {
        let mut dice = Dice::new(0);
        let names = catalogue().chain(trains()).chain(schemes()).chain(tasks());
        let documents = names.map(|name| document(name).unwrap().unwrap());
        let documents: Vec<Value> = documents
            .map(|document| serde_json::to_value(document).unwrap())
            .collect();
        for _ in 0..scaled(20) {
            for sound in &documents {
                let mut value = sound.clone();
                for _ in 0..=dice.below(2) {
                    with_other_value(&mut value, &mut dice);
                }
                let document = value.get("document").unwrap_or(&Value::Null).clone();
                agrees::<LinkageDocument>(&document);
                agrees::<GearTrainDocument>(&document);
                agrees::<SchemeDocument>(&document);
                agrees::<SynthesisDocument>(&document);
                agrees::<PosesDocument>(&document);
                agrees::<PathDocument>(&document);
                agrees::<View>(value.get("view").unwrap_or(&document));
            }
        }
    }
}
