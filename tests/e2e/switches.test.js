// Beside the path: the place of the decimal sign, and the block skip switch.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { paste, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

test('the slider moves the decimal sign of all dimension words, and path and format follow', async () => {
  const { page, leave } = await visit(started);
  const slider = page.locator('#decimals');
  const cell = page.locator('#span-rows tr', { hasText: 'Length' }).locator('td');
  const detail = page.locator('#field-detail');
  await page.locator('#format-button').click();
  await detail.waitFor();
  assert.equal(await slider.inputValue(), '3');
  assert.equal(await cell.innerText(), '15.708 mm');
  const written = await detail.inputValue();

  await slider.focus();
  await page.keyboard.press('ArrowLeft');
  await quiet(page);
  assert.equal(await slider.getAttribute('aria-valuetext'), '2 places');
  assert.equal(await cell.innerText(), '157.079 mm');
  assert.equal(await detail.inputValue(), written.replaceAll('33', '42'));
  assert.match(await page.locator('#totals').innerText(), /2271\.5 mm/);

  // Faster than the engine: what counts is where the slider stands in the end.
  await page.keyboard.press('End');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await quiet(page);
  assert.equal(await page.locator('#decimals-words').innerText(), '1 place');
  assert.equal(await detail.inputValue(), written.replaceAll('33', '51'));

  await slider.fill('3');
  await quiet(page);
  assert.equal(await detail.inputValue(), written);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await slider.inputValue(), '1', 'undone, as any change of the format');
  await leave();
});

test('without a dimension word there is nothing to move', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#format-button').click();
  await page.locator('#field-detail').fill('N3.G2.M2*');
  await quiet(page);
  assert.ok(await page.locator('#decimals').isDisabled());
  await leave();
});

test('the block skip switch is there with the first /, and leaves its block out', async () => {
  const { page, leave } = await visit(started);
  const box = page.locator('#skip');
  assert.ok(await box.isHidden());
  await paste(page, '%\nN001\tG01\t\tX+010000\t\t\t\tF0100\n/N002\t\t\tY+010000\t\t\t\tF0100\nN003\t\tX+010000\t\t\t\t\tF0100\tM30\n');
  assert.ok(await box.isVisible());
  assert.match(await page.locator('#totals').innerText(), /Cutting 30\.0 mm|Cutting 2\d\.\d mm/);
  const whole = await page.locator('#totals').innerText();
  await box.check();
  await quiet(page);
  const skipped = await page.locator('#totals').innerText();
  assert.notEqual(skipped, whole);
  await box.uncheck();
  await quiet(page);
  assert.equal(await page.locator('#totals').innerText(), whole);
  await leave();
});
