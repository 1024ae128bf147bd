// The path of the cutter's centre, a thin line beside the programmed path where cutter compensation is in force.
import { el } from '../dom.js';
import { AXES } from './view.js';

/** @typedef {import('./view.js').View} View */

export class CutterPath {
  /**
   * @param {import('../engine.js').Engine} engine
   * @param {() => void} onChange
   */
  constructor(engine, onChange) {
    this.engine = engine;
    this.onChange = onChange;
    /** @type {import('nctape').OffsetPath | null} */
    this.path = null;
  }

  /**
   * Asks for it anew. Nothing is asked of a tape without compensation.
   * @param {number} tolerance
   * @param {boolean} isThere
   */
  async follow(tolerance, isThere) {
    const before = this.path;
    const path = isThere ? await this.engine.ask('offset', tolerance) : null;
    if (path === undefined || (path === null && before === null)) return;
    this.path = path;
    this.onChange();
  }

  /** Its entry in the legend. */
  legend() {
    const title = 'Where the centre of the cutter goes. Lengths and times are those of the programmed path.';
    return this.path === null ? [] : [el('li', { class: 'key key-offset', title }, 'cutter centre')];
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {View} view
   * @param {Record<string, string>} colours
   */
  draw(context, view, colours) {
    if (this.path === null) return;
    const { xyz, starts } = this.path;
    const [across, up] = AXES[view.plane];
    context.strokeStyle = colours.offset;
    context.lineWidth = 1.25;
    context.lineJoin = 'round';
    context.setLineDash([]);
    context.beginPath();
    let next = 0;
    for (let i = 0; 3 * i < xyz.length; i += 1) {
      const [x, y] = view.at(xyz[3 * i + across], xyz[3 * i + up]);
      if (i === starts[next]) {
        next += 1;
        context.moveTo(x, y);
      } else context.lineTo(x, y);
    }
    context.stroke();
  }
}
