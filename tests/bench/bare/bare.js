// The page's editor and nothing behind it: no engine, no tape, no path. What a keystroke takes here it takes anywhere.
import { makeEditor } from '../../../web/editor/editor.js';

const host = /** @type {HTMLElement} */ (document.getElementById('editor'));
const { view } = makeEditor({
  host,
  format: { standard: 'iso2539', detail: '' },
  kinds: [],
  ask: async () => undefined,
  card: () => document.createElement('div'),
  goToProblem() {},
  leave() {},
  onUpdate() {},
});

Object.assign(window, { view });
