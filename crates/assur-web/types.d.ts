// Written by the tests of this crate from its Rust: see src/types.rs.
import { Mend } from "assur/types/edit.js";
import { KindDocument, LinkageDocument, Only } from "assur/types/file.js";
export type Summaries = { draft: DraftSummary, "gear-train": GearTrainSummary, linkage: LinkageSummary, mixer: MixerSummary, scheme: SchemeSummary, synthesis: SynthesisSummary };
export type AgainstLayout = { left: number, top: number, width: number, height: number, x: AxisLayout, y: AxisLayout, physical: boolean, role: string, 
/**
 * Visible runs of the curve: x and y in pixels of the reader, and the input.
 */
curve: Array<Array<number>>, };
export type AssembliesHere = { 
/**
 * Assemblies in ascending order of their angles.
 */
all: Array<AssemblyHere>, 
/**
 * Index of the assembly that moves; none if it has no pose at the input.
 */
shown: number | null, 
/**
 * Number of solutions of a group's equations over the complex numbers, if a single group has them.
 */
complex: number | null, 
/**
 * Whether all assemblies were found.
 */
whole: boolean, };
export type AssemblyHere = { 
/**
 * Number by which it is shown and chosen; a mixer numbers its assemblies by itself.
 */
number: number, 
/**
 * The angle by which they are numbered, in [0, 2π).
 */
angle: number, 
/**
 * Poses of the bodies, as in a frame.
 */
bodies: Array<number>, };
export type AxisLayout = { 
/**
 * None for the input.
 */
name: string | null, 
/**
 * The number that denotes the angle, if it has one.
 */
number: string | null, order: 0 | 1 | 2, kind: "angle" | "length", from: number, to: number, ticks: Array<TickLayout>, };
export type Belonging = { 
/**
 * Index of the branch of each assembly, in the order of their numbers.
 */
branches: Array<number>, 
/**
 * For each assembly, the meetings on the way from the chosen one: empty for the same branch,
 * null if it cannot be reached.
 */
reached: Array<Array<number> | null>, };
export type Between = { min: number, max: number, stroke: number, };
export type BodyNumbers = { sun: number, satellite: number, carrier: number, ring: number, };
export type BranchLine = { 
/**
 * Index of its circuit.
 */
circuit: number, 
/**
 * Inputs and outputs in alternation, split where either wraps: radians in [0, 2π], or the displacement of a slide.
 */
pieces: Array<Array<number>>, };
export type ChangedPair = { pair: string, kind: KindDocument, };
export type ChartLayout = { panels: Array<PanelLayout>, 
/**
 * The plot of one quantity against another that replaces the panels, if there is one and it has room.
 */
against: AgainstLayout | null, };
export type ChartRequest = { width: number, height: number, palette: Array<[number, number, number]>, 
/**
 * Scale of text and lines relative to the usual size.
 */
scale: number, 
/**
 * Pixels of the screen per pixel of the reader.
 */
ratio: number, 
/**
 * Whether curves go through all their points, for a picture that may be enlarged.
 */
whole: boolean, 
/**
 * The plot that takes all the room, if any.
 */
only: Only, 
/**
 * The input around which an endless motion is plotted.
 */
around: number, };
export type CircleHere = { point: string, 
/**
 * The radius with two derivatives, as the axes define them.
 */
radius: [number, number, number] | null, centre: [number, number] | null, reason: import("assur/core/problem.js").Problem | null, };
export type ClassSummary = { freedoms: number, count: number, };
export type ConditionSummary = { 
/**
 * Its number in the paper.
 */
number: number, 
/**
 * The length that it concerns.
 */
about: string | null, 
/**
 * The two numbers whose signs it compares; null where one is infinite.
 */
values: [number | null, number | null], 
/**
 * Whether it holds as printed, and whether its conclusion is true.
 */
holds: boolean, truth: boolean, };
export type CountSummary = { 
/**
 * n: moving links.
 */
links: number, 
/**
 * Pᵢ in the scheme's own space, and in space.
 */
pairs: Array<ClassSummary>, spatial_pairs: Array<ClassSummary>, planar: number | null, spatial: number, };
export type CountsSummary = { links: number, lower: number, higher: number, mobility: number, by_count: number, };
export type CourseSummary = { 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], };
export type CurvatureHere = { circles: Array<CircleHere>, inflection: InflectionHere | null, };
export type CycleSummary = { start: number, end: number, full: boolean, arcs: Array<[number, number]>, };
export type DeadPointSummary = { input: number, kind: string, links: Array<string>, };
export type DimensionSummary = { field: string, kind: "length" | "side" | "corner" | "offset" | "x" | "y", index: number, name: string, points: Array<string>, role: string, value: number, min: number, max: number, step: number, };
export type DraftSummary = { 
/**
 * Always null.
 */
moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, 
/**
 * Mobility W by count; none if a named part does not exist.
 */
mobility: number | null, drivers: number, 
/**
 * Every reason why it does not move.
 */
reasons: readonly import("assur/core/problem.js").Problem[], loose: Array<string>, locked: Array<string>, mends: readonly Mend[], };
export type DwellSummary = { arc: [number, number], band: [number, number], };
export type EquationSummary = { "kind": "distance", link: string, points: [string, string], } | { "kind": "offset", link: string, points: [string, string, string], } | { "kind": "direction", link: string, on: string, } | { "kind": "mesh", links: [string, string], carrier: string, teeth: [number, number], };
export type FamilyCurve = { l2: Array<number>, l3: Array<number>, verdicts: ("turns" | "rocks" | "disorder" | "branch")[], };
export type FamilySummary = { 
/**
 * Minimum and maximum of l₁, l₂, l₃; null if there is none.
 */
lengths: [[number | null, number | null], [number | null, number | null], [number | null, number | null]], 
/**
 * Range of the coupler's angle in each position, radians.
 */
couplers: [[number, number], [number, number]], curve: FamilyCurve, 
/**
 * l₁, l₂, l₃ where the class changes.
 */
changes: Array<[number, number, number]>, };
export type FoundHere = { name: string, rates: [number, number], };
export type FoundSummary = { 
/**
 * Number of its starts.
 */
starts: number, 
/**
 * Number of starts that ended in the solution shown first.
 */
best: number, 
/**
 * l₂ and l₃ along the path from each start.
 */
paths: Array<Array<[number, number]>>, 
/**
 * Decimal logarithm of ΣJ over l₂ and l₃.
 */
sum: PlaneSummary, };
export type FourBarSummary = { links: [string, string, string, string], grashof: string, };
export type FunctionSummary = { 
/**
 * x in even steps, with the error of the linkage's y; null beyond its reach.
 */
curve: Array<[number, number | null]>, 
/**
 * x and error at the greatest error; none if the linkage reaches nothing of the interval.
 */
greatest: [number, number] | null, 
/**
 * Whether it covers the whole interval without a break.
 */
complete: boolean, };
export type GearTrainSummary = { bounds: [number, number, number, number], roles: { [key in string]: string }, 
/**
 * The shaft that is not driven.
 */
free: string, speeds: BodyNumbers, 
/**
 * a and b of a ω₁ + b ω₄ = (a + b) ω₃.
 */
weights: [number, number], ratios: Array<RatioSummary>, identities: Array<IdentitySummary>, conditions: Array<TrainConditionSummary>, 
/**
 * Whether all conditions are met.
 */
builds: boolean, 
/**
 * Similar trains that can be built, if this one cannot.
 */
suggestions: Array<SuggestionSummary>, 
/**
 * z₂ with which gears of these z₁ and z₄ are in contact, if there is one.
 */
in_contact: number | null, mobility: MobilitySummary, 
/**
 * Gaps of magnets at sun and ring, mm.
 */
gaps: [number, number] | null, axis_distance: number, 
/**
 * Velocities at the last speeds, mm and mm/s.
 */
velocities: VelocitySummary | null, 
/**
 * Torques from outside without losses, relative to the sun's, and what each shaft takes in of the power.
 */
torques: ShaftNumbers, powers: ShaftNumbers, 
/**
 * The torques that the magnets hold, N·m, each with the other shafts held.
 */
limits: BodyNumbers | null, 
/**
 * Natural frequencies of the meshes with sun and ring, Hz.
 */
swings: [number, number] | null, 
/**
 * The greatest torque of the load, and its upper limit, N·m.
 */
load: PullSummary | null, 
/**
 * Slips of the meshes with sun and ring at the end of a run, in periods.
 */
slips: [number, number] | null, halt: HaltSummary | null, 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], };
export type GroupSummary = { term: string, role: string, };
export type HaltSummary = { body: string, time: number, };
export type HandleSummary = { name: string, role: string, 
/**
 * Whether pressing it without a drag has an effect.
 */
pressed: boolean, };
export type IdentitySummary = { terms: [string, string], sum: number, };
export type InflectionHere = { link: string, diameter: number | null, reason: import("assur/core/problem.js").Problem | null, };
export type JudgedSummary = { mobility: number, rank: number, redundant: number, redundancies: Array<RedundancySummary>, idle: Array<Array<string>>, 
/**
 * W in a nearby pose.
 */
generic: number | null, 
/**
 * Whether there is no nearby pose, though W is not 0.
 */
instantaneous: boolean, };
export type LeftOutSummary = { values: [number, number], holds: boolean, };
export type LegHere = { kind: "turning" | "normal" | "tangential" | "sliding" | "coriolis" | "relative", length: number, 
/**
 * Whether its length is known before the point is found.
 */
known: boolean, };
export type LimitSummary = { input: number, value: number, };
export type LinkHere = { link: string, 
/**
 * Its distance from the place, in the unit of the lengths.
 */
off: number, 
/**
 * The wheel at the place, a ring only on its rim.
 */
wheel: string | null, };
export type LinkageSummary = { dimensions: Array<DimensionSummary>, 
/**
 * The links that can drive it, by turning or sliding.
 */
drivers: Array<string>, rates: Array<RateSummary>, equations: Array<EquationSummary>, four_bars: Array<FourBarSummary>, transmissions: Array<TransmissionSummary>, points: Array<string>, profile: ProfileSummary | null, 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], bounds: [number, number, number, number], counts: CountsSummary, 
/**
 * Passive wheels, whose meshes repeat what others do.
 */
