// What axe-core finds on the page, in a frame and on the page around it: nothing, in light and dark.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { NARROW, paste, pasteFaulty, quiet, root, startBrowser, visit } from './support/playground.js';

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
  ['CLDATA', async (page) => {
    await page.keyboard.press('Escape');
    await openCldata(page);
  }],
];

/** CLDATA with a record that is kept and one that is wrong. @param {Page} page */
async function openCldata(page) {
  await page.locator('#kind-cldata').click();
  await page.locator('#posted-text .cm-content').waitFor({ state: 'attached' });
  await paste(page, "1,1000,7,'70';\n2,5000,3,'',0,.,.,30.;\n3,15000,1;\n4,20000,0,FEDRAT,200,PERMIN;\n5,5000,5,'L1',0,10.,10.,20.;\n6,14000;\n:\n");
  await page.keyboard.press('Control+Home');
  for (let line = 1; line < 5; line += 1) await page.keyboard.press('ArrowDown');
}

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
    await page.locator('#tab-program').click();
    await openCldata(page);
    for (const name of ['CLDATA', 'Tape', 'Path', 'Problems']) {
      await page.getByRole('tab', { name }).click();
      await quiet(page);
      found.push(...(await violations(page)).map((one) => `${name} of CLDATA: ${one}`));
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
