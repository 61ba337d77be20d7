// Cone of the directions of the moving links: all lengths are positive only if the frame's direction is in it.
import { makeSvg } from "assur/core/dom.js";

/** Names of the directions and roles of their colours, the frame's direction first. */
const LOOKS = Object.freeze([["e₀", "ink"], ["e₁", "coupler"], ["e₂", "rocker"], ["e₃", "crank"]]);

/** `NAME`: distance of a name from the centre. `FARTHER`: added if names would overlap. `SIZE`: half the picture. */
const NAME = 1.16;
const FARTHER = 0.22;
const SIZE = 1.5;

/** Angle between two directions, in radians, below which their names would overlap. */
const MIN_ANGLE = 0.2;

/**
 * @param {readonly [number, number, number, number]} turns angles of frame, coupler, output link and driver, in radians
 * @param {string} label
 * @returns {SVGElement}
 */
export function cone(turns, label) {
  const picture = makeSvg("svg", { viewBox: [-SIZE, -SIZE, 2 * SIZE, 2 * SIZE].join(" "), class: "cone", role: "img", "aria-label": label });
  picture.append(makeSvg("path", { d: sector(turns.slice(1)) }));
  for (const [k, turn] of turns.entries()) {
    const [name, role] = LOOKS[k];
    const [x, y] = at(turn, 1);
    const before = turns.slice(0, k).filter((other) => Math.abs(Math.sin((turn - other) / 2)) < MIN_ANGLE / 2).length;
    const [nameX, nameY] = at(turn, NAME + before * FARTHER);
    const line = makeSvg("line", { x1: 0, y1: 0, x2: x, y2: y });
    const text = makeSvg("text", { x: nameX, y: nameY }, [name]);
    for (const one of [line, text]) one.style.setProperty("--accent", `var(--role-${role})`);
    picture.append(line, text);
  }
  return picture;
}

/**
 * @param {readonly number[]} turns
 * @returns {string} path around all sums of positive multiples of the directions; the whole disc if all neighbouring
 * directions are less than half a turn apart
 */
function sector(turns) {
  const around = turns.map((turn) => (turn < 0 ? (turn % TURN) + TURN : turn % TURN)).sort((a, b) => a - b);
  const gaps = around.map((turn, k) => (k + 1 < around.length ? around[k + 1] : around[0] + TURN) - turn);
  const widest = gaps.indexOf(Math.max(...gaps));
  if (gaps[widest] < Math.PI) return "M1 0A1 1 0 1 0 -1 0A1 1 0 1 0 1 0Z";
  const from = around[widest] + gaps[widest];
  const to = around[widest] + TURN;
  return `M0 0L${at(from, 1).join(" ")}A1 1 0 0 0 ${at(to, 1).join(" ")}Z`;
}

const TURN = 2 * Math.PI;

/**
 * @param {number} turn
 * @param {number} far
 * @returns {[number, number]} the point in this direction at the distance `far`, with y downwards
 */
function at(turn, far) {
  return [far * Math.cos(turn), -far * Math.sin(turn)];
}
