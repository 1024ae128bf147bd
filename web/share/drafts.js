// What was written last, kept on this machine so that a reload or a closed window loses nothing.
//
// Each window keeps its own, under a name that it holds while it is open: two windows never write over one another.
import { forget, names, recall, remember } from '../storage.js';
import { wholeOf } from './whole.js';

/** @typedef {import('./whole.js').Whole} Whole */
/**
 * @typedef {object} Draft
 * @property {Whole | null} own  the visitor's tape
 * @property {Whole[]} earlier  what was theirs before it, the last one first
 * @property {Whole | null} shown  another that is open in its place
 * @property {string | null} guest  what that is called
 * @property {string | null} example  the example that is open in its place, as it comes
 */

const PREFIX = 'draft.';
/** Drafts of windows that were closed. */
const MOST_KEPT = 5;
/** Characters: a browser keeps some five million for all of a site. */
const MOST_CHARACTERS = 500_000;

export class Drafts {
  /**
   * @param {(words: string) => void} say  once, where drafts cannot be kept
   * @param {string[]} standards  that a format may follow
   */
  constructor(say, standards) {
    this.say = say;
    this.standards = standards;
    this.said = false;
    /** Of this window; empty where it keeps no draft. */
    this.name = '';
  }

  /** What this window kept before it was loaded anew, and what another one left behind. */
  async open() {
    this.name = await nameOfWindow();
    const all = names(PREFIX).map((name) => ({ name, draft: this.read(name) }));
    const mine = all.find(({ name }) => name === PREFIX + this.name)?.draft ?? null;
    const others = all.filter(({ name }) => name !== PREFIX + this.name).sort((a, b) => (b.draft?.time ?? 0) - (a.draft?.time ?? 0));
    const open = await namesOfWindows();
    const closed = others.filter(({ name }) => !open.includes(name.slice(PREFIX.length)));
    for (const { name } of closed.slice(MOST_KEPT)) forget(name);
    return { mine, last: others.find(({ draft }) => draft !== null && draft.own !== null)?.draft ?? null };
  }

  /**
   * @private
   * @param {string} name
   * @returns {(Draft & { time: number }) | null}
   */
  read(name) {
    try {
      const { own, earlier, shown, guest, example, time } = JSON.parse(recall(name) ?? 'null');
      const [whole, other] = [own, shown].map((found) => wholeOf(found, this.standards));
      const before = Array.isArray(earlier) ? earlier.map((one) => wholeOf(one, this.standards)).filter((one) => one !== null) : [];
      return { own: whole, earlier: before, shown: other, guest: wordOf(guest), example: wordOf(example), time: Number(time) || 0 };
    } catch {
      return null;
    }
  }

  /** @param {Draft} draft */
  keep(draft) {
    if (this.name === '') return;
    const { own, shown, example } = draft;
    const long = (own?.source.length ?? 0) + (shown?.source.length ?? 0);
    const isLong = long > MOST_CHARACTERS;
    // What was theirs before goes first where there is no room.
    let room = MOST_CHARACTERS - long;
    const earlier = draft.earlier.filter(({ source }) => (room -= source.length) >= 0);
    const nothing = own === null && shown === null && example === null;
    const kept = !isLong && !nothing && remember(PREFIX + this.name, JSON.stringify({ ...draft, earlier, time: Date.now() }));
    // An older one would come back as if it were this one.
    if (!kept) forget(PREFIX + this.name);
    if (kept || nothing || this.said) return;
    this.said = true;
    this.say(
      isLong
        ? 'This tape is too long to be kept by the browser: save its listing before you close the page.'
        : 'The browser keeps nothing for this page: save the listing before you close it.',
    );
  }
}

/** @param {unknown} word */
const wordOf = (word) => (typeof word === 'string' ? word : null);

/** Those that hold a name now. @returns {Promise<string[]>} */
async function namesOfWindows() {
  try {
    const { held = [] } = await navigator.locks.query();
    return held.map(({ name = '' }) => name.replace('nctape.window.', ''));
  } catch {
    return [];
  }
}

/** The name that this window had before it was loaded anew, unless a copy of the window holds it; else a new one. */
async function nameOfWindow() {
  const made = Math.random().toString(36).slice(2, 10);
  let name = made;
  try {
    name = sessionStorage.getItem('nctape.window') ?? made;
    if (!(await hold(name))) name = made;
    if (name === made) await hold(name);
    sessionStorage.setItem('nctape.window', name);
  } catch {
    // No storage here: there is no draft either.
  }
  return name;
}

/**
 * Holds a name until the window is closed; false where another window holds it.
 * @param {string} name
 * @returns {Promise<boolean>}
 */
function hold(name) {
  // Not to be had where the page is opened as a file.
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    const held = navigator.locks.request(`nctape.window.${name}`, { ifAvailable: true }, (lock) => {
      resolve(lock !== null);
      return lock === null ? undefined : new Promise(() => {});
    });
    // Forbidden, as in a frame of its own origin: then nothing is shared with another window either.
    held.catch(() => resolve(true));
  });
}
