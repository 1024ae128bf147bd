// What the page begins with: the tape of a link, or what this window held before, or the first example.
import { notice } from './notice.js';
import { Drafts } from './share/drafts.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {import('./share/whole.js').Whole} Whole */

/**
 * @typedef {object} Beginning
 * @property {Whole | null} tape  null: the first example
 * @property {Whole | null} own  the visitor's tape, where another is opened or another window left it
 * @property {Drafts} drafts
 */

/**
 * @param {Preset[]} presets
 * @returns {Promise<Beginning>}
 */
export async function begin(presets) {
  const drafts = new Drafts(notice);
  const { mine, last } = isFramed() ? { mine: null, last: null } : await drafts.open();
  const own = mine?.own ?? last?.own ?? null;
  const shared = await sharedTape();
  if (shared !== null) return { tape: shared, own, drafts };
  const example = presets.find(({ id }) => id === mine?.example) ?? null;
  return { tape: example ?? mine?.own ?? null, own, drafts };
}

/**
 * A link that is put into the address of the open page is opened too.
 * @param {(tape: Whole) => void} load
 */
export function followAddress(load) {
  window.addEventListener('hashchange', async () => {
    const shared = await sharedTape();
    if (shared !== null) load(shared);
  });
}

/** The page stands in another one, where it keeps nothing and leaves the address alone. */
const isFramed = () => window.parent !== window;

/** The tape of the address, which is then an address like any other: what is written next is not what was shared. */
async function sharedTape() {
  if (!/^#\d+\./.test(location.hash)) return null;
  const { readLink } = await import('./share/link.js');
  const found = await readLink(location.hash);
  if (found === null) return null;
  if ('trouble' in found) {
    notice(`The link could not be opened. ${found.trouble} The page shows what it would show without it.`);
    return null;
  }
  if (!isFramed()) history.replaceState(history.state, '', location.pathname + location.search);
  return found.tape;
}
