// Three short hints at the first visit. Once gone they stay away.
import { button, byId, el } from './dom.js';
import { recall, remember } from './storage.js';

const HINTS = [
  { by: 'strip', words: 'This is the tape that the program punches. Drag it under the reader head.' },
  { by: 'editor', words: 'Change a digit. The holes and the path follow at once, and what is wrong is underlined.' },
  { by: 'plot', words: 'Press a piece of the path to find its block. What you are on is lit everywhere.' },
];

/** @param {(view: string) => void} reveal  brings a view to the front where only one of them is seen */
export function makeHints(reveal) {
  const card = byId('hint', HTMLElement);
  if (recall('hints') === 'done') return;
  let at = 0;

  function end() {
    remember('hints', 'done');
    card.hidden = true;
    point(null);
    reveal('editor');
  }
  /** @param {string | null} by  the view that the hint speaks of */
  function point(by) {
    for (const hint of HINTS) byId(hint.by, HTMLElement).classList.toggle('hinted', hint.by === by);
  }
  function show() {
    const { by, words } = HINTS[at];
    const last = at === HINTS.length - 1;
    point(by);
    reveal(by);
    card.replaceChildren(
      el('p', null, words),
      el(
        'div',
        { class: 'hint-foot' },
        el('span', { class: 'hint-count' }, `${at + 1} of ${HINTS.length}`),
        last ? null : button('small link', 'No more hints', end),
        button('small primary', last ? 'Got it' : 'Next', () => (last ? end() : ((at += 1), show()))),
      ),
    );
    card.hidden = false;
  }
  show();
}
