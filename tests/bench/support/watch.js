// What is noted inside a page while it is measured. All times are milliseconds since the epoch, so that those of the
// page, of its worker and of its keys can be put beside one another.

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Worker} Worker */
/** @typedef {{ name: string, from: number, to: number }} Measure */

/**
 * @typedef {object} Notes
 * @property {number[]} keys  when each key was pressed
 * @property {number[]} typed  when the text of the editor changed
 * @property {number[]} frames  when each frame began
 * @property {number[]} painted  when it was painted
 * @property {Measure[]} measures
 */

/**
 * @typedef {Notes & { run: (on: boolean) => void, watchEditor: () => void, clear: () => void }} Watch
 */

/** Installed before the page's own scripts. */
export function watchPage() {
  const origin = performance.timeOrigin;
  /** @type {Watch} */
  const watch = {
    keys: [],
    typed: [],
    frames: [],
    painted: [],
    measures: [],
    run(on) {
      if (on && !running) requestAnimationFrame(frame);
      running = on;
    },
    watchEditor() {
      const text = document.getElementById('editor')?.shadowRoot?.querySelector('.cm-content');
      if (!text) throw new Error('the page has no editor');
      const observer = new MutationObserver(() => watch.typed.push(origin + performance.now()));
      observer.observe(text, { childList: true, characterData: true, subtree: true });
    },
    clear() {
      for (const list of [watch.keys, watch.typed, watch.frames, watch.painted, watch.measures]) list.length = 0;
    },
  };
  let running = false;
  // A message that is sent within a frame arrives when that frame is painted.
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => watch.painted.push(origin + performance.now());
  /** @param {number} time */
  function frame(time) {
    watch.frames.push(origin + time);
    port2.postMessage(null);
    if (running) requestAnimationFrame(frame);
  }
  addEventListener('keydown', ({ timeStamp }) => watch.keys.push(origin + timeStamp), true);
  new PerformanceObserver((list) => {
    for (const { name, startTime, duration } of list.getEntries()) {
      watch.measures.push({ name, from: origin + startTime, to: origin + startTime + duration });
    }
  }).observe({ type: 'measure' });
  Object.assign(window, { watch });
}

/**
 * Notes what the worker measures of itself.
 * @param {Page} page
 * @returns {Promise<Worker>}
 */
export async function watchWorker(page) {
  const worker = page.workers()[0];
  if (worker === undefined) throw new Error('the page has no worker');
  await worker.evaluate(() => {
    /** @type {Measure[]} */
    const measures = [];
    const origin = performance.timeOrigin;
    new PerformanceObserver((list) => {
      for (const { name, startTime, duration } of list.getEntries()) {
        measures.push({ name, from: origin + startTime, to: origin + startTime + duration });
      }
    }).observe({ type: 'measure' });
    Object.assign(self, { measures });
  });
  return worker;
}

/**
 * What the worker measured since it was asked last.
 * @param {Worker} worker
 * @returns {Promise<Measure[]>}
 */
export const workerMeasures = (worker) =>
  worker.evaluate(() => /** @type {{ measures: Measure[] }} */ (/** @type {unknown} */ (self)).measures.splice(0));

/**
 * What was noted in the page, which begins anew.
 * @param {Page} page
 * @returns {Promise<Notes>}
 */
export const notes = (page) =>
  page.evaluate(() => {
    const { watch } = /** @type {{ watch: Watch }} */ (/** @type {unknown} */ (window));
    const { keys, typed, frames, painted, measures } = watch;
    const copy = structuredClone({ keys, typed, frames, painted, measures });
    watch.clear();
    return copy;
  });

/**
 * Frames are noted, or no longer.
 * @param {Page} page
 * @param {boolean} on
 */
export const runFrames = (page, on) =>
  page.evaluate((run) => /** @type {{ watch: Watch }} */ (/** @type {unknown} */ (window)).watch.run(run), on);

/** @param {Page} page */
export const watchEditor = (page) =>
  page.evaluate(() => /** @type {{ watch: Watch }} */ (/** @type {unknown} */ (window)).watch.watchEditor());

/**
 * Until the text has changed, all that is wanted was measured, and nothing has happened for a while.
 * @param {Page} page
 * @param {string[]} wanted
 */
export async function settled(page, wanted) {
  await page.waitForFunction(
    ({ names, quiet }) => {
      const { watch } = /** @type {{ watch: Watch }} */ (/** @type {unknown} */ (window));
      const last = Math.max(watch.typed.at(-1) ?? Infinity, watch.measures.at(-1)?.to ?? 0);
      const done = names.every((name) => watch.measures.some((measure) => measure.name === name));
      return done && performance.timeOrigin + performance.now() - last > quiet;
    },
    // Longer than an answer takes to be drawn, shorter than the pause after which the list of problems is made anew.
    { names: wanted, quiet: 150 },
    { polling: 20, timeout: 120_000 },
  );
}
