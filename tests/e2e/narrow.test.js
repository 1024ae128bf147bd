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
        .map((one) => ({ name: one.id || one.className, box: one.getBoundingClientRect() }))
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
