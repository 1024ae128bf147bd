// A report as files for other programs: problems as Markdown, spans as comma-separated values.

/** @typedef {import('nctape').Report} Report */

const WORDS = { error: 'Error', warning: 'Warning', info: 'Note' };

/**
 * The problems as a list that a page of Markdown, an issue or a mail takes.
 * @param {Report} report
 * @param {string} format  in one line
 */
export function problemsAsMarkdown({ diagnostics, suppressed }, format) {
  const items = diagnostics.map(({ severity, line, column, rule, message, clauses, count }) => {
    const times = count > 1 ? ` ${count} times.` : '';
    const cited = clauses.length > 0 ? ` ${clauses.join(', ')}.` : '';
    return `- **${WORDS[severity]}** ${line}:${column} \`${rule}\` ${escaped(message)}${times}${cited}`;
  });
  const rest = suppressed > 0 ? [`- … and ${suppressed} more.`] : [];
  const body = items.length === 0 ? ['Nothing to object to.'] : [...items, ...rest];
  return `# Problems of the tape\n\nFormat: \`${format}\`\n\n${body.join('\n')}\n`;
}

/** What Markdown would take for its own. @param {string} text */
const escaped = (text) => text.replace(/[\\`*_[\]<>|#]/g, '\\$&');

/**
 * The spans, one a line, lengths in the unit of the format. A field that a span does not have, or that is not known, is
 * empty.
 * @param {Report} report
 */
export function spansAsTable({ spans, axes, unit, blocks }) {
  const ends = (/** @type {string} */ end) => axes.map((axis) => `${end} ${axis}`);
  const head = [
    'kind', 'first block', 'last block', ...ends('start'), ...ends('end'), 'plane', 'centre X', 'centre Y', 'centre Z', 'sweep rad',
    `length ${unit}`, `feed ${unit}/min`, 'seconds', 'stand-in',
  ];
  const rows = spans.map((span) => [
    span.kind,
    ...span.blocks.map((index) => blocks[index]?.sequence ?? index + 1),
    ...span.start,
    ...span.end,
    span.plane,
    ...[0, 1, 2].map((axis) => span.centre?.[axis]),
    span.sweep,
    span.length,
    span.feed,
    span.seconds,
    span.substitute === true ? 'yes' : '',
  ]);
  return [head, ...rows].map((row) => row.map(field).join(',')).join('\r\n') + '\r\n';
}

/**
 * RFC 4180: quoted where it has a comma or a quote. What a spreadsheet would take for a formula is text.
 * @param {string | number | null | undefined} value
 */
function field(value) {
  if (value === null || value === undefined) return '';
  if (typeof value === 'number') return String(value);
  const text = /^[=+\-@\t]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
