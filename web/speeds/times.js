// The time of each block beside that of the reader: a picture under the path, and its words.
import { button, byId, el, onceAFrame } from '../dom.js';
import { palette } from '../palette.js';
import { blockName } from '../plot/words.js';
import { time } from '../words.js';

/** @typedef {import('nctape').BlockTimes} BlockTimes */
/** @typedef {import('../store.js').Store} Store */

/** Blocks named beside the picture. */
const NAMED = 6;
/** In CSS pixels: the widest bar, and the least height of what takes any time. */
const WIDEST = 28;
const LOWEST = 3;
/** Room for the figures of the scale. */
const SCALE = 48;

/**
 * @param {object} parts
 * @param {Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {string[]} parts.kinds
 * @param {(range: { from: number, to: number }) => void} parts.show
 * @param {(field: string | null) => void} parts.openFormat
 * @param {() => void} parts.closed
 */
export function makeTimes({ store, engine, kinds, show, openFormat, closed }) {
  const canvas = el('canvas', { 'aria-hidden': 'true' });
  const readout = el('p', { class: 'times-readout', 'aria-hidden': 'true' });
  const words = el('p', { class: 'times-words' });
  const named = el('p', { class: 'times-named' });
  const host = el(
    'section',
    { class: 'times', id: 'times', 'aria-labelledby': 'times-head', hidden: true },
    el(
      'div',
      { class: 'times-head' },
      el('h3', { id: 'times-head' }, 'Time of each block'),
      el('p', { class: 'times-key' }, el('span', { class: 'times-key-bar' }, 'cut'), el('span', { class: 'times-key-read' }, 'read'), el('span', { class: 'times-key-starved' }, 'cut faster than read')),
      button('small', 'Close', close),
    ),
    el('div', { class: 'times-picture' }, canvas, readout),
    el('div', { class: 'times-more' }, words, named, button('small link', 'Reader and buffer', () => openFormat('itemized.readerSpeed'), { title: 'Opens the format at the reader' })),
  );
  byId('span-caption', HTMLElement).closest('table')?.before(host);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  /** @type {BlockTimes | null} */
  let times = null;
  /** The block under the pointer. */
  let pointed = -1;
  const redraw = onceAFrame(draw);

  async function refresh() {
    if (host.hidden) return;
    const found = await engine.ask('times');
    if (found === undefined) return;
    times = found.times;
    pointed = -1;
    words.textContent = found.sentences.join(' ');
    const ranked = rank(times);
    const blocks = await Promise.all(ranked.map((index) => engine.ask('block', index)));
    const links = blocks.flatMap((block) => (block ? [button('small link', blockName(block), () => show(placeOf(block)))] : []));
    const anyStarves = ranked.length > 0 && times.starved[ranked[0]] === 1;
    named.replaceChildren(...(links.length > 0 ? [anyStarves ? 'These wait most: ' : 'These take longest: ', ...links] : []));
    redraw();
  }

  function draw() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width === 0 || times === null) return;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    drawTimes(context, times, { colours: palette(store.state.theme), kindOf, ratio, current: store.state.here?.block?.index ?? -1, pointed });
    tellPointed();
  }

  /** @param {number} block */
  function kindOf(block) {
    const { track } = store.state;
    if (track === null || block >= track.blocks || !track.moves(block)) return '';
    return kinds[track.course.spanKinds[track.course.spanEnds[block] - 1] - 1] ?? '';
  }

  async function tellPointed() {
    const at = pointed;
    if (at < 0 || times === null) {
      readout.textContent = '';
      return;
    }
    const block = await engine.ask('block', at);
    if (at !== pointed || times === null || !block) return;
    const takes = times.executing[at];
    const cut = takes < 0 ? 'takes a time that is not known' : takes === 0 ? 'moves nothing' : `takes ${time(takes)}`;
    readout.textContent = `${blockName(block)} ${cut}, read in ${time(times.reading[at])}`;
  }

  /** @param {PointerEvent} event */
  function blockAt(event) {
    if (times === null || times.reading.length === 0) return -1;
    const block = Math.floor(event.offsetX / barWidth(times.reading.length, canvas.clientWidth));
    return block < times.reading.length ? block : -1;
  }
  canvas.addEventListener('pointermove', (event) => {
    pointed = blockAt(event);
    redraw();
  });
  canvas.addEventListener('pointerleave', () => {
    pointed = -1;
    redraw();
  });
  canvas.addEventListener('click', async (event) => {
    const block = await engine.ask('block', blockAt(/** @type {PointerEvent} */ (event)));
    if (block) show(placeOf(block));
  });

  function close() {
    host.hidden = true;
    closed();
  }

  /** @param {boolean} isOpen */
  function open(isOpen) {
    host.hidden = !isOpen;
    if (isOpen) void refresh();
    return isOpen;
  }

  store.on(['track'], () => void refresh());
  store.on(['theme', 'here'], redraw);
  new ResizeObserver(redraw).observe(canvas);

  return {
    /** @returns {boolean} it is open now */
    toggle: () => open(host.hidden !== false),
  };
}

