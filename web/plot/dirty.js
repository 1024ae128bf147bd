// The part of the picture that a change of the path touches.
import { AXES } from './view.js';

/** @typedef {import('./view.js').Box} Box */

/** Lines, dots, the cross at the start and their smoothing reach so far beyond a point. */
export const REACH = 12;

/** Boxes along a line are about so large, in pixels: one around a line across the picture would hold all of it. */
const PIECE = 128;
/** More of them than this are dearer than the one around all of them. */
const MOST = 24;
/** So many points are all over the picture, mostly. */
const MANY = 1000;

/**
 * Boxes around some points of a path and the lines between them; none without a point.
 * @param {import('./view.js').View} view
 * @param {Float64Array} xyz
 * @param {number} from  first point
 * @param {number} to  behind the last point
 * @returns {Box[]}
 */
export function boxesAlong(view, xyz, from, to) {
  /** @type {Box[]} */
  const boxes = [];
  /** @type {Place | null} */
  let before = null;
  for (const place of to - from > MANY ? points(view, xyz, from, to) : stations(view, xyz, from, to)) {
    const last = boxes.at(-1);
    const wider = last && joined(last, around(place));
    if (wider && (isSmall(wider) || to - from > MANY)) Object.assign(last, wider);
    else boxes.push(joined(around(before ?? place), around(place)));
    before = place;
  }
  return boxes.length > MOST ? [boxes.reduce(joined)] : boxes;
}

/** @typedef {[x: number, y: number]} Place  in the picture */

/**
 * Where the points are in the picture.
 * @param {import('./view.js').View} view
 * @param {Float64Array} xyz
 * @param {number} from
 * @param {number} to
 * @returns {Generator<Place>}
 */
function* points(view, xyz, from, to) {
  const [across, up] = AXES[view.plane];
  for (let i = from; i < to; i += 1) yield view.at(xyz[3 * i + across], xyz[3 * i + up]);
}

/**
 * The same, and places on the lines between them, so that none is farther than `PIECE` from the next, or as many of them
 * as are worth it.
 * @param {import('./view.js').View} view
 * @param {Float64Array} xyz
 * @param {number} from
 * @param {number} to
 * @returns {Generator<Place>}
 */
function* stations(view, xyz, from, to) {
  /** @type {Place | null} */
  let before = null;
  for (const [x, y] of points(view, xyz, from, to)) {
    const [startX, startY] = before ?? [x, y];
    const [wayX, wayY] = [x - startX, y - startY];
    const pieces = Math.min(MOST + 1, Math.ceil(Math.max(Math.abs(wayX), Math.abs(wayY)) / PIECE));
    for (let piece = 1; piece < pieces; piece += 1) yield [startX + (wayX * piece) / pieces, startY + (wayY * piece) / pieces];
    yield [x, y];
    before = [x, y];
  }
}

/** @param {Place} place @returns {Box} */
const around = ([x, y]) => ({ left: x - REACH, top: y - REACH, right: x + REACH, bottom: y + REACH });

/** @param {Box} one @param {Box} other @returns {Box} */
const joined = (one, other) => ({
  left: Math.min(one.left, other.left),
  top: Math.min(one.top, other.top),
  right: Math.max(one.right, other.right),
  bottom: Math.max(one.bottom, other.bottom),
});

/** @param {Box} box */
const isSmall = ({ left, top, right, bottom }) => Math.max(right - left, bottom - top) <= PIECE + 2 * REACH;

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
