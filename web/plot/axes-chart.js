// The axes beyond X, Y and Z against the length of the path: a line for each.
import { el, onceAFrame } from '../dom.js';
import { mono, palette } from '../palette.js';

/** @typedef {import('../store.js').Store} Store */
/** @typedef {import('nctape').OtherAxes} OtherAxes */

/** The colours of the lines, in turn. */
const COLOURS = ['arc', 'parabola', 'line', 'curve'];
/** Beside the lines stands the name of each with its range. */
const NAMES = 118;

/**
 * @param {object} parts
 * @param {HTMLElement} parts.host
 * @param {Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 */
export function makeAxesChart({ host, store, engine }) {
  const canvas = el('canvas', { role: 'img' });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  host.replaceChildren(canvas);
  /** @type {OtherAxes | null} */
  let axes = null;
  /** Least and greatest value of each axis. @type {[number, number][]} */
  let ranges = [];

  async function follow() {
    const { summary } = store.state;
    if (summary === null || summary.axes.length <= 3) {
      host.hidden = true;
      return;
    }
    const answer = await engine.ask('axes');
    if (answer === undefined) return;
    axes = answer;
    ranges = answer === null ? [] : rangesOf(answer);
    host.hidden = ranges.every(([least, greatest]) => least === greatest);
    canvas.setAttribute('aria-label', `Other axes against the length of the path: ${names().join(', ')}`);
    redraw();
  }

  /** "B 0 to 180°" */
  function names() {
    const { summary } = store.state;
    if (axes === null || summary === null) return [];
    const { rotary, angles } = axes;
    return axes.names.map((name, axis) => {
      const unit = rotary[axis] ? (angles === 'turns' ? ' turn' : '°') : summary.unit === 'mm' ? ' mm' : ' in';
      const [least, greatest] = ranges[axis].map(short);
      return `${name} ${least === greatest ? least : `${least} to ${greatest}`}${unit}`;
    });
  }

  const redraw = onceAFrame(() => {
    if (axes === null || host.hidden) return;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [host.clientWidth, host.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const colours = palette(store.state.theme);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colours.sheet;
    context.fillRect(0, 0, width, height);
    drawAll(context, axes, ranges, names(), { width, height }, colours);
    drawPlace(width, height, axes, colours.accent);
  });

  /**
   * Where the tool stands now.
   * @param {number} width
   * @param {number} height
   * @param {OtherAxes} shown
   * @param {string} colour
   */
  function drawPlace(width, height, shown, colour) {
    const { moment, here } = store.state;
    const span = moment !== null && moment.span >= 0 ? moment.span : (here?.block?.span ?? -1);
    const along = moment !== null && moment.span >= 0 ? moment.along : 1;
    const place = placesOf(shown, width);
    if (span < 0 || 2 * span >= shown.lengths.length) return;
    const [start, end] = place(span);
    const x = start + along * (end - start);
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x, 4);
    context.lineTo(x, height - 4);
    context.stroke();
  }

  new ResizeObserver(redraw).observe(host);
  store.on(['summary'], () => void follow());
  store.on(['here', 'moment', 'theme'], redraw);
  void follow();
}

/** @param {number} value */
const short = (value) => String(Math.round(value * 1e4) / 1e4);

/**
 * @param {OtherAxes} axes
 * @returns {[number, number][]}
 */
function rangesOf({ names, values }) {
  const count = names.length;
  return names.map((_, axis) => {
    let [least, greatest] = [Infinity, -Infinity];
    for (let i = 2 * axis; i < values.length; i += 2 * count) {
      least = Math.min(least, values[i], values[i + 1]);
      greatest = Math.max(greatest, values[i], values[i + 1]);
    }
    return least > greatest ? [0, 0] : [least, greatest];
  });
}

/**
 * Where a span begins and ends across. A path without any length goes by the count of its spans.
 * @param {OtherAxes} axes
 * @param {number} width
 * @returns {(span: number) => [number, number]}
 */
function placesOf({ lengths }, width) {
  const total = lengths.at(-1) ?? 0;
  const room = Math.max(1, width - NAMES - 12);
  if (total === 0) {
    const count = Math.max(1, lengths.length / 2);
    return (span) => [NAMES + (room * span) / count, NAMES + (room * (span + 1)) / count];
  }
  return (span) => [NAMES + (room * lengths[2 * span]) / total, NAMES + (room * lengths[2 * span + 1]) / total];
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {OtherAxes} axes
 * @param {[number, number][]} ranges
 * @param {string[]} words
 * @param {{ width: number, height: number }} size
 * @param {Record<string, string>} colours
 */
function drawAll(context, axes, ranges, words, { width, height }, colours) {
  const count = axes.names.length;
  const place = placesOf(axes, width);
  const band = (height - 6) / count;
  context.font = `12px ${mono()}`;
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  axes.names.forEach((_, axis) => {
    const [top, bottom] = [3 + axis * band + 4, 3 + (axis + 1) * band - 4];
    const [least, greatest] = ranges[axis];
    const up = (/** @type {number} */ value) =>
      greatest === least ? (top + bottom) / 2 : bottom - ((value - least) / (greatest - least)) * (bottom - top);
    context.strokeStyle = colours.grid;
    context.lineWidth = 1;
    context.strokeRect(NAMES + 0.5, Math.round(top) + 0.5, width - NAMES - 12, Math.round(bottom - top));
    context.strokeStyle = colours[COLOURS[axis % COLOURS.length]];
    context.lineWidth = 1.75;
    context.beginPath();
    for (let span = 0; 2 * span < axes.lengths.length; span += 1) {
      const [start, end] = place(span);
      const at = 2 * (span * count + axis);
      if (span === 0) context.moveTo(start, up(axes.values[at]));
      else context.lineTo(start, up(axes.values[at]));
      context.lineTo(end, up(axes.values[at + 1]));
    }
    context.stroke();
    context.fillStyle = colours.text;
    context.fillText(words[axis], 10, (top + bottom) / 2, NAMES - 16);
  });
}
