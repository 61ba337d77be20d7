// The drawing with the plots beside it, as the sheet of an animation.

/** @typedef {import("assur/app/page.js").Page} Page */

/**
 * @param {Page} page
 * @param {import("assur/export/moments.js").Wishes} wishes
 * @returns {import("assur/export/pictures.js").Sheet} the drawing, with the plots to its right if they are wished for
 */
export function sheetOf({ mechanism, chart }, { plots = false }) {
  if (!plots) return mechanism.sheet();
  const { width, height } = chart.size;
  const sheet = mechanism.sheet(0, height);
  const left = sheet.size.width;
  const size = { width: left + width, height: sheet.size.height };
  /** @type {import("assur/export/pictures.js").Sheet["begin"]} */
  const begin = (theme, newPath, places) => {
    const { ground, moment } = sheet.begin(theme, newPath, places);
    /** @type {import("assur/export/pictures.js").Drawing["moment"]} */
    const both = (target, here, labelled) => {
      moment(target, here, labelled);
      const { context, ratio } = target;
      // The drawing may reach beyond its part of the sheet.
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.fillStyle = theme.colours.paper;
      context.fillRect(left, 0, width, size.height);
      context.setTransform(ratio, 0, 0, ratio, left * ratio, ((size.height - height) / 2) * ratio);
      if (here) chart.paintAt(target, theme, here);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
    };
    return { ground, moment: both };
  };
  return { size, begin };
}
