// The columns that the reader hid, kept by the browser for the next report.  Columns of other reports stay in the list.
import type { Column } from '../fold';

const key = 'cylon-hidden-columns';

function hidden(): Set<string> {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(key) ?? '[]');
    return new Set(Array.isArray(list) ? list.filter((name) => typeof name === 'string') : []);
  } catch {
    return new Set(); // pages from a file may have no storage
  }
}

/** What was chosen at the last visit; all columns where that would leave none. */
export function rememberedColumns(columns: Column[]): boolean[] {
  const away = hidden();
  const shown = columns.map(({ label }) => !away.has(label));
  return shown.some(Boolean) ? shown : columns.map(() => true);
}

export function rememberColumns(columns: Column[], shown: boolean[]): void {
  const away = hidden();
  columns.forEach(({ label }, j) => (shown[j] ? away.delete(label) : away.add(label)));
  try {
    localStorage.setItem(key, JSON.stringify([...away]));
  } catch {
    // The choice then holds for this visit, in the address.
  }
}
