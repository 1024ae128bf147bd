// The frame's side of the talk with the page around it.
import { messageOf, VERSION } from './protocol.js';

/** @typedef {import('./protocol.js').Message} Message */

/** The page stands in another one. */
export const isFramed = () => window.parent !== window;

/**
 * Says something to the page around; there may be none. What is said is the tape and what was found in it, which that
 * page gave itself: any page may hear it.
 * @param {string} type
 * @param {Record<string, unknown>} [fields]
 */
export function tellHost(type, fields = {}) {
  if (isFramed()) window.parent.postMessage({ nctape: VERSION, type, ...fields }, '*');
}

/**
 * Hears the page around, and no one else.
 * @param {(message: Message) => void} hear
 */
export function hearHost(hear) {
  window.addEventListener('message', ({ source, data }) => {
    if (!isFramed() || source !== window.parent) return;
    const message = messageOf(data);
    if (message === null) return;
    if (message.nctape !== VERSION) tellHost('error', { message: `This frame speaks version ${VERSION} of the protocol.` });
    else hear(message);
  });
}
