// Boxes around runs of points, so that what is drawn of a long path looks only at what lies there.

/** Points of a run. */
export const CHUNK = 256;

export class Chunks {
  /** @param {Float64Array} xyz */
  constructor(xyz) {
    const points = xyz.length / 3;
    this.count = Math.ceil(points / CHUNK);
    /** Least X, Y and Z of each run, then greatest. */
    this.boxes = new Float64Array(6 * this.count);
    this.measure(xyz, 0, points);
  }

  /**
   * Takes the boxes around some points anew.
   * @param {Float64Array} xyz
   * @param {number} first
   * @param {number} end  behind the last point
   */
  measure(xyz, first, end) {
    const points = xyz.length / 3;
    // A point belongs to the box before and to the one behind it, too, where it stands at an edge.
    const from = Math.max(0, Math.floor((first - 1) / CHUNK));
    for (let chunk = from; chunk < this.count && chunk * CHUNK <= end; chunk += 1) {
      // With the point before it and the one behind it: the ways to its neighbours are its own too.
      const start = Math.max(0, chunk * CHUNK - 1);
      const stop = Math.min(points, (chunk + 1) * CHUNK + 1);
      for (let axis = 0; axis < 3; axis += 1) {
        let least = Infinity;
        let greatest = -Infinity;
        for (let i = 3 * start + axis; i < 3 * stop; i += 3) {
          const value = xyz[i];
          if (value < least) least = value;
          if (value > greatest) greatest = value;
        }
        this.boxes[6 * chunk + axis] = least;
        this.boxes[6 * chunk + 3 + axis] = greatest;
      }
    }
  }

  /**
   * Nothing of a run lies in a part of a plane.
   * @param {number} chunk
   * @param {[number, number]} axes
   * @param {[number, number, number, number]} part  least and greatest of the first axis, then of the second
   */
  isOff(chunk, [across, up], [left, right, bottom, top]) {
    const { boxes } = this;
    const at = 6 * chunk;
    return boxes[at + across] > right || boxes[at + 3 + across] < left || boxes[at + up] > top || boxes[at + 3 + up] < bottom;
  }
}

/** By the points of the path. @type {WeakMap<Float64Array, Chunks>} */
const known = new WeakMap();

/**
 * The runs of a path, made when it is drawn first.
 * @param {import('nctape').Path} path
 */
export function chunksOf({ xyz }) {
  let chunks = known.get(xyz);
  if (chunks === undefined) known.set(xyz, (chunks = new Chunks(xyz)));
  return chunks;
}

/**
 * Some points of a path were changed where they stand.
 * @param {Float64Array} xyz
 * @param {number} from
 * @param {number} to  behind the last point
 */
export const pointsChanged = (xyz, from, to) => known.get(xyz)?.measure(xyz, from, to);
