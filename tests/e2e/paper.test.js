// The tape as paper: a name in holes, what a row says, files in and out.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { difference, goToLine, lines, NARROW, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page */
const text = async (page) => (await lines(page)).join('\n');
const phone = { viewport: NARROW, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/**
 * What the browser is given to save when an item of the menu is pressed.
 * @param {Page} page
 * @param {string} item
 */
async function saved(page, item) {
  await page.locator('#file-button').click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(item).click()]);
  assert.ok(await page.locator('#file-menu').isHidden());
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/**
 * @param {Page} page
 * @param {string} name
 */
async function punchName(page, name) {
  await page.locator('#name-button').click();
  await page.locator('#name').fill(name);
  await quiet(page);
}

// The columns of an L, an I and an L as an eye reads them: strokes and feet, track 7 on top.
const STROKE = 0b111_1111;
const L = [STROKE, 1, 1, 1, 1];
const I = [0b100_0001, STROKE, 0b100_0001];

test('a name is punched into the leader as letters, and goes into the rows that are saved', async () => {
  const { page, leave } = await visit(started);
  const bare = await saved(page, '#save-rows');
  assert.equal(bare.name, 'tape.bin');
  assert.equal(bare.bytes.length, 417, 'the rows of the program, no more');
  const strip = await pixels(page, 'strip-canvas');

  await punchName(page, 'Lil');
  assert.match(await page.locator('#name-note').innerText(), /passes over them.*first end of block.*ISO 2539 3\.2\.1\.3/);
  assert.ok(difference(strip, await pixels(page, 'strip-canvas')) > 1000, 'the letters come under the head');
  await page.keyboard.press('Enter');
  assert.match(await page.locator('#name-button').innerText(), /Lil/);
  assert.match(await page.locator('#tape-words').innerText(), /^Leader, row/);

  await page.locator('#file-button').click();
  assert.match(await page.locator('#save-note').innerText(), /417 rows, and before them 35 rows with your name/);
  await page.keyboard.press('Escape');
  const named = await saved(page, '#save-rows');
  const margin = new Array(10).fill(0);
  assert.deepEqual([...named.bytes], [...margin, ...L, 0, ...I, 0, ...L, ...margin, ...bare.bytes]);

  // Opened again, the name is passed over and the tape is the same.
  const before = await text(page);
  await page.locator('#file-input').setInputFiles({ name: 'lil.bin', mimeType: 'application/octet-stream', buffer: named.bytes });
  await quiet(page);
  assert.equal(await text(page), before);
  assert.match(await page.locator('#file-card').innerText(), /ISO 840[\s\S]*1 remark on rows[\s\S]*Row 11: .*a label that a person reads/);
  await leave();
});

test('the letters can be reached on the tape, and taken back', async () => {
  const { page, leave } = await visit(started);
  await punchName(page, 'Ada');
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('#name-form').isHidden());
  await goToLine(page, 'N001');
  assert.match(await page.locator('#tape-words').innerText(), /N001/);
  await page.locator('#strip').focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowLeft');
  await quiet(page);
  assert.match((await page.locator('#strip').getAttribute('aria-valuetext')) ?? '', /^Leader, row 37 of 37/);
  await page.keyboard.press('ArrowRight');
  await quiet(page);
  assert.match((await page.locator('#strip').getAttribute('aria-valuetext')) ?? '', /^Row 1 of/);

  await page.locator('#name-button').click();
  await page.locator('#name').fill('');
  await quiet(page);
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#name-button').innerText(), 'Your name in holes');
  assert.equal((await saved(page, '#save-rows')).bytes.length, 417);
  await leave();
});

test('accents are left off, what has no letter is named, and a tape without its first end of block is warned of', async () => {
  const { page, leave } = await visit(started);
  await punchName(page, 'Zoë 世');
  assert.match(await page.locator('#name-note').innerText(), /^There is no letter of holes for 世\./);
  await page.keyboard.press('Escape');
  await goToLine(page, '%');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Delete');
  await quiet(page);
  assert.match(await text(page), /^N001/);
  await page.locator('#name-button').click();
  await quiet(page);
  assert.match(await page.locator('#name-note').innerText(), /no end of block before its first block/);
  await leave();
});

