// The whole tape as a line of time, in the colours of its spans; a hand can be laid on it.
import { byId, el, onceAFrame } from '../dom.js';
import { palette } from '../palette.js';
import { blockName } from '../plot/words.js';
import { time } from '../words.js';
import { clockTime } from './words.js';

/** @typedef {import('../store.js').Store} Store */

/** Half the width of the thumb, in CSS pixels: as far from the edges it goes. See replay.css. */
const INSET = 7;
const BAND = 8;
/** What lies ahead is as faint as the path ahead. */
const TO_COME = 0.38;

/**
 * @param {object} parts
 * @param {Store} parts.store
 * @param {string[]} parts.kinds
 * @param {import('./replay.js').Replay} parts.replay
 */
export function makeTimeline({ store, kinds, replay }) {
  const canvas = el('canvas', { 'aria-hidden': 'true' });
  const range = el('input', { type: 'range', id: 'replay-time', min: 0, max: 1, step: 'any', value: 0, 'aria-label': 'Time of the replay' });
  const clock = el('span', { class: 'replay-clock', id: 'replay-clock' });
  const host = byId('timeline', HTMLElement);
  host.append(el('div', { class: 'timeline-line' }, canvas, range), clock);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  // All of it in full colours, kept until the tape, the width or the theme changes.
  const bands = document.createElement('canvas');
  const bandsContext = /** @type {CanvasRenderingContext2D} */ (bands.getContext('2d'));
  let bandsAreTrue = false;
  let drawnAt = -1;

  const redraw = onceAFrame(draw);
  function redrawAll() {
    bandsAreTrue = false;
    redraw();
  }

  function measure() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width === 0 || height === 0) return;
    for (const surface of [canvas, bands]) Object.assign(surface, { width, height });
    redrawAll();
  }

  function draw() {
    const { track, moment, theme } = store.state;
    if (canvas.width === 0 || track === null) return;
    const ratio = canvas.width / canvas.clientWidth;
    const inset = INSET * ratio;
    const width = canvas.width - 2 * inset;
    const share = moment === null || track.seconds === 0 ? 0 : moment.seconds / track.seconds;
    const x = Math.round(inset + share * width);
    if (bandsAreTrue && x === drawnAt) return;
    if (!bandsAreTrue) drawBands(bandsContext, track, kinds, palette(theme), { inset, width, ratio });
    bandsAreTrue = true;
    drawnAt = x;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.globalAlpha = TO_COME;
    context.drawImage(bands, 0, 0);
    context.globalAlpha = 1;
    if (x > 0) context.drawImage(bands, 0, 0, x, bands.height, 0, 0, x, bands.height);
  }

  function tell() {
    const { track, moment, here } = store.state;
    range.disabled = track === null || track.blocks === 0;
    if (track === null) return;
    const { seconds } = track;
    const now = moment?.seconds ?? 0;
    range.max = String(seconds);
    if (!moment?.running || !range.matches(':active')) range.value = String(now);
    clock.textContent = `${clockTime(now, seconds)} / ${clockTime(seconds, seconds)}`;
    if (moment?.running) return;
    const name = blockName(here?.block ?? null);
    range.setAttribute('aria-valuetext', `${name === '' ? '' : `${name}, `}${time(now)} of ${time(seconds)}`);
  }

  range.addEventListener('input', () => replay.toTime(Number(range.value), true));
  range.addEventListener('change', () => replay.toTime(Number(range.value), false));
  range.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const deed = DEEDS[event.key];
    if (deed === undefined) return;
    event.preventDefault();
    deed(replay);
  });

  store.on(['track'], redrawAll);
  store.on(['theme'], redrawAll);
  store.on(['moment', 'track', 'here'], () => {
    tell();
    redraw();
  });
  new ResizeObserver(measure).observe(canvas);
  tell();
}

/** @type {Record<string, ((replay: import('./replay.js').Replay) => void) | undefined>} */
const DEEDS = {
  ArrowLeft: (replay) => replay.byBlock(-1),
  ArrowDown: (replay) => replay.byBlock(-1),
  ArrowRight: (replay) => replay.byBlock(1),
  ArrowUp: (replay) => replay.byBlock(1),
  PageUp: (replay) => replay.bySpan(-1),
  PageDown: (replay) => replay.bySpan(1),
  Home: (replay) => replay.toStart(),
  End: (replay) => replay.toEnd(),
};

/**
 * One pixel after another, so that a long tape takes no longer than a short one. Where blocks are wide enough, a fine
 * gap sets each off from the next.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./track.js').Track} track
 * @param {string[]} kinds
 * @param {Record<string, string>} colours
 * @param {{ inset: number, width: number, ratio: number }} place
 */
function drawBands(context, track, kinds, colours, { inset, width, ratio }) {
  const { canvas } = context;
  const middle = Math.round(canvas.height / 2);
  const high = Math.round((BAND * ratio) / 2) * 2;
  context.clearRect(0, 0, canvas.width, canvas.height);
  if (track.blocks === 0 || track.seconds === 0) return;
  const { spanKinds } = track.course;
  let before = -1;
  for (let x = 0; x < width; x += 1) {
    const at = track.atTime(((x + 0.5) / width) * track.seconds);
    const isFirst = at.block !== before;
    before = at.block;
    const wide = (track.course.seconds[at.block] / track.seconds) * width;
    if (isFirst && x > 0 && wide > 6 * ratio) continue;
    const kind = track.moves(at.block) ? kinds[spanKinds[track.toolAt(at).span] - 1] : '';
    const size = kind === '' ? Math.round(2 * ratio) : kind === 'rapid' ? Math.round(high / 2) : high;
    context.fillStyle = colours[kind] ?? colours.muted;
    context.fillRect(inset + x, middle - Math.floor(size / 2), 1, size);
  }
}
