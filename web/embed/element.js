// <nc-tape>: the playground in a frame of its own, loaded when it comes into sight. docs/embedding.md is its manual.
import { HOSTED, isText, messageOf, SETTINGS, TAPE, VERSION } from './protocol.js';

/** CSS pixels: the strip, and below it room for a dozen lines. */
const HEIGHT = 520;
/** So far below the edge of the window a frame begins to load. */
const AHEAD = '200px';

/** Events of the frame that go to the listeners of the element, and what they carry. @type {Record<string, string[]>} */
const EVENTS = {
  ready: ['version'],
  change: ['text', 'format'],
  diagnostics: ['errors', 'warnings', 'notes', 'list'],
  select: ['block', 'number'],
  solved: ['goal'],
  error: ['message'],
};

const script = document.currentScript instanceof HTMLScriptElement ? document.currentScript : document.querySelector('script[src*="nc-tape.js"]');
const home = script instanceof HTMLScriptElement ? script.src : document.baseURI;

const style = new CSSStyleSheet();
style.replaceSync(`
:host { display: block; box-sizing: border-box; height: ${HEIGHT}px; position: relative; overflow: hidden; border: 1px solid #b9b6ad; border-radius: 8px; background: #f3f2ee; color: #1c2024; }
:host([hidden]) { display: none; }
:host([theme="dark"]) { border-color: #4a525b; background: #16191d; color: #e7e9ec; }
iframe { display: block; width: 100%; height: 100%; border: 0; }
.ahead { height: 100%; overflow: auto; box-sizing: border-box; padding: 16px; }
.text { white-space: pre-wrap; font: 14px/1.5 ui-monospace, Menlo, Consolas, monospace; }
button { position: absolute; inset: auto 0 24px; margin: auto; width: max-content; min-height: 44px; padding: 0 20px; border: 0; border-radius: 8px; background: #0b66c3; color: #fff; font: 600 15px system-ui, sans-serif; cursor: pointer; }
button:focus-visible { outline: 3px solid #1c2024; outline-offset: 2px; }
@media (prefers-color-scheme: dark) {
  :host(:not([theme="light"])) { border-color: #4a525b; background: #16191d; color: #e7e9ec; }
  :host(:not([theme="light"])) button:focus-visible { outline-color: #e7e9ec; }
}`);

const watch = new IntersectionObserver(
  (entries) => {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting && target instanceof NcTape) target.load();
    }
  },
  { rootMargin: AHEAD },
);

export class NcTape extends HTMLElement {
  static observedAttributes = [...SETTINGS, 'height'];

  /** @type {HTMLIFrameElement | null} */
  #frame = null;
  #ready = false;
  #solved = false;
  /** The text as the visitor left it, for a frame that is loaded anew. @type {string | null} */
  #edited = null;
  /** What waits for the frame. @type {(() => void)[]} */
  #waiting = [];
  /** Questions by their number. @type {Map<number, (text: string) => void>} */
  #asked = new Map();
  #lastId = 0;
  #root = this.attachShadow({ mode: 'open' });