test('a row under the pointer says its holes, its weights, its parity and its character in both codes', async () => {
  const { page, leave } = await visit(started);
  const card = page.locator('#row-card');
  const calm = await page.evaluate(() => JSON.stringify(document.getElementById('editor')?.getBoundingClientRect()));
  const box = await page.locator('#strip').boundingBox();
  assert.ok(box);
  // Three rows of 14 pixels beyond the head, on the G of N006: G, 0, 2, tab.
  await page.mouse.move(box.x + box.width / 2 + 28, box.y + 80);
  await card.waitFor();
  const words = await card.innerText();
  assert.match(words, /Row 149 of 417 · N006/);
  // A 2 is 0x32 with track 8 for parity: tracks 2, 5, 6 and 8.
  assert.match(words, /ISO 840[\s\S]*32 \+ 16 \+ 2 = 50: 2, digit\. 4 holes: even, as it must be/);
  assert.match(words, /EIA RS-244[\s\S]*No character of this code\. 4 holes: even, and every row of this code is odd/);
  const punched = await card.locator('.track.punched .track-number').allInnerTexts();
  assert.deepEqual(punched, ['8', '6', '5', '2']);
  assert.deepEqual(await card.locator('.track-role').allInnerTexts(), ['parity', '64', '32', '16', '8', '4', '2', '1']);
  await page.mouse.move(box.x + box.width / 2, box.y + 400);
  await card.waitFor({ state: 'hidden' });
  assert.equal(await page.evaluate(() => JSON.stringify(document.getElementById('editor')?.getBoundingClientRect())), calm);
  await leave();
});

test('the same is told of the row under the head, by keys and by the finger', async () => {
  const { page, leave } = await visit(started);
  const card = page.locator('#row-card');
  await page.locator('#row-button').focus();
  await page.keyboard.press('Enter');
  await card.waitFor();
  assert.match(await card.innerText(), /Row 147 of 417 · N006[\s\S]*64 \+ 4 \+ 2 \+ 1 = 71: G, letter/);
  await page.locator('#strip').focus();
  await page.keyboard.press('ArrowRight');
  await quiet(page);
  assert.match(await card.innerText(), /Row 148[\s\S]*32 \+ 16 = 48: 0, digit/, 'the card follows the head');
  await page.keyboard.press('Escape');
  await card.waitFor({ state: 'hidden' });
  await leave();

  const narrow = await visit(started, { options: phone });
  await narrow.page.locator('#row-button').tap();
  await narrow.page.locator('#row-card').waitFor();
  const box = await narrow.page.locator('#row-card').boundingBox();
  assert.ok(box && box.x >= 0 && box.x + box.width <= NARROW.width);
  await narrow.page.locator('#row-button').tap();
  await narrow.page.locator('#row-card').waitFor({ state: 'hidden' });
  await narrow.leave();
});

test('a listing is opened by its content, in the format that is there', async () => {
  const { page, leave } = await visit(started);
  const format = await page.locator('#format-text').innerText();
  const listing = '%\r\nN001\tG01\tX+001000\t\t\t\t\tF0100\r\nN002\tX+002000\t\t\t\t\t\tF0100\tM30\r\n';
  await page.locator('#file-input').setInputFiles({ name: 'part.bin', mimeType: 'application/octet-stream', buffer: Buffer.from(listing) });
  await quiet(page);
  assert.match(await text(page), /^%\nN001\tG01\tX\+001000/);
  assert.equal(await page.locator('#format-text').innerText(), format);
  assert.match(await page.locator('#file-card').innerText(), /part\.bin[\s\S]*Text\./);
  assert.match(await page.locator('.cm-lit').innerText(), /^N001/, 'the cursor is on the first span');
  await page.locator('#file-card').getByRole('button', { name: /Close/ }).click();
  assert.ok(await page.locator('#file-card').isHidden());

  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.match(await text(page), /N006\tG02/, 'one undo');
  await leave();
});

