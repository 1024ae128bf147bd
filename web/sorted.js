// Looks things up in a sorted list by halving it.

/**
 * How many things at the start of a list something holds of, where it holds of none behind them.
 * @param {number} length  of the list
 * @param {(index: number) => boolean} holds
 */
export function countWhile(length, holds) {
  let low = 0;
  let high = length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(middle)) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * The first place of a value or of a greater one; the length of the list where there is none.
 * @param {Uint32Array} sorted
 * @param {number} value
 */
export const firstAtOrAfter = (sorted, value) => countWhile(sorted.length, (index) => sorted[index] < value);
