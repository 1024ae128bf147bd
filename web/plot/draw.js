// The whole path in the colours of its kinds, thinned to what a pixel can show.
import { AXES } from './view.js';

/** @typedef {import('nctape').Path} Path */
/** @typedef {import('./view.js').View} View */

/** Beyond so many spans the marks at their ends are left out. */
const MOST_MARKS = 2500;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {(span: number) => string} kindOf
 * @param {Record<string, string>} colours
 */
export function drawPath(context, view, path, kindOf, colours) {
  /** @type {Map<string, Path2D>} */
  const strokes = new Map();
  const ends = new Path2D();
  const withEnds = path.kinds.length <= MOST_MARKS;
  forEachRun(view, path, (span, points) => {
    const key = `${kindOf(span)} ${path.substitutes[span]}`;
    const stroke = strokes.get(key) ?? new Path2D();
    strokes.set(key, stroke);
    addThinned(stroke, points);
    if (withEnds) {
      const [x, y] = points.slice(-2);
      ends.moveTo(x + 2, y);
      ends.arc(x, y, 2, 0, 2 * Math.PI);
    }
  });
  context.lineJoin = 'round';
  context.lineCap = 'butt';
  for (const [key, stroke] of strokes) {
    const [kind, substitute] = key.split(' ');
    strokeStyle(context, kind, substitute === '1', colours);
    context.stroke(stroke);
  }
  context.setLineDash([]);
  context.fillStyle = colours.text;
  context.fill(ends);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {string} kind
 * @param {boolean} substitute
 * @param {Record<string, string>} colours
 */
export function strokeStyle(context, kind, substitute, colours) {
  context.strokeStyle = colours[kind] ?? colours.text;
  context.lineWidth = kind === 'rapid' ? 1.5 : 2;
  context.setLineDash(substitute ? [1.5, 4] : kind === 'rapid' ? [7, 5] : []);
}

/**
 * Calls for each span with its points on the screen, x and y in turn.
 * @param {View} view
 * @param {Path} path
 * @param {(span: number, points: number[]) => void} run
 */
function forEachRun(view, { xyz, span }, run) {
  for (let i = 0; i < span.length; ) {
    const from = i;
    while (i < span.length && span[i] === span[from]) i += 1;
    run(span[from], projected(view, xyz, from, i));
  }
}

/**
 * @param {View} view
 * @param {Float64Array} xyz
 * @param {number} from  first point
 * @param {number} to  behind the last point
 */
function projected(view, xyz, from, to) {
  const [across, up] = AXES[view.plane];
  const points = [];
  for (let i = from; i < to; i += 1) points.push(...view.at(xyz[3 * i + across], xyz[3 * i + up]));
  return points;
}

/**
 * @param {Path2D} stroke
 * @param {number[]} points
 */
function addThinned(stroke, points) {
  let [lastX, lastY] = points;
  stroke.moveTo(lastX, lastY);
  for (let i = 2; i < points.length; i += 2) {
    const x = points[i];
    const y = points[i + 1];
    if (i < points.length - 2 && Math.abs(x - lastX) + Math.abs(y - lastY) < 0.7) continue;
    stroke.lineTo(x, y);
    lastX = x;
    lastY = y;
  }
}

/**
 * The first and the last point of a span in the list, found by halving: spans are in order.
 * @param {Path} path
 * @param {number} index
 */
export function pointsOf({ span }, index) {
  let low = 0;
  let high = span.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (span[middle] < index) low = middle + 1;
    else high = middle;
  }
  let end = low;
  while (end < span.length && span[end] === index) end += 1;
  return [low, end];
}

/**
 * One span over the rest, with its direction.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {number} index
 * @param {string} kind
 * @param {Record<string, string>} colours
 * @param {number} halo  width of its glow
 */
export function drawLit(context, view, path, index, kind, colours, halo) {
  const [from, to] = pointsOf(path, index);
  if (to - from < 2) return;
  const points = projected(view, path.xyz, from, to);
  const stroke = new Path2D();
  addThinned(stroke, points);
  context.lineJoin = context.lineCap = 'round';
  context.setLineDash([]);
  context.strokeStyle = colours.halo;
  context.lineWidth = halo;
  context.stroke(stroke);
  strokeStyle(context, kind, path.substitutes[index] === 1, colours);
  context.lineWidth += 1;
  context.lineCap = 'butt';
  context.stroke(stroke);
  context.setLineDash([]);
  drawArrow(context, points, colours[kind] ?? colours.text);
}

/**
 * An arrow head at the end, unless the span is shorter than it.
 * @param {CanvasRenderingContext2D} context
 * @param {number[]} points
 * @param {string} colour
 */
function drawArrow(context, points, colour) {
  const [endX, endY] = points.slice(-2);
  for (let i = points.length - 4; i >= 0; i -= 2) {
    const x = endX - points[i];
    const y = endY - points[i + 1];
    const way = Math.hypot(x, y);
    if (way < 12) continue;
    const [unitX, unitY] = [x / way, y / way];
    context.fillStyle = colour;
    context.beginPath();
    context.moveTo(endX, endY);
    context.lineTo(endX - 12 * unitX - 5 * unitY, endY - 12 * unitY + 5 * unitX);
    context.lineTo(endX - 12 * unitX + 5 * unitY, endY - 12 * unitY - 5 * unitX);
    context.closePath();
    context.fill();
    return;
  }
}

/**
 * Where the tool stands before the first block.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {ArrayLike<number>} start
 * @param {Record<string, string>} colours
 */
export function drawStart(context, view, start, colours) {
  const [x, y] = view.toScreen(start);
  context.strokeStyle = colours.text;
  context.lineWidth = 1.5;
  context.setLineDash([]);
  context.beginPath();
  context.arc(x, y, 6, 0, 2 * Math.PI);
  context.moveTo(x - 10, y);
  context.lineTo(x + 10, y);
  context.moveTo(x, y - 10);
  context.lineTo(x, y + 10);
  context.stroke();
}
