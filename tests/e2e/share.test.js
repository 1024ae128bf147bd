// Sharing: a tape as a link, and what the browser keeps of it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { lines, paste, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @typedef {import('playwright-core').Page} Page */

const OWN = '%\nN001 G01 X+001000 Y+002000 F0300\nN002 M30\n';

/** @param {Page} page */
const text = async (page) => (await lines(page)).join('\n');

/** @param {Page} page */
async function reload(page) {
  await page.reload();
  await page.locator('.cm-line').first().waitFor();
  await quiet(page);
}

/** Longer than the pause after which a draft is kept. @param {Page} page */
const drafted = (page) => page.waitForTimeout(1000);

test('a tape is shared as a link, and the link opens it with its format', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#preset').selectOption('annex-e-parabolic');
  await quiet(page);
  await page.locator('#share-button').click();
  const link = await page.locator('#share-link').inputValue();
  assert.ok(link.startsWith(`${started.address}#1.`) || link.startsWith(`${started.address}/#1.`), link);
  const shared = await text(page);
  const format = await page.locator('#format-text').innerText();
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#share-menu').isVisible(), false);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'share-button');
  await leave();

  const other = await visit(started);
  await other.page.goto(link);
  await quiet(other.page);
  assert.equal(await text(other.page), shared);
  assert.equal(await other.page.locator('#format-text').innerText(), format);
  assert.equal(new URL(other.page.url()).hash, '', 'what is written next is not what was shared');
  await other.leave();
});

test('a broken link says so, and the page is as it would be without it', async () => {
  const { page, leave } = await visit(started);
  const first = await text(page);
  await page.goto(`${started.address}#1.AAAA`);
  await page.locator('#notice').waitFor();
  assert.match(await page.locator('#notice').innerText(), /The link could not be opened\. It is damaged/);
  assert.equal(await text(page), first);
  await leave();
});

test('a tape that is too long for a link is offered as a file', async () => {
  const { page, leave } = await visit(started);
  let state = 1;
  const noise = Array.from({ length: 3000 }, () => (state = (state * 48271) % 2147483647));
  await paste(page, `%\n${noise.map((number) => `N001 G01 X+${String(number % 1_000_000).padStart(6, '0')}`).join('\n')}\n`);
  await page.locator('#share-button').click();
  await page.locator('#share-said').waitFor();
  assert.match(await page.locator('#share-menu').innerText(), /would have [\d\s]+ characters.*as a file/s);
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the listing instead' }).click();
  assert.equal((await download).suggestedFilename(), 'tape.txt');
  await leave();
});

test('what was written is there after a reload, also while an example is looked at', async () => {
  const { page, leave } = await visit(started);
  await paste(page, OWN);
  await drafted(page);
  await reload(page);
  assert.equal(await text(page), OWN);
  await page.locator('#preset').selectOption('annex-e-parabolic');
  await drafted(page);
  await reload(page);
  assert.match(await text(page), /G06/);
  await page.locator('#preset').selectOption('');
  await quiet(page);
  assert.equal(await text(page), OWN);
  await leave();
});

test('two windows do not write over one another', async () => {
  const { page, leave } = await visit(started);
  const second = await page.context().newPage();
  await second.goto(started.address);
  await second.locator('.cm-line').first().waitFor();
  await quiet(second);
  await paste(page, OWN);
  await paste(second, `${OWN}N003\n`);
  await drafted(second);
  await drafted(page);
  await reload(page);
  await reload(second);
  assert.equal(await text(page), OWN);
  assert.equal(await text(second), `${OWN}N003\n`);
  await leave();
});

test('where nothing can be kept the page says so once and goes on', async () => {
  const { page, leave } = await visit(started, {
    before: (page) =>
      page.addInitScript(() => {
        Storage.prototype.setItem = () => {
          throw new DOMException('full', 'QuotaExceededError');
        };
      }),
  });
  await paste(page, OWN);
  await drafted(page);
  assert.match(await page.locator('#notice').innerText(), /keeps nothing for this page/);
  await page.locator('#notice button').click();
  await paste(page, `${OWN}N003\n`);
  await drafted(page);
  assert.equal(await page.locator('#notice').isVisible(), false);
  assert.equal(await text(page), `${OWN}N003\n`);
  await leave();
});

test('in a frame where storage throws it works, and leaves the address alone', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#share-button').click();
  const link = await page.locator('#share-link').inputValue();
  const host = await page.context().newPage();
  await host.setContent('<iframe id="plain" width="1200" height="400"></iframe>');
  await host.evaluate((src) => document.querySelector('iframe')?.setAttribute('src', src), link);
  const frame = host.frameLocator('#plain');
  await frame.locator('.cm-line').first().waitFor();
  await quiet(host);
  await frame.locator('.cm-content').focus();
  await host.keyboard.type('(');
  await drafted(host);
  await assert.rejects(frame.locator('body').evaluate(() => localStorage.length), /SecurityError/);
  assert.match((await frame.locator('.cm-line').allTextContents()).join('\n'), /\(\)/, 'what was typed is there');
  assert.ok((await frame.locator('body').evaluate(() => location.hash)).startsWith('#1.'));
  await leave();
});

test('a shared tape leaves the visitor’s own alone, until it is changed', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#share-button').click();
  const link = await page.locator('#share-link').inputValue();
  const example = await text(page);
  await paste(page, OWN);
  await drafted(page);
  await page.goto(link);
  await page.locator('.cm-line').first().waitFor();
  await drafted(page);
  await reload(page);
  assert.equal(await text(page), example);
  await page.locator('#preset').selectOption('');
  await quiet(page);
  assert.equal(await text(page), OWN);
  await leave();
});

test('a format that was changed under an example is there after a reload', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#format-button').click();
  await page.locator('#field-detail').fill('N3.G2.XD43.YD43.ZD43.ID43.JD43.F4.M2*');
  await drafted(page);
  await reload(page);
  assert.match(await page.locator('#format-text').innerText(), /XD43/);
  await leave();
});
