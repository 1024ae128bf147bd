// What can be saved beside the listing: each file holds what its name says.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/**
 * @param {import('playwright-core').Page} page
 * @param {string} id
 */
async function saved(page, id) {
  await page.locator('#file-button').click();
  const download = page.waitForEvent('download');
  await page.locator(`#${id}`).click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

test('the drawing, the path, the spans, the problems and the report', async () => {
  const { page, leave } = await visit(started);
  const drawing = await saved(page, 'save-drawing');
  assert.equal(drawing.name, 'tape.svg');
  // Five lines of a hundred rows, each with its feed hole.
  assert.equal(drawing.bytes.toString().match(/r="0\.585"/g)?.length, 500);
  assert.match(drawing.bytes.toString(), /^<svg xmlns="[^"]+" width="254\.00mm"/);

  const path = await saved(page, 'save-path');
  assert.equal(path.name, 'path.png');
  assert.equal(path.bytes.subarray(1, 4).toString(), 'PNG');

  const spans = await saved(page, 'save-spans');
  assert.equal(spans.bytes.toString().trim().split('\r\n').length, 12, 'a head and eleven spans');

  const problems = await saved(page, 'save-problems');
  assert.match(problems.bytes.toString(), /^- \*\*Note\*\* 8:26 `NUM-15`/m);

  const { report, format } = JSON.parse((await saved(page, 'save-report')).bytes.toString());
  assert.equal(report.api, 1);
  assert.equal(format.standard, 'iso2539');
  await leave();
});

test('what is printed is the listing, its problems and its path, and nothing of the page', async () => {
  const { page, leave } = await visit(started, {
    before: (page) =>
      page.addInitScript(() => {
        window.print = () => {
          const isSeen = (/** @type {string} */ name) => getComputedStyle(/** @type {Element} */ (document.querySelector(name))).display !== 'none';
          const sheet = /** @type {Element} */ (document.querySelector('.sheet'));
          Object.assign(window, { printed: { text: sheet.textContent, seen: [isSeen('.sheet'), isSeen('#app')] } });
          window.dispatchEvent(new Event('afterprint'));
        };
      }),
  });
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('#app').isVisible(), true, 'the browser’s own print shows the page');
  await page.locator('#file-button').click();
  await page.locator('#save-print').click();
  await page.waitForFunction(() => 'printed' in window);
  const { text, seen } = await page.evaluate(() => /** @type {any} */ (window).printed);
  assert.deepEqual(seen, [true, false], 'the sheet is seen, and the page is not');
  assert.match(text, /Format: ISO 2539.*N006\tG02.*Problems8:26 NUM-15 .*Path$/s);
  assert.equal(await page.locator('.sheet').count(), 0, 'gone when it is done');
  await leave();
});
