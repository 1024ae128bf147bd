// The hand on the tape: drag, wheel, keys. Distances are told in rows.
import { onKeys } from '../dom.js';

/**
 * @typedef {object} Hand
 * @property {() => number} pitch  of a row, in CSS pixels
 * @property {() => number} position
 * @property {(row: number) => void} slide  the tape follows the finger; the row may have a fraction
 * @property {(row: number) => void} settle  the finger is lifted
 * @property {(row: number) => void} go  to a whole row
 * @property {(direction: 1 | -1) => void} goToBlock
 * @property {() => number} rows
 */

/**
 * @param {HTMLElement} strip
 * @param {Hand} hand
 */
export function listenToHand(strip, hand) {
  dragging(strip, hand);
  wheeling(strip, hand);
  onKeys(strip, (key) => keyDeed(key, hand));
}

/**
 * @param {string} key
 * @param {Hand} hand
 */
function keyDeed(key, hand) {
  const here = Math.round(hand.position());
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return () => hand.go(here - 1);
    case 'ArrowRight':
    case 'ArrowUp':
      return () => hand.go(here + 1);
    case 'PageUp':
      return () => hand.goToBlock(-1);
    case 'PageDown':
      return () => hand.goToBlock(1);
    case 'Home':
      return () => hand.go(0);
    case 'End':
      return () => hand.go(hand.rows() - 1);
    default:
      return null;
  }
}

/** Pixels that a finger may tremble and still mean a press. */
const TREMBLE = 4;

/**
 * @param {HTMLElement} strip
 * @param {Hand} hand
 */
function dragging(strip, hand) {
  /** @type {{ pointer: number, x: number, position: number, moved: boolean } | null} */
  let drag = null;
  strip.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || drag !== null) return;
    strip.setPointerCapture(event.pointerId);
    drag = { pointer: event.pointerId, x: event.clientX, position: hand.position(), moved: false };
  });
  strip.addEventListener('pointermove', (event) => {
    if (drag === null || event.pointerId !== drag.pointer) return;
    const way = event.clientX - drag.x;
    if (!drag.moved && Math.abs(way) < TREMBLE) return;
    drag.moved = true;
    strip.classList.add('dragged');
    hand.slide(drag.position - way / hand.pitch());
  });
  /** @param {PointerEvent} event */
  const lift = (event) => {
    if (drag === null || event.pointerId !== drag.pointer) return;
    const { moved } = drag;
    drag = null;
    strip.classList.remove('dragged');
    if (moved) {
      hand.settle(hand.position());
    } else if (event.type === 'pointerup') {
      const box = strip.getBoundingClientRect();
      const way = event.clientX - box.left - box.width / 2;
      hand.go(Math.round(hand.position() + way / hand.pitch()));
    }
  };
  strip.addEventListener('pointerup', lift);
  strip.addEventListener('pointercancel', lift);
}

/**
 * @param {HTMLElement} strip
 * @param {Hand} hand
 */
function wheeling(strip, hand) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  strip.addEventListener(
    'wheel',
    (event) => {
      if (event.ctrlKey) return;
      event.preventDefault();
      const way = Math.abs(event.deltaX) > Math.abs(event.deltaY) ? event.deltaX : event.deltaY;
      const pixels = event.deltaMode === 1 ? way * 16 : event.deltaMode === 2 ? way * strip.clientWidth : way;
      hand.slide(hand.position() + pixels / hand.pitch());
      clearTimeout(rest);
      rest = setTimeout(() => hand.settle(hand.position()), 160);
    },
    { passive: false },
  );
}
