// Arrow keys move the focus through a table as in a spreadsheet: one cell of it is in the tab order.
import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';

const moves: Record<
  string,
  (row: number, column: number, rows: number, columns: number) => [number, number]
> = {
  ArrowUp: (r, c) => [r - 1, c],
  ArrowDown: (r, c) => [r + 1, c],
  ArrowLeft: (r, c) => [r, c - 1],
  ArrowRight: (r, c) => [r, c + 1],
  PageUp: (r, c) => [r - 10, c],
  PageDown: (r, c) => [r + 10, c],
  Home: (r) => [r, 0],
  End: (r, _, __, columns) => [r, columns - 1],
};

function within(value: number, count: number): number {
  return Math.min(count - 1, Math.max(0, value));
}

/** Links of the table carry data-row and data-column.  `grow` is asked for more rows near the last. */
export function useGridKeys(
  rows: number,
  columns: number,
  grow: () => void,
): RefObject<HTMLTableElement | null> {
  const table = useRef<HTMLTableElement>(null);
  const place = useRef<[number, number]>([0, 0]);

  // The table is drawn without the renderer knowing which cell has its turn: a step costs two attributes.
  const tabStop = (row: number, column: number): HTMLElement | null => {
    const at = (r: number, c: number) =>
      table.current?.querySelector<HTMLElement>(`[data-row='${r}'][data-column='${c}']`) ?? null;
    const next = at(row, column);
    if (!next) return null;
    at(...place.current)?.setAttribute('tabindex', '-1');
    next.setAttribute('tabindex', '0');
    place.current = [row, column];
    return next;
  };

  useLayoutEffect(() => {
    table.current
      ?.querySelectorAll('[data-row][tabindex="0"]')
      .forEach((e) => e.setAttribute('tabindex', '-1'));
    tabStop(within(place.current[0], rows), within(place.current[1], columns));
  });

  useLayoutEffect(() => {
    const node = table.current;
    if (!node) return;
    const onKey = (event: KeyboardEvent) => {
      const move = moves[event.key];
      if (!move || !(event.target instanceof HTMLElement) || event.target.dataset.row === undefined) return;
      if (event.altKey || event.metaKey || event.shiftKey) return;
      let [row, column] = move(...place.current, rows, columns);
      if (event.ctrlKey) row = event.key === 'Home' ? 0 : event.key === 'End' ? rows - 1 : row;
      row = within(row, rows);
      column = within(column, columns);
      event.preventDefault();
      const next = tabStop(row, column);
      if (next) next.focus();
      else grow();
    };
    const onFocus = (event: FocusEvent) => {
      const { row, column } = event.target instanceof HTMLElement ? event.target.dataset : {};
      if (row !== undefined && column !== undefined) tabStop(Number(row), Number(column));
    };
    node.addEventListener('keydown', onKey);
    node.addEventListener('focusin', onFocus);
    return () => {
      node.removeEventListener('keydown', onKey);
      node.removeEventListener('focusin', onFocus);
    };
  }, [rows, columns, grow]);

  return table;
}
