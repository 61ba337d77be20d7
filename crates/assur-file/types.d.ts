// Written by the tests of this crate from its Rust: see src/types.rs.
export type Problem = { readonly code: string, readonly field?: string, readonly [parameter: string]: string | number | readonly string[] | undefined };
export type Frozen<T> = T extends object ? { readonly [K in keyof T]: Frozen<T[K]> } : T;
export type DocumentOf<K extends Document["kind"]> = Extract<Document, { kind: K }>;
export type Against = { 
/** The abscissa; `input` stands for the input. */ x: string, 
/** The ordinate. */ y: string, };
export type AnchorDocument = { 
/** The link, or `frame`. */ link: string, 
/** One of its points. */ point: string, };
export type Axes = "analogues" | "physical";
export type BodiesDocument = { 
/** Moments of inertia, including those of all parts on the shafts, kg·m². */ inertia: [number, number, number, number], 
/** Mass of a satellite, kg. */ mass: number, 
/** Viscous damping in the bearings, N·m·s. */ damping: [number, number, number, number], };
export type ChoiceDocument = { 
/** The options. */ options: Array<string>, 
/** Index of the right option, from 0. */ answer: number, };
export type CouplingDocument = "magnetic" | "contact";
export type CourseDocument = "points" | "open" | "closed";
export type DamperDocument = { 
/** The points of its two ends. */ ends?: [AnchorDocument, AnchorDocument] | null, 
/** The links between which it acts on their relative angular velocity, if it has no ends. */ links?: [string, string] | null, 
/** Damping coefficient: N·s/m, or N·m·s. */ damping: number, };
export type Document = { "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "point-path", "document": PathDocument } | { "kind": "poses", "document": PosesDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument };
export type DraftDocument = LinkageDocument;
export type DriveDocument = { 
/** The driven shaft. */ shaft: ShaftDocument, 
/** Speed of the driven shaft, revolutions per minute; 0 if the shaft is held. Not used if `to` is given. */ rpm: number, 
/** Duration of a uniform acceleration from rest to the speed `rpm`, seconds; 0 for an instantaneous start. */ start_s: number, 
/** Another shaft, if the speed of the driven shaft is a multiple of the speed of that shaft. */ to?: ShaftDocument | null, 
/** Ratio of the driven shaft's speed to that of the shaft `to`. */ factor: number, };
export type DriverDocument = { 
/** The driven link, if it is a crank. */ crank?: string | null, 
/** The link relative to which the crank rotates; if absent, the frame. */ base?: string | null, 
/** Index of the driven slide in the list of slides, from 0. */ slide?: number | null, 
/** Least and greatest coordinate of the driven slide along its line. */ range?: [number, number] | null, 
/** Rate of this driver's coordinate relative to that of the first driver; 1 by default. */ rate?: number | null, 
/** Motor of a further driver in a motion under load; if absent, the driver is free there. */ motor?: MotorDocument | null, 
/** Rate of a further driver at the start of a motion under load; if absent, `rate` times that of the first driver. */ initial_rate?: number | null, 
/** Whether the driver keeps its rate in a motion under load, whatever torque that takes. */ keeps_rate?: boolean | null, };
export type EndDocument = { 
/** Name of the link. */ link: string, 
/** Position of the point. */ at: PlaceDocument, };
export type FormDocument = "planar" | "stepped" | "bevel";
export type FormulaDocument = "log10" | "exp" | "sin" | { "power": number } | { "table": Array<[number, number]> };
export type FrictionDocument = { 
/** The point of the hinges. */ hinge?: string | null, 
/** The link that slides. */ slide?: string | null, 
/** Coefficient of friction. */ coefficient: number, 
/** Radius of the pin of a hinge, in the unit of lengths. */ radius?: number | null, 
/** Length of the block of a slide along the line, in the unit of lengths, if known. */ length?: number | null, };
export type FunctionDocument = { 
/** The function f. */ of: FormulaDocument, 
/** Interval of x. */ x: [number, number], 
/** φ₃ at the two ends of the interval of x, degrees. */ input_deg: [number, number], 
/** φ₂ for the values of y at the two ends of the interval of x, degrees. */ output_deg: [number, number], };
export type GearDocument = { 
/** The two wheels. */ links: [string, string], 
/** The link to which both wheels are hinged, or `frame`. */ carrier: string, 
/** The numbers of teeth of the wheels. */ teeth: [number, number], 
/** Type of mesh. */ mesh: MeshDocument, };
export type GearTrainDocument = { 
/** Title of the train. */ title?: string | null, 
/** Source of the train. */ source?: string | null, 
/** Name of the catalogue mechanism from which the train was made. */ origin?: string | null, 
/** Arrangement of the wheels. */ form: FormDocument, 
/** Number of plates or teeth of the sun. */ z1: number, 
/** Number of plates or teeth of a satellite; if it is stepped, of its wheel in mesh with the sun. */ z2: number, 
/** Number of plates or teeth of a stepped satellite's wheel in mesh with the ring. */ z2_step?: number | null, 
/** Number of plates or teeth of the ring. */ z4: number, 
/** Number of satellites. */ satellites: number, 
/** Coupling of the wheels: by magnets or by teeth in contact. */ coupling: CouplingDocument, 
/** Module: a wheel's diameter divided by its number of plates or teeth. */ module_mm: number, 
/** Distance of the satellites' axes from the main axis, for magnets; if absent, the gaps at sun and ring are equal. */ axis_distance_mm?: number | null, 
/** Drives of two of the three shafts. */ drives: Array<DriveDocument>, 
/** Working members 7 and 8: the tools, such as fans or brushes, that the train drives. */ members: MembersDocument, 
/** The observer in whose frame of reference the train is shown. */ observer: ObserverDocument, 
/** Whether the train runs under load; otherwise the wheels do not slip. */ loaded: boolean, 
/** Plotted time span, and duration of a run under load, seconds. */ span_s: number, 
/**
 * Load on the shaft that is not driven: knots [time in s, torque in N·m]. A positive torque opposes the rotation
 * that the shaft would have without slip.
 */
load: Array<[number, number]>, 
/** The magnets of the two meshes. */ magnets: MagnetsDocument, 
/** Inertia, mass and damping of the bodies. */ bodies: BodiesDocument, };
export type Group = "four_bars" | "six_bars" | "guides" | "geared" | "higher" | "schemes" | "tasks";
export type HarmonicDocument = { 
/** Amplitude A, in the unit of the value. */ amplitude: number, 
/** Order k: of the angle of a crank, or of the travel of a slide in the unit of lengths. */ order: number, 
/** Phase α, degrees; 0 by default. */ phase_deg?: number | null, };
export type HingeDocument = { "frame": [number, number] } | { "body": [number, number] };
export type KindDocument = "revolute" | "prismatic" | "screw" | "cylindrical" | "universal" | "spherical" | "planar" | "sphere_in_cylinder" | "cylinder_on_plane" | "sphere_on_plane" | "class";
export type LengthUnit = "m" | "cm" | "mm" | "in" | "none";
export type LessonDocument = { 
/** Title of the lesson. */ title: string, 
/** Author of the lesson; may be empty. */ author?: string, 
/** Steps of the lesson, in order. */ steps: Array<StepDocument>, };
export type LinkDocument = { 
/** Name of the link. */ name: string, 
/** Points of the link. The link's angle is the direction from the first to the second. */ points: Array<string>, 
/** Distance between the two points of the link, if not as drawn. */ length?: number | null, 
/** Coordinates of the points in any axes fixed to the link, if not as drawn. */ shape?: Array<[number, number]> | null, 
/** The link to which this link is rigidly fixed, or `frame`. */ fixed_to?: string | null, 
/** Centre of mass of the link, one of its points. */ centre_of_mass?: string | null, 
/** Mass of the link, kilograms. It may also be called `mass`. */ mass_kg?: number | null, 
/** Moment of inertia of the link about its centre of mass: kilograms times the square of the unit of lengths. */ inertia?: number | null, };
export type LinkageDocument = { 
/** Title of the linkage. */ title?: string | null, 
/** Source of the dimensions. */ source?: string | null, 
/** Name of the catalogue mechanism from which the linkage was made. */ origin?: string | null, 
/** Unit of lengths; if absent, only proportions count. */ unit?: LengthUnit | null, 
/** All points, with their positions in the drawing. */ points: Array<PointDocument>, 
/** The points of the frame. */ frame: Array<string>, 
/** The moving links. */ links: Array<LinkDocument>, 
/** Prismatic pairs. */ slides?: Array<SlideDocument>, 
/** Gear couplings. */ gears?: Array<GearDocument>, 
/** Driven pairs. */ drivers: Array<DriverDocument>, 
/** Traced points: points of links that are not joints. */ tracers?: Array<TracerDocument>, 
/** Acceleration of free fall, x and y, m/s²; without it there is no gravity. */ gravity?: [number, number] | null, 
/** Loads: forces, torques and resistances. */ loads?: Array<LoadDocument>, 
/** Springs. */ springs?: Array<SpringDocument>, 
/** Dampers. */ dampers?: Array<DamperDocument>, 
/** Friction in hinges and slides; it counts in the reactions, not in the motion under load. */ friction?: Array<FrictionDocument>, 
/** Motor of the first driver; without it the driver is free in a motion under load. */ motor?: MotorDocument | null, 
/**
 * Moment of inertia of a flywheel on the crank of the first driver, kg·m², whatever the unit of lengths; without it
 * there is none.
 */
flywheel?: number | null, 
/**
 * Rate of the input at the start of a motion under load: radians of a crank, or units of length, per second; 0 by
 * default. Reactions are those at this rate.
 */
initial_rate?: number | null, 
/** Plotted quantities: `LINK.angle`, `POINT.x` or `POINT.y`. */ plots?: Array<string>, 
/** The points whose paths are drawn. */ traces?: Array<string>, 
/**
 * Dimensions kept while points are moved by hand. Two points stand for their distance, three for the
 * angle at the second. These locks do not affect the motion of the linkage.
 */
locks?: Array<Array<string>>, 
/** Height of the ground on which the linkage stands, if the ground is drawn. */ ground?: number | null, 
/**
 * Full width of the dwell band of the first plotted quantity: degrees for an angle, otherwise
 * in the unit of the lengths.
 */
band?: number | null, 
/**
 * Number of the assembly in which the linkage moves, from 1; if absent, the drawn one. Only old URLs and files
 * contain this field: an assembly is now saved as its drawing.
 */
assembly?: number | null, };
export type LoadDocument = { 
/** The link on which the load acts. */ link: string, 
/** The point at which a force or resistance acts; without a point it is a torque. */ point?: string | null, 
/** Force, N, or torque, N·m, the same at every input. */ value?: number | null, 
/** Force or torque linear between knots: inputs (degrees of a crank, or the unit of lengths) and values. */ table?: Array<[number, number]> | null, 
/** Force or torque as a sum of harmonics of the input. */ terms?: Array<HarmonicDocument> | null, 
/** Direction of the force, degrees from the x-axis, or from the link's direction if it turns with the link. */ direction_deg?: number | null, 
/** True if the force turns with the link. */ turns?: boolean, 
/** Resistance (k₁ + k₂|v|)v to the velocity of the point, or to the angular velocity: k₁ and k₂ in SI units. */ resistance?: [number, number] | null, };
export type MagnetsDocument = { 
/** Polarity of the plates. */ poles: PolesDocument, 
/** Greatest torques that one satellite exerts on sun and ring, N·m. */ peak: [number, number], 
/** Eddy-current damping in one satellite's mesh with the sun, and in its mesh with the ring, N·m·s. */ damping: [number, number], };
export type MemberDocument = { 
/** Type of the member. */ kind: MemberKind, 
/** Torque of one member at the speed that its shaft would have without slip, N·m. */ torque: number, };
export type MemberKind = "fan" | "brush" | "stirrer" | "scraper" | "blade" | "propeller" | "road_wheel";
export type MembersDocument = { 
/** Member 7, on the shaft of each satellite. */ satellite?: MemberDocument | null, 
/** Member 8, on the carrier. */ carrier?: MemberDocument | null, };
export type MeshDocument = "external" | "internal" | "as_printed";
export type MixerDocument = { 
/** Unit of lengths; if absent, metres. */ unit?: LengthUnit | null, 
/** Length of the crank AB. */ l1: number, 
/** Length of the coupler BC. */ l2: number, 
/** Length of the rocker DC. */ l3: number, 
/** Length of the frame AD. */ l4: number, 
/** Number of teeth of wheel 4, on the rocker's shaft. */ z4: number, 
/** The peripheral wheels that wheel 4 drives: wheels 5, 6, … */ wheels: Array<WheelDocument>, 
/** Type of mesh: `external`, `internal` or `as_printed`. */ mesh: MeshDocument, 
/** Module of the wheels. */ module: number, 
/** Number of the assembly of the four-bar, 1 or 2. */ assembly: 1 | 2, 
/** Traced points: P₁, P₂, … */ tracers: Array<MixerTracerDocument>, };
export type MixerTracerDocument = { 
/** The link that carries the point: `crank`, `coupler`, `rocker`, `wheel5`, `wheel6`, … */ link: string, 
/** Coordinate along the link, from the link's first joint. */ x: number, 
/** Coordinate perpendicular to the link, to the left. */ y: number, };
export type MotorDocument = { 
/** Torque of a motor with the same torque at every speed. */ torque?: number | null, 
/** Torque at rest of a motor whose torque is linear in the speed. */ stall?: number | null, 
/** Speed without load of such a motor. */ no_load?: number | null, 
/** Pull-out torque of an induction motor, by Kloss's formula. */ pull_out?: number | null, 
/** Slip of such a motor at the pull-out torque. */ slip?: number | null, 
/** Synchronous speed of such a motor. */ synchronous?: number | null, 
/** Torque linear between knots: speeds and torques. */ table?: Array<[number, number]> | null, };
export type NumberDocument = { 
/** Name of the quantity, such as `rocker.angle` or `C.x′`. */ quantity?: string | null, 
/**
 * The input at which the quantity is evaluated: degrees, seconds, or the unit of lengths. If absent, the input of
 * the step is used.
 */
at?: number | null, 
/** The answer itself, if it is not a quantity. */ value?: number | null, 
/** Unit written beside `value`. */ unit?: string, 
/** Tolerance of the answer. */ within: number, 
/** Whether the page shows the value of the quantity while the question is open; false by default. */ shown?: boolean, };
export type NumberField = { 
/** Path of the number's field, such as `wheels[0].z`. */ field: string, 
/** Value of the number. */ value: number, 
/** Whether only whole numbers are allowed, as for a number of teeth. */ whole: boolean, 
/**
 * Whether the engine sets the number, starting from the current pose, and changes other fields, too;
 * otherwise only this field is written.
 */
followed: boolean, };
export type ObserverDocument = "ground" | "sun" | "carrier" | "ring";
export type Only = "all" | "value" | "first" | "second";
export type OpenLesson = { 
/** Name of the lesson, which is also that of its folder. */ id: string, 
/** The step, counted from 1. */ step: number, };
export type PairDocument = { 
/** Name of the pair. */ name: string, 
/** Type of the pair. */ kind: KindDocument, 
/** Names of the links that the pair joins. */ links: Array<string>, 
/** Position of the pair. */ at?: PlaceDocument | null, 
/** A vector of any length in the direction of the axis or normal. */ axis?: [number, number, number] | null, 
/** The second axis of a universal pair, or the line along which two surfaces touch. */ second?: [number, number, number] | null, 
/** Advance of a screw per turn. */ pitch?: number | null, 
/** Number of freedoms of a pair of unspecified type. */ freedoms?: number | null, };
export type PathDocument = { 
/** Unit of lengths; if absent, only proportions count. */ unit?: LengthUnit | null, 
/** What the points mean. */ course?: CourseDocument, 
/** The points of the path, in their order: 3 to 512. */ path: Array<[number, number]>, 
/**
 * Crank angles at the points, of which only the differences count; the crank may turn in either direction. If
 * absent, they are free.
 */
angles_deg?: Array<number>, 
/** The linkage that is shown; if absent, the best one of a short search. */ linkage?: TracingDocument | null, };
export type PictureDocument = { 
/** The image, as a `data:` URL. */ image: string, 
/** Position of the picture's upper left corner. */ at: [number, number], 
/** Width of the picture, in the unit of lengths. */ width: number, 
/** Direction of the picture's upper edge, degrees. */ turn_deg: number, 
/** Opacity of the picture, up to 1. */ opacity: number, };
export type PlaceDocument = [number, number] | [number, number, number];
export type PointDocument = { 
/** Name of the point. */ name: string, 
/** Drawn coordinates x, y. */ at: [number, number], };
export type PolesDocument = "alike" | "alternating";
export type PoseDocument = { 
/** Coordinates of the body's origin. */ x: number, 
/** See `x`. */ y: number, 
/** Direction of the body's x-axis. */ angle_deg: number, };
export type PosesDocument = { 
/** Unit of lengths; if absent, only proportions count. */ unit?: LengthUnit | null, 
/** Two to five poses, in their order. */ poses: Array<PoseDocument>, 
/** Corners of the drawn body, in its own coordinates; by default a triangle that points along its x-axis. */ body?: Array<[number, number]>, 
/**
 * At most two wanted hinges, one for each dyad. Four poses leave a curve for them, on which the nearest point is
 * taken; five poses leave no choice of hinges. Without them, hinges at two corners of the body for up to three
 * poses, and points all along the curve for four.
 */
hinges?: Array<HingeDocument>, 
/** Opposite corners of the rectangle in which all hinges on the frame must be. */ region?: [[number, number], [number, number]] | null, 
/** Number of the pair of dyads that is shown, from 1; if absent, the pair of the wanted hinges or the best one. */ solution?: number | null, };
export type PositionDocument = { 
/** Output angle φ₂: direction from the joint with the coupler to the fixed pivot. */ output_deg: number, 
/** Input angle φ₃: direction from the fixed pivot to the joint with the coupler. */ input_deg: number, 
/** Weight of the position if not all positions can be met. */ weight: number, 
/** Coupler angle φ₁ at which the conditions of the paper are evaluated; if absent, that of the shown linkage. */ coupler_deg?: number | null, };
export type Preset = { 
/** Name in the catalogue. */ id: string, } & ({ "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "point-path", "document": PathDocument } | { "kind": "poses", "document": PosesDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument });
export type QuestionDocument = { 
/** Text of the question. */ text: string, 
/** Hint after a wrong answer. */ hint?: string, 
/** The answer, if it is a number. */ number?: NumberDocument | null, 
/** The options and the answer, if the answer is one of several options. */ choice?: ChoiceDocument | null, 
/** The answer, if it is a state that the reader must bring the mechanism to. */ reach?: ReachDocument | null, };
export type ReachDocument = { 
/** Name of the quantity, as in a [`NumberDocument`]. */ quantity: string, 
/** The value to be reached. */ value: number, 
/** Tolerance of the value. */ within: number, };
export type SchemeDocument = { 
/** Title of the scheme. */ title?: string | null, 
/** Source of the scheme. */ source?: string | null, 
/** Name of the catalogue mechanism from which the scheme was made. */ origin?: string | null, 
/** Whether all motion is in one plane. */ planar: boolean, 
/** Name of the fixed link. */ ground: string, 
/** The pairs, which also name the links. */ pairs: Array<PairDocument>, 
/** Further points of links at which there is no pair, such as the end of an arm. */ ends?: Array<EndDocument>, 
/** Names of cut pairs, such as `D`; for a compound hinge also the detached link, such as `Q:3`. */ cut: Array<string>, 
/** Viewing direction of a spatial scheme, degrees: rotation about the z-axis from the y-axis, and elevation. */ look_deg: [number, number], 
/** Number of the practice task that the scheme poses, if any; the answer is then hidden. */ task?: number | null, };
export type ShaftDocument = "sun" | "carrier" | "ring";
export type Shelf = { 
/** Name in the catalogue. */ id: string, 
/** Category of the gallery. */ group: Group, 
/** Highest class of the Assur groups, in Roman numerals; none if the mechanism is not a linkage. */ class: string | null, };
export type ShownDocument = { 
/** The view. Only fields that differ from their defaults are saved. */ view: Partial<View>, 
/** Numbers of the document that vary from reader to reader. */ vary?: Array<VariedDocument>, } & ({ "kind": "draft", "document": DraftDocument } | { "kind": "gear-train", "document": GearTrainDocument } | { "kind": "linkage", "document": LinkageDocument } | { "kind": "mixer", "document": MixerDocument } | { "kind": "point-path", "document": PathDocument } | { "kind": "poses", "document": PosesDocument } | { "kind": "scheme", "document": SchemeDocument } | { "kind": "synthesis", "document": SynthesisDocument });
export type SlideDocument = { 
/** The link that slides. */ link: string, 
/** Point of the sliding link that keeps its drawn distance from the line. */ point: string, 
/** The link that carries the line, or `frame`. */ on: string, 
/** Two points through which the line passes, on the link that carries it. */ line: [string, string], };
export type SpeedUnit = "rad_per_s" | "per_min";
export type SpringDocument = { 
/** The points of its two ends. */ ends?: [AnchorDocument, AnchorDocument] | null, 
/** The links between which it acts on their relative angle, if it has no ends. */ links?: [string, string] | null, 
/** Stiffness: N/m, or N·m per radian. */ stiffness: number, 
/** Length without load, in the unit of lengths; 0 by default. */ free_length?: number | null, 
/** Angle of the first link relative to the second without load, degrees; 0 by default. */ free_angle_deg?: number | null, };
export type StepDocument = { 
/** Title of the step. */ title: string, 
/** Paragraphs, one per line. Asterisks mark `*emphasis*`, and `_` starts a subscript in a symbol. */ text: string, 
/** Formulas, one per line. */ formula?: string, 
/** The shown document; if absent, the document of the step before is shown. */ shows?: ShownDocument | null, 
/** The question, if there is one. */ question?: QuestionDocument | null, };
export type SynthesisDocument = { 
/** Unit of lengths; if absent, only proportions count. */ unit?: LengthUnit | null, 
/** Length of the frame, l₀. */ frame: number, 
/** Direction of the frame, φ₀. */ phi0_deg: number, 
/** The positions, in their order. */ positions: Array<PositionDocument>, 
/** Whether φ₂ and φ₃ are measured from starting angles that may be chosen freely. */ free: boolean, 
/**
 * Lengths l₂, l₃ that choose one of the family of linkages for two positions: the one with this l₂ or, if all
 * have the same l₂, with this l₃. Lengths beyond an end of the family choose that end.
 */
member?: [number, number] | null, 
/**
 * Number of the solution, from 1, in ascending order of ΣJ, the weighted sum of the squared closure errors. If
 * absent, the solution with the least output error among those not at a bound of the search.
 */
solution?: number | null, 
/** Lengths l₁, l₂, l₃ that are shown instead of a solution. */ trial?: [number, number, number] | null, 
/** The function with which the shown linkage is compared. The positions need not come from it. */ function?: FunctionDocument | null, };
export type TracerDocument = { 
/** Name of the traced point, different from the names of all points. */ name: string, 
/** The link to which the traced point is fixed. */ link: string, 
/** Coordinates of the traced point on the link: x from the link's first point towards the second, y to the left. */ at: [number, number], };
export type TracingDocument = { "four_bar": { 
/** Fixed pivots of crank and rocker. */ pivots: [[number, number], [number, number]], 
/** Joints of the coupler with crank and rocker. */ joints: [[number, number], [number, number]], 
/** The traced point of the coupler. */ point: [number, number], } } | { "slider_crank": { 
/** Fixed pivot of the crank. */ pivot: [number, number], 
/** Joints of the rod with crank and slider. */ joints: [[number, number], [number, number]], 
/** Direction of the guide. */ guide: [number, number], 
/** The traced point of the rod. */ point: [number, number], } };
export type VariedDocument = { 
/** Path of the field of a number that a lesson may vary, such as `links[0].length`. */ field: string, 
/** The least value. */ from: number, 
/** The greatest value. */ to: number, 
/** Difference between successive values. */ step: number, };
export type View = { 
/** The input if it is an angle: the crank angle, degrees. */ phi_deg: number, 
/** The input if it is a length: the displacement of the driven slide, in the unit of lengths. */ s: number, 
/** The input if it is time, seconds. */ t: number, 
/** Whether the mechanism is moving. */ playing: boolean, 
/** Sense of rotation of the crank, 1 or −1. */ direction: 1 | -1, 
/** Playback speed, as a multiple of one turn in six seconds. */ speed: number, 
/** Whether the paths of the points in the list `traces` of a linkage are shown. */ traces: boolean, 
/** Whether centres of mass are shown. */ centres: boolean, 
/**
 * Whether velocity and acceleration analogues of moving points are shown; for a differential, velocities of a
 * satellite.
 */
vectors: boolean, 
/** Whether the vectors of the loop are shown. */ loop_vectors: boolean, 
/** Whether the arc of the transmission angle is shown. */ transmission: boolean, 
/** Whether links have the colours of their Assur groups. */ groups: boolean, 
/** Whether the numbers of the links are shown. */ numbers: boolean, 
/** Whether all assemblies are shown: a picture of each, and a map of them. */ all_assemblies: boolean, 
/** Whether the other assemblies are shown, dashed, beside the one that moves. */ others: boolean, 
/** Whether the polygons of velocities and accelerations are shown. */ polygons: boolean, 
/** Whether reactions and applied forces are shown: arrows in the drawing, and a table of all reactions. */ forces: boolean, 
/** Whether force plans, Zhukovsky's lever and free bodies are shown. */ force_plan: boolean, 
/** Whether the motion under load is shown: motor, run in time, steady cycle, flywheel. */ under_load: boolean, 
/**
 * Whether the instant centres of all links are shown, with the lines that locate the instant centre of `about`
 * relative to `relative_to`.
 */
instant_centres: boolean, 
/** Whether the centrodes of `about` are shown. */ centrodes: boolean, 
/** Whether the inflection circle of `about` is shown, and the circles of curvature and evolutes of traced paths. */ curvature: boolean, 
/**
 * The link whose instant centre, centrodes and inflection circle are shown. If empty, the first link with two or
 * more points that is not joined to the frame; if there is none, the last link.
 */
about: string, 
/** The reference link of the instant centre of `about`; if empty, the frame. */ relative_to: string, 
/**
 * Drawn and listed measures between points or links, by name: `A-C.distance`, `A-B-C.corner`,
 * `crank-rocker.between`.
 */
measures: Array<string>, 
/** Plotted quantities: `angles`, or the name of a quantity or a point, such as `C2`. */ plot: string, 
/** Two quantities plotted against each other instead of against the input, if any. */ against?: Against | null, 
/** The plot that is shown alone, if any. */ only: Only, 
/** Variable with respect to which derivatives are taken. */ axes: Axes, 
/** Angular velocity ω₁ of the crank, rad/s. */ omega: number, 
/** The unit in which ω₁ is written. */ omega_unit: SpeedUnit, 
/** Angular acceleration ε₁ of the crank, rad/s². */ epsilon: number, 
/** Whether playback is at ω₁ instead of `speed`. */ true_time: boolean, 
/** Whether the tools for drawing are shown. */ drawing: boolean, 
/** Whether difference quotients of the first derivatives are plotted on top of the second derivatives. */ differenced: boolean, 
/** The open lesson, if any. */ lesson?: OpenLesson | null, 
/** Whether the page has large text, thick lines and high contrast, as for a projector. */ projector: boolean, 
/** Language of the page. */ lang: string, };
export type WheelDocument = { 
/** Number of teeth of the wheel. */ z: number, 
/** Direction from the shaft of wheel 4 to that of this wheel, degrees. */ centre_line_deg: number, };
