// Prints the indices of the engine's functions that a first view calls, as a JSON array. The script repeats the calls
// of a first view on a module that marks each function when it is called.
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [engine, marked] = process.argv.slice(2);
const { Simulator, defaultView, initSync, mixers, roleNames } = await import(pathToFileURL(path.join(engine, "assur_web.js")).href);
const marks = initSync({ module: readFileSync(marked) });

/** A context that draws nothing, on which all texts have the same width. */
const context = new Proxy({}, { get: () => () => ({ width: 1 }), set: () => true });

const [{ kind, document }] = mixers();
const simulator = new Simulator();
// The view of the page has these fields even if they are empty.
const { home } = simulator.set({ format: 2, kind, document, view: { ...defaultView(), against: null, lesson: null } });
simulator.readouts();
simulator.outputs();
simulator.transmissions();
simulator.labelNames();
simulator.lengths();
simulator.choosesLengths();
simulator.setSymbol(0);
simulator.plotsForces();
simulator.scene();
simulator.advance(home, 0.1);
simulator.at(home);
const palette = roleNames().map(() => [0, 0, 0]);
simulator.chart(context, { width: 400, height: 400, palette, scale: 1, ratio: 1, whole: false, only: "all", around: home });

const PREFIX = "called.";
const called = Object.keys(marks).filter((name) => name.startsWith(PREFIX) && marks[name].value === 1);
console.log(JSON.stringify(called.map((name) => Number(name.slice(PREFIX.length)))));
