// The hand on the picture: drag to move, wheel and pinch to come nearer, point and press to read.
import { onKeys } from '../dom.js';

/**
 * @typedef {object} PlotHand
 * @property {(x: number, y: number) => void} pan
 * @property {(factor: number, x?: number, y?: number) => void} zoom
 * @property {() => void} fit
 * @property {(x: number, y: number) => void} point
 * @property {() => void} away
 * @property {(x: number, y: number) => void} press
 * @property {(direction: 1 | -1) => void} goToSpan
 */

const TREMBLE = 4;
const KEY_STEP = 40;

/**
 * @param {HTMLElement} canvas
 * @param {PlotHand} hand
 */
export function listenToPlotHand(canvas, hand) {
  /** @type {Map<number, { x: number, y: number }>} */
  const fingers = new Map();
  let moved = false;

  /** @param {MouseEvent} event */
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const pinch = () => {
    const [one, two] = [...fingers.values()];
    return { x: (one.x + two.x) / 2, y: (one.y + two.y) / 2, width: Math.hypot(one.x - two.x, one.y - two.y) };
  };

  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    if (fingers.size === 0) moved = false;
    fingers.set(event.pointerId, place(event));
  });
  canvas.addEventListener('pointermove', (event) => {
    const now = place(event);
    const before = fingers.get(event.pointerId);
    if (before === undefined) {
      hand.point(now.x, now.y);
      return;
    }
    if (fingers.size === 1) {
      if (!moved && Math.hypot(now.x - before.x, now.y - before.y) < TREMBLE) return;
      moved = true;
      fingers.set(event.pointerId, now);
      hand.pan(now.x - before.x, now.y - before.y);
    } else if (fingers.size === 2) {
      moved = true;
      const old = pinch();
      fingers.set(event.pointerId, now);
      const next = pinch();
      hand.pan(next.x - old.x, next.y - old.y);
      if (old.width > 0) hand.zoom(next.width / old.width, next.x, next.y);
    }
  });
  canvas.addEventListener('pointerup', (event) => {
    if (!fingers.delete(event.pointerId) || moved || fingers.size > 0) return;
    const { x, y } = place(event);
    hand.press(x, y);
  });
  canvas.addEventListener('pointercancel', (event) => fingers.delete(event.pointerId));
  canvas.addEventListener('pointerleave', () => hand.away());
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const { x, y } = place(event);
      const lines = event.deltaMode === 0 ? event.deltaY : event.deltaY * 30;
      hand.zoom(Math.exp(-lines * (event.ctrlKey ? 0.01 : 0.0016)), x, y);
    },
    { passive: false },
  );
  onKeys(canvas, (key) => keyDeed(key, hand));
}

/**
 * @param {string} key
 * @param {PlotHand} hand
 */
function keyDeed(key, hand) {
  switch (key) {
    case 'ArrowLeft':
      return () => hand.pan(KEY_STEP, 0);
    case 'ArrowRight':
      return () => hand.pan(-KEY_STEP, 0);
    case 'ArrowUp':
      return () => hand.pan(0, KEY_STEP);
    case 'ArrowDown':
      return () => hand.pan(0, -KEY_STEP);
    case '+':
    case '=':
      return () => hand.zoom(1.25);
    case '-':
      return () => hand.zoom(0.8);
    case '0':
      return () => hand.fit();
    case 'PageUp':
      return () => hand.goToSpan(-1);
    case 'PageDown':
      return () => hand.goToSpan(1);
    default:
      return null;
  }
}
