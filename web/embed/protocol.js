// What a page and the playground in its frame say to one another. Both sides check who speaks, the version and every
// field; whatever is not as it should be is passed over.
//
// Whoever changes the meaning of a message takes the next version. docs/embedding.md lists all of them.

export const VERSION = 1;

/** Characters of one text in a message. */
export const MOST_TEXT = 800_000;

/** The settings that say which tape. */
export const TAPE = /** @type {const} */ (['preset', 'tape', 'source', 'format']);
/** Every setting of the frame: an attribute of the element, or a name behind the # of the frame's address. */
export const SETTINGS = /** @type {const} */ ([...TAPE, 'views', 'read-only', 'theme', 'block', 'goal', 'goal-tape', 'page']);

/** Behind the # of a frame that waits for its settings from the page around it. */
export const HOSTED = 'hosted';

/** @typedef {{ nctape: number, type: string } & Record<string, unknown>} Message */

/**
 * A message of this protocol, if it is one.
 * @param {unknown} data
 * @returns {Message | null}
 */
export function messageOf(data) {
  if (typeof data !== 'object' || data === null) return null;
  const { nctape, type } = /** @type {Record<string, unknown>} */ (data);
  return typeof nctape === 'number' && typeof type === 'string' ? /** @type {Message} */ (data) : null;
}

/**
 * A text that is short enough.
 * @param {unknown} value
 * @param {number} [most]
 * @returns {value is string}
 */
export const isText = (value, most = MOST_TEXT) => typeof value === 'string' && value.length <= most;
