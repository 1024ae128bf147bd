// The playground in the pages of others: a frame by itself, the element around it, and what they say to one another.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { dist, quiet, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Frame} Frame */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** A host page, by its address below the site; nothing in it is waited for. @param {string} path @param {import('./support/playground.js').Visit} [how] */
const open = (path, how = {}) => visit(started, { firstTime: true, ready: false, path, ...how });

/**
 * The frame in an element or of an iframe, once its tape is there.
 * @param {Page} page
 * @param {string} selector
 * @returns {Promise<Frame>}
 */
async function frameIn(page, selector) {
  const host = page.locator(selector);
  await host.scrollIntoViewIfNeeded();
  const inner = (await host.evaluate((element) => element.localName)) === 'iframe' ? host : host.locator('iframe');
  await inner.waitFor();
  const handle = await inner.elementHandle();
  const frame = await handle?.contentFrame();
  assert.ok(frame, `${selector} has a frame`);
  await shown(frame);
  return frame;
}

/** The tape is read, and what was found is shown. @param {Frame | Page} frame */
async function shown(frame) {
  await frame.waitForFunction(() => document.getElementById('strip')?.hasAttribute('aria-valuetext'));
  await frame.waitForTimeout(700);
}

/** @param {Frame | Page} frame */
const text = async (frame) => (await frame.locator('.cm-line').allTextContents()).join('\n');

/** Keeps what an element dispatches, by its name. @param {Page} page @param {string} id */
const listen = (page, id) =>
  page.evaluate((name) => {
    const heard = /** @type {[string, any][]} */ ([]);
    Object.assign(window, { heard });
    for (const type of ['ready', 'change', 'diagnostics', 'select', 'solved', 'error']) {
      document.getElementById(name)?.addEventListener(type, (event) => heard.push([type, /** @type {CustomEvent} */ (event).detail]));
    }
  }, id);

/** @param {Page} page @param {string} type @returns {Promise<any[]>} */
const heard = (page, type) =>
  page.evaluate((wanted) => /** @type {any} */ (window).heard.filter((/** @type {[string, any]} */ [name]) => name === wanted).map((/** @type {[string, any]} */ [, detail]) => detail), type);

/** An empty page with one element in it. @param {Page} page @param {Record<string, string>} attributes @param {string} [inner] */
async function put(page, attributes, inner = '') {
  await page.evaluate(
    ([given, inside]) => {
      const element = document.createElement('nc-tape');
      for (const [name, value] of Object.entries(given)) element.setAttribute(name, value);
      element.id = 'one';
      element.textContent = inside;
      document.querySelector('main')?.replaceChildren(element);
    },
    /** @type {[Record<string, string>, string]} */ ([attributes, inner]),
  );
  await listen(page, 'one');
}

/** A method of that element. @param {Page} page @param {string} name @param {string[]} args @returns {Promise<any>} */
const call = (page, name, ...args) =>
  page.evaluate(([method, given]) => /** @type {any} */ (document.getElementById('one'))[/** @type {string} */ (method)](...given), /** @type {[string, string[]]} */ ([name, args]));

const FORMAT = '{"standard":"iso2539","classification":"CSM 332","detail":"N3.G2.X+33.Y+33.F4.M2*"}';
const TAPE = '%\nN001 G01 X+010000 Y+010000 F0300\nN002 X+040000\nN003 M30\n';

test('three of them work in one page, whose address stays and in which nothing is stored', async () => {
  const { page, leave } = await open('embedding.html');
  const address = page.url();
  for (const selector of ['#tape', '#exercise', '#frame']) {
    const frame = await frameIn(page, selector);
    await frame.locator('.cm-content').focus();
    await page.keyboard.press('Control+End');
    await page.keyboard.type('(');
    await quiet(page);
    await assert.rejects(frame.evaluate(() => localStorage.length), /SecurityError/);
    assert.ok(!frame.url().includes('?') && frame.url().includes('embed.html#'), frame.url());
    const isRead = selector === '#frame';
    assert.equal((await text(frame)).endsWith('()'), !isRead, `${selector} ${isRead ? 'is only read' : 'is written'}`);
  }
  assert.equal(page.url(), address);
  assert.deepEqual(await page.evaluate(() => [localStorage.length, sessionStorage.length, history.length]), [0, 0, 2]);
  await leave();
});

test('the page itself runs from a disk, and so does a page around it', async () => {
  const { page, leave } = await open('embed.html#preset=annex-e-parabolic', { site: pathToFileURL(`${dist}/`).href });
  await shown(page);
  assert.match(await page.locator('#format-text').innerText(), /X33/);
  await page.locator('#preset').selectOption('annex-e-circular');
  await shown(page);
  assert.match(await text(page), /G03/);
  await page.goto(pathToFileURL(`${dist}/embedding.html`).href);
  const frame = await frameIn(page, '#exercise');
  assert.match(await text(frame), /N003 Y\+03000/);
  await leave();
});

