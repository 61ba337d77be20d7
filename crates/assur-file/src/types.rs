//! TypeScript types of the saved form for the scripts of the page: this test writes `types.d.ts` of
//! this crate if `ASSUR_WRITE_TYPES` is set, and otherwise compares it.

use std::{env, fs};

use ts_rs::{Config, TS};

use crate::kinds::draft::DraftDocument;
use crate::kinds::gear_train::{
    BodiesDocument, CouplingDocument, DriveDocument, FormDocument, GearTrainDocument,
    MagnetsDocument, MemberDocument, MemberKind, MembersDocument, ObserverDocument, PolesDocument,
    ShaftDocument,
};
use crate::kinds::linkage::{
    DriverDocument, GearDocument, LinkDocument, MeshDocument, PointDocument, SlideDocument,
    TracerDocument,
};
use crate::kinds::mixer::{MixerDocument, MixerTracerDocument, WheelDocument};
use crate::kinds::numbers::NumberField;
use crate::kinds::scheme::{
    EndDocument, KindDocument, PairDocument, PlaceDocument, SchemeDocument,
};
use crate::kinds::synthesis::function::{FormulaDocument, FunctionDocument};
use crate::kinds::synthesis::{PositionDocument, SynthesisDocument};
use crate::lesson::{
    ChoiceDocument, LessonDocument, NumberDocument, QuestionDocument, ReachDocument, ShownDocument,
    StepDocument, VariedDocument,
};
use crate::view::{Against, Axes, Only, OpenLesson, SpeedUnit};
use crate::{
    Document, GalleryCategory, LengthUnit, LinkageDocument, PictureDocument, Preset, Shelf, View,
};

#[test]
fn the_scripts_know_what_is_saved() {
    let config = Config::new().with_large_int("number");
    let types = [
        View::decl(&config),
        OpenLesson::decl(&config),
        Against::decl(&config),
        Only::decl(&config),
        Axes::decl(&config),
        SpeedUnit::decl(&config),
        LengthUnit::decl(&config),
        Document::decl(&config),
        MixerDocument::decl(&config),
        WheelDocument::decl(&config),
        MixerTracerDocument::decl(&config),
        LinkageDocument::decl(&config),
        DraftDocument::decl(&config),
        PointDocument::decl(&config),
        LinkDocument::decl(&config),
        SlideDocument::decl(&config),
        GearDocument::decl(&config),
        MeshDocument::decl(&config),
        DriverDocument::decl(&config),
        TracerDocument::decl(&config),
        SchemeDocument::decl(&config),
        PairDocument::decl(&config),
        KindDocument::decl(&config),
        PlaceDocument::decl(&config),
        EndDocument::decl(&config),
        SynthesisDocument::decl(&config),
        PositionDocument::decl(&config),
        FunctionDocument::decl(&config),
        FormulaDocument::decl(&config),
        GearTrainDocument::decl(&config),
        FormDocument::decl(&config),
        CouplingDocument::decl(&config),
        ShaftDocument::decl(&config),
        ObserverDocument::decl(&config),
        DriveDocument::decl(&config),
        MembersDocument::decl(&config),
        MemberDocument::decl(&config),
        MemberKind::decl(&config),
        MagnetsDocument::decl(&config),
        PolesDocument::decl(&config),
        BodiesDocument::decl(&config),
        LessonDocument::decl(&config),
        StepDocument::decl(&config),
        ShownDocument::decl(&config),
        VariedDocument::decl(&config),
        QuestionDocument::decl(&config),
        NumberDocument::decl(&config),
        ChoiceDocument::decl(&config),
        ReachDocument::decl(&config),
        PictureDocument::decl(&config),
        NumberField::decl(&config),
        Preset::decl(&config),
        Shelf::decl(&config),
        GalleryCategory::decl(&config),
    ];
    let first = "// Written by the tests of this crate from its Rust: see src/types.rs.\n";
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
