// Frames while the hand moves the strip and the plot.
import { inFront } from './support/pages.js';
import { notes } from './support/watch.js';

/** @typedef {import('playwright-core').Page} Page */

const STEPS = 240;

/**
 * Rolls the strip on, and sometimes back.
 * @param {Page} page
 */
export const scrollStrip = (page) =>
  frames(page, '#strip', async () => {
    for (let i = 0; i < STEPS; i += 1) await page.mouse.wheel(0, i % 60 < 45 ? 60 : -60);
  });

/**
 * Drags the plot round in a circle.
 * @param {Page} page
 */
export const panPlot = (page) =>
  frames(page, '#plot-canvas', async (x, y) => {
    await page.mouse.down();
    for (let i = 0; i < STEPS; i += 1) {
      const angle = (i / 60) * 2 * Math.PI;
      await page.mouse.move(x + 60 * (Math.cos(angle) - 1), y + 60 * Math.sin(angle));
    }
    await page.mouse.up();
  });

/**
 * The time from each frame to the next while something is done at the middle of an element.
 * @param {Page} page
 * @param {string} selector
 * @param {(x: number, y: number) => Promise<void>} work
 * @returns {Promise<number[]>}
 */
async function frames(page, selector, work) {
  const box = await page.locator(selector).boundingBox();
  if (box === null) throw new Error(`${selector} is not to be seen`);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  return inFront(page, async () => {
    await notes(page);
    await work(x, y);
    const times = (await notes(page)).frames;
    return times.slice(1).map((time, index) => time - times[index]);
  });
}
