// Whose costs a column shows: engines in WebAssembly and in JavaScript say so wherever they stand beside native ones.
import { visible } from './visible';

/** What runs an engine that is no native code, as its version says in brackets: "WebAssembly in Node 20.20.2"; ''.  Costs of two
 * builds do not compare (harness/results/build.h). */
export function buildOf(version: string): string {
  return / \((.*)\)$/.exec(version)?.[1] ?? '';
}

/** Under the name of an engine at the head of its column; nothing for native code. */
export function Build({ build }: { build: string }) {
  return build ? <p class="why">{visible(build)}</p> : null;
}

/** A sentence for a note below or above costs of several builds; '' where all are of native code. */
export function buildsNote(builds: string[]): string {
  const others = [...new Set(builds.filter(Boolean))].sort();
  return others.length > 0
    ? `Costs of ${others.join(' and ')} are not those of native code and do not compare with them. `
    : '';
}
