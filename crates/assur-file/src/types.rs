//! TypeScript types of the saved form for the scripts of the page. The test compares them with this
//! crate's `types.d.ts`; if `ASSUR_WRITE_TYPES` is set, it writes that file first.

use assur_tests::types::assert_declared;

use crate::kinds::numbers::NumberField;
use crate::{
    Document, GalleryCategory, LengthUnit, LessonDocument, MeshDocument, PictureDocument, Preset,
    Shelf, View,
};

#[test]
fn the_scripts_know_what_is_saved() {
    type Saved = (View, Document, LessonDocument, PictureDocument, LengthUnit);
    type Shown = (NumberField, Preset, Shelf, GalleryCategory, MeshDocument);
    assert_declared::<(Saved, Shown)>(env!("CARGO_MANIFEST_DIR"), "");
}
