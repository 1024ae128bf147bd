// The small part of Markdown in which the pages of the rules are written, as elements.
import { el } from './dom.js';

/**
 * What stands under a fence, called for one fence after another.
 * @typedef {(info: string, body: string) => HTMLElement | null} UnderFence
 */

/**
 * @param {string} source
 * @param {UnderFence} [underFence]
 * @returns {HTMLElement[]}
 */
export function markdown(source, underFence = () => null) {
  const lines = source.replace(/\r\n?/g, '\n').split('\n');
  /** @type {HTMLElement[]} */
  const blocks = [];
  let i = 0;
  while (i < lines.length) {
    const [made, next] = block(lines, i, underFence);
    if (made !== null) blocks.push(made);
    i = next;
  }
  return blocks;
}

const FENCE = /^\s*(```+|~~~+)\s*(.*)$/;
const HEADING = /^(#{1,6})\s+(.*?)\s*#*$/;
const ITEM = /^\s*(?:([-*+])|(\d+)[.)])\s+(.*)$/;

/**
 * The block that begins at a line, and the line behind it.
 * @param {string[]} lines
 * @param {number} at
 * @param {UnderFence} underFence
 * @returns {[HTMLElement | null, number]}
 */
function block(lines, at, underFence) {
  const line = lines[at];
  if (line.trim() === '') return [null, at + 1];
  if (FENCE.test(line)) return fence(lines, at, underFence);
  const heading = HEADING.exec(line);
  if (heading !== null) {
    // The dialog has the second level itself.
    const level = /** @type {'h3' | 'h4' | 'h5'} */ (`h${Math.max(3, Math.min(5, heading[1].length + 1))}`);
    return [el(level, null, ...inline(heading[2])), at + 1];
  }
  if (ITEM.test(line)) return list(lines, at);
  let end = at + 1;
  while (end < lines.length && lines[end].trim() !== '' && !startsBlock(lines[end])) end += 1;
  return [el('p', null, ...inline(lines.slice(at, end).join(' '))), end];
}

/** @param {string} line */
const startsBlock = (line) => FENCE.test(line) || HEADING.test(line) || ITEM.test(line);

/**
 * @param {string[]} lines
 * @param {number} at
 * @param {UnderFence} underFence
 * @returns {[HTMLElement, number]}
 */
function fence(lines, at, underFence) {
  const [, mark = '```', info = ''] = FENCE.exec(lines[at]) ?? [];
  let end = at + 1;
  while (end < lines.length && !lines[end].trim().startsWith(mark)) end += 1;
  const body = lines.slice(at + 1, end).join('\n');
  const made = el('pre', { tabindex: '0', class: info.startsWith('json') ? 'wrapped' : null }, el('code', null, body));
  const under = underFence(info.trim(), body);
  return [under === null ? made : el('div', { class: 'example' }, made, under), end + 1];
}

/**
 * @param {string[]} lines
 * @param {number} at
 * @returns {[HTMLElement, number]}
 */
function list(lines, at) {
  const ordered = ITEM.exec(lines[at])?.[2] !== undefined;
  const made = el(ordered ? 'ol' : 'ul');
  let end = at;
  while (end < lines.length) {
    const item = ITEM.exec(lines[end]);
    if (item === null) break;
    const words = [item[3]];
    end += 1;
    while (end < lines.length && lines[end].trim() !== '' && !startsBlock(lines[end])) {
      words.push(lines[end].trim());
      end += 1;
    }
    made.append(el('li', null, ...inline(words.join(' '))));
  }
  return [made, end];
}

const INLINE = /(`+)(.+?)\1|\*\*(.+?)\*\*|\*(.+?)\*|\b_(.+?)_\b|\[([^\]]+)\]\([^)]*\)/;

/**
 * Code, emphasis; a link is its words, for the page goes nowhere else.
 * @param {string} text
 * @returns {(Node | string)[]}
 */
function inline(text) {
  const found = INLINE.exec(text);
  if (found === null) return text === '' ? [] : [text];
  const [all, , code, strong, star, underscore, link] = found;
  const made =
    code !== undefined
      ? el('code', null, code.replace(/^ (.+) $/, '$1'))
      : strong !== undefined
        ? el('strong', null, ...inline(strong))
        : link !== undefined
          ? el('span', null, ...inline(link))
          : el('em', null, ...inline(star ?? underscore));
  return [text.slice(0, found.index), made, ...inline(text.slice(found.index + all.length))].filter((part) => part !== '');
}
