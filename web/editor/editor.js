// The listing of the tape: text and format in one state with one undo.
import { history } from '@codemirror/commands';
import { Annotation, EditorState, Transaction } from '@codemirror/state';
import { drawSelection, EditorView, highlightSpecialChars, keymap } from '@codemirror/view';
import sharedStyle from '../style/shared.css?inline';
import { formatField, formatWithUndo, setFormat, undoTo } from './format-field.js';
import { blockGutter } from './gutter.js';
import { keys } from './keys.js';
import { kindField, kindWithUndo, setKind } from './kind-field.js';
import { litField } from './lit.js';
import { liveMarks, marksField } from './marks.js';
import { closedParentheses } from './parentheses.js';
import { scrollWithin } from './scroll.js';
import { theme } from './theme.js';
import { problemTooltip } from './tooltip.js';
import { typeOver } from './type-over.js';

/** @typedef {import('nctape').Format} Format */
/** @typedef {import('nctape').Diagnostic} Diagnostic */

/** @typedef {'tape' | 'path' | 'problems' | 'paste' | 'replay' | 'posted'} Mover */

/** Which view moved the cursor, where it was not the editor. @type {import('@codemirror/state').AnnotationType<Mover>} */
export const movedBy = Annotation.define();

/**
 * @typedef {object} Parts
 * @property {HTMLElement} host
 * @property {Format} format
 * @property {string[]} kinds
 * @property {import('./marks.js').AskListing} ask
 * @property {(diagnostic: Diagnostic) => HTMLElement} card  a problem as the tooltip shows it
 * @property {(direction: 1 | -1) => void} goToProblem
 * @property {() => void} leave  where the focus goes by Escape
 * @property {(update: import('@codemirror/view').ViewUpdate) => void} onUpdate
 * @property {import('@codemirror/state').Extension} [more]  what else the editor of this page does
 */

/** @param {Parts} parts */
export function makeEditor({ host, format, kinds, ask, card, goToProblem, leave, onUpdate, more = [] }) {
  const root = shadowRoot(host);
  const marks = liveMarks(ask, kinds);
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      extensions: [
        formatWithUndo(format),
        kindWithUndo,
        history(),
        closedParentheses,
        typeOver,
        drawSelection(),
        highlightSpecialChars(),
        EditorState.tabSize.of(10),
        marks.extension,
        litField,
        blockGutter((view) => view.state.field(marksField).gutter),
        problemTooltip(card),
        theme,
        keymap.of([
          { key: 'F8', run: () => (goToProblem(1), true), shift: () => (goToProblem(-1), true) },
          { key: 'Mod-i', run: insertTab, preventDefault: true },
          { key: 'Escape', run: () => (leave(), true) },
          ...keys,
        ]),
        EditorView.contentAttributes.of({
          'aria-label': 'Program. Escape leaves it.',
          spellcheck: 'false',
          autocorrect: 'off',
          autocapitalize: 'off',
          // It takes the focus as it is; who looks for what does so reads this.
          tabindex: '0',
        }),
        EditorView.updateListener.of(onUpdate),
        more,
      ],
    }),
  });
  return { view, refreshMarks: () => marks.refresh(view), marksWanted: () => marks.wanted(view) };
}

/**
 * In a shadow root CodeMirror adopts its style sheets: the page needs no inline style.
 * @param {HTMLElement} host
 */
export function shadowRoot(host) {
  const root = host.attachShadow({ mode: 'open' });
  const style = new CSSStyleSheet();
  style.replaceSync(sharedStyle);
  root.adoptedStyleSheets = [style];
  return root;
}

/** @param {EditorView} view */
export function insertTab(view) {
  view.dispatch(view.state.replaceSelection('\t'), { scrollIntoView: true, userEvent: 'input' });
  return true;
}

/** @param {EditorView} view */
export const currentFormat = (view) => view.state.field(formatField);

/** @param {EditorView} view */
export const currentKind = (view) => view.state.field(kindField);

/**
 * Makes the edits of a fix, and reads the text in another language from then on where it says so.
 * @param {EditorView} view
 * @param {import('nctape').Fix} fix
 */
export const mend = (view, { edits, kind }) =>
  view.dispatch({
    changes: edits,
    effects: kind === undefined ? [] : setKind.of(kind),
    userEvent: 'input.fix',
    scrollIntoView: true,
  });

/**
 * @param {EditorView} view
 * @param {Format} format
 */
export const changeFormat = (view, format) => view.dispatch({ effects: setFormat.of(format), userEvent: 'input.format' });

/**
 * Changes the format as a hand that is still moving does: undo knows nothing of it.
 * @param {EditorView} view
 * @param {Format} format
 */
export const tryFormat = (view, format) =>
  view.dispatch({ effects: setFormat.of(format), annotations: Transaction.addToHistory.of(false) });

/**
 * The hand has come to rest: what it tried is undone as one, back to where it began.
 * @param {EditorView} view
 * @param {Format} began
 */
export const keepFormat = (view, began) =>
  view.dispatch({ effects: setFormat.of(currentFormat(view)), annotations: undoTo.of(began), userEvent: 'input.format' });

/**
 * Replaces the text, the format and what the text is, undone as one; the first one cannot be undone.
 * @param {EditorView} view
 * @param {{ source: string, format: Format, cursor: number, kind?: import('nctape').SourceKind }} whole
 * @param {{ isFirst?: boolean }} [options]
 */
export function replaceAll(view, { source, format, cursor, kind = 'tape' }, { isFirst = false } = {}) {
  view.dispatch({
    changes: { from: 0, to: view.state.doc.length, insert: source },
    selection: { anchor: Math.min(cursor, source.length) },
    effects: [setFormat.of(format), setKind.of(kind)],
    userEvent: 'input.replace',
    annotations: isFirst ? Transaction.addToHistory.of(false) : [],
  });
  scrollWithin(view, Math.min(cursor, source.length), 'opened');
}

/**
 * Puts the cursor where another view points, and brings it into sight.
 * @param {EditorView} view
 * @param {number} offset
 * @param {Mover} by
 * @param {number} [to]  end of a selection
 */
export function moveCursor(view, offset, by, to = offset) {
  const limit = view.state.doc.length;
  const anchor = Math.min(offset, limit);
  const isAsked = by === 'problems';
  view.dispatch({
    selection: { anchor, head: Math.min(to, limit) },
    effects: isAsked ? EditorView.scrollIntoView(anchor, { y: 'center' }) : [],
    annotations: movedBy.of(by),
  });
  // Who moves the tape or the path looks at these: the page stays where it is, where it is longer than the screen.
  // A replay runs through the rows of a line: the line comes into sight, and does not move to and fro.
  const seen = by === 'replay' ? view.state.doc.lineAt(anchor).from : anchor;
  if (!isAsked) scrollWithin(view, seen, by === 'tape' || by === 'replay' ? 'nearest' : 'center');
}
