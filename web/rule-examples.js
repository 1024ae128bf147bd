// The examples of a rule's page: which format stands before a tape, and what of a fence is tape.

/** @typedef {import('nctape').Format} Format */
/** @typedef {{ source: string, format: Format, cursor: number, kind?: import('nctape').SourceKind }} Example */

/**
 * Reads the fences of one page from first to last. A tape is an example under the formats that stand before it, and
 * of these under the one of the wanted standard, else the first.
 * @param {import('nctape').Standard} standard
 * @param {Format} present  that CLDATA is posted to, where the page states none
 * @returns {(info: string, body: string) => Example | null}
 */
export function exampleReader(standard, present) {
  /** @type {Format[]} */
  let formats = [];
  let used = false;
  return (info, body) => {
    if (info === 'json format') {
      if (used) formats = [];
      used = false;
      formats.push(JSON.parse(body));
      return null;
    }
    const isCldata = /^cldata (good|bad)$/.test(info);
    if (!isCldata && !/^tape (good|bad|bad open)$/.test(info)) return null;
    used = true;
    const format = formats.find((one) => one.standard === standard) ?? formats[0];
    if (isCldata) return { ...withoutCaretLines(body), format: format ?? present, kind: 'cldata' };
    if (format === undefined) return null;
    const { source, cursor } = withoutCaretLines(body);
    // An open tape ends without its last line end.
    return { source: info.endsWith('open') ? source.slice(0, -1) : source, format, cursor };
  };
}

/**
 * The tape without the lines of carets, which mark the line above them; the cursor stands at the first mark.
 * @param {string} body
 */
function withoutCaretLines(body) {
  let source = '';
  let above = 0;
  /** @type {number | null} */
  let cursor = null;
  for (const line of body.split('\n')) {
    if (/^\s*\^+\s*$/.test(line)) {
      // A mark counts characters, a cursor UTF-16 code units.
      const before = [...source.slice(above)].slice(0, [...line].indexOf('^'));
      cursor ??= above + before.join('').length;
      continue;
    }
    above = source.length;
    source += `${line}\n`;
  }
  return { source, cursor: cursor ?? 0 };
}
