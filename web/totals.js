// The whole tape in one line of numbers.
import { byId, el } from './dom.js';
import { counted, longLength, metres, time } from './words.js';

/** @param {import('./store.js').Store} store */
export function makeTotals(store) {
  const line = byId('totals', HTMLElement);
  store.on(['summary'], ({ summary }) => {
    if (summary === null) return;
    const { totals, unit } = summary;
    /** @type {[string, string][]} */
    const parts = [
      ['Tape', `${counted(summary.blocks, 'block')}, ${counted(totals.rows, 'row')}, ${metres(totals.tapeMillimetres)}`],
      ['Cutting', longLength(totals.cutting, unit)],
      ['Rapid', longLength(totals.rapid, unit)],
      ['Time', time(totals.seconds)],
    ];
    line.replaceChildren(
      ...parts.map(([name, value]) => el('span', { class: 'total' }, el('span', { class: 'total-name' }, `${name} `), value)),
    );
  });
}
