// Time that runs with the frames of the screen.

/** Seconds that a frame takes at the most: what a page in the background missed is not made up for. */
const LONGEST = 0.1;

/**
 * @param {(seconds: number) => void} tick
 */
export function makeClock(tick) {
  let asked = 0;
  /** @type {number | null} */
  let last = null;

  /** @param {number} now */
  function frame(now) {
    asked = requestAnimationFrame(frame);
    const seconds = last === null ? 0 : Math.min(LONGEST, (now - last) / 1000);
    last = now;
    tick(seconds);
  }
  return {
    start() {
      if (asked !== 0) return;
      last = null;
      asked = requestAnimationFrame(frame);
    },
    stop() {
      cancelAnimationFrame(asked);
      asked = 0;
    },
  };
}
