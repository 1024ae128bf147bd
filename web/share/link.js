// A tape as a link: `#1.`, then its JSON deflated, as letters that an address may hold. What stands behind a # is never
// sent to a server.
//
// The number says how the rest is to be read. Whoever changes that takes the next number and keeps the old reader:
// links live for ever. tests/links has one of each.

import { MOST_TEXT, wholeOf } from './whole.js';

/** @typedef {import('./whole.js').Whole} Whole */

/** Characters of a link: mail, chat and course systems cut what is much longer. Some 700 blocks fit. */
export const MOST_CHARACTERS = 8000;
const MARK = '#1.';

/**
 * The part of the address from the # on; it may be longer than what is shared.
 * @param {Whole} tape
 */
export async function linkOf({ source, format, cursor, kind }) {
  // Of a tape as it always was; an older page reads CLDATA as a tape, and says what it is.
  const text = new TextEncoder().encode(JSON.stringify({ source, format, cursor, ...(kind === 'cldata' && { kind }) }));
  const packed = await through(text, new CompressionStream('deflate-raw'), Infinity);
  const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return MARK + letters.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * The tape of a link; null where the address holds none.
 * @param {string} hash  of the address
 * @param {string[]} standards  that a format may follow
 * @returns {Promise<{ tape: Whole } | { trouble: string } | null>}
 */
export async function readLink(hash, standards) {
  const version = /^#(\d+)\./.exec(hash);
  if (version === null) return null;
  if (version[1] !== '1') return { trouble: `It is of version ${version[1]}, which this page does not know yet.` };
  try {
    const letters = hash.slice(MARK.length).replaceAll('-', '+').replaceAll('_', '/');
    const packed = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
    const text = await through(packed, new DecompressionStream('deflate-raw'), 4 * MOST_TEXT);
    const found = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(text));
    const tape = wholeOf(found, standards);
    return tape === null ? { trouble: 'What it holds is no tape with its format.' } : { tape };
  } catch (error) {
    return { trouble: error instanceof TooMuch ? 'It holds more than a tape.' : 'It is damaged: some of its characters are missing or changed.' };
  }
}

class TooMuch extends Error {}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} change
 * @param {number} most  bytes that may come out
 */
async function through(bytes, change, most) {
  const writer = change.writable.getWriter();
  // What goes wrong is told by the side that is read.
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  const reader = change.readable.getReader();
  /** @type {Uint8Array[]} */
  const pieces = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    pieces.push(value);
    size += value.length;
    if (size > most) {
      void reader.cancel();
      throw new TooMuch();
    }
  }
  const all = new Uint8Array(size);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}
