// A valid state damaged in many ways, as an address and as a file; and a second reader of addresses, written from the rules of
// ARCHITECTURE.md alone.

/** Number of kinds of damage. */
export const KINDS = 12;

export const sound = () => ({
  format: 1,
  lesson: "mixer",
  document: {
    l1: 0.37, l2: 0.85, l3: 1, l4: 0.85, z4: 36,
    wheels: [{ z: 24, centre_line_deg: -40 }, { z: 18, centre_line_deg: 90 }],
    mesh: "internal", module: 0.0165, assembly: 2,
    tracers: [{ link: "coupler", x: 0.4, y: 0.2 }],
  },
  view: {
    phi_deg: 100.5, playing: false, direction: -1, speed: 2, traces: false,
    centres: true, vectors: false, loop_vectors: false, transmission: true,
    plot: "C2", axes: "physical", omega: 2, omega_unit: "per_min", epsilon: 0.5,
    true_time: false, differenced: true, step: 0, lang: "en",
  },
});

/** Senseless values of fields, as JSON. */
const NONSENSE = [
  "null", "[]", "{}", "[[[{}]]]",
  "\"<img src=x onerror='window.hurt=1'>\"", "\"<script>window.hurt=1</script>\"", "\"javascript:window.hurt=1\"",
  "\"\"", "\"NaN\"", "\"0.5; window.hurt=1\"",
  "1e300", "-1e300", "-7", "0.3333", "1e-320",
  "{\"__proto__\":{\"hurt\":1}}", "{\"constructor\":{\"prototype\":{\"hurt\":1}}}", "{\"toString\":1,\"valueOf\":1}", "{\"length\":1e9}",
  `"${"9".repeat(400_010)}"`, `${"[".repeat(20)}${"]".repeat(20)}`,
];

const KEYS = ["__proto__", "constructor", "prototype", "toString", "<img src=x onerror=window.hurt=1>", "hasOwnProperty", "", "\u202el1"];
const JUNK = ["<", "\"", "'", "%", "%E0%A4%A", "%C0%80", "%u0041", "&", "=", "{", "]", "\\", "\u0000", "💥"];
const PARTS = ["d.", "v.", ""];

/** @typedef {import("./random.js").Dice} Dice */

/**
 * Damages a text without regard to its form.
 * @param {Dice} dice
 * @param {string} text
 * @param {number} kind
 */
function blind(dice, text, kind) {
  const from = 1 + dice.below(text.length - 2);
  const to = Math.min(from + 1 + dice.below(12), text.length - 1);
  const [before, after] = [text.slice(0, from), text.slice(to)];
  if (kind === 0) return before;
  if (kind === 1) return before + after;
  if (kind === 2) return before + dice.one(JUNK) + text.slice(from);
  if (kind === 3) return text.slice(from) + before;
  return before + text.slice(from, to).toUpperCase() + after;
}

/** @param {ReturnType<typeof sound>} state */
function pairsOf({ lesson, document, view }) {
  const text = (value) => (typeof value === "string" ? value : JSON.stringify(value));
  const part = (start, values) => Object.entries(values).map(([key, value]) => [start + key, text(value)]);
  return [["lesson", lesson], ...part("d.", document), ...part("v.", view)];
}

const encoded = (text) => encodeURIComponent(text).replaceAll("%2C", ",");

/** @param {string[][]} pairs */
export function address(pairs = pairsOf(sound()), version = "1") {
  return [version, ...pairs.map(([key, value]) => `${encoded(key)}=${encoded(value)}`)].join("&");
}

/**
 * @param {Dice} dice
 * @param {number} kind
 */
export function damagedAddress(dice, kind) {
  const all = pairsOf(sound());
  const at = dice.below(all.length);
  const bad = dice.one(NONSENSE);
  if (kind === 5) all[at][1] = bad;
  else if (kind === 6) all[at][0] = dice.one(KEYS);
  else if (kind === 7) all[at][0] = dice.one(PARTS) + dice.one(KEYS);
  else if (kind === 8) all.push([all[at][0], bad]);
  else if (kind === 9) all.splice(at, 1);
  else if (kind === 10) return address(all, dice.one(["0", "2", "", "1.0", "1;", "<b>", "-1"]));
  else if (kind === 11) {
    // An additional key. In one of eight cases it is the only damage, and the address may still hold a state.
    all.push([dice.one(PARTS) + dice.one(KEYS), dice.one(["1", "{\"hurt\":1}", "x"])]);
    if (dice.below(8) > 0) all[at][1] += dice.one(["!", "<", "e", " 1"]);
  } else return blind(dice, address(all), kind);
  return address(all);
}

/**
 * @param {Dice} dice
 * @param {number} kind
 */
export function damagedFile(dice, kind) {
  const state = sound();
  const part = dice.one(["document", "view"]);
  const key = dice.one(Object.keys(state[part]));
  const bad = dice.one(NONSENSE);
  const text = JSON.stringify(state);
  const entry = `"${key}":${JSON.stringify(state[part][key])}`;
  const instead = (other) => text.replace(entry, () => other);
  if (kind === 5) return instead(`"${key}":${bad}`);
  if (kind === 6) return instead(entry.replace(key, encoded(dice.one(KEYS))));
  if (kind === 7) {
    const whole = JSON.stringify(dice.one(["format", "lesson", "document", "view"]));
    return `{${Object.entries(state).map(([name, value]) => `${JSON.stringify(name)}:${JSON.stringify(name) === whole ? bad : JSON.stringify(value)}`).join()}}`;
  }
  if (kind === 8) return instead(`${entry},"${key}":${bad}`);
  if (kind === 9) {
    delete state[part][key];
    return JSON.stringify(state);
  }
  if (kind === 10) return bad;
  if (kind === 11) {
    const own = JSON.stringify(dice.one(KEYS));
    return instead(dice.below(8) > 0 ? `"${key}":[${own}],${own}:{"hurt":1}` : `${entry},${own}:{"hurt":1}`);
  }
  return blind(dice, text, kind);
}

/** Keys of an address besides those of document and view, by version. */
const EXTRAS = { 1: ["lesson"], 2: ["kind", "lesson", "compared"] };

/**
 * @param {string} hash
 * @returns {object | null} the state in the address; null if the address cannot be read
 */
export function held(hash) {
  if (hash.length > 400_000) return null;
  const [version, ...pairs] = hash.split("&");
  if (version !== "1" && version !== "2") return null;
  const state = { format: Number(version), document: {}, view: {} };
  const put = (of, key, value) => Object.defineProperty(of, key, { value, enumerable: true, writable: true, configurable: true });
  for (const pair of pairs) {
    const at = pair.indexOf("=");
    let [key, value] = at < 0 ? [pair, null] : [pair.slice(0, at), pair.slice(at + 1)];
    try {
      key = decodeURIComponent(key);
      value = value === null ? null : decodeURIComponent(value);
    } catch {
      return null;
    }
    try {
      if (value !== null) value = JSON.parse(value);
    } catch {
      // A value that is not JSON is text.
    }
    if (key.startsWith("d.")) put(state.document, key.slice(2), value);
    else if (key.startsWith("v.")) put(state.view, key.slice(2), value);
    else if (EXTRAS[version].includes(key)) put(state, key, value);
  }
  return state;
}

/**
 * @param {unknown} value
 * @returns {number} depth of nesting
 */
export function depth(value) {
  if (typeof value !== "object" || value === null) return 0;
  return 1 + Math.max(0, ...Object.values(value).map(depth));
}
