// Play, steps, speed and the single-block switch.
import { button, byId, el } from '../dom.js';
import { blockName } from '../plot/words.js';

/** @typedef {import('../store.js').Store} Store */

/** Seconds of the machine for one of the clock. @type {[number, string][]} */
const SPEEDS = [[0.25, '¼ ×'], [1, '1 ×'], [4, '4 ×'], [16, '16 ×'], [64, '64 ×']];

/**
 * @param {object} parts
 * @param {Store} parts.store
 * @param {import('./replay.js').Replay} parts.replay
 */
export function makeReplayControls({ store, replay }) {
  const play = button('play', '', replay.toggle, { id: 'play' });
  const [playIcon, pauseIcon] = [icon('M4 2.2v11.6L14 8z'), icon('M3.5 2.5h3.2v11H3.5zM9.3 2.5h3.2v11H9.3z')];

  /** @param {string} name @param {(way: 1 | -1) => void} step */
  const steps = (name, step) =>
    el(
      'div',
      { class: 'steps', role: 'group', 'aria-label': `Step by ${name}` },
      button('step', '‹', () => step(-1), { 'aria-label': `Back by one ${name}`, title: `Back by one ${name}` }),
      el('span', { class: 'step-name', 'aria-hidden': 'true' }, name),
      button('step', '›', () => step(1), { 'aria-label': `On by one ${name}`, title: `On by one ${name}` }),
    );

  const speed = el(
    'select',
    { id: 'speed', 'aria-label': 'Speed of the replay', title: 'Speed: seconds of the machine in one second' },
    ...SPEEDS.map(([value, words]) => el('option', { value }, words)),
  );
  speed.value = String(store.state.speed);
  speed.addEventListener('change', () => store.set({ speed: Number(speed.value) }));

  const single = el('input', { type: 'checkbox', role: 'switch', id: 'single' });
  single.addEventListener('change', () => store.set({ single: single.checked }));

  const note = el('p', { class: 'replay-note', id: 'replay-note', role: 'status' });
  byId('replay', HTMLElement).append(
    play,
    el('div', { class: 'timeline', id: 'timeline' }),
    el(
      'div',
      { class: 'replay-more' },
      steps('block', replay.byBlock),
      steps('span', replay.bySpan),
      steps('row', replay.byRow),
      speed,
      el('label', { class: 'switch', title: 'On, play stops behind every block' }, single, ' Single block'),
      note,
    ),
  );

  function tellPlaying() {
    const { playing } = store.state;
    play.replaceChildren(playing ? pauseIcon : playIcon);
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    play.title = `${playing ? 'Pause' : 'Play'} (Space on the tape, the path or the timeline)`;
  }

  /** Why it stands still, or else what is assumed. */
  function tellNote() {
    const { halted, here, held, track, playing } = store.state;
    let words = track?.course.note ?? '';
    if (halted !== null && !playing && held?.block === halted && here?.block?.index === halted) {
      const why = held.stop === null ? '' : `: ${held.stop.code} ${held.stop.meaning}`;
      words = `Stopped behind ${blockName(here.block)}${why}`;
    }
    if (note.textContent === words) return;
    note.textContent = words;
    note.title = words;
  }

  for (const id of ['strip', 'plot-canvas', 'timeline']) {
    byId(id, HTMLElement).addEventListener('keydown', (event) => {
      if (event.key !== ' ' || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      if (!event.repeat) replay.toggle();
    });
  }

  store.on(['playing'], tellPlaying);
  store.on(['halted', 'held', 'here', 'track', 'playing'], tellNote);
  tellPlaying();
}

/** @param {string} shape */
function icon(shape) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', shape);
  svg.append(path);
  return svg;
}
