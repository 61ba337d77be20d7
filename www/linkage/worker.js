// The search for a dwell, beside the page: one mechanism after the other is judged, and each is told. The import map of the
// page does not hold here, so that the page says where the engine is. It is stopped from outside.

addEventListener("message", async ({ data: { engine, wasm, state, wishes } }) => {
  try {
    const { default: load, Design } = await import(engine);
    await load({ module_or_path: fetch(wasm) });
    const design = new Design(state, wishes);
    let progress;
    do {
      progress = design.step();
      postMessage({ progress });
    } while (!progress.end);
  } catch (thrown) {
    if (!Array.isArray(thrown)) console.error(thrown);
    postMessage({ problems: Array.isArray(thrown) ? thrown : [{ code: "not_arrived" }] });
  }
});
