// How far along a span the tool is: a place on its flattened points.
import { pointsOf } from '../plot/draw.js';
import { countWhile } from '../sorted.js';

/** @typedef {import('nctape').Path} Path */

/** The lengths along one span, kept while the tool is on it. @type {{ path: Path, span: number, from: number, lengths: Float64Array } | null} */
let kept = null;

/**
 * @param {Path} path
 * @param {number} span
 */
function measured(path, span) {
  if (kept?.path === path && kept.span === span) return kept;
  const [from, to] = pointsOf(path, span);
  const { xyz } = path;
  const lengths = new Float64Array(Math.max(0, to - from));
  for (let i = 1; i < lengths.length; i += 1) {
    const at = 3 * (from + i);
    const step = Math.hypot(xyz[at] - xyz[at - 3], xyz[at + 1] - xyz[at - 2], xyz[at + 2] - xyz[at - 1]);
    lengths[i] = lengths[i - 1] + step;
  }
  kept = { path, span, from, lengths };
  return kept;
}

/**
 * The place of the tool, and the points of the span that lie behind it.
 * @param {Path} path
 * @param {number} span
 * @param {number} along  share of the span
 * @returns {{ place: number[], from: number, to: number } | null}  null where the path has no such span
 */
export function wayAlong(path, span, along) {
  const { from, lengths } = measured(path, span);
  if (lengths.length === 0) return null;
  const { xyz } = path;
  const point = (/** @type {number} */ i) => Array.from(xyz.subarray(3 * (from + i), 3 * (from + i) + 3));
  const last = lengths.length - 1;
  const way = along * lengths[last];
  if (along >= 1 || lengths[last] === 0) return { place: point(along >= 1 ? last : 0), from, to: from + last + 1 };
  const low = countWhile(last, (index) => lengths[index] <= way) - 1;
  const [one, other] = [point(low), point(low + 1)];
  const share = (way - lengths[low]) / (lengths[low + 1] - lengths[low] || 1);
  return { place: one.map((value, axis) => value + share * (other[axis] - value)), from, to: from + low + 1 };
}
