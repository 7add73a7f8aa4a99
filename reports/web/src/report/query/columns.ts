// Shows or hides a column by rewriting the query, so that a link keeps the choice.
import type { Column } from '../fold';

/** The query without its columns: terms; what stands in quotes is left alone. */
function withoutColumns(query: string): string {
  const quoteOrTerm = /"[^"]*"|(^|\s)columns:("[^"]*"|[^\s()"])*/gi;
  return query.replace(quoteOrTerm, (part) => (part.startsWith('"') ? part : '')).trim();
}

function name(column: Column, columns: Column[]): string {
  const text = columns.filter((c) => c.engine === column.engine).length > 1 ? column.label : column.engine;
  return text.replace(/[\s()",]/g, '?'); // letters of the query itself
}

export function withColumns(query: string, columns: Column[], shown: boolean[]): string {
  const rest = withoutColumns(query);
  if (shown.every(Boolean)) return rest;
  const hidden = columns.filter((_, j) => !shown[j]);
  const kept = columns.filter((_, j) => shown[j]);
  const globs =
    hidden.length < kept.length || kept.length === 0
      ? hidden.map((c) => `-${name(c, columns)}`)
      : kept.map((c) => name(c, columns));
  return `${rest} columns:${globs.join(',')}`.trim();
}
