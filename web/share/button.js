// The button in the header; what it opens is fetched when it is pressed.
import { byId } from '../dom.js';
import { lazily } from '../lazy.js';

/** @param {() => import('./whole.js').Whole} current */
export function makeShareButton(current) {
  const menu = lazily(async () => (await import('./share.js')).makeShare(current));
  byId('share-button', HTMLElement).addEventListener('click', async () => (await menu()).toggle());
}
