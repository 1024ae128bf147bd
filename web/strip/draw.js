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
 * @property {import('./glyphs.js').Glyphs} glyphs
 * @property {number} rows
 * @property {Uint8Array} leader  rows of letters right before the first row
 * @property {number} position  row at the reader head, with its fraction
 * @property {[number, number] | null} lit  rows of the block that the cursor is on, [first, last + 1]
 * @property {number} ratio  device pixels for one of CSS
 */

/** Rows of bare tape before the first and behind the last, and over how many of them the tape fades out. */
const LEADER = 48;
const FADE = 28;

/** Heights around the tape, in CSS pixels. */
const ABOVE = 17;
const BELOW = 25;
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
  drawMarks(context, frame);
  drawNames(context, frame);
  drawHead(context, frame);
}

/** @typedef {StripPicture & { head: number, xOf: (row: number) => number, first: number, last: number, top: number }} Frame */

/**
 * The leader, with the letters in it, and the trailer: blank rows that fade into the bench.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawBareTape(context, { sheet, rows, leader, first, last, xOf, top }) {
  for (let row = Math.max(first, -leader.length - LEADER); row <= Math.min(last, rows - 1 + LEADER); row += 1) {
    if (row >= 0 && row < rows) continue;
    putColumn(context, sheet, row < 0 ? (leader[leader.length + row] ?? 0) : 0, xOf(row), top);
  }
  fade(context, xOf(-leader.length - LEADER), xOf(-leader.length - LEADER + FADE));
  fade(context, xOf(rows + LEADER), xOf(rows + LEADER - FADE));
}

/**
 * Takes the tape away towards its end, without steps.
 * @param {CanvasRenderingContext2D} context
 * @param {number} gone  where nothing is left
 * @param {number} whole  where all is
 */
function fade(context, gone, whole) {
  const { canvas } = context;
  const left = Math.min(gone, whole);
  const width = Math.abs(whole - gone);
  if (left > canvas.width || left + width < 0) return;
  const gradient = context.createLinearGradient(gone, 0, whole, 0);
  gradient.addColorStop(0, 'rgb(0 0 0 / 100%)');
  gradient.addColorStop(1, 'rgb(0 0 0 / 0%)');
  context.globalCompositeOperation = 'destination-out';
  context.fillStyle = gradient;
  context.fillRect(left, 0, width, canvas.height);
  context.globalCompositeOperation = 'source-over';
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
    const rail = Math.round(3 * ratio);
    context.fillStyle = colours.lamp;
    context.fillRect(x, paper, pitch, paperHeight);
    context.fillStyle = colours.head;
    context.fillRect(x, paper, pitch, rail);
    context.fillRect(x, paper + paperHeight - rail, pitch, rail);
  }
  if (known.kind > 0) drawBand(context, frame, kinds[known.kind - 1], x, paper - Math.round((BAND + 3) * ratio));

  const { label } = meanings[known.byte];
  const bad = known.mark === 3;
  const colour = bad ? colours.errorOnBench : isLit ? colours.lampText : label.length > 1 ? colours.benchQuiet : colours.benchText;
  drawCharacter(context, frame, label, x, colour, isLit ? 600 : 400);
}

/**
 * The character under its row.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {string} label
 * @param {number} x
 * @param {string} colour
 * @param {number} weight
 */
function drawCharacter(context, { sheet, top, font, ratio, glyphs }, label, x, colour, weight) {
  const y = top + sheet.columnHeight + Math.round(ratio * 5);
  glyphs.put(context, { pitch: sheet.pitch, ratio, font }, label, x, y, colour, weight);
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
  context.fillStyle = colours[`band-${kind}`] ?? colours.benchText;
  context.fillRect(x, y, kind === 'rapid' ? Math.round(sheet.pitch * 0.6) : sheet.pitch, height);
}

/**
 * One ring around neighbouring rows of one severity, and its shape below the first of them.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawMarks(context, frame) {
  const { windows, first, last, rows } = frame;
  const end = Math.min(last, rows - 1) + 1;
  for (let row = Math.max(0, first); row < end; ) {
    const mark = windows.row(row)?.mark ?? 0;
    const from = row;
    row += 1;
    while (row < end && (windows.row(row)?.mark ?? 0) === mark) row += 1;
    const severity = MARKS[mark];
    if (severity !== 0) drawMark(context, frame, from, row, severity);
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {number} from
 * @param {number} to  behind the last row
 * @param {'info' | 'warning' | 'error'} severity
 */
