// The slider for the one thing of a format that no tape shows: where the decimal sign is understood.
import { byId } from './dom.js';
import { counted } from './words.js';

/** @typedef {import('nctape').Format} Format */

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {(format: Format) => void} parts.attempt  changes the format while the hand moves
 * @param {(began: Format) => void} parts.keep  the hand rests: undo goes back to this format
 */
export function makeDecimals({ store, engine, attempt, keep }) {
  const slider = byId('decimals', HTMLInputElement);
  const words = byId('decimals-words', HTMLElement);
  /** The format that the slider stands for, and where its decimal sign is. @type {{ format: Format, places: number } | null} */
  let known = null;
  /** The hand is ahead of the format. */
  let following = false;
  /** The format before the hand moved. @type {Format | null} */
  let began = null;
  let resting = true;

  async function refresh() {
    if (following) return;
    const { format } = store.state;
    if (known?.format === format) {
      slider.value = String(known.places);
      tell();
      return;
    }
    const found = await engine.fact('decimalPlaces', format);
    if (store.state.format !== format || following) return;
    known = found && { format, places: found.places };
    slider.disabled = found === null || found.least === found.greatest;
    if (found !== null) {
      slider.min = String(found.least);
      slider.max = String(found.greatest);
      slider.value = String(found.places);
    }
    tell();
  }

  function tell() {
    const value = known === null ? 'not in the format' : counted(Number(slider.value), 'place');
    words.textContent = value;
    slider.setAttribute('aria-valuetext', value);
  }

  /** Moves the decimal sign to where the slider is, one format after another until it has caught up. */
  async function follow() {
    tell();
    if (following) return;
    following = true;
    began ??= store.state.format;
    while (known !== null && known.format === store.state.format && known.places !== Number(slider.value)) {
      const places = Number(slider.value);
      const { format } = known;
      const next = await engine.fact('shiftDecimals', format, places);
      if (next === null || store.state.format !== format) break;
      known = { format: next, places };
      attempt(next);
    }
    following = false;
    settle();
    // Where the format was changed from elsewhere meanwhile, the slider goes to it.
    void refresh();
  }

  /** One drag is one step of undo, however many formats it went through. */
  function settle() {
    if (!resting || following || began === null) return;
    const from = began;
    began = null;
    if (known !== null && known.format === store.state.format && from !== store.state.format) keep(from);
  }

  slider.addEventListener('input', () => {
    resting = false;
    void follow();
  });
  slider.addEventListener('change', () => {
    resting = true;
    settle();
  });
  store.on(['format'], () => void refresh());
  void refresh();
}
