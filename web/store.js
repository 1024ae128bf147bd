// What all views show: one object, told to all of them in the same moment.

/**
 * Of CLDATA, the path and the problems are its own, and rows and paper those of the tape that it became.
 * @typedef {import('nctape').Summary & { posted?: { blocks: number, errors: number, warnings: number, incomplete: boolean } }} Summary
 */
/** @typedef {import('nctape').Diagnostic} Diagnostic */
/** @typedef {import('nctape').BlockView & Partial<import('nctape').RecordView>} BlockView  of CLDATA, a record */
/** @typedef {import('nctape').Span} Span */
/** @typedef {import('nctape').Format} Format */

/**
 * What the cursor is on, found in every view by one question to the engine.
 * @typedef {object} Here
 * @property {number} offset
 * @property {number} row  -1 where no row follows
 * @property {BlockView | null} block
 * @property {Span | null} span
 * @property {{ from: number, to: number, at: number }} [posted]  of CLDATA: what the record became, and the place there
 */

/**
 * @typedef {object} State
 * @property {import('nctape').SourceKind} kind  what the text is
 * @property {Format} format
 * @property {import('nctape').FormatExplanation | null} explanation
 * @property {Summary | null} summary  of the newest edit that the engine has answered
 * @property {Here | null} here
 * @property {number | null} pointed  the span under the pointer in the plot
 * @property {{ from: number, to: number } | null} chosen  the range of the problem that was chosen last
 * @property {boolean} whole  the text was replaced as a whole: what is shown may be fitted anew
 * @property {Uint8Array} leader  rows of letters for people before the program; none: none
 * @property {boolean} skip  the optional block skip switch is on
 * @property {'light' | 'dark'} theme
 * @property {import('nctape').Path | null} path  flattened for the picture
 * @property {import('./replay/track.js').Track | null} track  the tape as a line of time
 * @property {import('./replay/replay.js').Moment | null} moment  where the tape stands on it
 * @property {import('nctape').Registers | null} held  what the control holds in the block under the head
 * @property {BlockView | null} heldBlock  that block
 * @property {boolean} playing
 * @property {number | null} halted  the block behind which play stopped by itself
 * @property {number} speed  of the replay, in seconds of the machine for one of the clock
 * @property {boolean} single  play stops behind every block
 */

/**
 * Before anything is known.
 * @param {State['theme']} theme
 * @returns {State}
 */
export const emptyState = (theme) => ({
  kind: 'tape',
  format: { standard: 'iso2539', detail: '' },
  explanation: null,
  summary: null,
  here: null,
  pointed: null,
  chosen: null,
  whole: true,
  leader: new Uint8Array(),
  skip: false,
  theme,
  path: null,
  track: null,
  moment: null,
  held: null,
  heldBlock: null,
  playing: false,
  halted: null,
  speed: 4,
  single: false,
});

export class Store {
  /** @param {State} state */
  constructor(state) {
    this.state = state;
    /** @type {{ keys: (keyof State)[], run: (state: State) => void }[]} */
    this.listeners = [];
  }

  /**
   * Changes some fields and tells everyone who looks at one of them.
   * @param {Partial<State>} patch
   */
  set(patch) {
    const changed = /** @type {(keyof State)[]} */ (Object.keys(patch)).filter(
      (key) => this.state[key] !== patch[key],
    );
    if (changed.length === 0) return;
    this.state = { ...this.state, ...patch };
    for (const { keys, run } of this.listeners) {
      if (keys.some((key) => changed.includes(key))) run(this.state);
    }
  }

  /**
   * @param {(keyof State)[]} keys
   * @param {(state: State) => void} run
   */
  on(keys, run) {
    this.listeners.push({ keys, run });
  }
}
