// Ties the views of the frame to one tape, and tells the page around what becomes of it.
import { Compartment, EditorState } from '@codemirror/state';
import { byId, whenQuiet } from '../dom.js';
import { changeFormat, currentFormat, currentKind, makeEditor, movedBy, moveCursor, replaceAll } from '../editor/editor.js';
import { light } from '../editor/lit.js';
import { makePlot } from '../plot/plot.js';
import { problemCard } from '../problem-card.js';
import { makeProblems } from '../problems.js';
import { makeRulePage } from '../rule-page.js';
import { makeStrip } from '../strip/strip.js';
import { makeFullPage } from './full-page.js';
import { goalTeller } from './goal-line.js';
import { tellHost } from './host.js';
import { MOST_TEXT } from './protocol.js';
import { makeViews } from './views.js';

/** @typedef {import('../share/whole.js').Whole} Whole */
/** @typedef {ReturnType<typeof makePlayground>} Playground */

/** The page around is told when the typing pauses for so many milliseconds. */
const PAUSE = 200;
/** Problems that it is told. */
const MOST_PROBLEMS = 100;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {string[]} parts.kinds
 */
export function makePlayground({ store, engine, kinds }) {
  const views = makeViews(store);
  const reset = byId('reset', HTMLButtonElement);
  /** What the exercise begins with. @type {Whole | null} */
  let beginning = null;
  /** The text that the page around was told last. @type {string | null} */
  let told = null;
  /** The block that it was told last. */
  let toldBlock = -1;
  /** The text was replaced as a whole, and the engine has not answered yet. */
  let replaced = true;

  const rulePage = makeRulePage({ engine, format: () => store.state.format, load: null });
  /** @type {import('../problem-card.js').Deeds} */
  const deeds = {
    apply({ edits, format }) {
      if (editor.state.readOnly) return;
      if (edits !== undefined) editor.dispatch({ changes: edits, userEvent: 'input.fix', scrollIntoView: true });
      if (format !== undefined) changeFormat(editor, format);
    },
    // The frame shows tapes alone.
    takes: ({ kind }) => kind === undefined,
    openRule: (rule) => void rulePage.open(rule),
    show({ from, to }) {
      store.set({ chosen: { from, to } });
      views.reveal('program');
      moveCursor(editor, from, 'problems', to);
    },
  };

  const readOnly = new Compartment();
  const { view: editor, refreshMarks, marksWanted } = makeEditor({
    host: byId('editor', HTMLElement),
    format: store.state.format,
    kinds,
    ask: (from, to) => engine.ask('listing', from, to),
    card: (diagnostic) => problemCard(diagnostic, deeds),
    goToProblem: (direction) => void problems.goTo(direction),
    leave: () => views.leaveProgram(),
    onUpdate,
    more: [
      readOnly.of([]),
      // Also for what does not ask whether it may: a fix, a tab, a key over a selection.
      EditorState.changeFilter.of((change) => !change.startState.readOnly || change.isUserEvent('input.replace')),
    ],
  });
  const head = () => editor.state.selection.main.head;
  const whole = () => ({ source: editor.state.doc.toString(), format: currentFormat(editor), cursor: head() });

  makeStrip({ store, engine, kinds, onRow: (offset) => moveCursor(editor, offset, 'tape') });
  const problems = makeProblems({ store, engine, deeds, textLength: () => editor.state.doc.length, cursor: () => editor.state.selection.main.from });
  makePlot({ store, engine, kinds, onBlock: (offset) => moveCursor(editor, offset, 'path') });
  const goal = goalTeller(store, engine);
  const fullPage = makeFullPage(() => ({ ...whole(), kind: currentKind(editor) }));

  engine.foresee(() => [['listing', ...marksWanted()]]);
  store.on(['summary'], () => void refreshMarks());
  store.on(['here', 'chosen'], ({ here, chosen }) => light(editor, { block: here?.block ?? null, chosen }));
  store.on(['here'], ({ here }) => {
    const block = here?.block ?? null;
    if ((block?.index ?? -1) === toldBlock) return;
    toldBlock = block?.index ?? -1;
    tellHost('select', { block: block?.sequence ?? null, number: toldBlock + 1 });
  });
  store.on(['format'], async ({ format }) => {
    const line = await engine.fact('formatLine', format);
    if (store.state.format !== format) return;
    byId('format-text', HTMLElement).textContent = line;
    byId('format-text', HTMLElement).title = line;
  });

  /** @param {import('@codemirror/view').ViewUpdate} update */
  function onUpdate(update) {
    const format = currentFormat(update.view);
    const isNewFormat = format !== store.state.format;
    if (update.docChanged) {
      replaced ||= update.transactions.some((one) => one.isUserEvent('input.replace'));
      problems.move(update.changes);
    }
    if (isNewFormat) store.set({ format });
    if (update.docChanged || isNewFormat) {
      reset.disabled = false;
      const changes = update.docChanged ? update.changes : undefined;
      engine.alter({ changes, format: isNewFormat ? format : undefined, offset: head() });
    } else if (update.selectionSet) {
      const byList = update.transactions.some((one) => one.annotation(movedBy) === 'problems');
      if (!byList) store.set({ chosen: null });
      void locate();
    }
  }

  async function locate() {
    const offset = head();
    const here = await engine.ask('locate', offset);
    if (here !== undefined && offset === head()) store.set({ here });
  }

  const tell = whenQuiet(async () => {
    const { summary } = store.state;
    if (summary === null) return;
    const { source, format } = whole();
    void fullPage.refresh();
    if (source !== told && source.length <= MOST_TEXT) {
      told = source;
      tellHost('change', { text: source, format });
    }
    const found = await engine.ask('problems', 0, editor.state.doc.length + 1, MOST_PROBLEMS);
    if (found === undefined) return;
    const { errors, warnings, infos } = summary;
    const list = found.map(({ rule, severity, from, to, line, column, message }) => ({ rule, severity, from, to, line, column, message }));
    tellHost('diagnostics', { errors, warnings, notes: infos, list });
    await goal.judge(format);
  }, PAUSE);

  reset.addEventListener('click', resetText);

  /** Brings the beginning back, undone as one. */
  function resetText() {
    if (beginning !== null) replaceAll(editor, beginning);
    reset.disabled = true;
  }

  return {
    /**
     * @param {import('./settings.js').Settings} settings
     * @param {Whole | null} tape  null: as it is
     */
    show(settings, tape) {
      views.show(settings);
      goal.set(settings.goal);
      fullPage.setAddress(settings.page);
      editor.dispatch({ effects: readOnly.reconfigure(settings.readOnly ? EditorState.readOnly.of(true) : []) });
      reset.hidden = settings.readOnly;
      if (tape !== null) {
        beginning = tape;
        replaceAll(editor, tape, { isFirst: true });
        if (!engine.opened) engine.open();
        reset.disabled = true;
      }
      tell();
      if (settings.block !== null) void this.select(settings.block);
    },
    /** @param {string} text */
    setText: (text) => replaceAll(editor, { ...whole(), source: text, cursor: 0 }),
    reset: resetText,
    /** @param {string} name  of a block */
    async select(name) {
      // The engine may still be reading what the name is of.
      for (let i = 0; i < 20; i += 1) {
        const block = await engine.ask('blockNamed', name);
        if (block !== undefined) {
          if (block !== null) moveCursor(editor, block.from, 'path');
          return;
        }
        await new Promise((resolve) => setTimeout(resolve, 50));
      }
    },
    current: () => ({ source: editor.state.doc.toString(), format: currentFormat(editor), skip: store.state.skip, offset: head() }),
    /** @param {import('../engine.js').Change} change */
    changed({ summary, here }) {
      store.set({ summary, here, whole: replaced });
      replaced = false;
      if (here.offset !== head()) void locate();
      tell();
    },
  };
}
