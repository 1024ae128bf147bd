// A menu that a button of the header opens: Escape and a press elsewhere close it, and the focus goes back.

/**
 * @param {object} parts
 * @param {HTMLElement} parts.menu
 * @param {HTMLElement} parts.opener
 * @param {() => unknown} parts.fill  makes it ready to be shown
 */
export function makeMenu({ menu, opener, fill }) {
  /** @param {boolean} open */
  async function show(open) {
    if (open) await fill();
    const hadFocus = menu.contains(document.activeElement);
    menu.hidden = !open;
    opener.setAttribute('aria-expanded', String(open));
    if (open) /** @type {HTMLElement | null} */ (menu.querySelector('input:not([hidden]), button'))?.focus();
    else if (hadFocus) opener.focus();
  }
  const close = () => {
    if (!menu.hidden) void show(false);
  };
  menu.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });
  window.addEventListener('pointerdown', ({ target }) => {
    if (target instanceof Node && !menu.contains(target) && !opener.contains(target)) close();
  });
  return { toggle: () => void show(menu.hidden === true), close };
}
