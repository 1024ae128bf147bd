// Blocks with their registers, kept while they are true. A replay asks once for many of them; the hand on the program
// needs only the one that it is on.

/** @typedef {import('./stretch.js').Stretch} Stretch */

export const STRETCH = 64;
const MOST_KEPT = 16;

export class Stretches {
  /** @param {(first: number, count: number) => Promise<Stretch | undefined>} ask */
  constructor(ask) {
    this.ask = ask;
    /** @type {Map<number, Stretch>} the last fetched at the end */
    this.kept = new Map();
    /** @type {Map<number, Promise<boolean>>} */
    this.asked = new Map();
    /** The block that was fetched by itself. @type {Stretch | null} */
    this.single = null;
    this.generation = 0;
  }

  /** The tape has changed. */
  expire() {
    this.generation += 1;
    this.kept.clear();
    this.asked.clear();
    this.single = null;
  }

  /**
   * One block, if it is here.
   * @param {number} block
   */
  block(block) {
    const stretch = this.kept.get(Math.floor(block / STRETCH)) ?? this.single;
    const one = stretch?.blocks[block - stretch.first];
    if (!stretch || one === undefined) return null;
    return { ...one, held: stretch.held[block - stretch.first], stretch };
  }

  /**
   * Fetches the stretch of a block; false where the tape has changed meanwhile.
   * @param {number} block
   * @returns {Promise<boolean>}
   */
  fetch(block) {
    const index = Math.floor(block / STRETCH);
    if (this.kept.has(index)) return Promise.resolve(true);
    let asked = this.asked.get(index);
    if (asked === undefined) {
      asked = this.bring(index);
      this.asked.set(index, asked);
    }
    return asked;
  }

  /**
   * Fetches one block; false where the tape has changed meanwhile.
   * @param {number} block
   */
  async fetchSingle(block) {
    const { generation } = this;
    const stretch = await this.ask(block, 1);
    if (generation !== this.generation || stretch === undefined) return false;
    this.single = stretch;
    return true;
  }

  /**
   * @private
   * @param {number} index
   */
  async bring(index) {
    const { generation } = this;
    const stretch = await this.ask(index * STRETCH, STRETCH);
    if (generation !== this.generation) return false;
    this.asked.delete(index);
    if (stretch === undefined) return false;
    this.kept.set(index, stretch);
    if (this.kept.size > MOST_KEPT) {
      const [oldest] = this.kept.keys();
      this.kept.delete(oldest);
    }
    return true;
  }
}
