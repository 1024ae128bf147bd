// With the keyboard alone, by the ear, and at the first visit.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { lines, paste, quiet, settled, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @param {import('playwright-core').Page} page */
const focused = (page) =>
  page.evaluate(() => {
    const inner = document.activeElement?.shadowRoot?.activeElement;
    return inner ? 'program text' : document.activeElement?.id || document.activeElement?.className || '';
  });

test('Tab reaches everything, and no key is a trap', async () => {
  const { page, leave } = await visit(started);
  await paste(page, 'N001 G01 X1 Y2\n');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
  await page.locator('#preset').focus();
  /** @type {string[]} */
  const reached = [];
  for (let i = 0; i < 40; i += 1) {
    reached.push(await focused(page));
    await page.keyboard.press('Tab');
  }
  for (const wanted of ['preset', 'format-button', 'theme-button', 'learn-button', 'strip', 'tab-key', 'program text', 'problem', 'about', 'divider', 'segment', 'zoom-in', 'zoom-fit', 'plot-canvas']) {
    assert.ok(reached.includes(wanted), `${wanted} among ${reached.join(', ')}`);
  }
  await leave();
});

test('a whole visit by the keyboard: choose a tape, make an error, find it, mend it, share it', async () => {
  const { page, leave } = await visit(started);
  /** @param {string} wanted @param {'Tab' | 'Shift+Tab'} [key] */
  const goTo = async (wanted, key = 'Tab') => {
    for (let i = 0; i < 60 && (await focused(page)) !== wanted; i += 1) await page.keyboard.press(key);
    assert.equal(await focused(page), wanted);
  };
  await goTo('preset');
  await page.keyboard.press('ArrowDown');
  await quiet(page);
  assert.equal(await page.locator('#preset').inputValue(), 'annex-e-parabolic');
  const whole = (await lines(page)).join('\n');

  await goTo('program text');
  await page.keyboard.press('Control+Home');
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'End', 'Backspace']) await page.keyboard.press(key);
  await quiet(page);
  assert.match(await page.locator('#tallies').innerText(), /1 error/);

  await page.keyboard.press('Control+Home');
  await page.keyboard.press('F8');
  await quiet(page);
  assert.ok(await page.locator('.problem-list > li.chosen').count());
  await page.keyboard.press('Escape');
  await goTo('small fix');
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error/);
  const mended = (await lines(page)).join('\n');
  assert.equal(mended.length, whole.length);

  await goTo('share-button', 'Shift+Tab');
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.equal(await focused(page), 'share-link');
  await goTo('copy-link');
  await page.keyboard.press('Enter');
  await quiet(page);
  assert.match(await page.locator('#share-said').innerText(), /copied|by hand/);
  const link = await page.locator('#share-link').inputValue();
  await page.keyboard.press('Escape');
  assert.equal(await focused(page), 'share-button');
  await leave();

  const other = await visit(started, { path: link.slice(started.address.length) });
  assert.equal((await lines(other.page)).join('\n'), mended);
  await other.leave();
});

test('Escape leaves the program', async () => {
  const { page, leave } = await visit(started);
  await page.locator('.cm-content').click();
  assert.equal(await focused(page), 'program text');
  await page.keyboard.press('Escape');
  assert.equal(await focused(page), 'problems');
  await leave();
});

test('one sentence tells what is wrong, when it is quiet', async () => {
  const { page, leave } = await visit(started);
  await paste(page, 'N001 G01 X1\n');
  await page.waitForTimeout(1600);
  assert.match((await page.locator('#status').textContent()) ?? '', /^\d+ .*First: line 1, /);
  assert.equal(await page.locator('#status').getAttribute('role'), 'status');
  await leave();
});

test('three hints at the first visit, none at the second', async () => {
  const { page, leave } = await visit(started, { firstTime: true });
  const hint = page.locator('#hint');
  assert.match(await hint.innerText(), /1 of 3/);
  await hint.getByRole('button', { name: 'Next' }).click();
  await hint.getByRole('button', { name: 'Next' }).click();
  assert.match(await hint.innerText(), /3 of 3/);
  await hint.getByRole('button', { name: 'Got it' }).click();
  assert.ok(await hint.isHidden());
  await page.reload();
  await settled(page);
  assert.ok(await hint.isHidden());
  await leave();
});

test('the theme is remembered, and the page works where nothing can be', async () => {
  const { page, leave } = await visit(started);
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  await page.locator('#theme-button').click();
  await page.locator('#theme-button').click();
  assert.equal(await theme(), 'dark');
  await page.reload();
  await settled(page);
  assert.equal(await theme(), 'dark');
  await leave();

  const denied = await visit(started, {
    firstTime: true,
    before: (other) =>
      other.addInitScript(() => {
        Object.defineProperty(window, 'localStorage', {
          get() {
            throw new DOMException('denied', 'SecurityError');
          },
        });
      }),
  });
  assert.ok(await denied.page.locator('#hint').isVisible());
  await denied.leave();
});

test('the page of a rule opens from the list', async () => {
  const { page, leave } = await visit(started);
  await paste(page, 'N001 G01 X1\n');
  await page.locator('.about').first().click();
  await quiet(page);
  const dialog = page.locator('#rule-page');
  assert.ok(await dialog.isVisible());
  assert.ok((await dialog.locator('h2').innerText()).length > 3);
  assert.ok((await dialog.locator('pre').count()) > 0, 'with whole tapes as examples');
  await page.keyboard.press('Escape');
  assert.ok(await dialog.isHidden());
  await leave();
});

test('the examples of a rule open as tapes under their format, the caret lines left out', async () => {
  const { page, leave } = await visit(started);
  await paste(page, (await lines(page)).join('\n').replace('X+015858', 'X+01585').replace('I-000000', 'I+000000'));
  await page.locator('.about').first().click();
  const dialog = page.locator('#rule-page');
  const shown = await dialog.locator('.example code').first().innerText();
  assert.match(shown, /\^\^/);
  await dialog.getByRole('button', { name: 'Open this example' }).first().click();
  await quiet(page);
  assert.ok(await dialog.isHidden());
  assert.equal((await lines(page)).join('\n').trim(), shown.split('\n').filter((line) => !/^[ ^]+$/.test(line)).join('\n').trim());
  assert.match(await page.locator('#format-text').innerText(), /ISO 2539 · CAM 332 · N3G2X\+42/);
  const problems = await page.locator('.rule-id').allInnerTexts();
  assert.deepEqual(problems, ['NUM-01'], 'the rule alone');
  assert.equal(await focused(page), 'program text');

  await page.locator('.about').first().click();
  await dialog.getByRole('button', { name: 'Open this example' }).nth(1).click();
  await quiet(page);
  assert.equal(await page.locator('#problem-list > li').count(), 0, 'the good one');
  await leave();
});

test('what the page is and how its keys go is told by Learn', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#learn-button').click();
  assert.match(await page.locator('#learn').innerText(), /What you see here[\s\S]*F8/);
  await page.keyboard.press('Escape');
  assert.equal(await focused(page), 'learn-button');
  await leave();
});
