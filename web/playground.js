// Makes the views and ties them to one tape: what one of them is told, all of them show.
import { byId, whenQuiet } from './dom.js';
import { makeDecimals } from './decimals.js';
import { makeKindSwitch } from './cldata/kind.js';
import { changeFormat, currentFormat, currentKind, insertTab, keepFormat, makeEditor, mend, movedBy, moveCursor, replaceAll, tryFormat } from './editor/editor.js';
import { light } from './editor/lit.js';
import { makeFormatPanel } from './format-panel/panel.js';
import { makeFiles } from './files/files.js';
import { makeHeader } from './header.js';
import { makeHints } from './hints.js';
import { makeLayout } from './layout.js';
import { lazily } from './lazy.js';
import { makeLearn } from './learn.js';
import { makeOffer } from './offer.js';
import { makePlot } from './plot/plot.js';
import { problemCard } from './problem-card.js';
import { makeProblems } from './problems.js';
import { makeReplayControls } from './replay/controls.js';
import { makeRegisters } from './replay/registers.js';
import { makeReplay } from './replay/replay.js';
import { makeTimeline } from './replay/timeline.js';
import { makeRulePage } from './rule-page.js';
import { makeShareButton } from './share/button.js';
import { makeSkip } from './skip.js';
import { makeName } from './strip/name.js';
import { followAddress, SHARED } from './start.js';
import { makeStrip } from './strip/strip.js';
import { makeThemeButton } from './theme.js';
import { makeTotals } from './totals.js';

/** @typedef {import('nctape').Preset} Preset */
/** @typedef {import('@codemirror/view').ViewUpdate} ViewUpdate */
/** @typedef {{ current: () => import('./engine.js').Current, changed: (change: import('./engine.js').Change) => void }} Playground */

/** A draft is kept when the typing pauses for so many milliseconds. */
const DRAFT = 800;

/**
 * @param {object} parts
 * @param {import('./store.js').Store} parts.store
 * @param {import('./engine.js').Engine} parts.engine
 * @param {string[]} parts.kinds
 * @param {Preset[]} parts.presets
 * @param {import('./start.js').Beginning} parts.beginning
 * @returns {Playground}
 */
