// Written by the tests of this crate from its Rust: see src/types.rs.
export type Against = { 
/**
 * The abscissa; `input` is the input.
 */
x: string, 
/**
 * The ordinate.
 */
y: string, };
export type Axes = "analogues" | "physical";
export type BodiesDocument = { 
/**
 * Moments of inertia with what is on the shafts, kg·m².
 */
inertia: [number, number, number, number], 
/**
 * Mass of a satellite, kg.
 */
mass: number, 
/**
 * Viscous damping in the bearings, N·m·s.
 */
damping: [number, number, number, number], };
export type ChoiceDocument = { 
/**
 * What there is to choose from.
 */
options: Array<string>, 
/**
 * Which of them is right, from 0.
 */
answer: number, };
export type CouplingDocument = "magnetic" | "contact";
export type Document = { "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument };
export type DraftDocument = LinkageDocument;
export type DriveDocument = { 
/**
 * Which.
 */
shaft: ShaftDocument, 
/**
 * Its speed, revolutions per minute; 0: it is held. Of a tied shaft, the speed that it has without the tie.
 */
rpm: number, 
/**
 * It rises evenly from rest in so many seconds; 0: it has that speed at once.
 */
start_s: number, 
/**
 * The shaft to which it is tied.
 */
to?: ShaftDocument | null, 
/**
 * Its speed relative to that of the shaft to which it is tied.
 */
factor: number, };
export type DriverDocument = { 
/**
 * The link that is turned.
 */
crank?: string | null, 
/**
 * The link that it is turned against; without it the frame.
 */
base?: string | null, 
/**
 * Which of the slides is moved, from 0.
 */
slide?: number | null, 
/**
 * Its least and greatest coordinate along the line.
 */
range?: [number, number] | null, 
/**
 * Rate of a further driver's coordinate by that of the first; 1 by default.
 */
rate?: number | null, };
export type EndDocument = { 
/**
 * The link.
 */
link: string, 
/**
 * Where it is.
 */
at: PlaceDocument, };
export type FormDocument = "planar" | "stepped" | "bevel";
export type FormulaDocument = "log10" | "exp" | "sin" | { "power": number } | { "table": Array<[number, number]> };
export type FunctionDocument = { 
/**
 * f.
 */
of: FormulaDocument, 
/**
 * From which x to which.
 */
x: [number, number], 
/**
 * φ₃ at these x, degrees.
 */
input_deg: [number, number], 
/**
 * φ₂ at the y of these x, degrees.
 */
output_deg: [number, number], };
export type GearDocument = { 
/**
 * The two links.
 */
links: [string, string], 
/**
 * The link both are hinged on, or `frame`.
 */
carrier: string, 
/**
 * Their numbers of teeth.
 */
teeth: [number, number], 
/**
 * How they engage.
 */
mesh: MeshDocument, };
export type GearTrainDocument = { 
/**
 * What it is called.
 */
title?: string | null, 
/**
 * Where it comes from.
 */
source?: string | null, 
/**
 * The mechanism of the catalogue that it was made from.
 */
origin?: string | null, 
/**
 * How the wheels stand.
 */
form: FormDocument, 
/**
 * Plates or teeth of the sun.
 */
z1: number, 
/**
 * Those of a satellite; of a stepped one where it meets the sun.
 */
z2: number, 
/**
 * Those of a stepped satellite where it meets the ring.
 */
z2_step?: number | null, 
/**
 * Those of the ring.
 */
z4: number, 
/**
 * How many satellites there are.
 */
satellites: number, 
/**
 * How the wheels turn each other.
 */
coupling: CouplingDocument, 
/**
 * Module: a wheel's diameter over its number.
 */
module_mm: number, 
/**
 * Of magnets: how far the satellites' axes are from the main one; without it gaps are equal.
 */
axis_distance_mm?: number | null, 
/**
 * What turns two of the three shafts.
 */
drives: Array<DriveDocument>, 
/**
 * Working members 7 and 8.
 */
members: MembersDocument, 
/**
 * From where it is seen.
 */
observer: ObserverDocument, 
/**
 * Whether it runs under load; else nothing slips.
 */
loaded: boolean, 
/**
 * The span of time that is plotted, and that a run under load lasts.
 */
span_s: number, 
/**
 * Times (s) and torques (N·m) of a load on the shaft that is not driven, against the sense in which that turns while nothing slips.
 */
load: Array<[number, number]>, 
/**
 * The magnets of the two meshes.
 */
magnets: MagnetsDocument, 
/**
 * The bodies in the order of their numbers 1, 2, 3, 4.
 */
bodies: BodiesDocument, };
export type Group = "four_bars" | "six_bars" | "guides" | "geared" | "higher" | "schemes";
export type KindDocument = "revolute" | "prismatic" | "screw" | "cylindrical" | "universal" | "spherical" | "planar" | "sphere_in_cylinder" | "cylinder_on_plane" | "sphere_on_plane" | "class";
export type LengthUnit = "m" | "cm" | "mm" | "in" | "none";
export type LessonDocument = { 
/**
 * What it is called.
 */
title: string, 
/**
 * Who wrote it.
 */
author?: string, 
/**
 * Its steps in their order.
 */
steps: Array<StepDocument>, };
export type LinkDocument = { 
/**
 * Its name.
 */
name: string, 
/**
 * Its points; its angle runs from the first to the second.
 */
points: Array<string>, 
/**
 * The distance of its two points, if not as drawn.
 */
length?: number | null, 
/**
 * The places of its points on the link, if not as drawn.
 */
shape?: Array<[number, number]> | null, 
/**
 * The link that it turns as one with.
 */
fixed_to?: string | null, 
/**
 * Its centre of mass, one of its points.
 */
centre_of_mass?: string | null, 
/**
 * Its mass, kilograms.
 */
mass_kg?: number | null, };
export type LinkageDocument = { 
/**
 * What it is called.
 */
title?: string | null, 
/**
 * Where its dimensions are from.
 */
source?: string | null, 
/**
 * The mechanism of the catalogue that it was made from, by name.
 */
origin?: string | null, 
/**
 * What its lengths are in; without it only their proportions count.
 */
unit?: LengthUnit | null, 
/**
 * Every point with its place in the drawing.
 */
points: Array<PointDocument>, 
/**
 * The points of the frame.
 */
frame: Array<string>, 
/**
 * The moving links.
 */
links: Array<LinkDocument>, 
/**
 * Prismatic pairs.
 */
slides?: Array<SlideDocument>, 
/**
 * Gear couplings.
 */
gears?: Array<GearDocument>, 
/**
 * What is driven.
 */
drivers: Array<DriverDocument>, 
/**
 * Points that links carry besides their joints.
 */
tracers?: Array<TracerDocument>, 
/**
 * What is plotted: `LINK.angle`, `POINT.x` or `POINT.y`.
 */
plots?: Array<string>, 
/**
 * The points whose paths are drawn.
 */
traces?: Array<string>, 
/**
 * What stays as it is while points are moved by hand: the distance of two points, the angle at the second of
 * three. It has nothing to do with how the linkage moves.
 */
locks?: Array<Array<string>>, 
/**
 * The height of the ground that it stands on, where it is drawn.
 */
ground?: number | null, 
/**
 * The full width of the band within which the first quantity that is plotted
 * counts as dwelling: degrees of an angle, else in the unit of the lengths.
 */
band?: number | null, 
/**
 * Which of its assemblies moves, from 1; without it the drawn one. Only links
 * and files of before name one: an assembly is saved as its drawing.
 */
assembly?: number | null, };
export type MagnetsDocument = { 
/**
 * Which poles the plates show.
 */
poles: PolesDocument, 
/**
 * The greatest torque of one satellite on sun and ring, N·m.
 */
peak: [number, number], 
/**
 * Damping by eddy currents of one satellite on sun and ring, N·m·s.
 */
damping: [number, number], };
export type MemberDocument = { 
/**
 * What it is.
 */
kind: MemberKind, 
/**
 * What it takes at the speed that its shaft has while nothing slips, N·m: one of several.
 */
torque: number, };
export type MemberKind = "fan" | "brush" | "stirrer" | "scraper" | "blade" | "propeller" | "road_wheel";
export type MembersDocument = { 
/**
 * 7: on the shaft of each satellite.
 */
satellite?: MemberDocument | null, 
/**
 * 8: on the carrier.
 */
carrier?: MemberDocument | null, };
export type MeshDocument = "external" | "internal" | "as_printed";
export type MixerDocument = { 
/**
 * What its lengths are in; without it metres.
 */
unit?: LengthUnit | null, 
/**
 * Crank AB.
 */
l1: number, 
/**
 * Coupler BC.
 */
l2: number, 
/**
 * Rocker DC.
 */
l3: number, 
/**
 * Frame AD.
 */
l4: number, 
/**
 * Teeth of the wheel on the rocker's shaft.
 */
z4: number, 
/**
 * The peripheral wheels it drives: wheel 5, 6, …
 */
wheels: Array<WheelDocument>, 
/**
 * `external`, `internal` or `as_printed`.
 */
mesh: MeshDocument, 
/**
 * Module of the wheels.
 */
module: number, 
/**
 * 1 or 2.
 */
assembly: 1 | 2, 
/**
 * The points traced: P₁, P₂, …
 */
tracers: Array<MixerTracerDocument>, };
export type MixerTracerDocument = { 
/**
 * What carries it: `crank`, `coupler`, `rocker`, `wheel5`, `wheel6`, …
 */
link: string, 
/**
 * Along the link from its first joint.
 */
x: number, 
/**
 * Across it, to the left.
 */
y: number, };
export type NumberDocument = { 
/**
 * Its name, such as `rocker.angle` or `C.x′`.
 */
quantity?: string | null, 
/**
 * The input at which it is asked for, as readers count; none: where the step shows it.
 */
at?: number | null, 
/**
 * The answer itself, if it is no quantity.
 */
value?: number | null, 
/**
 * What is written beside a value.
 */
unit?: string, 
/**
 * By how much an answer may be off.
 */
within: number, 
/**
 * Whether the page shows the quantity's value while it is asked for: without it, it does not.
 */
shown?: boolean, };
export type NumberField = { 
/**
 * Where it stands, such as `wheels[0].z`.
 */
field: string, 
/**
 * What it is.
 */
value: number, 
/**
 * Whether it counts, as a number of teeth does.
 */
whole: boolean, 
/**
 * Whether the engine sets it, from the pose at hand, and changes more than this field; else it is only
 * written down.
 */
followed: boolean, };
export type ObserverDocument = "ground" | "sun" | "carrier" | "ring";
export type Only = "all" | "value" | "first" | "second";
export type OpenLesson = { 
/**
 * Its name: that of its folder.
 */
id: string, 
/**
 * The step, counted from 1.
 */
step: number, };
export type PairDocument = { 
/**
 * Its name.
 */
name: string, 
/**
 * Its form.
 */
kind: KindDocument, 
/**
 * The links that it joins.
 */
links: Array<string>, 
/**
 * Where it is.
 */
at?: PlaceDocument | null, 
/**
 * The direction of its axis or normal, of any length.
 */
axis?: [number, number, number] | null, 
/**
 * The second axis of a universal pair, or the line along which two surfaces touch.
 */
second?: [number, number, number] | null, 
/**
 * The way of a screw with every turn.
 */
pitch?: number | null, 
/**
 * How many freedoms a pair of no certain form leaves.
 */
freedoms?: number | null, };
export type PictureDocument = { 
/**
 * The picture itself, as a `data:` address.
 */
image: string, 
/**
 * Where its upper left corner is.
 */
at: [number, number], 
/**
 * How wide it is, in the unit of lengths.
 */
width: number, 
/**
 * The direction in which its upper edge runs, degrees.
 */
turn_deg: number, 
/**
 * How much of the paper it covers, up to 1.
 */
opacity: number, };
export type PlaceDocument = [number, number] | [number, number, number];
export type PointDocument = { 
/**
 * Its name.
 */
name: string, 
/**
 * Where it is drawn: x, y.
 */
at: [number, number], };
export type PolesDocument = "alike" | "alternating";
export type PositionDocument = { 
/**
 * φ₂, from the joint with the coupler to the fixed pivot.
 */
output_deg: number, 
/**
 * φ₃, from the fixed pivot to the joint with the coupler.
 */
input_deg: number, 
/**
 * What it counts where not all can be met.
 */
weight: number, 
/**
 * φ₁ at which the conditions of the paper are evaluated; without it that of the linkage
 * that is shown.
 */
coupler_deg?: number | null, };
export type Preset = { 
/**
 * Its name.
 */
id: string, } & ({ "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument });
export type QuestionDocument = { 
/**
 * What is asked.
 */
text: string, 
/**
 * What is said to an answer that is not right.
 */
hint?: string, 
/**
 * A number is the answer.
 */
number?: NumberDocument | null, 
/**
 * One of several options is.
 */
choice?: ChoiceDocument | null, 
/**
 * The mechanism is to be brought somewhere.
 */
reach?: ReachDocument | null, };
export type ReachDocument = { 
/**
 * Its name, as of a number that is asked.
 */
quantity: string, 
/**
 * The value.
 */
value: number, 
/**
 * By how much it may be off.
 */
within: number, };
export type SchemeDocument = { 
/**
 * What it is called.
 */
title?: string | null, 
/**
 * Where it comes from.
 */
source?: string | null, 
/**
 * The mechanism of the catalogue that it was made from.
 */
origin?: string | null, 
/**
 * Whether all motion is in one plane.
 */
planar: boolean, 
/**
 * The link that does not move.
 */
ground: string, 
/**
 * The pairs; links are named by them.
 */
pairs: Array<PairDocument>, 
/**
 * Points of links beyond their pairs, such as the end of an arm.
 */
ends?: Array<EndDocument>, 
/**
 * The pairs that are cut: `D`, of a compound hinge with the link that is taken off it, `Q:3`.
 */
cut: Array<string>, 
/**
 * From where a spatial scheme is looked at: to the left of the y-axis, and above the plane x, y.
 */
look_deg: [number, number], 
/**
 * The number of the task that it is; what is asked is then not told.
 */
task?: number | null, };
export type ShaftDocument = "sun" | "carrier" | "ring";
export type Shelf = { 
/**
 * Its name.
 */
id: string, 
/**
 * What it is shown among.
 */
group: Group, 
/**
 * The highest class of its Assur groups, in Roman numerals; of what is no linkage none.
 */
class: string | null, };
export type ShownDocument = { 
/**
 * What of it is not as usual.
 */
view: Partial<View>, 
/**
 * Numbers that are others for every reader.
 */
vary?: Array<VariedDocument>, } & ({ "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument });
export type SlideDocument = { 
/**
 * The link that slides.
 */
link: string, 
/**
 * Its point that stays at its drawn distance from the line.
 */
point: string, 
/**
 * The link that has the line, or `frame`.
 */
on: string, 
/**
 * Two points of that link.
 */
line: [string, string], };
export type SpeedUnit = "rad_per_s" | "per_min";
export type StepDocument = { 
/**
 * What it is called.
 */
title: string, 
/**
 * Paragraphs, one a line; `*emphasis*`, and what follows `_` in a symbol stands low.
 */
text: string, 
/**
 * Formulas, one a line.
 */
formula?: string, 
/**
 * What it shows; none: what the step before shows.
 */
shows?: ShownDocument | null, 
/**
 * What is asked, if anything is.
 */
question?: QuestionDocument | null, };
export type SynthesisDocument = { 
/**
 * What the lengths are in; without it only their proportions count.
 */
unit?: LengthUnit | null, 
/**
 * l₀.
 */
frame: number, 
/**
 * φ₀.
 */
phi0_deg: number, 
/**
 * The positions, in their order.
 */
positions: Array<PositionDocument>, 
/**
 * True if φ₂ and φ₃ are counted from starts that may be chosen.
 */
free: boolean, 
/**
 * Which member of a family: l₂, and l₃ for one whose members all have the same l₂. Where
 * the family does not go so far, its nearest end is meant.
 */
member?: [number, number] | null, 
/**
 * Which of several solutions, from 1, by ascending ΣJ; without it, of those that are not held by the bounds of
 * the search, the one whose output is off by least.
 */
solution?: number | null, 
/**
 * Lengths l₁, l₂, l₃ that are shown instead of a solution.
 */
trial?: [number, number, number] | null, 
/**
 * The function with which the shown linkage is compared, wherever the positions come from.
 */
function?: FunctionDocument | null, };
export type TracerDocument = { 
/**
 * Its name, unlike that of any point.
 */
name: string, 
/**
 * The link that carries it.
 */
link: string, 
/**
 * Its place on the link: x from the link's first point towards its second, y
 * to the left.
 */
at: [number, number], };
export type VariedDocument = { 
/**
 * Where it stands in the document, such as `links[0].length`: one of [`numbers`](crate::Document::numbers).
 */
field: string, 
/**
 * The least value.
 */
from: number, 
/**
 * The greatest value.
 */
to: number, 
/**
 * By how much one value differs from the next.
 */
step: number, };
export type View = { 
/**
 * Input, if it is an angle: the crank angle, degrees.
 */
phi_deg: number, 
/**
 * Input, if it is a length: the displacement of the driven slide, in the unit of the lengths.
 */
s: number, 
/**
 * Input, if it is time, seconds.
 */
t: number, 
/**
 * Whether the mechanism is moving.
 */
playing: boolean, 
/**
 * 1 or −1: sense in which the crank turns.
 */
direction: 1 | -1, 
/**
 * Multiple of one turn in six seconds.
 */
speed: number, 
/**
 * Paths of the joints shown.
 */
traces: boolean, 
/**
 * Centres of mass shown. Older states lack this field and the next.
 */
centres: boolean, 
/**
 * Velocity and acceleration analogues of the joints shown.
 */
vectors: boolean, 
/**
 * Vectors of the loop shown.
 */
loop_vectors: boolean, 
/**
 * Arc of the transmission angle shown.
 */
transmission: boolean, 
/**
 * Links in the colours of their Assur groups.
 */
groups: boolean, 
/**
 * Numbers of the links shown.
 */
numbers: boolean, 
/**
 * All assemblies shown: a picture of each, and their map.
 */
all_assemblies: boolean, 
/**
 * The other assemblies shown beside the one that moves, dashed.
 */
others: boolean, 
/**
 * Polygons of velocities and accelerations shown.
 */
polygons: boolean, 
/**
 * Instant centres of all links shown, with the lines that give that of `about` against `relative_to`.
 */
instant_centres: boolean, 
/**
 * Centrodes of `about` shown.
 */
centrodes: boolean, 
/**
 * The inflection circle of `about` and the circles of curvature of traced points, with the evolutes of their paths, shown.
 */
curvature: boolean, 
/**
 * The link of these instant centres, centrodes and circles; empty: the first coupler.
 */
about: string, 
/**
 * The reference link of the instant centre of `about`; empty: the frame.
 */
relative_to: string, 
/**
 * Measures between points or links, by name (`A-C.distance`, `A-B-C.corner`,
 * `crank-rocker.between`): drawn, read out and listed.
 */
measures: Array<string>, 
/**
 * Plotted quantities: `angles`, or the name of a point (`C2`).
 */
plot: string, 
/**
 * Quantities plotted against each other instead, if any.
 */
against?: Against | null, 
/**
 * The plot that is shown alone, if any.
 */
only: Only, 
/**
 * Variable by which derivatives are taken.
 */
axes: Axes, 
/**
 * ω₁ of the crank, rad/s.
 */
omega: number, 
/**
 * The unit in which ω₁ is written.
 */
omega_unit: SpeedUnit, 
/**
 * ε₁ of the crank, rad/s².
 */
epsilon: number, 
/**
 * Playback at ω₁ instead of `speed`.
 */
true_time: boolean, 
/**
 * The tools for drawing shown.
 */
drawing: boolean, 
/**
 * Difference quotients of φ′ shown over φ″.
 */
differenced: boolean, 
/**
 * The open lesson, if any.
 */
lesson?: OpenLesson | null, 
/**
 * Large text, thick lines, high contrast.
 */
projector: boolean, 
/**
 * Language of the page.
 */
lang: string, };
export type WheelDocument = { 
/**
 * Its teeth.
 */
z: number, 
/**
 * Direction from the shaft of wheel 4 to its own, degrees.
 */
centre_line_deg: number, };
