// From lengths to the picture and back: a plane, a scale, a middle.

/** @typedef {import('nctape').Plane} Plane */
/** @typedef {[number, number, number]} Point3 */
/** @typedef {import('nctape').Summary['bounds']} Bounds */
/** A part of the picture in CSS pixels. @typedef {{ left: number, top: number, right: number, bottom: number }} Box */

/** The first axis of a plane goes to the right, the second up. @type {Record<Plane, [number, number]>} */
export const AXES = { xy: [0, 1], zx: [2, 0], yz: [1, 2] };
/** @type {Plane[]} */
export const PLANES = ['xy', 'zx', 'yz'];

/** Pixels for one unit of length, at least and at most. */
const SCALES = [1e-5, 1e6];

export class View {
  constructor() {
    /** @type {Plane} */
    this.plane = 'xy';
    /** CSS pixels for one unit of length. */
    this.scale = 10;
    /** What is in the middle of the picture. */
    this.middle = [0, 0];
    this.width = 1;
    this.height = 1;
    /** Room for the read-out and the labels at the edges. */
    this.margin = { left: 44, right: 28, top: 40, bottom: 56 };
  }

  /** The whole picture. @returns {Box} */
  box() {
    return { left: 0, top: 0, right: this.width, bottom: this.height };
  }

  /** @param {ArrayLike<number>} point  a place in space */
  toScreen(point) {
    const [across, up] = AXES[this.plane];
    return this.at(point[across] ?? 0, point[up] ?? 0);
  }

  /**
   * @param {number} u
   * @param {number} v
   * @returns {[number, number]}
   */
  at(u, v) {
    return [
      this.width / 2 + (u - this.middle[0]) * this.scale,
      this.height / 2 - (v - this.middle[1]) * this.scale,
    ];
  }

  /**
   * @param {number} x
   * @param {number} y
   * @returns {[number, number]}
   */
  toWorld(x, y) {
    return [
      this.middle[0] + (x - this.width / 2) / this.scale,
      this.middle[1] - (y - this.height / 2) / this.scale,
    ];
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  panBy(x, y) {
    this.middle = [this.middle[0] - x / this.scale, this.middle[1] + y / this.scale];
  }

  /**
   * Nearer by a factor; what is at this place of the picture stays there.
   * @param {number} factor
   * @param {number} [x]
   * @param {number} [y]
   */
  zoomBy(factor, x = this.width / 2, y = this.height / 2) {
    const [u, v] = this.toWorld(x, y);
    this.scale = Math.max(SCALES[0], Math.min(SCALES[1], this.scale * factor));
    const [nowX, nowY] = this.at(u, v);
    this.panBy(x - nowX, y - nowY);
  }

  /** @param {Bounds} bounds */
  fit(bounds) {
    Object.assign(this, this.fitting(bounds));
  }

  /**
   * The scale and the middle under which all within the bounds is seen.
   * @param {Bounds} bounds
   */
  fitting(bounds) {
    const [across, up] = AXES[this.plane];
    const { left, right, top, bottom } = this.margin;
    const min = bounds === null ? [0, 0] : [bounds.min[across], bounds.min[up]];
    const max = bounds === null ? [100, 100] : [bounds.max[across], bounds.max[up]];
    const wide = Math.max(1, this.width - left - right);
    const high = Math.max(1, this.height - top - bottom);
    const widest = Math.min(wide / Math.max(max[0] - min[0], 1e-9), high / Math.max(max[1] - min[1], 1e-9));
    const scale = Math.max(SCALES[0], Math.min(Math.min(SCALES[1], widest), 1e4));
    const middle = [
      (min[0] + max[0]) / 2 - (left - right) / 2 / scale,
      (min[1] + max[1]) / 2 + (top - bottom) / 2 / scale,
    ];
    return { scale, middle };
  }
}

/**
 * All within the bounds is in the picture, and no smaller than a fifth of it.
 * @param {View} view
 * @param {Bounds} bounds
 */
export function isSeen(view, bounds) {
  if (bounds === null) return true;
  const [left, bottom] = view.toScreen(bounds.min);
  const [right, top] = view.toScreen(bounds.max);
  const inside = left >= 0 && right <= view.width && top >= 0 && bottom <= view.height;
  return inside && (right - left > view.width / 5 || bottom - top > view.height / 5);
}

/**
 * One is so much larger than the other that a view of the one shows nothing of the other.
 * @param {Bounds} one
 * @param {Bounds} other
 */
export function isAnotherSize(one, other) {
  if (one === null || other === null) return one !== other;
  const [a, b] = [one, other].map(({ min, max }) => Math.hypot(...max.map((value, axis) => value - min[axis])));
  return a > 2 * b || b > 2 * a;
}
