// Opens the page as a visitor would, and watches that nothing goes wrong behind it.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from './server.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Locator} Locator */

export const root = fileURLToPath(new URL('../../../', import.meta.url));
export const dist = resolve(process.env.NCTAPE_DIST ?? `${root}dist`);

const WIDE = { width: 1440, height: 900 };
export const NARROW = { width: 390, height: 844 };

export async function startBrowser() {
  const site = await serve(dist);
  const browser = await chromium.launch({
    executablePath: process.env.NCTAPE_BROWSER ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--disable-dev-shm-usage',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--no-first-run',
      '--disable-quic',
    ],
  });
  return {
    browser,
    address: site.address,
    async close() {
      await browser.close();
      site.close();
    },
  };
}

/** @typedef {Awaited<ReturnType<typeof startBrowser>>} Started */

/**
 * @typedef {object} Visit
 * @property {import('playwright-core').BrowserContextOptions} [options]
 * @property {boolean} [firstTime]  show the hints
 * @property {(page: Page) => Promise<unknown>} [before]  done before the page is opened
 * @property {boolean} [ready]  wait until the tape is there: true
 * @property {string} [path]  of the page below the site: the playground
 * @property {string} [site]  where the pages are: on the server of the test
 */

/**
 * A new visitor with the page open. `troubles` collects what a visitor would never see:
 * errors, violations of the content security policy, requests to another host.
 * @param {Started} started
 * @param {Visit} [visit]
 */
export async function visit({ browser, address }, { options, firstTime = false, before, ready = true, path = '', site = address } = {}) {
  const context = await browser.newContext({ viewport: WIDE, colorScheme: 'light', reducedMotion: 'reduce', ...options });
  if (!firstTime) await context.addInitScript(() => localStorage.setItem('nctape.hints', 'done'));
  const page = await context.newPage();
  /** @type {string[]} */
  const troubles = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('request', (request) => {
    const { protocol, origin } = new URL(request.url());
    if (protocol.startsWith('http') && origin !== new URL(address).origin) troubles.push(`request to ${request.url()}`);
  });
  await before?.(page);
  await page.goto(site + path);
  if (ready) await settled(page);
  return {
    page,
    troubles,
    async leave() {
      assert.deepEqual(troubles, []);
      await context.close();
    },
  };
}

/**
 * The row under the reader head is named: the engine has answered and the tape is drawn.
 * @param {Page} page
 */
export async function settled(page) {
  await page.waitForFunction(() => document.getElementById('strip')?.hasAttribute('aria-valuetext'));
  await page.waitForFunction(() => document.getElementById('totals')?.childElementCount);
  await quiet(page);
}

/**
 * Long enough for an answer, for the list to settle and for two frames.
 * @param {Page} page
 */
export async function quiet(page) {
  await page.waitForTimeout(650);
}

/**
 * Puts the whole text aside for another, as by select all and paste.
 * @param {Page} page
 * @param {string} text
 */
export async function paste(page, text) {
  await page.locator('#editor .cm-content').focus();
  await page.keyboard.press('Control+a');
  await page.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData('text/plain', pasted);
    const target = document.getElementById('editor')?.shadowRoot?.querySelector('.cm-content');
    target?.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
  await quiet(page);
}

/**
 * The text of the editor, line by line as far as it is shown.
 * @param {Page} page
 */
export const lines = (page) => page.locator('#editor .cm-line').allTextContents();

/**
 * The first tape with faults put into it; its one note, on a minus zero, is taken out.
 * @param {Page} page
 * @param {Record<string, string>} [faults]  what stands in the text, and what is put in its place
 */
export async function pasteFaulty(page, faults = {}) {
  let text = (await lines(page)).join('\n').replace('I-000000', 'I+000000');
  for (const [good, bad] of Object.entries(faults)) text = text.replace(good, bad);
  await paste(page, text);
}

/**
 * Puts the cursor into a line of the program.
 * @param {Page} page
 * @param {string} start  how the line begins
 */
export async function goToLine(page, start) {
  await page.locator('#editor .cm-line', { hasText: start }).first().click({ position: { x: 14, y: 8 } });
  await page.keyboard.press('Home');
  await quiet(page);
}

/**
 * The pixels of a canvas, as drawn.
 * @param {Page} page
 * @param {string} id
 * @returns {Promise<Uint32Array>}
 */
export async function pixels(page, id) {
  const base64 = await page.evaluate((name) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(name));
    // A copy is read, so that the page's own canvas stays as it is.
    const copy = new OffscreenCanvas(canvas.width, canvas.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (copy.getContext('2d', { willReadFrequently: true }));
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let text = '';
    for (let i = 0; i < data.length; i += 0x8000) text += String.fromCharCode(...data.subarray(i, i + 0x8000));
    return btoa(text);
  }, id);
  return new Uint32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer);
}

/**
 * How many pixels are not the same.
 * @param {Uint32Array} one
 * @param {Uint32Array} other
 */
export function difference(one, other) {
  assert.equal(one.length, other.length, 'the pictures have one size');
  let count = 0;
  for (let i = 0; i < one.length; i += 1) count += one[i] === other[i] ? 0 : 1;
  return count;
}
