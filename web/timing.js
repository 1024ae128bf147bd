// How long things take, told to whoever observes measures: `cargo xtask bench`, or a browser's own profiler.

/**
 * Does a piece of work. Its measure is told and not kept: a page may stay open for days.
 * @template T
 * @param {string} name
 * @param {() => T} work
 * @returns {T}
 */
export function timed(name, work) {
  const start = performance.now();
  const result = work();
  performance.measure(name, { start });
  performance.clearMeasures(name);
  return result;
}
