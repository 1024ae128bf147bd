// Which views are shown, and in which theme.
import { byId } from '../dom.js';
import { makeTabs } from '../layout.js';
import { themeOf } from '../theme.js';

/** @typedef {import('./settings.js').ViewName} ViewName */

/** The panes among the views, by the names of their tabs. @type {[tab: string, view: ViewName][]} */
const PANES = [
  ['program', 'text'],
  ['path', 'plot'],
  ['problems', 'problems'],
];

/** @param {import('../store.js').Store} store */
export function makeViews(store) {
  const choose = makeTabs(PANES.map(([tab]) => tab));
  const system = matchMedia('(prefers-color-scheme: dark)');
  /** @type {import('./settings.js').Settings['theme']} */
  let theme = 'auto';
  function applyTheme() {
    const now = themeOf(theme);
    document.documentElement.dataset.theme = now;
    store.set({ theme: now });
  }
  system.addEventListener('change', applyTheme);
  applyTheme();

  return {
    /** @param {import('./settings.js').Settings} settings */
    show({ views, theme: wanted }) {
      theme = wanted;
      applyTheme();
      const shown = PANES.filter(([, view]) => views.includes(view)).map(([tab]) => tab);
      for (const [tab] of PANES) {
        byId(tab, HTMLElement).hidden = byId(`tab-${tab}`, HTMLElement).hidden = !shown.includes(tab);
      }
      byId('tape', HTMLElement).hidden = !views.includes('strip');
      byId('column', HTMLElement).hidden = !views.includes('text') && !views.includes('problems');
      byId('bench', HTMLElement).hidden = shown.length === 0;
      byId('tabs', HTMLElement).hidden = shown.length < 2;
      if (shown.length > 0) choose(shown[0]);
    },
    /** Brings a pane to the front where only one of them is seen. @param {string} tab */
    reveal(tab) {
      if (!byId(tab, HTMLElement).hidden) choose(tab);
    },
    /** The focus goes on from the program, where Tab is a key of the text. */
    leaveProgram() {
      const problems = byId('problems', HTMLElement);
      (problems.hidden ? byId('reset', HTMLElement) : problems).focus();
    },
  };
}
