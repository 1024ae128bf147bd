// Hands a file to the browser.

/**
 * @param {Blob} blob
 * @param {string} name
 */
export function give(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has taken it by then; a minute is plenty for a slow one.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
