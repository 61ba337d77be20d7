//! TypeScript types of the values exchanged with the scripts of the page: this test writes
//! `types.d.ts` of this crate if `ASSUR_WRITE_TYPES` is set, and otherwise compares it.

use std::{env, fs};

use ts_rs::{Config, TS};

use crate::assemblies::{
    AssembliesHere, AssemblyHere, Belonging, BranchLine, MeetingPlace, MotionsMap,
};
use crate::capabilities::{LinkHere, RelationHere};
use crate::chart::{
    AgainstLayout, AxisLayout, ChartLayout, ChartRequest, MarkLayout, PanelLayout, SeriesLayout,
    TickLayout,
};
use crate::curvature::{CircleHere, CurvatureHere, InflectionHere};
use crate::design::{Movement, ReachedSummary, StepSummary, Wishes};
use crate::dimensions::DimensionSummary;
use crate::equations::EquationSummary;
use crate::kinds::draft::DraftSummary;
use crate::kinds::gear_train::summary::{
    BodyNumbers, GearTrainSummary, HaltSummary, IdentitySummary, MobilitySummary, PullSummary,
    RatioSummary, ShaftNumbers, SuggestionSummary, TrainConditionSummary, VelocitySummary,
};
use crate::kinds::linkage::{LinkageSummary, RateSummary};
use crate::kinds::mixer::MixerSummary;
use crate::kinds::scheme::summary::{
    ChangedPair, ClassSummary, CountSummary, JudgedSummary, LoopSummary, MendedSummary,
    PairSummary, RedundancySummary, SchemeSummary, SectionsSummary,
};
use crate::kinds::synthesis::options::{FamilyCurve, FamilySummary, FoundSummary};
use crate::kinds::synthesis::plane::PlaneSummary;
use crate::kinds::synthesis::summary::{
    FunctionSummary, SolutionSummary, SynthesisSummary, VerdictSummary,
};
use crate::kinds::synthesis::wanted::{
    ConditionSummary, LeftOutSummary, PrintedSummary, TheoremSummary, WantedSummary,
    WeightedSummary,
};
use crate::polygons::{FoundHere, LegHere, PolygonPictureHere, PolygonStepHere, PolygonsHere};
use crate::profile::{DwellSummary, PhaseSummary, ProfileSummary};
use crate::summary::{
    Between, CountsSummary, CourseSummary, CycleSummary, DeadPointSummary, FourBarSummary,
    GroupSummary, HandleSummary, LimitSummary, ListedSummary, MotionSummary, OutputSummary,
    StructureSummary, TransmissionSummary, UnsearchedSummary,
};
use crate::table::{SweepColumn, SweepDimension, SweepQuantity, SweepRow, SweepTable};

#[test]
fn the_scripts_know_what_crosses_the_border() {
    let config = Config::new().with_large_int("number");
    let types = [
        AssembliesHere::decl(&config),
        AssemblyHere::decl(&config),
        PolygonsHere::decl(&config),
        PolygonPictureHere::decl(&config),
        PolygonStepHere::decl(&config),
        LegHere::decl(&config),
        FoundHere::decl(&config),
        CurvatureHere::decl(&config),
        CircleHere::decl(&config),
        InflectionHere::decl(&config),
        MotionsMap::decl(&config),
        BranchLine::decl(&config),
        MeetingPlace::decl(&config),
        Belonging::decl(&config),
        StructureSummary::decl(&config),
        CourseSummary::decl(&config),
        MotionSummary::decl(&config),
        LinkageSummary::decl(&config),
        RateSummary::decl(&config),
        DimensionSummary::decl(&config),
        MixerSummary::decl(&config),
        DraftSummary::decl(&config),
        LinkHere::decl(&config),
        RelationHere::decl(&config),
        SchemeSummary::decl(&config),
        PairSummary::decl(&config),
        CountSummary::decl(&config),
        ClassSummary::decl(&config),
        SectionsSummary::decl(&config),
        LoopSummary::decl(&config),
        JudgedSummary::decl(&config),
        RedundancySummary::decl(&config),
        MendedSummary::decl(&config),
        ChangedPair::decl(&config),
        SynthesisSummary::decl(&config),
        FunctionSummary::decl(&config),
        SolutionSummary::decl(&config),
        VerdictSummary::decl(&config),
        FamilySummary::decl(&config),
        FamilyCurve::decl(&config),
        FoundSummary::decl(&config),
        PlaneSummary::decl(&config),
        WantedSummary::decl(&config),
        ConditionSummary::decl(&config),
        TheoremSummary::decl(&config),
        LeftOutSummary::decl(&config),
        PrintedSummary::decl(&config),
        WeightedSummary::decl(&config),
        GearTrainSummary::decl(&config),
        BodyNumbers::decl(&config),
        ShaftNumbers::decl(&config),
        RatioSummary::decl(&config),
        IdentitySummary::decl(&config),
        TrainConditionSummary::decl(&config),
        SuggestionSummary::decl(&config),
        MobilitySummary::decl(&config),
        VelocitySummary::decl(&config),
        PullSummary::decl(&config),
        HaltSummary::decl(&config),
        CountsSummary::decl(&config),
        CycleSummary::decl(&config),
        GroupSummary::decl(&config),
        DeadPointSummary::decl(&config),
        FourBarSummary::decl(&config),
        TransmissionSummary::decl(&config),
        OutputSummary::decl(&config),
        UnsearchedSummary::decl(&config),
        Between::decl(&config),
        LimitSummary::decl(&config),
        ListedSummary::decl(&config),
        HandleSummary::decl(&config),
        EquationSummary::decl(&config),
        ProfileSummary::decl(&config),
        DwellSummary::decl(&config),
        PhaseSummary::decl(&config),
        ChartRequest::decl(&config),
        ChartLayout::decl(&config),
        AgainstLayout::decl(&config),
        AxisLayout::decl(&config),
        PanelLayout::decl(&config),
        TickLayout::decl(&config),
        SeriesLayout::decl(&config),
        MarkLayout::decl(&config),
        SweepTable::decl(&config),
        SweepDimension::decl(&config),
        SweepColumn::decl(&config),
        SweepQuantity::decl(&config),
        SweepRow::decl(&config),
        Wishes::decl(&config),
        Movement::decl(&config),
        StepSummary::decl(&config),
        ReachedSummary::decl(&config),
    ];
    let first = "// Written by the tests of this crate from its Rust: see src/types.rs.\n\
                 import { Mend } from \"assur/types/edit.js\";\n\
                 import { KindDocument, LinkageDocument, Only } from \"assur/types/file.js\";\n\
                 export type Summaries = { draft: DraftSummary, \"gear-train\": GearTrainSummary, linkage: LinkageSummary, mixer: MixerSummary, scheme: SchemeSummary, synthesis: SynthesisSummary };\n";
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
