// The 256 columns of tape as one picture, for the pitch and theme in use.

/** @typedef {Awaited<ReturnType<import('../worker.js').Facts['columns']>>} Sheet */

export class SheetSource {
  /**
   * @param {(pitch: number, theme: 'light' | 'dark') => Promise<Sheet>} ask
   * @param {(sheet: Sheet) => void} onSheet
   */
  constructor(ask, onSheet) {
    this.ask = ask;
    this.onSheet = onSheet;
    /** @type {Sheet | null} */
    this.sheet = null;
    this.wanted = '';
  }

  /**
   * @param {number} pitch  in device pixels
   * @param {'light' | 'dark'} theme
   */
  async want(pitch, theme) {
    const key = `${pitch} ${theme}`;
    if (key === this.wanted) return;
    this.wanted = key;
    const sheet = await this.ask(pitch, theme);
    if (key !== this.wanted) return;
    this.sheet?.sheet.close();
    this.sheet = sheet;
    this.onSheet(sheet);
  }
}

/**
 * Copies the column of a byte, pixel by pixel.
 * @param {CanvasRenderingContext2D} context
 * @param {Sheet} sheet
 * @param {number} byte
 * @param {number} x
 * @param {number} y
 */
export function putColumn(context, { sheet, pitch, columnHeight, perRow }, byte, x, y) {
  const fromX = (byte % perRow) * pitch;
  const fromY = Math.floor(byte / perRow) * columnHeight;
  context.drawImage(sheet, fromX, fromY, pitch, columnHeight, x, y, pitch, columnHeight);
}
