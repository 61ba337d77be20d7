//! TypeScript types of the values exchanged with the scripts of the page. The test writes this
//! crate's `types.d.ts` if `ASSUR_WRITE_TYPES` is set; otherwise it compares the file.

use assur_tests::types::assert_declared;

use crate::assemblies::{AssembliesHere, Belonging, MotionsMap};
use crate::capabilities::{LinkHere, RelationHere};
use crate::chart::{ChartLayout, ChartRequest};
use crate::curvature::CurvatureHere;
use crate::design::{Movement, ReachedSummary, StepSummary, Wishes};
use crate::equations::EquationSummary;
use crate::equilibrium::{EquilibriumHere, StudentSheet};
use crate::force_plan::{ForcePlanHere, FreeBodyHere, LeverHere};
use crate::kinds::draft::{DraftSummary, Drawn};
use crate::kinds::gear_train::summary::GearTrainSummary;
use crate::kinds::linkage::LinkageSummary;
use crate::kinds::mixer::MixerSummary;
use crate::kinds::point_path::atlas::{AtlasCell, AtlasHere, AtlasPage, AtlasRatio};
use crate::kinds::point_path::search::{
    NinePointProgress, PathWork, TracingProgress, TracingWishes,
};
use crate::kinds::point_path::summary::{
    FoundTracing, PathSummary, PathTaskSummary, TracingVerdict,
};
use crate::kinds::poses::summary::{DyadPairSummary, GuidanceVerdict, PosesSummary, TaskSummary};
use crate::kinds::scheme::summary::SchemeSummary;
use crate::kinds::synthesis::options::{FamilySummary, FoundSummary};
use crate::kinds::synthesis::plane::PlaneSummary;
use crate::kinds::synthesis::summary::SynthesisSummary;
use crate::kinds::synthesis::wanted::{PrintedSummary, WantedSummary};
use crate::kinds::task::StillSummary;
use crate::masses::MassHere;
use crate::polygons::PolygonsHere;
use crate::profile::ProfileSummary;
use crate::reactions::{ForcesHere, GreatestForces};
use crate::summary::{
    CourseSummary, MotionSummary, OutputSummary, StructureSummary, TransmissionSummary,
};
use crate::table::SweepTable;
use crate::under_load::{CycleHere, RunHere};

const HEAD: &str = "\
import { Mend } from \"assur/types/edit.js\";
import { Document, DocumentOf, Frozen, HingeDocument, KindDocument, LessonDocument, LinkageDocument, Only, PictureDocument, Problem, TracingDocument, View } from \"assur/types/file.js\";
export type Kind = Document[\"kind\"];
export type Summary = Summaries[Kind];
export type State<K extends Kind = Kind> = K extends Kind ? Frozen<DocumentOf<K> & { format: 2, view?: View, lesson?: LessonDocument, compared?: Document, picture?: PictureDocument }> : never;
export type Fields<K extends Kind = Kind> = K extends Kind ? Partial<DocumentOf<K>[\"document\"]> : never;
export type Changed = { document?: Fields, input?: number };
export type Traced = { document: Fields & { tracers: { name?: string, link: string }[] } };
export type Imported = { read: Document, left_out: Problem[] };
export type Summaries = { draft: DraftSummary, \"gear-train\": GearTrainSummary, linkage: LinkageSummary, mixer: MixerSummary, \"point-path\": PathSummary, poses: PosesSummary, scheme: SchemeSummary, synthesis: SynthesisSummary };
";

#[test]
fn the_scripts_know_what_crosses_the_border() {
    type Parts = (
        StructureSummary<'static>,
        CourseSummary<'static>,
        MotionSummary<'static>,
    );
    type Details = (
        OutputSummary,
        TransmissionSummary<'static>,
        ProfileSummary,
        EquationSummary<'static>,
    );
    type Moving = (
        LinkageSummary<'static>,
        MixerSummary<'static>,
        GearTrainSummary<'static>,
    );
    type Still = (
        DraftSummary<'static>,
        SchemeSummary<'static>,
        SynthesisSummary<'static>,
        PosesSummary<'static>,
        PathSummary<'static>,
        StillSummary<'static>,
    );
    type Synthesis = (
        FamilySummary,
        FoundSummary,
        PlaneSummary,
        WantedSummary,
        PrintedSummary,
        TaskSummary<'static>,
        DyadPairSummary,
        GuidanceVerdict,
    );
    type Paths = (
        PathTaskSummary<'static>,
        FoundTracing,
        TracingVerdict,
        TracingWishes,
        TracingProgress,
        NinePointProgress,
        PathWork,
    );
    type Atlas = (AtlasPage, AtlasRatio, AtlasHere, AtlasCell);
    type Here = (
        AssembliesHere,
        PolygonsHere,
        CurvatureHere<'static>,
        LinkHere,
        RelationHere,
        MotionsMap,
        Belonging,
        crate::here::Here,
        crate::here::ReadoutId,
    );
    type Forces = (
        ForcesHere,
        GreatestForces,
        MassHere,
        RunHere<'static>,
        CycleHere,
        ForcePlanHere,
        LeverHere,
        FreeBodyHere,
        EquilibriumHere,
        StudentSheet,
    );
    type Shown = (
        ChartRequest,
        ChartLayout<'static>,
        SweepTable,
        Wishes,
        Movement,
        Drawn,
        StepSummary,
        ReachedSummary,
    );
    assert_declared::<(
        Parts,
        Details,
        Moving,
        Still,
        Synthesis,
        Paths,
        Atlas,
        Here,
        Forces,
        Shown,
    )>(env!("CARGO_MANIFEST_DIR"), HEAD);
}
