// Axes with their letters, and a grid whose steps are 1, 2 or 5 times a power of ten.
import { AXES } from './view.js';

/** @typedef {import('./view.js').View} View */

const LEAST_STEP = 64;

/**
 * The step of the grid for this scale, so that its lines are at least so many pixels apart.
 * @param {number} scale
 * @param {number} [pixels]
 */
export function gridStep(scale, pixels = LEAST_STEP) {
  const least = pixels / scale;
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((candidate) => candidate * power >= least) ?? 10;
  return factor * power;
}

/**
 * @param {number} value
 * @param {number} step
 */
function label(value, step) {
  const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const text = value.toFixed(Math.min(places, 8));
  return (Number(text) === 0 ? '0' : text).replace('-', '−');
}

/**
 * @param {CanvasRenderingContext2D} context  scaled to CSS pixels
 * @param {View} view
 * @param {Record<string, string>} colours
 * @param {{ axes: string[], unit: string, font: string }} names
 */
export function drawGrid(context, view, colours, { axes, unit, font }) {
  const { width, height } = view;
  const step = gridStep(view.scale);
  const [left, bottom] = view.toWorld(0, height);
  const [right, top] = view.toWorld(width, 0);
  context.font = `11px ${font}`;
  context.lineWidth = 1;
  context.fillStyle = colours.muted;

  /** @type {[axis: number, low: number, high: number][]} */
  const directions = [
    [0, left, right],
    [1, bottom, top],
  ];
  for (const [axis, low, high] of directions) {
    for (let n = Math.ceil(low / step); n * step <= high; n += 1) {
      const [x, y] = axis === 0 ? view.at(n * step, 0) : view.at(0, n * step);
      context.strokeStyle = n === 0 ? colours.gridStrong : colours.grid;
      context.beginPath();
      if (axis === 0) {
        context.moveTo(Math.round(x) + 0.5, 0);
        context.lineTo(Math.round(x) + 0.5, height);
      } else {
        context.moveTo(0, Math.round(y) + 0.5);
        context.lineTo(width, Math.round(y) + 0.5);
      }
      context.stroke();
      if (axis === 0 && x > 40 && x < width - 64) {
        context.textAlign = 'center';
        context.textBaseline = 'bottom';
        context.fillText(label(n * step, step), x, height - 6);
      } else if (axis === 1 && y > 28 && y < height - 28) {
        context.textAlign = 'left';
        context.textBaseline = 'middle';
        context.fillText(label(n * step, step), 8, y);
      }
    }
  }

  const [across, up] = AXES[view.plane];
  context.font = `600 12px ${font}`;
  context.fillStyle = colours.text;
  context.textAlign = 'right';
  context.textBaseline = 'bottom';
  context.fillText(`${axes[across] ?? ''} ${unit}`, width - 8, height - 5);
  context.textAlign = 'left';
  context.textBaseline = 'top';
  context.fillText(`${axes[up] ?? ''} ${unit}`, 8, 8);
}
