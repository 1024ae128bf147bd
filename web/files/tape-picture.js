// The picture of a whole tape, true to scale, in lines that fit a sheet of paper. Runs in the worker.
import { picture } from 'nctape';
import { MOST_ROWS, ROWS_IN_LINE } from './limits.js';
import { png } from './png.js';

/** Pixels for a row: 240 to the inch. */
const PITCH = 24;

/**
 * @param {Uint8Array} rows
 * @returns {Promise<Blob>}
 */
export async function tapePicture(rows) {
  const shown = rows.subarray(0, MOST_ROWS);
  const tiles = [];
  for (let first = 0; first < Math.max(1, shown.length); first += ROWS_IN_LINE) {
    // Bare tape to the end of the last line, where there are several.
    const line = new Uint8Array(shown.length > ROWS_IN_LINE ? ROWS_IN_LINE : Math.max(1, shown.length));
    line.set(shown.subarray(first, first + ROWS_IN_LINE));
    tiles.push(line);
  }
  // One line is drawn at a time: the picture is never in memory as a whole.
  const { width, height, pixelsPerMetre } = picture(tiles[0], PITCH, 'light');
  return png({ width, height: height * tiles.length, pixelsPerMetre }, linesOf(tiles));
}

/** @param {Uint8Array[]} tiles */
function* linesOf(tiles) {
  for (const tile of tiles) {
    const { width, height, rgba } = picture(tile, PITCH, 'light');
    for (let y = 0; y < height; y += 1) {
      const line = new Uint8Array(3 * width);
      for (let x = 0; x < width; x += 1) {
        const at = 4 * (y * width + x);
        line[3 * x] = rgba[at];
        line[3 * x + 1] = rgba[at + 1];
        line[3 * x + 2] = rgba[at + 2];
      }
      yield line;
    }
  }
}
