// The tape at work: where it stands, what moves it, and what all views are told of it.
import { lessMotion, whenQuiet } from '../dom.js';
import { makeClock } from './clock.js';
import { Stretches, STRETCH } from './stretches.js';
import { Track } from './track.js';

/** @typedef {import('./track.js').At} At */
/** @typedef {import('../store.js').Here} Here */

/**
 * Where the tape stands at this moment.
 * @typedef {object} Moment
 * @property {number} block
 * @property {number} share  of the block that is done, 0 to 1
 * @property {number} row  under the head, with its fraction
 * @property {number} seconds  since the start of the tape
 * @property {number} span  that the tool is on, -1 without a path
 * @property {number} along  share of the span that is behind the tool
 * @property {boolean} led  the replay brought it here; else what the cursor is on
 * @property {boolean} running  it moves now: the tape follows at once
 */

/** The course and the registers of a changed tape are asked for when the typing pauses for so many milliseconds. */
const PAUSE = 300;
/** Where nothing may move by itself, each block is seen for so many milliseconds at least. */
const SEEN = 400;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {(offset: number) => void} parts.onPlace  the replay came to this character
 */
export function makeReplay({ store, engine, onPlace }) {
  /** @type {Track | null} */
  let track = null;
  /** The tape has changed since. */
  let stale = true;
  /** @type {At} */
  let at = { block: 0, share: 0 };
  let led = false;
  /** The place that all views were sent to from here. @type {Here | null} */
  let mine = null;
  let asking = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let seen;
  const stretches = new Stretches((first, count) => engine.ask('stretch', first, count));
  const clock = makeClock((seconds) => advance(seconds * store.state.speed));

  /**
   * Tells all views where the tape stands.
   * @param {boolean} running
   */
  function show(running) {
    if (track === null) return;
    if (track.blocks === 0) {
      store.set({ moment: null, held: null, heldBlock: null });
      return;
    }
    const { span, along } = track.toolAt(at);
    store.set({ moment: { ...at, row: track.rowOf(at), seconds: track.timeOf(at), span, along, led, running } });
    void follow();
  }

  /** Brings text, problems and registers to the block: at once where it is known, else when it is here. */
  async function follow() {
    if (asking) return;
    asking = true;
    let known = stretches.block(at.block);
    // Where the typing has paused one block is enough; a cursor that goes on from there wants its neighbours too.
    const many = led || stretches.single !== null;
    while (known === null && (await (many ? stretches.fetch(at.block) : stretches.fetchSingle(at.block)))) {
      known = stretches.block(at.block);
    }
    asking = false;
    if (known === null || stale || track === null) return;
    if (led) place(track, known);
    store.set({ held: known.held, heldBlock: known.block });
    const next = at.block + STRETCH / 2;
    if (store.state.playing && next < track.blocks) void stretches.fetch(next);
  }

  /**
   * @param {Track} track
   * @param {NonNullable<ReturnType<Stretches['block']>>} known
   */
  function place(track, { block, span, stretch }) {
    const running = store.state.moment?.running === true;
    const row = Math.round(track.rowOf(at));
    const { here } = store.state;
    if (here === mine && here?.block?.index === block.index && (running || here.row === row)) return;
    const offset = running ? block.from : (stretch.offsets[row - stretch.firstRow] ?? block.from);
    mine = { offset, row, block, span };
    store.set({ here: mine });
    onPlace(offset);
  }

  /** @param {number} seconds */
  function advance(seconds) {
    if (track === null) return;
    const next = track.advance(at, seconds, store.state.single);
    at = next.at;
    if (next.stopped) halt(at.block);
    else show(true);
  }

  /** Without motion: each block is done at once, and seen for a while. */
  function hop() {
    if (track === null) return;
    at = { block: at.block, share: 1 };
    if (track.waitsBehind(at.block, store.state.single)) {
      halt(at.block);
      return;
    }
    show(false);
    const seconds = track.course.seconds[at.block] / store.state.speed;
    seen = setTimeout(() => {
      at = { block: at.block + 1, share: 0 };
      hop();
    }, Math.max(SEEN, Math.min(seconds * 1000, 2 ** 31 - 1)));
  }

  /** The course as it is now, asked for at once where the typing has not paused yet; null without a block. */
  async function courseNow() {
    if (stale) await refresh();
    return stale || track === null || track.blocks === 0 ? null : track;
  }

  async function play() {
    const course = await courseNow();
    if (course === null || store.state.playing) return;
    at = course.begin(at);
    led = true;
    store.set({ playing: true, halted: null });
    if (lessMotion()) hop();
    else clock.start();
  }

  function rest() {
    clock.stop();
    clearTimeout(seen);
    store.set({ playing: false });
  }

  function pause() {
    if (!store.state.playing) return;
    rest();
    show(false);
  }

  /**
   * The control waits behind a block.
   * @param {number} block
   */
  function halt(block) {
    rest();
    store.set({ halted: block });
    show(false);
  }

  /**
   * The hand moves it.
   * @param {(track: Track) => At} where
   * @param {boolean} [running]  the hand goes on
   */
  async function go(where, running = false) {
    const course = await courseNow();
    if (course === null) return;
    if (store.state.playing) rest();
    at = where(course);
    led = true;
    store.set({ halted: null });
    show(running);
  }

  /**
   * Another view has gone to a place: the replay stands there.
   * @param {Here} here
   */
  function takeOver(here) {
    if (track === null || stale) return;
    if (store.state.playing) rest();
    led = false;
    at = track.atRow(here.row < 0 ? Infinity : here.row);
    store.set({ halted: null });
    show(false);
  }

  /**
   * The hand is on the program: nothing moves the cursor away from it.
   * @param {boolean} edited
   */
  function handOver(edited) {
    if (store.state.playing) rest();
    stale ||= edited;
    const { moment } = store.state;
    if (moment?.running) store.set({ moment: { ...moment, running: false } });
  }

  async function refresh() {
    // CLDATA has no rows to run through the head: what it became is replayed when it is opened as a tape.
    const course = store.state.kind === 'tape' ? await engine.ask('course') : null;
    if (course === undefined) return;
    if (course === null || store.state.kind !== 'tape') {
      track = null;
      store.set({ track, moment: null, held: null, heldBlock: null });
      return;
    }
    track = new Track(course);
    stale = false;
    store.set({ track });
    const { here } = store.state;
    if (here !== null) takeOver(here);
  }
  const refreshLater = whenQuiet(() => void refresh(), PAUSE);

  store.on(['summary'], ({ summary }) => {
    if (store.state.playing) rest();
    stale = true;
    stretches.expire();
    if (store.state.whole) void refresh();
    else refreshLater();
  });
  store.on(['here'], ({ here }) => {
    if (here !== null && here !== mine) takeOver(here);
  });

  return {
    handOver,
    play,
    pause,
    toggle: () => (store.state.playing ? pause() : void play()),
    /** @param {1 | -1} way */
    byBlock: (way) => go((track) => track.byBlock(at, way)),
    /** @param {1 | -1} way */
    bySpan: (way) => go((track) => track.bySpan(at, way)),
    /** @param {1 | -1} way */
    byRow: (way) => go((track) => track.byRow(at, way)),
    /** @param {number} seconds @param {boolean} running */
    toTime: (seconds, running) => go((track) => track.atTime(seconds), running),
    toStart: () => go(() => ({ block: 0, share: 0 })),
    toEnd: () => go((track) => ({ block: track.blocks - 1, share: 1 })),
  };
}

/** @typedef {ReturnType<typeof makeReplay>} Replay */
