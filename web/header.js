// The header: which example, and the format in one line.
import { byId, el } from './dom.js';
import { severityMark, SEVERITY_WORD } from './severity.js';

/** @typedef {import('nctape').Preset} Preset */

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {Preset[]} parts.presets
 * @param {(preset: Preset) => void} parts.choose
 */
export function makeHeader({ store, engine, presets, choose }) {
  const picker = byId('preset', HTMLSelectElement);
  const own = el('option', { value: '', hidden: true }, 'Your tape');
  picker.replaceChildren(own, ...presets.map(({ id, title }) => el('option', { value: id }, title)));
  picker.addEventListener('change', () => {
    const preset = presets.find(({ id }) => id === picker.value);
    if (preset !== undefined) choose(preset);
  });

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

  return {
    /**
     * Shows which example the text is, if it is one.
     * @param {(source: string) => boolean} is
     */
    name(is) {
      const preset = presets.find(({ source }) => is(source));
      picker.value = preset?.id ?? '';
      picker.title = preset?.about ?? '';
    },
  };
}
