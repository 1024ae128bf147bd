// The calculator: a speed and its code by each method, and a code and what each method reads in it.
import { byId, el, whenQuiet } from '../dom.js';

/** @typedef {import('nctape').ComparedSpeed} ComparedSpeed */
/** @typedef {'F' | 'S'} Address */

/** Long enough to type a digit more. */
const PAUSE = 60;
/** In per cent: what the figures in the boxes leave open. */
const EXACT = 1e-4;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 */
export function makeCalculator({ store, engine }) {
  const dialog = el('dialog', { class: 'page calculator', id: 'calculator', 'aria-labelledby': 'calculator-title' });
  const speed = numberBox('speed');
  const code = el('input', { id: 'calculator-code', inputmode: 'numeric', autocomplete: 'off', spellcheck: 'false', maxlength: 18 });
  const length = numberBox('length');
  const radius = numberBox('radius');
  const units = [el('span'), el('span'), el('span')];
  const rows = el('tbody');
  const said = el('p', { class: 'fine', role: 'status', id: 'calculator-said' });
  /** What was typed last is what the other is worked out from. @type {'speed' | 'code'} */
  let from = 'speed';
  /** @type {Address} */
  let address = 'F';
  const addresses = [choice('F', 'Feed, F'), choice('S', 'Spindle speed, S')];
  const measures = el('div', { class: 'calculator-boxes' }, labelled(length, 'Length of the block', units[1]), labelled(radius, 'Radius of the arc', units[2]));

  dialog.append(
    el('form', { method: 'dialog', class: 'page-close' }, el('button', { type: 'submit', class: 'small' }, 'Close')),
    el('h2', { id: 'calculator-title' }, 'Feed and speed codes'),
    el('p', null, 'Type a speed and see its code by each method; or type a code and see what each method reads in it. Digits and tables are those of the format.'),
    el('fieldset', { class: 'calculator-address' }, el('legend', { class: 'hidden' }, 'Word'), ...addresses),
    el('div', { class: 'calculator-boxes' }, labelled(speed, 'Speed', units[0]), labelled(code, 'Code', null)),
    measures,
    el(
      'div',
      { class: 'calculator-scroll', tabindex: 0, role: 'region', 'aria-labelledby': 'calculator-title' },
      el(
        'table',
        { class: 'calculator-table' },
        el('thead', null, el('tr', null, ...['Method', 'Code', 'Says', 'Off by', 'Printed in'].map((name) => el('th', { scope: 'col' }, name)))),
        rows,
      ),
    ),
    said,
  );
  byId('app', HTMLElement).append(dialog);

  const tellSoon = whenQuiet(() => void tell(), PAUSE);
  speed.addEventListener('input', () => typed('speed'));
  code.addEventListener('input', () => typed('code'));
  for (const box of [length, radius]) box.addEventListener('input', tellSoon);
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  store.on(['format'], () => {
    if (dialog.open) void tell();
  });

  /** @param {'speed' | 'code'} box */
  function typed(box) {
    from = box;
    (box === 'speed' ? code : speed).value = '';
    tellSoon();
  }

  /**
   * @param {Address} letter
   * @param {string} words
   */
  function choice(letter, words) {
    const box = el('input', { type: 'radio', name: 'calculator-address', value: letter, checked: letter === 'F' });
    box.addEventListener('change', () => {
      address = letter;
      measures.hidden = letter === 'S';
      tellSoon();
    });
    return el('label', { class: 'switch' }, box, words);
  }

  async function tell() {
    const { format } = store.state;
    const about = { format, address, length: valueOf(length), radius: valueOf(radius) };
    const isBlank = (from === 'speed' ? speed : code).value.trim() === '';
    const wanted = valueOf(speed);
    const found =
      from === 'code' ? await engine.fact('speedOf', code.value.trim(), about) : await engine.fact('speedCodes', wanted ?? 0, about);
    const unit = found?.unit ?? '';
    if (found !== null) {
      units[0].textContent = unit;
      units[1].textContent = units[2].textContent = found.lengthUnit;
    }
    const isFault = !isBlank && (found === null || (from === 'speed' && wanted === null));
    (from === 'speed' ? speed : code).setAttribute('aria-invalid', String(isFault));
    said.textContent = isFault ? (from === 'code' ? 'A code is a row of digits.' : 'A speed is a number of zero or more.') : '';
    rows.replaceChildren(...(isBlank || isFault || found === null ? [] : found.rows.map((row) => rowOf(row, address, unit))));
  }

  return {
    /** Opens it with what the cursor is on. */
    open() {
      const { here, held } = store.state;
      const span = here?.span ?? null;
      if (speed.value === '' && code.value === '') speed.value = plain(span?.feed ?? held?.feed?.perMinute ?? 100);
      if (span !== null && span.length > 0) length.value = plain(span.length);
      if (span?.centre !== undefined) radius.value = plain(Math.hypot(...span.centre.map((value, axis) => (isFlat(span, axis) ? value - span.start[axis] : 0))));
      dialog.showModal();
      (from === 'speed' ? speed : code).select();
      void tell();
    },
  };
}

/**
 * The axis lies in the plane of the arc.
 * @param {import('nctape').Span} span
 * @param {number} axis
 */
const isFlat = (span, axis) => 'xyz'[axis] !== undefined && (span.plane ?? '').includes('xyz'[axis]);

/**
 * @param {ComparedSpeed} row
 * @param {Address} address
 * @param {string} unit
 */
function rowOf({ title, clause, inForce, code, speed, deviation, note }, address, unit) {
  const said = speed === null ? note : `${plain(speed)} ${unit}`;
  return el(
    'tr',
    { class: inForce ? 'in-force' : null },
    el('th', { scope: 'row' }, title, inForce && el('span', { class: 'calculator-own' }, 'in this format')),
    el('td', { class: 'code' }, code === null ? '–' : `${address}${code}`),
    el('td', { class: speed === null ? 'calculator-note' : 'calculator-number' }, said),
    el('td', { class: 'calculator-number' }, deviation === null ? '' : percent(deviation)),
    el('td', { class: 'calculator-clause' }, clause),
  );
}

/** @param {number} deviation */
function percent(deviation) {
  const text = deviation.toFixed(1).replace('-', '−');
  if (Number(deviation.toFixed(1)) === 0) return Math.abs(deviation) < EXACT ? 'exact' : 'under 0.1 %';
  return `${deviation > 0 ? '+' : ''}${text} %`;
}

/** @param {string} name */
function numberBox(name) {
  return el('input', { id: `calculator-${name}`, inputmode: 'decimal', autocomplete: 'off' });
}

/**
 * @param {HTMLInputElement} box
 * @param {string} words
 * @param {HTMLElement | null} unit
 */
const labelled = (box, words, unit) =>
  el('label', { class: 'calculator-box' }, el('span', { class: 'calculator-name' }, words), el('span', { class: 'calculator-in' }, box, unit));

/**
 * A decimal comma is one, too.
 * @param {HTMLInputElement} box
 */
function valueOf(box) {
  const text = box.value.trim().replace(',', '.');
  const value = Number(text);
  return text === '' || !Number.isFinite(value) || value < 0 ? null : value;
}

/** @param {number} value */
const plain = (value) => String(Number(value.toPrecision(7)));

