// How the span under the cursor is built: centre, radii and sweep of an arc, tangents of a parabola.
import { coordinate, degrees } from '../words.js';

/** @typedef {import('nctape').Span} Span */
/** @typedef {import('./view.js').View} View */

/**
 * @typedef {object} Pen
 * @property {CanvasRenderingContext2D} context
 * @property {View} view
 * @property {Record<string, string>} colours
 * @property {string} font
 * @property {'mm' | 'inch'} unit
 */

/**
 * @param {Pen} pen
 * @param {Span} span
 */
export function drawConstruction(pen, span) {
  const { context, colours } = pen;
  context.save();
  context.strokeStyle = context.fillStyle = colours[span.kind] ?? colours.text;
  context.lineWidth = 1;
  context.font = `12px ${pen.font}`;
  if (span.centre !== undefined && span.sweep !== undefined) drawArc(pen, span, span.centre, span.sweep);
  if (span.tangent !== undefined) drawTangents(pen, span, span.tangent);
  if (span.control !== undefined) drawPolygon(pen, [span.start, ...span.control, span.end]);
  context.restore();
}

/**
 * @param {Pen} pen
 * @param {Span} span
 * @param {number[]} centre
 * @param {number} sweep
 */
function drawArc(pen, span, centre, sweep) {
  const { context, view, unit } = pen;
  const middle = view.toScreen(centre);
  const start = view.toScreen(span.start);
  const end = view.toScreen(span.end);
  line(context, [4, 3], start, middle, end);
  cross(context, middle);

  const inPlane = span.plane === view.plane;
  const radius = Math.hypot(start[0] - middle[0], start[1] - middle[1]);
  if (!inPlane || radius < 30) return;
  // On the screen y goes down, so a counter-clockwise sweep is a falling angle.
  const from = Math.atan2(start[1] - middle[1], start[0] - middle[0]);
  const small = Math.min(28, radius * 0.4);
  context.setLineDash([]);
  context.beginPath();
  context.arc(middle[0], middle[1], small, from, from - sweep, sweep > 0);
  context.stroke();
  const half = from - sweep / 2;
  caption(pen, degrees(Math.abs(sweep)), middle[0] + (small + 8) * Math.cos(half), middle[1] + (small + 8) * Math.sin(half), Math.cos(half));
  const length = Math.hypot(...span.start.map((value, axis) => value - (centre[axis] ?? value)));
  if (radius > 70) {
    // Beside the first radius, on the side that the sweep leaves free.
    const side = sweep > 0 ? from + Math.PI / 2 : from - Math.PI / 2;
    const x = start[0] * 0.55 + middle[0] * 0.45 + 9 * Math.cos(side);
    const y = start[1] * 0.55 + middle[1] * 0.45 + 9 * Math.sin(side);
    caption(pen, `R ${coordinate(length, unit)}`, x, y, Math.cos(side));
  }
}

/**
 * @param {Pen} pen
 * @param {Span} span
 * @param {number[]} tangent
 */
function drawTangents(pen, span, tangent) {
  const { context, view } = pen;
  const corners = [span.start, tangent, span.end].map((point) => view.toScreen(point));
  line(context, [4, 3], ...corners);
  cross(context, corners[1]);
  const [start, top, end] = corners;
  const up = top[1] <= (start[1] + end[1]) / 2 ? -1 : 1;
  caption(pen, 'P0', start[0] - 6, start[1] - up * 14, -1);
  caption(pen, 'PT', top[0], top[1] + up * 14, 0);
  caption(pen, 'P2', end[0] + 6, end[1] - up * 14, 1);
}

/**
 * @param {Pen} pen
 * @param {number[][]} points
 */
function drawPolygon({ context, view }, points) {
  const corners = points.map((point) => view.toScreen(point));
  line(context, [4, 3], ...corners);
  corners.slice(1, -1).forEach((corner) => cross(context, corner));
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number[]} dash
 * @param {...[number, number]} corners
 */
function line(context, dash, ...corners) {
  context.setLineDash(dash);
  context.beginPath();
  corners.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  context.stroke();
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {[number, number]} at
 */
function cross(context, [x, y]) {
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(x - 5, y);
  context.lineTo(x + 5, y);
  context.moveTo(x, y - 5);
  context.lineTo(x, y + 5);
  context.stroke();
}

/**
 * Words with a rim of the sheet's colour, so that lines do not cross them.
 * @param {Pen} pen
 * @param {string} text
 * @param {number} x
 * @param {number} y
 * @param {number} side  where the words lie: right of the place if positive, left if negative
 */
function caption({ context, colours }, text, x, y, side) {
  context.textAlign = Math.abs(side) < 0.3 ? 'center' : side > 0 ? 'left' : 'right';
  context.textBaseline = 'middle';
  const { strokeStyle, lineWidth } = context;
  context.setLineDash([]);
  context.lineJoin = 'round';
  context.strokeStyle = colours.sheet;
  context.lineWidth = 5;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
  context.strokeStyle = strokeStyle;
  context.lineWidth = lineWidth;
}
