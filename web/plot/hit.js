// Which span is under the pointer.
import { AXES } from './view.js';

/** So many pixels away a span is still meant. */
const REACH = 12;

/**
 * The nearest span, or null if none is near; of equally near ones the last, which lies on top.
 * @param {import('./view.js').View} view
 * @param {import('nctape').Path} path
 * @param {number} x
 * @param {number} y
 */
export function spanAt(view, { xyz, span }, x, y) {
  const [across, up] = AXES[view.plane];
  const [u, v] = view.toWorld(x, y);
  let best = (REACH / view.scale) ** 2;
  /** @type {number | null} */
  let found = null;
  for (let i = 1; i < span.length; i += 1) {
    if (span[i] !== span[i - 1]) continue;
    const distance = squaredDistance(
      u,
      v,
      xyz[3 * i - 3 + across],
      xyz[3 * i - 3 + up],
      xyz[3 * i + across],
      xyz[3 * i + up],
    );
    if (distance <= best) {
      best = distance;
      found = span[i];
    }
  }
  return found;
}

/**
 * From a place to a stretch of line.
 * @param {number} u
 * @param {number} v
 * @param {number} fromU
 * @param {number} fromV
 * @param {number} toU
 * @param {number} toV
 */
function squaredDistance(u, v, fromU, fromV, toU, toV) {
  const wayU = toU - fromU;
  const wayV = toV - fromV;
  const square = wayU * wayU + wayV * wayV;
  const share = square === 0 ? 0 : Math.max(0, Math.min(1, ((u - fromU) * wayU + (v - fromV) * wayV) / square));
  return (u - fromU - share * wayU) ** 2 + (v - fromV - share * wayV) ** 2;
}
