// What the engine says about the visible text, kept in place while the user types ahead of it.
import { RangeSet, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin } from '@codemirror/view';
import { timed } from '../timing.js';
import { BlockMarker } from './gutter.js';

/** @typedef {import('nctape').Diagnostic} Diagnostic */
/** @typedef {import('../questions.js').Listing} Listing */
/** @typedef {import('nctape').Syntax} Syntax */
/** @typedef {import('@codemirror/state').Text} Text */
/** @typedef {import('@codemirror/state').ChangeDesc} ChangeDesc */

/**
 * @typedef {object} Marks
 * @property {import('@codemirror/view').DecorationSet} decorations
 * @property {RangeSet<BlockMarker>} gutter
 * @property {Diagnostic[]} diagnostics
 */

/** @typedef {(from: number, to: number) => Promise<Listing | undefined>} AskListing */

/** @type {import('@codemirror/state').StateEffectType<Marks>} */
const setMarks = StateEffect.define();

/** @type {StateField<Marks>} */
export const marksField = StateField.define({
  create: () => /** @type {Marks} */ ({ decorations: Decoration.none, gutter: RangeSet.empty, diagnostics: [] }),
  update(marks, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(setMarks)) return effect.value;
    }
    if (!transaction.docChanged) return marks;
    return {
      decorations: marks.decorations.map(transaction.changes),
      gutter: marks.gutter.map(transaction.changes),
      diagnostics: moved(marks.diagnostics, transaction.changes),
    };
  },
  provide: (field) => EditorView.decorations.from(field, (marks) => marks.decorations),
});

/**
 * The diagnostics with their ranges, and those of their fixes, moved by an edit.
 * @param {Diagnostic[]} diagnostics
 * @param {ChangeDesc} changes
 * @returns {Diagnostic[]}
 */
export function moved(diagnostics, changes) {
  /** @template {{ from: number, to: number }} T @param {T} range @returns {T} */
  const move = (range) => {
    if (range.from > changes.length) return range;
    const from = changes.mapPos(range.from, 1);
    return { ...range, from, to: Math.max(from, changes.mapPos(Math.min(range.to, changes.length), -1)) };
  };
  return diagnostics.map((diagnostic) => ({
    ...move(diagnostic),
    related: diagnostic.related?.map(move),
    fixes: diagnostic.fixes?.map((fix) => ({ ...fix, edits: fix.edits?.map(move) })),
  }));
}

/**
 * Asks for what is visible, after every change and every scroll; a late answer never arrives.
 * @param {AskListing} ask
 * @param {string[]} kinds
 */
export function liveMarks(ask, kinds) {
  const plugin = ViewPlugin.define((view) => {
    const refresh = async () => {
      const { from, to } = view.viewport;
      const doc = view.state.doc;
      const listing = await ask(from, to);
      if (listing === undefined || view.state.doc !== doc) return;
      timed('nctape.marks', () => {
        const marks = marksFor(listing, doc, kinds);
        if (!isSame(view.state.field(marksField), marks)) view.dispatch({ effects: setMarks.of(marks) });
      });
    };
    return {
      refresh,
      update(/** @type {import('@codemirror/view').ViewUpdate} */ update) {
        if (update.viewportChanged && !update.docChanged) void refresh();
      },
    };
  });
  return {
    extension: [marksField, plugin],
    /** @param {EditorView} view */
    refresh: (view) => view.plugin(plugin)?.refresh(),
    /**
     * What will be asked of the text as it stands.
     * @param {EditorView} view
     * @returns {[from: number, to: number]}
     */
    wanted: ({ viewport: { from, to } }) => [from, to],
  };
}

/**
 * The marks that moved with the text are still true: the editor has nothing to lay out.
 * @param {Marks} shown
 * @param {Marks} marks
 */
const isSame = (shown, marks) =>
  RangeSet.eq([shown.decorations], [marks.decorations]) &&
  RangeSet.eq([shown.gutter], [marks.gutter]) &&
  JSON.stringify(shown.diagnostics) === JSON.stringify(marks.diagnostics);

/**
 * @param {Listing} listing
 * @param {Text} doc
 * @param {string[]} kinds
 * @returns {Marks}
 */
function marksFor({ syntax, diagnostics }, doc, kinds) {
  return {
    decorations: Decoration.set([...wordMarks(syntax), ...squiggles(diagnostics, doc)], true),
    gutter: RangeSet.of(gutterMarks(syntax, diagnostics, doc, kinds), true),
    diagnostics,
  };
}

const roleMarks = ['address', 'sequence', 'type', 'literal', 'kept'].map((role) => Decoration.mark({ class: `cm-${role}` }));

/** @param {Syntax} syntax */
function* wordMarks({ ranges, roles }) {
  for (let i = 0; i < roles.length; i += 1) yield roleMarks[roles[i]].range(ranges[2 * i], ranges[2 * i + 1]);
}

/** @type {Record<string, Decoration>} */
const squiggleOf = {
  error: Decoration.mark({ class: 'cm-squiggle cm-squiggle-error' }),
  warning: Decoration.mark({ class: 'cm-squiggle cm-squiggle-warning' }),
  info: Decoration.mark({ class: 'cm-squiggle cm-squiggle-info' }),
};

/**
 * @param {Diagnostic[]} diagnostics
 * @param {Text} doc
 */
function* squiggles(diagnostics, doc) {
  for (const diagnostic of diagnostics) {
    const range = shownRange(diagnostic, doc);
    if (range !== null) yield squiggleOf[diagnostic.severity].range(range.from, range.to);
  }
}

/**
 * A range of at least one character on its line: an empty one takes a neighbour.
 * @param {{ from: number, to: number }} range
 * @param {Text} doc
 */
export function shownRange({ from, to }, doc) {
  if (from > doc.length) return null;
  if (to > from) return { from, to: Math.min(to, doc.length) };
  const line = doc.lineAt(from);
  if (from < line.to) return { from, to: from + 1 };
  return from > line.from ? { from: from - 1, to: from } : null;
}

const BADNESS = { error: 3, warning: 2, info: 1 };

/**
 * One marker for each line that begins a block or holds the start of a problem.
 * @param {Syntax} syntax
 * @param {Diagnostic[]} diagnostics
 * @param {Text} doc
 * @param {string[]} kinds
 */
function gutterMarks({ starts, kinds: kindOf }, diagnostics, doc, kinds) {
  /** @type {Map<number, { kind: string | null, worst: Diagnostic['severity'] | null }>} */
  const lines = new Map();
  /** @param {number} offset */
  const lineFor = (offset) => {
    const { from } = doc.lineAt(Math.min(offset, doc.length));
    const known = lines.get(from) ?? { kind: null, worst: null };
    lines.set(from, known);
    return known;
  };
  starts.forEach((start, i) => {
    if (kindOf[i] > 0) lineFor(start).kind = kinds[kindOf[i] - 1] ?? null;
  });
  for (const { from, severity } of diagnostics) {
    const line = lineFor(from);
    if (line.worst === null || BADNESS[severity] > BADNESS[line.worst]) line.worst = severity;
  }
  return [...lines].map(([from, { kind, worst }]) => new BlockMarker(kind, worst).range(from));
}
