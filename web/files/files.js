// The menu of files: open one, save the tape. Nothing of it leaves the machine.
import { byId } from '../dom.js';
import { makeOpen } from './open.js';
import { makeSave } from './save.js';

/**
 * @param {Omit<Parameters<typeof makeOpen>[0], 'close'> & Omit<Parameters<typeof makeSave>[0], 'close'>} parts
 */
export function makeFiles(parts) {
  const menu = byId('file-menu', HTMLElement);
  const opener = byId('file-button', HTMLElement);
  const close = () => {
    if (!menu.hidden) show(false);
  };
  makeOpen({ ...parts, close });
  const save = makeSave({ ...parts, close });

  /** @param {boolean} open */
  function show(open) {
    if (open) save.tell();
    menu.hidden = !open;
    opener.setAttribute('aria-expanded', String(open));
    if (open) byId('open-file', HTMLElement).focus();
    else if (menu.contains(document.activeElement)) opener.focus();
  }
  opener.addEventListener('click', () => show(menu.hidden === true));
  menu.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    show(false);
    opener.focus();
  });
  window.addEventListener('pointerdown', ({ target }) => {
    if (target instanceof Node && !menu.contains(target) && !opener.contains(target)) close();
  });
}
