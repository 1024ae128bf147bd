// A severity has a word, a shape and a colour; the colour is never alone.

/** @typedef {import('nctape').Severity} Severity */

/** @type {Record<Severity, string>} */
export const SEVERITY_WORD = { error: 'Error', warning: 'Warning', info: 'Note' };

const SVG = 'http://www.w3.org/2000/svg';

/** In a square of 12: a disc with a cross, a triangle, a ring. @type {Record<Severity, [tag: string, attributes: Record<string, string>][]>} */
const SHAPES = {
  error: [
    ['circle', { cx: '6', cy: '6', r: '5.5', class: 'mark-body' }],
    ['path', { d: 'M4 4 8 8M8 4 4 8', class: 'mark-sign' }],
  ],
  warning: [
    ['path', { d: 'M6 .8 11.6 11H.4Z', class: 'mark-body' }],
    ['path', { d: 'M6 4.4V7.4M6 8.8V9.4', class: 'mark-sign' }],
  ],
  info: [['circle', { cx: '6', cy: '6', r: '4.4', class: 'mark-ring' }]],
};

/**
 * The shape as a picture with its word.
 * @param {Severity} severity
 */
export function severityMark(severity) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('class', `mark mark-${severity}`);
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', SEVERITY_WORD[severity]);
  for (const [tag, attributes] of SHAPES[severity]) {
    const shape = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) shape.setAttribute(name, value);
    svg.append(shape);
  }
  return svg;
}
