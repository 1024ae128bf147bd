// CLDATA as the text: the tape that it became beside it, and one light through records, blocks, rows and path.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { goToLine, lines, NARROW, paste, quiet, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/** Two sides of a plate and the round corner between them. */
const PLATE = [
  "1,20000,0,PARTNO,'PLATE';",
  '2,9000,9,1;',
  "3,1000,7,'70','FROM/SETPT';",
  "4,5000,3,'',0,.,.,30.;",
  '5,6000,6,10.;',
  "6,20000,0,PPRINT,'ROUND CORNER';",
  '7,20000,0,FEDRAT,200.,PERMIN;',
  "8,1000,9,'90','GORGT/L1,PAST,C1';",
  "9,5000,5,'',0,10.,10.,20.,50.,10.,20.;",
  "10,3000,2,0,4,9,'C1',0,50.,20.,20.,.,.,1.,10.;",
  "11,5000,5,'',0,60.,20.,20.;",
  '12,20000,0,RAPID;',
  "13,5000,5,'',0,.,.,30.;",
  '14,20000,0,END;',
  '15,14000;',
  ':',
  '',
].join('\n');

const APT = 'PARTNO / PLATE\nUNITS / MM\nFROM / 0, 0, 30\nFEDRAT / 200, MMPM\nGOTO / 10, 10, 20\nGOTO / 50, 10, 20\nEND\nFINI\n';

/** The text turned to CLDATA, and replaced. @param {Page} page @param {string} [text] */
async function openCldata(page, text = PLATE) {
  await page.locator('#kind-cldata').click();
  await page.locator('#posted-text .cm-content').waitFor({ state: 'attached' });
  await paste(page, text);
  await quiet(page);
}

/** @param {Page} page */
const litRecords = (page) => page.locator('#editor .cm-lit').allInnerTexts();
/** @param {Page} page */
const litBlocks = (page) => page.locator('#posted-text .cm-lit').allInnerTexts();
/** @param {Page} page */
const posted = (page) => page.locator('#posted-text .cm-line').allTextContents();
/** @param {Page} page */
const row = async (page) => (await page.locator('#strip').getAttribute('aria-valuetext')) ?? '';
/** @param {Page} page */
const caption = (page) => page.locator('#span-caption').innerText();

/** The number that a block begins with. @param {string} block */
const numberOf = (block) => /^\S*?(N\d+)/.exec(block)?.[1] ?? block;

test('an example of CLDATA shows its records, its path and the tape that it became', async () => {
  const { page, leave } = await visit(started);
  const option = page.locator('#preset optgroup').nth(1).locator('option').first();
  await page.locator('#preset').selectOption((await option.getAttribute('value')) ?? '');
  await page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(page);
  assert.equal(await page.locator('#kind-cldata').getAttribute('aria-checked'), 'true');
  assert.match(await page.locator('#program-note').innerText(), /\d+ records/);
  assert.match(await page.locator('#record-place').innerText(), /^Record \d+/);
  assert.notEqual((await page.locator('#record-says').innerText()).trim(), '');
  assert.ok((await posted(page)).some((line) => /N\d+/.test(line)));
  assert.match(await row(page), /^Row \d+ of \d+, block/);
  assert.notEqual((await page.locator('#legend').innerText()).trim(), '');
  assert.equal(await page.locator('.tally', { hasText: 'error' }).count(), 0, 'an example has no error');
  assert.equal(await page.locator('#replay').isVisible(), false);
  // And the switch goes back to the tape that was open before.
  await page.locator('#kind-tape').click();
  await quiet(page);
  assert.equal(await page.locator('#preset').inputValue(), 'annex-e-circular');
  assert.equal(await page.locator('#posted').isVisible(), false);
  assert.ok(await page.locator('#replay').isVisible());
  await leave();
});

test('an error in a record is located and mended, and the tape follows', async () => {
  const { page, leave } = await visit(started);
  await openCldata(page, PLATE.replace('60.,20.,20.', '60,20.,20.'));
  const before = (await posted(page)).join('\n');
  const problem = page.locator('#problem-list > li', { hasText: 'CLD-' }).first();
  assert.match(await problem.innerText(), /^11:16/m);
  assert.match(await problem.locator('.rule-id').innerText(), /^CLD-\d+/);
  await problem.locator('.problem').click();
  await quiet(page);
  assert.equal(await page.locator('#editor .cm-chosen').innerText(), '60');
  assert.deepEqual(await litRecords(page), ["11,5000,5,'',0,60,20.,20.;"]);
  await problem.locator('.fix').first().click();
  await quiet(page);
  assert.ok((await lines(page)).includes("11,5000,5,'',0,60.,20.,20.;"));
  assert.equal(await page.locator('.tally', { hasText: 'error' }).count(), 0);
  assert.equal((await posted(page)).join('\n'), before, 'the value was understood all the same');
  await problem.waitFor({ state: 'detached' }).catch(() => {});
  await leave();
});

