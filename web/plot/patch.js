// Brings a path up to date with what has changed of it.
import { firstAtOrAfter } from '../sorted.js';
import { pointsChanged } from './chunks.js';

/** @typedef {import('nctape').Path} Path */
/** @typedef {import('nctape').PathChange} PathChange */

/**
 * @param {Path | null} path  the one that the change is about
 * @param {PathChange} change
 * @returns {Path}
 */
export function patched(path, change) {
  const { first, last, shift, xyz, span, kinds, substitutes, blocks } = change;
  if (path === null || (first === 0 && last === 0)) return { xyz, span, kinds, substitutes, blocks };
  const before = path.kinds.length;
  const from = firstAtOrAfter(path.span, first);
  const to = firstAtOrAfter(path.span, before - last);
  const isAsLong = to - from === span.length && before - first - last === kinds.length;
  if (isAsLong) {
    path.xyz.set(xyz, 3 * from);
    pointsChanged(path.xyz, from, to);
    path.span.set(span, from);
    path.kinds.set(kinds, first);
    path.substitutes.set(substitutes, first);
    path.blocks.set(blocks, 2 * first);
    add(path.blocks, 2 * (before - last), shift);
    return { ...path };
  }
  const more = first + kinds.length + last - before;
  const next = {
    xyz: spliced(path.xyz, 3 * from, 3 * to, xyz),
    span: spliced(path.span, from, to, span),
    kinds: spliced(path.kinds, first, before - last, kinds),
    substitutes: spliced(path.substitutes, first, before - last, substitutes),
    blocks: spliced(path.blocks, 2 * first, 2 * (before - last), blocks),
  };
  add(next.span, from + span.length, more);
  add(next.blocks, 2 * (first + kinds.length), shift);
  return next;
}

/**
 * @template {Float64Array | Uint32Array | Uint8Array} T
 * @param {T} array
 * @param {number} from
 * @param {number} to
 * @param {T} insert
 * @returns {T}
 */
function spliced(array, from, to, insert) {
  const Kind = /** @type {new (length: number) => T} */ (array.constructor);
  const next = new Kind(array.length - (to - from) + insert.length);
  next.set(array.subarray(0, from));
  next.set(insert, from);
  next.set(array.subarray(to), from + insert.length);
  return next;
}

/**
 * @param {Uint32Array} array
 * @param {number} from
 * @param {number} summand
 */
function add(array, from, summand) {
  if (summand === 0) return;
  for (let i = from; i < array.length; i += 1) array[i] += summand;
}
