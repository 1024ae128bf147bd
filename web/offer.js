// Offers another format where the present one leaves most blocks in error, as after a paste.
import { pieceWord } from './cldata/kind.js';
import { byId, el, whenQuiet } from './dom.js';
import { counted } from './words.js';

const SETTLE = 400;

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {() => void} parts.suggest
 */
export function makeOffer({ store, engine, suggest }) {
  const note = byId('program-note', HTMLElement);
  const offer = byId('suggest-offer', HTMLButtonElement);
  offer.addEventListener('click', suggest);
  let misfits = false;

  async function judge() {
    const { summary } = store.state;
    if (summary === null) return;
    // A block in error has an error: only where there are enough of them the blocks are looked at.
    const isTape = store.state.kind === 'tape';
    const found = isTape && summary.errors * 2 > summary.blocks && (await engine.ask('misfits', summary.blocks));
    if (found === undefined) return;
    misfits = found;
    show();
  }
  function show() {
    const { summary } = store.state;
    if (summary === null) return;
    note.replaceChildren(
      counted(summary.blocks, pieceWord(store.state)),
      misfits ? el('span', { class: 'note-more' }, ', most with errors') : '',
    );
    offer.hidden = !misfits;
  }

  const settle = whenQuiet(() => void judge(), SETTLE);
  store.on(['summary'], ({ whole }) => {
    if (whole) void judge();
    else settle();
    show();
  });
}
