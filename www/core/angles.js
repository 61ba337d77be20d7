// Conversion between degrees, for the screen and the state, and radians, for the engine.

/** @param {number} degrees */
export function radians(degrees) {
  return (degrees * Math.PI) / 180;
}

/** @param {number} angle in radians */
export function degrees(angle) {
  return (angle * 180) / Math.PI;
}