test('record, block, rows and span are lit together, from each of them', async () => {
  const { page, leave } = await visit(started);
  await openCldata(page);

  // From the text: the record of the arc. Its block is lit, the tape stands at it, and the path names the record.
  await goToLine(page, "11,5000");
  assert.match(await caption(page), /^Arc of record 11/);
  assert.match(await page.locator('#record-says').innerText(), /The tool goes to X 60 Y 20 Z 20/);
  assert.match(await page.locator('#record-from').innerText(), /statement 9, 90 GORGT/);
  const [arc] = await litBlocks(page);
  assert.match(arc, /G0?3/);
  assert.match(await row(page), new RegExp(`block ${numberOf(arc)}`));

  // The record of its circle is another record of the same span.
  await goToLine(page, '10,3000');
  assert.match(await caption(page), /^Arc of record 10/);
  assert.match(await page.locator('#record-says').innerText(), /circle C1, centre X 50 Y 20 Z 20, radius 10/);

  // From the posted tape.
  const blocks = page.locator('#posted-text .cm-line');
  const texts = await blocks.allTextContents();
  const cut = texts.findIndex((text) => text === arc) - 1;
  await blocks.nth(cut).click({ position: { x: 30, y: 8 } });
  await quiet(page);
  assert.deepEqual(await litRecords(page), ["9,5000,5,'',0,10.,10.,20.,50.,10.,20.;"]);
  assert.match(await row(page), new RegExp(`block ${numberOf(texts[cut])}`));
  assert.match(await caption(page), /^Line of record 9/);

  // From the paper: on by a block.
  await page.locator('#strip').focus();
  await page.keyboard.press('PageDown');
  await quiet(page);
  assert.deepEqual(await litBlocks(page), [arc]);
  assert.match((await litRecords(page)).join('\n'), /^1[01],/);
  await page.keyboard.press('ArrowRight');
  await quiet(page);
  assert.match(await row(page), new RegExp(`block ${numberOf(arc)}, character 0`), 'the row under the hand stays there');

  // From the path: a record of two points has two spans, and each leads to its point.
  await page.locator('#plot-canvas').focus();
  await page.keyboard.press('PageUp');
  await quiet(page);
  assert.match(await caption(page), /^Line of record 9/);
  assert.match(await page.locator('#span-rows').innerText(), /Start\s+X 10\.000.*End\s+X 50\.000/s);
  await page.keyboard.press('PageUp');
  await quiet(page);
  assert.match(await caption(page), /^Line of record 9/);
  assert.match(await page.locator('#span-rows').innerText(), /Start\s+X 0\.000.*End\s+X 10\.000/s);
  await leave();
});

test('the tape that it became is opened as a tape, and undone', async () => {
  const { page, leave } = await visit(started);
  await openCldata(page);
  await goToLine(page, '11,5000');
  const text = (await posted(page)).join('\n');
  const [arc] = await litBlocks(page);
  await page.locator('#posted-open').click();
  await quiet(page);
  assert.equal(await page.locator('#kind-tape').getAttribute('aria-checked'), 'true');
  assert.equal((await lines(page)).join('\n'), text);
  assert.match(await page.locator('#editor .cm-lit').innerText(), new RegExp(`^${numberOf(arc)}`));
  assert.ok(await page.locator('#play').isVisible());
  await page.locator('#editor .cm-content').focus();
  await page.keyboard.press('Control+z');
  await quiet(page);
  assert.equal(await page.locator('#kind-cldata').getAttribute('aria-checked'), 'true');
  assert.equal((await lines(page)).join('\n'), PLATE);
  await leave();
});

