// Text that would like to be more than text: in the source, the format, a link, a file, a message.
import assert from 'node:assert/strict';
import { deflateRawSync } from 'node:zlib';
import { after, before, test } from 'node:test';
import { paste, quiet, startBrowser, visit } from './support/playground.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('./support/playground.js').Started} */
let started;
before(async () => {
  started = await startBrowser();
});
after(() => started.close());

const SCRIPT = '<img src=x onerror="top.hacked=1"><script>top.hacked=1</script><svg onload="hacked=1"></svg>{{constructor.constructor("hacked=1")()}}';
const HOSTILE = `%\n${SCRIPT}\n(${SCRIPT})\n"'\`\${hacked=1}\njavascript:hacked=1\n]]>--></script></style></textarea>\nN001 G01 X+1\n`;
/** A format of which every text is hostile. */
const FORMAT = {
  standard: 'iso2539',
  classification: SCRIPT,
  detail: SCRIPT,
  itemized: { feed: SCRIPT, setPoint: SCRIPT, declared: { G: { [SCRIPT]: SCRIPT } } },
  onclick: SCRIPT,
};

/** @param {unknown} content */
const link = (content) => `#1.${deflateRawSync(Buffer.from(typeof content === 'string' ? content : JSON.stringify(content))).toString('base64url')}`;

/** Nothing ran, and no element came of the text. @param {Page} page */
async function unharmed(page) {
  await quiet(page);
  for (const frame of page.frames()) {
    const found = await frame.evaluate(() => ({
      hacked: /** @type {any} */ (window).hacked,
      polluted: /** @type {any} */ ({}).polluted,
      handlers: document.querySelectorAll('[onerror], [onload], [onclick]').length,
      pictures: document.querySelectorAll('img').length,
      strangers: [...document.querySelectorAll('script')].filter((script) => script.textContent?.startsWith('top.')).length,
    }));
    assert.deepEqual(found, { hacked: undefined, polluted: undefined, handlers: 0, pictures: 0, strangers: 0 }, frame.url().slice(0, 80));
  }
}

test('a hostile source is a source', async () => {
  const { page, leave } = await visit(started);
  await paste(page, HOSTILE);
  await unharmed(page);
  assert.match((await page.locator('.cm-content').innerText()), /<img src=x onerror/);
  // The words of the problems, the tooltip and the tape quote it.
  await page.locator('.problem').first().click();
  await page.locator('.cm-squiggle').first().hover();
  await page.locator('#name-button').click();
  await page.locator('#name').fill(SCRIPT.slice(0, 40));
  await unharmed(page);
  await leave();
});

test('hostile formats, links and drafts are refused or shown as text', async () => {
  const { page, leave } = await visit(started);
  // Each time a page that is loaded anew, and not one whose address changes behind the #.
  let times = 0;
  const open = (/** @type {string} */ hash) => page.goto(`${started.address}?${(times += 1)}${hash}`);
  for (const content of [
    { source: HOSTILE, format: FORMAT, cursor: 3 },
    { source: HOSTILE, format: { ...FORMAT, standard: SCRIPT }, cursor: SCRIPT },
    `{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}},"source":"%","format":{"__proto__":{"polluted":1},"standard":"iso2539","detail":"N3"},"cursor":1e999}`,
    '[]', 'null', '"', { source: 7 }, 'x'.repeat(4_000_000),
  ]) {
    await open(link(content));
    await page.locator('.cm-line').first().waitFor();
    await unharmed(page);
  }
  for (const hash of ['#1.%00', '#1.<script>', '#0.', '#99.AAAA', `#1.${SCRIPT}`, '#1.__proto__']) {
    await open(hash);
    await page.locator('#notice').waitFor();
    await unharmed(page);
  }
  await page.evaluate((text) => {
    for (const name of Object.keys(localStorage)) localStorage.setItem(name, text);
    localStorage.setItem('nctape.draft.other', text);
    localStorage.setItem('nctape.split', text);
  }, JSON.stringify({ own: { source: HOSTILE, format: FORMAT, cursor: -1 }, shown: SCRIPT, guest: SCRIPT, example: SCRIPT, time: SCRIPT }));
  await open('');
  await page.locator('.cm-line').first().waitFor();
  await unharmed(page);
  await leave();
});

test('a hostile file is a listing', async () => {
  const { page, leave } = await visit(started);
  for (const name of ['page.html', 'picture.svg', `${SCRIPT.slice(0, 60).replaceAll('/', '')}.txt`]) {
    await page.locator('#file-input').setInputFiles({ name, mimeType: 'text/html', buffer: Buffer.from(HOSTILE) });
    await unharmed(page);
  }
  await leave();
});

