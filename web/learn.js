// The dialog that says in words what the page is and how the keys go.
import { byId } from './dom.js';

export function makeLearn() {
  const dialog = byId('learn', HTMLDialogElement);
  byId('learn-button', HTMLElement).addEventListener('click', () => dialog.showModal());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
}
