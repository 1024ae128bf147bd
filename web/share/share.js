// The menu that makes a link of the tape.
import { button, byId, el } from '../dom.js';
import { makeMenu } from '../menu.js';
import { whole as figure } from '../words.js';
import { linkOf, MOST_CHARACTERS } from './link.js';

/** @typedef {import('./whole.js').Whole} Whole */

/**
 * @param {() => Whole} current
 */
export function makeShare(current) {
  const box = byId('share-menu', HTMLElement);
  const link = el('input', { class: 'share-link', type: 'text', readonly: true, 'aria-label': 'Link to this tape', id: 'share-link' });
  const said = el('p', { class: 'menu-note', role: 'status', id: 'share-said' });
  const copy = button('menu-item', 'Copy the link', () => void put(link.value, 'The link is copied.'), { id: 'copy-link' });
  const markdown = button('menu-item', 'Copy it as Markdown', () => void put(`[NC tape](${link.value})`, 'Copied as Markdown.'), { id: 'copy-markdown' });
  const frame = button('menu-item', 'Copy it as a frame, for a page of yours', () => void put(frameOf(link.value), 'Copied as a frame, in HTML.'), { id: 'copy-frame' });
  const file = button('menu-item', 'Save the listing instead', () => {
    menu.close();
    byId('save-listing', HTMLElement).click();
  });
  // From its end to its start, which is what is seen of it.
  link.addEventListener('focus', () => link.setSelectionRange(0, link.value.length, 'backward'));

  /** @param {string} text @param {string} words */
  async function put(text, words) {
    try {
      await navigator.clipboard.writeText(text);
      said.textContent = words;
    } catch {
      // A browser may forbid it, as in a frame: the link can still be taken by hand.
      link.focus();
      said.textContent = 'The browser does not let the page copy. The link is selected: copy it by hand.';
    }
  }

  async function tell() {
    const address = new URL(await linkOf(current()), location.href).href;
    const tooLong = address.length > MOST_CHARACTERS;
    link.value = tooLong ? '' : address;
    said.textContent = tooLong
      ? `As a link this tape would have ${figure(address.length)} characters. Mail, chat and course systems cut links beyond some ${figure(MOST_CHARACTERS)}, so that nothing of it would open. Send its listing as a file.`
      : 'The program and its format are in the link itself, behind the #. No server gets to see them.';
    box.replaceChildren(el('h2', { class: 'menu-first' }, current().kind === 'cldata' ? 'Share this CLDATA' : 'Share this tape'), ...(tooLong ? [said, file] : [link, copy, markdown, current().kind === 'cldata' ? '' : frame, said]));
  }

  const menu = makeMenu({ menu: box, opener: byId('share-button', HTMLElement), fill: tell });
  return { toggle: menu.toggle };
}

/**
 * The lines that put the tape of a link into another page: docs/embedding.md.
 * @param {string} link
 */
function frameOf(link) {
  const { hash } = new URL(link);
  const address = new URL(`embed.html${hash}`, new URL('./', location.href)).href;
  return `<iframe width="100%" height="520" title="NC tape" loading="lazy" sandbox="allow-scripts allow-popups allow-popups-to-escape-sandbox" src="${address}"></iframe>`;
}
