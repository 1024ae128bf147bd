// Light, dark, or as the system has it.
import { byId } from './dom.js';
import { recall, remember } from './storage.js';

/** @typedef {'auto' | 'light' | 'dark'} Choice */

/** @type {Choice[]} */
const CHOICES = ['auto', 'light', 'dark'];
const WORDS = { auto: 'Auto', light: 'Light', dark: 'Dark' };

export const dark = matchMedia('(prefers-color-scheme: dark)');

/** @returns {Choice} */
function remembered() {
  const choice = recall('theme');
  return CHOICES.find((candidate) => candidate === choice) ?? 'auto';
}

/**
 * The theme that a choice means now.
 * @param {Choice} choice
 * @returns {'light' | 'dark'}
 */
export const themeOf = (choice) => (choice === 'auto' ? (dark.matches ? 'dark' : 'light') : choice);

/** Sets the remembered theme before anything is drawn. */
export function startTheme() {
  const theme = themeOf(remembered());
  document.documentElement.dataset.theme = theme;
  return theme;
}

/** @param {import('./store.js').Store} store */
export function makeThemeButton(store) {
  const button = byId('theme-button', HTMLButtonElement);
  let choice = remembered();
  function apply() {
    const theme = themeOf(choice);
    document.documentElement.dataset.theme = theme;
    const next = CHOICES[(CHOICES.indexOf(choice) + 1) % CHOICES.length];
    button.textContent = WORDS[choice];
    button.setAttribute('aria-label', `Theme: ${WORDS[choice].toLowerCase()}. Change to ${WORDS[next].toLowerCase()}.`);
    button.title = 'Theme: auto, light or dark';
    button.dataset.choice = choice;
    store.set({ theme });
  }
  button.addEventListener('click', () => {
    choice = CHOICES[(CHOICES.indexOf(choice) + 1) % CHOICES.length];
    remember('theme', choice);
    apply();
  });
  dark.addEventListener('change', apply);
  apply();
}
