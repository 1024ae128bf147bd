// The page begins here: it shows itself, starts the engine, and asks it for all that it does not know itself.
import { byId } from './dom.js';
import { Engine } from './engine.js';
import { clearNotice, notice } from './notice.js';
import { makePlayground } from './playground.js';
import { begin } from './start.js';
import { emptyState, Store } from './store.js';
import { startTheme } from './theme.js';
import { trustedWorker } from './trusted.js';
import workerAddress from './page-worker.js?worker&url';

byId('start', HTMLElement).remove();
byId('app', HTMLElement).hidden = false;

const store = new Store(emptyState(startTheme()));

/** @type {import('./playground.js').Playground | null} */
let playground = null;

/** The notice says that the checker waits for a change. */
let isDown = false;

const engine = new Engine({
  makeWorker: () => trustedWorker(workerAddress, { type: 'module', name: 'nctape' }),
  current: () => playground?.current() ?? { source: '', format: store.state.format, skip: false, offset: 0 },
  onChange(change) {
    if (isDown) clearNotice();
    isDown = false;
    playground?.changed(change);
  },
  onRefusal: (message) => notice(`The format was not taken: ${message}`),
  onTrap(message, down) {
    isDown = down;
    notice(
      down
        ? `The checker fails on this tape (${message}). Your text is kept, and the checker tries again at your next change.`
        : `The checker met a fault of its own (${message}) and was started again with your text.`,
    );
  },
  onFail: (message) =>
    notice(`The checker could not be loaded: ${message}. Nothing is checked. Reload the page to try again.`, { lasting: true }),
});

async function start() {
  const [presets, kinds, version] = await Promise.all([
    engine.fact('presets'),
    engine.fact('spanKinds'),
    engine.fact('version'),
  ]);
  byId('version', HTMLElement).textContent = `Version ${version.package}`;
  const beginning = await begin(engine, presets);
  playground = makePlayground({ store, engine, kinds, presets, beginning });
}

void start();
