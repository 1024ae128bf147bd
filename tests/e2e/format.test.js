// The format panel explains, and what is changed in it is read at once.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @param {import('playwright-core').Page} page */
async function openPanel(page) {
  await page.locator('#format-button').click();
  await page.locator('#format-panel fieldset').first().waitFor();
}

test('says in sentences what the format means', async () => {
  const { page, leave } = await visit(started);
  await openPanel(page);
  assert.ok((await page.locator('.explained li').count()) > 1);
  const field = page.locator('#field-detail');
  assert.equal(await field.inputValue(), await page.locator('#format-text').innerText().then((line) => line.split(' · ').at(-1)));
  await leave();
});

test('an edit of the detail applies live, and is undone with the text', async () => {
  const { page, leave } = await visit(started);
  await openPanel(page);
  const field = page.locator('#field-detail');
  const detail = await field.inputValue();
  await field.fill(detail.replace('N3', 'N4'));
  await quiet(page);
  assert.match(await page.locator('#format-text').innerText(), /N4/);
  assert.match(await page.locator('#tallies').innerText(), /error/, 'three digits are no longer right');
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await field.inputValue(), detail);
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error/);
  await leave();
});

test('a fault in the shorthand stands at its field, and one in a list beside its box', async () => {
  const { page, leave } = await visit(started);
  await openPanel(page);
  await page.locator('#field-detail').fill('N3.G2.X?');
  await quiet(page);
  assert.ok((await page.locator('.field:has(#field-detail) .field-verdict').count()) > 0);
  assert.equal(await page.locator('#format-flag .mark').count(), 1);

  const travel = page.locator('#field-itemized-travel');
  await travel.fill('X=0..');
  assert.match(await page.locator('#field-itemized-travel-fault').innerText(), /Write it like X=0\.\.85/);
  assert.equal(await travel.getAttribute('aria-invalid'), 'true');
  await travel.fill('X=0..85');
  assert.equal(await page.locator('#field-itemized-travel-fault').innerText(), '');
  await leave();
});

test('Escape closes it and gives the focus back', async () => {
  const { page, leave } = await visit(started);
  await openPanel(page);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#format-panel').isHidden(), true);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'format-button');
  await leave();
});
