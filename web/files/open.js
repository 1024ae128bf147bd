// Opens a file from this machine: chosen, or dropped on the page. What it holds is told by its content.
import { button, byId, el } from '../dom.js';
import { notice } from '../notice.js';
import { counted, whole } from '../words.js';
import { MOST_BYTES } from './limits.js';

/** So many remarks on rows are listed. */
const MOST = 100;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {(tape: import('../own-tape.js').Whole) => void} parts.load
 * @param {(range: { from: number, to: number }) => void} parts.show
 * @param {(rule: string) => void} parts.openRule
 * @param {() => void} parts.close  the menu
 */
export function makeOpen({ store, engine, load, show, openRule, close }) {
  const input = byId('file-input', HTMLInputElement);
  const veil = byId('drop-veil', HTMLElement);
  const card = byId('file-card', HTMLElement);

  /** What is loaded next is the file that the card speaks of. */
  let ours = false;
  const hide = () => (card.hidden = true);
  // It goes when another tape is opened.
  store.on(['summary'], ({ whole }) => {
    if (!whole) return;
    if (!ours) hide();
    ours = false;
  });
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && !event.defaultPrevented) hide();
  });

  byId('open-file', HTMLElement).addEventListener('click', () => input.click());
  input.addEventListener('change', async () => {
    close();
    const [file] = input.files ?? [];
    if (file !== undefined) await open(file);
    // The same file can be chosen again after it was changed.
    input.value = '';
  });

  /** @param {DragEvent} event */
  const hasFile = (event) => event.dataTransfer?.types.includes('Files') ?? false;
  // Before the editor, which would put the text of a file where it is dropped.
  window.addEventListener(
    'dragover',
    (event) => {
      if (!hasFile(event)) return;
      event.preventDefault();
      event.stopPropagation();
      veil.hidden = false;
    },
    { capture: true },
  );
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  window.addEventListener(
    'drop',
    (event) => {
      if (!hasFile(event)) return;
      event.preventDefault();
      event.stopPropagation();
      veil.hidden = true;
      const [file] = event.dataTransfer?.files ?? [];
      if (file !== undefined) void open(file);
    },
    { capture: true },
  );

  /** @param {File} file */
  async function open(file) {
    if (file.size > MOST_BYTES) {
      notice(`${file.name} has ${whole(file.size)} bytes; up to ${whole(MOST_BYTES)} can be opened.`);
      return;
    }
    let bytes;
    try {
      bytes = new Uint8Array(await file.arrayBuffer());
    } catch {
      notice(`${file.name} cannot be read.`);
      return;
    }
    const opened = await engine.fact('openFile', bytes, store.state.format);
    // As the editor has its line ends, which offsets count.
    ours = true;
    load({ source: opened.text.replace(/\r\n?/g, '\n'), format: opened.format, cursor: 0, kind: opened.language });
    tell(file.name, bytes.length, opened);
  }

  /**
   * @param {string} name
   * @param {number} size
   * @param {import('nctape').OpenedFile} opened
   */
  function tell(name, size, { kind, reason, decoded }) {
    const issues = decoded?.issues ?? [];
    card.replaceChildren(
      el(
        'div',
        { class: 'file-head' },
        el('h2', null, name),
        button('small', 'Close', hide, { 'aria-label': 'Close what is said of the file' }),
      ),
      el('p', null, kind === 'image' ? `${reason} ${counted(size, 'row')}.` : reason),
      decoded === null ? '' : el('p', null, decoded.reason),
      decoded === null ? '' : el('p', { class: 'file-count' }, issues.length === 0 ? 'Every row could be read.' : `${counted(issues.length, 'remark')} on rows:`),
      issues.length > 0 ? el('ol', { class: 'file-issues' }, ...issues.slice(0, MOST).map(entry)) : '',
      issues.length > MOST ? el('p', null, `… and ${whole(issues.length - MOST)} more.`) : '',
    );
    card.hidden = false;
  }

  /** @param {import('nctape').RowIssue} issue */
  function entry({ row, rule, message, from, to }) {
    return el(
      'li',
      null,
      button('file-issue', `Row ${whole(row + 1)}: ${message}`, () => show({ from, to })),
      button('small link', rule, () => openRule(rule), { title: `What ${rule} means` }),
    );
  }
}
