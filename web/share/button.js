// The button in the header; what it opens is fetched when it is pressed.
import { byId } from '../dom.js';

/** @param {() => import('./whole.js').Whole} current */
export function makeShareButton(current) {
  /** @type {Promise<{ toggle: () => void }> | null} */
  let menu = null;
  byId('share-button', HTMLElement).addEventListener('click', async () => {
    menu ??= import('./share.js').then(({ makeShare }) => makeShare(current));
    (await menu).toggle();
  });
}
