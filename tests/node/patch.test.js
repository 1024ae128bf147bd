// A path that was brought up to date is the path of the tape as it is now.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { patched } from '../../web/plot/patch.js';

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, '../../pkg');
/** @type {typeof import('nctape')} */
const { default: init, Tape } = await import(pathToFileURL(join(folder, 'nctape.js')).href);
await init({ module_or_path: readFileSync(join(folder, 'nctape_bg.wasm')) });

/** @type {import('nctape').Format} */
const FORMAT = { standard: 'iso2539', classification: 'CAM 222', detail: 'N3G2XL42YL42IL42JL42F4M2*' };

/** @param {number} blocks */
function tape(blocks) {
  const lines = Array.from({ length: blocks }, (_, i) => {
    const number = String(i % 1000).padStart(3, '0');
    if (i % 7 === 3) return `N${number} G02 X+000200 Y+000000 I+000100 J+000000`;
    return `N${number} G01 X+${String((i * 37) % 1000).padStart(6, '0')} Y-000100 F0300`;
  });
  return `%\n${lines.join('\n')}\nN999 M30\n`;
}

/** Each edit: where, how much goes, what comes. @type {(text: string) => [string, number, number, string][]} */
const edits = (text) => {
  const middle = text.indexOf('\n', text.length / 2) + 1;
  return [
    ['a digit', text.indexOf('X+', middle) + 3, 1, '9'],
    ['a new block', middle, 0, 'N500 G01 X+000700 Y+000300\n'],
    ['a block goes', middle, text.indexOf('\n', middle) + 1 - middle, ''],
    ['an arc comes', middle, 0, 'N500 G03 X+000000 Y+000200 I+000000 J+000100\n'],
    ['other dimensions from here', middle, 0, 'G91\n'],
    ['nothing', middle, 0, ''],
    ['an empty line', middle, 0, '\n'],
    ['the end comes early', middle, 0, 'N500 M30\n'],
  ];
};

for (const blocks of [20, 3000]) {
  test(`each edit of a tape of ${blocks} blocks leaves the path that a fresh tape has`, () => {
    const live = new Tape(tape(blocks), FORMAT);
    let text = tape(blocks);
    let change = live.pathChange(0.01, 0);
    let path = patched(null, change);
    for (const [name, at, removed, insert] of edits(text)) {
      /** @type {[number, number, string][]} */
      const thereAndBack = [
        [at, at + removed, insert],
        [at, at + insert.length, text.slice(at, at + removed)],
      ];
      for (const [from, to, piece] of thereAndBack) {
        live.edit(from, to, piece);
        text = text.slice(0, from) + piece + text.slice(to);
        change = live.pathChange(0.01, change.number);
        path = patched(path, change);
        const fresh = new Tape(text, FORMAT);
        assert.deepEqual(path, fresh.path(0.01), name);
        fresh.free();
      }
    }
  });
}

test('several edits are brought up to date at once', () => {
  let text = tape(2000);
  const live = new Tape(text, FORMAT);
  const { number, ...whole } = live.pathChange(0.01, 0);
  const path = patched(null, { number, ...whole });
  for (const share of [0.2, 0.7, 0.5]) {
    const at = text.indexOf('\n', text.length * share) + 1;
    const line = 'N001 G01 X+000100 Y+000200\n';
    live.edit(at, at, line);
    text = text.slice(0, at) + line + text.slice(at);
    // What is thrown away as late is told again with the next.
    live.pathChange(0.01, number);
  }
  assert.deepEqual(patched(path, live.pathChange(0.01, number)), new Tape(text, FORMAT).path(0.01));
});

test('a small edit of a long tape changes few spans', () => {
  const text = tape(3000);
  const live = new Tape(text, FORMAT);
  const { number } = live.pathChange(0.01, 0);
  const at = text.indexOf('X+', text.length / 2) + 3;
  live.edit(at, at + 1, '9');
  const { kinds, first, last } = live.pathChange(0.01, number);
  assert.ok(kinds.length <= 600, `${kinds.length} spans changed`);
  assert.ok(first > 1000 && last > 1000);
});
