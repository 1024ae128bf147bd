// The goal of an exercise as one line, and the moment when it is met.
import { byId, el } from '../dom.js';
import { goalWords, isMet } from './goal.js';
import { tellHost } from './host.js';

/**
 * @param {import('../store.js').Store} store
 * @param {import('../engine.js').Engine} engine
 */
export function goalTeller(store, engine) {
  const line = byId('goal', HTMLElement);
  /** @type {import('./goal.js').Goal | null} */
  let goal = null;
  let met = false;

  function show() {
    const { summary } = store.state;
    line.hidden = goal === null;
    if (goal === null || summary === null) return;
    const words = goalWords(goal, summary);
    line.classList.toggle('met', met);
    line.replaceChildren(ring(met), el('span', null, `${met ? 'Done' : 'Goal'}: ${words}.`));
  }

  return {
    /** @param {import('./goal.js').Goal | null} wanted */
    set(wanted) {
      goal = wanted;
      met = false;
      show();
    },
    /** @param {import('nctape').Format} format  of the tape */
    async judge(format) {
      const { summary } = store.state;
      if (goal === null || summary === null) return;
      const judged = goal;
      const is = await isMet(goal, summary, engine, format);
      if (is === undefined || judged !== goal) return;
      const isNew = is && !met;
      met = is;
      show();
      if (isNew) tellHost('solved', { goal: goalWords(goal, summary) });
    },
  };
}

const SVG = 'http://www.w3.org/2000/svg';

/** An open ring, or one with a tick in it. @param {boolean} ticked */
function ring(ticked) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'goal-ring');
  svg.setAttribute('viewBox', '0 0 20 20');
  svg.setAttribute('aria-hidden', 'true');
  const shape = document.createElementNS(SVG, 'path');
  shape.setAttribute('d', `M18 10a8 8 0 1 1-16 0a8 8 0 0 1 16 0${ticked ? 'M6 10.5l3 3l5.5-6.5' : ''}`);
  svg.append(shape);
  return svg;
}
