// Written by the tests of this crate from its Rust: see src/types.rs.
import { Mend } from "assur/types/edit.js";
import { Document, DocumentOf, Frozen, HingeDocument, KindDocument, LessonDocument, LinkageDocument, Only, PictureDocument, Problem, TracingDocument, View } from "assur/types/file.js";
export type Kind = Document["kind"];
export type Summary = Summaries[Kind];
export type State<K extends Kind = Kind> = K extends Kind ? Frozen<DocumentOf<K> & { format: 2, view?: View, lesson?: LessonDocument, compared?: Document, picture?: PictureDocument }> : never;
export type Fields<K extends Kind = Kind> = K extends Kind ? Partial<DocumentOf<K>["document"]> : never;
export type Changed = { document?: Fields, input?: number };
export type Traced = { document: Fields & { tracers: { name?: string, link: string }[] } };
export type Imported = { read: Document, left_out: Problem[] };
export type Summaries = { draft: DraftSummary, "gear-train": GearTrainSummary, linkage: LinkageSummary, mixer: MixerSummary, "point-path": PathSummary, poses: PosesSummary, scheme: SchemeSummary, synthesis: SynthesisSummary };
export type ActingHere = { symbol: string, couple: boolean, 
/** Components of the force; null if indeterminate, and for a couple. */ x: number | null, y: number | null, 
/** Magnitude of the force, or the couple; null if indeterminate. */ size: number | null, 
/** Direction of the force from the x-axis, radians. */ direction: number | null, };
export type AddendHere = { symbol: string, 
/** Number of an unknown; null for a given force or couple. */ unknown: number | null, 
/** Direction of the force in its sense, radians from the x-axis; null for a couple. */ direction: number | null, 
/** Factors in ΣX, ΣY and ΣM; the last is the arm with the sign of its moment, or the sense of a couple. */ factors: [number, number, number], 
/** Size in this sense, in N or N·m; null if indeterminate. */ size: number | null, 
/** Whether the signs given for ΣX, ΣY and ΣM are right; null where none is given. */ signs: [boolean | null, boolean | null, boolean | null], 
/** Whether the given arm is right; null if none is given. */ arm: boolean | null, };
export type AgainstLayout = { left: number, top: number, width: number, height: number, x: AxisLayout, y: AxisLayout, physical: boolean, role: string, 
/** Visible pieces of the curve. A point is three numbers: x and y in CSS pixels, then the input. */ curve: Array<Array<number>>, };
export type AloneSummary = { 
/** Always null: a task alone has no motion. */ moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, 
/**
 * Inputs at which the shown linkage meets the poses, radians or in the unit of lengths; null if it does not meet the
 * pose. Empty without a linkage.
 */
met: Array<number | null>, special: SpecialSummary | null, 
/** Numbers of the poses, from 1, that equal an earlier one. */ repeated: Array<number>, dyads: Array<GuideSummary>, 
/** A hinge of each shown dyad that chooses it; empty if the poses leave no choice. */ hinges: readonly HingeDocument[], 
/** Number of dyads that are complex, of five poses. */ complex: number, 
/** Whether no dyad is missing. Up to four poses leave more dyads than can be listed. */ complete: boolean, 
/** Number of coordinates of a dyad that the poses leave free. */ freedoms: number, 
/** The pairs of dyads, in numerical order. */ pairs: Array<DyadPairSummary>, 
/** Numbers of the pairs, from 1, the best first. */ ranking: Array<number>, 
/** Number of the shown pair, from 1; null if there is none. */ number: number | null, 
/** The reasons why the shown pair is no linkage; empty if it is one. */ reasons: readonly Problem[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type AppliedHere = { kind: "weight" | "inertia" | "load" | "spring" | "damper" | "friction", 
/** Index of the load, spring, damper or friction in its list. */ index: number | null, link: string, x: number, y: number, 
/** Magnitude of the force. */ value: number, 
/** Couple, positive counter-clockwise. */ couple: number, };
export type AssembliesHere = { 
/** Assemblies in ascending order of `angle`. */ all: Array<AssemblyHere>, 
/**
 * Index of the assembly in which the document moves; none if the document has no pose at this input, or if this
 * assembly was not found.
 */
shown: number | null, 
/**
 * Number of all solutions, real and complex, of the Assur group that was solved over the complex numbers. It is
 * given only if exactly one such group was solved, and only once.
 */
complex: number | null, 
/** Whether all assemblies were found. */ whole: boolean, };
export type AssemblyHere = { 
/** Number by which the page shows and chooses the assembly. A mixer has its own numbering. */ number: number, 
/** Angle of the link by which assemblies are numbered, in [0, 2π); 0 if there is no such link. */ angle: number, 
/** Poses of the bodies, in the format of a frame of the animation. */ bodies: Array<number>, };
export type AtlasCell = { 
/** Lengths of coupler, rocker and frame; the crank is 1. */ lengths: [number, number, number], 
/** Grashof type; null if the lengths form no linkage. */ grashof: string | null, 
/** Minimum transmission angle of the motion, radians. */ transmission: number | null, 
/** From 0, a curve of the shape of the path, to 1. */ unlikeness: number | null, 
/** Coordinates of the places of the curve, x and y in turn. */ curve: Array<number>, };
export type AtlasHere = { 
/** Lengths on the axes, to the right and upwards, with their common range relative to the crank. */ axes: [AtlasRatio, AtlasRatio], range: [number, number], 
/** Number of values on each axis, at equal steps of the logarithm. The first axis runs fastest. */ count: number, cells: Array<AtlasCell>, };
export type AtlasPage = { 
/** The length that is not on an axis, and its ratio to the crank. */ third: AtlasRatio, ratio: number, 
/** The coupler point: shares of the coupler's length along it and to its left. */ point: [number, number], };
export type AtlasRatio = "coupler" | "rocker" | "frame";
export type AxisLayout = { 
/** Name of the quantity; none for the input. */ name: string | null, 
/** The subscript in the symbol of the quantity, such as 2 in φ₂; none if the quantity is not an angle. */ number: string | null, order: 0 | 1 | 2, kind: "angle" | "length" | "force" | "torque", from: number, to: number, ticks: Array<TickLayout>, };
export type Belonging = { 
/** For each assembly, in the order of their numbers, the index of its branch. */ branches: Array<number>, 
/**
 * For each assembly, indices of the meetings of branches on the way to it from the chosen assembly. Empty if both
 * are on the same branch; null if the assembly cannot be reached.
 */
reached: Array<Array<number> | null>, };
export type Between = { min: number, max: number, stroke: number, };
export type BodyNumbers = { sun: number, satellite: number, carrier: number, ring: number, };
export type BranchLine = { 
/** Index of the branch's circuit. */ circuit: number, 
/**
 * Curve, split where the input or the output wraps. Inputs and outputs alternate. Angles are in [0, 2π); the input
 * of a slide is a displacement.
 */
pieces: Array<Array<number>>, };
export type ChangedPair = { pair: string, kind: KindDocument, };
export type ChartLayout = { panels: Array<PanelLayout>, 
/** The plot of one quantity against another that replaces the panels, if it is wanted and has enough room. */ against: AgainstLayout | null, };
export type ChartRequest = { width: number, height: number, palette: Array<[number, number, number]>, 
/** Scale of text and lines; 1 for the usual size. */ scale: number, 
/** Screen pixels per CSS pixel. */ ratio: number, 
/** Whether curves pass through all their points, for a picture that may be enlarged. */ whole: boolean, 
/** The plot that takes all the room, if any. */ only: Only, 
/** The time around which the endless motion of a gear train without load is plotted. */ around: number, };
export type CircleHere = { point: string, 
/** Radius with its first two derivatives, with respect to the variable chosen for the axes: input or time. */ radius: [number, number, number] | null, centre: [number, number] | null, reason: Problem | null, };
export type ClassSummary = { freedoms: number, count: number, };
export type ConditionSummary = { 
/** Number of the condition in the paper. */ number: number, 
/** The length that the condition concerns; null for condition (13). */ about: string | null, 
/** The two numbers whose signs are compared; null if a denominator is zero. */ values: [number | null, number | null], 
/** Whether the condition holds as printed. */ holds: boolean, 
/** Whether the statement that the condition is to ensure is true, be the condition met or not. */ truth: boolean, };
export type CountSummary = { 
/** Number of moving links, n. */ links: number, 
/** Numbers Pᵢ of pairs with i freedoms, in the scheme's own space. */ pairs: Array<ClassSummary>, 
/** Numbers Pᵢ of pairs with i freedoms, in three-dimensional space. */ spatial_pairs: Array<ClassSummary>, planar: number | null, spatial: number, };
export type CountsSummary = { links: number, lower: number, higher: number, mobility: number, by_count: number, };
export type CourseSummary = { 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], };
export type CurvatureHere = { circles: Array<CircleHere>, inflection: InflectionHere | null, };
export type CycleHere = { 
/** Mean rate of the methods. */ rate: number, 
/** Torque of the drive at this rate, N·m. */ torque: number, 
/** Points of Wittenbauer's diagram: input, reduced moment of inertia without flywheel (kg·m²), energy (J). */ diagram: Array<[number, number, number]>, given: WheelHere, wittenbauer: WheelHere, 
/** Slopes of the two tangents, 1/s². */ slopes: [number, number], 
/** Their intercepts on the axis of energies, J. */ intercepts: [number, number], 
/** Their points on the diagram, like its points. */ touches: [[number, number, number], [number, number, number]], mertsalov: WheelHere, 
/** Greatest difference of the energy of the links with a constant reduced inertia, J, and this inertia, kg·m². */ difference: number, constant: number, };
export type CycleSummary = { start: number, end: number, full: boolean, arcs: Array<[number, number]>, };
export type CycleSummaryHere = { 
/** Coefficient of non-uniformity. */ delta: number, mean: number, 
/** Rates of least and of greatest magnitude. */ extremes: [number, number], 
/** Duration, s. */ time: number, 
/** Points of the cycle, each with time, input, rate, acceleration and kinetic energy, J. */ points: Array<[number, number, number, number, number]>, };
export type DeadPointSummary = { input: number, kind: string, links: Array<string>, };
export type DimensionSummary = { field: string, kind: "length" | "side" | "corner" | "offset" | "x" | "y", index: number, name: string, points: Array<string>, role: string, value: number, min: number, max: number, step: number, };
export type DraftSummary = { 
/** Always null: a drawing has no motion. */ moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, 
/** Mobility W by count; none if the drawing could move, or if a defect of the drawing prevents counting. */ mobility: number | null, 
/** Numbers of links and pairs; none if a defect of the drawing prevents counting. */ counts: CountsSummary | null, drivers: number, 
/** Every reason why the drawing does not move. */ reasons: readonly Problem[], loose: Array<string>, locked: Array<string>, mends: readonly Mend[], };
export type Drawn = { 
/** The point that was used or added last. */ point: string | null, 
/** The link that was added last. */ link: string | null, 
/** Whether locked lengths or angles kept the edit from reaching its target. */ held: boolean, };
export type DriveHere = { 
/** Name of the quantity that can be plotted: `crank.torque` or `slider.force`. */ name: string, link: string, kind: "torque" | "force", value: number | null, };
export type DwellSummary = { arc: [number, number], band: [number, number], };
export type DyadPairSummary = { 
/** Numbers of the dyads, from 1, the driving one first. */ dyads: [number, number], 
/** Whether the pair passes through all poses without a break, in order. */ sound: boolean, verdict: GuidanceVerdict | null, };
export type EquationSummary = { "kind": "distance", link: string, points: [string, string], } | { "kind": "offset", link: string, points: [string, string, string], } | { "kind": "direction", link: string, on: string, } | { "kind": "mesh", links: [string, string], carrier: string, teeth: [number, number], };
export type EquilibriumHere = { 
/** Points about which moments can be taken: those of the link first. */ points: Array<string>, addends: Array<AddendHere>, 
/** The link with the unknowns in the chosen senses, all equally long. */ picture: ForcePictureHere, };
export type FamilyCurve = { l2: Array<number>, l3: Array<number>, verdicts: ("turns" | "rocks" | "disorder" | "branch")[], };
export type FamilySummary = { 
/** Minimum and maximum of l₁ (coupler), l₂ (output) and l₃ (input); a null maximum means no limit. */ lengths: [[number | null, number | null], [number | null, number | null], [number | null, number | null]], 
/** Range of the coupler's angle in each position, radians. */ couplers: [[number, number], [number, number]], curve: FamilyCurve, 
/** l₁, l₂, l₃ at each change of the Grashof type. */ changes: Array<[number, number, number]>, };
export type ForcePictureHere = { 
/** Display list. */ list: Array<number>, 
/** Names to which the labels of the list refer. */ names: Array<string>, 
/** Rectangle of the picture in the coordinates of `list`: left, bottom, right, top. */ bounds: [number, number, number, number], 
/** Force that a unit of these coordinates stands for in a plan to scale; null for a drawing of links. */ scale: number | null, };
export type ForcePlanHere = { 
/** False if nothing acts on the links, so that there is nothing to draw. */ loaded: boolean, steps: Array<ForceStepHere>, 
/** Picture of the last of the requested steps: its plan with the steps before it or, for a sum of moments, its links. */ picture: ForcePictureHere, };
export type ForceStepHere = { kind: "moments" | "along" | "polygon" | "group" | "indeterminate", 
/** Number of the plan in which the step is drawn. */ plan: number, 
/** Numbers of the links in equilibrium. */ links: Array<string>, 
/** Name of the pair about which moments are taken, or of the slide along whose line components are taken. */ about: string | null, terms: Array<ForceTermHere>, 
/** Symbols of what is statically indeterminate. */ open: Array<string>, };
export type ForceTermHere = { symbol: string, couple: boolean, 
/** False if this step finds it. */ known: boolean, 
/** Magnitude of the force, or the couple. */ size: number, 
/** Direction of the force from the x-axis, radians. */ direction: number, 
/** Moment, or component along the line. */ value: number, 
/** Arm of the force, in the unit of lengths; null if there is none. */ arm: number | null, };
export type ForcesHere = { reactions: Array<ReactionHere>, drives: Array<DriveHere>, applied: Array<AppliedHere>, shaking: ShakingHere, 
/** Power that friction takes, W; none without friction. */ lost: number | null, 
/**
 * Efficiency of the first driver; none without friction, and if the driver does no work. Not positive: the loads cannot
 * drive the linkage back.
 */
efficiency: number | null, };
export type FoundHere = { name: string, rates: [number, number], };
export type FoundSummary = { 
/** Number of starting points. */ starts: number, 
/** Number of starts that ended in the solution shown first. */ best: number, 
/** l₂ and l₃ along the path from each start. */ paths: Array<Array<[number, number]>>, 
/** Decimal logarithm of ΣJ as a function of l₂ and l₃. */ sum: PlaneSummary, };
export type FoundTracing = { linkage: TracingDocument, 
/** Greatest distance between path and curve. */ greatest: number, 
/** Root of the mean square of the distances; null if it was not computed. */ root_mean_square: number | null, verdict: TracingVerdict | null, 
/** Number of the coupler curve among those through nine points, from 1; its cognates share it. */ curve: number | null, };
export type FourBarSummary = { links: [string, string, string, string], grashof: string, };
export type FreeBodyHere = { 
/** Numbers and names of the links that can be chosen. */ links: Array<[string, string]>, acting: Array<ActingHere>, picture: ForcePictureHere, };
export type FunctionSummary = { 
/** Values of x at equal steps, each with the error of y; null if the linkage does not reach x. */ curve: Array<[number, number | null]>, 
/** Value of x with the greatest error, and this error; none if the linkage reaches no part of the interval. */ greatest: [number, number] | null, 
/** Whether the linkage covers the whole interval without a break. */ complete: boolean, };
export type GearTrainSummary = { bounds: [number, number, number, number], roles: { [key in string]: string }, 
/** The shaft that is not driven. */ free: string, speeds: BodyNumbers, 
/** Weights a and b in Willis's equation, a ω₁ + b ω₄ = (a + b) ω₃. */ weights: [number, number], ratios: Array<RatioSummary>, identities: Array<IdentitySummary>, conditions: Array<TrainConditionSummary>, 
/** Whether all conditions are met. */ builds: boolean, 
/** Similar trains that can be built; empty if this train can be built. */ suggestions: Array<SuggestionSummary>, 
/**
 * For a planar train: number of teeth z₂ of the satellite that fits between gears with these z₁ (sun) and z₄
 * (ring), if there is one.
 */
in_contact: number | null, mobility: MobilitySummary, 
/** Gaps between pitch circles of magnets at sun and ring, mm; null for gears in contact and bevel wheels. */ gaps: [number, number] | null, axis_distance: number, 
/**
 * Distances (mm) and velocities (mm/s) of points of the first satellite, at the final speeds of the shafts; null
 * for bevel wheels.
 */
velocities: VelocitySummary | null, 
/** External torques on the shafts, neglecting losses, as multiples of the torque on the sun. */ torques: ShaftNumbers, 
/** Power that each shaft takes in: its value in `torques` times its speed in revolutions per minute. */ powers: ShaftNumbers, 
/**
 * Greatest static torque that the magnets can hold on each body, N·m, with the other shafts held; for the
 * satellites, on all of them together.
 */
limits: BodyNumbers | null, 
/** Natural frequencies of the meshes with sun and ring, Hz. */ swings: [number, number] | null, 
/** The greatest torque of the load, and its upper limit, N·m. */ load: PullSummary | null, 
/** Slips of the meshes with sun and ring at the end of a run, in periods of the field. */ slips: [number, number] | null, halt: HaltSummary | null, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], };
export type GreatestForces = { greatest: Array<GreatestHere>, 
/**
 * Number of poses in which they are sought, and in how many of these friction holds the linkage whatever the
 * driver does, so that there are no reactions.
 */
poses: number, locked: number, };
export type GreatestHere = { 
/** Name of the quantity. */ name: string, 
/** Its value with the greatest magnitude; none if it is statically indeterminate everywhere. */ value: number | null, 
/** The input at which it is reached: radians of a crank, otherwise in the unit of lengths. */ input: number, };
export type GroupSummary = { term: string, role: string, };
export type GuidanceVerdict = { mechanism: "four_bar" | "slider_crank" | "inverted_slider_crank" | "double_slider" | "slider_block" | "double_block", 
/** Grashof type of a four-bar. */ grashof: string | null, passage: "continuous" | "through_change_point" | "across_dead_point" | "other_circuit" | "unreached", order: "growing" | "falling" | "either" | "mixed", turns: boolean, 
/** Minimum transmission angle from the first pose to the last, radians. */ transmission: number | null, size_ratio: number, };
export type GuideSummary = { code: "RR" | "PR" | "RP", 
/** Centre point; null for a slider on the frame. */ centre: [number, number] | null, 
/** Circle point in the first pose; null for a block. */ point: [number, number] | null, 
/** Circle point in the body's own coordinates; null for a block. */ own: [number, number] | null, 
/** Greatest distance by which a pose is missed. */ residual: number, };
export type GuidedSummary = { four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, 
/**
 * Inputs at which the shown linkage meets the poses, radians or in the unit of lengths; null if it does not meet the
 * pose. Empty without a linkage.
 */
met: Array<number | null>, special: SpecialSummary | null, 
/** Numbers of the poses, from 1, that equal an earlier one. */ repeated: Array<number>, dyads: Array<GuideSummary>, 
/** A hinge of each shown dyad that chooses it; empty if the poses leave no choice. */ hinges: readonly HingeDocument[], 
/** Number of dyads that are complex, of five poses. */ complex: number, 
/** Whether no dyad is missing. Up to four poses leave more dyads than can be listed. */ complete: boolean, 
/** Number of coordinates of a dyad that the poses leave free. */ freedoms: number, 
/** The pairs of dyads, in numerical order. */ pairs: Array<DyadPairSummary>, 
/** Numbers of the pairs, from 1, the best first. */ ranking: Array<number>, 
/** Number of the shown pair, from 1; null if there is none. */ number: number | null, 
/** The reasons why the shown pair is no linkage; empty if it is one. */ reasons: readonly Problem[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type HaltSummary = { body: string, time: number, };
export type HandleSummary = { name: string, role: string, 
/** Whether pressing the handle without a drag has an effect. */ pressed: boolean, };
export type Here = { 
/** Number of bodies; x, y and angle of each; then a display list of all shapes that are not rigid. */ frame: Float32Array, 
/** x and y of each handle of the summary. */ handles: Float64Array, 
/** Values of the read-outs that `readouts` names, in its order; empty if derivatives are unbounded. */ readouts: Float64Array, 
/**
 * For each series of the plots, its value and first two derivatives, or abscissa and ordinate if one quantity is
 * plotted against another; empty if derivatives are unbounded.
 */
plotted: Float64Array, };
export type IdentitySummary = { terms: [string, string], sum: number, };
export type InflectionHere = { link: string, diameter: number | null, reason: Problem | null, };
export type JudgedSummary = { mobility: number, rank: number, redundant: number, redundancies: Array<RedundancySummary>, idle: Array<Array<string>>, 
/** W in a nearby pose, if one was found; also 0 if W is 0 in the drawn pose. */ generic: number | null, 
/** Whether the scheme moves only for an instant: by rank W is not 0, but no nearby pose was reached. */ instantaneous: boolean, };
export type LeftOutSummary = { values: [number, number], holds: boolean, };
export type LegHere = { kind: "turning" | "normal" | "tangential" | "sliding" | "coriolis" | "relative", length: number, 
/** Whether the length of the vector is known before the point is found. */ known: boolean, };
export type LeverHere = { terms: Array<ForceTermHere>, 
/** Sum of the moments about the pole. */ sum: number, 
/** Symbol of the balancing torque or force. */ symbol: string, 
/** Whether a torque balances the lever, not a force. */ turns: boolean, 
/** Balancing torque or force by the lever; null if there are several drivers. */ by_lever: number | null, 
/** The same by the reactions; null if it is indeterminate. */ by_reactions: number | null, picture: ForcePictureHere, };
export type LimitSummary = { input: number, value: number, };
export type LinkHere = { link: string, 
/** Distance of the link from the place, in the unit of the lengths. */ off: number, 
/** The wheel at the place, if there is one; a ring counts only at its rim. */ wheel: string | null, };
export type LinkageSummary = { dimensions: Array<DimensionSummary>, 
/** Links that can drive the linkage, by rotating or sliding. */ drivers: Array<string>, rates: Array<RateSummary>, four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type ListedSummary = { name: string, 
/** `angle`, `load_angle`, `x`, `y`, `transmission`, `pressure`, `distance`, `corner` or `between`. */ what: "angle" | "load_angle" | "x" | "y" | "transmission" | "pressure" | "distance" | "corner" | "between", of: Array<string>, 
/** The subscript in the symbol of the read-out, if the read-out is an angle. */ number: string | null, role: string, };
export type LonePathSummary = { 
/** Always null: a task alone has no motion. */ moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, 
/**
 * Inputs at which the traced point is nearest to the points, radians or in the unit of lengths; null for a point that
 * the motion does not reach. Empty without a linkage.
 */
met: Array<number | null>, 
/** Distances of the points from the traced curve. */ distances: Array<number>, 
/** Diagonal of the bounding box of the path. */ size: number, 
/** The line or circle on which all points lie. */ special: "line" | "circle" | null, 
/** The shown linkage; null if there is none. */ traced: FoundTracing | null, 
/** The cognates of the shown linkage, which trace the same curve; null if it has no such cognate. */ cognates: readonly (TracingDocument | null)[], 
/** Geared five-bars that trace the same curve, for the simulator. */ geared: readonly { kind: "linkage", document: LinkageDocument }[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type LoopSummary = { cut: string, pairs: Array<string>, constraints: number, spatial_constraints: number, motion_space: number, redundant: number, };
export type MarkLayout = { role: string, kind: "max" | "min" | "zero", phi: number, value: number, };
export type MassHere = { link: string, mass: number, 
/** Moment of inertia about the centre of mass, in units of mass and of length. */ inertia: number, 
/** Centre of mass, from the first point of the link: towards the second, and to the left; in the unit of lengths. */ centre: [number, number], 
/**
 * Whether the centre of mass or the moment of inertia is given; otherwise the link is a uniform bar, or a mass at
 * its point.
 */
given: boolean, 
/** Whether the link has two points, so that it can be a uniform bar. */ bar: boolean, };
export type MeetingPlace = { kind: "fold" | "crossing", branches: [number, number], input: number, output: number, };
export type MendedSummary = { list: Array<Array<ChangedPair>>, complete: boolean, };
export type MixerSummary = { 
/** Speed ratios of the peripheral wheels to the rocker. */ ratios: Array<number>, 
/** Pairs of peripheral wheels that would overlap, as indices from 0. */ overlaps: Array<[number, number]>, 
/** Direction from wheel 4 in which another wheel has the most room, radians. */ free_direction: number, four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type MobilitySummary = { links: number, one_freedom: number, two_freedoms: number, mobility: number, passive: number, };
export type MotionSummary = { four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type MotionsMap = { 
/** Name of the link whose angle numbers the assemblies. */ output: string, branches: Array<BranchLine>, meetings: Array<MeetingPlace>, circuits: number, 
/** Whether all branches were found and each was followed to its ends. */ whole: boolean, };
export type Movement = { field: string, by: number, };
export type NinePointProgress = { 
/** Number of different coupler curves found and proved, real and complex. */ curves: number, 
/** Number of all of them for generic points. */ all: number, 
/** Number of curves that are found but not proved. */ unproved: number, 
/** Number of paths of the present work that are not yet followed. */ left: number, 
/** Whether all curves are found and proved. */ complete: boolean, };
export type OutputSummary = { name: string, searched: boolean, swing: Array<Between | null>, turns: Array<number>, limits: Array<LimitSummary>, time_ratio: number | null, };
export type PairSummary = { name: string, freedoms: number, constraints: number, spatial_freedoms: number, 
/** Names of the possible cuts of this pair: one cut, or one for each link of a compound hinge. */ cuts: Array<string>, };
export type PanelLayout = { order: 0 | 1 | 2, kind: "angle" | "length" | "force" | "torque", physical: boolean, differenced: boolean, left: number, top: number, width: number, height: number, x0: number, x1: number, y0: number, y1: number, xticks: Array<TickLayout>, yticks: Array<TickLayout>, series: Array<SeriesLayout>, marks: Array<MarkLayout>, points: Array<number>, };
export type PathSummary = TracedSummary | LonePathSummary;
export type PathTaskSummary = { 
/**
 * Inputs at which the traced point is nearest to the points, radians or in the unit of lengths; null for a point that
 * the motion does not reach. Empty without a linkage.
 */
met: Array<number | null>, 
/** Distances of the points from the traced curve. */ distances: Array<number>, 
/** Diagonal of the bounding box of the path. */ size: number, 
/** The line or circle on which all points lie. */ special: "line" | "circle" | null, 
/** The shown linkage; null if there is none. */ traced: FoundTracing | null, 
/** The cognates of the shown linkage, which trace the same curve; null if it has no such cognate. */ cognates: readonly (TracingDocument | null)[], 
/** Geared five-bars that trace the same curve, for the simulator. */ geared: readonly { kind: "linkage", document: LinkageDocument }[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type PathWork = { way: number, careful: boolean, paths: Array<number>, };
export type PhaseSummary = { kind: "rise" | "dwell" | "return", arc: [number, number], };
export type PlaneSummary = { 
/** Minimum and maximum length, the same on both axes. */ bounds: [number, number], values: Array<Array<number>>, };
export type PolygonPictureHere = { 
/** Display list. */ list: Array<number>, 
/** Names to which the labels of the list refer. */ names: Array<string>, 
/** Rectangle of the picture in the coordinates of `list`: left, bottom, right, top. */ bounds: [number, number, number, number], 
/** Velocity or acceleration that the scale bar represents. */ bar: number, 
/** Usual scale of the motion divided by the scale of this picture; 1 if the polygon fits at the usual scale. */ smaller: number, };
export type PolygonStepHere = { 
/**
 * Kind of step: the pole, a vector equation, points found by the image of their link, points of a group that is
 * not a dyad.
 */
kind: "pole" | "equation" | "image" | "group", 
/** The unknown point of the equation. */ target?: string | null, 
/** The reference point of the equation. */ from?: string | null, 
/** Number of the link with both points or, for a slide, with the line; 0 for the frame. */ link?: string | null, 
/** Terms of the sum in the equation for the velocity, and in the equation for the acceleration. */ legs: [Array<LegHere>, Array<LegHere>], 
/** The points found by this step, each with the magnitudes of its velocity and acceleration. */ found: Array<FoundHere>, };
export type PolygonsHere = { 
/** Steps of the construction, the same for both polygons. */ steps: Array<PolygonStepHere>, 
/** Pictures of the velocity and acceleration polygons, drawn up to the requested step. */ pictures: [PolygonPictureHere, PolygonPictureHere], };
export type PosesSummary = GuidedSummary | AloneSummary;
export type PrintedSummary = { 
/** Lengths l₁ (coupler), l₂ (output) and l₃ (input). */ lengths: [number, number, number], 
/** ΣJ of these lengths; dimensionless, since J is computed from zᵢ = lᵢ/l₀. */ least: number, 
/** ΣJ of the drawn linkage. */ drawn: number, };
export type ProfileSummary = { 
/** Width of the dwell band: degrees for an angle, otherwise in the unit of the lengths. */ width: number, 
/** Stroke from minimum to maximum; none if the output keeps rotating. */ stroke: number | null, dwell: DwellSummary | null, phases: Array<PhaseSummary>, };
export type PullSummary = { value: number, max: number, };
export type RateSummary = { field: string, link: string, rate: number, role: string, };
export type RatioSummary = { name: string, of: number, to: number, held: number, numerator: number, denominator: number, value: number, 
/** Whether this is the largest positive ratio. */ largest: boolean, };
export type ReachedSummary = { arc: number, stroke: number, residual: number, singularity_margin: number, };
export type ReactionHere = { 
/** Name of its magnitude among the quantities that can be plotted, such as `B.reaction`. */ name: string, 
/** The point of the hinge or slide, or the two wheels. */ pair: string, kind: "hinge" | "slide" | "mesh", 
/** The link on which it acts, and the link from which it comes; `frame` for the frame. */ on: string, from: string, 
/** Components and moment; none for what is statically indeterminate. */ x: number | null, y: number | null, moment: number | null, 
/** Magnitude of the force. */ value: number | null, 
/** Direction of the force, radians from the x-axis; none for a force of zero. */ direction: number | null, };
export type ReadoutId = { quantity: string, 
/** Order of the derivative: 0, 1 or 2. */ order: number, };
export type RedundancySummary = { count: number, pairs: Array<string>, };
export type RelationHere = { item: string, name: string, 
/** Whether the value is an angle, in radians. */ angle: boolean, 
/** Whether the value is an angle of rotation, in which whole turns count. */ turned: boolean, 
/** Whether the value is a count, which is a whole number. */ count: boolean, value: number, 
/** The value given by the relation as printed; none if this relation divides by zero. */ printed: number | null, };
export type RunHere = { 
/**
 * Readings, each of eight numbers: time, input, rate, acceleration; in joules the kinetic and potential energy, the
 * work of the motors and of the given forces, and the energy lost in resistances, dampers and friction. Then come
 * coordinate, rate and acceleration of each further driver.
 */
readings: Array<number>, 
/** Whether nothing moves any more. */ rests: boolean, 
/** Whether the motion ends at the last reading. */ ends: boolean, 
/** Whether it ends because the linkage locks itself by friction. */ locks: boolean, 
/** The end, if it is one of the motion of the linkage. */ at: DeadPointSummary | null, 
/** The reason why a motion of several freedoms ends. */ problems: readonly Problem[], };
export type SchemeSummary = { 
/** Always null: a scheme has no motion. */ moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, planar: boolean, 
/** Names of the links, the ground first. */ links: Array<string>, pairs: Array<PairSummary>, counts: CountSummary, mobility: number, redundant: number, 
/** Redundant constraints q by equation (6) of the mobility paper, if it applies. */ redundant_by_plane: number | null, 
/** The result of the cuts, if they open every contour. */ sections: SectionsSummary | null, 
/** The pairs of a contour that is still closed after the cuts. */ closed: Array<string>, 
/** Links that the cuts disconnect. */ apart: Array<string>, 
/** Names of automatically chosen cuts that open every contour. */ automatic: Array<string>, plane: JudgedSummary | null, space: JudgedSummary | null, 
/** The first pair that lacks data needed for the rank. */ missing: string | null, mended: MendedSummary | null, };
export type SectionsSummary = { cuts: Array<string>, 
/** Numbers Pᵢ of remaining pairs with i freedoms. */ left: Array<ClassSummary>, open: number, removed: number, open_spatial: number, removed_spatial: number, mobility: number, redundant: number, by_loops: number, loops: Array<LoopSummary>, };
export type SeriesLayout = { name: string, 
/** The subscript in the symbol of the quantity, such as 2 in φ₂; none if the quantity is not an angle. */ number: string | null, role: string, 
/** The value of the curve, if it is constant; radians for an angle. */ level: number | null, };
export type ShaftNumbers = { sun: number, carrier: number, ring: number, };
export type ShakingHere = { 
/** Name of its magnitude among the quantities that can be plotted. */ name: string, value: number, 
/** Direction of the force, radians from the x-axis; none for a force of zero. */ direction: number | null, 
/** Moment about the origin. */ moment: number, };
export type SolutionSummary = { 
/** Lengths l₁ (coupler), l₂ (output) and l₃ (input). */ lengths: [number, number, number], 
/** Starting angles φ₂₀ of the output and φ₃₀ of the input, radians. */ starts: [number, number], 
/** The greatest gap at the coupler over all positions, in the unit of lengths. */ gap: number, 
/** Weighted sum of the squared gaps, l₀²ΣJ, in squares of the unit of lengths. */ sum: number, 
/** Maximum error of the output angle, radians; none if a position is not reached. */ output_error: number | null, 
/** Whether a length is at a bound of the search. */ at_bound: boolean, verdict: VerdictSummary | null, };
export type SpecialSummary = { code: "still" | "rotation" | "line" | "parallelogram" | "parallel", 
/** The pole; the direction of the line; the vector from a hinge of the body to its pivot. */ at: [number, number] | null, };
export type StepSummary = { judged: number, accepted: boolean, before: number, reached: ReachedSummary, end: "fulfilled" | "settled" | null, document: Partial<LinkageDocument> | null, };
export type StillSummary = { 
/** Always null: a task alone has no motion. */ moves: null, bounds: [number, number, number, number], handles: Array<HandleSummary>, roles: { [key in string]: string }, };
export type StructureSummary = { bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type StudentSheet = { 
/** Place of the link in the list of moving links, from 0. */ link: number, 
/** Place of the point of moments among `points` of the result, from 0. */ about: number, 
/** Numbers of the unknowns whose senses are reversed. */ reversed: Array<number>, 
/** For each addend its signs −1, 0 or 1 in ΣX, ΣY and ΣM, and its arm; null where nothing is filled in. */ answers: Array<[number | null, number | null, number | null, number | null]>, };
export type SuggestionSummary = { z1: number, z2: number, z2_step: number | null, z4: number, };
export type SweepColumn = { 
/** Name of the column, as in all tables: `rocker.dangle`. */ name: string, 
/** Kind, subject and order of the quantity; none if the name is sufficient. */ quantity: SweepQuantity | null, };
export type SweepDimension = { kind: "length" | "x" | "y", 
/** Names of the two points, as in `A-B`, or of the single point. */ of: string, value: number, };
export type SweepQuantity = { kind: "angle" | "x" | "y" | "distance" | "corner" | "between" | "transmission" | "pressure" | "radius" | "centre_x" | "centre_y", of: string, order: number, };
export type SweepRow = { 
/** Input of the row: degrees for a crank, seconds for a gear train, otherwise in the unit of the lengths. */ input: number, values: Array<number | null>, reason: { readonly code: string } | null, };
export type SweepTable = { dimensions: Array<SweepDimension>, columns: Array<SweepColumn>, rows: Array<SweepRow>, 
/** Table of the compared mechanism at the same inputs. */ compared: SweepTable | null, };
export type SynthesisSummary = { 
/** Source of the drawn solution. */ from: "family" | "exact" | "found" | "trial", 
/** The numbered solutions, in numerical order; empty for a family. */ solutions: Array<SolutionSummary>, 
/** Numbers of the solutions, from 1, in the order in which they are shown. */ shown: Array<number>, 
/** Whether the output's angles were probably given in the direction from D to C, and so are off by 180°. */ turned: boolean, 
/** Number of the drawn solution, from 1; null if it belongs to a family or has trial lengths. */ number: number | null, drawn: SolutionSummary, 
/** Length of the frame, l₀. */ frame: number, family: FamilySummary | null, found: FoundSummary | null, wanted: Array<WantedSummary>, 
/** Number of positions that can be closed, as a function of l₁ (coupler) and l₂ (output). */ closed: PlaneSummary, 
/** Result of the paper's method, if the document gives every coupler angle. */ printed: PrintedSummary | null, 
/** Result of Levitsky's quadratic approximation. */ weighted: WeightedSummary | null, 
/** Error of the drawn linkage against the wanted function, if the document has one. */ function: FunctionSummary | null, 
/** The drawn solution, as a linkage for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument }, four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, };
export type TaskSummary = { 
/**
 * Inputs at which the shown linkage meets the poses, radians or in the unit of lengths; null if it does not meet the
 * pose. Empty without a linkage.
 */
met: Array<number | null>, special: SpecialSummary | null, 
/** Numbers of the poses, from 1, that equal an earlier one. */ repeated: Array<number>, dyads: Array<GuideSummary>, 
/** A hinge of each shown dyad that chooses it; empty if the poses leave no choice. */ hinges: readonly HingeDocument[], 
/** Number of dyads that are complex, of five poses. */ complex: number, 
/** Whether no dyad is missing. Up to four poses leave more dyads than can be listed. */ complete: boolean, 
/** Number of coordinates of a dyad that the poses leave free. */ freedoms: number, 
/** The pairs of dyads, in numerical order. */ pairs: Array<DyadPairSummary>, 
/** Numbers of the pairs, from 1, the best first. */ ranking: Array<number>, 
/** Number of the shown pair, from 1; null if there is none. */ number: number | null, 
/** The reasons why the shown pair is no linkage; empty if it is one. */ reasons: readonly Problem[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type TheoremSummary = { number: number, conditions: boolean, truth: boolean, };
export type TickLayout = { value: number, at: number, };
export type TracedSummary = { four_bars: Array<FourBarSummary>, points: Array<string>, 
/** Kind of input: `angle`, `length` or `time`. */ moves: "angle" | "length" | "time", 
/** The subscript in the symbol of the input, such as 1 in φ₁; empty if the input is time. */ input: string, cycle: CycleSummary, home: number, dead_points: Array<DeadPointSummary>, change_points: Array<number>, 
/** The reason why the motion was not searched for extrema; none if it was. Unsearched outputs have only a name. */ unsearched: UnsearchedSummary | null, 
/** Numbers of the links, by name: a link's number is the subscript of its angle, as in φ₂. */ numbers: { [key in string]: string }, listed: Array<ListedSummary>, 
/** Choices of the page that plot a group of quantities together, such as `angles`. */ overviews: Array<string>, plotted: Array<string>, 
/** Quantities of the drawn curves: the plotted ones, or the two plotted against each other. */ curves: Array<string>, handles: Array<HandleSummary>, 
/** Whether points of the links can be traced. */ traceable: boolean, 
/** Other kinds of document into which this document can be converted. */ becomes: readonly ("scheme" | "point-path")[], bounds: [number, number, number, number], counts: CountsSummary, 
/** Passive wheels, whose meshes repeat constraints of other meshes. */ passive: Array<string>, 
/** The pairs with a redundant constraint; empty if there are passive wheels. */ redundant: Array<string>, class: string, order: number, formula: string, groups: Array<GroupSummary>, roles: { [key in string]: string }, 
/**
 * Inputs at which the traced point is nearest to the points, radians or in the unit of lengths; null for a point that
 * the motion does not reach. Empty without a linkage.
 */
met: Array<number | null>, 
/** Distances of the points from the traced curve. */ distances: Array<number>, 
/** Diagonal of the bounding box of the path. */ size: number, 
/** The line or circle on which all points lie. */ special: "line" | "circle" | null, 
/** The shown linkage; null if there is none. */ traced: FoundTracing | null, 
/** The cognates of the shown linkage, which trace the same curve; null if it has no such cognate. */ cognates: readonly (TracingDocument | null)[], 
/** Geared five-bars that trace the same curve, for the simulator. */ geared: readonly { kind: "linkage", document: LinkageDocument }[], 
/** The shown linkage, for the simulator. */ linkage: { kind: "linkage", document: LinkageDocument } | null, };
export type TracingProgress = { 
/** Number of linkages compared so far. */ candidates: number, 
/** Whether the path is met within rounding, so that no better linkage exists. */ exact: boolean, 
/** The best linkages, if this step has found a better one; null otherwise. */ found: Array<FoundTracing> | null, };
export type TracingVerdict = { 
/** Grashof type of a four-bar. */ grashof: string | null, passage: "continuous" | "through_change_point" | "across_dead_point" | "other_circuit" | "unreached", order: "growing" | "falling" | "either" | "mixed", turns: boolean, 
/**
 * Minimum transmission angle between the points or, if the linkage does not pass through all of them, over the
 * whole motion, radians.
 */
transmission: number, size_ratio: number, };
export type TracingWishes = { 
/** Whether the root of the mean square is to be small instead of the greatest distance. */ squares: boolean, 
/** Whether four-bars are admitted. */ four_bars: boolean, 
/** Whether slider-cranks are admitted. */ slider_cranks: boolean, 
/** Whether four-bars without a link that turns fully are admitted. */ swinging: boolean, };
export type TrainConditionSummary = { kind: string, left: number, relation: string, right: number, met: boolean, 
/** Whether gears with profile shift could still meet the condition. */ shifted: boolean, };
export type TransmissionSummary = { what: "transmission" | "pressure", joint: string, links: [string, string], worst: number | null, input: number | null, };
export type UnsearchedSummary = { turns: number, most: number, };
export type VelocitySummary = { sun: [number, number], centre: [number, number], ring: [number, number], instantaneous_centre: number | null, };
export type VerdictSummary = { passage: "continuous" | "through_change_point" | "across_dead_point" | "other_circuit" | "unreached", order: "growing" | "falling" | "either" | "mixed", grashof: string, turns: boolean, 
/** Minimum transmission angle over the whole motion, radians. */ transmission: number, transmission_between: number | null, size_ratio: number, };
export type WantedSummary = { 
/** Angle φ₂ of the output, including its starting angle, radians. */ output: number, 
/** Angle φ₃ of the input, including its starting angle, radians. */ input: number, 
/** Angle φ₁ of the coupler of the drawn linkage, radians. */ coupler: number, 
/** Gap of the contour at the coupler of the drawn linkage, in the unit of lengths. */ error: number, 
/** Terms of the main equation: e₂·e₃, Z, e₀·e₂/z₃, e₀·e₃/z₂, with eᵢ the unit vectors of the links and zᵢ = lᵢ/l₀. */ equation: [number, number, number, number], 
/** Coupler angle φ₁ at which the conditions are evaluated, radians. */ at: number, 
/** Gap of the contour at the coupler angle `at`, in the unit of lengths. */ open: number, conditions: Array<ConditionSummary>, theorems: Array<TheoremSummary>, 
/** The condition omitted by theorem 5; null if coupler and output are parallel. */ pair: LeftOutSummary | null, 
/**
 * The range of l₁ in which l₂ is positive, and the range in which l₃ is positive; null if condition (13) fails. A
 * null range is empty; a null maximum means no limit.
 */
ranges: [[number, number | null] | null, [number, number | null] | null] | null, 
/** Range of l₁ for which all lengths are positive, null if empty; its ends are equal if only one l₁ is possible. */ interval: [number, number | null] | null, };
export type WeightedSummary = { 
/** Lengths l₁ (coupler), l₂ (output) and l₃ (input). */ lengths: [number, number, number], 
/** ΣJ of these lengths with the best coupler angles; dimensionless. */ sum: number, 
/** ΣJ of the drawn linkage. */ drawn: number, };
export type WheelHere = { 
/** Moment of inertia, kg·m². */ flywheel: number, 
/** None if there is no cycle. */ cycle: CycleSummaryHere | null, 
/** The reason why there is no cycle. */ problems: readonly Problem[], };
export type Wishes = { 
/** Minimum arc of the crank over which the output dwells, radians. */ arc: number, 
/** Stroke of the output, from minimum to maximum: radians, or in the unit of the lengths. */ stroke: number, movable: Array<Movement>, };
