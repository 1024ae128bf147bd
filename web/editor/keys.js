// What the keys of the listing do: those of any text. A tape has no syntax to go along, no brackets to jump between and
// nothing to indent; a new line begins empty, for a tab that nobody typed would be a row of holes.
//
// CodeMirror's own list of keys would bring its parser of languages with it, which is a tenth of its size.
import * as deed from '@codemirror/commands';

/** @typedef {import('@codemirror/view').KeyBinding} KeyBinding */

/** @type {KeyBinding[]} */
const CURSOR = [
  { key: 'ArrowLeft', run: deed.cursorCharLeft, shift: deed.selectCharLeft, preventDefault: true },
  { key: 'Mod-ArrowLeft', mac: 'Alt-ArrowLeft', run: deed.cursorGroupLeft, shift: deed.selectGroupLeft, preventDefault: true },
  { mac: 'Cmd-ArrowLeft', run: deed.cursorLineBoundaryLeft, shift: deed.selectLineBoundaryLeft, preventDefault: true },
  { key: 'ArrowRight', run: deed.cursorCharRight, shift: deed.selectCharRight, preventDefault: true },
  { key: 'Mod-ArrowRight', mac: 'Alt-ArrowRight', run: deed.cursorGroupRight, shift: deed.selectGroupRight, preventDefault: true },
  { mac: 'Cmd-ArrowRight', run: deed.cursorLineBoundaryRight, shift: deed.selectLineBoundaryRight, preventDefault: true },
  { key: 'ArrowUp', run: deed.cursorLineUp, shift: deed.selectLineUp, preventDefault: true },
  { mac: 'Cmd-ArrowUp', run: deed.cursorDocStart, shift: deed.selectDocStart },
  { mac: 'Ctrl-ArrowUp', run: deed.cursorPageUp, shift: deed.selectPageUp },
  { key: 'ArrowDown', run: deed.cursorLineDown, shift: deed.selectLineDown, preventDefault: true },
  { mac: 'Cmd-ArrowDown', run: deed.cursorDocEnd, shift: deed.selectDocEnd },
  { mac: 'Ctrl-ArrowDown', run: deed.cursorPageDown, shift: deed.selectPageDown },
  { key: 'PageUp', run: deed.cursorPageUp, shift: deed.selectPageUp },
  { key: 'PageDown', run: deed.cursorPageDown, shift: deed.selectPageDown },
  { key: 'Home', run: deed.cursorLineBoundaryBackward, shift: deed.selectLineBoundaryBackward, preventDefault: true },
  { key: 'Mod-Home', run: deed.cursorDocStart, shift: deed.selectDocStart },
  { key: 'End', run: deed.cursorLineBoundaryForward, shift: deed.selectLineBoundaryForward, preventDefault: true },
  { key: 'Mod-End', run: deed.cursorDocEnd, shift: deed.selectDocEnd },
  { key: 'Mod-a', run: deed.selectAll },
  { key: 'Alt-l', mac: 'Ctrl-l', run: deed.selectLine },
];

/** @type {KeyBinding[]} */
const TEXT = [
  { key: 'Enter', run: deed.insertNewline, shift: deed.insertNewline },
  { key: 'Backspace', run: deed.deleteCharBackwardStrict, shift: deed.deleteCharBackwardStrict, preventDefault: true },
  { key: 'Delete', run: deed.deleteCharForward, preventDefault: true },
  { key: 'Mod-Backspace', mac: 'Alt-Backspace', run: deed.deleteGroupBackward, preventDefault: true },
  { key: 'Mod-Delete', mac: 'Alt-Delete', run: deed.deleteGroupForward, preventDefault: true },
  { mac: 'Mod-Backspace', run: deed.deleteLineBoundaryBackward, preventDefault: true },
  { mac: 'Mod-Delete', run: deed.deleteLineBoundaryForward, preventDefault: true },
  { key: 'Alt-ArrowUp', run: deed.moveLineUp },
  { key: 'Alt-ArrowDown', run: deed.moveLineDown },
  { key: 'Shift-Alt-ArrowUp', run: deed.copyLineUp },
  { key: 'Shift-Alt-ArrowDown', run: deed.copyLineDown },
  { key: 'Shift-Mod-k', run: deed.deleteLine },
];

export const keys = [...CURSOR, ...TEXT, ...deed.historyKeymap];
