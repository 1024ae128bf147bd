// Looks things up in a sorted list by halving it.

/**
 * The first place of a value or of a greater one; the length of the list where there is none.
 * @param {Uint32Array} sorted
 * @param {number} value
 */
export function firstAtOrAfter(sorted, value) {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
