// What the page asks of the tape, one question for each view. Runs in the worker.
import { Tape as Other } from 'nctape';
import { replayQuestions } from './replay/stretch.js';
import { firstAtOrAfter } from './sorted.js';

/** @typedef {import('nctape').Tape} Tape */
/** @typedef {import('nctape').Diagnostic} Diagnostic */
/** @typedef {import('nctape').Severity} Severity */

/** @typedef {{ syntax: import('nctape').Syntax, diagnostics: Diagnostic[] }} Listing  what the editor marks */

/**
 * A stretch of rows with all that is drawn around it.
 * @typedef {object} StripWindow
 * @property {import('nctape').RowWindow} rows
 * @property {{ row: number, text: string, index: number }[]} names  the numbers of the blocks here, with the row where each begins
 * @property {Uint8Array} marks  for each row: 0, or the worst severity there, as an index into `SEVERITIES` plus 1
 */

/** From mild to bad. @type {Severity[]} */
const SEVERITIES = ['info', 'warning', 'error'];
const MOST_LISTED = 500;
const MOST_MARKS = 1000;
/** More blocks than any tape has. */
const EVERY = 0xffff_ffff;
/** So many blocks tell whether a format fits. */
const MOST_JUDGED = 500;

export const questions = {
  ...replayQuestions,

  /**
   * The path of the cutter's centre, where cutter compensation is in force.
   * @param {Tape} tape
   * @param {number} tolerance
   */
  offset: (tape, tolerance) => tape.offset(tolerance),

  /**
   * The axes beyond X, Y and Z along the path.
   * @param {Tape} tape
   */
  axes: (tape) => tape.axes(),

  /**
   * Where an offset lies in every view.
   * @param {Tape} tape
   * @param {number} offset
   * @returns {import('./store.js').Here}
   */
  locate(tape, offset) {
    const index = tape.blockAt(offset);
    const block = index < 0 ? null : tape.block(index);
    const span = block === null || block.span === null ? null : tape.span(block.span);
    return { offset, row: tape.rowAt(offset), block, span };
  },

  /**
   * Blocks and diagnostics that touch a stretch of the text.
   * @param {Tape} tape
   * @param {number} from
   * @param {number} to
   * @returns {Listing}
   */
  listing: (tape, from, to) => ({
    syntax: tape.syntax(from, to, MOST_LISTED),
    diagnostics: tape.diagnostics(from, to, MOST_LISTED),
  }),

  /**
   * @param {Tape} tape
   * @param {number} first
   * @param {number} count
   * @returns {StripWindow}
   */
  strip(tape, first, count) {
    const rows = tape.rows(first, count);
    const size = rows.bytes.length;
    const names = [];
    for (let i = 0; i < size; i += 1) {
      const index = rows.blocks[i];
      if (index < 0 || (i > 0 && rows.blocks[i - 1] === index)) continue;
      const block = tape.block(index);
      if (block !== null && block.sequence !== null) names.push({ row: block.rows[0], text: block.sequence, index });
    }
    return { rows, names, marks: marksOf(tape, rows) };
  },

  /**
   * @param {Tape} tape
   * @param {number} from
   * @param {number} to
   * @param {number} limit
   */
  problems: (tape, from, to, limit) => tape.diagnostics(from, to, limit),

  /**
   * Most blocks have an error.
   * @param {Tape} tape
   * @param {number} blocks
   */
  misfits(tape, blocks) {
    const judged = Math.min(blocks, MOST_JUDGED);
    const end = judged === 0 ? 0 : (tape.block(judged - 1)?.to ?? 0);
    const errors = tape.diagnostics(0, end, 4 * MOST_JUDGED).filter(({ severity }) => severity === 'error');
    return new Set(errors.map(({ from }) => tape.blockAt(from))).size * 2 > judged;
  },

  /**
   * The first span that moves in a time that is not known, with its block; null if there is none.
   * @param {Tape} tape
   */
  untimed(tape) {
    const index = tape.untimed();
    const span = index < 0 ? null : tape.span(index);
    return span === null ? null : { kind: span.kind, block: tape.block(span.blocks[0]) };
  },

  /** @param {Tape} tape @param {number} tolerance @param {number} since */
  pathChange: (tape, tolerance, since) => tape.pathChange(tolerance, since),

  /**
   * A span with the block that ends it.
   * @param {Tape} tape
   * @param {number} index
   */
  span(tape, index) {
    const span = tape.span(index);
    return span === null ? null : { span, block: tape.block(span.blocks[1]) };
  },

  /**
   * The first row of the next block before or behind a row, which need not lie in a block; null where there is none.
   * @param {Tape} tape
   * @param {number} row
   * @param {1 | -1} direction
   */
  blockBeside(tape, row, direction) {
    const at = tape.blockOfRow(row);
    const index = at >= 0 ? at + direction : blockFromRow(tape, row, direction);
    return index < 0 ? null : (tape.block(index)?.rows[0] ?? null);
  },

  /**
   * Where there is something to be seen of a tape: the block of its first span, else of the first word.
   * @param {Tape} tape
   */
  sight(tape) {
    const span = tape.span(0);
    return tape.block(span === null ? 0 : span.blocks[0])?.from ?? 0;
  },

  /**
   * How long every block takes to execute and to read, and the whole in words.
   * @param {Tape} tape
   */
  times: (tape) => ({ times: tape.times(0, EVERY), sentences: tape.time().sentences }),

  /** @param {Tape} tape @param {number} index */
  block: (tape, index) => tape.block(index),

  /**
   * The block of this sequence number, else the one at this place, counted from 1; null if there is none.
   * @param {Tape} tape
   * @param {string} name
   */
  blockNamed(tape, name) {
    for (let index = 0; ; index += 1) {
      const block = tape.block(index);
      if (block === null) break;
      if (block.sequence === name) return block;
    }
    return /^\d{1,9}$/.test(name) && Number(name) > 0 ? tape.block(Number(name) - 1) : null;
  },

  /**
   * The path is that of another tape.
   * @param {Tape} tape
   * @param {string} source  of the other
   * @param {import('nctape').Format} format  of the other
   * @param {number} tolerance  in the unit of the tape
   */
  samePath(tape, source, format, tolerance) {
    const other = new Other(source, format);
    try {
      return tape.samePath(other, tolerance);
    } finally {
      other.free();
    }
  },

  /** Where the cursor goes for a span. @param {Tape} tape @param {number} index @returns {number | null} */
  spanPlace: (tape, index) => tape.block(tape.span(index)?.blocks[0] ?? -1)?.from ?? null,
};

