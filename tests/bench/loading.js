// The first visit: when the page has its first answer, and how many bytes it takes.
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { constants, brotliCompressSync } from 'node:zlib';
import { dist, visit } from '../e2e/support/playground.js';

const VISITS = 9;

/**
 * Milliseconds from the navigation to the totals of the first tape, for a visitor with nothing in the cache.
 * @param {import('../e2e/support/playground.js').Started} started
 */
export async function measureFirstAnswer(started) {
  /** @type {number[]} */
  const times = [];
  for (let i = 0; i < VISITS; i += 1) {
    const { page, leave } = await visit(started, { before: (page) => page.addInitScript(noteFirstAnswer) });
    times.push(await page.evaluate(() => /** @type {{ firstAnswer: number }} */ (/** @type {unknown} */ (window)).firstAnswer));
    await leave();
  }
  return times;
}

function noteFirstAnswer() {
  const observer = new MutationObserver(() => {
    if (!document.getElementById('totals')?.childElementCount) return;
    observer.disconnect();
    Object.assign(window, { firstAnswer: performance.now() });
  });
  observer.observe(document, { childList: true, subtree: true });
}

/**
 * The files that the first load fetches, with their sizes under brotli at its best.
 * @param {import('../e2e/support/playground.js').Started} started
 */
export async function measureSizes(started) {
  /** @type {Map<string, import('playwright-core').Response>} */
  const responses = new Map();
  const { leave } = await visit(started, {
    before: async (page) => page.context().on('response', (response) => responses.set(response.url(), response)),
  });
  const files = [];
  for (const [url, response] of responses) {
    // What the page made itself, such as a picture of its own, was not fetched.
    if (!url.startsWith(started.address)) continue;
    files.push(sized(url.slice(started.address.length) || 'index.html', await response.body()));
  }
  await leave();
  return files;
}

/** The files that go into the pages of others. */
export const measureEmbed = () =>
  Promise.all(['embed.html', 'nc-tape.js'].map(async (name) => sized(name, await readFile(join(dist, name)))));

/**
 * @param {string} name
 * @param {Buffer} body
 */
function sized(name, body) {
  const params = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: body.length };
  return { name, raw: body.length, brotli: brotliCompressSync(body, { params }).length };
}
