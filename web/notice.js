// What went wrong with the page itself, said plainly.
import { button, byId, el } from './dom.js';

/**
 * @param {string} words
 * @param {{ lasting?: boolean }} [options]  lasting: it cannot be put away
 */
export function notice(words, { lasting = false } = {}) {
  const box = byId('notice', HTMLElement);
  box.replaceChildren(el('p', null, words), lasting ? '' : button('small', 'Close', () => (box.hidden = true)));
  box.hidden = false;
}

export function clearNotice() {
  byId('notice', HTMLElement).hidden = true;
}