passive: Array<string>, 
/**
 * The pairs with a redundant constraint; none if passive wheels are the only redundancy.
 */
redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type ListedSummary = { name: string, 
/**
 * `angle`, `load_angle`, `x`, `y`, `transmission`, `pressure`, `distance`, `corner` or `between`.
 */
what: "angle" | "load_angle" | "x" | "y" | "transmission" | "pressure" | "distance" | "corner" | "between", of: Array<string>, 
/**
 * The number that denotes the angle.
 */
number: string | null, role: string, };
export type LoopSummary = { cut: string, pairs: Array<string>, constraints: number, spatial_constraints: number, motion_space: number, redundant: number, };
export type MarkLayout = { role: string, kind: "max" | "min" | "zero", phi: number, value: number, };
export type MeetingPlace = { kind: "fold" | "crossing", branches: [number, number], input: number, output: number, };
export type MendedSummary = { list: Array<Array<ChangedPair>>, 
/**
 * Whether the list is complete.
 */
complete: boolean, };
export type MixerSummary = { 
/**
 * The ratios of the peripheral wheels to the rocker.
 */
ratios: Array<number>, 
/**
 * Pairs of peripheral wheels that would overlap.
 */
overlaps: Array<[number, number]>, 
/**
 * The direction from wheel 4 with the most room.
 */
free_direction: number, equations: Array<EquationSummary>, four_bars: Array<FourBarSummary>, transmissions: Array<TransmissionSummary>, points: Array<string>, profile: ProfileSummary | null, 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], bounds: [number, number, number, number], counts: CountsSummary, 
/**
 * Passive wheels, whose meshes repeat what others do.
 */
