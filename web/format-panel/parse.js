// How each kind of field is written in a box, and read back. Nothing is thrown: a fault is a sentence.

/** @typedef {import('nctape').FormatField['kind']} Kind */
/** @typedef {{ value: unknown } | { fault: string }} Parsed */

/**
 * @typedef {object} Way
 * @property {(value: any) => string} write
 * @property {(text: string) => Parsed} read  of a text that is not empty
 */

/** @param {string} text */
const items = (text) => text.split(/[,;\n]/).map((item) => item.trim()).filter((item) => item !== '');

/** @param {string} text */
function numberOf(text) {
  const value = Number(text.replace('−', '-'));
  return text.trim() === '' || !Number.isFinite(value) ? null : value;
}

/**
 * "A=…, B=…" with a reader for what stands behind the sign.
 * @template T
 * @param {string} text
 * @param {(text: string) => T | null} read
 * @param {string} example
 * @returns {Parsed}
 */
function pairs(text, read, example) {
  /** @type {Record<string, T>} */
  const value = {};
  for (const item of items(text)) {
    const sign = item.indexOf('=');
    const part = sign < 1 ? null : read(item.slice(sign + 1).trim());
    if (part === null) return { fault: `“${item}” cannot be read. Write it like ${example}.` };
    value[item.slice(0, sign).trim()] = part;
  }
  return { value };
}

/** @param {Record<string, unknown>} value @param {(part: any) => string} write */
const writePairs = (value, write = String) =>
  Object.entries(value)
    .map(([name, part]) => `${name}=${write(part)}`)
    .join(', ');

/** @type {Way} */
const text = { write: String, read: (written) => ({ value: written }) };

/** @type {Way} */
const json = {
  write: (value) => JSON.stringify(value),
  read(written) {
    try {
      return { value: JSON.parse(written) };
    } catch {
      return { fault: 'This cannot be read yet. Write it as JSON, like {"name": "value"}.' };
    }
  },
};

/** @type {Record<Kind, Way>} */
export const WAYS = {
  text,
  json,
  choice: text,
  flag: { write: String, read: (written) => ({ value: written === 'true' }) },
  number: {
    write: String,
    read(written) {
      const value = numberOf(written);
      return value === null ? { fault: `“${written}” is not a number.` } : { value };
    },
  },
  position: {
    write: (value) => (Array.isArray(value) ? value.join(', ') : writePairs(value)),
    read(written) {
      if (written.includes('=')) return pairs(written, numberOf, '10, 10, 20 or X=10, Z=20');
      const values = items(written).map(numberOf);
      return values.includes(null)
        ? { fault: 'A number for each axis, like 10, 10, 20.' }
        : { value: values };
    },
  },
  numbers: { write: writePairs, read: (written) => pairs(written, numberOf, '1=120, 2=160') },
  texts: { write: writePairs, read: (written) => pairs(written, (part) => part, 'G05=hold') },
  ranges: {
    write: (value) => writePairs(value, ([from, to]) => `${from}..${to}`),
    read: (written) =>
      pairs(
        written,
        (part) => {
          const ends = part.split('..').map(numberOf);
          return ends.length === 2 && !ends.includes(null) ? ends : null;
        },
        'X=0..85',
      ),
  },
};
