// What axe-core finds on the page, in a frame and on the page around it: nothing, in light and dark.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { NARROW, pasteFaulty, quiet, root, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

const AXE = readFileSync(`${root}node_modules/axe-core/axe.min.js`, 'utf8');

/**
 * One line for each violation.
 * @param {Page | import('playwright-core').Frame} place
 * @returns {Promise<string[]>}
 */
async function violations(place) {
  await place.evaluate(AXE);
  return place.evaluate(async () => {
    const { axe } = /** @type {any} */ (window);
    // Frames are asked one by one.
    const { violations: found } = await axe.run(document, { iframes: false, resultTypes: ['violations'] });
    return found.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id}: ${JSON.stringify(target)} ${failureSummary}`));
  });
}

/** What is opened on the page, one after the other. @type {[what: string, open: (page: Page) => Promise<unknown>][]} */
const STATES = [
  ['the page', async () => {}],
  ['problems', (page) => pasteFaulty(page, { 'Y-028284': 'Y-28284', 'G01': 'G77' })],
  ['a chosen problem', (page) => page.locator('.problem').first().click()],
  ['the page of a rule', (page) => page.locator('.about').first().click()],
  ['the format', async (page) => {
    await page.keyboard.press('Escape');
    await page.locator('#format-button').click();
  }],
  ['the file menu', async (page) => {
    await page.locator('#format-button').click();
    await page.locator('#file-button').click();
  }],
  ['the share menu', (page) => page.locator('#share-button').click()],
  ['learn', async (page) => {
    await page.keyboard.press('Escape');
    await page.locator('#learn-button').click();
  }],
];

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test(`the page, wide and ${colorScheme}`, async () => {
    const { page, leave } = await visit(started, { options: { colorScheme } });
    const found = [];
    for (const [what, open] of STATES) {
      await open(page);
      await quiet(page);
      found.push(...(await violations(page)).map((one) => `${what}: ${one}`));
    }
    assert.deepEqual(found, []);
    await leave();
  });

  test(`the page, narrow and ${colorScheme}`, async () => {
    const { page, leave } = await visit(started, { options: { viewport: NARROW, colorScheme } });
    await pasteFaulty(page, { 'Y-028284': 'Y-28284' });
    const found = [];
    for (const name of ['Program', 'Path', 'Problems']) {
      await page.getByRole('tab', { name }).click();
      await quiet(page);
      found.push(...(await violations(page)).map((one) => `${name}: ${one}`));
    }
    assert.deepEqual(found, []);
    await leave();
  });

  test(`a page with frames, and the frames, ${colorScheme}`, async () => {
    const { page, leave } = await visit(started, { path: 'embedding.html', ready: false, firstTime: true, options: { colorScheme } });
    const found = [];
    for (const selector of ['#tape iframe', '#exercise iframe', '#frame']) {
      await page.locator(selector.split(' ')[0]).scrollIntoViewIfNeeded();
      const frame = await (await page.locator(selector).elementHandle())?.contentFrame();
      assert.ok(frame);
      await frame.waitForFunction(() => document.getElementById('strip')?.hasAttribute('aria-valuetext'));
      await quiet(page);
      found.push(...(await violations(frame)).map((one) => `${selector}: ${one}`));
    }
    found.push(...(await violations(page)));
    await page.setViewportSize(NARROW);
    await quiet(page);
    for (const place of [page, ...page.frames().slice(1)]) found.push(...(await violations(place)).map((one) => `narrow, ${place.url().slice(-40)}: ${one}`));
    assert.deepEqual(found, []);
    await leave();
  });
}