test('the browser itself refuses what would make a script of a text', async () => {
  const { page } = await visit(started);
  const embed = await page.context().newPage();
  await embed.goto(`${started.address}embed.html`);
  await embed.locator('.cm-line').first().waitFor();
  for (const place of [page, embed]) {
    const refused = await place.evaluate(() =>
      Object.fromEntries(
        Object.entries({
          html: () => document.createElement('div').insertAdjacentHTML('beforeend', '<b>x</b>'),
          worker: () => new Worker('data:text/javascript,1'),
          script: () => Object.assign(document.createElement('script'), { src: 'https://example.org/x.js' }),
          policy: () => /** @type {any} */ (window).trustedTypes.createPolicy('another', {}),
        }).map(([name, deed]) => {
          try {
            deed();
            return [name, false];
          } catch {
            return [name, true];
          }
        }),
      ),
    );
    assert.deepEqual(refused, { html: true, worker: true, script: true, policy: true });
    const policy = (await place.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content')) ?? '';
    assert.match(policy, /default-src 'none'.*require-trusted-types-for 'script'; trusted-types nctape$/);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|https?:|\*/);
  }
  await page.context().close();
});

test('a frame shows hostile settings as text, and hears no message but its parent’s', async () => {
  const { page, leave } = await visit(started, { path: 'embedding.html', ready: false, firstTime: true });
  await page.evaluate(
    ([text, format]) => {
      const element = document.createElement('nc-tape');
      element.id = 'one';
      for (const name of ['preset', 'tape', 'views', 'theme', 'block', 'goal', 'goal-tape', 'label', 'height']) element.setAttribute(name, text);
      element.setAttribute('page', 'javascript:top.hacked=1');
      element.setAttribute('format', format);
      element.setAttribute('loading', 'eager');
      element.textContent = text;
      Object.assign(window, { heard: [] });
      for (const type of ['error', 'change', 'solved']) element.addEventListener(type, (event) => /** @type {any} */ (window).heard.push([type, /** @type {CustomEvent} */ (event).detail]));
      document.querySelector('main')?.replaceChildren(element);
    },
    /** @type {[string, string]} */ ([HOSTILE, JSON.stringify(FORMAT)]),
  );
  const frame = await (await page.locator('#one iframe').elementHandle())?.contentFrame();
  assert.ok(frame);
  await frame.locator('.cm-line').first().waitFor();
  await unharmed(page);
  const errors = await page.evaluate(() => /** @type {any} */ (window).heard.filter((/** @type {[string]} */ [type]) => type === 'error').map((/** @type {[string, any]} */ [, { message }]) => message));
  for (const what of ['preset', 'link', 'views', 'theme', 'goal', 'page']) assert.ok(errors.some((/** @type {string} */ words) => words.includes(what)), `${what} among ${errors.join(' | ')}`);
  assert.doesNotMatch((await frame.locator('#full-page').getAttribute('href')) ?? '', /javascript/);

  // Messages that are none of the protocol, from the parent; and good ones from another frame.
  const before = await frame.locator('.cm-content').innerText();
  await page.evaluate((text) => {
    const target = document.getElementById('one')?.shadowRoot?.querySelector('iframe')?.contentWindow;
    const deep = { nctape: 1, type: 'setText', text: {} };
    for (const message of [
      text, null, 7, [], {}, { nctape: 1 }, { nctape: '1', type: 'setText', text }, { nctape: 1, type: '__proto__', text }, { nctape: 1, type: 'constructor' },
      deep, { nctape: 1, type: 'setText', text: 'x'.repeat(800_001) }, { nctape: 1, type: 'select', block: {} }, { nctape: 1, type: 'getText', id: text },
      { nctape: 1, type: 'set', views: {}, theme: 7, page: ['javascript:1'], __proto__: { polluted: 1 } }, { nctape: 2, type: 'setText', text },
    ]) target?.postMessage(message, '*');
  }, SCRIPT);
  const [stranger] = await Promise.all([
    page.waitForEvent('frameattached'),
    page.evaluate(() => {
      const other = document.createElement('iframe');
      other.src = 'about:blank';
      document.querySelector('main')?.append(other);
    }),
  ]);
  await stranger.evaluate(() => {
    const element = parent.document.getElementById('one');
    const target = element?.shadowRoot?.querySelector('iframe')?.contentWindow;
    // Script in this frame is the speaker: the frame is not its child.
    const speak = new Function('target', 'message', 'target.postMessage(message, "*")');
    speak(target, { nctape: 1, type: 'setText', text: 'STRANGER' });
    speak(parent, { nctape: 1, type: 'solved', goal: 'STRANGER' });
    speak(parent, { nctape: 1, type: 'change', text: 'STRANGER' });
  });
  await unharmed(page);
  assert.equal(await frame.locator('.cm-content').innerText(), before);
  const heard = await page.evaluate(() => JSON.stringify(/** @type {any} */ (window).heard));
  assert.doesNotMatch(heard, /STRANGER/);
  assert.match(heard, /speaks version 1/);
  await leave();
});
