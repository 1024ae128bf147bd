// The calculator of codes, and the time of each block beside that of the reader.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NARROW, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @param {import('playwright-core').Page} page */
async function openCalculator(page) {
  await page.locator('#learn-button').click();
  await page.locator('#calculator-button').click();
  await page.locator('#calculator tbody tr').first().waitFor();
}

/** @param {import('playwright-core').Page} page */
const rows = (page) => page.locator('#calculator tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));

test('a speed is told by each method, and a code is read by each', async () => {
  const { page, leave } = await visit(started);
  await openCalculator(page);
  assert.ok(await page.locator('#calculator').isVisible());
  await page.locator('#calculator-length').fill('11.716');
  await page.locator('#calculator-radius').fill('20');
  await page.locator('#calculator-speed').fill('300');
  await quiet(page);
  const codes = (await rows(page)).map(([, code]) => code);
  assert.deepEqual(codes.slice(0, 6), ['F0025', 'F0015', 'F630', 'F6300', 'F63000', 'F50'], 'annex E writes F0025 and A.1.2 asks for F0015');
  assert.match((await page.locator('#calculator .in-force').first().innerText()), /Reciprocal of time[\s\S]*in this format/);

  await page.locator('#calculator-code').fill('615');
  await quiet(page);
  assert.equal(await page.locator('#calculator-speed').inputValue(), '', 'one is worked out from the other');
  const arithmetic = (await rows(page)).find(([method]) => method.startsWith('Arithmetic'));
  assert.equal(arithmetic?.[2], '150 mm/min');
  await page.locator('#calculator-code').fill('6x');
  await quiet(page);
  assert.equal(await page.locator('#calculator-said').innerText(), 'A code is a row of digits.');
  assert.equal(await page.locator('#calculator-code').getAttribute('aria-invalid'), 'true');

  await page.getByLabel('Spindle speed, S').check();
  await page.locator('#calculator-speed').fill('1728');
  await quiet(page);
  assert.equal(await page.locator('#calculator-length').isVisible(), false);
  assert.deepEqual((await rows(page)).slice(0, 3).map(([, code]) => code), ['S717', 'S7173', 'S71728']);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#calculator').isVisible(), false);
  await leave();
});

test('the calculator opens from the format, too', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#format-button').click();
  await page.locator('#format-panel').getByRole('button', { name: 'Feed and speed codes' }).click();
  await page.locator('#calculator tbody tr').first().waitFor();
  assert.ok(await page.locator('#calculator').isVisible());
  await leave();
});

test('the blocks are shown with their times, and those that starve are named', async () => {
  const { page, leave } = await visit(started);
  const opener = page.getByRole('button', { name: 'Block by block' });
  await opener.click();
  await page.locator('#times-head').waitFor();
  await quiet(page);
  assert.equal(await opener.getAttribute('aria-expanded'), 'true');
  const words = page.locator('.times-words');
  assert.match(await words.innerText(), /The machine alone takes 47\.17 s[\s\S]*No block is cut faster than it is read/);
  assert.match(await page.locator('.times-named').innerText(), /These take longest: N011/);
  const drawn = await page.locator('.times canvas').evaluate((canvas) => {
    canvas.id = 'times-canvas';
    return canvas.id;
  });
  assert.ok(new Set(await pixels(page, drawn)).size > 4, 'something is drawn');

  // A slow reader.
  await page.locator('#format-button').click();
  await page.locator('#field-itemized-readerSpeed').fill('10');
  await quiet(page);
  assert.match(await words.innerText(), /blocks are cut faster than they are read: there the tool stands/);
  assert.match(await page.locator('.times-named').innerText(), /These wait most/);
  assert.ok((await page.locator('.rule-id').allInnerTexts()).includes('FEED-15'));
  await page.keyboard.press('Escape');

  // A press leads to its block, here and in the picture.
  await page.locator('.times-named button').first().click();
  await quiet(page);
  const named = await page.locator('.times-named button').first().innerText();
  assert.match(await page.locator('#registers-place').innerText(), new RegExp(named));
  await page.locator('.times canvas').hover({ position: { x: 5, y: 40 } });
  await quiet(page);
  assert.match(await page.locator('.times-readout').innerText(), /^N001 .*read in/);
  await page.locator('#times').getByRole('button', { name: 'Close' }).click();
  assert.equal(await page.locator('#times').isVisible(), false);
  assert.equal(await opener.getAttribute('aria-expanded'), 'false');
  await leave();
});

test('on a narrow page nothing is wider than it, and targets are large', async () => {
  const { page, leave } = await visit(started, { options: { viewport: NARROW, hasTouch: true } });
  await page.locator('#tab-path').click();
  await page.getByRole('button', { name: 'Block by block' }).click();
  await page.locator('#times-head').waitFor();
  await quiet(page);
  const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok((await wide()) <= NARROW.width);
  const heights = await page.locator('#times button').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
  assert.ok(heights.every((height) => height >= 44), heights.join(', '));
  await openCalculator(page);
  const box = await page.locator('#calculator').boundingBox();
  assert.ok(box !== null && box.x >= 0 && box.x + box.width <= NARROW.width);
  const boxes = await page.locator('#calculator input:not([type=radio])').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
  assert.ok(boxes.every((height) => height >= 44), boxes.join(', '));
  await leave();
});
