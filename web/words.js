// Numbers with their units, in words for people.

/** @typedef {'mm' | 'inch'} Unit */

/**
 * @param {number} value
 * @param {number} places
 */
function fixed(value, places) {
  const text = value.toFixed(places);
  return Number(text) === 0 ? (0).toFixed(places) : text.replace('-', '−');
}

/**
 * A coordinate, without its unit.
 * @param {number} value
 * @param {Unit} unit
 */
export const coordinate = (value, unit) => fixed(value, unit === 'mm' ? 3 : 4);

/**
 * The same without zeros at its end.
 * @param {number} value
 * @param {Unit} unit
 */
export const shortCoordinate = (value, unit) => trimmed(coordinate(value, unit));

/**
 * @param {number} value
 * @param {Unit} unit
 */
export const length = (value, unit) => `${coordinate(value, unit)} ${unit === 'mm' ? 'mm' : 'in'}`;

/**
 * @param {number} value
 * @param {Unit} unit
 */
export const longLength = (value, unit) =>
  unit === 'mm' && value >= 10_000 ? `${fixed(value / 1000, 2)} m` : `${fixed(value, unit === 'mm' ? 1 : 2)} ${unit === 'mm' ? 'mm' : 'in'}`;

/**
 * @param {number | null} value
 * @param {Unit} unit
 */
export const feed = (value, unit) =>
  value === null ? 'not known' : `${significant(value)} ${unit === 'mm' ? 'mm/min' : 'in/min'}`;

/** @param {number} value */
function significant(value) {
  const places = value >= 1000 ? 0 : value >= 100 ? 1 : value >= 10 ? 2 : 3;
  return trimmed(fixed(value, places));
}

/** @param {string} text */
const trimmed = (text) => (text.includes('.') ? text.replace(/\.?0+$/, '') : text);

/** @param {number | null} seconds */
export function time(seconds) {
  if (seconds === null) return 'not known';
  if (seconds < 60) return `${trimmed(fixed(seconds, 2))} s`;
  const whole = Math.round(seconds);
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor((whole % 3600) / 60);
  return hours > 0 ? `${hours} h ${minutes} min` : `${minutes} min ${whole % 60} s`;
}

/** @param {number} radians */
export const degrees = (radians) => `${trimmed(fixed((radians * 180) / Math.PI, 3))}°`;

/** @param {number} millimetres */
export const metres = (millimetres) => `${fixed(millimetres / 1000, millimetres < 100_000 ? 2 : 0)} m`;

/** @param {number} millimetres */
export const feet = (millimetres) => `${fixed(millimetres / 304.8, millimetres < 30_480 ? 1 : 0)} ft`;

/**
 * "1 block", "12 345 blocks".
 * @param {number} count
 * @param {string} one
 * @param {string} [many]
 */
export const counted = (count, one, many = `${one}s`) => `${whole(count)} ${count === 1 ? one : many}`;

/** @param {number} count */
export const whole = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/**
 * "1, 2 and 7".
 * @param {(string | number)[]} items
 */
export function listed(items) {
  if (items.length < 2) return items.join('');
  return `${items.slice(0, -1).join(', ')} and ${items[items.length - 1]}`;
}

/** @param {string} text */
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/**
 * "3 errors and 1 warning"; empty when there is none.
 * @param {import('nctape').Summary} summary
 */
export function tally(summary) {
  const parts = [];
  if (summary.errors > 0) parts.push(counted(summary.errors, 'error'));
  if (summary.warnings > 0) parts.push(counted(summary.warnings, 'warning'));
  if (summary.infos > 0) parts.push(counted(summary.infos, 'note'));
  return listed(parts);
}
