// One thing, four places: text, tape, problems and path show the same.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { difference, goToLine, pasteFaulty, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @param {import('playwright-core').Page} page */
const litLine = (page) => page.locator('.cm-lit').innerText();
/** @param {import('playwright-core').Page} page */
const row = async (page) => (await page.locator('#strip').getAttribute('aria-valuetext')) ?? '';

test('the cursor in the text moves the tape and lights the path', async () => {
  const { page, leave } = await visit(started);
  const plot = await pixels(page, 'plot-canvas');
  await goToLine(page, 'N009');
  assert.match(await litLine(page), /^N009/);
  assert.match(await row(page), /block N009, character N/);
  assert.match(await page.locator('#span-caption').innerText(), /^Line of N009/);
  assert.ok(difference(plot, await pixels(page, 'plot-canvas')) > 100);
  await leave();
});

test('the tape under the hand moves the cursor and lights the path', async () => {
  const { page, leave } = await visit(started);
  await goToLine(page, 'N009');
  await page.locator('#strip').focus();
  await page.keyboard.press('ArrowRight');
  await quiet(page);
  assert.match(await row(page), /block N009, character 0/);
  await page.keyboard.press('PageDown');
  await quiet(page);
  assert.match(await litLine(page), /^N010/);
  assert.match(await page.locator('#span-caption').innerText(), /^Line of N010/);
  await page.keyboard.press('Home');
  await quiet(page);
  assert.match(await row(page), /^Row 1 of/);

  // Drag it by a hundred rows of 14 pixels.
  const box = await page.locator('#strip').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + 1400, box.y + 80);
  await page.mouse.down();
  await page.mouse.move(box.x + 700, box.y + 80, { steps: 4 });
  await page.mouse.move(box.x, box.y + 80, { steps: 4 });
  await page.mouse.up();
  await quiet(page);
  assert.match(await row(page), /^Row 10[01] of/);

  await page.mouse.wheel(0, 140);
  await quiet(page);
  assert.match(await row(page), /^Row 11[01] of/);
  await leave();
});

test('a press on the path puts the cursor into its block', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#plot-canvas').focus();
  await page.keyboard.press('PageDown');
  await quiet(page);
  assert.match(await litLine(page), /^N007/);

  // Where the lit span of N011 runs: its middle, found from the axes of the fitted picture.
  await goToLine(page, 'N011');
  const canvas = page.locator('#plot-canvas');
  const box = await canvas.boundingBox();
  assert.ok(box);
  await goToLine(page, 'N006');
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  /** @type {string[]} */
  const seen = [];
  for (let y = box.y + box.height - 30; y > box.y; y -= 6) {
    await page.mouse.move(box.x + box.width * 0.55, y);
    await page.waitForTimeout(30);
    const words = await page.locator('#readout').innerText();
    if (words !== '' && !seen.includes(words)) seen.push(words);
    if (words.includes('N011')) {
      await page.mouse.down();
      await page.mouse.up();
      break;
    }
  }
  await quiet(page);
  assert.match(seen.join('\n'), /Line to X 15.000.*mm.*N011/);
  assert.match(await litLine(page), /^N011/);
  assert.match(await row(page), /block N011/);
  await leave();
});

test('a problem pressed is selected in the text and lit on the tape', async () => {
  const { page, leave } = await visit(started);
  await pasteFaulty(page, { 'Y-028284': 'Y-28284' });
  await page.locator('.problem').first().click();
  await quiet(page);
  assert.match(await litLine(page), /^N010/);
  assert.equal(await page.locator('.cm-chosen').innerText(), 'Y-28284');
  assert.match(await row(page), /block N010/);
  assert.ok(await page.locator('#problem-list > li').first().evaluate((item) => item.classList.contains('lit')));
  await leave();
});

test('F8 goes from problem to problem', async () => {
  const { page, leave } = await visit(started);
  await pasteFaulty(page, { 'Y-028284': 'Y-28284', 'Y+018284': 'Y+18284' });
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('F8');
  await quiet(page);
  assert.match(await litLine(page), /^N004/);
  await page.keyboard.press('F8');
  await quiet(page);
  assert.match(await litLine(page), /^N010/);
  await page.keyboard.press('Shift+F8');
  await quiet(page);
  assert.match(await litLine(page), /^N004/);
  await leave();
});

test('planes and zoom change the picture', async () => {
  const { page, leave } = await visit(started);
  const xy = await pixels(page, 'plot-canvas');
  await page.getByRole('radio', { name: 'ZX' }).click();
  await quiet(page);
  const zx = await pixels(page, 'plot-canvas');
  assert.ok(difference(xy, zx) > 1000);
  await page.getByRole('radio', { name: 'XY' }).click();
  await page.locator('#zoom-in').click();
  await quiet(page);
  assert.ok(difference(xy, await pixels(page, 'plot-canvas')) > 1000);
  await page.locator('#zoom-fit').click();
  await page.mouse.move(5, 5);
  await quiet(page);
  assert.equal(difference(xy, await pixels(page, 'plot-canvas')), 0);
  await leave();
});
