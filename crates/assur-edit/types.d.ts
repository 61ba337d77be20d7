// Written by the tests of this crate from its Rust: see src/types.rs.
import { LinkageDocument } from "assur/types/file.js";
export type Edit = { "edit": "point", at: [number, number], fixed: boolean, } | { "edit": "bar", ends: [End, End], } | { "edit": "corner", link: string, end: End, } | { "edit": "block", end: End, along: Line, } | { "edit": "slide", link: string, along: Line, } | { "edit": "dyad", outer: [Outer, Outer], inner: Inner, } | { "edit": "triad", ends: [End, End, End], } | { "edit": "wheel", end: End, } | { "edit": "mesh", links: [string, string], teeth: [number, number], internal: boolean, } | { "edit": "drive", link: string, } | { "edit": "fix", point: string, } | { "edit": "make_exact", } | { "edit": "weld", links: [string, string], } | { "edit": "join", points: [string, string], } | { "edit": "part", point: string, } | { "edit": "trace", link: string, at: [number, number], } | { "edit": "mass", link: string, at: [number, number] | null, } | { "edit": "move", points: Array<string>, by: [number, number], } | { "edit": "place", point: string, at: [number, number], } | { "edit": "stretch", link: string, length: number, } | { "edit": "turn", link: string, angle_deg: number, } | { "edit": "rename", name: string, to: string, } | { "edit": "remove", points: Array<string>, links: Array<string>, } | { "edit": "paste", drawing: LinkageDocument, by: [number, number], } | { "edit": "mirror", points: Array<string>, } | { "edit": "lock", points: Array<string>, };
export type End = { "point": string } | { "at": [number, number] } | { "on": [string, [number, number]] };
export type Inner = "hinge" | "slide";
export type Line = { "link": string } | { "toward": [number, number] };
export type Mend = { "drive": string } | { "release": string } | { "remove": string } | { "fix": string } | { "exact": { 
/**
 * The point that moves farthest.
 */
point: string, 
/**
 * Distance that this point moves.
 */
by: number, } };
export type Outer = { "hinge": End } | { "slide": [string, [number, number]] } | { "level": [number, number] };
