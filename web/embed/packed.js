// The parts of the file that are no page: the script of the worker, and the wasm for it.
import { trustedWorker } from '../trusted.js';

/** @param {string} id */
const textOf = (id) => document.getElementById(id)?.textContent ?? '';

/** A worker of the script in this file. */
export function packedWorker() {
  const address = URL.createObjectURL(new Blob([textOf('worker')], { type: 'text/javascript' }));
  const worker = trustedWorker(address, { name: 'nctape' });
  // A minute is plenty for the browser to have read it.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
  worker.postMessage(textOf('wasm'));
  return worker;
}
