//! TypeScript declarations, written from the Rust types.

use std::collections::BTreeMap;
use std::{env, fs};

use ts_rs::{Config, TS, TypeVisitor};

/// Declares types by their names, and the types of their fields.
struct Declarations {
    config: Config,
    by_name: BTreeMap<String, String>,
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        if T::output_path().is_some() {
            let declaration = format!("export {}\n", T::decl(&self.config));
            let declaration = on_one_line(&declaration);
            let name = T::ident(&self.config);
            if self.by_name.insert(name, declaration).is_none() {
                T::visit_dependencies(self);
            }
        }
    }
}

/// Writes each comment of one line, and the field that it describes, on one line.
fn on_one_line(declaration: &str) -> String {
    let mut comments = declaration.split("/**\n * ");
    let mut text = comments.next().unwrap_or_default().to_owned();
    for comment in comments {
        match comment.split_once("\n */\n") {
            Some((line, rest)) if !line.contains('\n') => text += &format!("/** {line} */ {rest}"),
            _ => text += &format!("/**\n * {comment}"),
        }
    }
    text
}

/// Compares the file `types.d.ts` of a crate with the declarations of a tuple of types, after these lines; writes it
/// instead where `ASSUR_WRITE_TYPES` is set.
///
/// # Panics
/// Where they differ, or the file cannot be read or written.
pub fn assert_declared<Types: TS + 'static>(crate_folder: &str, head: &str) {
    let mut declarations = Declarations {
        config: Config::new().with_large_int("number"),
        by_name: BTreeMap::new(),
    };
    Types::visit_generics(&mut declarations);
    let first = "// Written by the tests of this crate from its Rust: see src/types.rs.\n";
    let declared: String = declarations.by_name.into_values().collect();
    let text = [first, head, &declared].concat();
    let place = format!("{crate_folder}/types.d.ts");
    if env::var_os("ASSUR_WRITE_TYPES").is_some() {
        fs::write(&place, &text).unwrap();
    }
    assert_eq!(fs::read_to_string(place).unwrap(), text);
}
