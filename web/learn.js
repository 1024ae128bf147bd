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
  const table = byId('learn-functions', HTMLDetailsElement);
  table.addEventListener('toggle', async () => {
    if (!table.open || table.childElementCount > 1) return;
    table.append(functionTable(await engine.fact('functions')));
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

/**
 * Codes in a row about which nothing but their state is known stand in one line.
 * @param {import('nctape').FunctionEntry[]} entries
 */
function functionTable(entries) {
  /** @type {{ first: string, last: string, entry: import('nctape').FunctionEntry }[]} */
  const lines = [];
  for (const entry of entries) {
    const before = lines.at(-1);
    const isLike = before !== undefined && entry.state !== 'assigned' && entry.code[0] === before.last[0] &&
      entry.state === before.entry.state && entry.conflict === before.entry.conflict;
    if (isLike) before.last = entry.code;
    else lines.push({ first: entry.code, last: entry.code, entry });
  }
  const rows = lines.map(({ first, last, entry: { state, meaning, group, acts, conflict } }) =>
    el('tr', state === 'assigned' ? null : { class: 'no-function' },
      el('th', { scope: 'row' }, first === last ? first : `${first}–${last}`),
      el('td', null, meaning || state, conflict === null ? '' : el('span', { class: 'conflict' }, ` ${conflict}`)),
      el('td', null, group),
      el('td', null, acts),
    ),
  );
  const heads = ['Code', 'Meaning', 'Group', 'Acts'].map((head) => el('th', { scope: 'col' }, head));
  return el('div', { class: 'function-scroll' },
    el('table', { class: 'function-table' }, el('thead', null, el('tr', null, ...heads)), el('tbody', null, ...rows)));
}
