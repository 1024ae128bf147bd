// What the page in the frame is to show, from its address or from the page around it: nothing of it is believed.
import { readLink } from '../share/link.js';
import { wholeOf } from '../share/whole.js';
import { goalOf } from './goal.js';
import { HOSTED, isText, MOST_TEXT, SETTINGS, TAPE } from './protocol.js';

/** @typedef {import('../share/whole.js').Whole} Whole */
/** @typedef {typeof VIEWS[number]} ViewName */
/** @typedef {{ presets: import('nctape').Preset[], standards: string[] }} Known  what the core knows */

/**
 * @typedef {object} Settings
 * @property {ViewName[]} views
 * @property {boolean} readOnly
 * @property {'light' | 'dark' | 'auto'} theme
 * @property {string | null} block  that is lit at first
 * @property {import('./goal.js').Goal | null} goal
 * @property {URL | null} page  where the full page is
 */

export const VIEWS = /** @type {const} */ (['strip', 'text', 'problems', 'plot']);
const THEMES = /** @type {const} */ (['light', 'dark', 'auto']);
/** A tape's number, a theme, an address. */
const MOST_WORD = 4096;

/** @typedef {Partial<Record<typeof SETTINGS[number], string>>} Stated */

/**
 * The settings behind the #: `#1.…&views=text,plot`, `#preset=annex-e-circular&read-only`.
 * @param {string} hash
 * @returns {{ hosted: boolean, stated: Stated }}
 */
export function inAddress(hash) {
  const parts = hash.slice(1).split('&').filter((part) => part !== '');
  /** @type {Record<string, unknown>} */
  const found = {};
  if (/^\d+\./.test(parts[0] ?? '')) found.tape = `#${parts.shift()}`;
  for (const part of parts) {
    const [name] = part.split('=', 1);
    found[name] = decoded(part.slice(name.length + 1));
  }
  return { hosted: HOSTED in found, stated: statedIn(found) };
}

/** @param {string} text  in which + stands for itself, as it does on a tape */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/**
 * The settings among the fields of a message.
 * @param {unknown} found
 * @returns {Stated}
 */
export function statedIn(found) {
  if (typeof found !== 'object' || found === null) return {};
  const fields = /** @type {Record<string, unknown>} */ (found);
  const long = ['source', 'tape', 'goal-tape', 'format'];
  return Object.fromEntries(SETTINGS.filter((name) => isText(fields[name], long.includes(name) ? MOST_TEXT : MOST_WORD)).map((name) => [name, fields[name]]));
}

/**
 * The settings that say which tape, or the others.
 * @param {Stated} stated
 * @param {boolean} wanted
 * @returns {Stated}
 */
export const ofTape = (stated, wanted) =>
  Object.fromEntries(Object.entries(stated).filter(([name]) => /** @type {readonly string[]} */ (TAPE).includes(name) === wanted));

/**
 * The tape that is wanted; whatever is wrong with what was stated goes to `fault`, and something is shown in its place.
 * @param {Stated} stated
 * @param {Known} known
 * @param {(words: string) => void} fault
 * @returns {Promise<Whole>}
 */
export async function tapeOf(stated, { presets, standards }, fault) {
  const preset = presets.find(({ id }) => id === stated.preset);
  if (stated.preset !== undefined && preset === undefined) fault(`There is no preset “${stated.preset.slice(0, 60)}”.`);
  /** @type {Whole} */
  let tape = preset ?? presets[0];
  if (stated.tape !== undefined) tape = (await linked(stated.tape, standards, fault)) ?? tape;
  const format = stated.format === undefined ? tape.format : (formatOf(stated.format, standards, fault) ?? tape.format);
  const { source = tape.source } = stated;
  return { source, format, cursor: source === tape.source ? tape.cursor : 0 };
}

/**
 * All but the tape.
 * @param {Stated} stated
 * @param {Known} known
 * @param {(words: string) => void} fault
 * @returns {Promise<Settings>}
 */
export async function settingsOf(stated, { standards }, fault) {
  /** @param {readonly string[]} choices @param {string} name @param {string} value */
  const isOne = (choices, name, value) => choices.includes(value) || fault(`${name}: “${value.slice(0, 60)}” is none of ${choices.join(', ')}.`);
  const words = (stated.views ?? '').split(/[\s,]+/).filter((word) => word !== '' && isOne(VIEWS, 'views', word));
  const theme = stated.theme ?? 'auto';
  const goalTape = stated['goal-tape'];
  return {
    views: words.length === 0 ? [...VIEWS] : VIEWS.filter((view) => words.includes(view)),
    readOnly: stated['read-only'] !== undefined && stated['read-only'] !== 'false',
    theme: isOne(THEMES, 'theme', theme) ? /** @type {Settings['theme']} */ (theme) : 'auto',
    block: stated.block ?? null,
    goal: goalOf(stated.goal ?? '', goalTape === undefined ? null : await goalTapeOf(goalTape, standards, fault), fault),
    page: stated.page === undefined ? null : addressOf(stated.page, fault),
  };
}

/**
 * The tape of a link, of which all before the # may be left out.
 * @param {string} link
 * @param {string[]} standards
 * @param {(words: string) => void} fault
 */
async function linked(link, standards, fault) {
  const found = await readLink(link.slice(Math.max(0, link.indexOf('#'))), standards);
  if (found !== null && 'tape' in found) {
    if (found.tape.kind !== 'cldata') return found.tape;
    fault('The link holds CLDATA, which a frame does not show: open it in the playground itself.');
    return null;
  }
  fault(`The link could not be opened. ${found === null ? 'It has no tape behind its #.' : found.trouble}`);
  return null;
}

/**
 * @param {string} text  of a tape, or a link to one
 * @param {string[]} standards
 * @param {(words: string) => void} fault
 * @returns {Promise<import('./goal.js').GoalTape | null>}
 */
async function goalTapeOf(text, standards, fault) {
  if (!/^\S*#\d+\./.test(text)) return { source: text, format: null };
  return linked(text, standards, fault);
}

/**
 * @param {string} text  JSON, or the format detail of ISO 2539 alone
 * @param {string[]} standards
 * @param {(words: string) => void} fault
 */
function formatOf(text, standards, fault) {
  try {
    const format = text.trim().startsWith('{') ? JSON.parse(text) : { standard: standards[0], detail: text.trim() };
    const whole = wholeOf({ source: '', format, cursor: 0 }, standards);
    if (whole !== null) return whole.format;
  } catch {
    // Said below.
  }
  fault('format: neither the JSON of a format nor a format detail.');
  return null;
}

/**
 * @param {string} text
 * @param {(words: string) => void} fault
 */
function addressOf(text, fault) {
  try {
    const address = new URL(text, location.href);
    if (['http:', 'https:', 'file:'].includes(address.protocol)) return address;
  } catch {
    // Said below.
  }
  fault('page: no address of a page.');
  return null;
}
