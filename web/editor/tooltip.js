// What is wrong under the pointer, with its corrections.
import { hoverTooltip } from '@codemirror/view';
import { el } from '../dom.js';
import { marksField, shownRange } from './marks.js';

/** @typedef {import('nctape').Diagnostic} Diagnostic */

/** The worst first, and no more than a glance takes in: all of them are in the list. */
const WORST = ['error', 'warning', 'info'];
const MOST = 3;

/** @param {(diagnostic: Diagnostic) => HTMLElement} card */
export const problemTooltip = (card) =>
  hoverTooltip((view, position) => {
    const { doc } = view.state;
    const found = view.state.field(marksField).diagnostics.filter((diagnostic) => {
      const range = shownRange(diagnostic, doc);
      return range !== null && range.from <= position && position <= range.to;
    });
    if (found.length === 0) return null;
    found.sort((one, other) => WORST.indexOf(one.severity) - WORST.indexOf(other.severity));
    return {
      pos: Math.min(...found.map(({ from }) => from)),
      above: false,
      create: () => ({ dom: el('div', { class: 'cm-cards' }, ...found.slice(0, MOST).map(card)) }),
    };
  });
