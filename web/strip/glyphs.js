// The characters under the rows, drawn once each and copied from then on, as the columns of holes are.

/** Room around a character, as a part of the pitch. */
const AROUND = 0.5;
/** CSS pixels of height: the longest name, set upright. */
const HEIGHT = 22;

export class Glyphs {
  constructor() {
    /** @type {Map<string, HTMLCanvasElement>} */
    this.drawn = new Map();
    this.key = '';
  }

  /**
   * Draws a character, or the name of one that is not printed, around a place.
   * @param {CanvasRenderingContext2D} context
   * @param {{ pitch: number, ratio: number, font: string }} size  device pixels of a row, device pixels for one of CSS
   * @param {string} label
   * @param {number} x  left edge of the row, in device pixels
   * @param {number} y  the middle of the character
   * @param {string} colour
   * @param {number} weight
   */
  put(context, size, label, x, y, colour, weight) {
    if (label === '') return;
    const key = `${size.pitch} ${size.ratio} ${size.font}`;
    if (key !== this.key) this.drawn.clear();
    this.key = key;
    const name = `${weight} ${colour} ${label}`;
    let glyph = this.drawn.get(name);
    if (glyph === undefined) this.drawn.set(name, (glyph = drawn(size, label, colour, weight)));
    const around = (glyph.width - size.pitch) / 2;
    context.drawImage(glyph, x - around, y - glyph.height / 2);
  }
}

/**
 * @param {{ pitch: number, ratio: number, font: string }} size
 * @param {string} label
 * @param {string} colour
 * @param {number} weight
 */
function drawn({ pitch, ratio, font }, label, colour, weight) {
  const canvas = document.createElement('canvas');
  // Even heights and whole margins: copied, every pixel falls on one of the strip's.
  canvas.width = pitch + 2 * Math.ceil(pitch * AROUND);
  canvas.height = 2 * Math.ceil((HEIGHT * ratio) / 2);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.fillStyle = colour;
  context.textBaseline = 'middle';
  context.textAlign = 'center';
  context.translate(canvas.width / 2, canvas.height / 2);
  if (label.length === 1) {
    context.font = `${weight} ${12 * ratio}px ${font}`;
  } else {
    context.font = `${weight} ${Math.min(8 * ratio, (20 * ratio) / (0.61 * label.length))}px ${font}`;
    context.rotate(-Math.PI / 2);
  }
  context.fillText(label, 0, 0);
  return canvas;
}
