// What the page remembers between visits. In a sandboxed frame every access throws: then it remembers nothing.

const PREFIX = 'nctape.';

/**
 * @param {string} key
 * @returns {string | null}
 */
export function recall(key) {
  try {
    return localStorage.getItem(PREFIX + key);
  } catch {
    return null;
  }
}

/**
 * @param {string} key
 * @param {string} value
 */
export function remember(key, value) {
  try {
    localStorage.setItem(PREFIX + key, value);
  } catch {
    // Not allowed here, or full: the page works without.
  }
}
