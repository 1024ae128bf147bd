// The tool in the picture, and the path behind it.
import { drawPath, pointsOf, strokeStyle } from '../plot/draw.js';
import { wayAlong } from './way.js';

/** @typedef {import('nctape').Path} Path */
/** @typedef {import('../plot/view.js').View} View */
/** @typedef {import('./replay.js').Moment} Moment */

/** How much of its colour the path has where the tool has not been. */
export const TO_COME = 0.3;

/** The spans that the tool has left behind, drawn once each while the view stays as it is. */
export class Travelled {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    this.key = '';
    /** @type {Path | null} */
    this.path = null;
    /** Spans that are drawn. */
    this.count = 0;
  }

  /**
   * @param {object} picture
   * @param {View} picture.view
   * @param {number} picture.ratio
   * @param {Path} picture.path
   * @param {(span: number) => string} picture.kindOf
   * @param {Record<string, string>} picture.colours
   * @param {string} picture.theme
   * @param {boolean} picture.dense
   * @param {number} count  of the spans behind the tool
   */
  draw({ view, ratio, path, kindOf, colours, theme, dense }, count) {
    const { canvas, context } = this;
    const key = [view.plane, view.scale, ...view.middle, view.width, view.height, ratio, theme, dense].join(' ');
    if (key !== this.key || path !== this.path || count < this.count) {
      canvas.width = Math.round(view.width * ratio);
      canvas.height = Math.round(view.height * ratio);
      this.key = key;
      this.path = path;
      this.count = 0;
    }
    if (count === this.count) return;
    const from = pointsOf(path, this.count)[0];
    const to = count >= path.kinds.length ? path.span.length : pointsOf(path, count)[0];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawPath(context, view, path, kindOf, colours, { dense, points: [from, to] });
    this.count = count;
  }
}

/**
 * The part of its span that is behind the tool.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {Moment} moment
 * @param {string} kind
 * @param {Record<string, string>} colours
 */
export function drawBehind(context, view, path, { span, along }, kind, colours) {
  const way = along > 0 ? wayAlong(path, span, along) : null;
  if (way === null) return;
  const stroke = new Path2D();
  for (let i = way.from; i < way.to; i += 1) stroke.lineTo(...view.toScreen(path.xyz.subarray(3 * i, 3 * i + 3)));
  stroke.lineTo(...view.toScreen(way.place));
  context.lineJoin = context.lineCap = 'round';
  context.setLineDash([]);
  context.strokeStyle = colours.halo;
  context.lineWidth = 11;
  context.stroke(stroke);
  context.lineCap = 'butt';
  strokeStyle(context, kind, path.substitutes[span] === 1, colours);
  context.lineWidth += 1;
  context.stroke(stroke);
  context.setLineDash([]);
}

/**
 * The tool, seen along its axis: a ring with a point where it cuts, and an arrow on each side where it turns.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Path} path
 * @param {Moment} moment
 * @param {import('nctape').Registers | null} held
 * @param {Record<string, string>} colours
 */
export function drawTool(context, view, path, { span, along }, held, colours) {
  const way = wayAlong(path, span, along);
  if (way === null) return;
  const [x, y] = view.toScreen(way.place);
  const turns = held?.spindle?.turns ?? 'still';
  context.setLineDash([]);
  context.lineCap = 'round';
  context.beginPath();
  context.arc(x, y, 8, 0, 2 * Math.PI);
  context.fillStyle = colours.sheet;
  context.globalAlpha = 0.82;
  context.fill();
  context.globalAlpha = 1;
  // A fine edge of the sheet sets it off from the lines that it lies on.
  context.lineWidth = 5.5;
  context.strokeStyle = colours.sheet;
  context.stroke();
  context.lineWidth = 2.5;
  context.strokeStyle = colours.accent;
  context.stroke();
  context.beginPath();
  context.arc(x, y, 2.25, 0, 2 * Math.PI);
  context.fillStyle = colours.accent;
  context.fill();
  if (turns !== 'still') {
    for (const side of [0, Math.PI]) drawTurn(context, x, y, side, turns === 'clockwise' ? 1 : -1, colours);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} angle  where the arrow begins
 * @param {1 | -1} way  1 clockwise as it is seen
 * @param {Record<string, string>} colours
 */
function drawTurn(context, x, y, angle, way, colours) {
  const radius = 13.5;
  const end = angle + way * 1.25;
  for (const [width, colour] of /** @type {[number, string][]} */ ([[4.5, colours.sheet], [1.75, colours.accent]])) {
    context.beginPath();
    context.arc(x, y, radius, angle, end, way < 0);
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke();
  }
  const tipX = x + radius * Math.cos(end + way * 0.3);
  const tipY = y + radius * Math.sin(end + way * 0.3);
  context.beginPath();
  context.moveTo(tipX, tipY);
  context.lineTo(x + (radius + 3.2) * Math.cos(end), y + (radius + 3.2) * Math.sin(end));
  context.lineTo(x + (radius - 3.2) * Math.cos(end), y + (radius - 3.2) * Math.sin(end));
  context.closePath();
  context.fillStyle = colours.accent;
  context.fill();
}
