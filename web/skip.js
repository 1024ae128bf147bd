// The optional block skip switch: there only where the tape has a block that it leaves out.
import { byId } from './dom.js';

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {() => number} parts.cursor
 */
export function makeSkip({ store, engine, cursor }) {
  const label = byId('skip-label', HTMLElement);
  const box = byId('skip', HTMLInputElement);
  box.checked = store.state.skip;
  box.addEventListener('change', () => {
    store.set({ skip: box.checked });
    engine.alter({ skip: box.checked, offset: cursor() });
  });
  store.on(['summary'], ({ summary }) => {
    label.hidden = summary === null || summary.skips === 0;
  });
}
