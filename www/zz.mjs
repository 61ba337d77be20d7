import { newEngine, stateOf } from "assur/tests/engine.js";
const id = process.env.MECH ?? "class4-dwell";
const engine = newEngine();
const n = Number(process.env.N ?? 150);
const state = stateOf(engine, id);
const link = state.document.links.find((l) => l.length !== undefined) ?? null;
const times = [];
for (let k = 0; k < n; k++) {
  const document = structuredClone(state.document);
  if (link) document.links[state.document.links.indexOf(link)].length *= 1 + 1e-9 * k;
  const one = { ...state, document };
  const t = performance.now();
  engine.set(one);
  times.push(performance.now() - t);
}
times.sort((a, b) => a - b);
console.log(id, times[n >> 1].toFixed(4), times[0].toFixed(4));
