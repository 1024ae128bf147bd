// A listing that came without a format: one is offered, taken, and taken back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { lines, NARROW, paste, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

// Four digits and no tabs: nothing of it fits the format of the first tape.
const OLD = '%\nN001G00X+1000Y+1000\nN002G01X+2000F0300\nN003Y+2500\nN004X+1000\nN005Y+1000\nN006M30\n';

test('a paste that does not fit is offered a format, which reads it without an error', async () => {
  const { page, leave } = await visit(started);
  const offer = page.locator('#suggest-offer');
  const format = page.locator('#format-text');
  const before = await format.innerText();
  assert.ok(await offer.isHidden());
  await paste(page, OLD);
  assert.match(await page.locator('#program-note').innerText(), /most with errors/);
  await offer.click();
  const cards = page.locator('.suggestion');
  await cards.first().waitFor();
  assert.ok((await cards.count()) <= 4);
  const words = await cards.first().innerText();
  assert.match(words, /leaves no error/);
  assert.match(words, /Read off the tape[\s\S]*X has 4 digits[\s\S]*Assumed[\s\S]*decimal sign/);

  await cards.first().getByRole('button', { name: 'Use this format' }).click();
  await quiet(page);
  assert.equal(await format.innerText(), await cards.first().locator('.suggestion-line').innerText());
  assert.equal(await page.locator('#field-itemized-setPoint').inputValue(), '', 'a set point is of its own tape');
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error/);
  assert.ok(await offer.isHidden());
  assert.ok(await cards.first().getByRole('button', { name: 'In use' }).isVisible());

  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await format.innerText(), before);
  assert.match((await lines(page)).join('\n'), /N002G01X\+2000/, 'the text stays');
  assert.ok(await offer.isVisible());
  await leave();
});

test('the offer moves nothing, on a wide screen and on a narrow one', async () => {
  for (const viewport of [{ width: 1440, height: 900 }, NARROW]) {
    const { page, leave } = await visit(started, { options: { viewport } });
    const boxes = () =>
      page.evaluate(() => ['strip', 'editor', 'tab-key', 'problems', 'totals'].map((id) => JSON.stringify(document.getElementById(id)?.getBoundingClientRect())));
    const calm = await boxes();
    await paste(page, OLD);
    assert.ok(await page.locator('#suggest-offer').isVisible());
    assert.deepEqual(await boxes(), calm);
    await leave();
  }
});

test('what was suggested goes with the text that it was made for, and an empty tape gets words', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#format-button').click();
  const panel = page.locator('#format-panel');
  await panel.getByRole('button', { name: 'Suggest a format' }).click();
  await panel.locator('.suggestion').first().waitFor();
  await paste(page, '%\n');
  assert.equal(await panel.locator('.suggestion').count(), 0);
  await panel.getByRole('button', { name: 'Suggest a format' }).click();
  await quiet(page);
  assert.match(await panel.locator('.suggest-words').innerText(), /No format can be suggested/);
  await leave();
});
