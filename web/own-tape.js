// Which tape is open: one of the examples, a guest that came with a link or the page of a rule, or the visitor's own,
// which is kept while another is looked at.
import { byId, el } from './dom.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {{ source: string, format: import('nctape').Format, cursor: number }} Whole  a tape with all that opens it */

const OWN = '';
const EMPTY = 'empty';
const GUEST = 'guest';
const ABOUT_OWN = 'Your own tape. This browser keeps it, also while you look at an example.';
const ABOUT_GUEST = 'Not your own tape until you change it: yours is kept, and can be chosen above.';

/**
 * @param {object} parts
 * @param {Preset[]} parts.presets
 * @param {(preset: Preset) => void} parts.choose
 * @param {() => Whole} parts.current
 * @param {(tape: Whole) => void} parts.load
 * @param {Whole | null} parts.own  the visitor's tape of an earlier visit
 * @param {string | null} parts.guest  what the tape that opens first is called, where it is a guest
 */
export function makePicker({ presets, choose, current, load, own: earlier, guest: first }) {
  const picker = byId('preset', HTMLSelectElement);
  const about = byId('about-tape', HTMLElement);
  const opener = byId('about-button', HTMLElement);
  const own = el('option', { value: OWN, hidden: true }, 'Your tape');
  const visiting = el('option', { value: GUEST, hidden: true });
  picker.replaceChildren(
    own,
    ...presets.map(({ id, title }) => el('option', { value: id }, title)),
    el('option', { value: EMPTY }, 'Empty tape'),
    visiting,
  );
  /** What was written before an example was opened. @type {Whole | null} */
  let kept = earlier;
  /** What the tape that is looked at is called, where it is a guest: it is the visitor's own once it is edited. */
  let guest = first;
  /** The example that the text is; GUEST or OWN if it is none. */
  let open = OWN;

  picker.addEventListener('change', () => {
    const wanted = picker.value;
    keep();
    guest = null;
    const preset = presets.find(({ id }) => id === wanted);
    if (preset !== undefined) choose(preset);
    else if (wanted === EMPTY) load({ ...current(), source: '', cursor: 0 });
    else if (kept !== null) load(kept);
    show();
  });

  /** Lays the visitor's own tape aside. */
  function keep() {
    const tape = current();
    if (open === OWN && tape.source.trim() !== '') kept = tape;
  }
  function show() {
    picker.value = open;
    own.hidden = open !== OWN && kept === null;
    visiting.hidden = open !== GUEST;
    visiting.textContent = guest;
    about.textContent = presets.find(({ id }) => id === open)?.about ?? (open === GUEST ? ABOUT_GUEST : ABOUT_OWN);
  }
  opener.addEventListener('click', () => {
    const isOpen = about.classList.toggle('open');
    opener.setAttribute('aria-expanded', String(isOpen));
  });

  return {
    keep,
    /**
     * The tape that is loaded next is a guest.
     * @param {string} title
     */
    welcome(title) {
      keep();
      guest = title;
    },
    /** What is to be kept of this visit. @returns {import('./share/drafts.js').Draft} */
    draft() {
      const tape = current();
      const own = open === OWN && tape.source.trim() !== '' ? tape : kept;
      const example = presets.find(({ id }) => id === open);
      // An example is kept by its name, as long as it is read under its own format.
      if (example?.format === tape.format) return { own, shown: null, guest: null, example: open };
      return { own, shown: open === OWN ? null : tape, guest: open === GUEST ? guest : null, example: null };
    },
    /**
     * Shows which example the text is, if it is one.
     * @param {(source: string) => boolean} is
     * @param {boolean} byHand  it was written, and not loaded
     */
    name(is, byHand) {
      if (byHand) guest = null;
      open = presets.find(({ source }) => is(source))?.id ?? (guest === null ? OWN : GUEST);
      show();
    },
  };
}
