// Draws the rows that are visible, in device pixels, each at a whole one.
import { putColumn } from './sheet.js';

/** @typedef {import('nctape').RowMeaning} RowMeaning */

/**
 * @typedef {object} StripPicture
 * @property {import('./sheet.js').Sheet} sheet
 * @property {import('./windows.js').Windows} windows
 * @property {RowMeaning[]} meanings
 * @property {string[]} kinds
 * @property {Record<string, string>} colours
 * @property {string} font
 * @property {number} rows
 * @property {number} position  row at the reader head, with its fraction
 * @property {[number, number] | null} lit  rows of the block that the cursor is on, [first, last + 1]
 * @property {number} ratio  device pixels for one of CSS
 */

/** Rows of bare tape before the first and behind the last, and over how many of them the tape fades out. */
const LEADER = 48;
const FADE = 28;

/** Heights around the tape, in CSS pixels. */
const ABOVE = 16;
const BELOW = 17;
const BAND = 4;

/** @type {(0 | 'info' | 'warning' | 'error')[]} */
const MARKS = [0, 'info', 'warning', 'error'];

/**
 * How high the whole strip is, in CSS pixels, for this pitch.
 * @param {number} pitch
 */
export const stripHeight = (pitch) => ABOVE + 12 * pitch + BELOW;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {StripPicture} picture
 */
export function drawStrip(context, picture) {
  const { canvas } = context;
  const { sheet, position, rows, ratio } = picture;
  const { pitch } = sheet;
  const head = Math.floor((canvas.width - pitch) / 2);
  /** @param {number} row */
  const xOf = (row) => head + Math.round((row - position) * pitch);
  const first = Math.floor(position - head / pitch) - 1;
  const last = first + Math.ceil(canvas.width / pitch) + 3;
  const frame = { ...picture, head, xOf, first, last, top: Math.round(ABOVE * ratio) };

  context.clearRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingEnabled = false;
  drawBareTape(context, frame);
  for (let row = Math.max(0, first); row <= Math.min(last, rows - 1); row += 1) drawRow(context, frame, row);
  drawNames(context, frame);
  drawHead(context, frame);
}

/** @typedef {StripPicture & { head: number, xOf: (row: number) => number, first: number, last: number, top: number }} Frame */

/**
 * The leader and the trailer: blank rows that fade into the bench.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawBareTape(context, { sheet, rows, first, last, xOf, top }) {
  for (let row = Math.max(first, -LEADER); row <= Math.min(last, rows - 1 + LEADER); row += 1) {
    const away = row < 0 ? -row : row - rows + 1;
    if (away <= 0) continue;
    const left = LEADER - away;
    context.globalAlpha = left >= FADE ? 1 : Math.max(0, left / FADE);
    putColumn(context, sheet, 0, xOf(row), top);
  }
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {number} row
 */
function drawRow(context, frame, row) {
  const { sheet, windows, meanings, kinds, colours, xOf, top, lit, ratio } = frame;
  const { pitch, columnHeight, paperTop, paperHeight } = sheet;
  const x = xOf(row);
  const known = windows.row(row);
  putColumn(context, sheet, known?.byte ?? 0, x, top);
  if (known === null) return;

  const paper = top + paperTop;
  const isLit = lit !== null && lit[0] <= row && row < lit[1];
  if (isLit) {
    context.fillStyle = colours.lamp;
    context.fillRect(x, paper, pitch, paperHeight);
  }
  if (known.kind > 0) drawBand(context, frame, kinds[known.kind - 1], x, paper - Math.round((BAND + 3) * ratio));
  if (known.mark > 0) drawMark(context, frame, x, MARKS[known.mark]);

  const { label } = meanings[known.byte];
  if (label !== '') {
    const size = Math.min(11.5 * ratio, (pitch * 0.98) / (0.61 * label.length));
    context.font = `${isLit ? '600 ' : ''}${size}px ${frame.font}`;
    context.textAlign = 'center';
    context.textBaseline = 'alphabetic';
    context.fillStyle = known.mark === 3 ? colours.errorOnBench : isLit ? colours.lampText : colours.benchText;
    context.fillText(label, x + pitch / 2, top + columnHeight + Math.round(1 * ratio));
  }
}

