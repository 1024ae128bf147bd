// The path of the tool, in one plane.
import { pieceWord } from '../cldata/kind.js';
import { button, byId, el, onceAFrame } from '../dom.js';
import { mono, palette } from '../palette.js';
import { firstAtOrAfter } from '../sorted.js';
import { drawBehind, drawTool, TO_COME, Travelled } from '../replay/tool.js';
import { timed } from '../timing.js';
import { drawConstruction } from './construction.js';
import { drawLit } from './draw.js';
import { drawGrid } from './grid.js';
import { spanAt } from './hit.js';
import { listenToPlotHand } from './input.js';
import { CutterPath } from './cutter.js';
import { KeptPicture } from './kept.js';
import { patched } from './patch.js';
import { AXES, isAnotherSize, isSeen, PLANES, View } from './view.js';
import { sentence } from '../words.js';
import { blockName, placeLine, spanCaption, spanLine, spanRows } from './words.js';

/** @typedef {import('../store.js').Store} Store */
/** @typedef {import('../engine.js').Engine} Engine */
/** @typedef {import('nctape').Path} Path */

/** How far a chord may be from its curve, in pixels. */
const TOLERANCE = 0.2;

/**
 * @param {object} parts
 * @param {Store} parts.store
 * @param {Engine} parts.engine
 * @param {string[]} parts.kinds
 * @param {(offset: number) => void} parts.onBlock  a span was pressed: its block begins here
 */
