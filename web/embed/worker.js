// The worker of the page that is one file: its wasm comes with the first message, a letter for each byte.
import init from 'nctape';
import { serve } from '../worker.js';

onmessage = ({ data }) => serve(init({ module_or_path: bytesOf(data) }));

/** @param {string} letters  whose last eight bits are the bytes */
function bytesOf(letters) {
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; i += 1) bytes[i] = letters.charCodeAt(i);
  return bytes;
}
