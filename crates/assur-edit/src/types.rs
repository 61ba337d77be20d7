//! TypeScript types of edits for the scripts of the page: this test writes `types.d.ts` of this
//! crate if `ASSUR_WRITE_TYPES` is set, and otherwise compares it.

use std::{env, fs};

use ts_rs::{Config, TS};

use crate::{Edit, End, Inner, Line, Mend, Outer};

#[test]
fn the_scripts_know_what_can_be_edited() {
    let config = Config::new().with_large_int("number");
    let types = [
        Edit::decl(&config),
        End::decl(&config),
        Line::decl(&config),
        Outer::decl(&config),
        Inner::decl(&config),
        Mend::decl(&config),
    ];
    let first = "// Written by the tests of this crate from its Rust: see src/types.rs.\n\
                 import { LinkageDocument } from \"assur/types/file.js\";\n";
    let text: String = types
        .map(|declared| format!("export {declared}\n"))
        .concat();
    let text = [first, &text].concat();
    let place = concat!(env!("CARGO_MANIFEST_DIR"), "/types.d.ts");
    if env::var_os("ASSUR_WRITE_TYPES").is_some() {
        fs::write(place, &text).unwrap();
    }
    assert_eq!(fs::read_to_string(place).unwrap(), text);
}
