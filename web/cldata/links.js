// What became of what: stretches of CLDATA and stretches of the tape that they became, both ways. The map has four
// offsets for each: from and to in the source, from and to in the text; empty in the text where it gave nothing.

/** @typedef {{ from: number, to: number }} Range */

/**
 * All that a stretch of the source became, from the first to the last of it; empty where it gave nothing of its own, and
 * null where nothing is known of it.
 * @param {Uint32Array} map
 * @param {Range} source
 * @returns {Range | null}
 */
export function becameOf(map, { from, to }) {
  /** @type {Range | null} */
  let range = null;
  /** @type {number | null} */
  let nothing = null;
  for (let i = 0; i < map.length; i += 4) {
    if (map[i] >= to || map[i + 1] <= from) continue;
    if (map[i + 2] === map[i + 3]) nothing ??= map[i + 2];
    else if (range === null) range = { from: map[i + 2], to: map[i + 3] };
    else range = { from: Math.min(range.from, map[i + 2]), to: Math.max(range.to, map[i + 3]) };
  }
  return range ?? (nothing === null ? null : { from: nothing, to: nothing });
}

/**
 * Where the text goes on with what stands behind an offset of the source; the end of the text where nothing does.
 * @param {Uint32Array} map
 * @param {number} offset
 * @param {number} end
 */
export function placeBehind(map, offset, end) {
  let best = Infinity;
  let place = end;
  for (let i = 0; i < map.length; i += 4) {
    if (map[i] < offset || map[i] >= best || map[i + 2] === map[i + 3]) continue;
    best = map[i];
    place = map[i + 2];
  }
  return place;
}

/**
 * The stretch of the source that an offset of the text came from: of several, the last one, which is the motion that
 * the others only prepared. Null where nothing of the source stands behind it.
 * @param {Uint32Array} map
 * @param {number} offset
 * @returns {Range | null}
 */
export function cameFrom(map, offset) {
  /** @type {Range | null} */
  let found = null;
  for (let i = 0; i < map.length; i += 4) {
    if (map[i + 2] > offset || map[i + 3] <= offset) continue;
    if (found === null || map[i] >= found.from) found = { from: map[i], to: map[i + 1] };
  }
  return found;
}
