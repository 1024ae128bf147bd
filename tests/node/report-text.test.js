// Reports as files for other programs.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { problemsAsMarkdown, spansAsTable } from '../../web/files/report-text.js';

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, '../../pkg');
/** @type {typeof import('nctape')} */
const { default: init, check } = await import(pathToFileURL(join(folder, 'nctape.js')).href);
await init({ module_or_path: readFileSync(join(folder, 'nctape_bg.wasm')) });

/** @type {import('nctape').Format} */
const FORMAT = { standard: 'iso2539', classification: 'CAM 222', detail: 'N3G2XL42YL42IL42JL42F4M2*' };

test('a span is a line, and reads back as the numbers of the report', () => {
  const report = check('%\nN001 G00 X+000500 Y+000000\nN002 G02 X+001500 I+001000 J+000000 F0300\nN003 M30\n', FORMAT);
  const [head, ...rows] = spansAsTable(report).trim().split('\r\n').map((line) => line.split(','));
  assert.equal(rows.length, report.spans.length);
  rows.forEach((row, index) => {
    const span = report.spans[index];
    const at = (/** @type {string} */ name) => row[head.indexOf(name)];
    assert.deepEqual([at('kind'), at('first block'), at('last block')], [span.kind, ...span.blocks.map((block) => report.blocks[block].sequence)]);
    assert.deepEqual(['X', 'Y', 'Z'].map((axis) => Number(at(`end ${axis}`))), span.end);
    assert.deepEqual([at('length mm'), at('seconds')], [String(span.length), span.seconds === null ? '' : String(span.seconds)]);
  });
  assert.deepEqual(rows[0].length, head.length);
});

test('the centre of an arc is told axis by axis in whatever plane', () => {
  const format = { ...FORMAT, classification: 'CAM 332', detail: 'N3G2XL42YL42ZL42IL42JL42KL42F4M2*' };
  const report = check('%\nN001 G00 X+001000 Y+000200 Z+000000\nN002 G18 G02 X+000000 Z-001000 I+000000 K+000000 F0300\nN003 M30\n', format);
  const [head, , arc] = spansAsTable(report).split('\r\n').map((line) => line.split(','));
  // By hand: about X 0, Z 0, at the height Y 2 of the plane.
  assert.deepEqual(['X', 'Y', 'Z'].map((axis) => arc[head.indexOf(`centre ${axis}`)]), ['0', '2', '0']);
  assert.equal(arc[head.indexOf('plane')], 'zx');
});

test('what was typed into a tape is text in a spreadsheet and in Markdown', () => {
  const report = check('%\n=1+1|cmd\n', FORMAT);
  const found = problemsAsMarkdown({ ...report, diagnostics: [{ ...report.diagnostics[0], message: 'a *b* <img> [x](y) `c`', count: 3 }] }, 'F');
  assert.match(found, /a \\\*b\\\* \\<img\\> \\\[x\\\]\(y\) \\`c\\` 3 times\./);
  const table = spansAsTable({ ...report, blocks: [{ from: 0, to: 1, sequence: '=HYPERLINK("x")', words: [] }], spans: [
    { kind: 'line', blocks: [0, 0], start: [0, 0, 0], end: [1, 0, -2], length: 1, feed: null, seconds: null },
  ] });
  assert.match(table, /\r\nline,"'=HYPERLINK\(""x""\)","'=HYPERLINK\(""x""\)",0,0,0,1,0,-2,,,,,,1,,,\r\n$/);
});

test('a tape without a problem says so', () => {
  const report = check('%\nN001 M30\n', { ...FORMAT, classification: 'CAM 222' });
  assert.equal(problemsAsMarkdown({ ...report, diagnostics: [] }, 'F'), '# Problems of the tape\n\nFormat: `F`\n\nNothing to object to.\n');
});
