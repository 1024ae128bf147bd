// Blocks with their registers, fetched by the stretch and kept while they are true: a replay asks once for many blocks.

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
    this.generation = 0;
  }

  /** The tape has changed. */
  expire() {
    this.generation += 1;
    this.kept.clear();
    this.asked.clear();
  }

  /**
   * One block, if it is here.
   * @param {number} block
   */
  block(block) {
    const stretch = this.kept.get(Math.floor(block / STRETCH));
    const one = stretch?.blocks[block - stretch.first];
    if (stretch === undefined || one === undefined) return null;
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
