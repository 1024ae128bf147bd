// What is lit in the text: the block that the cursor is on, and the range of the chosen problem.
import { RangeSet, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView } from '@codemirror/view';

/** @typedef {{ from: number, to: number }} Range */
/** @typedef {{ block: Range | null, chosen: Range | null }} Lit */

/** @type {import('@codemirror/state').StateEffectType<Lit>} */
const setLit = StateEffect.define();

const litLine = Decoration.line({ class: 'cm-lit' });
const chosenMark = Decoration.mark({ class: 'cm-chosen' });

/** @type {StateField<import('@codemirror/view').DecorationSet>} */
export const litField = StateField.define({
  create: () => Decoration.none,
  update(lit, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(setLit)) return decorate(effect.value, transaction.state.doc);
    }
    return lit.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

const MOST_LINES = 200;

/**
 * @param {Lit} lit
 * @param {import('@codemirror/state').Text} doc
 */
function decorate({ block, chosen }, doc) {
  const marks = [];
  if (block !== null && block.from <= doc.length) {
    const last = doc.lineAt(Math.min(Math.max(block.from, block.to - 1), doc.length)).number;
    const first = doc.lineAt(block.from).number;
    for (let number = first; number <= Math.min(last, first + MOST_LINES); number += 1) {
      marks.push(litLine.range(doc.line(number).from));
    }
  }
  if (chosen !== null && chosen.to <= doc.length && chosen.to > chosen.from) {
    marks.push(chosenMark.range(chosen.from, chosen.to));
  }
  return Decoration.set(marks, true);
}

/**
 * Lights what is not lit yet: the next row is mostly one of the same block.
 * @param {EditorView} view
 * @param {Lit} lit
 */
export function light(view, lit) {
  const shown = view.state.field(litField);
  if (!RangeSet.eq([shown], [decorate(lit, view.state.doc)])) view.dispatch({ effects: setLit.of(lit) });
}
