// What the text is, a tape or CLDATA, lives beside it in the editor's state, so that one undo takes back both.
import { invertedEffects } from '@codemirror/commands';
import { StateEffect, StateField } from '@codemirror/state';

/** @typedef {import('nctape').SourceKind} SourceKind */

/** @type {import('@codemirror/state').StateEffectType<SourceKind>} */
export const setKind = StateEffect.define();

/** @type {StateField<SourceKind>} */
export const kindField = StateField.define({
  create: () => /** @type {SourceKind} */ ('tape'),
  update(kind, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(setKind)) return effect.value;
    }
    return kind;
  },
});

export const kindWithUndo = [
  kindField,
  invertedEffects.of((transaction) =>
    transaction.effects.some((effect) => effect.is(setKind)) ? [setKind.of(transaction.startState.field(kindField))] : [],
  ),
];
