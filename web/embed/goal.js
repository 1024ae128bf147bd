// What an exercise asks for, and whether the tape does it.
import { whole } from '../words.js';

/** @typedef {{ source: string, format: import('nctape').Format | null }} GoalTape  null: in the format of the tape */
/**
 * @typedef {object} Goal
 * @property {boolean} noErrors
 * @property {number | null} rows  at most so many
 * @property {{ tape: GoalTape, tolerance: number } | null} path  that of another tape
 */

/**
 * "no-errors", "rows=120", "path=0.01", or several of them.
 * @param {string} text
 * @param {GoalTape | null} tape  whose path is meant
 * @param {(words: string) => void} fault
 * @returns {Goal | null}
 */
export function goalOf(text, tape, fault) {
  /** @type {Goal} */
  const goal = { noErrors: false, rows: null, path: null };
  let some = false;
  for (const word of text.split(/[\s,]+/).filter((part) => part !== '')) {
    const [name, value] = word.split('=', 2);
    const number = Number(value);
    if (word === 'no-errors') goal.noErrors = true;
    else if (name === 'rows' && Number.isSafeInteger(number) && number > 0) goal.rows = number;
    else if (name === 'path' && number > 0 && Number.isFinite(number) && tape !== null) goal.path = { tape, tolerance: number };
    else {
      fault(
        name === 'path' && tape === null
          ? 'goal: path wants the tape whose path is meant, in goal-tape.'
          : `goal: “${word.slice(0, 60)}” is none of no-errors, rows=120, path=0.01.`,
      );
      continue;
    }
    some = true;
  }
  return some ? goal : null;
}

/**
 * @param {Goal} goal
 * @param {import('nctape').Summary} summary
 * @param {import('../engine.js').Engine} engine
 * @param {import('nctape').Format} format  of the tape
 * @returns {Promise<boolean | undefined>}  undefined: the tape has changed meanwhile
 */
export async function isMet({ noErrors, rows, path }, summary, engine, format) {
  // Nothing is not yet an answer.
  if (summary.blocks === 0) return false;
  if (noErrors && summary.errors > 0) return false;
  if (rows !== null && summary.rows > rows) return false;
  if (path === null) return true;
  return engine.ask('samePath', path.tape.source, path.tape.format ?? format, path.tolerance);
}

/**
 * The goal as one phrase: "no errors, and the given path within 0.01 mm".
 * @param {Goal} goal
 * @param {import('nctape').Summary} summary
 */
export function goalWords({ noErrors, rows, path }, { unit }) {
  const parts = [
    noErrors ? 'no errors' : '',
    rows === null ? '' : `at most ${whole(rows)} rows of tape`,
    path === null ? '' : `the given path within ${path.tolerance} ${unit === 'mm' ? 'mm' : 'in'}`,
  ].filter((part) => part !== '');
  return parts.length > 1 ? `${parts.slice(0, -1).join(', ')}, and ${parts[parts.length - 1]}` : parts[0];
}
