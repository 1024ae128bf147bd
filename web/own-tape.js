// Which tape is open: one of the examples, or the visitor's own, which is kept while an example is looked at.
import { byId, el } from './dom.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {{ source: string, format: import('nctape').Format, cursor: number }} Whole  a tape with all that opens it */

const OWN = '';
const EMPTY = 'empty';
const ABOUT_OWN = 'Your own tape. This browser keeps it, also while you look at an example.';

/**
 * @param {object} parts
 * @param {Preset[]} parts.presets
 * @param {(preset: Preset) => void} parts.choose
 * @param {() => Whole} parts.current
 * @param {(tape: Whole) => void} parts.load
 * @param {Whole | null} parts.own  the visitor's tape of an earlier visit
 */
export function makePicker({ presets, choose, current, load, own: earlier }) {
  const picker = byId('preset', HTMLSelectElement);
  const about = byId('about-tape', HTMLElement);
  const opener = byId('about-button', HTMLElement);
  const own = el('option', { value: OWN, hidden: true }, 'Your tape');
  picker.replaceChildren(
    own,
    ...presets.map(({ id, title }) => el('option', { value: id }, title)),
    el('option', { value: EMPTY }, 'Empty tape'),
  );
  /** What was written before an example was opened. @type {Whole | null} */
  let kept = earlier;
  /** The example that the text is; OWN if it is none. */
  let open = OWN;

  picker.addEventListener('change', () => {
    const wanted = picker.value;
    keep();
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
    about.textContent = presets.find(({ id }) => id === open)?.about ?? ABOUT_OWN;
  }
  opener.addEventListener('click', () => {
    const isOpen = about.classList.toggle('open');
    opener.setAttribute('aria-expanded', String(isOpen));
  });

  return {
    keep,
    /** What is to be kept of this visit. @returns {import('./share/drafts.js').Draft} */
    draft() {
      const tape = open === OWN ? current() : null;
      const own = tape !== null && tape.source.trim() !== '' ? tape : kept;
      return { own, example: open === OWN ? null : open };
    },
    /**
     * Shows which example the text is, if it is one.
     * @param {(source: string) => boolean} is
     */
    name(is) {
      open = presets.find(({ source }) => is(source))?.id ?? OWN;
      show();
    },
  };
}
