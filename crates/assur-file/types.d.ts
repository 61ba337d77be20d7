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
 * The options.
 */
options: Array<string>, 
/**
 * Index of the right option, from 0.
 */
answer: number, };
export type CouplingDocument = "magnetic" | "contact";
export type Document = { "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument };
export type DraftDocument = LinkageDocument;
export type DriveDocument = { 
/**
 * The driven shaft.
 */
shaft: ShaftDocument, 
/**
 * Its speed, revolutions per minute; 0: it is held. For a tied shaft, its speed without the tie.
 */
rpm: number, 
/**
 * Time of a uniform rise of the speed from rest, seconds; 0: full speed at once.
 */
start_s: number, 
/**
 * The shaft to which it is tied.
 */
to?: ShaftDocument | null, 
/**
 * Ratio of its speed to that of the shaft to which it is tied.
 */
factor: number, };
export type DriverDocument = { 
/**
 * The driven link.
 */
crank?: string | null, 
/**
 * The link relative to which it turns; without it the frame.
 */
base?: string | null, 
/**
 * Index of the driven slide, from 0.
 */
slide?: number | null, 
/**
 * Its least and greatest coordinate along the line.
 */
range?: [number, number] | null, 
/**
 * Rate of a further driver's coordinate relative to that of the first; 1 by default.
 */
rate?: number | null, };
export type EndDocument = { 
/**
 * The link.
 */
link: string, 
/**
 * Its place.
 */
at: PlaceDocument, };
export type FormDocument = "planar" | "stepped" | "bevel";
export type FormulaDocument = "log10" | "exp" | "sin" | { "power": number } | { "table": Array<[number, number]> };
export type FunctionDocument = { 
/**
 * The function f.
 */
of: FormulaDocument, 
/**
 * Interval of x.
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
 * Type of mesh.
 */
mesh: MeshDocument, };
export type GearTrainDocument = { 
/**
 * Its title.
 */
title?: string | null, 
/**
 * Its source.
 */
source?: string | null, 
/**
 * The mechanism of the catalogue that it was made from.
 */
origin?: string | null, 
/**
 * Arrangement of the wheels.
 */
form: FormDocument, 
/**
 * Plates or teeth of the sun.
 */
z1: number, 
/**
 * Plates or teeth of a satellite; if stepped, of its wheel in mesh with the sun.
 */
z2: number, 
/**
 * Plates or teeth of a stepped satellite's wheel in mesh with the ring.
 */
z2_step?: number | null, 
/**
 * Plates or teeth of the ring.
 */
z4: number, 
/**
 * Number of satellites.
 */
satellites: number, 
/**
 * Coupling of the wheels: by magnets or by teeth in contact.
 */
coupling: CouplingDocument, 
/**
 * Module: a wheel's diameter divided by its number of plates or teeth.
 */
module_mm: number, 
/**
 * Distance of the satellites' axes from the main axis, for magnets; if absent, the gaps are equal.
 */
axis_distance_mm?: number | null, 
/**
 * Drives of two of the three shafts.
 */
drives: Array<DriveDocument>, 
/**
 * Working members 7 and 8.
 */
members: MembersDocument, 
/**
 * The observer in whose frame of reference the train is shown.
 */
observer: ObserverDocument, 
/**
 * Whether it runs under load; otherwise nothing slips.
 */
loaded: boolean, 
/**
 * Plotted time span, and duration of a run under load.
 */
span_s: number, 
/**
 * Knots of a load on the shaft that is not driven: times (s) and torques (N·m) against its rotation without slip.
 */
load: Array<[number, number]>, 
/**
 * The magnets of the two meshes.
 */
magnets: MagnetsDocument, 
/**
 * Inertia, mass and damping of the bodies.
 */
bodies: BodiesDocument, };
export type Group = "four_bars" | "six_bars" | "guides" | "geared" | "higher" | "schemes";
export type KindDocument = "revolute" | "prismatic" | "screw" | "cylindrical" | "universal" | "spherical" | "planar" | "sphere_in_cylinder" | "cylinder_on_plane" | "sphere_on_plane" | "class";
export type LengthUnit = "m" | "cm" | "mm" | "in" | "none";
export type LessonDocument = { 
/**
 * Its title.
 */
title: string, 
/**
 * Its author.
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
 * Its title.
 */
title?: string | null, 
/**
 * Source of its dimensions.
 */
source?: string | null, 
/**
 * The mechanism of the catalogue that it was made from, by name.
 */
origin?: string | null, 
/**
 * Unit of its lengths; without it only their proportions count.
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
 * Driven pairs.
 */
drivers: Array<DriverDocument>, 
/**
 * Points that links carry besides their joints.
 */
tracers?: Array<TracerDocument>, 
/**
 * Plotted quantities: `LINK.angle`, `POINT.x` or `POINT.y`.
 */
plots?: Array<string>, 
/**
 * The points whose paths are drawn.
 */
traces?: Array<string>, 
/**
 * Dimensions kept while points are moved by hand: the distance of two points, the angle at the
 * second of three. They do not affect the motion of the linkage.
 */
locks?: Array<Array<string>>, 
/**
 * Height of the ground on which it stands, if the ground is drawn.
 */
ground?: number | null, 
/**
 * Full width of the dwell band of the first plotted quantity: degrees for an angle, otherwise
 * in the unit of the lengths.
 */
band?: number | null, 
/**
 * Number of the assembly that moves, from 1; without it the drawn one. Only links and older
 * files contain it: an assembly is saved as its drawing.
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
 * Kind of the member.
 */
kind: MemberKind, 
/**
 * Torque of one member at the speed that its shaft has without slip, N·m.
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
 * Unit of its lengths; without it metres.
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
 * Type of mesh: `external`, `internal` or `as_printed`.
 */
mesh: MeshDocument, 
/**
 * Module of the wheels.
 */
module: number, 
/**
 * Number of the assembly, 1 or 2.
 */
assembly: 1 | 2, 
/**
 * The points traced: P₁, P₂, …
 */
tracers: Array<MixerTracerDocument>, };
export type MixerTracerDocument = { 
/**
 * The link that carries it: `crank`, `coupler`, `rocker`, `wheel5`, `wheel6`, …
 */
link: string, 
/**
 * Coordinate along the link from its first joint.
 */
x: number, 
/**
 * Coordinate perpendicular to it, to the left.
 */
y: number, };
export type NumberDocument = { 
/**
 * Name of the quantity, such as `rocker.angle` or `C.x′`.
 */
quantity?: string | null, 
/**
 * The input at which it is evaluated, in the reader's unit; none: that of the step.
 */
at?: number | null, 
/**
 * The answer itself, if it is not a quantity.
 */
value?: number | null, 
/**
 * Unit written beside a value.
 */
unit?: string, 
/**
 * Tolerance of the answer.
 */
within: number, 
/**
 * Whether the page shows the value of the quantity during the question; by default it does not.
 */
shown?: boolean, };
export type NumberField = { 
/**
 * Path of its field, such as `wheels[0].z`.
 */
field: string, 
/**
 * Its value.
 */
value: number, 
/**
 * Whether it is a whole number, such as a number of teeth.
 */
whole: boolean, 
/**
 * Whether the engine sets it from the current pose and changes other fields, too; otherwise
 * only this field is written.
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
 * Its place.
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
 * Advance of a screw per turn.
 */
pitch?: number | null, 
/**
 * Number of freedoms of a pair of unspecified form.
 */
freedoms?: number | null, };
export type PictureDocument = { 
/**
 * The image, as a `data:` address.
 */
image: string, 
/**
 * Position of its upper left corner.
 */
at: [number, number], 
/**
 * Its width, in the unit of lengths.
 */
width: number, 
/**
 * Direction of its upper edge, degrees.
 */
turn_deg: number, 
/**
 * Its opacity, up to 1.
 */
opacity: number, };
export type PlaceDocument = [number, number] | [number, number, number];
export type PointDocument = { 
/**
 * Its name.
 */
name: string, 
/**
 * Drawn coordinates x, y.
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
 * Weight of the position where not all can be met.
 */
weight: number, 
/**
 * φ₁ at which the conditions of the paper are evaluated; without it that of the shown linkage.
 */
coupler_deg?: number | null, };
export type Preset = { 
/**
 * Name in the catalogue.
 */
id: string, } & ({ "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument });
export type QuestionDocument = { 
/**
 * Text of the question.
 */
text: string, 
/**
 * Hint after a wrong answer.
 */
hint?: string, 
/**
 * The answer is a number.
 */
number?: NumberDocument | null, 
/**
 * The answer is one of several options.
 */
choice?: ChoiceDocument | null, 
/**
 * The answer is a state to which the mechanism is brought.
 */
reach?: ReachDocument | null, };
export type ReachDocument = { 
/**
 * Name of the quantity, as for a number.
 */
quantity: string, 
/**
 * The value.
 */
value: number, 
/**
 * Tolerance of the value.
 */
within: number, };
export type SchemeDocument = { 
/**
 * Its title.
 */
title?: string | null, 
/**
 * Its source.
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
 * Cut pairs: `D`; of a compound hinge with the link that is taken off it, `Q:3`.
 */
cut: Array<string>, 
/**
 * Direction from which a spatial scheme is viewed: to the left of the y-axis, and above the plane x, y.
 */
look_deg: [number, number], 
/**
 * Number of the task, if it is one; the answer is then hidden.
 */
task?: number | null, };
export type ShaftDocument = "sun" | "carrier" | "ring";
export type Shelf = { 
/**
 * Name in the catalogue.
 */
id: string, 
/**
 * Category of the gallery.
 */
group: Group, 
/**
 * Highest class of its Assur groups, in Roman numerals; none if it is not a linkage.
 */
class: string | null, };
export type ShownDocument = { 
/**
 * The view; only fields that differ from the default are saved.
 */
view: Partial<View>, 
/**
 * Numbers that vary from reader to reader.
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
 * The link with the line, or `frame`.
 */
on: string, 
/**
 * Two points of that link, on the line.
 */
line: [string, string], };
export type SpeedUnit = "rad_per_s" | "per_min";
export type StepDocument = { 
/**
 * Its title.
 */
title: string, 
/**
 * Paragraphs, one per line; `*emphasis*`, and `_` starts a subscript in a symbol.
 */
text: string, 
/**
 * Formulas, one per line.
 */
formula?: string, 
/**
 * The shown document; none: that of the step before.
 */
shows?: ShownDocument | null, 
/**
 * The question, if there is one.
 */
question?: QuestionDocument | null, };
export type SynthesisDocument = { 
/**
 * Unit of the lengths; without it only their proportions count.
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
 * Whether φ₂ and φ₃ are counted from starts that may be chosen.
 */
free: boolean, 
/**
 * Chosen member of a family: l₂, and l₃ for one whose members all have the same l₂. Beyond the
 * ends of the family, the nearest end.
 */
member?: [number, number] | null, 
/**
 * Number of the solution, from 1, in ascending ΣJ; without it, the one with the least output
 * error among those not at a bound of the search.
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
 * Its name, different from that of any point.
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
 * Path of its field, such as `links[0].length`, of a number that a lesson may vary.
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
 * Difference of successive values.
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
