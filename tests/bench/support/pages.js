// The two pages that are compared, each with the same tape in it.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'vite';
import { paste, quiet, root, visit } from '../../e2e/support/playground.js';
import { serve } from '../../e2e/support/server.js';
import { BEFORE_DIGIT, contour, DETAIL, PRESET } from './tape.js';
import { runFrames, settled, watchEditor, watchPage, watchWorker } from './watch.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../e2e/support/playground.js').Started} Started */

/** What is drawn when the page has answered a change in full. */
export const DRAWN = ['nctape.show', 'nctape.marks', 'nctape.strip', 'nctape.plot'];

/**
 * The playground with a tape of so many blocks, the cursor in the middle of it.
 * @param {Started} started
 * @param {number} blocks
 */
export async function openPlayground(started, blocks) {
  const visited = await visit(started, { before: (page) => page.addInitScript(watchPage) });
  const { page } = visited;
  await page.locator('#preset').selectOption(PRESET);
  await quiet(page);
  await page.locator('#format-button').click();
  await page.locator('#field-detail').fill(DETAIL);
  // One that is never waited for: FEED-15 has nothing to say of the tape.
  await page.locator('#field-itemized-readerSpeed').fill('100000');
  await quiet(page);
  await page.locator('#format-button').click();
  await watchEditor(page);
  await page.evaluate(() => /** @type {any} */ (window).watch.clear());
  await paste(page, contour(blocks));
  await settled(page, DRAWN);
  const tally = await page.locator('#tallies').innerText();
  if (/error|warning/.test(tally)) throw new Error(`the tape is not clean: ${tally}`);
  await page.locator('#tape-scrub').evaluate((scrub) => {
    if (!(scrub instanceof HTMLInputElement)) throw new Error('the tape has no slider');
    scrub.value = String(Math.floor(Number(scrub.max) / 2));
    scrub.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await quiet(page);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Home');
  for (let i = 0; i < BEFORE_DIGIT; i += 1) await page.keyboard.press('ArrowRight');
  await quiet(page);
  return { ...visited, worker: await watchWorker(page) };
}

/**
 * The editor with nothing behind it, as large as in the playground, built for the occasion.
 * @param {Started} started
 */
export async function buildBare({ browser }) {
  const folder = await mkdtemp(join(tmpdir(), 'nctape-bench-'));
  await build({
    root: join(root, 'tests/bench/bare'),
    configFile: false,
    base: './',
    logLevel: 'warn',
    build: { outDir: folder, emptyOutDir: true, target: 'es2022' },
  });
  const site = await serve(folder);
  return {
    /**
     * @param {number} blocks
     * @param {{ width: number, height: number }} size  of the editor
     */
    async open(blocks, size) {
      const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, colorScheme: 'light', reducedMotion: 'reduce' });
      const page = await context.newPage();
      await page.addInitScript(watchPage);
      await page.goto(site.address);
      await page.locator('.cm-content').waitFor();
      await page.evaluate(
        ({ text, width, height, column }) => {
          const { view } = /** @type {{ view: import('@codemirror/view').EditorView }} */ (/** @type {unknown} */ (window));
          const host = /** @type {HTMLElement} */ (document.getElementById('editor'));
          Object.assign(host.style, { width: `${width}px`, height: `${height}px` });
          view.dispatch({ changes: { from: 0, insert: text } });
          const { from } = view.state.doc.line(Math.floor(view.state.doc.lines / 2));
          view.dispatch({ selection: { anchor: from + column }, scrollIntoView: true });
          view.focus();
        },
        { text: contour(blocks), ...size, column: BEFORE_DIGIT },
      );
      await quiet(page);
      await watchEditor(page);
      return { page, leave: () => context.close() };
    },
    async close() {
      site.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

/**
 * Brings a page to the front while something is measured in it.
 * @template T
 * @param {Page} page
 * @param {() => Promise<T>} work
 * @returns {Promise<T>}
 */
export async function inFront(page, work) {
  await page.bringToFront();
  await runFrames(page, true);
  // The first frames after a change of page are late.
  await page.waitForTimeout(200);
  try {
    return await work();
  } finally {
    await runFrames(page, false);
  }
}
