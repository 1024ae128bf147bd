// A keystroke: what the engine and the drawing take of it, and when it is painted, beside the editor alone.
import { DRAWN, inFront } from './support/pages.js';
import { notes, settled, workerMeasures } from './support/watch.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('./support/watch.js').Measure} Measure */

/** Keys that are pressed in one page before it is the other's turn. */
const TURN = 10;
const MOST_TURNS = 12;
const FEWEST_TURNS = 3;
/** Milliseconds for all turns of one size of tape. */
const BUDGET = 120_000;

/**
 * One keystroke. Times are milliseconds since the key was pressed, or of work.
 * @typedef {object} Keystroke
 * @property {number} character  the text in the editor is painted
 * @property {number} all  everything is painted
 * @property {Measure[]} engine  what the worker did
 * @property {Measure[]} drawing  what the page did with the answers
 */

/**
 * @param {{ page: Page, worker: import('playwright-core').Worker }} playground
 * @param {{ page: Page }} bare
 */
export async function measureTyping(playground, bare) {
  /** @type {Keystroke[]} */
  const withEngine = [];
  /** @type {Keystroke[]} */
  const alone = [];
  const end = Date.now() + BUDGET;
  // The first turn is for warmth.
  for (let turn = 0; turn <= MOST_TURNS && (turn <= FEWEST_TURNS || Date.now() < end); turn += 1) {
    const played = await inFront(playground.page, () => press(playground.page, DRAWN, playground.worker));
    const bared = await inFront(bare.page, () => press(bare.page, [], null));
    if (turn > 0) {
      withEngine.push(...played);
      alone.push(...bared);
    }
  }
  return { withEngine, alone };
}

/**
 * A digit, and the key that takes it out again, in turns.
 * @param {Page} page
 * @param {string[]} wanted
 * @param {import('playwright-core').Worker | null} worker
 */
async function press(page, wanted, worker) {
  /** @type {Keystroke[]} */
  const found = [];
  for (let i = 0; i < TURN; i += 1) {
    await notes(page);
    if (worker !== null) await workerMeasures(worker);
    await page.keyboard.press(i % 2 === 0 ? '1' : 'Backspace');
    await settled(page, wanted);
    const { keys, typed, painted, measures } = await notes(page);
    const [key] = keys;
    const after = (/** @type {number} */ time) => {
      const frame = painted.find((one) => one >= time);
      if (frame === undefined) throw new Error('no frame was painted');
      return frame - key;
    };
    const drawing = measures.filter(({ name }) => DRAWN.includes(name));
    found.push({
      character: after(typed[0]),
      all: after(Math.max(typed[0], ...drawing.map(({ to }) => to))),
      engine: worker === null ? [] : await workerMeasures(worker),
      drawing,
    });
  }
  return found;
}

/**
 * How long all of it took.
 * @param {Measure[]} measures
 */
export const spent = (measures) => measures.reduce((sum, { from, to }) => sum + to - from, 0);
