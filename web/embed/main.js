// The page that is one file: the playground in a frame of another page, or opened from a disk.
import './embed.css';
import { byId, el } from '../dom.js';
import { Engine } from '../engine.js';
import { clearNotice, notice } from '../notice.js';
import { emptyState, Store } from '../store.js';
import { themeOf } from '../theme.js';
import { hearHost, isFramed, tellHost } from './host.js';
import { packedWorker } from './packed.js';
import { makePlayground } from './playground.js';
import { isText } from './protocol.js';
import { inAddress, ofTape, settingsOf, statedIn, tapeOf } from './settings.js';

/** The page around has so many milliseconds to say what it wants; then something is shown all the same. */
const PATIENCE = 5000;

byId('app', HTMLElement).hidden = false;
const store = new Store(emptyState(themeOf('auto')));

/** @type {import('./playground.js').Playground | null} */
let playground = null;
/** The notice says that the checker waits for a change. */
let isDown = false;

/** @param {string} words */
function trouble(words) {
  notice(words);
  tellHost('error', { message: words });
}

const engine = new Engine({
  makeWorker: packedWorker,
  current: () => playground?.current() ?? { source: '', format: store.state.format, skip: false, offset: 0 },
  onChange(change) {
    if (isDown) clearNotice();
    isDown = false;
    playground?.changed(change);
  },
  onRefusal: (message) => trouble(`The format was not taken: ${message}`),
  onTrap(message, down) {
    isDown = down;
    trouble(`The checker met a fault of its own (${message}). Your text is kept${down ? ', and it is checked again at your next change' : ''}.`);
  },
  onFail: (message) => trouble(`The checker could not be loaded: ${message}. Nothing is checked.`),
});

/** What was stated last. @type {import('./settings.js').Stated} */
let stated = {};

async function start() {
  const address = inAddress(location.hash);
  const hosted = address.hosted && isFramed();
  /** @type {Promise<import('./settings.js').Stated>} */
  const first = hosted ? firstWish() : Promise.resolve(address.stated);
  const [presets, kinds, standards, version] = await Promise.all([
    engine.fact('presets'),
    engine.fact('spanKinds'),
    engine.fact('standards'),
    engine.fact('version'),
  ]);
  const known = { presets: presets.filter(({ kind }) => kind === 'tape'), standards: standards.map(({ id }) => /** @type {string} */ (id)) };
  const made = makePlayground({ store, engine, kinds });

  /** Shows what was stated; the tape anew where it is among that. @param {boolean} anew */
  async function show(anew) {
    const settings = await settingsOf(stated, known, trouble);
    const tape = anew ? await tapeOf(stated, known, trouble) : null;
    playground = made;
    made.show(settings, tape);
  }

  stated = await first;
  await show(true);
  if (!isFramed()) offerPresets(known.presets, (id) => {
    stated = { ...ofTape(stated, false), preset: id };
    void show(true);
  });
  tellHost('ready', { version: version.package });

  if (!hosted) {
    window.addEventListener('hashchange', () => {
      ({ stated } = inAddress(location.hash));
      void show(true);
    });
  }
  hearHost(({ type, ...fields }) => {
    if (type === 'open' || type === 'set') {
      stated = type === 'open' ? statedIn(fields) : { ...ofTape(stated, true), ...ofTape(statedIn(fields), false) };
      void show(type === 'open');
    } else if (type === 'setText' && isText(fields.text)) made.setText(fields.text);
    else if (type === 'getText' && typeof fields.id === 'number') tellHost('text', { id: fields.id, text: made.current().source });
    else if (type === 'select' && isText(fields.block, 100)) void made.select(fields.block);
    else if (type === 'reset') made.reset();
  });
}

/** What the page around wants to begin with. @returns {Promise<import('./settings.js').Stated>} */
function firstWish() {
  return new Promise((resolve) => {
    const late = setTimeout(() => resolve({}), PATIENCE);
    hearHost(({ type, ...fields }) => {
      if (type !== 'open') return;
      clearTimeout(late);
      resolve(statedIn(fields));
    });
    tellHost('hello');
  });
}

/**
 * Opened by itself the page has the examples to choose from.
 * @param {import('nctape').Preset[]} presets
 * @param {(id: string) => void} choose
 */
function offerPresets(presets, choose) {
  const picker = byId('preset', HTMLSelectElement);
  picker.append(el('option', { value: '' }, 'Examples…'), ...presets.map(({ id, title }) => el('option', { value: id }, title)));
  picker.addEventListener('change', () => {
    if (picker.value !== '') choose(picker.value);
  });
  byId('pick', HTMLElement).hidden = false;
}

void start();
