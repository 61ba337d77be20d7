//! TypeScript types of the saved form for the scripts of the page. The test compares them with this
//! crate's `types.d.ts`; if `ASSUR_WRITE_TYPES` is set, it writes that file first.

use assur_tests::types::assert_declared;

use crate::kinds::numbers::NumberField;
use crate::{
    Document, GalleryCategory, LengthUnit, LessonDocument, MeshDocument, PictureDocument, Preset,
    Shelf, View,
};

/// Types without a counterpart in Rust: a problem, a value that is never changed in place, a document of given kinds.
const HEAD: &str = "\
export type Problem = { readonly code: string, readonly field?: string, readonly [parameter: string]: string | number | readonly string[] | undefined };
export type Frozen<T> = T extends object ? { readonly [K in keyof T]: Frozen<T[K]> } : T;
export type DocumentOf<K extends Document[\"kind\"]> = Extract<Document, { kind: K }>;
";

#[test]
fn the_scripts_know_what_is_saved() {
    type Saved = (View, Document, LessonDocument, PictureDocument, LengthUnit);
    type Shown = (NumberField, Preset, Shelf, GalleryCategory, MeshDocument);
    assert_declared::<(Saved, Shown)>(env!("CARGO_MANIFEST_DIR"), HEAD);
}
