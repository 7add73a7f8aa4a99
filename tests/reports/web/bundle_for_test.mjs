// The pages' own modules for tests in node, which cannot read TypeScript.
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const web = join(import.meta.dirname, '../../../reports/web');
const { buildSync } = createRequire(join(web, 'package.json'))('esbuild');

/** Imports reports/web/src/`path`, such as "report/fold.ts". */
export async function load(path) {
  const folder = mkdtempSync(join(tmpdir(), 'cylon-unit-'));
  try {
    const outfile = join(folder, 'module.mjs');
    buildSync({
      entryPoints: [join(web, 'src', path)],
      absWorkingDir: web,
      outfile,
      bundle: true,
      format: 'esm',
      platform: 'node',
      logLevel: 'error',
    });
    return await import(pathToFileURL(outfile).href);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
