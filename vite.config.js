import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { embedPage } from './build/embed.js';

const alias = { nctape: fileURLToPath(new URL('pkg/nctape.js', import.meta.url)) };

export default defineConfig({
  // Relative, or the page breaks on a host that serves it from a sub-folder.
  base: './',
  resolve: { alias },
  plugins: [embedPage(alias)],
  build: {
    outDir: 'dist',
    target: 'es2022',
    // Every asset stays a file of its own: the content security policy allows few `data:` addresses.
    assetsInlineLimit: 0,
    // Browsers of es2022 know module preload; the polyfill would be an inline surprise.
    modulePreload: { polyfill: false },
  },
  worker: { format: 'es' },
});