export function makePlot({ store, engine, kinds, onBlock }) {
  const canvas = byId('plot-canvas', HTMLCanvasElement);
  const host = byId('plot', HTMLElement);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));

  const view = new View();
  const kept = new KeptPicture(view);
  /** @type {Path | null} */
  let path = null;
  /** The tolerance of `path`, in lengths. */
  let tolerance = Infinity;
  /** By which its change is asked for. */
  let pathNumber = 0;
  const travelled = new Travelled();
  let fitted = false;
  /** The picture was moved by hand: it stays as it was put until the tape is another one. */
  let held = false;
  /** The tape has changed and its path is not here yet: the picture stays until it is. */
  let stale = false;
  /** The format was changed since the last path, which may make all lengths others. */
  let reformatted = false;
  /** @type {import('./view.js').Bounds} */
  let bounds = null;
  let ratio = 1;

  /** @param {number} span */
  const kindOf = (span) => kinds[(path?.kinds[span] ?? 0) - 1] ?? '';

  const cutter = new CutterPath(engine, () => {
    showLegend();
    redraw();
  });

  const redraw = onceAFrame(draw);
  function redrawAll() {
    kept.drop();
    redraw();
  }

  function measure() {
    ratio = window.devicePixelRatio || 1;
    const width = host.clientWidth;
    const height = host.clientHeight;
    if (width === 0 || height === 0) return;
    // A frame is given its size late: what was fitted into much less room, or more, is fitted anew.
    const another = Math.abs(Math.log2(width / view.width)) > 1 || Math.abs(Math.log2(height / view.height)) > 1;
    if (another && !held) fitted = false;
    view.width = width;
    view.height = height;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    kept.measure(ratio);
    if (!fitted) fit();
    redrawAll();
  }

  function fit() {
    const { summary } = store.state;
    if (summary === null) return;
    view.fit(summary.bounds);
    fitted = true;
    held = false;
    redrawAll();
    void refine();
  }

  /** Asks for the path once more where the view has come so near that its chords would be seen. */
  async function refine() {
    const needed = TOLERANCE / view.scale;
    if (needed >= tolerance / 2 && tolerance !== Infinity) return;
    await fetchPath();
  }

  /** @param {number} scale @returns {[tolerance: number, since: number]} */
  function pathWanted(scale) {
    const asked = TOLERANCE / scale / 2;
    return [asked, asked === tolerance ? pathNumber : 0];
  }
  engine.foresee(() => (fitted ? [['pathChange', ...pathWanted(view.scale)]] : []));

  async function fetchPath(scale = view.scale) {
    const [asked, since] = pathWanted(scale);
    const change = await engine.ask('pathChange', asked, since);
    if (change === undefined) return false;
    take(change);
    tolerance = asked;
    pathNumber = change.number;
    store.set({ path });
    showLegend();
    void cutter.follow(asked, store.state.summary?.compensated === true);
    redraw();
    return true;
  }

  /**
   * Takes a change of the path over, and notes what part of the picture it touches.
   * @param {import('nctape').PathChange} change
   */
  function take(change) {
    const { first, last, span } = change;
    if (path === null || (first === 0 && last === 0)) {
      path = patched(path, change);
      kept.drop();
      return;
    }
    const from = firstAtOrAfter(path.span, first);
    kept.touch(path.xyz, from, firstAtOrAfter(path.span, path.kinds.length - last));
    path = patched(path, change);
    kept.touch(path.xyz, from, from + span.length);
  }

  /** Shows the path of a changed tape, in the same moment fitted anew where that is due. */
  async function follow() {
    stale = true;
    const { summary } = store.state;
    const anew = fitted ? null : view.fitting(summary?.bounds ?? null);
    if (await fetchPath(anew?.scale)) {
      bounds = summary?.bounds ?? null;
      if (anew !== null && view.width > 1) {
        Object.assign(view, anew);
        fitted = true;
        kept.drop();
      }
    }
    stale = false;
    redraw();
  }

  function draw() {
    const { summary } = store.state;
    if (summary !== null && !stale && canvas.width > 0) timed('nctape.plot', () => drawAll(summary));
  }

  /** @param {import('nctape').Summary} summary */
  function drawAll(summary) {
    const { here, pointed, theme, moment, held } = store.state;
    const colours = palette(theme);
    const font = mono();
    kept.draw(path, kindOf, colours);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colours.sheet;
    context.fillRect(0, 0, view.width, view.height);
    drawGrid(context, view, colours, { axes: summary.axes, unit: summary.unit === 'mm' ? 'mm' : 'in', font });
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.globalAlpha = moment?.led ? TO_COME : 1;
    context.drawImage(kept.canvas, 0, 0);
    context.globalAlpha = 1;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    cutter.draw(context, view, colours);
    if (path === null) return;
    const tool = moment !== null && moment.span >= 0 && moment.span < path.kinds.length ? moment : null;
    if (tool?.led) {
      const behind = tool.span + (tool.along === 1 ? 1 : 0);
      travelled.draw({ view, ratio, path, kindOf, colours, theme, dense: kept.dense }, behind);
      context.setTransform(1, 0, 0, 1, 0, 0);
      if (behind > 0) context.drawImage(travelled.canvas, 0, 0);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
    }
    // What only explains a piece of the path stays away while the tool runs by.
    if (here?.span && !tool?.running) {
      drawConstruction({ context, view, colours, font, unit: summary.unit }, here.span);
    }
    if (tool?.led) {
      drawBehind(context, view, path, tool, kindOf(tool.span), colours);
    } else if (here?.span) {
      drawLit(context, view, path, /** @type {number} */ (here.block?.span), here.span.kind, colours, 11);
    }
    if (pointed !== null && pointed < path.kinds.length && pointed !== here?.block?.span) {
      drawLit(context, view, path, pointed, kindOf(pointed), colours, 7);
    }
    if (tool !== null) drawTool(context, view, path, tool, held, colours);
  }

  const legend = byId('legend', HTMLElement);
  function showLegend() {
    const used = new Set(path?.kinds ?? []);
    legend.replaceChildren(
      ...kinds.filter((_, index) => used.has(index + 1)).map((kind) => el('li', { class: `key kind-${kind}` }, kind)),
      ...cutter.legend(),
    );
  }

  const readout = byId('readout', HTMLElement);
  /** Where the pointer is, in lengths. @type {[number, number] | null} */
  let pointer = null;
  const caption = byId('span-caption', HTMLElement);
  const rows = byId('span-rows', HTMLElement);
  function tellHere() {
    const { here, summary } = store.state;
    if (summary === null) return;
    if (here?.span) {
      caption.textContent = spanCaption(here.span, here.block);
      rows.replaceChildren(...spanRows(here.span, summary));
    } else {
      caption.textContent = here?.block ? `${sentence(blockName(here.block))} moves nothing` : `No ${pieceWord(store.state)} under the cursor`;
      rows.replaceChildren();
    }
  }
  async function tellPointed() {
    const { pointed, summary } = store.state;
    if (pointed === null || summary === null) {
      readout.textContent = summary === null || pointer === null ? '' : placeLine(pointer, view.plane, summary);
      return;
    }
    const found = await engine.ask('span', pointed);
    if (!found || store.state.pointed !== pointed) return;
    readout.textContent = spanLine(found.span, found.block, summary);
  }

  /**
   * @param {number} factor
   * @param {number} [x]
   * @param {number} [y]
   */
  function zoom(factor, x, y) {
    held = true;
    view.zoomBy(factor, x, y);
    redrawAll();
    void refine();
  }

  let rest = [0, 0];
  listenToPlotHand(canvas, {
    pan(x, y) {
      held = true;
      // What is less than a pixel of the screen goes with the next movement.
      const [right, down] = kept.panBy(x + rest[0], y + rest[1]);
      rest = [x + rest[0] - right, y + rest[1] - down];
      redraw();
    },
    zoom,
    fit,
    point(x, y) {
      pointer = view.toWorld(x, y);
      if (store.state.pointed === null) void tellPointed();
      store.set({ pointed: path === null ? null : spanAt(view, path, x, y) });
    },
    away() {
      pointer = null;
      store.set({ pointed: null });
      void tellPointed();
    },
    press: (x, y) => goToSpan(path === null ? null : spanAt(view, path, x, y)),
    goToSpan(direction) {
      const at = store.state.here?.block?.span ?? (direction > 0 ? -1 : 0);
      goToSpan(at + direction);
    },
  });

  /** @param {number | null} index */
  async function goToSpan(index) {
    if (index === null || path === null || index < 0 || index >= path.kinds.length) return;
    const offset = await engine.ask('spanPlace', index);
    if (offset !== undefined && offset !== null) onBlock(offset);
  }

  byId('zoom-in', HTMLElement).addEventListener('click', () => zoom(1.25));
  byId('zoom-out', HTMLElement).addEventListener('click', () => zoom(0.8));
  byId('zoom-fit', HTMLElement).addEventListener('click', fit);

  const planes = byId('planes', HTMLElement);
  const choices = PLANES.map((plane) =>
    button('segment', '', () => choosePlane(plane), { role: 'radio', 'data-plane': plane }),
  );
  planes.append(...choices);
  planes.addEventListener('keydown', (event) => {
    const way = ['ArrowRight', 'ArrowDown'].includes(event.key) ? 1 : ['ArrowLeft', 'ArrowUp'].includes(event.key) ? -1 : 0;
    if (way === 0) return;
    event.preventDefault();
    const next = (PLANES.indexOf(view.plane) + way + PLANES.length) % PLANES.length;
    choosePlane(PLANES[next]);
    choices[next].focus();
  });
  /** @param {import('nctape').Plane} plane */
  function choosePlane(plane) {
    view.plane = plane;
    namePlanes();
    fit();
  }
  function namePlanes() {
    const axes = store.state.summary?.axes ?? ['X', 'Y', 'Z'];
    choices.forEach((choice, index) => {
      const chosen = PLANES[index] === view.plane;
      choice.textContent = AXES[PLANES[index]].map((axis) => axes[axis]).join('');
      choice.setAttribute('aria-checked', String(chosen));
      choice.tabIndex = chosen ? 0 : -1;
    });
  }

  store.on(['format'], () => {
    reformatted = true;
  });
  store.on(['summary'], ({ whole, summary }) => {
    const next = summary?.bounds ?? null;
    if (whole || (reformatted && isAnotherSize(bounds, next))) {
      fitted = false;
      held = false;
    }
    // A path that grows out of the picture, as while a tape is typed from nothing.
    if (!held && !isSeen(view, next)) fitted = false;
    reformatted = false;
    namePlanes();
    tellHere();
    void follow();
  });
  store.on(['here'], () => {
    tellHere();
    redraw();
  });
  store.on(['pointed'], () => {
    void tellPointed();
    redraw();
  });
  store.on(['moment', 'held'], redraw);
  store.on(['theme'], redrawAll);
  namePlanes();
  new ResizeObserver(measure).observe(host);
}