  connectedCallback() {
    this.#root.adoptedStyleSheets = [style];
    this.#size();
    window.addEventListener('message', this.#hear);
    if (this.#frame !== null) return;
    const text = document.createElement('div');
    text.className = 'text';
    text.append(document.createElement('slot'), this.getAttribute('source') ?? '');
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = 'Load the playground';
    button.addEventListener('click', () => this.load());
    const ahead = document.createElement('div');
    ahead.className = 'ahead';
    ahead.append(text, button);
    this.#root.replaceChildren(ahead);
    if (this.getAttribute('loading') === 'eager') this.load();
    else if (this.getAttribute('loading') !== 'click') watch.observe(this);
  }

  disconnectedCallback() {
    window.removeEventListener('message', this.#hear);
    watch.unobserve(this);
    // A frame that is taken out of a page is loaded anew when it comes back.
    this.#frame = null;
    this.#ready = false;
  }

  /** @param {string} name @param {string | null} before @param {string | null} value */
  attributeChangedCallback(name, before, value) {
    if (name === 'height') this.#size();
    else if (this.#ready && before !== value) {
      const isTape = /** @type {readonly string[]} */ (TAPE).includes(name);
      if (isTape) this.#edited = null;
      this.#say(isTape ? 'open' : 'set', this.#settings());
    }
  }

  /** Loads the frame, if it is not there yet. */
  load() {
    if (this.#frame !== null || !this.isConnected) return;
    watch.unobserve(this);
    const frame = document.createElement('iframe');
    frame.title = this.getAttribute('label') ?? 'NC tape';
    // No access to the page around, nor to what it keeps.
    frame.setAttribute('sandbox', 'allow-scripts allow-popups allow-popups-to-escape-sandbox');
    frame.src = `${new URL(this.getAttribute('frame') ?? 'embed.html', home).href}#${HOSTED}`;
    this.#frame = frame;
    this.#root.replaceChildren(frame);
  }

  /** The goal is met. */
  get solved() {
    return this.#solved;
  }

  /** The text as it is now. @returns {Promise<string>} */
  async getText() {
    await this.#loaded();
    return new Promise((resolve) => {
      this.#lastId += 1;
      this.#asked.set(this.#lastId, resolve);
      this.#say('getText', { id: this.#lastId });
    });
  }

  /** Puts another text in its place; the visitor can undo it. @param {string} text */
  async setText(text) {
    await this.#loaded();
    this.#say('setText', { text: String(text) });
  }

  /** Moves the cursor to a block, by its sequence number or its place counted from 1. @param {string | number} block */
  async select(block) {
    await this.#loaded();
    this.#say('select', { block: String(block) });
  }

  /** Brings the tape back as it was at the start. */
  async reset() {
    await this.#loaded();
    this.#say('reset');
  }

  /** @returns {Promise<void>} */
  #loaded() {
    this.load();
    return this.#ready ? Promise.resolve() : new Promise((resolve) => this.#waiting.push(resolve));
  }

  #size() {
    const height = Number(this.getAttribute('height'));
    this.style.height = height > 0 && height < 10_000 ? `${height}px` : '';
  }

  #settings() {
    /** @type {Record<string, string>} */
    const stated = {};
    for (const name of SETTINGS) {
      const value = this.getAttribute(name);
      if (value !== null) stated[name] = value;
    }
    const inner = plain(this.textContent ?? '');
    if (stated.source === undefined && inner !== '') stated.source = inner;
    return stated;
  }

  /** @param {string} type @param {Record<string, unknown>} [fields] */
  #say(type, fields = {}) {
    // A sandboxed frame has no origin that could be named.
    this.#frame?.contentWindow?.postMessage({ nctape: VERSION, type, ...fields }, '*');
  }

  #hear = (/** @type {MessageEvent} */ { source, data }) => {
    if (this.#frame === null || source === null || source !== this.#frame.contentWindow) return;
    const message = messageOf(data);
    if (message === null || message.nctape !== VERSION) return;
    const { type, id, text } = message;
    if (type === 'hello') this.#say('open', this.#settings());
    if (type === 'text' && typeof id === 'number' && isText(text)) {
      this.#asked.get(id)?.(text);
      this.#asked.delete(id);
    }
    if (!Object.hasOwn(EVENTS, type)) return;
    if (type === 'ready') {
      this.#ready = true;
      if (this.#edited !== null) this.#say('setText', { text: this.#edited });
      for (const go of this.#waiting.splice(0)) go();
    }
    if (type === 'change' && isText(text)) this.#edited = text;
    if (type === 'solved') this.#solved = true;
    const detail = Object.fromEntries(EVENTS[type].map((name) => [name, message[name]]));
    this.dispatchEvent(new CustomEvent(type, { detail }));
  };
}

/**
 * A text as it stands in HTML: without the line end before it, the spaces behind it, and those before every line.
 * @param {string} text
 */
function plain(text) {
  const lines = text.replace(/^[ \t]*\r?\n/, '').trimEnd().split('\n');
  const margins = lines.filter((line) => line.trim() !== '').map((line) => /^ */.exec(line)?.[0].length ?? 0);
  const margin = Math.min(...margins);
  const body = lines.map((line) => line.slice(margin)).join('\n');
  return body === '' ? '' : `${body}\n`;
}

customElements.define('nc-tape', NcTape);
