// The tape under the reader head.
import { byId, lessMotion, onceAFrame } from '../dom.js';
import { mono, palette } from '../palette.js';
import { timed } from '../timing.js';
import { listed, whole } from '../words.js';
import { drawStrip, stripHeight } from './draw.js';
import { Glyphs } from './glyphs.js';
import { listenToHand } from './input.js';
import { makeRowCard } from './row-card.js';
import { SheetSource } from './sheet.js';
import { WINDOW, Windows } from './windows.js';

/** @typedef {import('../store.js').Store} Store */
/** @typedef {import('../engine.js').Engine} Engine */

/** How long the tape takes to a place near by, in milliseconds; a far one is there at once. */
const GLIDE = 180;
const NEAR = 400;
/** While the hand moves the tape, the other views follow once in so many milliseconds: the tape itself keeps up. */
const FOLLOW = 60;

/**
 * @param {object} parts
 * @param {Store} parts.store
 * @param {Engine} parts.engine
 * @param {string[]} parts.kinds
 * @param {(offset: number) => void} parts.onRow  the hand brought this character to the head
 */
export function makeStrip({ store, engine, kinds, onRow }) {
  const strip = byId('strip', HTMLElement);
  const canvas = byId('strip-canvas', HTMLCanvasElement);
  const words = byId('tape-words', HTMLElement);
  const scrub = byId('tape-scrub', HTMLInputElement);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));

  /** @type {import('nctape').RowMeaning[] | null} */
  let meanings = null;
  let meaningsOf = '';
  let position = 0;
  /** Where the hand wants the tape before its row has come. @type {number | null} */
  let wanted = null;
  let held = false;
  /** The row of the leader at the head, which no character of the program has. @type {number | null} */
  let inLeader = null;
  /** The character that was told last: its answer may come when the hand is in the leader already. */
  let told = -1;
  let ratio = 1;
  /** CSS pixels of a row. */
  let pitch = 14;

  const glyphs = new Glyphs();
  const redraw = onceAFrame(draw);
  const windows = new Windows((first, count) => engine.ask('strip', first, count), () => {
    tellRow();
    redraw();
  });
  const sheets = new SheetSource((size, theme) => engine.fact('columns', size, theme), ({ bench }) => {
    // The page paints what surrounds the picture with the same bench.
    document.documentElement.style.setProperty('--bench', bench);
    redraw();
  });

  const rows = () => store.state.summary?.rows ?? 0;
  /** The letters in the leader stand before the first row. @param {number} row */
  const inTape = (row) => Math.max(-store.state.leader.length, Math.min(row, rows() - 1));

  function measure() {
    ratio = window.devicePixelRatio || 1;
    const wide = matchMedia('(min-width: 1000px)').matches;
    const device = Math.max(4, Math.round((wide ? 14 : 11) * ratio));
    pitch = device / ratio;
    const height = stripHeight(pitch);
    const width = strip.clientWidth;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.width = `${canvas.width / ratio}px`;
    canvas.style.height = `${canvas.height / ratio}px`;
    void sheets.want(device, store.state.theme);
    redraw();
  }

  /** The first and the last row that are to be seen, and some beside them. @returns {[number, number]} */
  function inSight() {
    const half = canvas.width / ratio / pitch / 2 + 16;
    return [Math.floor(position - half), Math.min(rows() - 1, Math.ceil(position + half))];
  }
  engine.foresee(() => [...windows.around(...inSight())].map((index) => ['strip', index * WINDOW, WINDOW]));

  function draw() {
    const { sheet } = sheets;
    if (sheet === null || meanings === null || store.state.summary === null) return;
    windows.want(...inSight());
    const block = store.state.here?.block ?? null;
    const picture = {
      sheet,
      windows,
      meanings,
      kinds,
      colours: palette(store.state.theme),
      font: mono(),
      glyphs,
      rows: rows(),
      leader: store.state.leader,
      position,
      lit: block === null ? null : block.rows,
      ratio,
    };
    timed('nctape.strip', () => drawStrip(context, picture));
  }

  /** The character under the head, told once its row is here. */
  function tellRow() {
    if (wanted === null || !windows.isFresh(wanted)) return;
    const known = windows.row(wanted);
    wanted = null;
    if (known === null) return;
    told = known.offset;
    onRow(known.offset);
  }

  /** @param {number} row */
  function reach(row) {
    const reached = inTape(Math.round(row));
    inLeader = reached < 0 ? reached : null;
    if (inLeader !== null) {
      wanted = null;
      describe();
      return;
    }
    wanted = reached;
    windows.want(wanted, wanted);
    tellRow();
  }

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let following;
  let followed = 0;
  /** Tells where the tape is, while the hand moves it. */
  function follow() {
    if (following !== undefined) return;
    const pause = Math.max(0, followed + FOLLOW - performance.now());
    following = setTimeout(() => {
      following = undefined;
      followed = performance.now();
      reach(position);
    }, pause);
  }
  /** The hand has let go: where the tape is meant to be is told by whoever moves it there. */
  function letGo() {
    clearTimeout(following);
    following = undefined;
    held = false;
  }

  let glide = 0;
  /** @param {number} row */
  function glideTo(row) {
    cancelAnimationFrame(glide);
    const start = position;
    const way = row - start;
    if (way === 0 || lessMotion() || Math.abs(way) > NEAR) {
      position = row;
      redraw();
      return;
    }
    /** @type {number | null} */
    let began = null;
    const step = (/** @type {number} */ now) => {
      began ??= now;
      const share = Math.min(1, (now - began) / GLIDE);
      position = start + way * (1 - (1 - share) ** 3);
      draw();
      if (share < 1) glide = requestAnimationFrame(step);
    };
    glide = requestAnimationFrame(step);
  }

  listenToHand(strip, {
    pitch: () => pitch,
    position: () => position,
    rows,
    slide(row) {
      cancelAnimationFrame(glide);
      held = true;
      position = inTape(row);
      follow();
      redraw();
    },
    settle(row) {
      letGo();
      reach(row);
      glideTo(inTape(Math.round(row)));
    },
    go(row) {
      letGo();
      glideTo(inTape(row));
      reach(row);
    },
    async goToBlock(direction) {
      const row = Math.round(position);
      const found = await engine.ask('blockBeside', row, direction);
      if (found === undefined) return;
      this.go(found ?? (direction < 0 ? 0 : Math.max(row, rows() - 1)));
    },
  });

  const card = makeRowCard({
    store,
    engine,
    strip,
    headX: () => strip.getBoundingClientRect().left + strip.clientWidth / 2,
    /** What lies under a place of the screen. */
    at(x) {
      const { summary, leader } = store.state;
      const box = strip.getBoundingClientRect();
      const row = Math.round(position + (x - box.left - box.width / 2) / pitch);
      if (summary === null || row >= summary.rows || row < -leader.length) return null;
      if (row < 0) return { byte: leader[leader.length + row], place: 'Letters in the leader' };
      const known = windows.row(row);
      return known && { byte: known.byte, place: placeWords(row, summary.rows, windows.name(known.block)) };
    },
  });

  scrub.addEventListener('input', () => {
    position = inTape(Number(scrub.value));
    reach(position);
    redraw();
  });

  store.on(['summary'], async ({ summary }) => {
    windows.expire();
    wanted = null;
    position = inTape(position);
    windows.want(...inSight());
    redraw();
    if (summary !== null && summary.code !== meaningsOf) {
      meaningsOf = summary.code;
      meanings = await engine.fact('codeTable', summary.code);
      describe();
      redraw();
    }
  });
  store.on(['moment'], ({ moment }) => {
    if (!moment?.running || held) return;
    cancelAnimationFrame(glide);
    inLeader = null;
    const before = Math.round(position);
    position = inTape(moment.row);
    if (Math.round(position) !== before) describe();
    redraw();
  });
  store.on(['here'], ({ here, moment }) => {
    if (inLeader !== null && (here?.posted?.at ?? here?.offset) === told) return;
    inLeader = null;
    told = -1;
    if (moment?.running) redraw();
    else if (here !== null && here.row >= 0 && !held && wanted === null) glideTo(inTape(here.row));
    else if (here !== null && here.row < 0 && rows() > 0 && wanted === null) glideTo(rows() - 1);
    describe();
    redraw();
  });
  store.on(['theme'], measure);
  store.on(['leader'], ({ leader }) => {
    scrub.min = String(-leader.length);
    // The letter that was punched last comes under the head.
    let last = leader.length - 1;
    while (last >= 0 && leader[last] === 0) last -= 1;
    if (last >= 0) {
      inLeader = last - leader.length;
      wanted = null;
      glideTo(inLeader);
    } else {
      inLeader = null;
      glideTo(inTape(store.state.here?.row ?? 0));
    }
    describe();
    redraw();
  });

  function describe() {
    const { here, moment, summary, leader } = store.state;
    if (here === null || summary === null || meanings === null) return;
    if (inLeader !== null) {
      const said = `Leader, row ${leader.length + inLeader + 1} of ${leader.length} · ${holesOf(meanings[leader[leader.length + inLeader]].tracks)}`;
      words.textContent = said;
      strip.setAttribute('aria-valuetext', said);
      scrub.value = String(inLeader);
      card.showHead(leader[leader.length + inLeader], 'Letters in the leader');
      return;
    }
    const running = moment?.running === true;
    const row = running ? inTape(Math.round(moment.row)) : here.row < 0 ? Math.max(0, summary.rows - 1) : here.row;
    strip.setAttribute('aria-valuemax', String(Math.max(1, summary.rows)));
    if (!running) strip.setAttribute('aria-valuenow', String(row + 1));
    scrub.max = String(Math.max(0, summary.rows - 1));
    scrub.value = String(row);
    windows.want(row, row);
    const known = summary.rows > 0 ? windows.row(row) : null;
    if (summary.rows === 0) words.textContent = 'The tape is empty.';
    if (known === null) {
      if (summary.rows === 0) strip.setAttribute('aria-valuetext', 'The tape is empty.');
      return;
    }
    // Of CLDATA the cursor is on a record, and the row is of a block that it became.
    const block = here.posted === undefined ? (here.block?.sequence ?? null) : windows.name(known.block);
    words.textContent = rowWords(row, summary.rows, block, meanings[known.byte]);
    card.showHead(known.byte, placeWords(row, summary.rows, block));
    // For the ear the rows that run by would be a chatter.
    if (running) return;
    strip.setAttribute('aria-valuetext', spokenRow(row, summary.rows, block, meanings[known.byte]));
  }
  const arrived = windows.onArrival;
  windows.onArrival = () => {
    arrived();
    describe();
  };

  new ResizeObserver(measure).observe(strip);
  watchRatio(measure);
  return { focus: () => strip.focus() };
}

