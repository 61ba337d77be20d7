// The peripheral wheels of the mixer: how many there may be, and how they are called.

/** The number of the first as readers count, and how many there may be. */
export const WHEELS = Object.freeze({ first: 5, least: 1, most: 6 });

/**
 * @param {string} link
 * @returns {number} which peripheral wheel it is, from 0; below 0 where it is none
 */
export function wheelOf(link) {
  return link.startsWith("wheel") ? Number(link.slice(5)) - WHEELS.first : -1;
}

/**
 * @param {number} index of a peripheral wheel, from 0
 * @returns {string} the link's name
 */
export function wheelLink(index) {
  return `wheel${index + WHEELS.first}`;
}
