// Peripheral wheels of the mixer: their number and their names.

/** `first`: the number shown for the first wheel. `least`, `most`: limits of the number of wheels. */
export const WHEELS = Object.freeze({ first: 5, least: 1, most: 6 });

/**
 * @param {string} link
 * @returns {number} index of the peripheral wheel, from 0; negative for other links
 */
export function wheelOf(link) {
  return link.startsWith("wheel") ? Number(link.slice(5)) - WHEELS.first : -1;
}

/**
 * @param {number} index of a peripheral wheel, from 0
 * @returns {string} name of the link
 */
export function wheelLink(index) {
  return `wheel${index + WHEELS.first}`;
}
