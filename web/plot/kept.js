// The picture of the whole path, kept while the view stays: what has changed of it is drawn anew, and where the view
// is moved it is moved along, so that only what comes in at the edges is drawn.
import { drawPath, drawStart, isDense } from './draw.js';
import { boxesAlong, seen } from './dirty.js';

/** @typedef {import('nctape').Path} Path */
/** @typedef {import('./view.js').Box} Box */
/** @typedef {import('./view.js').View} View */

export class KeptPicture {
  /** @param {View} view */
  constructor(view) {
    this.view = view;
    this.canvas = document.createElement('canvas');
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    this.ratio = 1;
    /** What must be drawn anew; null: all of it. @type {Box[] | null} */
    this.untrue = null;
    /** It is drawn finely. */
    this.dense = false;
  }

  /**
   * @param {number} ratio  device pixels for a CSS pixel
   */
  measure(ratio) {
    this.ratio = ratio;
    this.canvas.width = Math.round(this.view.width * ratio);
    this.canvas.height = Math.round(this.view.height * ratio);
    this.untrue = null;
  }

  /** Nothing of it is true any longer. */
  drop() {
    this.untrue = null;
  }

  /**
   * Some points are no longer where they were, or have come.
   * @param {Float64Array} xyz
   * @param {number} from
   * @param {number} to  behind the last point
   */
  touch(xyz, from, to) {
    this.untrue?.push(...boxesAlong(this.view, xyz, from, to));
  }

  /**
   * Moves the view, by whole device pixels, and what is drawn with it; answers by how much of CSS pixels.
   * @param {number} x
   * @param {number} y
   * @returns {[number, number]}
   */
  panBy(x, y) {
    const { canvas, context, ratio, view } = this;
    const [right, down] = [Math.round(x * ratio), Math.round(y * ratio)];
    const [wide, high] = [right / ratio, down / ratio];
    view.panBy(wide, high);
    if (this.untrue !== null) {
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.globalCompositeOperation = 'copy';
      context.drawImage(canvas, right, down);
      context.globalCompositeOperation = 'source-over';
      const all = view.box();
      this.untrue = this.untrue.map((box) => ({
        left: box.left + wide,
        right: box.right + wide,
        top: box.top + high,
        bottom: box.bottom + high,
      }));
      if (wide !== 0) this.untrue.push(wide > 0 ? { ...all, right: wide } : { ...all, left: all.right + wide });
      if (high !== 0) this.untrue.push(high > 0 ? { ...all, bottom: high } : { ...all, top: all.bottom + high });
    }
    return [wide, high];
  }

  /**
   * Draws what is not true.
   * @param {Path | null} path
   * @param {(span: number) => string} kindOf
   * @param {Record<string, string>} colours
   */
  draw(path, kindOf, colours) {
    const { context, view, ratio } = this;
    const dense = path !== null && isDense(view, path);
    if (dense !== this.dense) this.untrue = null;
    this.dense = dense;
    for (const untrue of this.untrue ?? [view.box()]) {
      const box = seen(untrue, view, ratio);
      if (box === null) continue;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.save();
      context.beginPath();
      context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
      context.clip();
      context.clearRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
      if (path !== null && path.xyz.length > 0) {
        drawPath(context, view, path, kindOf, colours, { dense, box });
        drawStart(context, view, path.xyz.subarray(0, 3), colours);
      }
      context.restore();
    }
    this.untrue = [];
  }
}
