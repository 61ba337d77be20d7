// Conversion between degrees, used on the page and in the state, and radians, used by the engine.

/** @param {number} degrees */
export function radians(degrees) {
  return (degrees * Math.PI) / 180;
}

/** @param {number} angle in radians */
export function degrees(angle) {
  return (angle * 180) / Math.PI;
}