export function makePlayground({ store, engine, kinds, presets, beginning }) {
  const layout = makeLayout();
  const rulePage = makeRulePage({
    engine,
    format: () => store.state.format,
    load(example) {
      header.welcome('Example of a rule');
      replaceAll(editor, example);
      if (layout.narrow()) layout.showTab('program');
      editor.focus();
    },
  });
  const first = beginning.tape ?? presets[0];
  store.set({ format: first.format });

  /** @type {import('./problem-card.js').Deeds} */
  const deeds = {
    apply(fix) {
      if (fix.edits !== undefined || fix.kind !== undefined) mend(editor, fix);
      if (fix.format !== undefined) changeFormat(editor, fix.format);
    },
    openRule: (rule) => void rulePage.open(rule),
    show({ from, to }) {
      store.set({ chosen: { from, to } });
      if (layout.narrow()) layout.showTab('program');
      moveCursor(editor, from, 'problems', to);
    },
  };

  /** The text was replaced as a whole, and the engine has not answered yet. */
  let replaced = true;
  /** It was replaced by a paste or a file, which leave the cursor where nothing is to be seen. */
  let toSight = false;
  const { view: editor, refreshMarks, marksWanted } = makeEditor({
    host: byId('editor', HTMLElement),
    format: first.format,
    kinds,
    ask: (from, to) => engine.ask('listing', from, to),
    card: (diagnostic) => problemCard(diagnostic, deeds),
    goToProblem: (direction) => void problems.goTo(direction),
    leave: () => byId('problems', HTMLElement).focus(),
    onUpdate,
  });
  const head = () => editor.state.selection.main.head;

  const header = makeHeader({
    store,
    engine,
    presets,
    choose: (preset) => replaceAll(editor, preset),
    current: whole,
    load(tape) {
      replaceAll(editor, tape);
      editor.focus();
    },
    own: beginning.own,
    earlier: beginning.earlier,
    guest: beginning.guest,
  });
  const keepDraft = whenQuiet(() => beginning.drafts.keep(header.draft()), DRAFT);
  window.addEventListener('pagehide', () => beginning.drafts.keep(header.draft()));
  makeShareButton(whole);
  followAddress(engine, (tape) => {
    header.welcome(SHARED);
    replaceAll(editor, tape);
  });
  makeThemeButton(store);
  const calculator = lazily(async () => (await import('./speeds/calculator.js')).makeCalculator({ store, engine }));
  const openCalculator = async () => (await calculator()).open();
  makeLearn(engine, openCalculator);
  /** @param {import('nctape').Format} format */
  const change = (format) => changeFormat(editor, format);
  const formatPanel = makeFormatPanel({ store, engine, text: () => editor.state.doc, change, openCalculator });
  makeOffer({ store, engine, suggest: () => formatPanel.suggest() });
  makeStrip({ store, engine, kinds, onRow: (offset) => (store.state.kind === 'cldata' ? void goToPosted(offset) : moveCursor(editor, offset, 'tape')) });
  const problems = makeProblems({ store, engine, deeds, textLength: () => editor.state.doc.length, cursor: () => editor.state.selection.main.from });
  makePlot({ store, engine, kinds, onBlock: (offset) => moveCursor(editor, offset, 'path') });
  makeRegisters(store);
  showOtherAxes(store, engine);
  showCldata({
    store,
    engine,
    kinds,
    // What is wrong with that tape is mended in the CLDATA, or in the format.
    card: (diagnostic) => problemCard({ ...diagnostic, fixes: [], related: [] }, deeds),
    onPlace: (offset) => void goToPosted(offset),
    open(source, cursor) {
      header.welcome('Tape that was CLDATA');
      replaceAll(editor, { source, format: currentFormat(editor), cursor, kind: 'tape' });
      if (layout.narrow()) layout.showTab('program');
      editor.focus();
    },
    async goTo(record) {
      const block = await engine.ask('block', record);
      if (block) moveCursor(editor, block.from, 'path');
    },
  });
  makeKindSwitch({ store, turn: header.turn });
  const replay = makeReplay({ store, engine, onPlace: (offset) => moveCursor(editor, offset, 'replay') });
  makeReplayControls({ store, replay });
  makeTimeline({ store, kinds, replay });
  makeDecimals({
    store,
    engine,
    attempt: (format) => tryFormat(editor, format),
    keep: (began) => keepFormat(editor, began),
  });
  makeSkip({ store, engine, cursor: head });
  makeTotals({ store, engine, kinds, openFormat: (field) => void formatPanel.openAt(field), show: deeds.show });
  makeName({
    store,
    engine,
    beginning: async (characters) =>
      store.state.kind === 'tape' ? editor.state.sliceDoc(0, characters) : (await listing()).slice(0, characters),
  });
  makeFiles({
    store,
    engine,
    source: () => editor.state.doc.toString(),
    listing,
    load(tape) {
      header.keep();
      replaceAll(editor, tape);
      toSight = true;
    },
    show: deeds.show,
    openRule: deeds.openRule,
  });
  byId('tab-key', HTMLElement).addEventListener('click', () => {
    insertTab(editor);
    editor.focus();
  });

  engine.foresee(() => [['listing', ...marksWanted()]]);
  store.on(['summary'], () => void refreshMarks());
  store.on(['here', 'chosen'], ({ here, chosen }) => light(editor, { block: here?.block ?? null, chosen }));

  /** @param {ViewUpdate} update */
  function onUpdate(update) {
    const by = update.transactions.map((one) => one.annotation(movedBy));
    if (by.includes('replay') || by.includes('posted')) return;
    const format = currentFormat(update.view);
    const isNewFormat = format !== store.state.format;
    const kind = currentKind(update.view);
    const isNewKind = kind !== store.state.kind;
    if (update.docChanged || update.selectionSet || isNewFormat) replay.handOver(update.docChanged || isNewFormat);
    if (update.docChanged) noteEdit(update);
    if (isNewFormat || isNewKind) store.set({ format, kind });
    if (update.docChanged || isNewFormat || isNewKind) keepDraft();
    if (isNewKind) {
      replaced = true;
      engine.reopen();
    } else if (update.docChanged || isNewFormat) {
      engine.alter({
        changes: update.docChanged ? update.changes : undefined,
        format: isNewFormat ? format : undefined,
        offset: head(),
      });
    } else if (update.selectionSet) {
      if (!by.includes('problems')) store.set({ chosen: null });
      void locate();
    }
  }

  /** @param {ViewUpdate} update */
  function noteEdit({ changes, startState, state, transactions }) {
    changes.iterChangedRanges((from, to) => {
      if (from > 0 || to < startState.doc.length * 0.9) return;
      replaced = true;
      toSight = transactions.some((one) => one.isUserEvent('input.paste'));
    });
    problems.move(changes);
    const byHand = !transactions.some((one) => one.isUserEvent('input.replace'));
    header.name((source) => source.length === state.doc.length && source === state.doc.toString(), byHand);
  }

  /** The tape as it stands, with all that opens it again. */
  function whole() {
    return { source: editor.state.doc.toString(), format: currentFormat(editor), cursor: head(), kind: currentKind(editor) };
  }

  /** Puts the cursor where there is something to be seen. */
  async function goToSight() {
    const { doc } = editor.state;
    const offset = await engine.ask('sight');
    if (offset !== undefined && editor.state.doc === doc) moveCursor(editor, offset, 'paste');
  }

  /** The listing of the tape: the text, or what the CLDATA became. */
  async function listing() {
    if (store.state.kind === 'tape') return editor.state.doc.toString();
    return (await engine.ask('posted', 0))?.text ?? '';
  }

  /**
   * A hand went to a place of the tape that the CLDATA became: the record that it came from is lit with it.
   * @param {number} at
   */
  async function goToPosted(at) {
    const { doc } = editor.state;
    const here = await engine.ask('locatePosted', at);
    if (here === undefined || editor.state.doc !== doc) return;
    if (here.block !== null) moveCursor(editor, here.offset, 'posted');
    store.set({ chosen: null, here: here.block === null ? { ...here, offset: head() } : here });
  }

  async function locate() {
    const offset = head();
    const here = await engine.ask('locate', offset);
    if (here !== undefined && offset === head()) store.set({ here });
  }

  // When the caller has the playground in hand, to which the engine's answer goes.
  queueMicrotask(() => {
    replaceAll(editor, first, { isFirst: true });
    // Who follows a link wants to see what is in it.
    if (beginning.guest === null) {
      makeHints((view) => {
        if (layout.narrow()) layout.showTab(view === 'plot' ? 'path' : 'program');
      });
    }
  });

  return {
    current: () => ({ source: editor.state.doc.toString(), format: currentFormat(editor), kind: currentKind(editor), skip: store.state.skip, offset: head() }),
    changed({ summary, here }) {
      store.set({ summary, here, whole: replaced });
      if (toSight) void goToSight();
      replaced = toSight = false;
      // The cursor may have moved on while the engine was reading.
      if (here.offset !== head()) void locate();
    },
  };
}

/**
 * The views of CLDATA, fetched when it is opened first.
 * @param {Parameters<typeof import('./cldata/views.js').makeCldataViews>[0]} parts
 */
function showCldata(parts) {
  let asked = false;
  parts.store.on(['kind'], async ({ kind }) => {
    if (asked || kind !== 'cldata') return;
    asked = true;
    const { makeCldataViews } = await import('./cldata/views.js');
    makeCldataViews(parts);
  });
}

/**
 * The chart of the axes beyond X, Y and Z, fetched for the first tape that has some.
 * @param {import('./store.js').Store} store
 * @param {import('./engine.js').Engine} engine
 */
function showOtherAxes(store, engine) {
  let asked = false;
  store.on(['summary'], async ({ summary }) => {
    if (asked || summary === null || summary.axes.length <= 3) return;
    asked = true;
    const { makeAxesChart } = await import('./plot/axes-chart.js');
    makeAxesChart({ host: byId('axes-chart', HTMLElement), store, engine });
  });
}
