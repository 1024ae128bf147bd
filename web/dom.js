// Elements are made here, never from strings of HTML.

/**
 * The element with this id; the page cannot work without it.
 * @template {HTMLElement} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function byId(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`index.html has no ${type.name} #${id}`);
  return found;
}

/**
 * A new element. `class` and attributes go by their names, `on` takes listeners.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string | number | boolean | null | undefined> & { on?: never } | null} [attributes]
 * @param {...(Node | string | null | undefined | false)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function el(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter(isShown));
  return element;
}

/**
 * @param {Node | string | null | undefined | false} child
 * @returns {child is Node | string}
 */
function isShown(child) {
  return child !== null && child !== undefined && child !== false;
}

/**
 * A button that says what it does.
 * @param {string} className
 * @param {string} label
 * @param {(event: MouseEvent) => void} press
 * @param {Record<string, string>} [attributes]
 */
export function button(className, label, press, attributes) {
  const made = el('button', { type: 'button', class: className, ...attributes }, label);
  made.addEventListener('click', press);
  return made;
}

/**
 * Does what a key means here; a key that means nothing here, or that is held with another, stays the browser's.
 * @param {HTMLElement} element
 * @param {(key: string) => (() => void) | null} deedOf
 */
export function onKeys(element, deedOf) {
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const deed = deedOf(event.key);
    if (deed === null) return;
    event.preventDefault();
    deed();
  });
}

/** @returns {boolean} the user asked for less motion */
export const lessMotion = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

/**
 * Calls `run` at most once a frame, however often it is asked for.
 * @param {() => void} run
 * @returns {() => void}
 */
export function onceAFrame(run) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      run();
    });
  };
}

/**
 * Calls `run` when nobody has asked for it during `milliseconds`.
 * @param {() => void} run
 * @param {number} milliseconds
 */
export function whenQuiet(run, milliseconds) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  return () => {
    clearTimeout(timer);
    timer = setTimeout(run, milliseconds);
  };
}
