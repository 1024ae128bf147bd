// What the page begins with: the tape of a link, or what this window held before, or the first example.
import { notice } from './notice.js';
import { Drafts } from './share/drafts.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {import('./share/whole.js').Whole} Whole */

/**
 * @typedef {object} Beginning
 * @property {Whole | null} tape  null: the first example
 * @property {string | null} guest  what it is called, where it is not the visitor's own
 * @property {Whole | null} own  the visitor's tape, where another is opened or another window left it
 * @property {Whole[]} earlier  what was theirs before it
 * @property {Drafts} drafts
 */

/** What a tape is called that came with a link. */
export const SHARED = 'Shared tape';

/**
 * @param {import('./engine.js').Engine} engine
 * @param {Preset[]} presets
 * @returns {Promise<Beginning>}
 */
export async function begin(engine, presets) {
  const drafts = new Drafts(notice, await standardsOf(engine));
  const { mine, last } = isFramed() ? { mine: null, last: null } : await drafts.open();
  const own = mine?.own ?? last?.own ?? null;
  const earlier = (mine ?? last)?.earlier ?? [];
  const shared = await sharedTape(engine);
  if (shared !== null) return { tape: shared, guest: SHARED, own, earlier, drafts };
  const example = presets.find(({ id }) => id === mine?.example) ?? null;
  return { tape: mine?.shown ?? example ?? mine?.own ?? null, guest: mine?.guest ?? null, own, earlier, drafts };
}

/** @param {import('./engine.js').Engine} engine */
const standardsOf = async (engine) => (await engine.fact('standards')).map(({ id }) => /** @type {string} */ (id));

/**
 * A link that is put into the address of the open page is opened too.
 * @param {import('./engine.js').Engine} engine
 * @param {(tape: Whole) => void} load
 */
export function followAddress(engine, load) {
  window.addEventListener('hashchange', async () => {
    const shared = await sharedTape(engine);
    if (shared !== null) load(shared);
  });
}

/** The page stands in another one, where it keeps nothing and leaves the address alone. */
const isFramed = () => window.parent !== window;

/**
 * The tape of the address, which is then an address like any other: what is written next is not what was shared.
 * @param {import('./engine.js').Engine} engine
 */
async function sharedTape(engine) {
  if (!/^#\d+\./.test(location.hash)) return null;
  const { readLink } = await import('./share/link.js');
  const found = await readLink(location.hash, await standardsOf(engine));
  if (found === null) return null;
  if ('trouble' in found) {
    notice(`The link could not be opened. ${found.trouble} The page shows what it would show without it.`);
    return null;
  }
  if (!isFramed()) history.replaceState(history.state, '', location.pathname + location.search);
  return found.tape;
}