/**
 * A character is called by itself, and one that is not printed by its name.
 * @param {string} label
 * @param {string} name
 */
const called = (label, name) => (label.length === 1 ? label : name);

/**
 * "Row 152 of 358 · N006"
 * @param {number} row
 * @param {number} rows
 * @param {string | null} block
 */
const placeWords = (row, rows, block) => `Row ${whole(row + 1)} of ${whole(rows)}${block === null ? '' : ` · ${block}`}`;

/**
 * "tracks 1 2 3 7"
 * @param {number[]} tracks
 */
const holesOf = (tracks) => (tracks.length === 0 ? 'no hole' : `${tracks.length === 1 ? 'track' : 'tracks'} ${tracks.join(' ')}`);

/**
 * "Row 152 of 358 · N006 · G · tracks 1 2 3 7"
 * @param {number} row
 * @param {number} rows
 * @param {string | null} block
 * @param {import('nctape').RowMeaning} meaning
 */
function rowWords(row, rows, block, { label, name, tracks, parity }) {
  const parts = [placeWords(row, rows, block), called(label, name), holesOf(tracks), parity ? '' : 'wrong parity'];
  return parts.filter((part) => part !== '').join(' · ');
}

/**
 * The same for the ear: "Row 152, block N006, character G, holes in tracks 1, 2, 3 and 7".
 * @param {number} row
 * @param {number} rows
 * @param {string | null} block
 * @param {import('nctape').RowMeaning} meaning
 */
function spokenRow(row, rows, block, { label, name, tracks, parity }) {
  const holes =
    tracks.length === 0 ? 'no hole' : `${tracks.length === 1 ? 'a hole in track' : 'holes in tracks'} ${listed(tracks)}`;
  const parts = [`Row ${row + 1} of ${rows}`, block === null ? '' : `block ${block}`, `character ${called(label, name)}`, holes, parity ? '' : 'wrong parity'];
  return parts.filter((part) => part !== '').join(', ');
}

/**
 * Calls when the page moves to a screen of another density, or is zoomed.
 * @param {() => void} run
 */
function watchRatio(run) {
  const query = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
  query.addEventListener('change', () => {
    run();
    watchRatio(run);
  }, { once: true });
}
