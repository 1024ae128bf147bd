// The header: which tape, and the format in one line.
import { byId } from './dom.js';
import { makePicker } from './own-tape.js';
import { severityMark, SEVERITY_WORD } from './severity.js';

/** @typedef {import('nctape').Preset} Preset */

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {Preset[]} parts.presets
 * @param {(preset: Preset) => void} parts.choose
 * @param {() => import('./own-tape.js').Whole} parts.current
 * @param {(tape: import('./own-tape.js').Whole) => void} parts.load
 * @param {import('./own-tape.js').Whole | null} parts.own  the visitor's tape of an earlier visit
 * @param {import('./own-tape.js').Whole[]} parts.earlier  those before it
 * @param {string | null} parts.guest  what the tape that opens first is called, where it is a guest
 */
export function makeHeader({ store, engine, presets, choose, current, load, own, earlier, guest }) {
  const picker = makePicker({ presets, choose, current, load, own, earlier, guest });

  const line = byId('format-text', HTMLElement);
  const flag = byId('format-flag', HTMLElement);
  async function tellFormat() {
    const { format } = store.state;
    const [words, explanation] = await Promise.all([
      engine.fact('formatLine', format),
      engine.fact('explainFormat', format),
    ]);
    if (store.state.format !== format) return;
    line.textContent = words;
    byId('format-button', HTMLElement).title = words;
    store.set({ explanation });
    const worst = ['error', 'warning'].find((severity) => explanation.diagnostics.some((one) => one.severity === severity));
    flag.replaceChildren(worst === undefined ? '' : severityMark(/** @type {'error' | 'warning'} */ (worst)));
    flag.title = worst === undefined ? '' : `${SEVERITY_WORD[/** @type {'error' | 'warning'} */ (worst)]} in the format`;
  }
  store.on(['format'], () => void tellFormat());
  void tellFormat();

  return picker;
}
