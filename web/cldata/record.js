// The record under the cursor in words, and what holds behind it: beside the path, where a tape has its registers.
import { byId, el } from '../dom.js';
import { blockName } from '../plot/words.js';
import { coordinate, sentence } from '../words.js';

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {(record: number) => void} parts.goTo
 */
export function makeRecord({ store, engine, goTo }) {
  const host = byId('record', HTMLElement);
  const place = byId('record-place', HTMLElement);
  const says = byId('record-says', HTMLElement);
  const from = byId('record-from', HTMLElement);
  const axes = byId('record-axes', HTMLElement);
  const rows = byId('record-rows', HTMLElement);

  async function tell() {
    const { here, kind, summary } = store.state;
    if (kind !== 'cldata' || summary === null || here === null) return;
    const { block } = here;
    const known = block !== null && block.called !== undefined;
    host.classList.toggle('blank', !known);
    place.textContent = known ? sentence(blockName(block)) : 'No record under the cursor';
    says.textContent = block?.says ?? '';
    says.classList.toggle('kept', block?.kept === true);
    const { statement } = block ?? {};
    from.replaceChildren();
    if (statement && statement.record !== block?.index) {
      const name = statement.identification.trim();
      const press = el('button', { type: 'button', class: 'small link' }, `statement ${statement.number ?? '?'}${name === '' ? '' : `, ${name}`}`);
      press.addEventListener('click', () => goTo(statement.record));
      from.append('From ', press, statement.text === null ? '' : ` ${statement.text.trim()}`);
    }
    if (!known) return;
    const state = await engine.ask('state', /** @type {number} */ (block?.index));
    if (!state || store.state.here !== here) return;
    const named = summary.axes.slice(0, 3);
    axes.replaceChildren(
      ...named.map((name, axis) =>
        el('tr', null, el('th', { scope: 'row' }, name), el('td', null, state.position === null ? '–' : coordinate(state.position[axis], summary.unit))),
      ),
    );
    rows.replaceChildren(
      ...state.registers.map(({ name, says, stated }) =>
        el('tr', null, el('th', { scope: 'row' }, name), el('td', { title: says, class: stated ? null : 'taken' }, says)),
      ),
    );
  }

  store.on(['here', 'summary'], () => void tell());
  void tell();
}
