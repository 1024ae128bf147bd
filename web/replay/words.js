// Moments in words.

/**
 * "1:07.4", "12:01:07": minutes and seconds, with hours where there are any; always as wide for one tape.
 * @param {number} seconds
 * @param {number} longest  the longest that stands in the same place
 */
export function clockTime(seconds, longest) {
  if (longest < 3600) {
    // Cut off, so that no minute has sixty seconds.
    const tenths = Math.floor(seconds * 10 + 1e-6);
    const minutes = Math.floor(tenths / 600);
    const width = String(Math.floor(longest / 60)).length;
    return `${String(minutes).padStart(width, '0')}:${String(Math.floor(tenths / 10) % 60).padStart(2, '0')}.${tenths % 10}`;
  }
  const whole = Math.floor(seconds + 1e-6);
  const width = String(Math.floor(longest / 3600)).length;
  const two = (/** @type {number} */ number) => String(number).padStart(2, '0');
  return `${String(Math.floor(whole / 3600)).padStart(width, '0')}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}
