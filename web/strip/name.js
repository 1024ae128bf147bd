// A name in letters of holes, punched into the leader for the eye.
import { byId } from '../dom.js';

/** So much of a listing shows how it begins. */
const BEGINNING = 4096;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {(characters: number) => Promise<string>} parts.beginning  of the listing of the tape
 */
export function makeName({ store, engine, beginning }) {
  const opener = byId('name-button', HTMLButtonElement);
  const form = byId('name-form', HTMLFormElement);
  const field = byId('name', HTMLInputElement);
  const note = byId('name-note', HTMLElement);
  const foot = byId('tape-foot', HTMLElement);
  const SAYS = opener.textContent ?? '';

  /** @param {boolean} open */
  function show(open) {
    form.hidden = !open;
    foot.classList.toggle('naming', open);
    opener.setAttribute('aria-expanded', String(open));
    if (open) {
      field.focus();
      field.select();
      void punch();
    } else {
      opener.focus();
    }
  }

  async function punch() {
    const written = field.value;
    // Letters are lettered without their accents.
    const plain = written.normalize('NFD').replace(/\p{M}/gu, '');
    const begins = await beginning(BEGINNING);
    const [rows, { advice, missing }] = await Promise.all([
      engine.fact('lettering', plain),
      engine.fact('letteringNote', plain, begins),
    ]);
    if (field.value !== written) return;
    note.textContent = missing === '' ? advice : `There is no letter of holes for ${[...missing].join(' ')}. ${advice}`;
    opener.textContent = rows.length === 0 ? SAYS : `In the leader: ${written.trim()}`;
    if (rows.length > 0 || store.state.leader.length > 0) store.set({ leader: rows });
  }

  opener.addEventListener('click', () => show(form.hidden === true));
  field.addEventListener('input', () => void punch());
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    show(false);
  });
  form.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    show(false);
  });
}
