// What can be saved beside the tape itself, and the page for the printer. Fetched when it is asked for first.
import { el } from '../dom.js';
import { messageOf } from '../problem-card.js';
import { give } from './give.js';
import { problemsAsMarkdown, spansAsTable } from './report-text.js';

/** @typedef {import('nctape').Report} Report */

/** Findings in a saved report: more than anyone reads, fewer than make a file that no program opens. */
const MOST_PROBLEMS = 100_000;

/**
 * @param {object} parts
 * @param {import('../store.js').Store} parts.store
 * @param {import('../engine.js').Engine} parts.engine
 * @param {() => string} parts.source
 * @param {() => Promise<string>} parts.listing  of the tape
 */
export function makeExports({ store, engine, source, listing }) {
  const report = () => {
    const { format, skip, kind } = store.state;
    if (kind === 'cldata') return engine.fact('checkPosted', source(), format, MOST_PROBLEMS);
    return engine.fact('check', source(), format, { skip, limit: MOST_PROBLEMS });
  };
  const plot = () => /** @type {HTMLCanvasElement} */ (document.getElementById('plot-canvas'));
  /** @returns {Promise<Blob | null>} */
  const picture = () => new Promise((resolve) => plot().toBlob(resolve, 'image/png'));

  /** @param {string} text @param {string} type @param {string} name */
  const save = (text, type, name) => give(new Blob([text], { type }), name);

  return {
    async path() {
      const found = await picture();
      if (found !== null) give(found, 'path.png');
    },
    async spans() {
      save(spansAsTable(await report()), 'text/csv', 'spans.csv');
    },
    async report() {
      save(`${JSON.stringify({ format: store.state.format, report: await report() }, null, 1)}\n`, 'application/json', 'report.json');
    },
    async problems() {
      const line = await engine.fact('formatLine', store.state.format);
      save(problemsAsMarkdown(await report(), line), 'text/markdown', 'problems.md');
    },
    /** The listing, its problems and its path on paper. */
    async print() {
      const [found, line, image] = await Promise.all([report(), engine.fact('formatLine', store.state.format), picture()]);
      const address = image === null ? null : URL.createObjectURL(image);
      const shown = address === null ? null : el('img', { src: address, alt: 'Path of the tool' });
      const sheet = el(
        'article',
        { class: 'sheet' },
        el('h1', null, store.state.kind === 'cldata' ? 'CLDATA' : 'NC tape'),
        el('p', null, `Format: ${line}`),
        el('pre', null, source()),
        ...(store.state.kind === 'tape' ? [] : [el('h2', null, 'The tape that it became'), el('pre', null, await listing())]),
        el('h2', null, 'Problems'),
        found.diagnostics.length === 0
          ? el('p', null, 'Nothing to object to.')
          : el('ol', null, ...found.diagnostics.map((one) => el('li', null, `${one.line}:${one.column} ${one.rule} `, messageOf(one)))),
        el('h2', null, 'Path'),
        shown,
      );
      document.body.append(sheet);
      await shown?.decode().catch(() => {});
      // Where print() does not wait, the sheet must stay until it is on paper.
      const done = () => {
        sheet.remove();
        if (address !== null) URL.revokeObjectURL(address);
      };
      window.addEventListener('afterprint', done, { once: true });
      window.print();
    },
  };
}
