// Parts of the page that are fetched when they are wanted first.
import { notice } from './notice.js';

/**
 * Fetches once; where that fails it says so, and the next call tries again.
 * @template T
 * @param {() => Promise<T>} load
 * @returns {() => Promise<T>}
 */
export function lazily(load) {
  /** @type {Promise<T> | null} */
  let made = null;
  return () => {
    made ??= load().catch((error) => {
      made = null;
      notice(`This part of the page could not be loaded: ${error instanceof Error ? error.message : error}. Try it again.`);
      throw error;
    });
    return made;
  };
}