/**
 * The kind of the span over its rows; a rapid is dashed.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {string} kind
 * @param {number} x
 * @param {number} y
 */
function drawBand(context, { colours, sheet, ratio }, kind, x, y) {
  const height = Math.round(BAND * ratio);
  context.fillStyle = colours[kind] ?? colours.benchText;
  context.fillRect(x, y, kind === 'rapid' ? Math.round(sheet.pitch * 0.6) : sheet.pitch, height);
}

/**
 * A ring around a row with a problem, and the shape of its severity below it.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {number} x
 * @param {0 | 'info' | 'warning' | 'error'} severity
 */
function drawMark(context, { sheet, colours, top, ratio }, x, severity) {
  if (severity === 0) return;
  const { pitch, paperTop, paperHeight, columnHeight } = sheet;
  const line = Math.max(1, Math.round(1.5 * ratio));
  context.strokeStyle = colours[severity];
  context.lineWidth = line;
  context.setLineDash(severity === 'error' ? [] : severity === 'warning' ? [4 * ratio, 2 * ratio] : [ratio, 2 * ratio]);
  context.beginPath();
  context.roundRect(x + line / 2, top + paperTop + line / 2, pitch - line, paperHeight - line, pitch * 0.3);
  context.stroke();
  context.setLineDash([]);
  drawShape(context, severity, x + pitch / 2, top + columnHeight + 9 * ratio, 4 * ratio, colours[`${severity}OnBench`]);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {'info' | 'warning' | 'error'} severity
 * @param {number} x
 * @param {number} y
 * @param {number} r
 * @param {string} colour
 */
function drawShape(context, severity, x, y, r, colour) {
  context.beginPath();
  if (severity === 'warning') {
    context.moveTo(x, y - r);
    context.lineTo(x + r, y + r * 0.8);
    context.lineTo(x - r, y + r * 0.8);
    context.closePath();
  } else {
    context.arc(x, y, severity === 'error' ? r : r * 0.75, 0, 2 * Math.PI);
  }
  context.fillStyle = context.strokeStyle = colour;
  context.lineWidth = r * 0.4;
  if (severity === 'info') context.stroke();
  else context.fill();
}

/**
 * The numbers of the blocks above their first rows, left out where two would touch.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawNames(context, { windows, first, last, xOf, lit, colours, font, ratio, top, sheet }) {
  let free = -Infinity;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  for (const { row, text } of windows.names(first - 12, last)) {
    const isLit = lit !== null && row === lit[0];
    context.font = `${isLit ? '700' : '500'} ${11.5 * ratio}px ${font}`;
    const x = xOf(row);
    if (x < free) continue;
    free = x + context.measureText(text).width + 6 * ratio;
    context.fillStyle = isLit ? colours.lampText : colours.benchText;
    context.fillText(text, x + 3 * ratio, top - Math.round(2 * ratio));
    context.fillRect(x, top - Math.round(10 * ratio), Math.max(1, Math.round(ratio)), Math.round(10 * ratio) + sheet.paperTop - Math.round(9 * ratio));
  }
}

/**
 * The reader head: it stands still, the tape runs under it.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawHead(context, { sheet, head, top, ratio, colours }) {
  const { pitch, paperTop, paperHeight } = sheet;
  const centre = head + pitch / 2;
  const edge = Math.round(3 * ratio);
  const over = paperTop + top;
  context.fillStyle = colours.head;
  for (const [y, direction] of [[over - edge, -1], [over + paperHeight + edge, 1]]) {
    context.beginPath();
    context.moveTo(centre, y);
    context.lineTo(centre + 6 * ratio, y + direction * 8 * ratio);
    context.lineTo(centre - 6 * ratio, y + direction * 8 * ratio);
    context.closePath();
    context.fill();
  }
  const line = Math.max(1, Math.round(ratio));
  context.strokeStyle = colours.head;
  context.lineWidth = Math.max(1, Math.round(1.5 * ratio));
  context.beginPath();
  context.roundRect(head - line, over - edge, pitch + 2 * line, paperHeight + 2 * edge, 4 * ratio);
  context.stroke();
  context.globalAlpha = 0.75;
  context.fillRect(Math.round(centre - line / 2), over, line, paperHeight);
  context.globalAlpha = 1;
}
