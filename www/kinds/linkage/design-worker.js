// The search for a dwell, beside the page: one mechanism after the other is judged, and each is told. The import map of the
// page does not hold here, so that the page says where the engine is. After a better one it waits until the page has shown it;
// it is stopped from outside.

/** Goes on with the search. */
let goOn = () => {};

addEventListener("message", ({ data }) => {
  if (data.engine) search(data);
  else goOn();
});

/** @param {{ engine: string, wasm: ArrayBuffer, state: object, wishes: object }} task address and wasm of the engine, arguments of its Design */
async function search({ engine, wasm, state, wishes }) {
  try {
    const { default: load, Design } = await import(engine);
    await load({ module_or_path: wasm });
    const design = new Design(state, wishes);
    let progress;
    do {
      progress = design.step();
      postMessage({ progress });
      if (progress.accepted) await new Promise((resolve) => (goOn = () => resolve(undefined)));
    } while (!progress.end);
  } catch (thrown) {
    if (!Array.isArray(thrown)) console.error(thrown);
    postMessage({ problems: Array.isArray(thrown) ? thrown : [{ code: "not_arrived" }] });
  }
}
