// A contouring tape of so many blocks, the same in every run: straight cuts, each with N, G, X, Y, Z and F.

/** The detail of its format; the rest is that of the preset. */
export const PRESET = 'annex-e-parabolic';
export const DETAIL = 'N7.G2.X+33.Y+33.Z+33.F4.M2*';

/** So many characters of each line stand before the last digit of X. */
export const BEFORE_DIGIT = 'N0000001 G01 X+01234'.length;

/** From here the path turns back. */
const FAR = 900_000;

/** @param {number} blocks */
export function contour(blocks) {
  const lines = ['%'];
  const at = [0, 0, 0];
  let noise = 1;
  // The generator of Park and Miller.
  const random = () => (noise = (noise * 48_271) % 2_147_483_647);
  for (let number = 1; number <= blocks; number += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const way = (random() % 2000) + 1;
      const outwards = at[axis] < 0 ? -way : way;
      at[axis] += Math.abs(at[axis]) > FAR || random() % 2 === 0 ? -outwards : outwards;
    }
    const [x, y, z] = at.map((value) => `${value < 0 ? '-' : '+'}${padded(Math.abs(value), 6)}`);
    const feed = padded(100 + (number % 900), 4);
    lines.push(`N${padded(number, 7)} G01 X${x} Y${y} Z${z} F${feed}${number === blocks ? ' M30' : ''}`);
  }
  return `${lines.join('\n')}\n`;
}

/**
 * @param {number} value
 * @param {number} digits
 */
const padded = (value, digits) => String(value).padStart(digits, '0');