test('a link to CLDATA is said to be one, and something else is shown', async () => {
  const content = JSON.stringify({ source: '1,1045/', format: JSON.parse(FORMAT), cursor: 0, kind: 'cldata' });
  const { page, leave } = await open(`embed.html#1.${deflateRawSync(Buffer.from(content)).toString('base64url')}`);
  await shown(page);
  assert.match(await page.locator('#notice').innerText(), /holds CLDATA/);
  assert.match(await text(page), /N001/);
  await leave();
});

test('an exercise says when its goal is met, and not before', async () => {
  const { page, leave } = await open('embedding.html');
  const frame = await frameIn(page, '#exercise');
  assert.equal(await frame.locator('#goal').innerText(), 'Goal: no errors, and the given path within 0.01 mm.');
  await listen(page, 'exercise');
  await frame.getByRole('button', { name: /Fill it up with zeros in front/ }).click();
  await quiet(page);
  assert.equal(await frame.locator('.cm-squiggle-error').count(), 0);
  assert.deepEqual(await heard(page, 'solved'), [], 'without errors, and yet another path');
  for (const [line, digits] of [['N003', '30000'], ['N004', '10000']]) {
    await frame.locator('.cm-line', { hasText: line }).click();
    await page.keyboard.press('End');
    for (let i = 0; i < 5; i += 1) await page.keyboard.press('Backspace');
    await page.keyboard.type(digits);
  }
  await quiet(page);
  assert.deepEqual(await heard(page, 'solved'), [{ goal: 'no errors, and the given path within 0.01 mm' }]);
  assert.match(await frame.locator('#goal').innerText(), /^Done: /);
  assert.match(await page.locator('#verdict').innerText(), /^Solved/);
  assert.equal(await page.locator('#exercise').evaluate((element) => /** @type {any} */ (element).solved), true);
  await leave();
});

test('the other goals: at most so many rows, and the path of a linked tape in other blocks', async () => {
  const { page, leave } = await open('');
  await page.locator('#strip[aria-valuetext]').waitFor();
  await page.locator('#share-button').click();
  const link = await page.locator('#share-link').inputValue();
  const source = await page.evaluate(() => document.getElementById('editor')?.shadowRoot?.querySelector('.cm-content')?.textContent);
  assert.ok(source);
  await page.goto(`${started.address}embedding.html`);
  await put(page, { preset: 'annex-e-circular', loading: 'eager', goal: 'rows=411,path=0.001', 'goal-tape': link });
  const frame = await frameIn(page, '#one');
  assert.equal((await heard(page, 'solved')).length, 0, '417 rows are too many');
  const before = await call(page, 'getText');
  await call(page, 'setText', before.replace('\t\t\t\t\t\t\tM05', '\tM05'));
  await quiet(page);
  assert.equal((await heard(page, 'solved')).length, 1, await frame.locator('#goal').innerText());
  await leave();
});

test('the element has methods and events', async () => {
  const { page, leave } = await open('embedding.html');
  await put(page, { format: FORMAT, views: 'text problems' }, TAPE);
  assert.equal(await call(page, 'getText'), TAPE);
  assert.equal((await heard(page, 'ready')).length, 1);
  await call(page, 'select', 'N002');
  await quiet(page);
  assert.deepEqual((await heard(page, 'select')).at(-1), { block: 'N002', number: 2 });
  await call(page, 'select', '3');
  await quiet(page);
  assert.deepEqual((await heard(page, 'select')).at(-1), { block: 'N003', number: 3 });
  await call(page, 'setText', TAPE.replace('X+040000', 'X+04000'));
  await quiet(page);
  assert.equal((await heard(page, 'change')).at(-1).text, TAPE.replace('X+040000', 'X+04000'));
  const { errors, list } = (await heard(page, 'diagnostics')).at(-1);
  assert.equal(errors, 1);
  assert.deepEqual([list[0].rule, list[0].line, list[0].column], ['NUM-01', 3, 6]);
  await call(page, 'reset');
  assert.equal(await call(page, 'getText'), TAPE);
  const frame = await frameIn(page, '#one');
  await frame.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  assert.match(await call(page, 'getText'), /X\+04000\n/, 'a reset is undone');
  assert.deepEqual(await heard(page, 'error'), []);
  await leave();
});

