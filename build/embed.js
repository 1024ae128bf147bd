// Makes dist/embed.html, one file that needs no other, and dist/nc-tape.js, which puts it into the pages of others.
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));

/**
 * @param {import('vite').AliasOptions} alias
 * @returns {import('vite').Plugin}
 */
export function embedPage(alias) {
  return {
    name: 'nctape-embed',
    apply: 'build',
    async generateBundle() {
      const [page, worker, element, template, host] = await Promise.all([
        bundle('web/embed/main.js', 'es', alias),
        bundle('web/embed/worker.js', 'iife', { nctape: `${root}web/embed/core.js` }),
        bundle('web/embed/element.js', 'iife', alias),
        readFile(`${root}web/embed/embed.html`, 'utf8'),
        readFile(`${root}web/embed/embedding.html`, 'utf8'),
      ]);
      const wasm = await wasmFor(worker.script);
      const parts = {
        css: page.css.trim(),
        main: scriptText(page.script),
        worker: scriptText(worker.script),
        wasm: Array.from(wasm, letterOf).join(''),
      };
      // The mark of UTF-8 comes first, which holds against whatever a server says.
      const hashes = { script: hash(parts.main), style: hash(parts.css) };
      this.emitFile({ type: 'asset', fileName: 'embed.html', source: `\uFEFF${filled(template, { ...parts, ...hashes })}` });
      this.emitFile({ type: 'asset', fileName: 'nc-tape.js', source: element.script });
      this.emitFile({ type: 'asset', fileName: 'embedding.html', source: host });
    },
  };
}

/**
 * One script of a file and all that it imports, and the style sheet that goes with it.
 * @param {string} file
 * @param {'es' | 'iife'} format
 * @param {import('vite').AliasOptions} alias
 */
async function bundle(file, format, alias) {
  const made = await build({
    root,
    configFile: false,
    logLevel: 'warn',
    resolve: { alias },
    plugins: [withoutFetch],
    build: {
      write: false,
      target: 'es2022',
      modulePreload: false,
      // What core.js leaves out is undefined where it is named.
      rolldownOptions: { shimMissingExports: true, onLog: quietly, input: root + file, output: { format, codeSplitting: false, entryFileNames: 'script.js' } },
    },
  });
  if (!('output' in made)) throw new Error(`${file} was not bundled once`);
  const [{ code }, ...rest] = made.output;
  const sheets = rest.map((one) => (one.type === 'asset' ? String(one.source) : ''));
  return { script: code.trim(), css: sheets.join('') };
}

/** @type {(level: string, log: { code?: string }, handle: (level: any, log: any) => void) => void} */
const quietly = (level, log, handle) => {
  if (log.code !== 'IMPORT_IS_UNDEFINED' && log.code !== 'SHIMMED_EXPORT') handle(level, log);
};

/** Those of the wasm that all browsers of es2022 have; binaryen would write what few of them read, if it might. */
const FEATURES = ['bulk-memory', 'bulk-memory-opt', 'multivalue', 'mutable-globals', 'nontrapping-float-to-int', 'reference-types', 'sign-ext', 'simd'].map((name) => `--enable-${name}`);

/**
 * The wasm without the functions that a script has no use for.
 * @param {string} script
 */
async function wasmFor(script) {
  const file = `${root}pkg/nctape_bg.wasm`;
  const module = new WebAssembly.Module(await readFile(file));
  const exports = WebAssembly.Module.exports(module).map(({ name }) => name);
  const imports = WebAssembly.Module.imports(module);
  const name = /([\w$]+)\.__wbindgen_start\(/.exec(script)?.[1];
  if (name === undefined) throw new Error('the worker starts no wasm');
  const used = new Set(Array.from(script.matchAll(/([\w$]+)\.(\w+)/g), ([, object, property]) => (object === name ? property : '')));
  const graph = [
    { name: 'script', root: true, reaches: [...exports.filter((name) => used.has(name)).map((name) => `out ${name}`), ...imports.map(({ name }) => `in ${name}`)] },
    ...exports.map((name) => ({ name: `out ${name}`, export: name })),
    ...imports.map(({ module: from, name }) => ({ name: `in ${name}`, import: [from, name] })),
  ];
  const folder = await mkdtemp(join(tmpdir(), 'nctape-embed-'));
  try {
    const [asked, made] = [join(folder, 'graph.json'), join(folder, 'made.wasm')];
    await writeFile(asked, JSON.stringify(graph));
    const tool = `${root}node_modules/binaryen/bin/wasm-metadce`;
    await promisify(execFile)(process.execPath, [tool, ...FEATURES, file, '-o', made, '--graph-file', asked, '--quiet']);
    return await readFile(made);
  } finally {
    await rm(folder, { recursive: true });
  }
}

/**
 * The glue of the wasm names the file beside it, which is in no bundle; and what it does with a class as it is loaded
 * would keep one that nobody uses.
 * @type {import('vite').Plugin}
 */
const withoutFetch = {
  name: 'nctape-without-fetch',
  transform(code, id) {
    if (!id.endsWith('pkg/nctape.js')) return null;
    return code
      .replace(/new URL\('nctape_bg\.wasm', import\.meta\.url\)/, "''")
      .replaceAll(/^if \(Symbol\.dispose\) .*$/gm, '')
      .replaceAll('new FinalizationRegistry', '/* @__PURE__ */ new FinalizationRegistry');
  },
};

/**
 * A byte as a letter of a page. Brotli, which the file is sent with, makes as much of these letters as of the bytes: a
 * wasm of 459 kB takes 476 kB so, and 596 kB as base64 of deflated bytes (by gzip 623 and 599 kB).
 * Three bytes would not stay what they are in a page, and become letters with the same last eight bits.
 * @param {number} byte
 */
const letterOf = (byte) => String.fromCharCode([0x00, 0x0d, 0x3c].includes(byte) ? byte + 0x100 : byte);

/** A script as it may stand within a page: nothing in it ends the element, or begins a comment. @param {string} code */
const scriptText = (code) => code.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

/** @param {string} text */
const hash = (text) => createHash('sha256').update(text).digest('base64');

/**
 * @param {string} template
 * @param {Record<string, string>} parts
 */
const filled = (template, parts) =>
  template.replace(/\{(\w+)\}/g, (_, name) => {
    if (!(name in parts)) throw new Error(`embed.html wants {${name}}`);
    return parts[name];
  });
