// A tape as a link, there and back. A link of every version that was ever made lies in tests/links: it must open for ever.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { linkOf, readLink as read } from '../../web/share/link.js';

const readLink = (/** @type {string} */ hash) => read(hash, ['iso2539', 'iso1058', 'rs274']);

const TAPE = {
  source: '%\nN001 G01 X+001000 Y-000500 F0300\nN002 (Größe µ) M30\n',
  format: /** @type {import('nctape').Format} */ ({
    standard: 'iso2539',
    classification: 'CSM 432',
    detail: 'N3G2X+33Y+33F4M2*',
    itemized: { setPoint: [1, 2, 3] },
  }),
  cursor: 9,
};

const CLDATA = /** @type {const} */ ({
  source: "1,5000,3,'',0,.,.,.;\n2,5000,5,'',0,10.,.,.;\n3,14000;\n:\n",
  format: TAPE.format,
  cursor: 22,
  kind: 'cldata',
});

/** @param {unknown} held @param {string} [mark] */
const link = (held, mark = '#1.') => mark + deflateRawSync(typeof held === 'string' ? held : JSON.stringify(held)).toString('base64url');

test('a link of version 1 opens', async () => {
  const kept = readFileSync(new URL('../links/version-1.txt', import.meta.url), 'utf8').trim();
  assert.deepEqual(await readLink(kept), { tape: TAPE });
});

test('a link of version 1 opens CLDATA, too', async () => {
  const kept = readFileSync(new URL('../links/version-1-cldata.txt', import.meta.url), 'utf8').trim();
  assert.deepEqual(await readLink(kept), { tape: CLDATA });
  assert.deepEqual(await readLink(await linkOf(CLDATA)), { tape: CLDATA });
  const { kind: _, ...tape } = CLDATA;
  assert.deepEqual(await readLink(await linkOf({ ...tape, kind: 'tape' })), { tape }, 'a tape needs no word');
  assert.deepEqual(await readLink(link({ ...TAPE, kind: 'apt' })), { tape: TAPE }, 'an unknown word is none');
});

test('what was shared is what is opened', async () => {
  for (const source of ['', 'a\r\n\u{1F600}\0', 'N001 G01 X+001000\n'.repeat(400)]) {
    const tape = { ...TAPE, source, cursor: 0 };
    const made = await linkOf(tape);
    assert.match(made, /^#1\.[A-Za-z0-9_-]+$/);
    assert.deepEqual(await readLink(made), { tape });
  }
});

test('an address without a tape is none', async () => {
  for (const hash of ['', '#', '#learn', '#1', '#x.abc']) assert.equal(await readLink(hash), null, hash);
});

test('what is damaged, of another kind or of a version to come is said, and nothing of it is taken', async () => {
  const whole = await linkOf(TAPE);
  const broken = [
    whole.slice(0, -9),
    `${whole.slice(0, 20)}!${whole.slice(21)}`,
    '#1.',
    link('no JSON'),
    link([1, 2]),
    link({ source: 5, format: TAPE.format }),
    link({ source: 'N001', format: 'iso2539' }),
    link(null),
    link({ ...TAPE, format: { ...TAPE.format, standard: 'din66025' } }),
    link({ ...TAPE, source: 'N'.repeat(900_000) }),
    link('x'.repeat(20_000_000)),
    link(TAPE, '#2.'),
  ];
  for (const hash of broken) {
    const found = await readLink(hash);
    assert.ok(found !== null && 'trouble' in found && found.trouble.endsWith('.'), hash.slice(0, 60));
  }
});

test('a cursor that is no place is the start', async () => {
  for (const cursor of [-1, 1.5, 'far', null, undefined]) {
    const found = await readLink(link({ ...TAPE, cursor }));
    assert.ok(found !== null && 'tape' in found && found.tape.cursor === 0);
  }
});
