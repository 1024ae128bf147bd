// The whole tape in numbers: the paper, the motion, the room that it takes.
import { button, byId, el } from './dom.js';
import { lazily } from './lazy.js';
import { blockName } from './plot/words.js';
import { counted, feet, longLength, metres, shortCoordinate, time, whole } from './words.js';

/** @typedef {import('./store.js').Summary} Summary */
/** @typedef {[name: string, value: string, ...(Node | string)[]]} Part */

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {(field: string | null) => void} parts.openFormat  at a field, where one is named
 * @param {string[]} parts.kinds
 * @param {(range: { from: number, to: number }) => void} parts.show
 */
export function makeTotals({ store, engine, kinds, openFormat, show }) {
  const box = byId('totals', HTMLElement);
  const times = lazily(async () => (await import('./speeds/times.js')).makeTimes({ store, engine, kinds, show, openFormat, closed }));
  const timesButton = button('small link', 'Block by block', toggleTimes, { 'aria-expanded': 'false', title: 'How long each block takes, beside the time of the reader' });
  /** Why the time is not known. @type {{ sentence: string, field: string | null, block: import('./store.js').BlockView | null } | null} */
  let reason = null;
  let speed = 0;
  /** @type {import('nctape').Format | null} */
  let speedOf = null;

  async function refresh() {
    const { summary, format } = store.state;
    if (summary === null) return;
    if (speedOf !== format) {
      speed = await engine.fact('readerSpeed', format);
      speedOf = format;
    }
    reason = null;
    if (summary.totals.seconds === null) {
      const found = await engine.ask('untimed');
      if (found === undefined) return;
      if (found !== null) reason = { ...(await engine.fact('whyUntimed', found.kind, format)), block: found.block };
    }
    if (store.state.summary === summary) tell(summary);
  }

  /** @param {Summary} summary */
  function tell(summary) {
    const { totals, unit, bounds } = summary;
    /** @type {Part[][]} */
    const lines = [
      [
        ['Tape', `${counted(summary.posted?.blocks ?? summary.blocks, 'block')}, ${counted(totals.rows, 'row')}, ${metres(totals.tapeMillimetres)} (${feet(totals.tapeMillimetres)})`],
        ['Reading', `${time(totals.rows / speed)} at ${whole(speed)} rows/s`],
      ],
      [
        ['Cutting', longLength(totals.cutting, unit)],
        ['Rapid', longLength(totals.rapid, unit)],
        ['Within', bounds === null ? 'no motion' : boxWords(bounds, summary)],
      ],
      [['Machining', summary.spans === 0 ? 'no motion' : time(totals.seconds), ...why(), ' ', summary.posted === undefined ? timesButton : '']],
    ];
    box.replaceChildren(
      ...lines.map((parts) =>
        el(
          'p',
          { class: 'total-line' },
          ...parts.map(([name, value, ...more]) => el('span', { class: 'total' }, el('span', { class: 'total-name' }, `${name} `), value, ...more)),
        ),
      ),
    );
  }

  async function toggleTimes() {
    timesButton.setAttribute('aria-expanded', String((await times()).toggle()));
  }
  function closed() {
    timesButton.setAttribute('aria-expanded', 'false');
    timesButton.focus();
  }

  /** Why the time is not known, and the way to where it is said. */
  function why() {
    if (reason === null) return [];
    const { sentence, field, block } = reason;
    const place = block && button('small link', `at ${blockName(block)}`, () => show({ from: block.from, to: block.to }));
    const set = field !== null && button('small link', 'State it', () => openFormat(field), { title: 'Opens the format at this field' });
    return [el('span', { class: 'total-why' }, ' ', place, ': ', sentence, ' ', set)];
  }

  store.on(['summary'], () => void refresh());
}

/**
 * "X 10 to 85  Y 10 to 55 mm"
 * @param {NonNullable<Summary['bounds']>} bounds
 * @param {Summary} summary
 */
function boxWords({ min, max }, { axes, unit }) {
  const sides = min.map((least, axis) => `${axes[axis] ?? '?'} ${shortCoordinate(least, unit)} to ${shortCoordinate(max[axis], unit)}`);
  return `${sides.join('  ')} ${unit === 'mm' ? 'mm' : 'in'}`;
}
