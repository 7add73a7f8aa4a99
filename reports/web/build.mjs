// Bundles src/ into one script and one style sheet.  The same sources and packages give the same bytes.
//   node build.mjs [FOLDER]   writes cylon.js, cylon.css and csp.txt (the script's hash for a page's
//                             Content-Security-Policy) there; bundle/ otherwise
import { createHash } from 'node:crypto';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { build } from 'esbuild';

const folder = process.argv[2] ?? 'bundle';
await mkdir(folder, { recursive: true });
await build({
  entryPoints: { cylon: 'src/main.ts' },
  absWorkingDir: import.meta.dirname,
  outdir: folder,
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  legalComments: 'eof',
  jsx: 'automatic',
  jsxImportSource: 'preact',
});
// A script inside a page must not hold its own end.
const path = `${folder}/cylon.js`;
const script = (await readFile(path, 'utf8')).replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
await writeFile(path, script);
await writeFile(`${folder}/csp.txt`, `sha256-${createHash('sha256').update(script).digest('base64')}`);
