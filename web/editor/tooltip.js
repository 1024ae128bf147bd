// What is wrong under the pointer, with its corrections.
import { hoverTooltip } from '@codemirror/view';
import { el } from '../dom.js';
import { marksField, shownRange } from './marks.js';

/** @typedef {import('nctape').Diagnostic} Diagnostic */

/** @param {(diagnostic: Diagnostic) => HTMLElement} card */
export const problemTooltip = (card) =>
  hoverTooltip((view, position) => {
    const { doc } = view.state;
    const found = view.state.field(marksField).diagnostics.filter((diagnostic) => {
      const range = shownRange(diagnostic, doc);
      return range !== null && range.from <= position && position <= range.to;
    });
    if (found.length === 0) return null;
    return {
      pos: Math.min(...found.map(({ from }) => from)),
      above: false,
      create: () => ({ dom: el('div', { class: 'cm-cards' }, ...found.slice(0, 4).map(card)) }),
    };
  });
