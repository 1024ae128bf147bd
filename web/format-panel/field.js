// One field of the format: its label, its box, its help, and what is wrong with it.
import { el } from '../dom.js';
import { severityMark } from '../severity.js';
import { WAYS } from './parse.js';

/** @typedef {import('nctape').FormatField} FormatField */
/** @typedef {import('nctape').Diagnostic} Diagnostic */

/**
 * @typedef {object} FieldView
 * @property {HTMLElement} element
 * @property {(value: unknown) => void} show
 * @property {(diagnostics: Diagnostic[]) => void} judge
 */

/**
 * @param {FormatField} field
 * @param {(value: unknown) => void} onValue  undefined: not stated
 * @returns {FieldView}
 */
export function makeField(field, onValue) {
  const id = `field-${field.path.replaceAll('.', '-')}`;
  const way = WAYS[field.kind];
  const box = boxFor(field, id);
  const fault = el('p', { class: 'field-fault', id: `${id}-fault` });
  const verdicts = el('div', { class: 'field-verdicts' });
  box.setAttribute('aria-describedby', `${id}-help ${id}-fault`);

  box.addEventListener('input', () => {
    const written = box.value.trim();
    const parsed = written === '' ? { value: undefined } : way.read(written);
    tellFault('fault' in parsed ? parsed.fault : '');
    if ('value' in parsed) onValue(parsed.value);
  });
  /** @param {string} words */
  function tellFault(words) {
    fault.textContent = words;
    box.setAttribute('aria-invalid', String(words !== ''));
  }

  return {
    element: el(
      'div',
      { class: `field field-${field.kind}` },
      el('label', { for: id }, field.label),
      box,
      fault,
      verdicts,
      el('p', { class: 'field-help', id: `${id}-help` }, field.help),
    ),
    show(value) {
      // What is being written is not touched.
      if (box === document.activeElement) return;
      box.value = value === undefined || value === null ? '' : way.write(value);
      tellFault('');
    },
    judge(diagnostics) {
      verdicts.replaceChildren(
        ...diagnostics.map(({ severity, message, clauses }) =>
          el(
            'p',
            { class: 'field-verdict' },
            severityMark(severity),
            el('span', null, message, ' ', el('span', { class: 'clauses' }, clauses.join(', '))),
          ),
        ),
      );
    },
  };
}

/**
 * @param {FormatField} field
 * @param {string} id
 */
function boxFor(field, id) {
  if (field.kind === 'choice' || field.kind === 'flag') {
    const choices =
      field.kind === 'choice'
        ? field.choices
        : [
            { value: 'true', title: 'yes' },
            { value: 'false', title: 'no' },
          ];
    const unstated = field.default === '' ? 'not stated' : `not stated: ${field.default}`;
    return el(
      'select',
      { id },
      el('option', { value: '' }, unstated),
      ...choices.map(({ value, title }) => el('option', { value }, title)),
    );
  }
  return el('input', {
    id,
    type: 'text',
    inputmode: field.kind === 'number' ? 'decimal' : null,
    placeholder: field.default,
    autocomplete: 'off',
    spellcheck: 'false',
  });
}
