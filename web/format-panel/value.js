// Reading and changing one value of a format by its path.

/** @typedef {import('nctape').Format} Format */

/**
 * @param {Format} format
 * @param {string} path  "itemized.declared.G"
 * @returns {unknown}
 */
export function valueAt(format, path) {
  return path.split('.').reduce((part, key) => /** @type {any} */ (part)?.[key], /** @type {unknown} */ (format));
}

/**
 * The format with one value changed; without it where the value is undefined.
 * @param {Format} format
 * @param {string} path
 * @param {unknown} value
 * @returns {Format}
 */
export function withValue(format, path, value) {
  return /** @type {Format} */ (changed(format, path.split('.'), value));
}

/**
 * @param {any} part
 * @param {string[]} keys
 * @param {unknown} value
 * @returns {any}
 */
function changed(part, [key, ...rest], value) {
  const next = { ...part };
  const inner = rest.length === 0 ? value : changed(next[key] ?? {}, rest, value);
  const isEmpty = inner === undefined || (rest.length > 0 && Object.keys(inner).length === 0);
  if (isEmpty) delete next[key];
  else next[key] = inner;
  return next;
}
