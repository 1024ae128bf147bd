// What the text is: a tape, or CLDATA that becomes one. The page shows what belongs to it.
import { byId } from '../dom.js';

/** @typedef {import('nctape').SourceKind} SourceKind */

/** @type {SourceKind[]} */
const KINDS = ['tape', 'cldata'];

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {(kind: SourceKind) => void} parts.turn
 */
export function makeKindSwitch({ store, turn }) {
  const app = byId('app', HTMLElement);
  const choices = KINDS.map((kind) => byId(`kind-${kind}`, HTMLElement));
  function show() {
    const { kind } = store.state;
    app.dataset.kind = kind;
    choices.forEach((choice, index) => {
      const chosen = KINDS[index] === kind;
      choice.setAttribute('aria-checked', String(chosen));
      choice.tabIndex = chosen ? 0 : -1;
    });
  }
  /** @param {SourceKind} kind */
  function choose(kind) {
    if (kind !== store.state.kind) turn(kind);
  }
  choices.forEach((choice, index) => {
    choice.addEventListener('click', () => choose(KINDS[index]));
    choice.addEventListener('keydown', (event) => {
      if (!['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'].includes(event.key)) return;
      event.preventDefault();
      choices[1 - index].focus();
      choose(KINDS[1 - index]);
    });
  });
  store.on(['kind'], show);
  show();
}

/**
 * What the pieces of the text are called.
 * @param {import('../store.js').State} state
 */
export const pieceWord = ({ kind }) => (kind === 'cldata' ? 'record' : 'block');
