// A span in words: the line in the picture, and the table under it.
import { el } from '../dom.js';
import { coordinate, degrees, feed, length, sentence, time } from '../words.js';
import { AXES } from './view.js';

/** @typedef {import('nctape').Span} Span */
/** @typedef {import('../store.js').Summary} Summary */
/** @typedef {import('../store.js').BlockView} BlockView */

/**
 * "X 44.142  Y 55.858  Z 10.000"
 * @param {number[]} point
 * @param {Summary} summary
 */
const place = (point, { axes, unit }) =>
  point.map((value, axis) => `${axes[axis] ?? '?'} ${coordinate(value, unit)}`).join('  ');

/**
 * What a block is called: its number, or else its place in the tape.
 * @param {BlockView | null} block
 */
export const blockName = (block) => (block === null ? '' : (block.called ?? block.sequence ?? `block ${block.index + 1}`));

/**
 * "Arc to X 44.142 Y 55.858 · 15.708 mm · 297 mm/min · 3.2 s · N006"
 * @param {Span} span
 * @param {BlockView | null} block
 * @param {Summary} summary
 */
export function spanLine(span, block, summary) {
  return [
    `${sentence(span.kind)} to ${place(span.end, summary)}`,
    length(span.length, summary.unit),
    span.feed === null ? 'feed not known' : feed(span.feed, summary.unit),
    span.seconds === null ? 'time not known' : time(span.seconds),
    blockName(block),
  ]
    .filter(Boolean)
    .join(' · ');
}

/**
 * "X 44.142  Y 55.858 mm": a place in the picture.
 * @param {[number, number]} at
 * @param {import('nctape').Plane} plane
 * @param {Summary} summary
 */
export const placeLine = (at, plane, { axes, unit }) =>
  `${AXES[plane].map((axis, index) => `${axes[axis] ?? '?'} ${coordinate(at[index], unit)}`).join('  ')} ${unit === 'mm' ? 'mm' : 'in'}`;

/**
 * The rows of the table: a name and what it is.
 * @param {Span} span
 * @param {Summary} summary
 * @returns {[string, string][]}
 */
function facts(span, summary) {
  const { unit } = summary;
  /** @type {[string, string | null][]} */
  const all = [
    ['Start', place(span.start, summary)],
    ['End', place(span.end, summary)],
    ['Length', length(span.length, unit)],
    ['Centre', span.centre === undefined ? null : place(span.centre, summary)],
    ['Tangents meet', span.tangent === undefined ? null : place(span.tangent, summary)],
    ['Sweep', span.sweep === undefined ? null : turn(span.sweep)],
    ['Feed', feed(span.feed, unit)],
    ['Time', time(span.seconds)],
  ];
  return /** @type {[string, string][]} */ (all.filter(([, value]) => value !== null));
}

/** @param {number} sweep */
const turn = (sweep) => `${degrees(Math.abs(sweep))} ${sweep > 0 ? 'counter-clockwise' : 'clockwise'}`;

/**
 * @param {Span} span
 * @param {Summary} summary
 */
export const spanRows = (span, summary) =>
  facts(span, summary).map(([name, value]) => el('tr', null, el('th', { scope: 'row' }, name), el('td', null, value)));

/**
 * @param {Span} span
 * @param {BlockView | null} block
 */
export const spanCaption = (span, block) =>
  `${sentence(span.kind)}${block === null ? '' : ` of ${blockName(block)}`}${span.substitute ? ', a stand-in for what cannot be computed' : ''}`;
