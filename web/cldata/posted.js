// The tape that the CLDATA became, as text beside it: to be read, with the same light as in the other views.
import { EditorState } from '@codemirror/state';
import { drawSelection, EditorView, highlightSpecialChars, keymap } from '@codemirror/view';
import { byId } from '../dom.js';
import { shadowRoot } from '../editor/editor.js';
import { blockGutter } from '../editor/gutter.js';
import { keys } from '../editor/keys.js';
import { light, litField } from '../editor/lit.js';
import { liveMarks, marksField } from '../editor/marks.js';
import { scrollWithin } from '../editor/scroll.js';
import { theme } from '../editor/theme.js';
import { problemTooltip } from '../editor/tooltip.js';
import { counted, listed } from '../words.js';

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {string[]} parts.kinds
 * @param {(diagnostic: import('nctape').Diagnostic) => HTMLElement} parts.card
 * @param {(offset: number) => void} parts.onPlace  the hand went to this place of the tape
 * @param {(text: string, cursor: number) => void} parts.open  as a tape of its own
 */
export function makePosted({ store, engine, kinds, card, onPlace, open }) {
  const root = shadowRoot(byId('posted-text', HTMLElement));
  const about = byId('posted-about', HTMLElement);
  const marks = liveMarks((from, to) => engine.ask('postedListing', from, to), kinds);
  let ours = false;
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      extensions: [
        EditorState.readOnly.of(true),
        drawSelection(),
        highlightSpecialChars(),
        EditorState.tabSize.of(10),
        marks.extension,
        litField,
        blockGutter((shown) => shown.state.field(marksField).gutter),
        problemTooltip(card),
        theme,
        keymap.of([{ key: 'Escape', run: () => (byId('problems', HTMLElement).focus(), true) }, ...keys]),
        // No keyboard comes up on the screen for what cannot be written in; the tab key reaches it all the same.
        EditorView.contentAttributes.of({ 'aria-label': 'The tape that it became. Escape leaves it.', inputmode: 'none', spellcheck: 'false', tabindex: '0' }),
        EditorView.updateListener.of(({ selectionSet, state }) => {
          if (selectionSet && !ours) onPlace(state.selection.main.head);
        }),
      ],
    }),
  });

  /** Which text is shown. */
  let version = 0;
  engine.foresee(() => (store.state.kind === 'cldata' ? [['posted', version]] : []));
  async function refresh() {
    if (store.state.kind !== 'cldata') return;
    const next = await engine.ask('posted', version);
    if (next === undefined || store.state.kind !== 'cldata') return;
    if (next.text !== null) show(next.text);
    version = next.version;
    follow();
    void marks.refresh(view);
    tell();
  }

  /**
   * Changes what is not the same, so that the rest stays where it is.
   * @param {string} next
   */
  function show(next) {
    const before = view.state.doc.toString();
    let from = 0;
    while (from < before.length && from < next.length && before[from] === next[from]) from += 1;
    let to = before.length;
    let end = next.length;
    while (to > from && end > from && before[to - 1] === next[end - 1]) {
      to -= 1;
      end -= 1;
    }
    ours = true;
    view.dispatch({ changes: { from, to, insert: next.slice(from, end) } });
    ours = false;
  }

  /** Lights what the record became, and brings it into sight. */
  function follow() {
    const { here, kind } = store.state;
    if (kind !== 'cldata' || here?.posted === undefined) return;
    const { from, to, at } = here.posted;
    const limit = view.state.doc.length;
    light(view, { block: to > from && to <= limit ? { from, to } : null, chosen: null });
    if (!view.hasFocus) scrollWithin(view, Math.min(at, limit), 'nearest');
  }

  function tell() {
    const posted = store.state.summary?.posted;
    if (posted === undefined) return;
    const found = listed([
      ...(posted.errors > 0 ? [counted(posted.errors, 'error')] : []),
      ...(posted.warnings > 0 ? [counted(posted.warnings, 'warning')] : []),
    ]);
    about.classList.toggle('incomplete', posted.incomplete);
    about.textContent = [
      counted(posted.blocks, 'block'),
      posted.incomplete
        ? ': not complete, as the format above cannot say all of it. The problems name what is missing.'
        : ' under the format above, which you can change. The tape follows every key.',
      found === '' ? '' : ` Read as a tape it has ${found}.`,
    ].join('');
  }

  byId('posted-open', HTMLElement).addEventListener('click', () => {
    const { here } = store.state;
    open(view.state.doc.toString(), here?.posted?.at ?? 0);
  });

  store.on(['summary'], () => void refresh());
  store.on(['here'], follow);
  void refresh();
}
