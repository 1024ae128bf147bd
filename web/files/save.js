// Saves the tape to this machine: as a listing, as rows of holes, for a control of today, as a picture.
import { byId } from '../dom.js';
import { lazily } from '../lazy.js';
import { notice } from '../notice.js';
import { counted, whole } from '../words.js';
import { give } from './give.js';
import { MOST_ROWS, ROWS_IN_LINE } from './limits.js';

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {() => string} parts.source
 * @param {() => Promise<string>} parts.listing  of the tape; of CLDATA, of the one that it became
 * @param {() => void} parts.close  the menu
 */
export function makeSave({ store, engine, source, listing, close }) {
  const note = byId('save-note', HTMLElement);

  /** The rows of the tape, the letters in the leader before them. */
  async function rows() {
    const punched = await engine.fact('encode', await listing(), store.state.format);
    const { leader } = store.state;
    const all = new Uint8Array(leader.length + punched.length);
    all.set(leader);
    all.set(punched, leader.length);
    return all;
  }

  const named = (/** @type {string} */ ending) => `tape.${ending}`;
  byId('save-cldata', HTMLElement).addEventListener('click', () => {
    give(new Blob([source()], { type: 'text/plain' }), 'cldata.txt');
    close();
  });
  byId('save-listing', HTMLElement).addEventListener('click', async () => {
    give(new Blob([await listing()], { type: 'text/plain' }), named('txt'));
    close();
  });
  byId('save-rows', HTMLElement).addEventListener('click', async () => {
    give(new Blob([await rows()], { type: 'application/octet-stream' }), named('bin'));
    close();
  });
  byId('save-decimal', HTMLElement).addEventListener('click', async () => {
    const { text, diagnostics } = await engine.fact('toDecimal', await listing(), store.state.format, 'linuxcnc');
    give(new Blob([text], { type: 'text/plain' }), named('ngc'));
    const said = diagnostics.map(({ message }) => message);
    if (said.length > 0) notice(lacking(named('ngc'), said));
    close();
  });
  byId('save-picture', HTMLElement).addEventListener('click', async () => {
    const all = await rows();
    give(await engine.fact('tapePicture', all), named('png'));
    if (all.length > MOST_ROWS) notice(`The picture shows the first ${whole(MOST_ROWS)} rows of ${whole(all.length)}.`);
    close();
  });

  byId('save-drawing', HTMLElement).addEventListener('click', async () => {
    const all = await rows();
    give(new Blob([await engine.fact('tapeDrawing', all.subarray(0, MOST_ROWS), ROWS_IN_LINE)], { type: 'image/svg+xml' }), named('svg'));
    if (all.length > MOST_ROWS) notice(`The drawing shows the first ${whole(MOST_ROWS)} rows of ${whole(all.length)}.`);
    close();
  });

  const exports = lazily(async () => (await import('./exports.js')).makeExports({ store, engine, source, listing }));
  for (const name of /** @type {const} */ (['path', 'spans', 'report', 'problems', 'print'])) {
    byId(`save-${name}`, HTMLElement).addEventListener('click', async () => {
      close();
      await (await exports())[name]();
    });
  }

  return {
    /** Says what would be saved. */
    tell() {
      const { summary, leader } = store.state;
      const tape = counted(summary?.rows ?? 0, 'row');
      note.textContent =
        leader.length === 0
          ? `${tape}, one byte a row; track 1 is the lowest bit.`
          : `${tape}, and before them ${counted(leader.length, 'row')} with your name; one byte a row, track 1 the lowest bit.`;
    },
  };
}

/** As much as can be read at a glance: the file itself marks every place. */
const MOST_SENTENCES = 3;

/**
 * What a saved file lacks.
 * @param {string} name
 * @param {string[]} sentences  one at least
 */
function lacking(name, sentences) {
  const shown = sentences.slice(0, MOST_SENTENCES);
  const rest = sentences.length - shown.length;
  return [`${name} is saved, with ${counted(sentences.length, 'remark')}.`, ...shown, rest > 0 ? `And ${rest} more.` : '']
    .join(' ')
    .trim();
}
