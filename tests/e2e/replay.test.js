// The tape at work: head, tool, registers and timeline move together, by themselves and by the hand.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NARROW, difference, goToLine, paste, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @type {{ reducedMotion: 'no-preference' }} */
const moving = { reducedMotion: 'no-preference' };

/** @param {Page} page */
const litLine = (page) => page.locator('.cm-lit').first().innerText();
/** @param {Page} page */
const row = async (page) => (await page.locator('#strip').getAttribute('aria-valuetext')) ?? '';
/** @param {Page} page */
const note = (page) => page.locator('#replay-note').innerText();

/**
 * A register by its name, as it is shown.
 * @param {Page} page
 * @param {string} name
 */
const register = (page, name) => page.locator('#registers tr', { has: page.getByRole('rowheader', { name, exact: true }) }).locator('td').innerText();

/** @param {Page} page */
const position = async (page) => (await page.locator('#registers .axes td').allInnerTexts()).map((text) => Number(text.replace('−', '-')));

/**
 * Presses a key on the timeline so many times.
 * @param {Page} page
 * @param {...string} keys
 */
async function press(page, ...keys) {
  await page.locator('#replay-time').focus();
  for (const key of keys) await page.keyboard.press(key);
  await quiet(page);
}

/**
 * All places where something stands, to see that nothing shifts.
 * @param {Page} page
 */
const places = (page) =>
  page.evaluate(() =>
    ['plot', 'replay', 'registers', 'timeline', 'speed', 'replay-clock', 'span-caption', 'totals']
      .map((id) => [id, /** @type {HTMLElement} */ (document.getElementById(id)).getBoundingClientRect()])
      .map(([id, box]) => `${id} ${JSON.stringify(box)}`),
  );

test('play takes the tape from the first block to the end of the program', async () => {
  const { page, leave } = await visit(started, { options: moving });
  await press(page, 'Home');
  assert.match(await row(page), /block N001, character N/);
  // All blocks that were lit on the way.
  await page.evaluate(() => {
    const place = /** @type {HTMLElement} */ (document.getElementById('registers-place'));
    const seen = new Set([place.textContent]);
    new MutationObserver(() => seen.add(place.textContent)).observe(place, { childList: true, characterData: true, subtree: true });
    Object.assign(window, { seen });
  });
  await page.locator('#speed').selectOption('16');
  await page.locator('#play').click();
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Pause');
  await page.waitForFunction(() => document.getElementById('replay-note')?.textContent !== '');
  await quiet(page);
  assert.equal(await note(page), 'Stopped behind N012: M30 End of tape (rewind)');
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
  assert.match(await litLine(page), /^N012/);
  assert.match(await row(page), /block N012, character end of block/);
  assert.deepEqual(await position(page), [10, 10, 20]);
  assert.match(await register(page, 'Spindle'), /^M30/);
  assert.equal(await page.locator('#replay-clock').innerText(), '0:47.2 / 0:47.2');
  const seen = /** @type {string[]} */ (await page.evaluate(() => [.../** @type {any} */ (window).seen]));
  for (const block of ['N002', 'N005', 'N006', 'N010', 'N011']) assert.ok(seen.includes(block), `${block} of ${seen}`);
  await leave();
});

test('in the middle of an arc, tape, tool and registers have come equally far; pause holds them there', async () => {
  const { page, leave } = await visit(started, { options: moving });
  await goToLine(page, 'N006');
  const still = await pixels(page, 'plot-canvas');
  const first = Number(/^Row (\d+)/.exec(await row(page))?.[1]);
  assert.deepEqual(await position(page), [30.858, 49.142, 10]);
  await page.locator('#speed').selectOption('0.25');
  await page.locator('#play').click();
  await page.waitForFunction((from) => Number(/^Row (\d+)/.exec(document.getElementById('tape-words')?.textContent ?? '')?.[1]) > from + 5, first);
  await page.locator('#play').click();
  await quiet(page);
  assert.match(await litLine(page), /^N006/);
  assert.equal(await page.locator('#registers-place').innerText(), 'N006');
  assert.match(await register(page, 'Motion'), /^G02 Circular interpolation/);

  // 51 rows, from N to the end of block: as far as the row has come, the tool has come along 45 degrees about (45, 35).
  const [, now, rows] = /^Row (\d+) of (\d+), block N006/.exec(await row(page)) ?? [];
  assert.equal(rows, '417');
  const [x, y] = await position(page);
  const swept = 135 - (Math.atan2(y - 35, x - 45) * 180) / Math.PI;
  const share = (Number(now) - first) / 50;
  assert.ok(Math.abs(swept / 45 - share) < 0.02, `${swept} of 45 degrees, ${share} of the rows`);
  // Three places behind the decimal sign, in each of two axes.
  assert.ok(Math.abs(Math.hypot(x - 45, y - 35) - 20) < 0.002, 'on the circle');
  assert.ok(difference(still, await pixels(page, 'plot-canvas')) > 300, 'the path ahead is faint, the tool has moved');

  // Another half a second: nothing moves any more.
  const before = [await pixels(page, 'plot-canvas'), await pixels(page, 'strip-canvas')];
  await quiet(page);
  assert.equal(difference(before[0], await pixels(page, 'plot-canvas')), 0);
  assert.equal(difference(before[1], await pixels(page, 'strip-canvas')), 0);
  await leave();
});

