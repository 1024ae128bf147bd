// The whole path in the colours of its kinds, thinned to what a pixel can show.
import { firstAtOrAfter } from '../sorted.js';
import { CHUNK, chunksOf } from './chunks.js';
import { REACH } from './dirty.js';
import { Pen } from './pen.js';
import { AXES } from './view.js';

/** @typedef {import('nctape').Path} Path */
/** @typedef {import('./view.js').View} View */

/**
 * Beyond so many points in the picture lines are one pixel wide and the ends of spans have no dots: each would cost five
 * times as much (see pen.js), where no eye tells them apart.
 */
const MOST_WIDE = 800;

/**
 * So many points are in the picture that it is drawn finely.
 * @param {View} view
 * @param {Path} path
 */
export function isDense(view, path) {
  let seen = 0;
  for (const [from, to] of runsIn(view, path, 0, path.span.length, view.box())) seen += to - from;
  return seen > MOST_WIDE;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {(span: number) => string} kindOf
 * @param {Record<string, string>} colours
 * @param {object} [part]
 * @param {boolean} [part.dense]  finely, see `isDense`
 * @param {[number, number]} [part.points]  only these, the first one of a span and behind the last one of another
 * @param {import("./view.js").Box} [part.box]  only what lies in this part of the picture
 */
export function drawPath(context, view, path, kindOf, colours, { dense = false, points, box = view.box() } = {}) {
  const [from, to] = points ?? [0, path.span.length];
  const { xyz, span, kinds, substitutes } = path;
  const [across, up] = AXES[view.plane];
  const { scale } = view;
  const [left, top] = view.at(0, 0);
  context.lineJoin = 'bevel';
  context.lineCap = 'butt';
  const pen = new Pen(context, box);
  let style = -1;
  let dashed = false;
  for (const [first, end] of runsIn(view, path, from, to, box)) {
    style = -1;
    for (let i = first; i < end; i += 1) {
      const x = left + xyz[3 * i + across] * scale;
      const y = top - xyz[3 * i + up] * scale;
      const index = span[i];
      if (i > first && index === span[i - 1]) {
        pen.lineTo(x, y);
        continue;
      }
      const next = 2 * kinds[index] + substitutes[index];
      if (next !== style) {
        pen.end();
        const kind = kindOf(index);
        strokeStyle(context, kind, substitutes[index] === 1, colours);
        dashed = kind === 'rapid' || substitutes[index] === 1;
        if (dense) context.lineWidth = 1;
        style = next;
        pen.moveTo(x, y);
      } else if (!dashed && i > first && isSamePoint(xyz, i)) {
        pen.lineTo(x, y);
      } else {
        // Dashes begin anew with each span, so that they lie alike in whatever part of the picture is drawn.
        pen.moveTo(x, y);
      }
    }
  }
  pen.end();
  context.setLineDash([]);
  if (!dense) drawEnds(context, view, path, colours, from, to, box);
}

/**
 * The points that may show in a part of the picture, in runs.
 * @param {View} view
 * @param {Path} path
 * @param {number} from
 * @param {number} to
 * @param {import("./view.js").Box} box
 */
function* runsIn(view, path, from, to, box) {
  const chunks = chunksOf(path);
  const axes = AXES[view.plane];
  const [left, top] = view.toWorld(box.left - REACH, box.top - REACH);
  const [right, bottom] = view.toWorld(box.right + REACH, box.bottom + REACH);
  let first = from;
  for (let chunk = Math.floor(from / CHUNK); chunk * CHUNK < to; chunk += 1) {
    if (!chunks.isOff(chunk, axes, [left, right, bottom, top])) continue;
    // Up to the point before the run, whose way to it is the run's own.
    const end = Math.max(from, chunk * CHUNK);
    if (first < end) yield [first, end];
    first = Math.max(first, Math.min(to, (chunk + 1) * CHUNK));
  }
  if (first < to) yield [first, to];
}

/**
 * A span mostly begins where the one before it ends.
 * @param {Float64Array} xyz
 * @param {number} i
 */
const isSamePoint = (xyz, i) =>
  xyz[3 * i] === xyz[3 * i - 3] && xyz[3 * i + 1] === xyz[3 * i - 2] && xyz[3 * i + 2] === xyz[3 * i - 1];

/**
 * A dot where each span ends.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {Record<string, string>} colours
 * @param {number} from
 * @param {number} to
 * @param {import("./view.js").Box} box
 */
function drawEnds(context, view, { xyz, span }, colours, from, to, box) {
  const [across, up] = AXES[view.plane];
  context.fillStyle = colours.text;
  context.beginPath();
  for (let i = from; i < to; i += 1) {
    if (i + 1 < to && span[i + 1] === span[i]) continue;
    const [x, y] = view.at(xyz[3 * i + across], xyz[3 * i + up]);
    if (x < box.left - REACH || x > box.right + REACH || y < box.top - REACH || y > box.bottom + REACH) continue;
    context.moveTo(x + 2, y);
    context.arc(x, y, 2, 0, 2 * Math.PI);
  }
  context.fill();
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
 * @param {number[]} points
 */
function lineThrough(points) {
  const stroke = new Path2D();
  for (let i = 0; i < points.length; i += 2) stroke.lineTo(points[i], points[i + 1]);
  return stroke;
}

/**
 * The first and the last point of a span in the list, found by halving: spans are in order.
 * @param {Path} path
 * @param {number} index
 */
export function pointsOf({ span }, index) {
  const low = firstAtOrAfter(span, index);
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
  const stroke = lineThrough(points);
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
