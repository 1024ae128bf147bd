// Formats that would fit the tape, for a listing that came without one: what each rests on, and a press to take it.
import { button, el } from '../dom.js';
import { severityMark } from '../severity.js';
import { counted } from '../words.js';

/** @typedef {import('nctape').Format} Format */
/** @typedef {import('nctape').Suggestion} Suggestion */

/**
 * What one suggestion rests on and another does not.
 * @param {Suggestion} one
 * @param {Suggestion} other
 */
const apart = (one, other) =>
  [...one.sure, ...one.assumed].filter((ground) => ![...other.sure, ...other.assumed].includes(ground)).join(' ');

/** So many are worth comparing. */
const MOST = 4;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {() => { toString(): string }} parts.text  of the tape: another object after each change of the text
 * @param {(format: Format) => void} parts.change
 */
export function makeSuggestions({ store, engine, text, change }) {
  const asker = button('small', 'Suggest a format', () => void ask());
  const words = el('p', { class: 'suggest-words', role: 'status' });
  const list = el('ol', { class: 'suggestions' });
  /** What the shown suggestions were made for. @type {unknown} */
  let madeFor = null;
  /** @type {{ format: Format, taker: HTMLButtonElement, card: HTMLElement }[]} */
  let takers = [];

  async function ask() {
    const about = text();
    madeFor = about;
    words.textContent = 'Trying formats …';
    list.replaceChildren();
    takers = [];
    const known = store.state.format;
    const suggested = (await engine.fact('suggestFormat', about.toString())).slice(0, MOST);
    // A listing does not know the machine: what was known of it holds on.
    const found = await Promise.all(
      suggested.map(async (one) => ({ ...one, format: await engine.fact('onMachineOf', one.format, known) })),
    );
    const lines = await Promise.all(found.map(({ format }) => engine.fact('formatLine', format)));
    if (madeFor !== about || text() !== about) return;
    takers = found.map((suggestion, index) => {
      const twin = found.find((other, at) => at !== index && lines[at] === lines[index]);
      return card(suggestion, lines[index], index === 0, twin === undefined ? null : apart(suggestion, twin));
    });
    list.replaceChildren(...takers.map((taker) => taker.card));
    words.textContent =
      found.length === 0
        ? 'No format can be suggested: nothing in the program could be read as a word.'
        : `${counted(found.length, 'format')} would read this program, the best one first. Undo takes a format back.`;
    showUsed();
  }

  /**
   * @param {Suggestion} suggestion
   * @param {string} line
   * @param {boolean} first
   * @param {string | null} difference  from another suggestion of the same line
   */
  function card({ format, sure, assumed, errors }, line, first, difference) {
    const taker = button('small', '', () => {
      if (!isUsed(format)) change(format);
    });
    const grounds = el('details', { open: first }, el('summary', null, 'What it rests on'), part('Read off the tape', sure), part('Assumed', assumed));
    return {
      format,
      taker,
      card: el(
        'li',
        { class: 'suggestion' },
        el('p', { class: 'suggestion-line' }, line),
        difference && el('p', { class: 'suggestion-apart' }, difference),
        el(
          'p',
          { class: 'suggestion-errors' },
          errors > 0 && severityMark('error'),
          errors === 0 ? 'leaves no error' : `leaves ${counted(errors, 'error')}`,
        ),
        taker,
        grounds,
      ),
    };
  }

  /** @param {Format} format */
  const isUsed = (format) => JSON.stringify(format) === JSON.stringify(store.state.format);

  function showUsed() {
    for (const { format, taker, card } of takers) {
      const used = isUsed(format);
      taker.textContent = used ? 'In use' : 'Use this format';
      taker.classList.toggle('primary', !used && takers[0].taker === taker);
      card.classList.toggle('used', used);
    }
  }

  store.on(['format'], showUsed);
  // What was suggested for another text is worth nothing.
  store.on(['summary'], () => {
    if (madeFor === null || text() === madeFor) return;
    madeFor = null;
    takers = [];
    list.replaceChildren();
    words.textContent = '';
  });

  return {
    element: el(
      'section',
      { class: 'suggest', 'aria-label': 'Suggested formats' },
      el('p', { class: 'suggest-ask' }, el('span', null, 'The format is not known?'), asker),
      words,
      list,
    ),
    ask,
  };
}

/**
 * @param {string} title
 * @param {string[]} sentences
 */
function part(title, sentences) {
  if (sentences.length === 0) return null;
  return el('div', null, el('h3', null, title), el('ul', null, ...sentences.map((sentence) => el('li', null, sentence))));
}