// The block that Y-1702 prints, in EIA code, between blank tape; one row has a hole too many.
const EIA = [
  0, 0, 0, 0x0b, 0x80, 0x45, 0x20, 0x02, 0x15, 0x67, 0x20, 0x01, 0x37, 0x40, 0x20, 0x13, 0x02, 0x01, 0x16, 0x38, 0x70, 0x20, 0x20, 0x07, 0x08,
  0x02, 0x76, 0x04, 0x01, 0x15, 0x54, 0x20, 0x01, 0x80, 0, 0,
];

test('a dropped image of a tape is recognised with its code, and its bad rows are shown', async () => {
  const { page, leave } = await visit(started);
  const bad = [...EIA];
  bad[9] |= 0x08;
  await page.evaluate((bytes) => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array(bytes)], 'reel 7'));
    const target = document.getElementById('editor');
    for (const type of ['dragover', 'drop']) {
      target?.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true, composed: true }));
    }
  }, bad);
  await quiet(page);
  assert.ok(await page.locator('#drop-veil').isHidden());
  assert.match(await text(page), /^%\nN025\uFFFD01X-03216Y\+00782F415M01\n/);
  const card = page.locator('#file-card');
  const words = await card.innerText();
  assert.match(words, /reel 7[\s\S]*the image of a tape, one byte for each row\. 36 rows\./);
  assert.match(words, /EIA RS-244: the first end of block is track 8 alone/);
  assert.match(words, /1 remark on rows[\s\S]*Row 10: [\s\S]*ROW-0/);
  await card.locator('.file-issue').first().click();
  await quiet(page);
  assert.match(await page.locator('.cm-lit').innerText(), /^N025/);

  // The tape is punched in the code that it came in: saved again it has the same rows, less the bad one.
  const again = await saved(page, '#save-rows');
  assert.deepEqual([...again.bytes], EIA.slice(3, 34).filter((_, index) => index !== 6));
  await card.locator('.small.link').first().click();
  assert.match(await page.locator('#rule-page .eyebrow').innerText(), /^ROW-0/);
  await leave();
});

test('the listing is saved as it stands', async () => {
  const { page, leave } = await visit(started);
  const { name, bytes } = await saved(page, '#save-listing');
  assert.equal(name, 'tape.txt');
  assert.equal(bytes.toString(), await text(page));
  await leave();
});