/**
 * A block without its last character, the end of block: behind that begins the next one.
 * @param {{ from: number, to: number }} block
 */
const placeOf = ({ from, to }) => ({ from, to: Math.max(from, to - 1) });

/**
 * The blocks that wait most for the reader; where none does, those that take longest.
 * @param {BlockTimes} times
 */
function rank({ executing, reading, starved }) {
  /** @type {number[]} */
  const all = [];
  for (let index = 0; index < executing.length; index += 1) if (starved[index] === 1) all.push(index);
  const anyStarves = all.length > 0;
  if (!anyStarves) for (let index = 0; index < executing.length; index += 1) if (executing[index] > 0) all.push(index);
  const weight = (/** @type {number} */ index) => (anyStarves ? reading[index] - executing[index] : executing[index]);
  return all.sort((one, other) => weight(other) - weight(one)).slice(0, NAMED);
}

/**
 * @param {number} blocks
 * @param {number} width
 */
const barWidth = (blocks, width) => Math.min(WIDEST, Math.max(0, width - SCALE) / blocks);

/**
 * A bar for each block, or for each pixel the greatest of its blocks. Heights are logarithmic, because the blocks of one
 * tape differ by decades: a tenth of a second is seen beside a minute.
 * @param {CanvasRenderingContext2D} context
 * @param {BlockTimes} times
 * @param {{ colours: Record<string, string>, kindOf: (block: number) => string, ratio: number, current: number, pointed: number }} how
 */
function drawTimes(context, { executing, reading, starved }, { colours, kindOf, ratio, current, pointed }) {
  const { width, height } = context.canvas;
  context.clearRect(0, 0, width, height);
  const blocks = reading.length;
  if (blocks === 0) return;
  const [least, most] = range(executing, reading);
  const top = 16 * ratio;
  const scale = (/** @type {number} */ seconds) =>
    Math.max(LOWEST * ratio, (Math.log(seconds / least) / Math.log(most / least)) * (height - top));
  context.font = `${11 * ratio}px ${getComputedStyle(context.canvas).fontFamily}`;
  for (let decade = Math.ceil(Math.log10(least)); 10 ** decade <= most; decade += 1) {
    const y = Math.round(height - scale(10 ** decade));
    context.fillStyle = colours.grid;
    context.fillRect(0, y, width, Math.max(1, ratio));
    context.fillStyle = colours.muted;
    context.fillText(time(10 ** decade), width - 44 * ratio, y - 3 * ratio);
  }
  const step = barWidth(blocks, width / ratio) * ratio;
  const gap = step > 4 * ratio ? ratio : 0;
  const columns = Math.min(blocks, Math.floor(width - SCALE * ratio));
  for (let column = 0; column < columns; column += 1) {
    const from = step >= 1 ? column : Math.floor((column / columns) * blocks);
    const to = step >= 1 ? column + 1 : Math.max(from + 1, Math.floor(((column + 1) / columns) * blocks));
    let [block, read, isStarved] = [from, 0, false];
    for (let index = from; index < to; index += 1) {
      if (executing[index] > executing[block]) block = index;
      read = Math.max(read, reading[index]);
      isStarved ||= starved[index] === 1;
    }
    const x = step >= 1 ? column * step : column;
    const broad = Math.max(1, step - gap);
    if (from <= current && current < to) {
      context.fillStyle = colours.lit;
      context.fillRect(x, 0, broad, height);
    }
    const takes = executing[block];
    if (takes > 0) {
      const high = scale(takes);
      context.fillStyle = colours[kindOf(block)] ?? colours.muted;
      context.globalAlpha = pointed >= from && pointed < to ? 1 : 0.78;
      context.fillRect(x, height - high, broad, high);
      context.globalAlpha = 1;
    }
    if (read > 0) {
      context.fillStyle = isStarved ? colours.caution : colours.text;
      const line = (isStarved ? 3 : 1.5) * ratio;
      context.fillRect(x, Math.round(height - scale(read) - line / 2), broad, line);
    }
    if (isStarved) {
      // A sign of its own beside the colour.
      context.fillStyle = colours.caution;
      context.beginPath();
      context.moveTo(x + broad / 2, 10 * ratio);
      context.lineTo(x + broad / 2 - 4 * ratio, 2 * ratio);
      context.lineTo(x + broad / 2 + 4 * ratio, 2 * ratio);
      context.fill();
    }
  }
}

/**
 * From half the least time to the greatest.
 * @param {Float64Array} executing
 * @param {Float64Array} reading
 */
function range(executing, reading) {
  let [least, most] = [Infinity, 0];
  for (const list of [executing, reading]) {
    for (const seconds of list) {
      if (seconds <= 0) continue;
      least = Math.min(least, seconds);
      most = Math.max(most, seconds);
    }
  }
  return most === 0 ? [0.01, 1] : [least / 2, Math.max(most, least * 2)];
}
