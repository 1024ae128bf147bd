// CLDATA in the worker, with the tape that it became: what the page changes and asks. Runs in the worker.
//
// All of it is read, checked and posted anew at every change: a hundred thousand records take some tenths of a second,
// and what is typed meanwhile is sent as one change.
import * as nctape from 'nctape';
import { becameOf, cameFrom, placeBehind } from './links.js';

/** @typedef {import('../store.js').Here} Here */
/** @typedef {import('../store.js').Summary} Summary */

/** So many records or blocks are listed. */
const MOST_LISTED = 500;

let versions = 0;

export class CldataSource {
  /**
   * @param {string} source
   * @param {import('nctape').Format} format
   */
  constructor(source, format) {
    this.cldata = new nctape.Cldata(source, format);
    const { text, map } = this.cldata.posted();
    /** The tape that it became, and how often it was another one. */
    this.text = text;
    this.version = versions += 1;
    this.map = map;
    this.tape = this.cldata.postedTape();
  }

  free() {
    this.tape.free();
    this.cldata.free();
  }

  /**
   * @param {[from: number, to: number, insert: string][]} edits  from the last one to the first
   * @param {import('nctape').Format | null} format  null: as it was
   */
  alter(edits, format) {
    for (const [from, to, insert] of edits) this.cldata.edit(from, to, insert);
    if (format !== null) this.cldata.setFormat(format);
    const { text, map } = this.cldata.posted();
    if (text !== this.text) this.version = versions += 1;
    this.tape.free();
    Object.assign(this, { text, map, tape: this.cldata.postedTape() });
  }

  /** The path is that of the CLDATA, the paper that of the tape. @returns {Summary} */
  summary() {
    const own = this.cldata.summary();
    const tape = this.tape.summary();
    const { rows, tapeMillimetres, seconds } = tape.totals;
    return {
      ...own,
      code: tape.code,
      rows: tape.rows,
      skips: 0,
      compensated: false,
      totals: { ...own.totals, rows, tapeMillimetres, seconds },
      posted: { blocks: tape.blocks, errors: tape.errors, warnings: tape.warnings, incomplete: own.incomplete },
    };
  }

  /**
   * A record with the rows and the text that it became.
   * @param {number} index
   * @param {number} [span]  that is looked at, where it has several
   */
  record(index, span) {
    const [view] = index < 0 ? [] : this.cldata.records(index, 1);
    if (view === undefined) return { block: null, posted: null };
    const became = becameOf(this.map, view);
    const posted = became !== null && became.to > became.from ? became : null;
    return { block: { ...view, span: span ?? view.span, rows: this.rowsOf(posted) }, posted };
  }

  /**
   * @private
   * @param {import('./links.js').Range | null} range  of the text of the tape
   * @returns {[number, number]}
   */
  rowsOf(range) {
    if (range === null) return [0, 0];
    const [first, end] = [this.tape.rowAt(range.from), this.tape.rowAt(range.to)];
    return [first, end < 0 ? this.tape.summary().rows : end];
  }
}

/** What the page asks of CLDATA otherwise than of a tape; what is not here is asked of the tape that it became. */
export const cldataQuestions = {
  /**
   * Where an offset of the CLDATA lies in every view.
   * @param {CldataSource} on
   * @param {number} offset
   * @returns {Here}
   */
  locate(on, offset) {
    const span = on.cldata.spanAt(offset);
    const { block, posted } = on.record(on.cldata.recordAt(offset), span < 0 ? undefined : span);
    const place = posted?.from ?? placeBehind(on.map, offset, on.text.length);
    return { offset, row: on.tape.rowAt(place), block, span: span < 0 ? null : on.cldata.span(span), posted: { ...(posted ?? { from: place, to: place }), at: place } };
  },

  /**
   * The same of an offset of the tape that it became: the record is the one that it came from.
   * @param {CldataSource} on
   * @param {number} at
   * @returns {Here}
   */
  locatePosted(on, at) {
    const from = cameFrom(on.map, at);
    const offset = from?.from ?? 0;
    const row = on.tape.rowAt(at);
    if (from === null) return { offset, row, block: null, span: null, posted: { from: at, to: at, at } };
    return { ...cldataQuestions.locate(on, offset), row, posted: { ...(becameOf(on.map, from) ?? { from: at, to: at }), at } };
  },

  /** @param {CldataSource} on @param {number} from @param {number} to */
  listing: (on, from, to) => ({
    syntax: on.cldata.syntax(from, to, MOST_LISTED),
    diagnostics: on.cldata.diagnostics(from, to, MOST_LISTED),
  }),

  /** @param {CldataSource} on @param {number} from @param {number} to @param {number} limit */
  problems: (on, from, to, limit) => on.cldata.diagnostics(from, to, limit),

  /** @param {CldataSource} on @param {number} tolerance */
  pathChange: (on, tolerance) => on.cldata.pathChange(tolerance),

  /** @param {CldataSource} on @param {number} index */
  span(on, index) {
    const span = on.cldata.span(index);
    return span === null ? null : { span, block: on.record(span.blocks[1], index).block };
  },

  /** Where the point stands that a span ends in. @param {CldataSource} on @param {number} index */
  spanPlace: (on, index) => on.cldata.endOfSpan(index)?.from ?? null,

  /** @param {CldataSource} on */
  sight: (on) => on.cldata.endOfSpan(0)?.from ?? on.cldata.records(0, 1)[0]?.from ?? 0,

  /** @param {CldataSource} on @param {number} index */
  block: (on, index) => on.record(index).block,

  /** The first span of the tape that moves in a time that is not known, with its record. @param {CldataSource} on */
  untimed(on) {
    const index = on.tape.untimed();
    const span = index < 0 ? null : on.tape.span(index);
    if (span === null) return null;
    const from = cameFrom(on.map, on.tape.block(span.blocks[0])?.from ?? 0);
    return { kind: span.kind, block: from === null ? null : on.record(on.cldata.recordAt(from.from)).block };
  },

  /**
   * The text of the tape, with its number; without the text where that is the one that is known.
   * @param {CldataSource} on
   * @param {number} known
   * @returns {{ version: number, text: string | null }}
   */
  posted: ({ version, text }, known) => ({ version, text: version === known ? null : text }),

  /** @param {CldataSource} on @param {number} from @param {number} to */
  postedListing: (on, from, to) => ({
    syntax: on.tape.syntax(from, to, MOST_LISTED),
    diagnostics: on.tape.diagnostics(from, to, MOST_LISTED),
  }),

  /** What holds at a record. @param {CldataSource} on @param {number} index */
  state: (on, index) => on.cldata.state(index),
};
