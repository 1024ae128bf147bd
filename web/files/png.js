// Writes a picture as PNG with its scale, which a canvas cannot: a print of it has the size of the thing.

/** @type {Uint32Array | null} */
let table = null;

/** The check sums of PNG (its annex on CRC). @param {Uint8Array[]} parts */
function crc(parts) {
  table ??= Uint32Array.from({ length: 256 }, (_, n) => {
    let c = n;
    for (let k = 0; k < 8; k += 1) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
    return c;
  });
  let c = 0xffffffff;
  for (const part of parts) for (const byte of part) c = table[(c ^ byte) & 0xff] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

/** @param {...number} numbers  of four bytes each */
function words(...numbers) {
  const view = new DataView(new ArrayBuffer(4 * numbers.length));
  numbers.forEach((number, index) => view.setUint32(4 * index, number));
  return new Uint8Array(view.buffer);
}

/**
 * @param {string} name
 * @param {...Uint8Array<ArrayBuffer>} data
 */
function chunk(name, ...data) {
  const title = new TextEncoder().encode(name);
  const length = data.reduce((sum, { length }) => sum + length, 0);
  return [words(length), title, ...data, words(crc([title, ...data]))];
}

/**
 * @param {{ width: number, height: number, pixelsPerMetre: number }} size
 * @param {Iterable<Uint8Array<ArrayBuffer>>} lines  red, green and blue of the pixels of each line
 * @returns {Promise<Blob>}
 */
export async function png({ width, height, pixelsPerMetre }, lines) {
  const squeezed = new CompressionStream('deflate');
  const writer = squeezed.writable.getWriter();
  const collected = new Response(squeezed.readable).arrayBuffer();
  // Each line is told how it is written: as it is.
  const plain = new Uint8Array([0]);
  for (const line of lines) {
    await writer.write(plain);
    await writer.write(line);
  }
  await writer.close();
  const data = new Uint8Array(await collected);
  const scale = Math.round(pixelsPerMetre);
  return new Blob(
    [
      new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
      // Eight bits for each of three colours.
      ...chunk('IHDR', words(width, height), new Uint8Array([8, 2, 0, 0, 0])),
      ...chunk('pHYs', words(scale, scale), new Uint8Array([1])),
      ...chunk('IDAT', data),
      ...chunk('IEND'),
    ],
    { type: 'image/png' },
  );
}
