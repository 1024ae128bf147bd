// The list of problems: it settles when typing pauses, and moves with the text until then.
import { pieceWord } from './cldata/kind.js';
import { button, byId, el, whenQuiet } from './dom.js';
import { moved } from './editor/marks.js';
import { deedsOf, messageOf } from './problem-card.js';
import { severityMark } from './severity.js';
import { counted, tally, whole } from './words.js';

/** @typedef {import('nctape').Diagnostic} Diagnostic */

/** So many are listed; the rest is a number. */
const MOST = 200;
const SETTLE = 400;
const SAY = 1000;

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {import('./problem-card.js').Deeds} parts.deeds
 * @param {() => number} parts.textLength
 * @param {() => number} parts.cursor
 */
export function makeProblems({ store, engine, deeds, textLength, cursor }) {
  const list = byId('problem-list', HTMLElement);
  const empty = byId('problem-empty', HTMLElement);
  const tallies = byId('tallies', HTMLElement);
  const tabCount = byId('tab-count', HTMLElement);
  const status = byId('status', HTMLElement);
  /** @type {Diagnostic[]} */
  let shown = [];
  let first = true;

  async function refresh() {
    const found = await engine.ask('problems', 0, textLength() + 1, MOST);
    const { summary } = store.state;
    if (found === undefined || summary === null) return;
    shown = found;
    const total = summary.errors + summary.warnings + summary.infos;
    const focused = focusedIndex();
    list.replaceChildren(...shown.map(entry));
    if (focused !== null) /** @type {HTMLElement | null} */ (list.children[focused]?.querySelector('button'))?.focus();
    empty.textContent =
      total === 0 || summary.blocks === 0
        ? emptyWords(store.state, summary)
        : total > shown.length
          ? `… and ${whole(total - shown.length)} more further on. They come up when these are settled.`
          : '';
    empty.classList.toggle('quiet', total > 0);
    tabCount.textContent = total === 0 ? '' : whole(total);
    tabCount.dataset.worst = summary.errors > 0 ? 'error' : summary.warnings > 0 ? 'warning' : 'info';
    tallies.replaceChildren(...tallyMarks(summary));
    showLit();
    say();
  }

  /** Which entry holds the focus, so that it may have it again. */
  function focusedIndex() {
    const holder = document.activeElement?.closest('.problem-list > li');
    return holder ? [...list.children].indexOf(holder) : null;
  }

  const say = whenQuiet(() => {
    const { summary } = store.state;
    if (summary === null) return;
    const [worst] = shown;
    const count = tally(summary);
    const words = count === '' ? 'No problems.' : `${count}.${worst ? ` First: line ${worst.line}, ${worst.message}` : ''}`;
    if (status.textContent !== words) status.textContent = words;
  }, SAY);

  /** @param {Diagnostic} _ @param {number} index */
  function entry(_, index) {
    const diagnostic = shown[index];
    const main = button('problem', '', () => deeds.show(shown[index]));
    main.append(
      severityMark(diagnostic.severity),
      el('span', { class: 'place' }, `${diagnostic.line}:${diagnostic.column}`),
      el('span', { class: 'rule-id' }, diagnostic.rule),
      messageOf(diagnostic),
    );
    // The deeds look the problem up when they are pressed: it may have moved since.
    const here = () => shown[index];
    const extra = deedsOf(
      diagnostic,
      {
        ...deeds,
        apply: (fix) => deeds.apply(here().fixes?.[diagnostic.fixes?.indexOf(fix) ?? 0] ?? fix),
        show: (range) =>
          deeds.show(here().related?.[diagnostic.related?.findIndex((one) => one === range) ?? 0] ?? range),
      },
      { withRule: false },
    );
    return el(
      'li',
      null,
      main,
      button('about', 'About', () => deeds.openRule(diagnostic.rule), {
        'aria-label': `About ${diagnostic.rule}`,
        title: `What ${diagnostic.rule} means`,
      }),
      extra,
    );
  }

  /** Lights what concerns the block under the cursor, in the same moment as the other views. */
  function showLit() {
    const { here, chosen } = store.state;
    shown.forEach((diagnostic, index) => {
      const item = list.children[index];
      const block = here?.block;
      const lit = block ? diagnostic.from <= block.to && diagnostic.to >= block.from : false;
      const current = chosen !== null && chosen.from === diagnostic.from && chosen.to === diagnostic.to;
      item?.classList.toggle('lit', lit);
      item?.classList.toggle('chosen', current);
      item?.querySelector('.problem')?.toggleAttribute('aria-current', lit);
      if (lit) bringIntoList(item);
    });
  }
  let lastBrought = -1;
  /** @param {Element | undefined} item */
  function bringIntoList(item) {
    const block = store.state.here?.block?.index ?? -1;
    if (block === lastBrought || list.contains(document.activeElement)) return;
    lastBrought = block;
    item?.scrollIntoView({ block: 'nearest' });
  }

  const settle = whenQuiet(() => void refresh(), SETTLE);
  store.on(['summary'], () => {
    if (first || store.state.whole) void refresh();
    else settle();
    first = false;
  });
  store.on(['here', 'chosen'], showLit);

  return {
    /** @param {import('@codemirror/state').ChangeDesc} changes */
    move(changes) {
      shown = moved(shown, changes);
    },
    /** @param {1 | -1} direction */
    async goTo(direction) {
      const all = await engine.ask('problems', 0, textLength() + 1, 100_000);
      if (all === undefined || all.length === 0) return;
      const at = cursor();
      const next =
        direction > 0
          ? (all.find(({ from }) => from > at) ?? all[0])
          : (all.filter(({ from }) => from < at).at(-1) ?? all[all.length - 1]);
      deeds.show(next);
    },
  };
}

/**
 * @param {import('./store.js').State} state
 * @param {import('nctape').Summary} summary
 */
function emptyWords(state, { blocks }) {
  if (blocks > 0) return `Nothing to object to in ${counted(blocks, pieceWord(state))}.`;
  return state.kind === 'cldata'
    ? 'There is no record yet. Type one, paste CLDATA or the CL text of a CAM system, or choose an example above.'
    : 'Nothing is on the tape yet. Type a block, paste a listing, or choose an example above.';
}

/** @param {import('nctape').Summary} summary */
function tallyMarks({ errors, warnings, infos }) {
  /** @type {[import('nctape').Severity, number, string][]} */
  const counts = [
    ['error', errors, 'error'],
    ['warning', warnings, 'warning'],
    ['info', infos, 'note'],
  ];
  return counts
    .filter(([, count]) => count > 0)
    .map(([severity, count, word]) => el('span', { class: 'tally' }, severityMark(severity), counted(count, word)));
}
