// Further axes, the cutter beside its path, threads, and the functions in words.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { difference, goToLine, paste, pixels, quiet, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

/**
 * The page with an example in it.
 * @param {string} preset
 */
async function opened(preset) {
  const { page, leave } = await visit(started);
  await page.locator('#preset').selectOption(preset);
  await quiet(page);
  return { page, leave };
}

/**
 * A register by its name.
 * @param {Page} page
 * @param {string} name
 */
const register = (page, name) => page.locator('#registers tr', { has: page.getByRole('rowheader', { name, exact: true }) }).locator('td').innerText();

test('an axis that turns has a plot of its own, and its place in it moves with the tape', async () => {
  const { page, leave } = await opened('rotary-table');
  const chart = page.locator('#axes-chart');
  assert.ok(await chart.isVisible());
  assert.equal(await chart.locator('canvas').getAttribute('aria-label'), 'Other axes against the length of the path: B 0 to 270°');
  await goToLine(page, 'N007');
  assert.equal(await register(page, 'B'), '90.000');
  const picture = async () => {
    await chart.locator('canvas').evaluate((canvas) => canvas.setAttribute('id', 'axes-canvas'));
    return pixels(page, 'axes-canvas');
  };
  const before = await picture();
  await goToLine(page, 'N010');
  assert.equal(await register(page, 'B'), '180.000');
  const at = await picture();
  assert.ok(difference(before, at) > 20, 'the line at the place of the tool has moved');
  assert.ok(difference(before, at) < before.length / 20, 'and nothing else');
  // A tape without such an axis has no such plot.
  await page.locator('#preset').selectOption('annex-e-circular');
  await quiet(page);
  assert.equal(await chart.isVisible(), false);
  await leave();
});

test('the path of the cutter is drawn beside the programmed one where compensation is in force', async () => {
  const { page, leave } = await opened('cutter-left');
  const legend = page.locator('.key-offset');
  assert.equal(await legend.innerText(), 'cutter centre');
  assert.match(await register(page, 'Cutter'), /^G41/);
  const text = (await page.locator('.cm-line').allTextContents()).join('\n');
  // The cursor stands at the end of what was pasted, and the tool with it.
  await paste(page, text);
  const drawn = await pixels(page, 'plot-canvas');
  await paste(page, text.replace('G41 X', 'X').replace('(CUTTER LEFT)', '(NO CUTTER)'));
  assert.ok(difference(drawn, await pixels(page, 'plot-canvas')) > 300, 'without G41 there is no line of the cutter');
  await leave();
});

test('a thread shows its lead, and when its functions act can be read without hovering', async () => {
  const { page, leave } = await opened('thread');
  assert.match(await register(page, 'Lead'), /K 1\.5 mm\/rev/);
  const more = page.locator('#registers-more');
  assert.equal(await more.locator('p').count(), 0);
  await more.locator('summary').focus();
  await page.keyboard.press('Enter');
  await more.locator('p').first().waitFor();
  const said = await more.innerText();
  assert.match(said, /M03 acts with the motion of the block/);
  assert.match(said, /G33 acts/);
  await goToLine(page, 'N014');
  assert.match(await more.innerText(), /M05 acts after the motion of the block/);
  await leave();
});

test('the table of functions has every code, its group, when it acts and what other sources say', async () => {
  const { page, leave } = await visit(started);
  await page.locator('#learn-button').click();
  await page.locator('#learn-functions summary').click();
  await page.locator('.function-table tbody tr').first().waitFor();
  const rows = await page.locator('.function-table tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
  const row = (/** @type {string} */ code) => rows.find(([name]) => name === code) ?? [];
  assert.equal(row('G02')[1], 'Circular interpolation, arc clockwise');
  assert.equal(row('M05')[3].includes('after the motion of the block'), true, row('M05').join());
  assert.match(row('G70').concat(rows.flat().filter((cell) => cell.includes('inch programming'))).join(), /inch programming/);
  // Every code of G and M stands in one line, alone or in a range.
  const covered = rows.reduce((count, [name]) => {
    const [first, last = first] = name.split('–').map((code) => Number(code.slice(1)));
    return count + last - first + 1;
  }, 0);
  assert.equal(covered, 200);
  await leave();
});
