// Degrees live at the screen and in the state, radians in the engine.

/** @param {number} degrees */
export function radians(degrees) {
  return (degrees * Math.PI) / 180;
}

/** @param {number} angle in radians */
export function degrees(angle) {
  return (angle * 180) / Math.PI;
}

/**
 * The same position of the crank, brought onto the angle axis. Both ends of the axis stay as they are.
 * @param {number} phiDeg
 * @param {{ start: number, end: number }} cycle in radians
 * @returns {number} in degrees
 */
export function ontoAxis(phiDeg, cycle) {
  const start = degrees(cycle.start);
  const period = degrees(cycle.end - cycle.start);
  if (phiDeg >= start && phiDeg <= start + period) return phiDeg;
  return phiDeg - period * Math.floor((phiDeg - start) / period);
}
