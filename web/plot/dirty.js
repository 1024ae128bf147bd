// The part of the picture that a change of the path touches.
import { AXES } from './view.js';

/** @typedef {import('./view.js').Box} Box */

/** Lines, dots, the cross at the start and their smoothing reach so far beyond a point. */
export const REACH = 12;

/**
 * The box around some points of a path; null without a point.
 * @param {import('./view.js').View} view
 * @param {Float64Array} xyz
 * @param {number} from  first point
 * @param {number} to  behind the last point
 * @returns {Box | null}
 */
export function boxAround(view, xyz, from, to) {
  if (from >= to) return null;
  const [across, up] = AXES[view.plane];
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = from; i < to; i += 1) {
    const [x, y] = view.at(xyz[3 * i + across], xyz[3 * i + up]);
    left = Math.min(left, x - REACH);
    right = Math.max(right, x + REACH);
    top = Math.min(top, y - REACH);
    bottom = Math.max(bottom, y + REACH);
  }
  return { left, top, right, bottom };
}

/**
 * On whole pixels, so that nothing is smoothed twice at its edge; null where nothing of it is seen.
 * @param {Box} box
 * @param {import('./view.js').View} view
 * @param {number} ratio  device pixels for a CSS pixel
 * @returns {Box | null}
 */
export function seen(box, view, ratio) {
  const left = Math.max(0, Math.floor(box.left * ratio) / ratio);
  const top = Math.max(0, Math.floor(box.top * ratio) / ratio);
  const right = Math.min(view.width, Math.ceil(box.right * ratio) / ratio);
  const bottom = Math.min(view.height, Math.ceil(box.bottom * ratio) / ratio);
  return left < right && top < bottom ? { left, top, right, bottom } : null;
}