passive: Array<string>, 
/**
 * The pairs with a redundant constraint; none if passive wheels are the only redundancy.
 */
redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type MobilitySummary = { links: number, one_freedom: number, two_freedoms: number, mobility: number, passive: number, };
export type MotionSummary = { equations: Array<EquationSummary>, four_bars: Array<FourBarSummary>, transmissions: Array<TransmissionSummary>, points: Array<string>, profile: ProfileSummary | null, 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], bounds: [number, number, number, number], counts: CountsSummary, 
/**
 * Passive wheels, whose meshes repeat what others do.
 */
passive: Array<string>, 
/**
 * The pairs with a redundant constraint; none if passive wheels are the only redundancy.
 */
redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type MotionsMap = { 
/**
 * The link by whose angle assemblies are numbered.
 */
output: string, branches: Array<BranchLine>, meetings: Array<MeetingPlace>, circuits: number, 
/**
 * Whether all branches were found, each followed to its ends.
 */
whole: boolean, };
export type Movement = { field: string, by: number, };
export type OutputSummary = { name: string, searched: boolean, swing: Array<Between | null>, turns: Array<number>, limits: Array<LimitSummary>, time_ratio: number | null, };
export type PairSummary = { name: string, freedoms: number, constraints: number, spatial_freedoms: number, 
/**
 * The cuts of this pair if it is cut: itself, or one link of a compound hinge.
 */
cuts: Array<string>, };
export type PanelLayout = { order: 0 | 1 | 2, kind: "angle" | "length", physical: boolean, differenced: boolean, left: number, top: number, width: number, height: number, x0: number, x1: number, y0: number, y1: number, xticks: Array<TickLayout>, yticks: Array<TickLayout>, series: Array<SeriesLayout>, marks: Array<MarkLayout>, points: Array<number>, };
export type PhaseSummary = { kind: "rise" | "dwell" | "return", arc: [number, number], };
export type PlaneSummary = { 
/**
 * Minimum and maximum of both lengths.
 */
bounds: [number, number], values: Array<Array<number>>, };
export type PolygonPictureHere = { 
/**
 * The display list, and the names to which its labels refer.
 */
list: Array<number>, names: Array<string>, 
/**
 * Left, bottom, right, top.
 */
bounds: [number, number, number, number], 
/**
 * Length of the scale bar.
 */
bar: number, 
/**
 * Factor by which the scale is smaller than usual in the motion: 1, unless the polygon would not fit.
 */
smaller: number, };
export type PolygonStepHere = { 
/**
 * Kind of step: the pole, an equation, points by the image of their link, points of a group other than a dyad.
 */
kind: "pole" | "equation" | "image" | "group", 
/**
 * The unknown point of an equation and its reference point.
 */
target?: string | null, from?: string | null, 
/**
 * The number of the link that has both, or the line; 0 of the frame.
 */
link?: string | null, 
/**
 * Terms added to its velocity and to its acceleration.
 */
legs: [Array<LegHere>, Array<LegHere>], 
/**
 * The points found by this step, each with the magnitudes of its velocity and acceleration.
 */
found: Array<FoundHere>, };
export type PolygonsHere = { 
/**
 * Steps of the construction, the same for both polygons.
 */
steps: Array<PolygonStepHere>, 
/**
 * Pictures of the velocity and acceleration polygons, after the requested number of steps.
 */
pictures: [PolygonPictureHere, PolygonPictureHere], };
export type PrintedSummary = { 
/**
 * l₁, l₂, l₃.
 */
lengths: [number, number, number], 
/**
 * ΣJ of these lengths and of the drawn linkage: dimensionless, since J is of zᵢ = lᵢ/l₀.
 */
least: number, drawn: number, };
export type ProfileSummary = { 
/**
 * Width of the band, degrees or in the unit of the lengths.
 */
width: number, 
/**
 * Stroke from minimum to maximum; none if the output turns on and on.
 */
stroke: number | null, dwell: DwellSummary | null, phases: Array<PhaseSummary>, };
export type PullSummary = { value: number, max: number, };
export type RateSummary = { field: string, link: string, rate: number, role: string, };
export type RatioSummary = { name: string, of: number, to: number, held: number, numerator: number, denominator: number, value: number, 
/**
 * Whether it is the largest positive one.
 */
largest: boolean, };
export type ReachedSummary = { arc: number, stroke: number, residual: number, singularity_margin: number, };
export type RedundancySummary = { count: number, pairs: Array<string>, };
export type RelationHere = { item: string, name: string, 
/**
 * Whether it is an angle, radians.
 */
angle: boolean, 
/**
 * Whether it is an angle of rotation, of which whole turns count.
 */
turned: boolean, 
/**
 * Whether it is a count, and so a whole number.
 */
count: boolean, value: number, 
/**
 * The value by the relation as printed; none if that divides by zero.
 */
printed: number | null, };
export type SchemeSummary = { 
/**
 * Always null.
 */
moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, planar: boolean, 
/**
 * Names of the links, the ground first.
 */
links: Array<string>, pairs: Array<PairSummary>, counts: CountSummary, mobility: number, redundant: number, 
/**
 * q by (6), if it applies.
 */
redundant_by_plane: number | null, 
/**
 * The result of the cuts, if they open every contour.
 */
sections: SectionsSummary | null, 
/**
 * The pairs of a contour that is still closed.
 */
closed: Array<string>, 
/**
 * Links joined to nothing after the cuts.
 */
apart: Array<string>, 
/**
 * Cuts that open every contour.
 */
automatic: Array<string>, plane: JudgedSummary | null, space: JudgedSummary | null, 
/**
 * A pair with too few data for the rank.
 */
missing: string | null, mended: MendedSummary | null, };
export type SectionsSummary = { cuts: Array<string>, 
/**
 * Remaining pairs: i, and their number.
 */
left: Array<ClassSummary>, open: number, removed: number, open_spatial: number, removed_spatial: number, mobility: number, redundant: number, by_loops: number, loops: Array<LoopSummary>, };
export type SeriesLayout = { name: string, 
/**
 * The number that denotes the angle, if it has one.
 */
number: string | null, role: string, 
/**
 * The value of the curve if it is constant.
 */
level: number | null, };
export type ShaftNumbers = { sun: number, carrier: number, ring: number, };
export type SolutionSummary = { 
/**
 * l₁, l₂, l₃.
 */
lengths: [number, number, number], 
/**
 * φ₂₀ and φ₃₀, radians.
 */
starts: [number, number], 
/**
 * The greatest gap at the coupler over the positions.
 */
gap: number, 
/**
 * l₀²ΣJ, in squares of the unit of lengths.
 */
sum: number, 
/**
 * Maximum error of the output angle, radians; none if a position is not reached.
 */
output_error: number | null, 
/**
 * Whether a length is at a bound of the search.
 */
at_bound: boolean, verdict: VerdictSummary | null, };
export type StepSummary = { judged: number, accepted: boolean, before: number, reached: ReachedSummary, end: "fulfilled" | "settled" | null, document: Partial<LinkageDocument> | null, };
export type StructureSummary = { bounds: [number, number, number, number], counts: CountsSummary, 
/**
 * Passive wheels, whose meshes repeat what others do.
 */
passive: Array<string>, 
/**
 * The pairs with a redundant constraint; none if passive wheels are the only redundancy.
 */
redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type SuggestionSummary = { z1: number, z2: number, z2_step: number | null, z4: number, };
export type SweepColumn = { 
/**
 * Name as in all tables: `rocker.dangle`.
 */
name: string, 
/**
 * None if the name is sufficient.
 */
quantity: SweepQuantity | null, };
export type SweepDimension = { kind: "length" | "x" | "y", 
/**
 * Names of two points, as in `A-B`, or of one.
 */
of: string, value: number, };
export type SweepQuantity = { kind: "angle" | "x" | "y" | "distance" | "corner" | "between" | "transmission" | "pressure" | "radius" | "centre_x" | "centre_y", of: string, order: number, };
export type SweepRow = { 
/**
 * Degrees of a crank, otherwise in the unit of the lengths.
 */
input: number, values: Array<number | null>, reason: { readonly code: string } | null, };
export type SweepTable = { dimensions: Array<SweepDimension>, columns: Array<SweepColumn>, rows: Array<SweepRow>, 
/**
 * Table of the compared mechanism at the same inputs.
 */
compared: SweepTable | null, };
export type SynthesisSummary = { 
/**
 * Source of the solutions.
 */
from: "family" | "exact" | "found" | "trial", 
/**
 * The numbered solutions in the order of their numbers.
 */
solutions: Array<SolutionSummary>, 
/**
 * Their numbers, from 1, in the order in which they are shown.
 */
shown: Array<number>, 
/**
 * Whether the output's angles are probably given in the opposite sense.
 */
turned: boolean, 
/**
 * Number of the drawn solution, from 1.
 */
number: number | null, drawn: SolutionSummary, 
/**
 * l₀.
 */
frame: number, family: FamilySummary | null, found: FoundSummary | null, wanted: Array<WantedSummary>, 
/**
 * Number of positions that can be closed, over l₁ and l₂.
 */
closed: PlaneSummary, 
/**
 * Result of the paper's method, if the document gives every coupler angle.
 */
printed: PrintedSummary | null, 
/**
 * Result of Levitsky's quadratic approximation.
 */
weighted: WeightedSummary | null, 
/**
 * Error of the drawn linkage against the wanted function, if the document has one.
 */
function: FunctionSummary | null, 
/**
 * The drawn solution, as a linkage for the simulator.
 */
linkage: { kind: "linkage", document: LinkageDocument }, equations: Array<EquationSummary>, four_bars: Array<FourBarSummary>, transmissions: Array<TransmissionSummary>, points: Array<string>, profile: ProfileSummary | null, 
/**
 * Kind of input: `angle`, `length` or `time`.
 */
moves: "angle" | "length" | "time", 
/**
 * The number that denotes the input.
 */
input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, outputs: Array<OutputSummary>, 
/**
 * The reason why extrema over the motion were not searched, if so: outputs then have only a name.
 */
unsearched: UnsearchedSummary | null, 
/**
 * The numbers of links, which denote their angles.
 */
numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/**
 * Groups of quantities that can be plotted together, by the name of the choice.
 */
overviews: Array<string>, plotted: Array<string>, 
/**
 * The quantities of the curves on the plots: those, or the ones plotted against each other.
 */
curves: Array<string>, handles: Array<HandleSummary>, 
/**
 * Whether points of its links can be traced.
 */
traceable: boolean, 
/**
 * Other kinds of document into which it can be converted.
 */
becomes: readonly "scheme"[], bounds: [number, number, number, number], counts: CountsSummary, 
/**
 * Passive wheels, whose meshes repeat what others do.
 */
passive: Array<string>, 
/**
 * The pairs with a redundant constraint; none if passive wheels are the only redundancy.
 */
redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type TheoremSummary = { number: number, conditions: boolean, truth: boolean, };
export type TickLayout = { value: number, at: number, };
export type TrainConditionSummary = { kind: string, left: number, relation: string, right: number, met: boolean, 
/**
 * Whether gears with profile shift may still be built.
 */
shifted: boolean, };
export type TransmissionSummary = { what: "transmission" | "pressure", joint: string, links: [string, string], worst: number | null, input: number | null, };
export type UnsearchedSummary = { turns: number, most: number, };
export type VelocitySummary = { sun: [number, number], centre: [number, number], ring: [number, number], instantaneous_centre: number | null, };
export type VerdictSummary = { passage: "continuous" | "through_change_point" | "across_dead_point" | "other_circuit" | "unreached", order: "growing" | "falling" | "either" | "mixed", grashof: string, turns: boolean, 
/**
 * Radians.
 */
transmission: number, transmission_between: number | null, size_ratio: number, };
export type WantedSummary = { 
/**
 * φ₂ and φ₃ with their starts, and φ₁ of the drawn linkage, radians.
 */
output: number, input: number, coupler: number, 
/**
 * Gap of the contour at the coupler.
 */
error: number, 
/**
 * The main equation: its left side, Z, e₀·e₂/z₃ and e₀·e₃/z₂.
 */
equation: [number, number, number, number], 
/**
 * φ₁ at which the conditions are evaluated, and the gap of the contour with the coupler at
 * this angle.
 */
at: number, open: number, conditions: Array<ConditionSummary>, theorems: Array<TheoremSummary>, 
/**
 * The condition that theorem 5 leaves out.
 */
pair: LeftOutSummary | null, 
/**
 * Ranges of l₁ in which l₂ and l₃ are positive: null if there is none, or no maximum; null
 * altogether where (13) fails.
 */
ranges: [[number, number | null] | null, [number, number | null] | null] | null, 
/**
 * Range of l₁ in which all lengths are positive: null if there is none, or no maximum.
 */
interval: [number, number | null] | null, };
export type WeightedSummary = { 
/**
 * l₁, l₂, l₃.
 */
lengths: [number, number, number], 
/**
 * ΣJ of these lengths, with the best coupler angles, and of the drawn linkage: dimensionless.
 */
sum: number, drawn: number, };
export type Wishes = { 
/**
 * Minimum arc of the crank over which the output dwells, radians.
 */
arc: number, 
/**
 * Stroke of the output, from minimum to maximum: radians, or in the unit of the lengths.
 */
stroke: number, movable: Array<Movement>, };
