// The colours of the style sheet, for what is drawn on a canvas.

/** @type {Record<string, string>} */
const NAMES = {
  text: '--text',
  muted: '--muted',
  sheet: '--sheet',
  grid: '--grid',
  gridStrong: '--grid-strong',
  accent: '--accent',
  halo: '--halo',
  lamp: '--lamp',
  lampText: '--lamp-text',
  benchText: '--bench-text',
  lampInk: '--lamp-ink',
  benchQuiet: '--bench-quiet',
  head: '--head',
  jaw: '--jaw',
  lit: '--lit',
  caution: '--warning',
  error: '--mark-error',
  warning: '--mark-warning',
  info: '--mark-info',
  errorOnBench: '--bench-error',
  warningOnBench: '--bench-warning',
  infoOnBench: '--bench-info',
  rapid: '--kind-rapid',
  line: '--kind-line',
  arc: '--kind-arc',
  parabola: '--kind-parabola',
  curve: '--kind-curve',
  dwell: '--kind-dwell',
  offset: '--offset',
  'band-rapid': '--band-rapid',
  'band-line': '--band-line',
  'band-arc': '--band-arc',
  'band-parabola': '--band-parabola',
  'band-curve': '--band-curve',
  'band-dwell': '--band-dwell',
};

/** @type {{ theme: string, colours: Record<string, string> } | null} */
let kept = null;

/**
 * @param {'light' | 'dark'} theme
 * @returns {Record<string, string>}
 */
export function palette(theme) {
  if (kept?.theme === theme) return kept.colours;
  const style = getComputedStyle(document.documentElement);
  const colours = Object.fromEntries(
    Object.entries(NAMES).map(([name, property]) => [name, style.getPropertyValue(property).trim()]),
  );
  kept = { theme, colours };
  return colours;
}

/** @type {string | null} */
let font = null;

/** The font of numbers and words on a canvas. It is asked for once: the answer makes the browser lay out the page. */
export const mono = () => (font ??= getComputedStyle(document.documentElement).getPropertyValue('--mono'));