test('it is loaded when it comes into sight, or when it is asked for', async () => {
  const { page, leave } = await open('embedding.html');
  await page.evaluate(() => {
    const far = document.createElement('div');
    far.style.height = '4000px';
    document.querySelector('main')?.replaceChildren(far);
    for (const [id, loading] of [['sight', ''], ['click', 'click']]) {
      const element = document.createElement('nc-tape');
      element.id = id;
      element.setAttribute('loading', loading);
      element.textContent = '%\nN001 M30\n';
      document.querySelector('main')?.append(element);
    }
  });
  await quiet(page);
  assert.equal(await page.locator('nc-tape iframe').count(), 0);
  assert.match(await page.locator('#sight').innerText(), /N001 M30/);
  await page.locator('#sight').scrollIntoViewIfNeeded();
  await page.locator('#sight iframe').waitFor();
  await page.locator('#click').scrollIntoViewIfNeeded();
  await quiet(page);
  assert.equal(await page.locator('#click iframe').count(), 0);
  await page.locator('#click').getByRole('button', { name: 'Load the playground' }).click();
  await page.locator('#click iframe').waitFor();
  await leave();
});

test('its attributes choose the views, the theme and whether it is written', async () => {
  const { page, leave } = await open('embedding.html');
  await put(page, { preset: 'annex-e-circular', views: 'text,plot', theme: 'dark', 'read-only': '', block: 'N006' });
  const frame = await frameIn(page, '#one');
  const seen = async () => Object.fromEntries(await Promise.all(['tape', 'program', 'problems', 'path', 'reset'].map(async (id) => [id, await frame.locator(`#${id}`).isVisible()])));
  assert.deepEqual(await seen(), { tape: false, program: true, problems: false, path: true, reset: false });
  assert.equal(await frame.locator('html').getAttribute('data-theme'), 'dark');
  assert.match(await frame.locator('#span-caption').innerText(), /N006/);
  await frame.locator('.cm-content').focus();
  const before = await text(frame);
  for (const key of ['a', 'Backspace', 'Enter', 'Control+i', 'Alt+ArrowUp', 'Shift+ArrowRight', '1']) await page.keyboard.press(key);
  assert.equal(await text(frame), before);
  await page.evaluate(() => {
    const element = document.getElementById('one');
    element?.setAttribute('theme', 'light');
    element?.setAttribute('views', 'strip');
    element?.removeAttribute('read-only');
  });
  await quiet(page);
  assert.deepEqual(await seen(), { tape: true, program: false, problems: false, path: false, reset: true });
  assert.equal(await frame.locator('html').getAttribute('data-theme'), 'light');
  await leave();
});

test('the full page opens with the text as it is by then', async () => {
  const { page, leave } = await open('embedding.html');
  const frame = await frameIn(page, '#exercise');
  await frame.locator('.cm-content').focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('(by hand');
  await quiet(page);
  const opened = page.context().waitForEvent('page');
  await frame.getByRole('link', { name: 'Full page' }).click();
  const full = await opened;
  await full.locator('.cm-line').first().waitFor();
  await quiet(full);
  assert.match(await text(full), /N006 M30\n\(by hand\)$/);
  assert.match(await full.locator('#format-text').innerText(), /CSM 332/);
  await leave();
});

test('what is taken out of the page and put back is as it was left', async () => {
  const { page, leave } = await open('embedding.html');
  await put(page, { format: FORMAT }, TAPE);
  await frameIn(page, '#one');
  await call(page, 'setText', `${TAPE}(mine)\n`);
  await quiet(page);
  await page.evaluate(() => {
    const element = /** @type {HTMLElement} */ (document.getElementById('one'));
    element.remove();
    document.querySelector('main')?.append(element);
  });
  const frame = await frameIn(page, '#one');
  assert.match(await text(frame), /\(mine\)/);
  await frame.locator('#reset').click();
  assert.doesNotMatch(await text(frame), /\(mine\)/);
  await leave();
});

test('in a narrow frame the panes are tabs', async () => {
  const { page, leave } = await open('embedding.html', { options: { viewport: { width: 390, height: 844 } } });
  const frame = await frameIn(page, '#exercise');
  await frame.getByRole('tab', { name: /Problems/ }).click();
  assert.equal(await frame.locator('#program').isVisible(), false);
  await frame.locator('.problem').first().click();
  assert.equal(await frame.locator('#program').isVisible(), true);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await leave();
});

test('a problem explains itself, and a row of holes', async () => {
  const { page, leave } = await open('embedding.html');
  const exercise = await frameIn(page, '#exercise');
  await exercise.getByRole('button', { name: 'About NUM-01' }).click();
  assert.match(await exercise.locator('#rule-title').innerText(), /digits/);
  assert.equal(await exercise.getByRole('button', { name: 'Open this example' }).count(), 0, 'an exercise is not replaced');
  await exercise.locator('#rule-page').getByRole('button', { name: 'Close' }).click();
  assert.equal(await exercise.locator('#rule-page').isVisible(), false);
  const tape = await frameIn(page, '#tape');
  await tape.locator('#row-button').click();
  assert.match(await tape.locator('#row-card').innerText(), /N006.*character|ISO 840/s);
  await leave();
});
