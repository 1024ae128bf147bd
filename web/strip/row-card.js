// What one row of holes says, in both codes: under the pointer, or under the head while it is asked for.
import { byId, el } from '../dom.js';

/** @typedef {{ byte: number, place: string }} Seen */

const TRACKS = [8, 7, 6, 5, 4, 3, 2, 1];
/** A pointer that passes by asks for nothing, in milliseconds. */
const REST = 120;
const EDGE = 8;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {HTMLElement} parts.strip
 * @param {() => number} parts.headX  where the head is on the screen
 * @param {(x: number) => Seen | null} parts.at  the row under a place of the screen
 */
export function makeRowCard({ store, engine, strip, headX, at }) {
  const card = byId('row-card', HTMLElement);
  const opener = byId('row-button', HTMLButtonElement);
  /** @type {Map<number, import('nctape').RowInCode[]>} */
  const known = new Map();
  /** @type {import('nctape').AboutCodes | null} */
  let about = null;
  /** The row under the head. @type {Seen | null} */
  let head = null;
  /** The card stays open for the row under the head. */
  let pinned = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  /** What was asked for last. */
  let wanted = 0;

  /**
   * @param {Seen} seen
   * @param {number} x  of its row on the screen
   */
  async function show(seen, x) {
    wanted += 1;
    const asked = wanted;
    about ??= await engine.fact('aboutCodes');
    const words = known.get(seen.byte) ?? (await engine.fact('rowWords', seen.byte));
    known.set(seen.byte, words);
    if (asked !== wanted) return;
    const code = store.state.summary?.code ?? 'iso';
    // The code of the tape comes first.
    const codes = [...words].sort((one, other) => Number(other.id === code) - Number(one.id === code));
    const roles = about.codes.find(({ id }) => id === code)?.tracks ?? [];
    card.replaceChildren(
      el('p', { class: 'row-place' }, seen.place),
      holes(seen.byte, roles),
      ...codes.map(({ title, label, sentence, parity, id }) =>
        el(
          'div',
          { class: `row-code ${id === code ? 'row-own' : ''}` },
          el('p', { class: 'row-title' }, title, label === '' ? null : el('span', { class: 'row-label' }, label)),
          el('p', { class: parity ? null : 'row-odd' }, sentence),
        ),
      ),
    );
    card.hidden = false;
    const { width } = card.getBoundingClientRect();
    const left = Math.max(EDGE, Math.min(x - width / 2, document.documentElement.clientWidth - width - EDGE));
    card.style.left = `${left}px`;
    card.style.top = `${strip.getBoundingClientRect().bottom + 4}px`;
  }

  function hide() {
    wanted += 1;
    clearTimeout(rest);
    if (pinned && head !== null) void show(head, headX());
    else card.hidden = true;
  }

  /** @param {boolean} open */
  function pin(open) {
    pinned = open;
    opener.setAttribute('aria-expanded', String(open));
    hide();
  }

  strip.addEventListener('pointermove', (event) => {
    clearTimeout(rest);
    if (event.pointerType !== 'mouse') return;
    if (event.buttons !== 0) {
      hide();
      return;
    }
    const tell = () => {
      const seen = at(event.clientX);
      if (seen === null) hide();
      else void show(seen, event.clientX);
    };
    // Once it is open it follows at once.
    if (card.hidden) rest = setTimeout(tell, REST);
    else tell();
  });
  strip.addEventListener('pointerleave', hide);
  strip.addEventListener('pointerdown', hide);
  opener.addEventListener('click', () => pin(!pinned));
  window.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && pinned) pin(false);
  });

  return {
    /**
     * Tells the row under the head, which an open card follows.
     * @param {number} byte
     * @param {string} place
     */
    showHead(byte, place) {
      head = { byte, place };
      if (pinned) void show(head, headX());
    },
  };
}

/**
 * The row as it lies on the tape, track 8 first, each track with what it counts.
 * @param {number} byte
 * @param {string[]} roles  track 1 first
 */
function holes(byte, roles) {
  const cell = (/** @type {number} */ track) => {
    const punched = (byte & (1 << (track - 1))) !== 0;
    return el(
      'li',
      { class: `track ${punched ? 'punched' : ''} ${track === 3 ? 'beyond-feed' : ''}` },
      el('span', { class: 'track-number' }, String(track)),
      el('span', { class: 'track-hole', role: 'img', 'aria-label': punched ? 'hole' : 'no hole' }),
      el('span', { class: 'track-role' }, roles[track - 1] ?? ''),
    );
  };
  return el('ol', { class: 'tracks', 'aria-label': 'Tracks 8 to 1' }, ...TRACKS.map(cell));
}
