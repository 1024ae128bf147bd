// Rows of the tape, fetched by the window and kept while they are true.

/** @typedef {import('../questions.js').StripWindow} StripWindow */

export const WINDOW = 256;
const MOST_KEPT = 48;

export class Windows {
  /**
   * @param {(first: number, count: number) => Promise<StripWindow | undefined>} ask
   * @param {() => void} onArrival
   */
  constructor(ask, onArrival) {
    this.ask = ask;
    this.onArrival = onArrival;
    /** @type {Map<number, StripWindow>} the last used at the end */
    this.kept = new Map();
    /** @type {Set<number>} out of date: still drawn until the new ones are here */
    this.stale = new Set();
    /** @type {Map<number, number>} window -> generation in which it was asked for */
    this.asked = new Map();
    this.generation = 0;
  }

  /** The tape has changed. */
  expire() {
    this.generation += 1;
    this.stale = new Set(this.kept.keys());
    this.asked.clear();
  }

  /**
   * The windows that hold these rows.
   * @param {number} first
   * @param {number} last
   */
  *around(first, last) {
    for (let index = Math.floor(Math.max(0, first) / WINDOW); index * WINDOW <= last; index += 1) yield index;
  }

  /**
   * Makes sure that these rows are here or on their way.
   * @param {number} first
   * @param {number} last
   */
  want(first, last) {
    for (const index of this.around(first, last)) {
      const fresh = this.kept.has(index) && !this.stale.has(index);
      if (!fresh && this.asked.get(index) !== this.generation) void this.fetch(index);
    }
  }

  /**
   * @private
   * @param {number} index
   */
  async fetch(index) {
    const { generation } = this;
    this.asked.set(index, generation);
    const window = await this.ask(index * WINDOW, WINDOW);
    if (window === undefined || generation !== this.generation) return;
    this.asked.delete(index);
    this.stale.delete(index);
    this.kept.delete(index);
    this.kept.set(index, window);
    if (this.kept.size > MOST_KEPT) {
      const [oldest] = this.kept.keys();
      this.kept.delete(oldest);
    }
    this.onArrival();
  }

  /**
   * Is what is known of this row still true?
   * @param {number} row
   */
  isFresh(row) {
    const index = Math.floor(row / WINDOW);
    return this.kept.has(index) && !this.stale.has(index);
  }

  /**
   * One row, if it is here.
   * @param {number} row
   */
  row(row) {
    if (row < 0) return null;
    const window = this.kept.get(Math.floor(row / WINDOW));
    const i = row % WINDOW;
    if (window === undefined || i >= window.rows.bytes.length) return null;
    const { bytes, offsets, blocks, kinds } = window.rows;
    return { byte: bytes[i], offset: offsets[i], block: blocks[i], kind: kinds[i], mark: window.marks[i] };
  }

  /**
   * What a block near by is called; null where it has no number or is not here.
   * @param {number} block
   */
  name(block) {
    for (const { names } of this.kept.values()) {
      const found = names.find(({ index }) => index === block);
      if (found !== undefined) return found.text;
    }
    return null;
  }

  /**
   * The blocks of these rows, and maybe some before; the first may begin earlier.
   * @param {number} first
   * @param {number} last
   */
  *names(first, last) {
    for (const index of this.around(first, last)) {
      for (const name of this.kept.get(index)?.names ?? []) {
        if (name.row <= last) yield name;
      }
    }
  }
}
