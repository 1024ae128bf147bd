// Typing: parentheses close themselves, a tape from nothing is fitted, and what the hand does is undone as it was done.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { difference, goToLine, lines, paste, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page */
const text = async (page) => (await lines(page)).join('\n');

/**
 * @param {Page} page
 * @param {string} start
 */
async function endOfLine(page, start) {
  await goToLine(page, start);
  await page.keyboard.press('End');
}

test('a parenthesis closes itself, so that a comment being typed swallows nothing', async () => {
  const { page, leave } = await visit(started);
  const original = await text(page);
  await endOfLine(page, 'N005');
  await page.keyboard.type('(');
  await quiet(page);
  assert.match(await text(page), /F0013\(\)\n/);
  assert.match(await page.locator('#program-note').innerText(), /^12 blocks/, 'no block is swallowed');
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error/);

  await page.keyboard.type('FACE');
  await page.keyboard.type(')');
  await page.keyboard.type(' ');
  assert.match(await text(page), /F0013\(FACE\) \n/, 'the closing one is typed over');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.equal(await text(page), original, 'undone');
  await leave();
});

test('backspace takes an empty pair, and a pair that waits is not doubled', async () => {
  const { page, leave } = await visit(started);
  const original = await text(page);
  await endOfLine(page, 'N005');
  await page.keyboard.type('(');
  await page.keyboard.press('Backspace');
  assert.equal(await text(page), original);

  await page.keyboard.type('FACE)');
  for (let i = 0; i < 'FACE)'.length; i += 1) await page.keyboard.press('ArrowLeft');
  await page.keyboard.type('(');
  assert.match(await text(page), /F0013\(FACE\)\n/, 'the ) was there already');
  await page.keyboard.type('(');
  assert.match(await text(page), /F0013\(\(FACE\)\n/, 'within a comment nothing is added');
  await leave();
});

test('a selection is put between parentheses', async () => {
  const { page, leave } = await visit(started);
  await goToLine(page, 'N005');
  await page.keyboard.press('Shift+End');
  await page.keyboard.type('(');
  await quiet(page);
  assert.match(await text(page), /\n\(N005\t.*F0013\)\n/);
  assert.match(await page.locator('#program-note').innerText(), /^12 blocks/);
  await leave();
});

test('a tape typed from nothing is fitted in the picture', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#preset').selectOption({ label: 'Empty tape' });
  await quiet(page);
  assert.equal(await text(page), '');
  await page.keyboard.type('%\nN001\tG01\tX+900000\tY+700000\t\t\t\tF0100\n');
  await quiet(page);
  assert.ok(await isPathSeen(page), 'the whole line is in the picture as typed');
  await leave();
});

test('a picture that was moved by hand stays as it was put', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#zoom-in').click();
  await page.locator('#zoom-in').click();
  await page.locator('#zoom-in').click();
  await quiet(page);
  await goToLine(page, 'N001');
  const held = await pixels(page, 'plot-canvas');
  await page.keyboard.press('End');
  await page.keyboard.type('(A');
  await quiet(page);
  await goToLine(page, 'N001');
  const after = await pixels(page, 'plot-canvas');
  // Chords of another length on the arcs are a matter of some pixels; another view is a matter of thousands.
  assert.ok(difference(held, after) < 500, `${difference(held, after)} pixels`);
  await page.locator('#zoom-fit').click();
  await quiet(page);
  assert.ok(difference(held, await pixels(page, 'plot-canvas')) > 2000, 'fitted it looks otherwise');
  await leave();
});

/**
 * The colour of lines is on the left and on the right half of the picture, and not at its edges.
 * @param {Page} page
 */
async function isPathSeen(page) {
  const size = await page.locator('#plot-canvas').evaluate((canvas) => ({ width: /** @type {HTMLCanvasElement} */ (canvas).width, height: /** @type {HTMLCanvasElement} */ (canvas).height }));
  const picture = await pixels(page, 'plot-canvas');
  const green = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue('--kind-line').trim());
  const [red, middle, blue] = [1, 3, 5].map((at) => Number.parseInt(green.slice(at, at + 2), 16));
  const wanted = ((255 << 24) | (blue << 16) | (middle << 8) | red) >>> 0;
  const found = [];
  for (let i = 0; i < picture.length; i += 1) if (picture[i] === wanted) found.push([i % size.width, Math.floor(i / size.width)]);
  const xs = found.map(([x]) => x);
  const ys = found.map(([, y]) => y).filter((y) => y > 30);
  const spread = Math.max(...xs) - Math.min(...xs) > size.width / 4 || Math.max(...ys) - Math.min(...ys) > size.height / 4;
  return found.length > 50 && spread && Math.min(...xs) > 0 && Math.max(...ys) < size.height - 1;
}

