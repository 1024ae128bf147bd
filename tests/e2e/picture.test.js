// The picture that the README shows. It is written where NCTAPE_PICTURES names a folder:
//   NCTAPE_PICTURES=docs cargo xtask test e2e
import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { root, startBrowser, visit } from './support/playground.js';

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

test('the page at 1440 by 900, in light', async () => {
  const { page, leave } = await visit(started);
  const picture = await page.screenshot();
  assert.equal(picture.readUInt32BE(16), 1440);
  assert.equal(picture.readUInt32BE(20), 900);
  const folder = process.env.NCTAPE_PICTURES;
  if (folder) {
    await mkdir(resolve(root, folder), { recursive: true });
    await writeFile(join(resolve(root, folder), 'playground.png'), picture);
  }
  await leave();
});
