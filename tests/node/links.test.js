// From CLDATA to the tape that it became, and back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { becameOf, cameFrom, placeBehind } from '../../web/cldata/links.js';

// Four records of ten characters. The first gave nothing, the second two blocks, the third nothing, the fourth one; the
// second and the fourth share the last block.
const map = new Uint32Array([0, 10, 2, 2, 10, 20, 2, 12, 20, 30, 12, 12, 10, 20, 12, 22, 30, 40, 12, 22]);

test('what a record became', () => {
  assert.deepEqual(becameOf(map, { from: 0, to: 10 }), { from: 2, to: 2 });
  assert.deepEqual(becameOf(map, { from: 10, to: 20 }), { from: 2, to: 22 });
  assert.deepEqual(becameOf(map, { from: 30, to: 40 }), { from: 12, to: 22 });
  assert.equal(becameOf(map, { from: 40, to: 50 }), null);
  assert.equal(becameOf(new Uint32Array(), { from: 0, to: 10 }), null);
});

test('where the tape goes on behind a record', () => {
  assert.equal(placeBehind(map, 0, 30), 2);
  assert.equal(placeBehind(map, 20, 30), 12);
  assert.equal(placeBehind(map, 31, 30), 30, 'at its end');
});

test('what a block came from', () => {
  assert.equal(cameFrom(map, 0), null, 'nothing of the source stands behind the program start');
  assert.deepEqual(cameFrom(map, 2), { from: 10, to: 20 });
  assert.deepEqual(cameFrom(map, 12), { from: 30, to: 40 }, 'of two records the last');
  assert.equal(cameFrom(map, 22), null);
});