test('step by step: blocks, spans and rows, forward and back', async () => {
  const { page, leave } = await visit(started);
  const step = (/** @type {string} */ name) => page.getByRole('button', { name, exact: true }).click();
  await press(page, 'Home');
  for (let i = 0; i < 5; i += 1) await step('On by one block');
  await quiet(page);
  assert.match(await litLine(page), /^N005/);
  assert.deepEqual(await position(page), [30.858, 49.142, 10]);
  assert.match(await row(page), /block N005, character end of block/);
  assert.match(await page.locator('#span-caption').innerText(), /^Line of N005/);
  await step('Back by one block');
  await quiet(page);
  assert.match(await litLine(page), /^N004/);
  assert.deepEqual(await position(page), [15, 33.284, 10]);

  await step('On by one row');
  await quiet(page);
  assert.match(await row(page), /block N005, character N,/);
  assert.deepEqual(await position(page), [15, 33.284, 10], 'N005 has only begun');
  await step('Back by one row');
  await quiet(page);
  assert.match(await row(page), /block N004, character end of block/);

  // N001 moves nothing: the first span is that of N002.
  await press(page, 'Home');
  await step('On by one span');
  await quiet(page);
  assert.match(await litLine(page), /^N002/);
  assert.deepEqual(await position(page), [10, 10, 10]);
  await step('On by one span');
  await step('On by one span');
  await step('Back by one span');
  await quiet(page);
  assert.match(await litLine(page), /^N003/);
  assert.deepEqual(await position(page), [15, 15, 10]);
  await leave();
});

test('an arc in two blocks is one step by span and two by block', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#preset').selectOption('annex-d-boring');
  await quiet(page);
  // Of N001 to N012 all but N001, N008 and N009 move the tool.
  await press(page, 'Home', ...Array(9).fill('PageDown'));
  assert.match(await register(page, 'Tool'), /^T02 M06 Tool change/);
  assert.match(await litLine(page), /^N012/);
  await press(page, 'PageDown');
  assert.match(await litLine(page), /^N014/);
  assert.deepEqual(await position(page), [140, 85, -4]);
  await press(page, 'ArrowLeft');
  assert.match(await litLine(page), /^N013/);
  assert.deepEqual(await position(page), [180, 85, -4], 'at the point between, the tool has not left');
  assert.match(await register(page, 'Speed'), /^S712 1200 rev\/min/);
  assert.equal(await register(page, 'B'), 'B5');
  assert.match(await register(page, 'Feed kind'), /^\(G93\)/, 'the tape does not state it');
  assert.equal(await note(page), 'Assumed for the replay: rapid 5000 mm/min');
  await leave();
});

test('the timeline goes where it is pressed, and tells where that is', async () => {
  const { page, leave } = await visit(started);
  const box = await page.locator('#replay-time').boundingBox();
  assert.ok(box);
  // N011 takes from 29.7 s to 44.7 s of 47.2 s.
  await page.mouse.click(box.x + 7 + 0.7 * (box.width - 14), box.y + box.height / 2);
  await quiet(page);
  assert.match(await litLine(page), /^N011/);
  const [x, y] = await position(page);
  // 33.05 s: 3.32 s of 15 s, from X 85 by 70 mm to the left.
  assert.ok(Math.abs(x - (85 - (70 * 3.32) / 15)) < 1 && y === 15, `${x} ${y}`);
  assert.match((await page.locator('#replay-time').getAttribute('aria-valuetext')) ?? '', /^N011, 3[23]\.\d+ s of 47\.\d+ s$/);
  await press(page, 'End');
  assert.match(await litLine(page), /^N012/);
  await leave();
});

test('single block waits behind every block; Space plays on the tape, the path and the timeline', async () => {
  const { page, leave } = await visit(started, { options: moving });
  await press(page, 'Home');
  await page.locator('#single').check();
  await page.locator('#speed').selectOption('64');
  for (const [where, block] of [['#strip', 'N001'], ['#plot-canvas', 'N002'], ['#replay-time', 'N003']]) {
    await page.locator(where).focus();
    await page.keyboard.press('Space');
    await page.waitForFunction((words) => document.getElementById('replay-note')?.textContent === words, `Stopped behind ${block}`);
    await quiet(page);
    assert.match(await litLine(page), new RegExp(`^${block}`));
    assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
  }
  assert.deepEqual(await position(page), [15, 15, 10]);
  await leave();
});

const SKIPPED = '%\nN001\tG01\t\tX+010000\t\t\t\tF0100\n/N002\t\t\tX+010000\t\t\t\tF0100\nN003\t\t\tX+010000\t\t\t\tF0100\tM00\nN004\t\t\t\tY+010000\t\t\tF0100\tM30\n';