test('the tape is saved as G-code for LinuxCNC, and what that lacks is said', async () => {
  const { page, leave } = await visit(started);
  const { name, bytes } = await saved(page, '#save-decimal');
  assert.equal(name, 'tape.ngc');
  assert.match(bytes.toString(), /^%\n\(For LinuxCNC[^]*\nN006 G2 X45\.000 Y55\.000 I14\.142 J-14\.142 F19\n[^]*%\n$/);
  assert.ok(await page.locator('#notice').isHidden(), 'nothing is lacking');

  await page.locator('#preset').selectOption('annex-d-boring');
  await quiet(page);
  const lacking = await saved(page, '#save-decimal');
  assert.match(lacking.bytes.toString(), /\n\(LEFT OUT: B1\)\n/);
  assert.match(await page.locator('#notice').innerText(), /tape\.ngc is saved, with 1 remark\. B1 and 2 other words/);
  await leave();
});

test('the picture of the tape is true to scale and holds every hole', async () => {
  const { page, leave } = await visit(started);
  const { name, bytes } = await saved(page, '#save-picture');
  assert.equal(name, 'tape.png');
  const { width, height, perMetre, pixel } = readPng(bytes);
  // 417 rows in lines of 100: ten inches, five lines.
  assert.equal(width, 2400);
  assert.equal(height % 5, 0);
  assert.ok(Math.abs((width / perMetre) * 1000 - 254) < 0.01, `${(width / perMetre) * 1000} mm`);
  const rows = await saved(page, '#save-rows');
  // Where a hole is, the bench shows, which is dark; paper is light. Track centres in millimetres from the lower edge.
  const centres = [2.34, 4.88, 7.42, 12.5, 15.04, 17.58, 20.12, 22.66];
  const line = height / 5;
  const paperBottom = line / 2 + (12.7 * perMetre) / 1000;
  for (const row of [0, 1, 57, 146, 416]) {
    centres.forEach((centre, track) => {
      const x = Math.round(((row % 100) + 0.5) * 24);
      const y = Math.round(Math.floor(row / 100) * line + paperBottom - (centre * perMetre) / 1000);
      assert.equal(pixel(x, y) < 128, (rows.bytes[row] & (1 << track)) !== 0, `row ${row} track ${track + 1}`);
    });
  }
  await leave();
});

/**
 * Reads a picture that was written without filters.
 * @param {Buffer} bytes
 */
function readPng(bytes) {
  /** @type {Record<string, Buffer>} */
  const chunks = {};
  for (let at = 8; at < bytes.length; ) {
    const length = bytes.readUInt32BE(at);
    chunks[bytes.toString('latin1', at + 4, at + 8)] = bytes.subarray(at + 8, at + 8 + length);
    at += length + 12;
  }
  const width = chunks.IHDR.readUInt32BE(0);
  const data = inflateSync(chunks.IDAT);
  return {
    width,
    height: chunks.IHDR.readUInt32BE(4),
    perMetre: chunks.pHYs.readUInt32BE(0),
    /** Its brightness. @param {number} x @param {number} y */
    pixel(x, y) {
      const at = y * (3 * width + 1) + 1 + 3 * x;
      return (data[at] + data[at + 1] + data[at + 2]) / 3;
    },
  };
}

test('the path under the pointer says where it goes, how long, how fast, and where the pointer is', async () => {
  const { page, leave } = await visit(started);
  const box = await page.locator('#plot-canvas').boundingBox();
  assert.ok(box);
  const readout = page.locator('#readout');
  await page.mouse.move(box.x + 6, box.y + box.height - 60);
  await readout.filter({ hasText: /^X −?\d+\.\d{3} {2}Y −?\d+\.\d{3} mm$/ }).waitFor();
  await page.locator('#plot-canvas').focus();
  await page.mouse.move(5, 5);
  await readout.waitFor({ state: 'hidden' });
  await leave();
});

test('the totals say what is known, and where to state what is not', async () => {
  const { page, leave } = await visit(started);
  const totals = page.locator('#totals');
  const words = await totals.innerText();
  // 417 rows of 2.54 mm, at 300 rows a second.
  assert.match(words, /12 blocks, 417 rows, 1\.06 m \(3\.5 ft\)/);
  assert.match(words, /Reading 1\.39 s at 300 rows\/s/);
  assert.match(words, /Within X 10 to 85 +Y 10 to 55 +Z 10 to 20 mm/);
  await goToLine(page, 'N003');
  for (let i = 0; i < 'N003\t'.length; i += 1) await page.keyboard.press('ArrowRight');
  await page.keyboard.type('G00');
  await quiet(page);
  assert.match(await totals.innerText(), /Machining not known at N003: The rapid traverse of the machine is not stated\./);
  await totals.getByRole('button', { name: 'State it' }).click();
  await page.locator('#field-itemized-rapid').waitFor();
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'field-itemized-rapid');
  await page.keyboard.type('5000');
  await quiet(page);
  assert.match(await totals.innerText(), /Machining \d+(\.\d+)? s/);
  await page.locator('#field-itemized-readerSpeed').fill('100');
  await quiet(page);
  assert.match(await totals.innerText(), /at 100 rows\/s/);
  await leave();
});
