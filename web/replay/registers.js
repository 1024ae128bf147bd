// What the control holds: a table whose rows stay where they are while the tape runs.
import { byId, el } from '../dom.js';
import { AXES } from '../plot/view.js';
import { blockName } from '../plot/words.js';
import { coordinate, feed, time } from '../words.js';
import { wayAlong } from './way.js';

/** @typedef {import('../store.js').Store} Store */
/** @typedef {import('../store.js').State} State */
/** @typedef {import('nctape').Registers} Registers */

/**
 * One line: a word as written or a code, and what it says.
 * @typedef {object} Line
 * @property {string} name
 * @property {string} code
 * @property {string} says
 * @property {boolean} [quiet]  the tape has not said so
 * @property {string[]} [more]  what does not fit into the line: when the functions act, and what other sources say of them
 */

/** @param {Store} store */
export function makeRegisters(store) {
  const host = byId('registers', HTMLElement);
  const head = el('h3', { id: 'registers-head' }, 'Registers');
  const place = el('p', { class: 'registers-place', id: 'registers-place' });
  const axes = el('tbody', { class: 'axes' });
  const lines = el('tbody', { class: 'lines' });
  const notes = el('div');
  // What a line of the table has no room for, for whoever does not hover.
  const details = el('details', { class: 'registers-more', id: 'registers-more' }, el('summary', null, 'When these act'), notes);
  host.append(
    el('div', { class: 'registers-head' }, head, place),
    el('table', { class: 'register-table' }, axes, lines),
    details,
  );
  /** The texts of the rows as they stand, so that only what changes is written. @type {string[]} */
  let written = [];
  let noted = '';

  details.addEventListener('toggle', tell);

  function tell() {
    const { held, heldBlock, summary } = store.state;
    host.classList.toggle('blank', held === null);
    if (held === null || heldBlock === null || summary === null) return;
    write(place, 0, `${placeOf(held, heldBlock)}${FATES[held.fate]}`);
    place.classList.toggle('left-out', held.fate !== 'executed');
    const position = positionAt(store.state, held);
    fill(axes, position.length);
    position.forEach((value, axis) => {
      const [name, cell] = cells(axes, axis);
      write(name, 2 * axis + 1, summary.axes[axis] ?? '?');
      write(cell, 2 * axis + 2, `${held.doubtful[axis] ? '? ' : ''}${coordinate(value, summary.unit)}`);
    });
    const all = linesOf(store.state, held);
    fill(lines, all.length);
    if (details.open) {
      const sentences = all.flatMap(({ more = [] }) => more);
      if (noted !== sentences.join('\n')) {
        noted = sentences.join('\n');
        notes.replaceChildren(...sentences.map((sentence) => el('p', null, sentence)));
      }
    }
    all.forEach(({ name, code, says, quiet, more = [] }, index) => {
      const [heading, cell] = cells(lines, index);
      const at = 2 * (position.length + index) + 1;
      write(heading, at, name);
      const words = [code, says, quiet, ...more].join('\n');
      if (written[at + 1] === words) return;
      written[at + 1] = words;
      cell.replaceChildren(el('span', { class: quiet ? 'code quiet-code' : 'code' }, code), ' ', says);
      cell.title = [[code, says].filter(Boolean).join(' '), ...more].join('\n');
    });
  }

  /**
   * @param {HTMLElement} element
   * @param {number} at
   * @param {string} words
   */
  function write(element, at, words) {
    if (written[at] === words && element.textContent === words) return;
    written[at] = words;
    element.textContent = words;
  }

  /**
   * As many rows as there are registers; it changes with the format and the tape, never with the block.
   * @param {HTMLTableSectionElement} body
   * @param {number} count
   */
  function fill(body, count) {
    if (body.rows.length === count) return;
    written = [];
    body.replaceChildren(...Array.from({ length: count }, () => el('tr', null, el('th', { scope: 'row' }), el('td'))));
  }

  store.on(['held', 'here', 'moment', 'summary'], tell);
}

/**
 * "Program 12 · N013"; a block without a number of its own has the last one behind it.
 * @param {Registers} held
 * @param {import('nctape').BlockView} block
 */
function placeOf({ program, sequence }, block) {
  const last = block.sequence === null && sequence !== null ? ` behind ${sequence}` : '';
  return `${program === null ? '' : `Program ${program} · `}${blockName(block)}${last}`;
}

/** @type {Record<Registers['fate'], string>} */
const FATES = { executed: '', skipped: ' is skipped', unreached: ' is behind the end' };

/**
 * @param {HTMLTableSectionElement} body
 * @param {number} row
 */
const cells = (body, row) => /** @type {HTMLElement[]} */ ([...body.rows[row].cells]);

