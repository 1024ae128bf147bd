// The runs of a path that may show in a part of the picture: whoever draws only these must miss nothing.
import assert from 'node:assert/strict';
import test from 'node:test';
import { CHUNK, Chunks } from '../../web/plot/chunks.js';

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
