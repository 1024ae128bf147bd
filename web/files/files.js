// The menu of files: open one, save the tape. Nothing of it leaves the machine.
import { byId } from '../dom.js';
import { makeMenu } from '../menu.js';
import { makeOpen } from './open.js';
import { makeSave } from './save.js';

/**
 * @param {Omit<Parameters<typeof makeOpen>[0], 'close'> & Omit<Parameters<typeof makeSave>[0], 'close'>} parts
 */
export function makeFiles(parts) {
  const opener = byId('file-button', HTMLElement);
  const menu = makeMenu({ menu: byId('file-menu', HTMLElement), opener, fill: () => save.tell() });
  makeOpen({ ...parts, close: menu.close });
  const save = makeSave({ ...parts, close: menu.close });
  opener.addEventListener('click', menu.toggle);
}
