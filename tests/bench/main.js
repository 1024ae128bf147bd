// `cargo xtask bench`: measures the page in a real browser and prints the tables of docs/performance.md.
import { cpus, loadavg, totalmem, type } from 'node:os';
import { startBrowser } from '../e2e/support/playground.js';
import { panPlot, scrollStrip } from './frames.js';
import { measureEmbed, measureFirstAnswer, measureSizes } from './loading.js';
import { grouped, kilobytes, median, medianAndP95, ms, percentile, table } from './support/figures.js';
import { buildBare, openPlayground } from './support/pages.js';
import { measureTyping, spent } from './typing.js';

/** Milliseconds of a frame at 60 of them a second. */
const FRAME = 1000 / 60;
/** A browser rounds the times of frames to tenths, at both ends. */
const ROUNDED = 0.2;

const GOALS = { keystroke: 8, framesMore: 2, wasm: 170_000, load: 300_000, embed: 320_000, framesInTime: 95 };

/** @type {string[][]} */
const rows = [];
/** @type {string[][]} */
const parts = [];

/**
 * @param {string} what
 * @param {string} blocks
 * @param {string} goal
 * @param {string} figure
 * @param {boolean | null} met
 */
const tell = (what, blocks, goal, figure, met) => rows.push([what, blocks, goal, figure, met === null ? '' : met ? 'yes' : 'no']);

/** @param {string} text */
const progress = (text) => console.error(`measuring: ${text}`);

/**
 * @param {import('../e2e/support/playground.js').Started} started
 * @param {Awaited<ReturnType<typeof buildBare>>} bare
 * @param {number} blocks
 */
async function measureTape(started, bare, blocks) {
  const count = grouped(blocks);
  progress(`${count} blocks, a keystroke`);
  const playground = await openPlayground(started, blocks);
  const size = await playground.page.locator('#editor').boundingBox();
  if (size === null) throw new Error('the editor is not to be seen');
  const alone = await bare.open(blocks, size);
  const typing = await measureTyping(playground, alone);
  await alone.leave();

  const work = typing.withEngine.map(({ engine, drawing }) => spent([...engine, ...drawing]));
  const worst = percentile(work, 95);
  tell('engine and drawing for a keystroke: median, p95', count, `p95 at most ${GOALS.keystroke} ms`, medianAndP95(work), worst <= GOALS.keystroke);
  tellParts(count, typing.withEngine);

  const plain = typing.alone.map(({ all }) => all);
  const characters = typing.withEngine.map(({ character }) => character);
  const all = typing.withEngine.map((keystroke) => keystroke.all);
  tell('keystroke to character painted, editor alone: median, p95', count, '', medianAndP95(plain), null);
  tell('keystroke to character painted, playground: median, p95', count, '', medianAndP95(characters), null);
  tell('keystroke to everything painted, playground: median, p95', count, '', medianAndP95(all), null);
  const more = [50, 95].map((percent) => (percentile(all, percent) - percentile(plain, percent)) / FRAME);
  tell(
    'frames until everything is painted, more than the editor alone: median, p95',
    count,
    `at most ${GOALS.framesMore}`,
    more.map((frames) => frames.toFixed(1)).join(', '),
    Math.max(...more) <= GOALS.framesMore,
  );

  progress(`${count} blocks, frames`);
  tellFrames('frames in time while the strip is scrolled', count, await scrollStrip(playground.page));
  tellFrames('frames in time while the plot is panned', count, await panPlot(playground.page));
  await playground.leave();
}

/**
 * @param {string} what
 * @param {string} count
 * @param {number[]} times
 */
function tellFrames(what, count, times) {
  const inTime = (100 * times.filter((time) => time <= FRAME + ROUNDED).length) / times.length;
  const figure = `${inTime.toFixed(1)} % (p95 ${ms(percentile(times, 95))}, ${times.length} frames)`;
  tell(what, count, `${GOALS.framesInTime} % within 16.7 ms`, figure, inTime >= GOALS.framesInTime);
}

/**
 * What a keystroke is made of.
 * @param {string} count
 * @param {import('./typing.js').Keystroke[]} keystrokes
 */
function tellParts(count, keystrokes) {
  for (const place of /** @type {const} */ (['engine', 'drawing'])) {
    const names = new Set(keystrokes.flatMap((keystroke) => keystroke[place].map(({ name }) => name)));
    for (const name of names) {
      const times = keystrokes.map((keystroke) => spent(keystroke[place].filter((one) => one.name === name)));
      // The list of problems is made anew in a pause, and no keystroke waits for it.
      if (name !== 'nctape.problems') parts.push([count, place, name.replace('nctape.', ''), ms(median(times)), ms(percentile(times, 95))]);
    }
  }
}

const loadBefore = loadavg()[0];
const started = await startBrowser();
const bare = await buildBare(started);
try {
  for (const blocks of [1000, 100_000]) await measureTape(started, bare, blocks);

  progress('the first visit');
  const first = await measureFirstAnswer(started);
  tell('navigation to first answer, nothing cached: median, most', '', '', `${ms(median(first))}, ${ms(Math.max(...first))}`, null);

  progress('sizes');
  const files = await measureSizes(started);
  const wasm = files.filter(({ name }) => name.endsWith('.wasm')).reduce((sum, { brotli }) => sum + brotli, 0);
  const load = files.reduce((sum, { brotli }) => sum + brotli, 0);
  tell('wasm, brotli', '', kilobytes(GOALS.wasm), kilobytes(wasm), wasm <= GOALS.wasm);
  tell('first load, brotli', '', kilobytes(GOALS.load), kilobytes(load), load <= GOALS.load);

  const embed = await measureEmbed();
  const whole = embed[0].brotli;
  tell('the playground as one file, brotli', '', kilobytes(GOALS.embed), kilobytes(whole), whole <= GOALS.embed);

  const [cpu] = cpus();
  console.log(`
Printed by \`cargo xtask bench\` on ${new Date().toISOString().slice(0, 10)}: ${cpu.model.trim()}, ${cpus().length} cores, \
${Math.round(totalmem() / 2 ** 30)} GiB, ${type()}; Chromium ${started.browser.version()} without a display; Node ${process.version}. \
Programs that wanted to run, on average: ${loadBefore.toFixed(1)} at the start, ${loadavg()[0].toFixed(1)} at the end.

${table(['what', 'blocks', 'goal', 'figure', 'met'], rows)}

What a keystroke is made of. The engine works in the worker, while the page goes on; drawing is the page's own.

${table(['blocks', 'where', 'part', 'median', 'p95'], parts)}

What the first load fetches.

${table(['file', 'bytes', 'brotli'], files.map(({ name, raw, brotli }) => [name, grouped(raw), grouped(brotli)]))}

What goes into the pages of others.

${table(['file', 'bytes', 'brotli'], embed.map(({ name, raw, brotli }) => [name, grouped(raw), grouped(brotli)]))}
`);
} finally {
  await bare.close();
  await started.close();
}
