// The one thing that the page is for: paste a tape, see what is wrong, put it right, and see tape and path follow.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { difference, goToLine, lines, pasteFaulty, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

test('opens with a tape without an error, the cursor on its first arc', async () => {
  const { page, leave } = await visit(started);
  assert.match((await lines(page)).join('\n'), /N006\tG02/);
  assert.match(await page.locator('#span-caption').innerText(), /^Arc of N006/);
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error|warning/);
  assert.match((await page.locator('#strip').getAttribute('aria-valuetext')) ?? '', /block N006/);
  await leave();
});

test('a fault is underlined and listed; typed right, strip and plot show it', async () => {
  const { page, leave } = await visit(started);
  await pasteFaulty(page);
  assert.match(await page.locator('#problem-empty').innerText(), /Nothing to object to in 12 blocks/);

  // One digit too few in the X of N005.
  await goToLine(page, 'N005');
  const good = { strip: await pixels(page, 'strip-canvas'), plot: await pixels(page, 'plot-canvas') };
  await pasteFaulty(page, { 'X+015858': 'X+01585' });
  const squiggle = page.locator('.cm-squiggle-error').first();
  assert.equal(await squiggle.innerText(), 'X+01585');
  const entry = page.locator('#problem-list > li').first();
  assert.match(await entry.innerText(), /NUM-01/);
  assert.match(await entry.innerText(), /X has 5 digits/);
  assert.match(await page.locator('#tallies').innerText(), /1 error/);

  await goToLine(page, 'N005');
  const bad = { strip: await pixels(page, 'strip-canvas'), plot: await pixels(page, 'plot-canvas') };
  assert.ok(difference(good.strip, bad.strip) > 500, 'the tape is shorter by a row');

  // Corrected by typing the digit behind the others.
  for (let i = 0; i < 'N005\t\tX+01585'.length; i += 1) await page.keyboard.press('ArrowRight');
  await page.keyboard.type('8');
  await quiet(page);
  assert.equal(await page.locator('.cm-squiggle-error').count(), 0);
  assert.equal(await page.locator('#problem-list > li').count(), 0);
  await goToLine(page, 'N005');
  const again = { strip: await pixels(page, 'strip-canvas'), plot: await pixels(page, 'plot-canvas') };
  assert.ok(difference(bad.strip, again.strip) > 500, 'the strip follows');
  assert.equal(difference(good.strip, again.strip), 0, 'the tape is the first again');

  // Another length: the path follows too.
  await page.keyboard.press('End');
  await goToLine(page, 'N011');
  const before = await pixels(page, 'plot-canvas');
  for (let i = 0; i < 'N011\t\tX-0'.length; i += 1) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Delete');
  await page.keyboard.type('6');
  await quiet(page);
  assert.ok(difference(before, await pixels(page, 'plot-canvas')) > 500, 'the plot follows');
  await leave();
});

test('a correction is one press, and one undo takes it back', async () => {
  const { page, leave } = await visit(started);
  await pasteFaulty(page, { 'X+015858': 'X+01585' });
  const fix = page.locator('#problem-list .fix').first();
  await fix.click();
  await quiet(page);
  assert.doesNotMatch((await lines(page)).join('\n'), /X\+01585\t/);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.match((await lines(page)).join('\n'), /X\+01585\t/);
  await leave();
});

test('the first tape cannot be undone; a chosen one can, with its format', async () => {
  const { page, leave } = await visit(started);
  const format = page.locator('#format-text');
  const first = await format.innerText();
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  assert.match((await lines(page)).join('\n'), /N006\tG02/);
  await page.locator('#preset').selectOption({ index: 2 });
  await quiet(page);
  assert.notEqual(await format.innerText(), first);
  assert.match(await page.locator('#span-caption').innerText(), /^Parabola of N006/);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await format.innerText(), first);
  assert.match((await lines(page)).join('\n'), /N006\tG02/);
  await leave();
});

test('layout stays where it is when problems come and go', async () => {
  const { page, leave } = await visit(started);
  const boxes = () =>
    page.evaluate(() => ['strip', 'editor', 'problems', 'plot', 'totals'].map((id) => JSON.stringify(document.getElementById(id)?.getBoundingClientRect())));
  const calm = await boxes();
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('N013 X1 Y2 ? Q Q Q\nN001 G99\n');
  await quiet(page);
  assert.ok((await page.locator('#problem-list > li').count()) > 1);
  assert.deepEqual(await boxes(), calm);

  // Neither does an example with a longer tape, a row under the pointer, nor a time that has to be explained.
  await page.locator('#preset').selectOption({ index: 3 });
  await quiet(page);
  assert.match(await page.locator('#totals').innerText(), /Machining not known/);
  await page.mouse.move(400, 150);
  await page.locator('#row-card').waitFor();
  assert.deepEqual(await boxes(), calm);
  await leave();
});

test('an empty tape is said to be empty', async () => {
  const { page, leave } = await visit(started);
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await quiet(page);
  assert.match(await page.locator('#problem-empty').innerText(), /Nothing is on the tape yet|further/);
  assert.match(await page.locator('#totals').innerText(), /0 blocks/);
  await leave();
});