/**
 * The nearest block from a row that belongs to none, -1 if there is none in that direction.
 * @param {Tape} tape
 * @param {number} row
 * @param {1 | -1} direction
 */
function blockFromRow(tape, row, direction) {
  if (row < 0) return direction > 0 && tape.block(0) !== null ? 0 : -1;
  const ROWS = 1024;
  for (let first = direction > 0 ? row : row - ROWS + 1; ; first += direction * ROWS) {
    const start = Math.max(0, first);
    const { blocks } = tape.rows(start, first + ROWS - start);
    const found = (direction > 0 ? blocks : blocks.slice().reverse()).find((index) => index >= 0);
    if (found !== undefined) return found;
    if (first <= 0 && direction < 0) return -1;
    if (blocks.length === 0) return -1;
  }
}

/**
 * @param {Tape} tape
 * @param {import('nctape').RowWindow} rows
 */
function marksOf(tape, rows) {
  const size = rows.bytes.length;
  const marks = new Uint8Array(size);
  if (size === 0) return marks;
  const { offsets } = rows;
  for (const problem of tape.diagnostics(offsets[0], offsets[size - 1] + 1, MOST_MARKS)) {
    const level = SEVERITIES.indexOf(problem.severity) + 1;
    const end = Math.max(problem.to, problem.from + 1);
    for (let i = firstAtOrAfter(offsets, problem.from); i < size && offsets[i] < end; i += 1) {
      marks[i] = Math.max(marks[i], level);
    }
  }
  return marks;
}