function drawMark(context, { sheet, colours, top, ratio, xOf }, from, to, severity) {
  const { pitch, paperTop, paperHeight, columnHeight } = sheet;
  const line = Math.max(1, Math.round(1.75 * ratio));
  const x = xOf(from);
  const width = xOf(to) - x;
  context.strokeStyle = colours[severity];
  context.lineWidth = line;
  context.setLineDash(severity === 'error' ? [] : severity === 'warning' ? [5 * ratio, 2.5 * ratio] : [1.5 * ratio, 2.5 * ratio]);
  context.beginPath();
  context.roundRect(x + line / 2, top + paperTop + line / 2, width - line, paperHeight - line, pitch * 0.35);
  context.stroke();
  context.setLineDash([]);
  drawShape(context, severity, x + pitch / 2, top + columnHeight + 18 * ratio, 4 * ratio, colours[`${severity}OnBench`]);
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
 * The number of a block that began further left stays at the edge.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawNames(context, frame) {
  const { windows, first, last, xOf, font, ratio } = frame;
  const gap = 6 * ratio;
  /** @type {{ row: number, text: string } | null} */
  let began = null;
  let free = 0;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.font = `600 ${11.5 * ratio}px ${font}`;
  for (const name of windows.names(first, last)) {
    const x = xOf(name.row);
    if (x < 0) {
      began = name;
      continue;
    }
    if (began !== null) {
      if (gap + context.measureText(began.text).width + gap < x) drawName(context, frame, began, 0);
      began = null;
    }
    if (x < free) continue;
    free = x + context.measureText(name.text).width + gap;
    drawName(context, frame, name, x);
  }
  if (began !== null) drawName(context, frame, began, 0);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 * @param {{ row: number, text: string }} name
 * @param {number} x
 */
function drawName(context, { sheet, lit, colours, top, ratio, xOf }, { row, text }, x) {
  const isLit = lit !== null && row === lit[0];
  context.fillStyle = isLit ? colours.lampText : colours.benchText;
  context.fillText(text, x + Math.round(4 * ratio), top - Math.round(2 * ratio));
  if (xOf(row) < 0) return;
  const height = sheet.paperTop + Math.round(4 * ratio);
  context.fillRect(x, top - Math.round(11 * ratio), Math.max(1, Math.round(ratio)), height);
}

/**
 * The reader head: it stands still, the tape runs under it. Two jaws hold a window over the row;
 * a fine line runs through it to the character, which is set in the colour of the lamp.
 * @param {CanvasRenderingContext2D} context
 * @param {Frame} frame
 */
function drawHead(context, frame) {
  const { sheet, windows, meanings, position, head, top, ratio, colours } = frame;
  const { pitch, paperTop, paperHeight, columnHeight } = sheet;
  const centre = head + pitch / 2;
  const paper = top + paperTop;
  const wide = Math.round(pitch * 2.3);
  const jaw = Math.round(7 * ratio);
  const line = Math.max(1, Math.round(ratio));

  context.fillStyle = colours.jaw;
  context.shadowColor = 'rgb(0 0 0 / 45%)';
  context.shadowBlur = 5 * ratio;
  context.shadowOffsetY = ratio;
  context.beginPath();
  context.roundRect(centre - wide / 2, paper - jaw, wide, jaw + line, [4 * ratio, 4 * ratio, 0, 0]);
  context.roundRect(centre - wide / 2, paper + paperHeight - line, wide, jaw, [0, 0, 4 * ratio, 4 * ratio]);
  context.fill();
  context.shadowColor = 'transparent';

  context.strokeStyle = colours.head;
  context.lineWidth = 2 * line;
  context.strokeRect(head - line, paper, pitch + 2 * line, paperHeight);
  context.fillStyle = colours.head;
  context.fillRect(Math.round(centre - line / 2), paper - jaw, line, paperHeight + 2 * jaw);

  const known = windows.row(Math.round(position));
  if (known === null || frame.rows === 0) return;
  const { label } = meanings[known.byte];
  const y = top + columnHeight + Math.round(5 * ratio);
  const half = Math.max(pitch, 14 * ratio) / 2 + ratio;
  context.fillStyle = colours.lampText;
  context.beginPath();
  context.roundRect(centre - half, y - 11 * ratio, 2 * half, 22 * ratio, 4 * ratio);
  context.fill();
  drawCharacter(context, frame, label, head, colours.lampInk, 700);
}
