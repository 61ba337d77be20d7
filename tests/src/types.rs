//! Declarations of types in TypeScript, written from the Rust.

use std::collections::BTreeSet;
use std::{env, fs};

use ts_rs::{Config, TS, TypeVisitor};

/// Declares types, each once, and the types of their fields.
struct Declarations {
    config: Config,
    names: BTreeSet<String>,
    text: String,
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        let declared = T::output_path().is_some();
        if declared && self.names.insert(T::ident(&self.config)) {
            let declaration = T::decl(&self.config);
            self.text += &format!("export {declaration}\n");
            T::visit_dependencies(self);
        }
    }
}

/// Compares the file `types.d.ts` of a crate with the declarations of a tuple of types, after these lines; writes it
/// instead where `ASSUR_WRITE_TYPES` is set.
///
/// # Panics
/// Where they differ, or the file cannot be read or written.
pub fn assert_declared<Types: TS + 'static>(crate_folder: &str, head: &str) {
    let mut declarations = Declarations {
        config: Config::new().with_large_int("number"),
        names: BTreeSet::new(),
        text: format!(
            "// Written by the tests of this crate from its Rust: see src/types.rs.\n{head}"
        ),
    };
    Types::visit_generics(&mut declarations);
    let place = format!("{crate_folder}/types.d.ts");
    if env::var_os("ASSUR_WRITE_TYPES").is_some() {
        fs::write(&place, &declarations.text).unwrap();
    }
    assert_eq!(fs::read_to_string(place).unwrap(), declarations.text);
}
