// The dialog that says in words what the page is, how the holes are made, and how the keys go.
import { byId, el } from './dom.js';

/**
 * @param {import('./engine.js').Engine} engine
 * @param {() => void} openCalculator
 */
export function makeLearn(engine, openCalculator) {
  const dialog = byId('learn', HTMLDialogElement);
  const place = byId('learn-codes', HTMLElement);
  byId('learn-button', HTMLElement).addEventListener('click', async () => {
    dialog.showModal();
    if (place.childElementCount > 0) return;
    const { tape, codes } = await engine.fact('aboutCodes');
    place.replaceChildren(...tape.map((sentence) => el('p', null, sentence)), ...codes.flatMap(codeWords));
  });
  byId('calculator-button', HTMLElement).addEventListener('click', () => {
    dialog.close();
    openCalculator();
  });
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
}

/** @param {import('nctape').AboutCodes['codes'][number]} code */
function codeWords({ title, tracks, about }) {
  const numbers = tracks.map((_, index) => index + 1).reverse();
  return [
    el('h4', null, title),
    el(
      'table',
      { class: 'track-table' },
      el('tbody', null,
        el('tr', null, el('th', { scope: 'row' }, 'Track'), ...numbers.map((number) => el('td', null, String(number)))),
        el('tr', null, el('th', { scope: 'row' }, 'Hole'), ...numbers.map((number) => el('td', null, tracks[number - 1]))),
      ),
    ),
    ...about.map((sentence) => el('p', null, sentence)),
  ];
}
