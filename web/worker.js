// The worker owns the wasm and the one live tape. It answers in the order in which it is asked; what came in one
// message is answered in one.
import * as nctape from 'nctape';
import { CldataSource, cldataQuestions } from './cldata/source.js';
import { tapePicture } from './files/tape-picture.js';
import { questions } from './questions.js';
import { timed } from './timing.js';

/** @typedef {{ summary: import('./store.js').Summary, here: import('./store.js').Here }} Change */

/** @type {nctape.Tape | CldataSource | null} */
let open = null;

const openOrThrow = () => {
  if (open === null) throw new Error('nothing is open');
  return open;
};

/**
 * @param {nctape.Tape | CldataSource} on
 * @param {number} offset  of the cursor, which every change moves
 * @returns {Change}
 */
const changed = (on, offset) => ({
  summary: on.summary(),
  here: on instanceof CldataSource ? cldataQuestions.locate(on, offset) : questions.locate(on, offset),
});

/** What changes the tape or the CLDATA. Each answers with the counts and the place of the cursor after it. */
const changes = {
  /**
   * @param {string} source
   * @param {import('nctape').Format} format
   * @param {import('nctape').SourceKind} kind
   * @param {boolean} skip
   * @param {number} offset
   */
  open(source, format, kind, skip, offset) {
    const next = kind === 'cldata' ? new CldataSource(source, format) : new nctape.Tape(source, format, { skip });
    open?.free();
    open = next;
    return changed(open, offset);
  },
  /**
   * @param {[from: number, to: number, insert: string][]} edits  from the last one to the first
   * @param {import('nctape').Format | null} format  null: as it was
   * @param {boolean | null} skip  null: as it was
   * @param {number} offset
   */
  alter(edits, format, skip, offset) {
    const on = openOrThrow();
    if (on instanceof CldataSource) {
      on.alter(edits, format);
      return changed(on, offset);
    }
    for (const [from, to, insert] of edits) on.edit(from, to, insert);
    if (format !== null) on.setFormat(format);
    if (skip !== null) on.setSkip(skip);
    return changed(on, offset);
  },
};

/** What the package knows without a tape. */
const facts = {
  version: nctape.version,
  presets: nctape.presets,
  rules: nctape.rules,
  standards: nctape.standards,
  spanKinds: nctape.spanKinds,
  codeTable: nctape.codeTable,
  formatFields: nctape.formatFields,
  formatLine: nctape.formatLine,
  explainFormat: nctape.explainFormat,
  suggestFormat: nctape.suggestFormat,
  decimalPlaces: nctape.decimalPlaces,
  shiftDecimals: nctape.shiftDecimals,
  lettering: nctape.lettering,
  letteringNote: nctape.letteringNote,
  aboutCodes: nctape.aboutCodes,
  functions: nctape.functions,
  rowWords: nctape.rowWords,
  readerSpeed: nctape.readerSpeed,
  whyUntimed: nctape.whyUntimed,
  speedCodes: nctape.speedCodes,
  speedOf: nctape.speedOf,
  onMachineOf: nctape.onMachineOf,
  openFile: nctape.openFile,
  encode: nctape.encode,
  check: nctape.check,
  tapeDrawing: nctape.tapeDrawing,
  toDecimal: nctape.toDecimal,
  tapePicture,
  /**
   * The report on CLDATA, with what was found when it was posted to a format.
   * @param {string} source
   * @param {import('nctape').Format} format
   * @param {number} limit
   */
  checkPosted(source, format, limit) {
    const report = nctape.checkCldata(source, { limit: 0 });
    const cldata = new nctape.Cldata(source, format);
    const diagnostics = cldata.diagnostics(0, source.length, limit);
    const { errors, warnings, infos } = cldata.summary();
    cldata.free();
    return { ...report, diagnostics, suppressed: errors + warnings + infos - diagnostics.length };
  },
  /**
   * The 256 columns of tape as one picture.
   * @param {number} pitch
   * @param {'light' | 'dark'} theme
   */
  async columns(pitch, theme) {
    const { image, ...sizes } = nctape.columns(pitch, theme);
    return { sheet: await createImageBitmap(image), ...sizes };
  },
};

/** @typedef {typeof changes} Changes */
/** @typedef {typeof facts} Facts */
/** @typedef {typeof questions & Omit<typeof cldataQuestions, keyof typeof questions>} Questions */

/** @typedef {{ id: number, about: string, name: string, args: any[] }} Request */

/** @param {Request} request */
function answer({ about, name, args }) {
  if (about === 'change') {
    const change = /** @type {(...args: any[]) => Change} */ (changes[/** @type {keyof Changes} */ (name)]);
    return change(...args);
  }
  if (about === 'tape') {
    const on = openOrThrow();
    const known = /** @type {Record<string, (on: any, ...args: any[]) => unknown>} */ (
      on instanceof CldataSource ? cldataQuestions : questions
    );
    if (name in known) return known[name](on, ...args);
    // What only a tape is asked; and what only CLDATA is, where it is open no longer.
    const asked = /** @type {Record<string, (on: any, ...args: any[]) => unknown>} */ (questions)[name];
    return on instanceof CldataSource ? asked(on.tape, ...args) : undefined;
  }
  return /** @type {(...args: any[]) => unknown} */ (facts[/** @type {keyof Facts} */ (name)])(...args);
}

/**
 * What a refused argument says; everything else that is thrown leaves the wasm in an unknown state.
 * @param {unknown} error
 */
const isRefusal = (error) => error instanceof TypeError && 'field' in error;

/**
 * Answers as soon as the wasm is there.
 * @param {Promise<unknown>} start  of the wasm
 */
export function serve(start) {
  const ready = start.then(
    () => postMessage({ ready: true }),
    (error) => {
      postMessage({ failed: String(error?.message ?? error) });
      throw error;
    },
  );
  ready.catch(() => {});
  onmessage = ({ data }) => void answerAll(ready, data);
}

/**
 * @param {Promise<unknown>} ready
 * @param {Request[]} requests
 */
async function answerAll(ready, requests) {
  try {
    await ready;
  } catch {
    return;
  }
  /** @type {({ id: number, value: unknown } | { id: number, refused: string })[]} */
  const replies = [];
  for (const request of requests) {
    try {
      const value = await timed(`nctape.${request.name}`, () => answer(request));
      replies.push({ id: request.id, value });
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      if (!isRefusal(error)) {
        postMessage({ replies, trap: message });
        return;
      }
      replies.push({ id: request.id, refused: message });
    }
  }
  postMessage({ replies });
}
