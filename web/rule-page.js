// The page of a rule: what it means and why a control objects, with a bad and a good tape.
import { byId, el } from './dom.js';
import { markdown } from './markdown.js';
import { severityMark, SEVERITY_WORD } from './severity.js';

/** @typedef {import('nctape').Rule} Rule */
/** @typedef {import('nctape').Standard} Standard */

/** @param {import('./engine.js').Engine} engine */
export function makeRulePage(engine) {
  const dialog = byId('rule-page', HTMLDialogElement);
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  /** @type {Promise<[Rule[], { id: Standard, title: string }[]]> | null} */
  let known = null;
  return {
    /** @param {string} id */
    async open(id) {
      known ??= Promise.all([engine.fact('rules'), engine.fact('standards')]);
      const [rules, standards] = await known;
      const rule = rules.find((candidate) => candidate.rule === id || candidate.aliases.includes(id));
      if (rule === undefined) return;
      dialog.replaceChildren(...pageOf(rule, standards));
      dialog.scrollTop = 0;
      dialog.showModal();
    },
  };
}

/**
 * @param {Rule} rule
 * @param {{ id: Standard, title: string }[]} standards
 */
function pageOf(rule, standards) {
  const verdicts = standards.map(({ id, title }) => {
    const severity = rule.severity[id];
    return el(
      'li',
      null,
      severity === null ? el('span', { class: 'mark' }) : severityMark(severity),
      `${title}: ${severity === null ? 'does not apply' : SEVERITY_WORD[severity].toLowerCase()}`,
    );
  });
  const body = markdown(rule.page);
  // The page's own heading would say the title twice.
  if (rule.page.trimStart().startsWith('# ')) body.shift();
  return [
    el('form', { method: 'dialog', class: 'page-close' }, el('button', { type: 'submit', class: 'small' }, 'Close')),
    el('p', { class: 'eyebrow' }, `${rule.rule} · ${rule.name}`),
    el('h2', { id: 'rule-title' }, rule.title),
    el('ul', { class: 'verdicts' }, ...verdicts),
    el('div', { class: 'prose' }, ...body),
    rule.clauses.length > 0 ? el('p', { class: 'fine' }, rule.clauses.join(', ')) : '',
  ];
}
