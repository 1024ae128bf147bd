// A tape with all that opens it, as it comes from a link or from what the browser keeps: nothing of it is believed.

/** @typedef {{ source: string, format: import('nctape').Format, cursor: number, kind?: import('nctape').SourceKind }} Whole  left out, it is a tape */

/** Characters of a text that is taken from there: a hundred times what the longest link is made of here. */
export const MOST_TEXT = 800_000;

/**
 * What was read, if it is a tape; nothing of it is taken but what belongs to one.
 * @param {any} found
 * @param {string[]} standards  that a format may follow
 * @returns {Whole | null}
 */
export function wholeOf(found, standards) {
  if (typeof found !== 'object' || found === null) return null;
  const { source, format, cursor, kind } = found;
  if (typeof source !== 'string' || source.length > MOST_TEXT) return null;
  if (typeof format !== 'object' || format === null || typeof format.detail !== 'string') return null;
  if (!standards.includes(format.standard)) return null;
  const whole = { source, format, cursor: Number.isInteger(cursor) && cursor >= 0 ? cursor : 0 };
  return kind === 'cldata' ? { ...whole, kind } : whole;
}
