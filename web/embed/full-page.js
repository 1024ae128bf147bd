// The way from the frame to a page of its own, with the tape as it is then.
import { byId } from '../dom.js';
import { linkOf } from '../share/link.js';

/** Characters of an address that browsers open: two million, of which the rest is for the page's own address. */
const MOST_CHARACTERS = 1_900_000;

/** @param {() => import('../share/whole.js').Whole} current */
export function makeFullPage(current) {
  const link = byId('full-page', HTMLAnchorElement);
  /** @type {URL | null} */
  let stated = null;
  let asked = 0;

  async function refresh() {
    asked += 1;
    const mine = asked;
    const hash = await linkOf(current());
    if (mine !== asked) return;
    const page = stated ?? beside();
    link.hidden = page === null || hash.length > MOST_CHARACTERS;
    if (page !== null) link.href = new URL(hash, page).href;
  }
  return {
    refresh,
    /** @param {URL | null} address */
    setAddress(address) {
      stated = address;
    },
  };
}

/** The playground itself, which lies beside this file; from a disk, and by itself, this very file is all there is. */
function beside() {
  if (location.protocol === 'file:') return window.parent === window ? null : new URL(location.pathname, location.href);
  return location.protocol.startsWith('http') ? new URL('./', location.href) : null;
}