test('a link to CLDATA opens it as such, with the format that it is posted to, and so does a reload', async () => {
  const { page, leave } = await visit(started);
  await openCldata(page);
  const text = (await posted(page)).join('\n');
  await page.locator('#share-button').click();
  const link = await page.locator('#share-link').inputValue();
  await page.keyboard.press('Escape');
  await page.waitForTimeout(1000);
  await page.reload();
  await page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(page);
  assert.equal((await lines(page)).join('\n'), PLATE);
  await leave();

  const other = await visit(started);
  await other.page.goto(link);
  await other.page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(other.page);
  assert.equal((await lines(other.page)).join('\n'), PLATE);
  assert.equal((await posted(other.page)).join('\n'), text);
  assert.match(await other.page.locator('#preset option:checked').innerText(), /Shared/);
  await other.leave();
});

test('CLDATA pasted as a tape is offered as what it is', async () => {
  const { page, leave } = await visit(started);
  await paste(page, PLATE);
  const problem = page.locator('#problem-list > li').first();
  assert.match(await problem.innerText(), /TAPE-08/);
  await problem.getByRole('button', { name: 'Open it as CLDATA' }).click();
  await page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(page);
  assert.equal(await page.locator('#kind-cldata').getAttribute('aria-checked'), 'true');
  assert.equal((await lines(page)).join('\n'), PLATE);
  assert.equal(await page.locator('.tally', { hasText: 'error' }).count(), 0);
  await leave();
});

test('the CL text of a CAM system becomes CLDATA, pasted under either', async () => {
  const { page, leave } = await visit(started);
  await paste(page, APT);
  await page.locator('#problem-list > li').first().getByRole('button', { name: 'Turn it into CLDATA' }).click();
  await page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(page);
  assert.match((await lines(page)).join('\n'), /,5000,5,'',0,50\.,10\.,20\.;/);
  assert.equal(await page.locator('.tally', { hasText: 'error' }).count(), 0);

  await paste(page, APT);
  await page.locator('#problem-list > li').first().getByRole('button', { name: 'Turn it into records' }).click();
  await quiet(page);
  assert.match((await lines(page)).join('\n'), /,5000,5,'',0,50\.,10\.,20\.;/);
  await leave();
});

test('a file of CLDATA is opened as such, and its tape is saved', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#file-input').setInputFiles({ name: 'plate.cld', mimeType: 'text/plain', buffer: Buffer.from(PLATE) });
  await page.locator('#posted-text .cm-line').first().waitFor();
  await quiet(page);
  assert.equal((await lines(page)).join('\n'), PLATE);
  const text = (await posted(page)).join('\n');
  /** @param {string} id */
  const saved = async (id) => {
    await page.locator('#file-button').click();
    const download = page.waitForEvent('download');
    await page.locator(`#${id}`).click();
    const stream = await (await download).createReadStream();
    const chunks = [];
    for await (const chunk of stream) chunks.push(chunk);
    return { name: (await download).suggestedFilename(), text: Buffer.concat(chunks).toString() };
  };
  assert.deepEqual(await saved('save-cldata'), { name: 'cldata.txt', text: PLATE });
  assert.deepEqual(await saved('save-listing'), { name: 'tape.txt', text });
  const report = JSON.parse((await saved('save-report')).text).report;
  assert.equal(report.blocks.length, 15);
  assert.equal(report.spans.length, 4);
  await leave();
});

test('on a phone the tape that it became has a tab of its own', async () => {
  const { page, leave } = await visit(started, { options: { viewport: NARROW, hasTouch: true } });
  await openCldata(page);
  await goToLine(page, '11,5000');
  await page.locator('#tab-posted').click();
  await quiet(page);
  const [arc] = await litBlocks(page);
  assert.ok(await page.locator('#posted-text .cm-lit').isVisible());
  await page.locator('#tab-path').click();
  assert.match(await caption(page), /^Arc of record 11/);
  assert.ok(await page.locator('#record').isVisible());
  // Nothing is wider than the screen, and what is pressed is large enough.
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), NARROW.width);
  for (const id of ['kind-tape', 'kind-cldata', 'tab-posted', 'posted-open']) {
    if (id === 'posted-open') await page.locator('#tab-posted').click();
    const box = await page.locator(`#${id}`).boundingBox();
    assert.ok(box && box.height >= 44 && box.width >= 44, `${id} is ${box?.width} by ${box?.height}`);
  }
  await page.locator('#posted-open').click();
  await quiet(page);
  assert.match((await page.locator('#editor .cm-lit').innerText()), new RegExp(`^${numberOf(arc)}`));
  assert.equal(await page.locator('#tab-posted').isVisible(), false);
  await leave();
});
