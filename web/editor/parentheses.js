// A parenthesis that is opened is closed at once, so that a comment being typed does not swallow the rest of the text.
import { EditorSelection, Prec } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';

/** @typedef {import('@codemirror/state').EditorState} EditorState */

/** How far is looked for the other parenthesis: no comment is so long. */
const REACH = 20_000;

/**
 * Between `(` and `)`, or behind a `(` that nothing closes.
 * @param {EditorState} state
 * @param {number} at
 */
function isInside(state, at) {
  const before = state.sliceDoc(Math.max(0, at - REACH), at);
  return before.lastIndexOf('(') > before.lastIndexOf(')');
}

/**
 * The next parenthesis is a `)` that waits for its `(`.
 * @param {EditorState} state
 * @param {number} at
 */
const isAwaited = (state, at) => /^[^()]*\)/.test(state.sliceDoc(at, at + REACH));

/**
 * @param {EditorView} view
 * @param {number} from
 * @param {number} to
 * @param {string} typed
 */
function typeParenthesis(view, from, to, typed) {
  const { state } = view;
  if (view.composing || state.readOnly || state.selection.ranges.length > 1) return false;
  const { anchor, head } = state.selection.main;
  if (typed === '(' && !isInside(state, from)) {
    const enclosed = state.sliceDoc(from, to);
    if (/[()]/.test(enclosed) || (from === to && isAwaited(state, to))) return false;
    view.dispatch({
      changes: { from, to, insert: `(${enclosed})` },
      selection: from === to ? EditorSelection.cursor(from + 1) : EditorSelection.range(anchor + 1, head + 1),
      scrollIntoView: true,
      userEvent: 'input.type',
    });
    return true;
  }
  if (typed === ')' && from === to && state.sliceDoc(to, to + 1) === ')' && isInside(state, from)) {
    view.dispatch({ selection: EditorSelection.cursor(to + 1), scrollIntoView: true, userEvent: 'input.type' });
    return true;
  }
  return false;
}

/**
 * Backspace in an empty pair takes both.
 * @param {EditorView} view
 */
function deletePair({ state, dispatch }) {
  const { main, ranges } = state.selection;
  if (ranges.length > 1 || !main.empty || state.readOnly) return false;
  if (state.sliceDoc(main.head - 1, main.head + 1) !== '()') return false;
  dispatch(state.update({ changes: { from: main.head - 1, to: main.head + 1 }, scrollIntoView: true, userEvent: 'delete.backward' }));
  return true;
}

export const closedParentheses = [
  EditorView.inputHandler.of(typeParenthesis),
  Prec.high(keymap.of([{ key: 'Backspace', run: deletePair }])),
];
