// Nothing that is pasted, and nothing that fails behind the page, leaves the visitor without words.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { goToLine, lines, paste, quiet, root, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

test('binary rubbish leaves the page working', async () => {
  const { page, leave } = await visit(started);
  const original = (await lines(page)).join('\n');
  let rubbish = '';
  let state = 7;
  for (let i = 0; i < 20_000; i += 1) {
    state = (state * 1_103_515_245 + 12_345) % 2_147_483_648;
    rubbish += String.fromCharCode(state >> 8 & (i % 50 === 0 ? 0xffff : 0xff));
  }
  await paste(page, rubbish);
  await page.waitForTimeout(1000);
  assert.ok((await page.locator('#problem-list > li').count()) > 0);
  await paste(page, original);
  assert.doesNotMatch(await page.locator('#tallies').innerText(), /error/);
  await goToLine(page, 'N009');
  assert.match(await page.locator('#span-caption').innerText(), /N009/);
  await leave();
});

test('a trap starts the worker again with the current text, and says so', async () => {
  const { page, leave } = await visit(started);
  const [worker] = page.workers();
  await worker.evaluate(() => {
    const fail = () => {
      throw new WebAssembly.RuntimeError('unreachable');
    };
    TextEncoder.prototype.encodeInto = fail;
    TextEncoder.prototype.encode = fail;
  });
  await goToLine(page, 'N010');
  await page.keyboard.press('End');
  // What is not ASCII goes the way of the encoder.
  await page.keyboard.type('Ω');
  await quiet(page);
  assert.match(await page.locator('#notice').innerText(), /fault of its own.*started again with your text/);
  assert.notEqual(page.workers()[0], worker);
  assert.match((await lines(page)).join('\n'), /F0010Ω/);

  // The new worker reads on.
  await goToLine(page, 'N011');
  assert.match(await page.locator('#span-caption').innerText(), /N011/);
  await page.locator('#notice').getByRole('button').click();
  assert.ok(await page.locator('#notice').isHidden());
  await leave();
});

test('wasm that cannot be loaded is said plainly', async () => {
  const { page, troubles } = await visit(started, {
    ready: false,
    before: (other) => other.route('**/*.wasm', (route) => route.abort()),
  });
  await page.locator('#notice').waitFor();
  assert.match(await page.locator('#notice').innerText(), /could not be loaded.*Reload/);
  troubles.length = 0;
  await page.context().close();
});

test('opened as a file, the page says how it is started', async () => {
  const context = await started.browser.newContext();
  const page = await context.newPage();
  await page.goto(pathToFileURL(`${root}index.html`).href);
  await page.waitForTimeout(1300);
  const words = page.locator('#start');
  assert.ok(await words.isVisible());
  assert.match(await words.innerText(), /cargo xtask serve/);
  await context.close();

  const scriptless = await started.browser.newContext({ javaScriptEnabled: false });
  const silent = await scriptless.newPage();
  await silent.goto(started.address);
  assert.match(await silent.locator('body').innerText(), /allow scripts/);
  await scriptless.close();
});

test('no script, style or connection from elsewhere is allowed', async () => {
  const { page, leave } = await visit(started);
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  assert.match(policy ?? '', /default-src 'none'/);
  assert.doesNotMatch(policy ?? '', /unsafe-inline|'unsafe-eval'|https?:|\*/);
  await leave();
});
