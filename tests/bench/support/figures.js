// Figures from measurements.

/**
 * The value that so many hundredths of all do not exceed.
 * @param {number[]} values
 * @param {number} percent
 */
export function percentile(values, percent) {
  if (values.length === 0) throw new Error('nothing was measured');
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.max(0, Math.ceil((percent / 100) * sorted.length) - 1)];
}

/** @param {number[]} values */
export const median = (values) => percentile(values, 50);

/** @param {number} value */
export const ms = (value) => `${value < 100 ? value.toFixed(1) : Math.round(value)} ms`;

/** @param {number} bytes  a kB is a thousand of them */
export const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;

/** @param {number[]} values */
export const medianAndP95 = (values) => `${ms(median(values))}, ${ms(percentile(values, 95))}`;

/** 100000 as 100 000. @param {number} count */
export const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ' ');

/**
 * A table in Markdown.
 * @param {string[]} head
 * @param {string[][]} rows
 */
export function table(head, rows) {
  const line = (/** @type {string[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n');
}