test('play waits behind a program stop; the skip switch leaves its block out', async () => {
  const { page, leave } = await visit(started, { options: moving });
  await paste(page, SKIPPED);
  await page.locator('#speed').selectOption('64');
  for (const [skip, x, stands] of /** @type {[boolean, number, string][]} */ ([[false, 40, '/N002'], [true, 30, '/N002']])) {
    await page.locator('#skip').setChecked(skip);
    await quiet(page);
    await press(page, 'Home');
    await page.locator('#play').click();
    await page.waitForFunction(() => document.getElementById('replay-note')?.textContent?.startsWith('Stopped behind N003'));
    await quiet(page);
    assert.equal(await note(page), 'Stopped behind N003: M00 Program stop');
    assert.equal((await position(page))[0], x);
    await press(page, 'ArrowLeft');
    assert.ok((await litLine(page)).startsWith(stands));
    assert.equal(await page.locator('#registers-place').innerText(), skip ? 'N002 is skipped' : 'N002');
    assert.equal((await position(page))[0], skip ? 20 : 30);
    // Play goes on behind the stop.
    await press(page, 'ArrowRight');
    await page.locator('#play').click();
    await page.waitForFunction(() => document.getElementById('replay-note')?.textContent?.includes('M30'));
  }
  await leave();
});

test('an edit and a cursor set elsewhere end the play, and the hand keeps its place', async () => {
  const { page, leave } = await visit(started, { options: moving });
  await page.locator('#speed').selectOption('0.25');
  const text = async () => (await page.locator('.cm-line').allTextContents()).join('\n');
  const written = await text();
  const playing = () => page.locator('#play').getAttribute('aria-label');
  await page.locator('#play').click();
  assert.equal(await playing(), 'Pause');
  await goToLine(page, 'N010');
  assert.equal(await playing(), 'Play');
  assert.match(await litLine(page), /^N010/);
  assert.deepEqual((await position(page)).slice(0, 2), [85, 43.284]);

  await page.locator('#play').click();
  assert.equal(await playing(), 'Pause');
  await page.locator('.cm-content').focus();
  await page.keyboard.type('X');
  assert.equal(await playing(), 'Play');
  await quiet(page);
  const typed = await text();
  assert.equal(typed.length, written.length + 1);
  assert.match(await litLine(page), /X.*N010|N010.*X/, 'typed where the play stood');
  await page.keyboard.press('Control+z');
  await quiet(page);
  await page.locator('#play').click();
  assert.equal(await playing(), 'Pause', 'the tape as it is now plays');
  await leave();
});

test('with less motion play goes from the end of one block to the end of the next', async () => {
  const { page, leave } = await visit(started);
  await press(page, 'Home');
  await page.evaluate(() => {
    const words = /** @type {HTMLElement} */ (document.getElementById('tape-words'));
    /** @type {string[]} */
    const rows = [];
    new MutationObserver(() => rows.push(words.textContent ?? '')).observe(words, { childList: true, characterData: true, subtree: true });
    Object.assign(window, { rows });
  });
  await page.locator('#speed').selectOption('64');
  await page.locator('#play').click();
  await page.waitForFunction(() => document.getElementById('replay-note')?.textContent?.startsWith('Stopped behind N012'));
  const rows = /** @type {string[]} */ (await page.evaluate(() => /** @type {any} */ (window).rows));
  assert.ok(rows.length >= 12, rows.join('\n'));
  for (const words of rows) assert.match(words, /end of block/);
  await leave();
});

test('nothing shifts while the tape runs, wide and narrow', async () => {
  for (const options of [moving, { ...moving, viewport: NARROW, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }]) {
    const { page, leave } = await visit(started, { options });
    if ('isMobile' in options) await page.getByRole('tab', { name: 'Path' }).tap();
    await page.locator('#preset').selectOption('annex-d-boring');
    await quiet(page);
    const before = await places(page);
    for (const key of ['Home', 'ArrowRight', 'ArrowRight', 'PageDown', 'End']) {
      await press(page, key);
      assert.deepEqual(await places(page), before, key);
    }
    await page.locator('#speed').selectOption('64');
    await page.locator('#play').click();
    await page.waitForFunction(() => document.getElementById('registers-place')?.textContent === 'N006');
    assert.deepEqual(await places(page), before, 'while it plays');
    await leave();
  }
});

test('on a telephone the replay stands under the path, and the registers can be reached', async () => {
  const { page, leave } = await visit(started, { options: { viewport: NARROW, hasTouch: true, isMobile: true, deviceScaleFactor: 2 } });
  await page.getByRole('tab', { name: 'Path' }).tap();
  for (const id of ['play', 'replay-time']) {
    const box = await page.locator(`#${id}`).boundingBox();
    assert.ok(box && box.y + box.height <= NARROW.height && box.height >= 43.5, `${id} ${JSON.stringify(box)}`);
  }
  const registers = page.locator('#registers tr').last();
  await registers.scrollIntoViewIfNeeded();
  const box = await registers.boundingBox();
  assert.ok(box && box.y > 0 && box.y + box.height <= NARROW.height);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), NARROW.width);
  await leave();
});
