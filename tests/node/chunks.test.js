// The runs of a path that may show in a part of the picture: whoever draws only these must miss nothing.
import assert from 'node:assert/strict';
import test from 'node:test';
import { CHUNK, Chunks, chunksOf, pointsChanged } from '../../web/plot/chunks.js';
import { boxesAlong } from '../../web/plot/dirty.js';
import { View } from '../../web/plot/view.js';

test('a run is off a part of the plane only where none of its lines touches it', () => {
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  const points = 5 * CHUNK + 7;
  const xyz = Float64Array.from({ length: 3 * points }, () => 200 * random() - 100);
  // Some runs that stay in a corner, so that there is something to leave out.
  for (let i = 3 * CHUNK; i < 9 * CHUNK; i += 1) xyz[i] = 90 + xyz[i] / 20;
  const chunks = new Chunks(xyz);
  let off = 0;
  for (let round = 0; round < 300; round += 1) {
    const [left, bottom] = [200 * random() - 100, 200 * random() - 100];
    /** @type {[number, number, number, number]} */
    const part = [left, left + 40 * random(), bottom, bottom + 40 * random()];
    for (let chunk = 0; chunk < chunks.count; chunk += 1) {
      if (!chunks.isOff(chunk, [0, 1], part)) continue;
      off += 1;
      for (let i = Math.max(1, chunk * CHUNK); i < Math.min(points, (chunk + 1) * CHUNK + 1); i += 1) {
        assert.ok(!touches(xyz, i, part), `line ${i} is seen, its run is left out`);
      }
    }
  }
  assert.ok(off > 100, 'nothing was ever left out');
});

test('boxes around points that were changed are those of a fresh path', () => {
  const points = 4 * CHUNK + 3;
  const xyz = Float64Array.from({ length: 3 * points }, (_, i) => Math.sin(i) * 50);
  const path = /** @type {import('nctape').Path} */ (/** @type {unknown} */ ({ xyz }));
  const kept = chunksOf(path);
  // At both sides of the edge of a run, whose box holds the points beside it.
  for (const [from, to] of [[CHUNK - 1, CHUNK], [CHUNK, CHUNK + 1], [2 * CHUNK - 2, 3 * CHUNK + 2], [0, 1], [points - 1, points]]) {
    for (let i = 3 * from; i < 3 * to; i += 1) xyz[i] = 900 + i;
    pointsChanged(xyz, from, to);
    assert.deepEqual(kept.boxes, new Chunks(xyz).boxes, `points ${from} to ${to}`);
  }
});

test('the boxes along a path hold all of its lines, and not the whole picture for one across it', () => {
  const view = new View();
  Object.assign(view, { width: 800, height: 600 });
  view.fit({ min: [0, 0, 0], max: [400, 300, 0] });
  const line = Float64Array.from([0, 0, 0, 400, 300, 0]);
  const boxes = boxesAlong(view, line, 0, 2);
  const area = boxes.reduce((sum, { left, top, right, bottom }) => sum + (right - left) * (bottom - top), 0);
  assert.ok(area < 0.5 * view.width * view.height, `${area} square pixels`);
  for (let step = 0; step <= 1000; step += 1) {
    const [x, y] = view.at(0.4 * step, 0.3 * step);
    const isIn = boxes.some(({ left, top, right, bottom }) => x - 5 >= left && x + 5 <= right && y - 5 >= top && y + 5 <= bottom);
    assert.ok(isIn, `${x}, ${y}`);
  }
  assert.equal(boxesAlong(view, line, 0, 0).length, 0);
  assert.equal(boxesAlong(view, new Float64Array(3 * 5000), 0, 5000).length, 1);
});

/**
 * The line to a point passes the part of the plane: looked at in small steps.
 * @param {Float64Array} xyz
 * @param {number} i
 * @param {[number, number, number, number]} part
 */
function touches(xyz, i, [left, right, bottom, top]) {
  for (let step = 0; step <= 64; step += 1) {
    const x = xyz[3 * i - 3] + ((xyz[3 * i] - xyz[3 * i - 3]) * step) / 64;
    const y = xyz[3 * i - 2] + ((xyz[3 * i + 1] - xyz[3 * i - 2]) * step) / 64;
    if (x > left && x < right && y > bottom && y < top) return true;
  }
  return false;
}
