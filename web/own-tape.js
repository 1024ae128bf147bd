// What is open, a tape or CLDATA: one of the examples, a guest that came with a link or the page of a rule, or the visitor's own,
// which is kept while another is looked at.
import { byId, el } from './dom.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {import('./share/whole.js').Whole} Whole  a tape or CLDATA with all that opens it */
/** @typedef {import('nctape').SourceKind} SourceKind */

const OWN = '';
/** @type {{ kind: SourceKind, group: string, own: string, about: string, empty: string, emptyTitle: string }[]} */
const KINDS = [
  { kind: 'tape', group: 'Tapes', own: 'Your tape', about: 'Your own tape.', empty: 'empty', emptyTitle: 'Empty tape' },
  { kind: 'cldata', group: 'CLDATA, from which tapes are made', own: 'Your CLDATA', about: 'Your own CLDATA.', empty: 'empty-cldata', emptyTitle: 'Empty CLDATA' },
];
const GUEST = 'guest';
const EARLIER = 'earlier.';
/** So many tapes are kept that were the visitor's own before an example or a guest was changed. */
const MOST_EARLIER = 3;
const ABOUT_OWN = 'This browser keeps it, also while you look at an example.';
const ABOUT_GUEST = 'Not your own until you change it: yours is kept, and can be chosen above.';

/** @param {Whole | null} whole */
const kindOf = (whole) => KINDS.find(({ kind }) => kind === whole?.kind) ?? KINDS[0];

/**
 * @param {object} parts
 * @param {Preset[]} parts.presets
 * @param {(preset: Preset) => void} parts.choose
 * @param {() => Whole} parts.current
 * @param {(tape: Whole) => void} parts.load
 * @param {Whole | null} parts.own  the visitor's tape of an earlier visit
 * @param {Whole[]} parts.earlier  those before it, the last one first
 * @param {string | null} parts.guest  what the tape that opens first is called, where it is a guest
 */
export function makePicker({ presets, choose, current, load, own: lastOwn, earlier, guest: first }) {
  const picker = byId('preset', HTMLSelectElement);
  const about = byId('about-tape', HTMLElement);
  const opener = byId('about-button', HTMLElement);
  const own = el('option', { value: OWN, hidden: true }, KINDS[0].own);
  const before = Array.from({ length: MOST_EARLIER }, (_, at) =>
    el('option', { value: `${EARLIER}${at}`, hidden: true }, at === 0 ? 'Your earlier tape' : `Your earlier tape, ${at + 1} back`),
  );
  const visiting = el('option', { value: GUEST, hidden: true });
  picker.replaceChildren(
    own,
    ...KINDS.map(({ kind, group, empty, emptyTitle }) =>
      el(
        'optgroup',
        { label: group },
        ...presets.filter((preset) => preset.kind === kind).map(({ id, title }) => el('option', { value: id }, title)),
        el('option', { value: empty }, emptyTitle),
      ),
    ),
    ...before,
    visiting,
  );
  /** What was written before an example was opened. @type {Whole | null} */
  let kept = lastOwn;
  /** What the tape that is looked at is called, where it is a guest: it is the visitor's own once it is edited. */
  let guest = first;
  /** The example that the text is; GUEST or OWN if it is none. */
  let open = OWN;

  picker.addEventListener('change', () => {
    const wanted = picker.value;
    keep();
    guest = null;
    const preset = presets.find(({ id }) => id === wanted);
    const empty = KINDS.find((one) => one.empty === wanted);
    if (preset !== undefined) choose(preset);
    else if (empty !== undefined) load({ format: current().format, source: '', cursor: 0, kind: empty.kind });
    else if (wanted.startsWith(EARLIER)) takeUp(Number(wanted.slice(EARLIER.length)));
    else if (kept !== null) load(kept);
    show();
  });
  /** Opens an earlier tape, in the place of which the last one is laid aside. @param {number} at */
  function takeUp(at) {
    const chosen = earlier[at];
    if (chosen === undefined) return;
    earlier.splice(at, 1, ...(kept === null ? [] : [kept]));
    kept = chosen;
    load(chosen);
  }
  /** What was open of either kind when the other was turned to. @type {Partial<Record<SourceKind, { whole: Whole, guest: string | null }>>} */
  const left = {};

  /** Lays the visitor's own tape aside. */
  function keep() {
    const tape = current();
    if (open === OWN && tape.source.trim() !== '') kept = tape;
  }
  function show() {
    picker.value = open;
    own.hidden = open !== OWN && kept === null;
    own.textContent = kindOf(open === OWN ? current() : kept).own;
    before.forEach((option, at) => (option.hidden = earlier[at] === undefined));
    visiting.hidden = open !== GUEST;
    visiting.textContent = guest;
    about.textContent = presets.find(({ id }) => id === open)?.about ?? (open === GUEST ? ABOUT_GUEST : `${kindOf(current()).about} ${ABOUT_OWN}`);
  }
  opener.addEventListener('click', () => {
    const isOpen = about.classList.toggle('open');
    opener.setAttribute('aria-expanded', String(isOpen));
  });

  return {
    keep,
    /**
     * Turns to what was open of a kind last, or to its first example.
     * @param {SourceKind} kind
     */
    turn(kind) {
      keep();
      left[current().kind ?? 'tape'] = { whole: current(), guest };
      const last = left[kind];
      guest = last?.guest ?? null;
      const example = presets.find((preset) => preset.kind === kind);
      if (last !== undefined) load(last.whole);
      else if (example !== undefined) choose(example);
      else load({ format: current().format, source: '', cursor: 0, kind });
      show();
    },
    /**
     * The tape that is loaded next is a guest.
     * @param {string} title
     */
    welcome(title) {
      keep();
      left[current().kind ?? 'tape'] = { whole: current(), guest };
      guest = title;
    },
    /** What is to be kept of this visit. @returns {import('./share/drafts.js').Draft} */
    draft() {
      const tape = current();
      const own = open === OWN && tape.source.trim() !== '' ? tape : kept;
      const example = presets.find(({ id }) => id === open);
      // An example is kept by its name, as long as it is read under its own format.
      if (example?.format === tape.format) return { own, earlier, shown: null, guest: null, example: open };
      return { own, earlier, shown: open === OWN ? null : tape, guest: open === GUEST ? guest : null, example: null };
    },
    /**
     * Shows which example the text is, if it is one.
     * @param {(source: string) => boolean} is
     * @param {boolean} byHand  it was written, and not loaded
     */
    name(is, byHand) {
      if (byHand) guest = null;
      const kind = current().kind ?? 'tape';
      const was = open;
      open = presets.find((preset) => preset.kind === kind && is(preset.source))?.id ?? (guest === null ? OWN : GUEST);
      // An example or a guest that is changed becomes the visitor's own, and theirs an earlier one; undone, it comes back.
      if (byHand && was !== OWN && open === OWN && kept !== null) {
        earlier.unshift(kept);
        earlier.length = Math.min(earlier.length, MOST_EARLIER);
        kept = null;
      } else if (was === OWN && open !== OWN && kept === null) {
        kept = earlier.shift() ?? null;
      }
      show();
    },
  };
}
