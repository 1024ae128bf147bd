// Where the points of a span stand in the list of all points.

/**
 * The first point of a span or of one behind it, found by halving: spans are in order.
 * @param {Uint32Array} span  the span of each point
 * @param {number} index
 */
export function firstPointOf(span, index) {
  let low = 0;
  let high = span.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (span[middle] < index) low = middle + 1;
    else high = middle;
  }
  return low;
}
