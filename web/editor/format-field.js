// The format lives beside the text in the editor's state, so that one undo takes back both.
import { invertedEffects } from '@codemirror/commands';
import { Annotation, StateEffect, StateField } from '@codemirror/state';

/** @typedef {import('nctape').Format} Format */

/** @type {import('@codemirror/state').StateEffectType<Format>} */
export const setFormat = StateEffect.define();

/** What undo goes back to, where that is not the format just before. @type {import('@codemirror/state').AnnotationType<Format>} */
export const undoTo = Annotation.define();

/** @type {StateField<Format>} */
export const formatField = StateField.define({
  create: () => /** @type {Format} */ ({ standard: 'iso2539', detail: '' }),
  update(format, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(setFormat)) return effect.value;
    }
    return format;
  },
});

/** @param {Format} format  at the start */
export const formatWithUndo = (format) => [
  formatField.init(() => format),
  invertedEffects.of((transaction) =>
    transaction.effects.some((effect) => effect.is(setFormat))
      ? [setFormat.of(transaction.annotation(undoTo) ?? transaction.startState.field(formatField))]
      : [],
  ),
];
