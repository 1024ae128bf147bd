// The panel that explains the format and changes it while one looks.
import { button, byId, el } from '../dom.js';
import { makeField } from './field.js';
import { makeSuggestions } from './suggestions.js';
import { valueAt, withValue } from './value.js';

/** @typedef {import('nctape').Format} Format */
/** @typedef {import('nctape').Standard} Standard */
/** @typedef {import('nctape').FormatField} FormatField */

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {() => { toString(): string }} parts.text
 * @param {(format: Format) => void} parts.change
 * @param {() => void} parts.openCalculator
 */
export function makeFormatPanel({ store, engine, text, change, openCalculator }) {
  const panel = byId('format-panel', HTMLElement);
  const opener = byId('format-button', HTMLElement);
  const words = el('ul', { class: 'explained' });
  const fieldsBox = el('div', { class: 'fields' });
  const standard = el('select', { id: 'field-standard' });
  const suggestions = makeSuggestions({ store, engine, text, change });
  const body = el('div', { class: 'drawer-body' });
  const closer = button('small', 'Close', close);
  /** @type {Map<string, import('./field.js').FieldView>} */
  let fields = new Map();
  /** @type {Standard | null} */
  let fieldsFor = null;

  panel.append(
    el('div', { class: 'drawer-head' }, el('h2', { id: 'format-head' }, 'Format of the control'), closer),
    body,
  );
  body.append(
    suggestions.element,
    el('div', { class: 'field field-choice' }, el('label', { for: 'field-standard' }, 'Standard'), standard),
    fieldsBox,
    el('p', { class: 'drawer-foot' }, button('small', 'Feed and speed codes', openCalculator)),
  );
  standard.addEventListener('change', () =>
    change({ ...store.state.format, standard: /** @type {Standard} */ (standard.value) }),
  );
  opener.addEventListener('click', () => (panel.hidden ? open() : close()));
  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });

  async function open() {
    panel.hidden = false;
    opener.setAttribute('aria-expanded', 'true');
    panel.focus();
    await show();
  }
  function close() {
    panel.hidden = true;
    opener.setAttribute('aria-expanded', 'false');
    opener.focus();
  }

  async function show() {
    if (panel.hidden) return;
    const { format } = store.state;
    if (standard.options.length === 0) {
      const standards = await engine.fact('standards');
      standard.replaceChildren(...standards.map(({ id, title }) => el('option', { value: id }, title)));
    }
    if (fieldsFor !== format.standard) {
      fieldsFor = format.standard;
      const known = await engine.fact('formatFields', format.standard);
      build(known.filter(({ path }) => path !== 'standard'));
    }
    standard.value = store.state.format.standard;
    for (const [path, field] of fields) field.show(valueAt(store.state.format, path));
    judge();
  }

  /** @param {FormatField[]} known */
  function build(known) {
    fields = new Map(
      known.map((field) => [
        field.path,
        makeField(field, (value) => change(withValue(store.state.format, field.path, value))),
      ]),
    );
    /** @type {Map<string, HTMLElement[]>} */
    const groups = new Map();
    for (const { path, group } of known) {
      const members = groups.get(group) ?? [];
      members.push(/** @type {HTMLElement} */ (fields.get(path)?.element));
      groups.set(group, members);
    }
    const [shorthand, ...rest] = [...groups].map(([group, members]) =>
      el('fieldset', null, el('legend', null, group), ...members),
    );
    // The words stand right under the shorthand that they explain.
    fieldsBox.replaceChildren(shorthand, el('section', { 'aria-label': 'In words' }, words), ...rest);
  }

  function judge() {
    const { explanation } = store.state;
    if (explanation === null) return;
    words.replaceChildren(...explanation.sentences.map((sentence) => el('li', null, sentence)));
    for (const [path, field] of fields) {
      field.judge(explanation.diagnostics.filter((diagnostic) => diagnostic.path === path));
    }
  }

  store.on(['format'], () => void show());
  store.on(['explanation'], judge);

  return {
    /**
     * Opens at one field.
     * @param {string | null} path
     */
    async openAt(path) {
      await open();
      const box = path === null ? null : document.getElementById(`field-${path.replaceAll('.', '-')}`);
      box?.scrollIntoView({ block: 'center' });
      box?.focus();
    },
    /** Opens with formats that would fit the tape. */
    suggest() {
      void open();
      body.scrollTop = 0;
      void suggestions.ask();
    },
  };
}