/**
 * Where every axis is at this moment: on a line or an arc as the span says it, on another curve where the tool is in
 * the picture; an axis that does not take part, in proportion.
 * @param {State} state
 * @param {Registers} held
 */
function positionAt({ here, moment, path, track }, held) {
  const span = here?.block?.index === held.block ? here.span : null;
  if (moment === null || path === null || track === null || span === null) return held.position;
  const { block, along } = moment;
  if (block !== held.block || moment.share === 1 || !track.moves(block)) return held.position;
  const place = moment.span < path.kinds.length ? wayAlong(path, moment.span, along)?.place : undefined;
  // A block may end one span and stand in for another: the tool is on the first of the two.
  if (here?.block?.span !== moment.span) return held.position.map((value, axis) => place?.[axis] ?? value);
  const onWay = span.start.map((start, axis) => start + along * (span.end[axis] - start));
  if (span.kind === 'line' || span.kind === 'rapid') return onWay;
  const arc = placeOnArc(span, along);
  return onWay.map((value, axis) => (arc ?? place)?.[axis] ?? value);
}

/**
 * The two axes in which an arc turns, by the index of each; its radius goes from that of the start to that of the end.
 * @param {import('nctape').Span} span
 * @param {number} along
 * @returns {Record<number, number> | null}
 */
function placeOnArc({ plane, centre, sweep, start, end }, along) {
  if (plane === undefined || centre === undefined || sweep === undefined) return null;
  const [across, up] = AXES[plane];
  const [fromX, fromY] = [start[across] - centre[across], start[up] - centre[up]];
  const startRadius = Math.hypot(fromX, fromY);
  const radius = startRadius + along * (Math.hypot(end[across] - centre[across], end[up] - centre[up]) - startRadius);
  const angle = Math.atan2(fromY, fromX) + along * sweep;
  return { [across]: centre[across] + radius * Math.cos(angle), [up]: centre[up] + radius * Math.sin(angle) };
}

/**
 * @param {State} state
 * @param {Registers} held
 * @returns {Line[]}
 */
function linesOf({ here, summary }, held) {
  const unit = summary?.unit ?? 'mm';
  const span = here?.block?.index === held.block ? here.span : null;
  const along = span === null ? (held.feed?.perMinute ?? null) : span.feed;
  /** @param {import('nctape').NamedFunction | null} named */
  const named = (named) => ({ code: named?.code ?? '–', says: named?.meaning ?? '', more: named === null ? [] : acting([named]) });
  return [
    { name: 'Feed', code: held.feed?.word ?? '–', says: along === null ? '' : feed(along, unit) },
    ...(held.leads === null ? [] : [{ name: 'Lead', code: '', says: leadWords(held.leads, unit) }]),
    { name: 'Speed', code: held.speed?.word ?? '–', says: held.speed?.perMinute == null ? '' : `${Math.round(held.speed.perMinute * 10) / 10} rev/min` },
    { name: 'Spindle', ...named(held.spindle) },
    { name: 'Coolant', ...named(held.coolant) },
    { name: 'Tool', code: held.tool?.word ?? '–', says: held.tool === null ? '' : held.tool.change === null ? 'not changed yet' : `${held.tool.change.code} ${held.tool.change.meaning}` },
    ...(held.compensation === null ? [] : [{ name: 'Offset no.', code: held.compensation, says: '' }]),
    ...held.others.map(({ address, word }) => ({ name: address, code: word ?? '–', says: '' })),
    ...held.modal.map(({ group, code, meaning, acts, conflict, stated }) => ({ name: group, code: code === null ? '–' : stated ? code : `(${code})`, says: meaning, quiet: !stated, more: acting([{ code: code ?? '', acts, conflict }]) })),
    { name: 'This block', code: held.once.map(({ code }) => code).join(' ') || '–', says: [held.once.length === 1 ? held.once[0].meaning : '', held.dwell && time(held.dwell.seconds)].filter(Boolean).join(' '), more: acting(held.once) },
  ];
}

/**
 * "M05 acts after the motion of the block, until another function of its group."
 * @param {Pick<import('nctape').NamedFunction, 'code' | 'acts' | 'conflict'>[]} functions
 */
const acting = (functions) =>
  functions.flatMap(({ code, acts, conflict }) => [acts === '' ? '' : `${code} acts ${acts}.`, conflict ?? '']).filter(Boolean);

/**
 * "K 1.5 mm/rev"
 * @param {[number, number, number]} leads
 * @param {'mm' | 'inch'} unit
 */
const leadWords = (leads, unit) =>
  leads.flatMap((lead, axis) => (lead === 0 ? [] : [`${'IJK'[axis]} ${lead}`])).join(', ').replace(/(.)$/, `$1 ${unit === 'mm' ? 'mm' : 'in'}/rev`) || '–';
