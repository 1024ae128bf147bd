// The divider between program and path, and the tabs that take its place where the page is narrow.
import { byId } from './dom.js';
import { recall, remember } from './storage.js';

const LEAST = 25;
const MOST = 75;

function makeDivider() {
  const bench = byId('bench', HTMLElement);
  const divider = byId('divider', HTMLElement);
  let share = 50;
  /** @param {number} percent */
  function set(percent) {
    share = Math.round(Math.max(LEAST, Math.min(MOST, percent)) * 10) / 10;
    bench.style.setProperty('--split', `${share}%`);
    divider.setAttribute('aria-valuenow', String(Math.round(share)));
  }
  set(Number(recall('split')) || share);
  const keep = () => remember('split', String(share));

  divider.addEventListener('pointerdown', (event) => divider.setPointerCapture(event.pointerId));
  divider.addEventListener('pointermove', (event) => {
    if (!divider.hasPointerCapture(event.pointerId)) return;
    const box = bench.getBoundingClientRect();
    set(((event.clientX - box.left) / box.width) * 100);
  });
  divider.addEventListener('pointerup', keep);
  divider.addEventListener('keydown', (event) => {
    const way = event.key === 'ArrowLeft' ? -2 : event.key === 'ArrowRight' ? 2 : 0;
    if (way === 0) return;
    event.preventDefault();
    set(share + way);
    keep();
  });
}

const TABS = ['program', 'posted', 'path', 'problems'];

/**
 * @param {string[]} names  of the views, the first of which is shown
 */
export function makeTabs(names) {
  const bench = byId('bench', HTMLElement);
  const tabs = names.map((name) => byId(`tab-${name}`, HTMLElement));
  /** @param {string} name */
  function choose(name) {
    bench.dataset.tab = name;
    tabs.forEach((tab, index) => {
      const chosen = names[index] === name;
      tab.setAttribute('aria-selected', String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
    });
  }
  tabs.forEach((tab, index) => {
    tab.addEventListener('click', () => choose(names[index]));
    tab.addEventListener('keydown', (event) => {
      const way = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
      if (way === 0) return;
      let next = index;
      // The tab of a view that is not there is passed over.
      do next = (next + way + names.length) % names.length;
      while (tabs[next].offsetParent === null && next !== index);
      choose(names[next]);
      tabs[next].focus();
    });
  });
  choose(names[0]);
  return choose;
}

/**
 * The views are panels of the tabs where there are tabs, and regions of their own where there are none.
 * @param {boolean} narrow
 */
function nameViews(narrow) {
  for (const name of TABS) {
    const view = byId(name, HTMLElement);
    if (narrow) view.setAttribute('role', 'tabpanel');
    else view.removeAttribute('role');
  }
}

/** @returns {{ showTab: (name: string) => void, narrow: () => boolean }} */
export function makeLayout() {
  makeDivider();
  const showTab = makeTabs(TABS);
  const wide = matchMedia('(min-width: 1000px)');
  nameViews(!wide.matches);
  wide.addEventListener('change', () => nameViews(!wide.matches));
  return { showTab, narrow: () => !wide.matches };
}
