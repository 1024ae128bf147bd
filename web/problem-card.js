// One problem in words: in the list, and under the pointer in the text.
import { button, el } from './dom.js';
import { severityMark } from './severity.js';
import { whole } from './words.js';

/** @typedef {import('nctape').Diagnostic} Diagnostic */
/** @typedef {import('nctape').Fix} Fix */

/**
 * @typedef {object} Deeds
 * @property {(fix: Fix) => void} apply
 * @property {(fix: Fix) => boolean} [takes]  it is offered here; left out, every fix is
 * @property {(rule: string) => void} openRule
 * @property {(range: { from: number, to: number }) => void} show  select a range in all views
 */

/**
 * The sentence, the clauses last.
 * @param {Diagnostic} diagnostic
 */
export function messageOf({ message, clauses, count }) {
  return el(
    'span',
    { class: 'message' },
    message,
    count > 1 ? ' ' : null,
    count > 1 ? el('span', { class: 'repeats' }, `${whole(count)} times.`) : null,
    ' ',
    el('span', { class: 'clauses' }, clauses.join(', ')),
  );
}

/**
 * Buttons: what else belongs to it, its corrections, its rule.
 * @param {Diagnostic} diagnostic
 * @param {Deeds} deeds
 * @param {{ withRule: boolean }} options
 */
export function deedsOf(diagnostic, { apply, takes = () => true, openRule, show }, { withRule }) {
  const related = (diagnostic.related ?? []).map((range) =>
    button('small link', range.message, () => show(range)),
  );
  const fixes = (diagnostic.fixes ?? []).filter(takes).map((fix) => button('small fix', fix.title, () => apply(fix)));
  const rule = withRule
    ? [button('small link rule', diagnostic.rule, () => openRule(diagnostic.rule), { title: `What ${diagnostic.rule} means` })]
    : [];
  const all = [...fixes, ...related, ...rule];
  return all.length > 0 ? el('div', { class: 'deeds' }, ...all) : null;
}

/**
 * The card of the tooltip.
 * @param {Diagnostic} diagnostic
 * @param {Deeds} deeds
 */
export function problemCard(diagnostic, deeds) {
  return el(
    'div',
    { class: 'card' },
    el('p', { class: 'card-words' }, severityMark(diagnostic.severity), messageOf(diagnostic)),
    deedsOf(diagnostic, deeds, { withRule: true }),
  );
}