test('after a paste the cursor stands where there is something to be seen', async () => {
  const { page, leave } = await visit(started);
  const original = await text(page);
  await paste(page, original);
  assert.match(await page.locator('.cm-lit').innerText(), /^N002/);
  assert.match(await page.locator('#span-caption').innerText(), /^Line of N002/, 'its first span');
  assert.match((await page.locator('#strip').getAttribute('aria-valuetext')) ?? '', /block N002/);

  // Text that replaces less than the whole leaves the cursor where typing goes on.
  await endOfLine(page, 'N012');
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.setData('text/plain', '\n(MORE)');
    const target = document.getElementById('editor')?.shadowRoot?.querySelector('.cm-content');
    target?.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
  });
  await quiet(page);
  await page.keyboard.type('X');
  assert.match(await text(page), /\(MORE\)X/);
  await leave();
});

test('a drag of the decimal sign is one step of undo', async () => {
  const { page, leave } = await visit(started);
  const format = page.locator('#format-text');
  const before = await format.innerText();
  const box = await page.locator('#decimals').boundingBox();
  assert.ok(box);
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 2, y);
  await page.mouse.down();
  /** @type {Set<string>} */
  const seen = new Set();
  for (const share of [0.4, 0.3, 0.2, 0.1, 0.02]) {
    await page.mouse.move(box.x + box.width * share, y);
    await page.waitForTimeout(150);
    seen.add(await format.innerText());
  }
  await page.mouse.up();
  await quiet(page);
  assert.ok(seen.size > 1, 'the format follows while the hand moves');
  assert.notEqual(await format.innerText(), before);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await format.innerText(), before);
  await page.keyboard.press('Control+Shift+z');
  await quiet(page);
  assert.notEqual(await format.innerText(), before, 'and done again');
  await leave();
});

test('one’s own tape waits while an example is looked at', async () => {
  const { page, leave } = await visit(started);
  const picker = page.locator('#preset');
  const about = page.locator('#about-tape');
  assert.match(await about.innerText(), /annex E/);
  assert.equal(await picker.locator('option', { hasText: 'Your tape' }).evaluate((option) => /** @type {HTMLElement} */ (option).hidden), true);
  await endOfLine(page, 'N005');
  await page.keyboard.type('(MINE)');
  assert.equal(await picker.inputValue(), '');
  assert.match(await about.innerText(), /Your own tape/);
  await picker.selectOption({ index: 2 });
  await quiet(page);
  assert.doesNotMatch(await text(page), /MINE/);
  assert.match(await about.innerText(), /parabol/i);
  await picker.selectOption('');
  await quiet(page);
  assert.match(await text(page), /F0013\(MINE\)/);
  assert.match(await page.locator('#format-text').innerText(), /CSM 333/, 'with its format');
  await leave();
});

test('an example that is changed leaves the visitor’s tape to be chosen, and gives it back when it is undone', async () => {
  const { page, leave } = await visit(started);
  const picker = page.locator('#preset');
  const shown = () => picker.locator('option:not([hidden])').allInnerTexts();
  await endOfLine(page, 'N005');
  await page.keyboard.type('(MINE)');
  await picker.selectOption({ index: 2 });
  await quiet(page);
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('(OTHER)');
  await quiet(page);
  assert.ok((await shown()).includes('Your earlier tape'), (await shown()).join(', '));
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.ok(!(await shown()).includes('Your earlier tape'), 'undone, it is an example again');
  await picker.selectOption('');
  await quiet(page);
  assert.match(await text(page), /MINE/);
  await picker.selectOption({ index: 2 });
  await quiet(page);
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('(OTHER)');
  await quiet(page);
  await page.waitForTimeout(1200);
  await page.reload();
  await quiet(page);
  assert.match(await text(page), /OTHER/);
  await picker.selectOption({ label: 'Your earlier tape' });
  await quiet(page);
  assert.match(await text(page), /MINE/, 'it outlives a reload');
  await picker.selectOption({ label: 'Your earlier tape' });
  await quiet(page);
  assert.match(await text(page), /OTHER/, 'the two change places');
  await leave();
});

test('Page Down behind the last block stays there, and Page Up comes back to it', async () => {
  const { page, leave } = await visit(started);
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('%');
  await quiet(page);
  await page.locator('#strip').focus();
  await page.keyboard.press('End');
  await quiet(page);
  const row = async () => (await page.locator('#strip').getAttribute('aria-valuetext')) ?? '';
  const last = await row();
  assert.doesNotMatch(last, /block/);
  await page.keyboard.press('PageDown');
  await quiet(page);
  assert.equal(await row(), last);
  await page.keyboard.press('PageUp');
  await quiet(page);
  assert.match(await row(), /block N012, character N/);
  await leave();
});

test('a new line begins empty, whatever blanks and tabs the one before it begins with', async () => {
  const { page, leave } = await visit(started);
  await paste(page, '%\n\t  N001 M03\n');
  await endOfLine(page, 'N001');
  await page.keyboard.press('Enter');
  await page.keyboard.type('N002');
  assert.deepEqual(await lines(page), ['%', '\t  N001 M03', 'N002', '']);
  await leave();
});
