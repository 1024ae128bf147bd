// The page of a rule: what it means and why a control objects, with a bad and a good tape.
import { button, byId, el } from './dom.js';
import { markdown } from './markdown.js';
import { exampleReader } from './rule-examples.js';
import { severityMark, SEVERITY_WORD } from './severity.js';

/** @typedef {import('nctape').Rule} Rule */
/** @typedef {import('nctape').Standard} Standard */

/**
 * @param {object} parts
 * @param {import('./engine.js').Engine} parts.engine
 * @param {() => import('nctape').Format} parts.format  that the reader works under
 * @param {((example: import('./rule-examples.js').Example) => void) | null} parts.load  null: its examples are only read
 */
export function makeRulePage({ engine, format, load }) {
  const dialog = byId('rule-page', HTMLDialogElement);
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  /** @type {Promise<[Rule[], { id: Standard, title: string }[]]> | null} */
  let known = null;

  /** @returns {import('./markdown.js').UnderFence} */
  function underFence() {
    const read = exampleReader(format().standard, format());
    return (info, body) => {
      const example = read(info, body);
      if (example === null || load === null) return null;
      return button('small', 'Open this example', () => {
        dialog.close();
        load(example);
      });
    };
  }

  return {
    /** @param {string} id */
    async open(id) {
      known ??= Promise.all([engine.fact('rules'), engine.fact('standards')]);
      const [rules, standards] = await known;
      const rule = rules.find((candidate) => candidate.rule === id || candidate.aliases.includes(id));
      if (rule === undefined) return;
      dialog.replaceChildren(...pageOf(rule, standards, underFence(), () => dialog.close()));
      dialog.scrollTop = 0;
      dialog.showModal();
    },
  };
}

/**
 * @param {Rule} rule
 * @param {{ id: Standard, title: string }[]} standards
 * @param {import('./markdown.js').UnderFence} underFence
 * @param {() => void} close
 */
function pageOf(rule, standards, underFence, close) {
  const onCldata = rule.severity.iso3592;
  /** @type {[title: string, severity: import('nctape').Severity | null][]} */
  const known = onCldata === undefined ? standards.map(({ id, title }) => [title, rule.severity[id]]) : [['ISO 3592', onCldata]];
  const verdicts = known.map(([title, severity]) => {
    return el(
      'li',
      null,
      severity === null ? el('span', { class: 'mark' }) : severityMark(severity),
      `${title}: ${severity === null ? 'does not apply' : SEVERITY_WORD[severity].toLowerCase()}`,
    );
  });
  const body = markdown(rule.page, underFence);
  // The page's own heading would say the title twice.
  if (rule.page.trimStart().startsWith('# ')) body.shift();
  return [
    // No form: a frame may be one where forms are forbidden.
    el('div', { class: 'page-close' }, button('small', 'Close', close)),
    el('p', { class: 'eyebrow' }, `${rule.rule} · ${rule.name}`),
    el('h2', { id: 'rule-title' }, rule.title),
    el('ul', { class: 'verdicts' }, ...verdicts),
    el('div', { class: 'prose' }, ...body),
    rule.clauses.length > 0 ? el('p', { class: 'fine' }, rule.clauses.join(', ')) : '',
  ];
}
