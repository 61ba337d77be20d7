// Written by the tests of this crate from its Rust: see src/types.rs.
import { LinkageDocument } from "assur/types/file.js";
export type Edit = { "edit": "point", 
/**
 * Its position.
 */
at: [number, number], 
/**
 * Whether it belongs to the frame.
 */
fixed: boolean, } | { "edit": "bar", 
/**
 * Its ends.
 */
ends: [End, End], } | { "edit": "corner", 
/**
 * The link.
 */
link: string, 
/**
 * The point.
 */
end: End, } | { "edit": "block", 
/**
 * Its hinge.
 */
end: End, 
/**
 * The line along which it slides.
 */
along: Line, } | { "edit": "slide", 
/**
 * The link.
 */
link: string, 
/**
 * The line along which it slides.
 */
along: Line, } | { "edit": "dyad", 
/**
 * Its outer pairs, in turn.
 */
outer: [Outer, Outer], 
/**
 * Its inner pair.
 */
inner: Inner, } | { "edit": "triad", 
/**
 * The ends of its bars.
 */
ends: [End, End, End], } | { "edit": "wheel", 
/**
 * Its centre.
 */
end: End, } | { "edit": "mesh", 
/**
 * The links.
 */
links: [string, string], 
/**
 * Their numbers of teeth.
 */
teeth: [number, number], 
/**
 * Whether the larger wheel is a ring.
 */
internal: boolean, } | { "edit": "drive", 
/**
 * The link.
 */
link: string, } | { "edit": "fix", 
/**
 * The point.
 */
point: string, } | { "edit": "make_exact", } | { "edit": "weld", 
/**
 * The links: the first is fixed to the second, which may be the frame.
 */
links: [string, string], } | { "edit": "join", 
/**
 * The point to be removed, and the one that stays.
 */
points: [string, string], } | { "edit": "part", 
/**
 * The point.
 */
point: string, } | { "edit": "trace", 
/**
 * The link.
 */
link: string, 
/**
 * Its position in the drawing.
 */
at: [number, number], } | { "edit": "mass", 
/**
 * The link.
 */
link: string, 
/**
 * Its position in the drawing.
 */
at: [number, number] | null, } | { "edit": "move", 
/**
 * The points.
 */
points: Array<string>, 
/**
 * The displacement.
 */
by: [number, number], } | { "edit": "place", 
/**
 * The point.
 */
point: string, 
/**
 * The place.
 */
at: [number, number], } | { "edit": "stretch", 
/**
 * The link.
 */
link: string, 
/**
 * The new length.
 */
length: number, } | { "edit": "turn", 
/**
 * The link.
 */
link: string, 
/**
 * The direction from its first point to its second, degrees.
 */
angle_deg: number, } | { "edit": "rename", 
/**
 * The present name, of a point or a tracer, or else of a link.
 */
name: string, 
/**
 * The new name.
 */
to: string, } | { "edit": "remove", 
/**
 * Points and tracers.
 */
points: Array<string>, 
/**
 * Links.
 */
links: Array<string>, } | { "edit": "paste", 
/**
 * The drawing to be added.
 */
drawing: LinkageDocument, 
/**
 * Its displacement.
 */
by: [number, number], } | { "edit": "mirror", 
/**
 * The points.
 */
points: Array<string>, } | { "edit": "lock", 
/**
 * Two or three points.
 */
points: Array<string>, };
export type End = { "point": string } | { "at": [number, number] } | { "on": [string, [number, number]] };
export type Line = { "link": string } | { "toward": [number, number] };
export type Outer = { "hinge": End } | { "slide": [string, [number, number]] } | { "level": [number, number] };
export type Inner = "hinge" | "slide";
export type Mend = { "drive": string } | { "release": string } | { "remove": string } | { "fix": string } | { "exact": { 
/**
 * The point that moves farthest.
 */
point: string, 
/**
 * Length of its move.
 */
by: number, } };
