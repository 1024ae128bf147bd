// The tape as a line of time: which block, which row and which piece of the path belong to a moment, and back.
//
// Where the replay stands is a block and the share of it that is done; the row under the head has come as far
// through the block as the tool has.

import { countWhile } from '../sorted.js';

/** @typedef {import('nctape').Course} Course */
/** @typedef {{ block: number, share: number }} At */

const BEHIND_THE_END = 2;

/** Small against any row and any pixel: a share that near to 1 is done. */
const DONE = 1 - 1e-9;

export class Track {
  /** @param {Course} course */
  constructor(course) {
    this.course = course;
    this.blocks = course.seconds.length;
    /** When each block begins, and when the last one ends. */
    this.starts = new Float64Array(this.blocks + 1);
    for (let i = 0; i < this.blocks; i += 1) this.starts[i + 1] = this.starts[i] + course.seconds[i];
  }

  /** How long all of it takes. */
  get seconds() {
    return this.starts[this.blocks];
  }

  /** @param {At} at */
  timeOf({ block, share }) {
    return this.starts[block] + share * this.course.seconds[block];
  }

  /**
   * @param {number} seconds
   * @returns {At}
   */
  atTime(seconds) {
    const block = Math.max(0, Math.min(this.blocks - 1, behind(this.starts, seconds) - 1));
    const takes = this.course.seconds[block];
    return { block, share: takes > 0 ? between(0, (seconds - this.starts[block]) / takes, 1) : 1 };
  }

  /**
   * The row under the head, with its fraction: the first one of a block as it begins, the last one when it is done.
   * @param {At} at
   */
  rowOf({ block, share }) {
    const { rows } = this.course;
    return rows[2 * block] + share * Math.max(0, rows[2 * block + 1] - rows[2 * block] - 1);
  }

  /**
   * @param {number} row
   * @returns {At}
   */
  atRow(row) {
    const { rows } = this.course;
    const block = Math.max(0, countWhile(this.blocks, (index) => rows[2 * index] <= row) - 1);
    const way = rows[2 * block + 1] - rows[2 * block] - 1;
    return { block, share: way > 0 ? between(0, (row - rows[2 * block]) / way, 1) : 0 };
  }

  /**
   * The span that the tool is on and how far along it is; between motions, the end of the last one.
   * @param {At} at
   * @returns {{ span: number, along: number }}  span -1 where the path has none
   */
  toolAt({ block, share }) {
    const { spanEnds, spanSeconds } = this.course;
    const first = this.firstSpan(block);
    let left = share * this.course.seconds[block];
    for (let span = first; span < spanEnds[block]; span += 1) {
      const takes = spanSeconds[span];
      const isLast = span + 1 === spanEnds[block];
      if (left < takes || isLast) return { span, along: takes > 0 && share < DONE ? between(0, left / takes, 1) : 1 };
      left -= takes;
    }
    if (first > 0) return { span: first - 1, along: 1 };
    return { span: spanSeconds.length > 0 ? 0 : -1, along: 0 };
  }

  /**
   * Spans that are carried out with blocks before this one.
   * @param {number} block
   */
  firstSpan(block) {
    return block === 0 ? 0 : this.course.spanEnds[block - 1];
  }

  /** @param {number} block */
  moves(block) {
    return this.course.spanEnds[block] > this.firstSpan(block);
  }

  /**
   * Time goes on. Where it comes to a block behind which the control waits, it goes no further.
   * @param {At} at
   * @param {number} seconds
   * @param {boolean} single  it waits behind every block
   * @returns {{ at: At, stopped: boolean }}
   */
  advance({ block, share }, seconds, single) {
    const takes = this.course.seconds;
    let left = seconds + share * takes[block];
    for (; left >= takes[block]; block += 1) {
      if (this.waitsBehind(block, single)) return { at: { block, share: 1 }, stopped: true };
      left -= takes[block];
    }
    return { at: { block, share: left / takes[block] }, stopped: false };
  }

  /**
   * @param {number} block
   * @param {boolean} single
   */
  waitsBehind(block, single) {
    return single || this.course.stops[block] !== 0 || block + 1 >= this.blocks;
  }

  /**
   * Where play begins: behind a block that is done, with the next one that is executed, or else with the first.
   * @param {At} at
   * @returns {At}
   */
  begin({ block, share }) {
    if (share < DONE) return { block, share };
    const { fates } = this.course;
    let next = block + 1;
    while (next < this.blocks && fates[next] === BEHIND_THE_END) next += 1;
    return { block: next < this.blocks ? next : 0, share: 0 };
  }

  /**
   * One block more is done, or one less.
   * @param {At} at
   * @param {1 | -1} way
   * @returns {At}
   */
  byBlock({ block, share }, way) {
    const done = share >= DONE ? block : block - 1;
    const next = way > 0 ? done + 1 : share > 0 && share < DONE ? done : done - 1;
    return next < 0 ? { block: 0, share: 0 } : { block: Math.min(next, this.blocks - 1), share: 1 };
  }

  /**
   * To the end of the next span, or back to where the last one that is done or begun starts.
   * @param {At} at
   * @param {1 | -1} way
   * @returns {At}
   */
  bySpan(at, way) {
    const { spanEnds, spanSeconds } = this.course;
    const count = spanSeconds.length;
    if (count === 0) return at;
    const { span, along } = this.toolAt(at);
    const done = along >= DONE ? span + 1 : span;
    const next = way > 0 ? Math.min(done + 1, count) : along > 0 && along < DONE ? done : Math.max(0, done - 1);
    // The block with which the span before that place is carried out.
    const block = behind(spanEnds, Math.max(0, next - 1));
    if (next === 0) return { block, share: 0 };
    let seconds = 0;
    for (let index = this.firstSpan(block); index < next; index += 1) seconds += spanSeconds[index];
    const takes = this.course.seconds[block];
    return { block, share: next === spanEnds[block] || takes === 0 ? 1 : seconds / takes };
  }

  /**
   * @param {At} at
   * @param {1 | -1} way
   * @returns {At}
   */
  byRow(at, way) {
    const { rows } = this.course;
    const { block } = at;
    const row = Math.round(this.rowOf(at)) + way;
    if (rows[2 * block] <= row && row < rows[2 * block + 1]) return { ...this.atRow(row), block };
    const next = block + way;
    if (next < 0 || next >= this.blocks) return at;
    return { block: next, share: way > 0 ? 0 : 1 };
  }
}

/**
 * @param {number} least
 * @param {number} value
 * @param {number} most
 */
const between = (least, value, most) => Math.max(least, Math.min(most, value));

/**
 * How many of the rising numbers are at most this one.
 * @param {Float64Array | Uint32Array} rising
 * @param {number} value
 */
const behind = (rising, value) => countWhile(rising.length, (index) => rising[index] <= value);
