// On a telephone: the tape on top, then three tabs.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NARROW, pasteFaulty, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

const options = { viewport: NARROW, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

test('the tabs show one view at a time, under the tape', async () => {
  const { page, leave } = await visit(started, { options });
  const visible = () =>
    page.evaluate(() => ['program', 'path', 'problems'].filter((id) => getComputedStyle(/** @type {Element} */ (document.getElementById(id))).visibility === 'visible'));
  assert.deepEqual(await visible(), ['program']);
  await page.getByRole('tab', { name: 'Path' }).tap();
  assert.deepEqual(await visible(), ['path']);
  await page.keyboard.press('ArrowRight');
  assert.deepEqual(await visible(), ['problems']);
  assert.ok(await page.locator('#strip-canvas').isVisible());
  await leave();
});

test('the count of problems stands on its tab, and a problem leads to its place', async () => {
  const { page, leave } = await visit(started, { options });
  await pasteFaulty(page, { 'Y-028284': 'Y-28284' });
  const badge = page.locator('#tab-count');
  assert.equal(await badge.innerText(), '1');
  const red = await badge.evaluate((one) => getComputedStyle(one).backgroundColor);
  await page.getByRole('tab', { name: 'Problems' }).tap();
  await page.locator('.problem').first().tap();
  await quiet(page);
  assert.equal(await page.locator('#tab-program').getAttribute('aria-selected'), 'true');
  assert.match(await page.locator('.cm-lit').innerText(), /^N010/);

  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await badge.innerText(), '1', 'the note of the first tape');
  assert.notEqual(await badge.evaluate((one) => getComputedStyle(one).backgroundColor), red, 'a note alone is not red');
  await leave();
});

test('nothing is wider than the screen, and every target is large enough for a finger', async () => {
  const { page, leave } = await visit(started, { options });
  await pasteFaulty(page, { 'Y-028284': 'Y-28284' });
  for (const tab of ['Program', 'Path', 'Problems']) {
    await page.getByRole('tab', { name: tab }).tap();
    const small = await page.evaluate(() => {
      const all = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('button, select, input')]);
      return all
        .filter((one) => one.checkVisibility({ visibilityProperty: true }) && !one.closest('.hidden'))
        // A switch is pressed by its words as well.
        .map((one) => ({ name: one.id || one.className, box: ((one.role === 'switch' && one.closest('label')) || one).getBoundingClientRect() }))
        .filter(({ box }) => box.width > 0 && (box.height < 43.5 || box.width < 43.5 || box.right > innerWidth + 1))
        .map(({ name, box }) => `${name} ${Math.round(box.width)}x${Math.round(box.height)}`);
    });
    assert.deepEqual(small, [], tab);
  }
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), NARROW.width);
  await leave();
});

test('the format panel fills the lower part and can be closed', async () => {
  const { page, leave } = await visit(started, { options });
  await page.locator('#format-button').tap();
  await page.locator('#format-panel fieldset').first().waitFor();
  assert.ok(await page.locator('#strip-canvas').isVisible());
  await page.locator('#format-panel').getByRole('button', { name: 'Close' }).tap();
  assert.ok(await page.locator('#format-panel').isHidden());
  await leave();
});

test('on a low screen the page opens at its top, and the tape does not move it', async () => {
  const { page, leave } = await visit(started, { options: { ...options, viewport: { width: 390, height: 640 } } });
  const top = () => page.evaluate(() => document.documentElement.scrollTop + document.body.scrollTop);
  assert.equal(await top(), 0);
  // It is longer than the screen, so that it could be moved.
  assert.ok(await page.evaluate(() => document.documentElement.scrollHeight > innerHeight));
  await page.locator('#strip').focus();
  await page.keyboard.press('End');
  await quiet(page);
  assert.match((await page.locator('#strip').getAttribute('aria-valuetext')) ?? '', /^Row 417/);
  assert.equal(await top(), 0);
  await leave();
});

test('each hint brings to the front what it speaks of', async () => {
  const { page, leave } = await visit(started, { options, firstTime: true });
  const hint = page.locator('#hint');
  await hint.getByRole('button', { name: 'Next' }).tap();
  assert.ok(await page.locator('#editor').isVisible());
  await hint.getByRole('button', { name: 'Next' }).tap();
  assert.ok(await page.locator('#plot-canvas').isVisible());
  assert.match(await hint.innerText(), /the path/);
  await hint.getByRole('button', { name: 'Got it' }).tap();
  assert.ok(await hint.isHidden());
  assert.equal(await page.locator('#tab-program').getAttribute('aria-selected'), 'true');
  await leave();
});

test('the picture of the path keeps its height, and what is under it can be reached', async () => {
  const { page, leave } = await visit(started, { options });
  await page.getByRole('tab', { name: 'Path' }).tap();
  const plot = await page.locator('#plot').boundingBox();
  assert.ok(plot && plot.height >= 280, `${plot?.height}`);
  const totals = page.locator('#totals');
  await totals.scrollIntoViewIfNeeded();
  const box = await totals.boundingBox();
  assert.ok(box && box.y + box.height <= NARROW.height + 1);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), NARROW.width);
  await leave();
});

test('menus, cards and the name have targets for a finger and stay on the screen', async () => {
  const { page, leave } = await visit(started, { options });
  const strays = () =>
    page.evaluate(() => {
      const all = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('button, select, input')]);
      return all
        .filter((one) => one.checkVisibility({ visibilityProperty: true }) && !one.closest('.hidden'))
        .map((one) => ({ name: one.id || one.className, box: one.getBoundingClientRect() }))
        .filter(({ box }) => box.width > 0 && (box.height < 43.5 || box.width < 43.5 || box.right > innerWidth + 1 || box.left < -1))
        .map(({ name, box }) => `${name} ${Math.round(box.width)}x${Math.round(box.height)}`);
    });
  await page.locator('#file-button').tap();
  assert.ok(await page.locator('#file-menu').isVisible());
  assert.deepEqual(await strays(), []);
  // A press beside the menu closes it.
  await page.touchscreen.tap(20, 700);
  assert.ok(await page.locator('#file-menu').isHidden());

  await page.locator('#name-button').tap();
  await page.locator('#name').fill('Ada');
  await quiet(page);
  assert.deepEqual(await strays(), []);
  await page.locator('.name-done').tap();

  const editor = await page.locator('#editor').boundingBox();
  await page.locator('#about-button').tap();
  assert.match(await page.locator('#about-tape').innerText(), /annex E/);
  assert.deepEqual(await page.locator('#editor').boundingBox(), editor, 'what the tape teaches lies over the text');
  await page.locator('#about-button').tap();
  assert.ok(await page.locator('#about-tape').isHidden());

  await page.locator('#file-input').setInputFiles({ name: 'r', mimeType: '', buffer: Buffer.from([0, 0x80, 0x45, 0x21, 0x80]) });
  await page.locator('#file-card').waitFor();
  await quiet(page);
  assert.deepEqual(await strays(), []);
  await leave();
});
